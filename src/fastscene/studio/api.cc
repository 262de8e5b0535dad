#include "fastscene/studio/api.h"

#include <algorithm>

#include "fastscene/base/base64.h"
#include "fastscene/base/memory.h"
#include "fastscene/base/parallel.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/studio/costs.h"
#include "fastscene/studio/refusal.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

template <class T>
T field(const Json& body, const char* key, const T& usual) {
    const auto found = body.find(key);
    if (found == body.end() || found->is_null()) return usual;
    try {
        return found->get<T>();
    } catch (const Json::exception&) {
        throw Refusal(400, "expected another \"{}\", found {}", key,
                      found->dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 60));
    }
}

std::uint64_t seed_in(const Json& body) {
    const auto seed = field<std::int64_t>(body, "seed", 0);
    if (seed < 0) throw Refusal(400, "seed: expected a whole number from 0 up, found {}", seed);
    return static_cast<std::uint64_t>(seed);
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

// A prompt that begins with a dash is no flag.
std::vector<std::string> arguments_of(const std::string& verb, const std::string& prompt,
                                      const std::vector<std::string>& flags) {
    std::vector<std::string> out{verb};
    if (!prompt.empty() && prompt.front() != '-') out.push_back(prompt);
    append(out, flags);
    if (prompt.starts_with('-')) append(out, {"--", prompt});
    return out;
}

std::vector<std::string> look_of(const std::string& prompt, std::uint64_t seed) {
    return arguments_of("panorama", prompt, {"--seed", std::to_string(seed)});
}

// As a shell reads it, with the program's name first.
std::string command_line(const std::vector<std::string>& arguments) {
    std::string out = "fastscene";
    for (const std::string& argument : arguments) {
        const bool plain = !argument.empty() && argument.find_first_not_of(
                                                    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                                    "-_./=:,+@%~") == std::string::npos;
        out += ' ';
        if (plain) {
            out += argument;
            continue;
        }
        out += '\'';
        for (const char c : argument) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
        out += '\'';
    }
    return out;
}

// The command that makes a recorded run again, without the settings that are the quality's.
std::string command_of(const RunFolder& folder, const Json& summary) {
    std::vector<std::string> arguments;
    if (!summary.at("from").get<std::string>().empty()) {
        arguments = {"make", "--room", folder.room_json().string()};
    } else {
        try {
            const RecordedRun run = recorded_run(folder);
            arguments = {"make"};
            if (const auto* room = std::get_if<DocumentSource>(&run.request.source))
                append(arguments, {"--room", room->room.string()});
            else if (const std::string prompt = prompt_of(run.request.source); !prompt.empty())
                arguments.push_back(prompt);
            if (const fs::path picture = picture_of(run.request.source); !picture.empty())
                append(arguments, {"--panorama", picture.string()});
            if (const fs::path range = range_map_of(run.request.source); !range.empty())
                append(arguments, {"--range", range.string()});
        } catch (const Error&) {
            return "";  // photographs, or a run of another version
        }
    }
    append(arguments, {"--quality", summary.at("quality"), "--seed", summary.at("seed").dump(), "-o",
                       folder.root.string() + "-again"});
    return command_line(arguments);
}

ApiAnswer failure(int status, const std::string& text) { return {status, {{"error", text}}, {}, {}}; }

template <class Work>
ApiAnswer guarded(const Work& work) {
    try {
        return work();
    } catch (const Refusal& e) {
        return failure(e.status, e.what());
    } catch (const UsageError& e) {
        return failure(422, e.what());
    } catch (const Error& e) {
        return failure(422, e.what());
    } catch (const std::bad_alloc&) {
        return failure(507, "not enough memory: close other programs");
    } catch (const std::exception& e) {
        return failure(500, std::string("internal error, please report it: ") + e.what());
    }
}

}  // namespace

Api::Api(Library& library, Board& board, ApiParams params)
    : library_(library),
      board_(board),
      params_(std::move(params)),
      drafts_(library, planner_),
      downloads_(library, params_.program),
      uploads_(library),
      looks_(library, board, params_.program),
      queue_(library, board, looks_, {params_.program, params_.threads}),
      films_(library, board, params_.program) {}

