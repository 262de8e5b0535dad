// splat: a stage of a run, and a command of its own for photographs with cameras.
#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "fastscene/cli/request.h"
#include "fastscene/cli/splat_select.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/pipeline/capture_run.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct CaptureFlags {
    std::map<std::string, std::string> sources;  // by kind; empty: not given
    std::string images, masks, points, out, seed = "0";
    bool force = false;
    std::shared_ptr<Given> given = std::make_shared<Given>();
};

// The maximum picture size depends on the preset.
int max_size_of(const std::string& quality) { return quality == "draft" ? 640 : quality == "standard" ? 1024 : 1600; }

void train(const CaptureRequest& request, const RunFolder& folder, std::uint64_t seed, const Session& session) {
    const Run run = session.run(seed);
    const Json report = train_capture(request, folder, run);
    session.print(folder.root.string(), report);
    if (fs::exists(folder.viewer_html()))
        run.note(fmt::format("open {} in a browser to walk through it", folder.viewer_html().string()));
}

auto given_source(const CaptureFlags& flags) {
    return std::find_if(flags.sources.begin(), flags.sources.end(), [](const auto& s) { return !s.second.empty(); });
}

// "--colmap, --nerfstudio or --polycam"
std::string source_flags() {
    std::vector<std::string> flags;
    for (const CaptureKind& kind : capture_kinds()) flags.push_back(fmt::format("--{}", kind.name));
    return any_of(flags);
}

CaptureRequest request_of(const CaptureFlags& flags, const RequestFlags& stage) {
    CaptureRequest request;
    const auto given = given_source(flags);
    request.source = {given->first, given->second, flags.images, flags.masks, flags.points};
    request.quality = stage.quality;
    request.splat = capture_params_of_quality(stage.quality);
    request.photos.max_size = max_size_of(stage.quality);
    request.start_over = flags.force;
    return request;
}

// Flags for photographs only.
constexpr std::array kCaptureOnly{"--out", "--images", "--masks", "--points", "--seed", "--force"};

void add_capture_flags(CLI::App& verb, CaptureFlags& flags) {
    const std::string group = "Photographs with cameras (instead of a run's folder)";
    const auto add = [&](const std::string& name, std::string& value, const char* type, const char* sentence) {
        return verb.add_option(name, value, sentence)->type_name(type)->group(group);
    };
    for (const CaptureKind& kind : capture_kinds())
        add(fmt::format("--{}", kind.name), flags.sources[kind.name], kind.type, kind.sentence);
    add("-o,--out", flags.out, "DIR", "Output folder; default: out/ plus the name of the source.");
    add("--images", flags.images, "DIR", "Folder of the pictures; default: images/ next to the model.");
    add("--masks", flags.masks, "DIR",
        "Folder of masks, white = used; default: masks/ next to the model, if it exists.");
    add("--points", flags.points, "FILE", "Initial points as .ply, instead of the capture's own.");
    add("--seed", flags.seed, "N", "Same seed, same splats, byte for byte.")->default_str("0");
    verb.add_flag("--force", flags.force, "Delete another run in the folder.")->group(group);
    PhotosParams photos;
    photos.max_size = max_size_of("standard");
    add_fields(verb, "", photos, flags.given, group);
}

// This command's own settings are accepted without prefix, too: --until for --splat-until.
void add_short_names(CLI::App& verb, const std::shared_ptr<Given>& given) {
    const std::string prefix = "--splat-";
    for (const CLI::Option* option : verb.get_options()) {
        const std::string name = option->get_lnames().empty() ? "" : "--" + option->get_lnames().front();
        if (!name.starts_with(prefix)) continue;
        const std::string own = "--" + name.substr(prefix.size());
        if (option->get_expected_max() == 0)
            verb.add_flag_callback(own, [given, name] { (*given)[name] = "true"; })->group("");
        else
            verb.add_option_function<std::string>(own,
                                                  [given, name](const std::string& text) { (*given)[name] = text; })
                ->group("");
    }
}

// Flags without effect are probably mistakes.
void check_flags(const CLI::App& verb, const Given& stage_flags, const CaptureFlags& capture, bool from_capture,
                 bool recorded_capture) {
    if (from_capture || recorded_capture)
        for (const auto& [flag, text] : stage_flags)
            if (!flag.starts_with("--splat-"))
                throw UsageError("{}: expected with the folder of a made scene; photographs have no such stage", flag);
    if (from_capture) return;
    for (const char* flag : kCaptureOnly)
        if (verb.count(flag))
            throw UsageError("{}: expected with {}, found with the folder of a run, which has its own", flag,
                             source_flags());
    if (!recorded_capture && !capture.given->empty())
        throw UsageError("{}: expected with photographs, found with the folder of a made scene",
                         capture.given->begin()->first);
}

}  // namespace

Verb add_splat(CLI::App& app) {
    auto stage = std::make_shared<RequestFlags>();
    auto flags = std::make_shared<CaptureFlags>();
    Verb verb = add_stage_verb(
        app, "splat",
        "Views -> 3D Gaussians, and a page to walk through them; also trains on photographs with cameras.", stage,
        [&](CLI::App& help) { add_capture_flags(help, *flags); });
    verb.app->get_option("folder")->required(false);
    add_short_names(*verb.app, stage->given);
    const Verb selecting = add_splat_select(*verb.app);
    selecting.app->fallthrough();  // common flags belong to `splat`
    verb.app->footer(
        "The prefix --splat- may be omitted: --until is --splat-until.\n\nExamples:\n  fastscene splat --colmap photos "
        "-o out/photos\n  fastscene splat out/bedroom --splat-steps 5000\n  fastscene splat select -i out/bedroom "
        "--class "
        "armchair -o armchair.ply");

    const auto continue_run = verb.act;
    verb.act = [stage, flags, continue_run, selecting, app = verb.app](const Session& session) {
        if (selecting.app->parsed()) return selecting.act(session);
        const auto sources = !stage->out.empty() + std::count_if(flags->sources.begin(), flags->sources.end(),
                                                                 [](const auto& s) { return !s.second.empty(); });
        if (sources != 1)
            throw UsageError("splat: expected the folder of a run, or one of {}, found {}", source_flags(), sources);
        if (!stage->out.empty()) {
            const RunFolder folder{stage->out};
            auto recorded = recorded_capture(folder);
            check_flags(*app, *stage->given, *flags, false, recorded.has_value());
            if (!recorded) return continue_run(session);
            if (stage->has_quality) recorded->request.splat = capture_params_of_quality(stage->quality);
            apply_fields("splat", recorded->request.splat, *stage->given);
            apply_fields("", recorded->request.photos, *flags->given);
            return train(recorded->request, folder, recorded->seed, session);
        }
        check_flags(*app, *stage->given, *flags, true, false);
        CaptureRequest request = request_of(*flags, *stage);
        apply_fields("splat", request.splat, *stage->given);
        apply_fields("", request.photos, *flags->given);
        fs::path source = fs::absolute(request.source.source).lexically_normal();
        if (source.filename().empty()) source = source.parent_path();
        const std::string name = fs::is_regular_file(source) ? source.parent_path().filename().string()
                                                             : source.filename().string();
        const RunFolder folder{flags->out.empty() ? fs::path("out") / slug_of(name) : fs::path(flags->out)};
        train(request, folder, number_from<std::uint64_t>("--seed", flags->seed), session);
    };
    return verb;
}

}  // namespace fastscene::cli
