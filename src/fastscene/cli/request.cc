#include "fastscene/cli/request.h"

#include "fastscene/cli/checks.h"
#include "fastscene/pipeline/cached_weights.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/pack.h"

namespace fastscene::cli {
void add_param_flags(CLI::App& app, const std::shared_ptr<RequestFlags>& flags, const std::string& last_stage) {
    SceneParams defaults = params_of_quality(flags->quality);
    bool wanted = true;
    visit_sections(defaults, [&](std::string_view section, auto& fields) {
        if (wanted)
            add_fields(app, std::string(section), fields, flags->given,
                       fmt::format("Settings of {} (defaults are those of --quality {})", section, flags->quality));
        if (section == last_stage) wanted = false;
    });
    // Named after the paper's step.
    if (const CLI::Option* sfm = app.get_option_no_throw("--views-sfm"))
        app.add_option_function<std::string>(
               "--sfm", [given = flags->given](const std::string& text) { (*given)["--views-sfm"] = text; },
               "The same as --views-sfm.")
            ->type_name(sfm->get_type_name())
            ->group(sfm->get_group());
    if (app.get_option_no_throw("--depth-weights"))
        app.add_option("--trust", flags->trusted,
                       "Files of code (TorchScript) that may run: paths or SHA-256 hashes. Never taken from a run's "
                       "record (docs/torchscript.md).")
            ->type_name("FILE|SHA256")
            ->allow_extra_args(false);
    app.add_option("--quality", flags->quality, "Preset that fills all settings below.")
        ->type_name("draft|standard|high")
        ->check(one_of(qualities()))
        ->default_str(flags->quality)
        ->each([flags = flags.get()](const std::string&) { flags->has_quality = true; });
}

namespace {
void trust(SceneParams& params, const std::vector<std::string>& files) {
    params.depth.trusted = params.walk.trusted = files;
}
}  // namespace

void apply_param_flags(SceneParams& params, const Given& given) {
    visit_sections(params,
                   [&](std::string_view section, auto& fields) { apply_fields(std::string(section), fields, given); });
    // An explicit number of Gaussians overrides the density.
    if (given.count("--splat-count") && !given.count("--splat-per-m2")) params.splat.per_m2 = 0;
}

namespace {

// Prints the scene's folder to stdout.
void make_and_print(const SceneRequest& request, const RunFolder& folder, const Run& run, const Session& session) {
    const Json report = make_scene(request, folder, run);
    if (request.last_stage == "splat") session.print(folder.root.string(), report);
    else session.print(folder.stage(request.last_stage).string(), report);
    if (request.last_stage == "splat" && std::filesystem::exists(folder.viewer_html()))
        run.note(fmt::format("open {} in a browser to walk through it", folder.viewer_html().string()));
}

// Value of --panorama that is not a picture.
constexpr std::string_view kPainter = "diffusion360";

bool is_painted(const RequestFlags& flags) {
    const auto named = flags.source.find("--panorama");
    const auto backend = flags.given->find("--panorama-backend");
    return (named != flags.source.end() && named->second == kPainter) ||
           (backend != flags.given->end() && backend->second == kPainter);
}

bool is_enlarged(const RequestFlags& flags) {
    const auto upscale = flags.given->find("--panorama-upscale");
    return upscale != flags.given->end() && upscale->second != "none";
}

// Throws UsageError for contradictory flags.
SceneSource starting_source(const CLI::App& verb, const RequestFlags& flags) {
    const bool painted = is_painted(flags), larger = is_enlarged(flags);
    const SceneSource source = source_of(flags.source, painted);
    const auto given = [&](std::string_view flag) { return flags.source.contains(flag); };
    const bool picture = !picture_of(source).empty();
    if (!painted && !picture && !given("prompt") && !given("--room"))
        throw UsageError("{}: expected a prompt in quotes, --room FILE or --panorama FILE", verb.get_name());
    if (larger && !painted && !picture)
        throw UsageError(
            "--panorama-upscale: expected together with --panorama diffusion360 or --panorama FILE, found alone");
    if (picture && !larger && given("--weights"))
        throw UsageError(
            "--weights: expected together with --panorama diffusion360, or --panorama FILE and --panorama-upscale, "
            "found alone");
    if (painted && prompt_of(source).find_first_not_of(" \t\r\n") == std::string::npos)
        throw UsageError("{}: expected a prompt in quotes, found none", verb.get_name());
    return source;
}

// A document's own, unless another one was asked for.
std::uint64_t seed_of(const SceneSource& source, const CLI::App& verb, const RequestFlags& flags) {
    if (const auto* room = std::get_if<DocumentSource>(&source); room && verb.count("--seed") == 0)
        return read_document(room->document, room->room.string()).seed.value_or(0);
    return number_from<std::uint64_t>("--seed", flags.seed);
}

SceneRequest starting_request(const CLI::App& verb, const RequestFlags& flags, const std::string& last_stage) {
    SceneRequest request;
    request.source = starting_source(verb, flags);
    request.quality = flags.quality;
    request.params = params_of_quality(flags.quality);
    PanoramaParams& panorama = request.params.panorama;
    if (const auto* painting = std::get_if<PaintingSource>(&request.source)) {
        panorama.width = 1024;  // the model's training resolution
        if (!painting->photo.empty()) panorama.diffusion.guidance = kGuidanceAroundPhoto;
    }
    apply_param_flags(request.params, *flags.given);
    trust(request.params, flags.trusted);
    if (has_room(request.source) && panorama.backend == "image")
        throw UsageError("--panorama-backend image: expected --panorama FILE, found none");
    panorama.backend = panorama_backend(request.source);
    if (flags.strict) panorama.strict = true;
    panorama.assets = absolute_assets(flags.assets.empty() ? panorama.assets : flags.assets);
    request.last_stage = last_stage;
    request.start_over = flags.force;
    return request;
}

}  // namespace

Verb add_starting_verb(CLI::App& app, const std::string& name, const std::string& sentence,
                       const std::string& last_stage) {
    auto flags = std::make_shared<RequestFlags>();
    CLI::App* verb = app.add_subcommand(name, sentence);
    verb->add_option("-o,--out", flags->out, "Folder of the run; default: out/ plus the words of the prompt.")
        ->type_name("DIR");
    verb->add_option("--seed", flags->seed, "Same seed, same scene, byte for byte.")
        ->type_name("N")
        ->capture_default_str();
    add_source_flags(*verb, flags->source);
    verb->add_flag("--strict", flags->strict, "Refuse a prompt with words that are not understood.");
    verb->add_option("--assets", flags->assets,
                     "Models beyond the built-in ones: a folder of your own (docs/assets.md), or of the furniture pack "
                     "none, those in "
                     "the public domain (cc0, default), or all, which requires distributing credits.txt.")
        ->type_name("DIR|none|cc0|all");
    verb->add_flag("--force", flags->force, "Delete a run of another prompt or seed in the folder.");
    add_param_flags(*verb, flags, last_stage);

    return {verb, [flags, last_stage, verb](const Session& session) {
                SceneRequest request = starting_request(*verb, *flags, last_stage);
                const Run run = session.run(seed_of(request.source, *verb, *flags));
                use_cached_weights(request, run);
                // The prompt is validated before it becomes a folder's name.
                if (std::holds_alternative<PromptSource>(request.source))
                    read_prompt(prompt_of(request.source), request.params.panorama);
                const std::filesystem::path picture = picture_of(request.source);
                const std::string title = picture.empty() ? prompt_of(request.source) : picture.stem().string();
                const RunFolder folder{flags->out.empty() ? std::filesystem::path("out") / slug_of(title)
                                                          : std::filesystem::path(flags->out)};
                make_and_print(request, folder, run, session);
            }};
}

Verb add_stage_verb(CLI::App& app, const std::string& name, const std::string& sentence,
                    std::shared_ptr<RequestFlags> flags, const std::function<void(CLI::App&)>& first) {
    CLI::App* verb = app.add_subcommand(name, sentence);
    verb->add_option("folder", flags->out, "Folder of a run.")->type_name("DIR")->required();
    if (first) first(*verb);
    add_param_flags(*verb, flags, name);
    return {verb, [flags, name](const Session& session) {
                const RunFolder folder{flags->out};
                RecordedRun recorded = recorded_run(folder);
                if (flags->has_quality) {
                    recorded.request.quality = flags->quality;
                    recorded.request.params = params_of_quality(flags->quality);
                }
                apply_param_flags(recorded.request.params, *flags->given);
                trust(recorded.request.params, flags->trusted);
                recorded.request.last_stage = name;
                const Run run = session.run(recorded.seed);
                use_cached_weights(recorded.request, run);
                make_and_print(recorded.request, folder, run, session);
            }};
}

}  // namespace fastscene::cli