void Api::warm_up() {
    guarded([&]() -> ApiAnswer { return {200, planner_.plan("a bedroom", 0), {}, {}}; });
}

bool Api::has_scene(const std::string& name) const {
    try {
        library_.folder(name);
        return true;
    } catch (const Refusal&) {
        return queue_.has(name);
    }
}

ApiAnswer Api::answer(const ApiRequest& request) {
    return guarded([&]() -> ApiAnswer {
        if (request.method == "GET") return get(request.path);
        if (!request.body.is_object()) throw Refusal(400, "expected a JSON object");
        return post(request.path, request.body);
    });
}

ApiAnswer Api::upload(const std::string& kind, const std::string& name,
                      const std::function<bool(const Uploads::Put&)>& read) {
    return guarded([&]() -> ApiAnswer {
        return {200, kind == "range" ? uploads_.range_map(name, read) : uploads_.panorama(name, read), {}, {}};
    });
}

Json Api::live() const {
    return {{"jobs", queue_.jobs()}, {"version", board_.version()}, {"look", looks_.latest()}, {"film", films_.live()}};
}

ApiAnswer Api::state() {
    const Json scenes = library_.scenes();
    Json shown = Json::array();
    for (const Json& scene : scenes)
        if (!queue_.has(scene.at("name"))) shown.push_back(scene);
    const int threads = params_.threads > 0 ? params_.threads : thread_count();
    return {200,
            {{"version", program_version()},
             {"folder", library_.root().string()},
             {"threads", threads},
             {"free_memory_bytes", available_memory()},
             {"costs", costs(scenes, threads)},
             {"choices", Planner::choices()},
             {"most_upload_bytes", kMostUploadBytes},
             {"scenes", shown},
             {"trash", library_.trash()},
             {"jobs", queue_.jobs()}},
            {},
            {}};
}

Json Api::scene(const std::string& name) {
    Json out = library_.scene(name);
    out["downloads"] = downloads_.list(name);
    for (Json& download : out["downloads"])
        download["command"] = download.at("arguments").empty()
                                  ? Json("")
                                  : Json(command_line(download.at("arguments").get<std::vector<std::string>>()));
    out["command"] = command_of(library_.folder(name), out);
    const std::string from = out.at("from");
    out["has_before"] = !from.empty() && has_scene(from);
    return out;
}

ApiAnswer Api::get(const std::vector<std::string>& path) {
    const std::string what = path.empty() ? "" : path[0];
    if (path.size() == 1 && what == "state") return state();
    if (path.size() == 1 && what == "live") return {200, live(), {}, {}};
    if (path.size() == 2 && what == "scenes") return {200, scene(path[1]), {}, {}};
    if (path.size() == 3 && what == "scenes" && path[2] == "draft") return {200, drafts_.draft(path[1]), {}, {}};
    if (path.size() >= 3 && what == "scenes" && path[2] == "film") return get_film(path[1], path);
    if (path.size() == 4 && what == "scenes" && path[2] == "download") {
        const fs::path file = downloads_.make(path[1], path[3]);
        return {200, {}, file, path[1] + "-" + file.filename().string()};
    }
    if (path.size() == 3 && what == "jobs" && path[2] == "picture") {
        const RunFolder folder{library_.root() / path[1]};
        for (const char* const name : {"training.jpg", "panorama/color.png"})
            if (const auto made = library_.file(path[1], name)) return {200, {}, *made, {}};
        if (is_scene_name(path[1]))
            if (const fs::path look = queue_.look(path[1]); !look.empty()) return {200, {}, look, {}};
        throw Refusal(404, "there is no picture yet");
    }
    if (path.size() == 2 && what == "looks") {
        if (const fs::path picture = looks_.picture(path[1]); !picture.empty()) return {200, {}, picture, {}};
        throw Refusal(404, "there is no picture yet");
    }
    if (path.size() == 2 && what == "uploads") return {200, {}, uploads_.file(path[1]), {}};
    throw Refusal(404, "there is no such address");
}

