#include "fastscene/cli/request.h"

#include "fastscene/pipeline/share.h"

namespace fastscene::cli {
namespace {

// Flags of the stages up to `last_stage`.
void add_param_flags(CLI::App& app, const std::shared_ptr<RequestFlags>& flags, const std::string& last_stage) {
    SceneParams defaults = params_of_quality(flags->quality);
    bool wanted = true;
    visit_sections(defaults, [&](std::string_view section, auto& fields) {
        if (wanted)
            add_fields(app, std::string(section), fields, flags->given,
                       fmt::format("Settings of {} (defaults are those of --quality {})", section, flags->quality));
        if (section == last_stage) wanted = false;
    });
    app.add_option("--quality", flags->quality, "Preset that fills all settings below.")
        ->type_name("draft|standard|high")
        ->check(CLI::IsMember(qualities()).description(""))
        ->default_str(flags->quality)
        ->each([flags = flags.get()](const std::string&) { flags->has_quality = true; });
}

void apply_param_flags(SceneParams& params, const Given& given) {
    visit_sections(params, [&](std::string_view section, auto& fields) { apply_fields(std::string(section), fields, given); });
}

// stdout: where the scene is.
void make_and_print(const SceneRequest& request, const RunFolder& folder, const Run& run, const Session& session) {
    const Json report = make_scene(request, folder, run);
    if (request.last_stage == "splat")
        session.print(folder.root.string(), report);
    else
        session.print(folder.stage(request.last_stage).string(), report);
    if (request.last_stage == "splat" && std::filesystem::exists(folder.viewer_html()))
        run.note(fmt::format("open {} in a browser to walk through it", folder.viewer_html().string()));
}

}  // namespace

Verb add_starting_verb(CLI::App& app, const std::string& name, const std::string& sentence, const std::string& last_stage) {
    auto flags = std::make_shared<RequestFlags>();
    CLI::App* verb = app.add_subcommand(name, sentence);
    verb->add_option("prompt", flags->prompt, "The scene in a sentence, for example \"a cozy bedroom with a red armchair\".")->type_name("PROMPT");
    verb->add_option("-o,--out", flags->out, "Folder of the run; default: out/ and the words of the prompt.")->type_name("DIR");
    verb->add_option("--seed", flags->seed, "Same seed, same scene, byte for byte.")->type_name("N")->capture_default_str();
    verb->add_option("--panorama", flags->picture, "Start from this 2:1 picture (.jpg, .png) instead of a prompt.")->type_name("FILE");
    verb->add_option("--range", flags->range_map, "Range map of that picture (.exr, .pfm, 16-bit .png in millimetres).")->type_name("FILE");
    verb->add_flag("--strict", flags->strict, "Refuse a prompt with words that are not understood.");
    verb->add_flag("--force", flags->force, "Throw away what another prompt or seed has left in the folder.");
    add_param_flags(*verb, flags, last_stage);

    return {verb, [flags, last_stage, verb](const Session& session) {
                if (flags->picture.empty() && verb->count("prompt") == 0)
                    throw UsageError("{}: expected a prompt in quotes, or --panorama FILE --range FILE", verb->get_name());
                SceneRequest request;
                request.source = {flags->prompt, flags->picture, flags->range_map};
                request.quality = flags->quality;
                request.params = params_of_quality(flags->quality);
                apply_param_flags(request.params, *flags->given);
                if (flags->strict) request.params.panorama.strict = true;
                if (!flags->picture.empty()) request.params.panorama.backend = "image";
                if (flags->picture.empty() && request.params.panorama.backend == "image")
                    throw UsageError("--panorama-backend image: expected --panorama FILE, found none");
                request.last_stage = last_stage;
                request.start_over = flags->force;
                // The prompt is looked at before it becomes a folder's name.
                if (flags->picture.empty()) understand_prompt(flags->prompt, request.params.panorama.strict);
                const std::string title = flags->picture.empty() ? flags->prompt : std::filesystem::path(flags->picture).stem().string();
                const RunFolder folder{flags->out.empty() ? std::filesystem::path("out") / slug_of(title) : std::filesystem::path(flags->out)};
                make_and_print(request, folder, session.run(number_from<std::uint64_t>("--seed", flags->seed)), session);
            }};
}

Verb add_stage_verb(CLI::App& app, const std::string& name, const std::string& sentence) {
    auto flags = std::make_shared<RequestFlags>();
    CLI::App* verb = app.add_subcommand(name, sentence);
    verb->add_option("folder", flags->out, "Folder of a run.")->type_name("DIR")->required();
    add_param_flags(*verb, flags, name);
    return {verb, [flags, name](const Session& session) {
                const RunFolder folder{flags->out};
                RecordedRun recorded = recorded_run(folder);
                if (flags->has_quality) {
                    recorded.request.quality = flags->quality;
                    recorded.request.params = params_of_quality(flags->quality);
                }
                apply_param_flags(recorded.request.params, *flags->given);
                recorded.request.last_stage = name;
                make_and_print(recorded.request, folder, session.run(recorded.seed), session);
            }};
}

}  // namespace fastscene::cli
