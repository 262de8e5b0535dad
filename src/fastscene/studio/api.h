// What the pages request, as plain data, without sockets; web_server.h speaks HTTP.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/studio/board.h"
#include "fastscene/studio/downloads.h"
#include "fastscene/studio/drafts.h"
#include "fastscene/studio/films.h"
#include "fastscene/studio/job_queue.h"
#include "fastscene/studio/library.h"
#include "fastscene/studio/looks.h"
#include "fastscene/studio/planner.h"
#include "fastscene/studio/uploads.h"

namespace fastscene::studio {

struct ApiRequest {
    std::string method;             // GET or POST
    std::vector<std::string> path;  // decoded: {"scenes", "bedroom"}
    Json body;                      // of a POST
};
struct ApiAnswer {
    int status = 200;
    Json json;
    std::filesystem::path file;  // sent in place of `json`
    std::string save_as;         // its name, when it is to be saved
};

struct ApiParams {
    std::filesystem::path program;
    std::vector<std::string> make_flags;  // of all scenes, besides prompt, seed and quality
    int threads = 0;                      // of a job; 0: all cores
};

class Api {
  public:
    Api(Library& library, Board& board, ApiParams params);

    // Loads what the first answer would wait for: furniture, the lexicon.
    void warm_up();
    // Never throws: errors are {"error": text} with a status.
    ApiAnswer answer(const ApiRequest& request);
    // `kind`: "panorama" or "range".
    ApiAnswer upload(const std::string& kind, const std::string& name,
                     const std::function<bool(const Uploads::Put&)>& read);
    bool has_scene(const std::string& name) const;
    // Of all pages: jobs, and a number that changes with the scenes.
    Json live() const;

  private:
    ApiAnswer get(const std::vector<std::string>& path);
    ApiAnswer post(const std::vector<std::string>& path, const Json& body);
    ApiAnswer post_scene(const std::string& scene, const std::string& what, const Json& body);
    ApiAnswer post_job(const std::string& id, const std::string& what);
    ApiAnswer state();
    ApiAnswer post_film(const std::string& scene, const std::string& what, const Json& body);
    ApiAnswer get_film(const std::string& scene, const std::vector<std::string>& path);
    Json scene(const std::string& name);
    Json create(const Json& body);
    Json remake(const std::string& scene, const Json& body);
    void complete(const std::string& scene);
    std::vector<std::string> look_of_draft(const std::string& scene);

    Library& library_;
    Board& board_;
    ApiParams params_;
    Planner planner_;
    Drafts drafts_;
    Downloads downloads_;
    Uploads uploads_;
    Looks looks_;
    JobQueue queue_;
    Films films_;
};

}  // namespace fastscene::studio
