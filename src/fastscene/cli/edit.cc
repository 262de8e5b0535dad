#include <fmt/ranges.h>

#include <filesystem>
#include <optional>

#include "fastscene/base/folder_lock.h"
#include "fastscene/base/writable.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/verb.h"
#include "fastscene/pipeline/cached_weights.h"
#include "fastscene/pipeline/find_earlier_run.h"
#include "fastscene/pipeline/edited_run.h"
#include "fastscene/pipeline/pipeline.h"
#include "fastscene/pipeline/source_json.h"
#include "fastscene/rooms/edit.h"
#include "fastscene/rooms/pack.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct EditFlags {
    std::string target, sentence, room, out, style, time, assets = "cc0";
    std::vector<std::string> remove, move, recolor, add;
    bool in_place = false, plan_only = false;
};

// "sofa-1=green"
EditStep recoloring(const std::string& text, const RoomDocument& document,
                    const std::shared_ptr<const FurniturePack>& pack) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw UsageError("--recolor: expected ID=COLOR, found \"{}\"", text);
    EditStep step;
    step.kind = EditStep::Kind::recolor;
    const std::string id = text.substr(0, equals);
    if (id == "wall" || id == "floor" || id == "ceiling" || id == "trim" || id == "accent_wall") step.surface = id;
    else step.ids = things_named(document, id, pack);
    step.wish = looks_named(text.substr(equals + 1));
    return step;
}

// The flags as steps, in this order; ids are those of the document before.
std::vector<EditStep> steps_of(const EditFlags& flags, const RoomDocument& document,
                               const std::shared_ptr<const FurniturePack>& pack) {
    std::vector<EditStep> out;
    for (const std::string& id : flags.remove) {
        out.emplace_back().ids = things_named(document, id, pack);
    }
    for (std::size_t i = 0; i + 3 < flags.move.size(); i += 4) {
        EditStep& step = out.emplace_back();
        step.kind = EditStep::Kind::move;
        step.ids = things_named(document, flags.move[i], pack);
        step.position = Vec2f{number_from<float>("--move", flags.move[i + 1]),
                              number_from<float>("--move", flags.move[i + 2])};
        step.yaw = number_from<float>("--move", flags.move[i + 3]) * kPi / 180;
    }
    for (const std::string& text : flags.recolor) out.push_back(recoloring(text, document, pack));
    if (!flags.style.empty()) {
        EditStep& step = out.emplace_back();
        step.kind = EditStep::Kind::restyle;
        step.value = flags.style;
    }
    if (!flags.time.empty()) {
        EditStep& step = out.emplace_back();
        step.kind = EditStep::Kind::light;
        step.value = flags.time;
    }
    return out;
}

EditResult edited(const EditFlags& flags, const RoomDocument& document,
                  const std::shared_ptr<const FurniturePack>& pack, const fastscene::Run& run) {
    EditResult out{completed(document, flags.target, pack, run), {}};
    const auto append = [&](EditResult next) {
        out.document = std::move(next.document);
        out.changes.insert(out.changes.end(), next.changes.begin(), next.changes.end());
    };
    const std::vector<EditStep> steps = steps_of(flags, out.document, pack);
    if (!steps.empty()) append(edit_document(out.document, steps, pack, run));
    for (const std::string& thing : flags.add) append(edit_by_sentence(out.document, "add " + thing, pack, run));
    if (!flags.sentence.empty()) append(edit_by_sentence(out.document, flags.sentence, pack, run));
    if (out.changes.empty() && flags.room.empty())
        throw UsageError(
            "edit: expected what to change, as a sentence or by flags; found nothing that changes the room");
    return out;
}

// What was done; of the rest there was a warning.
std::vector<std::string> lines_of(const EditResult& result) {
    std::vector<std::string> out;
    for (const EditChange& change : result.changes)
        if (change.id != kNotDone) out.push_back(fmt::format("{}: {}", change.id, change.what));
    return out;
}
std::string as_text(const EditResult& result, const std::string& where) {
    std::string out;
    for (const std::string& line : lines_of(result)) out += line + "\n";
    return out + where;
}
Json as_json(const EditResult& result, const std::string& where) {
    Json changes = Json::array();
    for (const EditChange& change : result.changes) changes.push_back({{"id", change.id}, {"what", change.what}});
    return {{"out", where}, {"changes", changes}};
}

void edit_file(const EditFlags& flags, const Session& session) {
    if (!flags.out.empty() && flags.in_place) throw UsageError("--in-place: expected without -o");
    if (!flags.room.empty())
        throw UsageError(
            "--room: expected beside the folder of a run, found \"{}\"; a document is edited as it is: "
            "fastscene edit {} \"…\"",
            flags.target, flags.room);
    const fs::path from = flags.target;
    const fs::path to = flags.in_place       ? from
                        : !flags.out.empty() ? fs::path(flags.out)
                                             : from.parent_path() / (from.stem().string() + "-edited.json");
    check_writable(to);
    std::vector<std::string> complaints;
    const auto pack = FurniturePack::open(flags.assets, complaints);
    const EditResult result = edited(flags, load_document(from), pack, session.run(0));
    write_json(to, document_json(result.document));
    session.print(as_text(result, to.string()), as_json(result, to.string()));
}

// What was asked for, to recognize it.
std::string text_of(const EditFlags& flags) {
    return fmt::format("{}|{}|{}|{}|{}|{}|{}|{}", flags.sentence, flags.room, flags.style, flags.time,
                       fmt::join(flags.remove, " "), fmt::join(flags.move, " "), fmt::join(flags.recolor, " "),
                       fmt::join(flags.add, " "));
}