ApiAnswer Api::post(const std::vector<std::string>& path, const Json& body) {
    const std::string what = path.empty() ? "" : path[0];
    if (path.size() == 1 && what == "plan")
        return {200, planner_.plan(field<std::string>(body, "prompt", ""), seed_in(body)), {}, {}};
    if (path.size() == 1 && what == "look") {
        const std::string prompt = field<std::string>(body, "prompt", "");
        understand_prompt(prompt, false);
        const std::vector<std::string> wished = look_of(prompt, seed_in(body));
        looks_.wish(wished);
        return {200, {{"key", Looks::key_of(wished)}}, {}, {}};
    }
    if (path.size() == 1 && what == "jobs") return {200, create(body), {}, {}};
    if (path.size() == 3 && what == "jobs") return post_job(path[1], path[2]);
    if (path.size() == 3 && what == "scenes") return post_scene(path[1], path[2], body);
    if (path.size() == 4 && what == "scenes" && path[2] == "film") return post_film(path[1], path[3], body);
    if (path.size() == 3 && what == "trash" && path[2] == "restore") {
        const std::string name = library_.restore(path[1]);
        board_.changed();
        return {200, {{"name", name}}, {}, {}};
    }
    throw Refusal(404, "there is no such address");
}

ApiAnswer Api::post_job(const std::string& id, const std::string& what) {
    if (what == "stop") queue_.stop(id);
    else if (what == "resume") queue_.resume(id);
    else if (what == "forget") queue_.forget(id);
    else if (what == "first") queue_.move_first(id);
    else throw Refusal(404, "there is no such address");
    return {200, {{"jobs", queue_.jobs()}}, {}, {}};
}

// scenes/NAME/film: the path; …/film/made: the film; …/film/traced: a picture of the room; …/film/FORMAT: the path for
// other programs.
ApiAnswer Api::get_film(const std::string& scene, const std::vector<std::string>& path) {
    if (path.size() == 3) {
        Json film = films_.film(scene);
        film["view"] = fs::exists(library_.folder(scene).room_json()) ? drafts_.scene_view(scene) : Json(nullptr);
        return {200, std::move(film), {}, {}};
    }
    if (path.size() != 4) throw Refusal(404, "there is no such address");
    if (path[3] == "traced") return {200, {}, films_.traced(scene), {}};
    const fs::path file = path[3] == "made" ? films_.made(scene) : films_.written(scene, path[3]);
    return {200, {}, file, scene + "-" + file.filename().string()};
}

ApiAnswer Api::post_film(const std::string& scene, const std::string& what, const Json& body) {
    if (what == "plan")
        return {200,
                films_.plan(scene, field<std::string>(body, "kind", "tour"), field<float>(body, "seconds", 0)),
                {},
                {}};
    if (what == "path") return {200, films_.save(scene, field<Json>(body, "path", Json::object())), {}, {}};
    if (what == "read") return {200, films_.read(scene, field<std::string>(body, "text", "")), {}, {}};
    if (what == "frame") {
        const int width = std::clamp(field<int>(body, "width", 480), 16, 1920);
        return {200, {{"jpeg", base64(films_.frame(scene, field<float>(body, "time_s", 0), width))}}, {}, {}};
    }
    if (what == "make") films_.make(scene, field<std::string>(body, "ending", "mp4"));
    else if (what == "trace") films_.trace(scene, field<float>(body, "time_s", 0));
    else if (what == "stop") films_.stop();
    else throw Refusal(404, "there is no such address");
    return {200, films_.live(), {}, {}};
}

