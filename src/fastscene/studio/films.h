// Films of scenes: a camera path for each, planned, drawn by hand or read from a file, and the film rendered along it.
// They stand in .studio/films/SCENE.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/scene/camera_path.h"
#include "fastscene/studio/board.h"
#include "fastscene/studio/library.h"

namespace fastscene::studio {

class Films {
  public:
    Films(Library& library, Board& board, std::filesystem::path program);
    ~Films();

    // {path, rings, low_m, high_m, made}: the saved path, else a tour; where the camera may be (world frame, [x, z])
    // and how high above the floor; the bytes of the film that was made of this path, or null. A path is as
    // io/camera_path_io.h has it. Throws Refusal 409 if the scene has no splats or no walkable floor.
    Json film(const std::string& scene);
    // Plans a path, which replaces the saved one. `seconds` 0: as long as it takes. Throws like plan_film.
    Json plan(const std::string& scene, const std::string& kind, float seconds);
    // Checks and saves a path. Throws Error for an invalid path, or one whose camera leaves the walkable area.
    Json save(const std::string& scene, const Json& path);
    // The same from the text of a file, also one of another program.
    Json read(const std::string& scene, const std::string& text);
    // The path in a format of io/camera_path_io.h.
    std::filesystem::path written(const std::string& scene, const std::string& format);

    // What the camera sees at a time of the saved path, as a JPEG.
    std::string frame(const std::string& scene, float time_s, int width);

    // Renders the saved path in the background. One at a time: throws Refusal 409 while a film or a picture is made.
    void make(const std::string& scene, const std::string& ending);
    // The same of one picture of the room behind the scene, path traced from where the camera is at a time of the path.
    // Throws Refusal 409 for a scene whose room is not known.
    void trace(const std::string& scene, float time_s);
    void stop();
    // Throws Refusal 404 if there is none.
    std::filesystem::path traced(const std::string& scene) const;
    // Throws Refusal 404 if the film of the saved path was not made.
    std::filesystem::path made(const std::string& scene) const;
    // Of what is in work or was made last: {scene, what: film | trace, state: "" | running | finished | failed |
    // stopped, overall, seconds_left, error}; of a trace also time_s.
    Json live() const;

  private:
    struct Stage;  // splats, loaded
    std::filesystem::path folder(const std::string& scene) const;
    std::filesystem::path path_file(const std::string& scene) const;
    CameraPath path(const std::string& scene);
    Json keep(const std::string& scene, const CameraPath& path);
    // Runs the program with `arguments` in the background.
    void start(const std::string& scene, Json live, std::vector<std::string> arguments);
    void work(const std::string& scene, std::vector<std::string> arguments, const std::stop_token& stop);

    Library& library_;
    Board& board_;
    std::filesystem::path program_;
    std::mutex paths_, stage_mutex_;
    std::unique_ptr<Stage> stage_;  // of the scene that was shown last
    mutable std::mutex mutex_;      // of what follows
    Json live_;
    std::jthread worker_;
};

}  // namespace fastscene::studio