// Whether an interrupted edit in place is not of this document and is to be forgotten.
bool is_another(const RunFolder& unfinished, const SceneSource& source) {
    if (!fs::exists(unfinished.run_json())) return false;
    const Json found = read_json(unfinished.run_json()), wanted = json_of_source(source);
    return found.value("document", Json()) != wanted.value("document", Json()) ||
           found.value("edited_from", Json()) != wanted.value("edited_from", Json());
}

void edit_run(const EditFlags& flags, const Session& session) {
    if (!flags.out.empty() && flags.in_place) throw UsageError("--in-place: expected without -o");
    if (flags.plan_only && flags.in_place)
        throw UsageError("--plan-only: expected without --in-place, which would replace the scene by its panorama");
    const RunFolder from{fs::path(flags.target).lexically_normal()};
    if (flags.in_place && is_edit_half_finished(from)) {
        const FolderLock lock(from.root);
        if (resume_finishing_edit(from) == text_of(flags))
            return session.print(from.root.string(), {{"out", from.root.string()}, {"changes", Json::array()}});
    }
    RecordedRun recorded = recorded_run(from);
    std::optional<FolderLock> lock;
    if (flags.in_place) lock.emplace(from.root);
    const Run run = session.run(recorded.seed);
    const PanoramaParams& panorama = recorded.request.params.panorama;
    const auto pack = furniture_pack(panorama);
    const EditResult result = edited(
        flags, flags.room.empty() ? document_of_run(from, recorded, run) : load_document(flags.room), pack, run);
    std::string name = from.root.string();
    while (name.size() > 1 && name.ends_with('/')) name.pop_back();
    const RunFolder to{flags.in_place      ? from.root
                       : flags.out.empty() ? fs::path(name + "-edited")
                                           : fs::path(flags.out)};
    if (!flags.in_place && fs::weakly_canonical(to.root) == fs::weakly_canonical(from.root))
        throw UsageError("-o: expected another folder than that of the scene; --in-place changes the scene itself");
    for (const std::string& line : lines_of(result)) run.note(line);
    SceneRequest& request = recorded.request;
    request.source = edit_of(document_source(result.document, to.room_json()), from);
    request.last_stage = flags.plan_only ? "panorama" : std::string(last_finished_stage(from));
    use_cached_weights(request, run);
    if (flags.in_place) {
        request.start_over = is_another(unfinished_edit(from), request.source);
        make_scene(request, unfinished_edit(from), run);
        finish_edit(from, text_of(flags));
    } else {
        make_scene(request, to, run);
    }
    session.print(as_text(result, to.root.string()), as_json(result, to.root.string()));
}

}  // namespace

Verb add_edit(CLI::App& app) {
    auto flags = std::make_shared<EditFlags>();
    CLI::App* verb = app.add_subcommand(
        "edit", "Changes the room of a scene: moves, adds, removes and recolors things; all others stay.");
    verb->add_option("scene", flags->target, "Folder of a run from a prompt or a room, or a room's document.")
        ->type_name("DIR|FILE")
        ->required();
    verb->add_option("sentence", flags->sentence, "What to change, in words.")->type_name("SENTENCE");
    const auto list = [&](const std::string& flag, std::vector<std::string>& to, const char* kind,
                          const std::string& sentence) {
        return verb->add_option(flag, to, sentence)
            ->type_name(kind)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    list("--remove", flags->remove, "ID", "Remove this thing, with what stands on it. May be repeated.")->expected(1);
    list("--move", flags->move, "ID X Z YAW", "Move it there: metres in the room, degrees. May be repeated.")
        ->expected(4);
    list("--recolor", flags->recolor, "ID=COLOR",
         "Give it this color or material; ID may be wall, floor, ceiling or trim. May be repeated.")
        ->expected(1);
    list("--add", flags->add, "THING", "Add a thing, in words: \"a floor lamp beside the bed\". May be repeated.")
        ->expected(1);
    verb->add_option("--room", flags->room,
                     "Begin with this document instead of the scene's room; the scene's settings are kept.")
        ->type_name("FILE");
    verb->add_option("--style", flags->style, "Another style for the room.")->type_name("STYLE");
    verb->add_option("--time", flags->time, "Another hour: morning, day, evening, dusk, night.")->type_name("HOUR");
    verb->add_option("-o,--out", flags->out,
                     "Folder of the new run, or the new document; default: the name and -edited.")
        ->type_name("DIR|FILE");
    verb->add_flag("--in-place", flags->in_place,
                   "Replace the scene, once the edited one is complete, or overwrite the document.");
    verb->add_flag("--plan-only", flags->plan_only, "Of a run: only its panorama, to look at the change.");
    verb->add_option("--assets", flags->assets,
                     "Of a document: a folder of your own models; or of the furniture pack none, cc0 or all.")
        ->type_name("DIR|none|cc0|all")
        ->capture_default_str();
    verb->footer(
        "Examples:\n  fastscene edit out/bedroom \"move the armchair to the window, make the bed linen\"\n  fastscene "
        "edit "
        "room.json --remove rug-1 --recolor sofa-1=green -o green.json");
    return {verb, [flags](const Session& session) {
                if (fs::is_directory(flags->target)) edit_run(*flags, session);
                else edit_file(*flags, session);
            }};
}

}  // namespace fastscene::cli
