#include "fastscene/studio/drafts.h"

#include "fastscene/base/file.h"
#include "fastscene/pipeline/edited_run.h"
#include "fastscene/studio/plan_view.h"
#include "fastscene/studio/refusal.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostUndone = 40;  // steps; a document has some tens of kilobytes
constexpr const char* kRoomFile = "room.json";

template <class T>
T needed(const Json& step, const char* key) {
    try {
        return step.at(key).get<T>();
    } catch (const Json::exception&) {
        throw Refusal(400, "edit: expected \"{}\" in {}", key,
                      step.dump(-1, ' ', false, Json::error_handler_t::replace));
    }
}

float radians(double degrees) { return static_cast<float>(degrees) * kPi / 180; }

EditStep step_from(const Json& json) {
    using Kind = EditStep::Kind;
    const std::string op = needed<std::string>(json, "op");
    EditStep step;
    if (op == "style" || op == "time") {
        step.kind = op == "style" ? Kind::restyle : Kind::light;
        step.value = needed<std::string>(json, "value");
        return step;
    }
    if (op == "recolor") {
        step.kind = Kind::recolor;
        step.wish = looks_named(needed<std::string>(json, "looks"));
        if (json.contains("surface")) step.surface = needed<std::string>(json, "surface");
        else step.ids = {needed<std::string>(json, "id")};
        return step;
    }
    step.ids = {needed<std::string>(json, "id")};
    if (op == "remove") return step;
    if (op == "turn") {
        step.kind = Kind::turn;
        step.yaw = radians(needed<double>(json, "by_deg"));
    } else if (op == "move") {
        step.kind = Kind::move;
        step.position = Vec2f{needed<float>(json, "x"), needed<float>(json, "z")};
        step.yaw = radians(needed<double>(json, "yaw_deg"));
    } else {
        throw Refusal(400, "edit: unknown step \"{}\"", op);
    }
    return step;
}

EditResult applied(const RoomDocument& document, const Json& step, const std::shared_ptr<const FurniturePack>& pack) {
    const std::string op = needed<std::string>(step, "op");
    if (op == "say") return edit_by_sentence(document, needed<std::string>(step, "words"), pack, Run{});
    if (op == "add") return edit_by_sentence(document, "add " + needed<std::string>(step, "words"), pack, Run{});
    return edit_document(document, {step_from(step)}, pack, Run{});
}

Json changes_json(const std::vector<EditChange>& changes) {
    Json out = Json::array();
    for (const EditChange& change : changes) out.push_back({{"id", change.id}, {"what", change.what}});
    return out;
}

}  // namespace

fs::path Drafts::file(const std::string& scene) const { return library_.own("drafts") / (scene + ".json"); }

Drafts::State Drafts::load(const std::string& scene) const {
    State state;
    if (!fs::exists(file(scene))) return state;
    try {
        const Json json = read_json(file(scene));
        state.revision = json.at("revision");
        state.past = json.at("past").get<std::vector<Json>>();
        state.future = json.at("future").get<std::vector<Json>>();
        state.now = json.at("now");
    } catch (const Json::exception& e) {
        throw Error("{}: expected a draft of the studio: {}", file(scene).string(), e.what());
    }
    return state;
}

void Drafts::save(const std::string& scene, const State& state) const {
    write_file(
        file(scene),
        Json{{"revision", state.revision}, {"past", state.past}, {"future", state.future}, {"now", state.now}}.dump());
}

RoomDocument Drafts::document(const std::string& scene, const State& state) const {
    if (!state.now.is_null()) return read_document(state.now.at("document").dump(), kRoomFile);
    const RunFolder folder = library_.folder(scene);
    const RecordedRun recorded = recorded_run(folder);
    return document_of_run(folder, recorded, Run{recorded.seed, nullptr, {}});
}

std::shared_ptr<const FurniturePack> Drafts::pack(const std::string& scene) {
    return planner_.pack(recorded_run(library_.folder(scene)).request.params.panorama.assets);
}

Json Drafts::answer(const std::string& scene, const State& state) {
    const std::uint64_t seed = recorded_run(library_.folder(scene)).seed;
    const DocumentRoom room = furnish_document(document(scene, state), kRoomFile, pack(scene), Run{seed, nullptr, {}});
    return {{"revision", state.revision},
            {"view", plan_view(room)},
            {"changes", state.now.is_null() ? Json::array() : state.now.at("changes")},
            {"can_undo", !state.past.empty()},
            {"can_redo", !state.future.empty()}};
}

Json Drafts::scene_view(const std::string& scene) {
    const std::lock_guard lock(mutex_);
    return answer(scene, {}).at("view");
}

Json Drafts::draft(const std::string& scene) {
    const std::lock_guard lock(mutex_);
    return answer(scene, load(scene));
}

Json Drafts::edit(const std::string& scene, int revision, const Json& step) {
    const std::lock_guard lock(mutex_);
    library_.folder(scene);
    State state = load(scene);
    if (state.revision != revision)
        throw Refusal(409, "this room was changed in another window: it is shown now, and your change was not applied");
    const std::string op = needed<std::string>(step, "op");
    const auto swap_with = [&](std::vector<Json>& from, std::vector<Json>& to) {
        if (from.empty()) throw Refusal(409, "there is nothing to {}", op);
        to.push_back(state.now);
        state.now = from.back();
        from.pop_back();
    };
    if (op == "undo") {
        swap_with(state.past, state.future);
    } else if (op == "redo") {
        swap_with(state.future, state.past);
    } else if (op == "reset") {
        state.past.clear(), state.future.clear();
        state.now = nullptr;
    } else {
        const EditResult result = applied(document(scene, state), step, pack(scene));
        Json changes = state.now.is_null() ? Json::array() : state.now.at("changes");
        for (Json& change : changes_json(result.changes)) changes.push_back(std::move(change));
        state.past.push_back(state.now);
        if (state.past.size() > kMostUndone) state.past.erase(state.past.begin());
        state.future.clear();
        state.now = {{"document", document_json(result.document)}, {"changes", std::move(changes)}};
    }
    ++state.revision;
    Json out = answer(scene, state);
    save(scene, state);
    return out;
}

Drafts::Made Drafts::write(const std::string& scene, int revision, const std::string& new_scene) {
    const std::lock_guard lock(mutex_);
    const State state = load(scene);
    if (state.revision != revision)
        throw Refusal(409, "this room was changed in another window: check it, then make it");
    if (state.now.is_null()) throw Refusal(409, "nothing was changed yet");
    const fs::path room = library_.own("rooms") / (new_scene + ".json");
    write_json(room, state.now.at("document"));
    return {room, state.now.at("changes")};
}

std::string Drafts::room(const std::string& scene) {
    const std::lock_guard lock(mutex_);
    const State state = load(scene);
    if (state.now.is_null()) throw Refusal(409, "nothing was changed yet");
    return state.now.at("document").dump(2);
}

void Drafts::drop(const std::string& scene) {
    const std::lock_guard lock(mutex_);
    std::error_code none;
    fs::remove(file(scene), none);
}

}  // namespace fastscene::studio