ApiAnswer Api::post_scene(const std::string& scene, const std::string& what, const Json& body) {
    if (what == "delete") {
        if (queue_.has(scene)) throw Refusal(409, "{} is being made: stop it first", scene);
        const std::string trashed = library_.remove(scene);
        board_.changed();
        return {200, {{"trashed", trashed}}, {}, {}};
    }
    if (what == "edit")
        return {200, drafts_.edit(scene, field<int>(body, "revision", -1), body.value("step", Json::object())), {}, {}};
    if (what == "look") {
        const std::vector<std::string> wished = look_of_draft(scene);
        looks_.wish(wished);
        return {200, {{"key", Looks::key_of(wished)}}, {}, {}};
    }
    if (what == "remake") return {200, remake(scene, body), {}, {}};
    if (what == "complete") {
        complete(scene);
        return {200, {{"id", scene}}, {}, {}};
    }
    throw Refusal(404, "there is no such address");
}

Json Api::create(const Json& body) {
    const std::string prompt = field<std::string>(body, "prompt", "");
    const std::string quality = field<std::string>(body, "quality", "standard");
    const std::string picture = field<std::string>(body, "panorama", ""), range = field<std::string>(body, "range", "");
    const std::uint64_t seed = seed_in(body);
    params_of_quality(quality);  // throws for another name
    if (picture.empty()) understand_prompt(prompt, false);
    const fs::path picture_file = picture.empty() ? "" : uploads_.file(picture),
                   range_file = picture.empty() || range.empty() ? "" : uploads_.file(range);
    const std::string name = field<std::string>(body, "name", "");
    const std::string title = !prompt.empty() ? prompt : fs::path(name).stem().string();

    Job job;
    job.id = library_.reserve(title.empty() ? "panorama" : title);
    std::vector<std::string> flags{
        "--seed", std::to_string(seed), "--quality", quality, "-o", (library_.root() / job.id).string()};
    if (!picture_file.empty()) append(flags, {"--panorama", picture_file.string()});
    if (!range_file.empty()) append(flags, {"--range", range_file.string()});
    append(flags, params_.make_flags);
    job.arguments = arguments_of("make", prompt, flags);
    job.request = {{"title", title}, {"seed", seed}, {"quality", quality}, {"from", ""}};
    job.request["command"] = command_line(job.arguments);
    if (picture.empty()) job.look = look_of(prompt, seed);
    const Json out{{"id", job.id}};
    queue_.add(std::move(job));
    return out;
}

std::vector<std::string> Api::look_of_draft(const std::string& scene) {
    return {"panorama", "--room", looks_.room_file(drafts_.room(scene)).string(), "--seed",
            library_.scene(scene).at("seed").dump()};
}

Json Api::remake(const std::string& scene, const Json& body) {
    const Json before = library_.scene(scene);
    const std::string title = before.at("title");
    Job job;
    job.id = library_.reserve(title);
    Drafts::Made made;
    try {
        made = drafts_.write(scene, field<int>(body, "revision", -1), job.id);
    } catch (...) {
        std::error_code none;
        fs::remove(library_.root() / job.id, none);
        throw;
    }
    library_.note_origin(job.id, scene, made.changes);
    job.arguments = {"edit", (library_.root() / scene).string(), "--room", made.room.string(),
                     "-o",   (library_.root() / job.id).string()};
    job.look = look_of_draft(scene);
    job.request = {{"title", title}, {"seed", before.at("seed")}, {"quality", before.at("quality")},
                   {"from", scene},  {"changes", made.changes},   {"command", command_line(job.arguments)}};
    const Json out{{"id", job.id}};
    queue_.add(std::move(job));
    drafts_.drop(scene);
    return out;
}

// A run that was stopped before it came here: made on the command line, or its job was forgotten.
void Api::complete(const std::string& scene) {
    if (queue_.has(scene)) throw Refusal(409, "{} is being made already", scene);
    const Json summary = library_.scene(scene);
    Job job;
    job.id = scene;
    job.arguments = {"splat", (library_.root() / scene).string()};
    job.request = {{"title", summary.at("title")},
                   {"seed", summary.at("seed")},
                   {"quality", summary.at("quality")},
                   {"from", summary.at("from")},
                   {"command", command_line(job.arguments)}};
    queue_.add(std::move(job));
}

}  // namespace fastscene::studio
