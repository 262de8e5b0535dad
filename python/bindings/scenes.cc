#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "bind.h"
#include "calls.h"
#include "fastscene/film/plan.h"
#include "fastscene/film/subjects.h"
#include "fastscene/pipeline/pipeline.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/rooms/document.h"
#include "settings.h"

namespace fastscene::python {
namespace {

// A sentence, or a document.
SceneSource source_from(const py::object& room) {
    if (py::isinstance<py::str>(room)) return PromptSource{room.cast<std::string>()};
    const std::string text = json_text(room);
    const RoomDocument document = read_document(text, "document");
    return DocumentSource{document.prompt.empty() ? document.type : document.prompt, "document", text};
}

py::object make(const py::object& room, const std::filesystem::path& folder, const std::string& quality,
                std::uint64_t seed, const std::string& last_stage, py::object on_progress, const py::kwargs& given) {
    SceneRequest request;
    request.source = source_from(room);
    request.quality = quality;
    request.params = params_of_quality(quality);
    request.last_stage = last_stage;
    Settings settings(given);
    visit_sections(request.params,
                   [&](std::string_view section, auto& fields) { settings.take(fields, std::string(section)); });
    settings.finish();
    return python_of(long_call(seed, std::move(on_progress),
                               [&](const Run& run, Caller&) { return make_scene(request, RunFolder{folder}, run); }));
}

CameraPath film_plan(const std::filesystem::path& folder, const std::string& kind, float seconds, float fps,
                     float fov_deg, int width, int height) {
    const RunFolder run{folder};
    const auto area = walkable_in(run);
    if (!area) throw UsageError("{}: expected a run that knows where one can walk", folder.string());
    std::vector<FilmSubject> subjects;
    constexpr std::size_t kMostSubjects = 5;
    if (std::filesystem::exists(run.room_json()))
        subjects = film_subjects(read_json(run.room_json()), kMostSubjects, run.room_json().string());
    return long_call(0, py::none(), [&](const Run&, Caller&) {
        return plan_film(*area, subjects, {kind, seconds, fps, fov_deg, width, height});
    });
}

}  // namespace

void bind_scenes(py::module_& m) {
    m.def("make_scene", &make, py::arg("room"), py::arg("folder"), py::arg("quality") = "standard", py::arg("seed") = 0,
          py::arg("last_stage") = "splat", py::arg("on_progress") = py::none(),
          "From a sentence or a document to a scene in a folder; finished stages are kept. Returns the report. "
          "Settings: all flags of `make`, as panorama_width, splat_steps. on_progress(work, done, total).");
    m.def("plan_film", &film_plan, py::arg("folder"), py::arg("kind") = "tour", py::arg("seconds") = 0.f,
          py::arg("fps") = 30.f, py::arg("fov_deg") = 75.f, py::arg("width") = 1280, py::arg("height") = 720,
          "A camera path over the walkable floor of a scene: tour, orbit or walkthrough.");
}

}  // namespace fastscene::python
