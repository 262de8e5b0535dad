#include "fastscene/cli/request.h"

#include "fastscene/cli/checks.h"
#include "fastscene/pipeline/cached_weights.h"
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
    // As the paper's step is called.
    if (const CLI::Option* sfm = app.get_option_no_throw("--views-sfm"))
        app.add_option_function<std::string>(
               "--sfm", [given = flags->given](const std::string& text) { (*given)["--views-sfm"] = text; },
               "The same as --views-sfm.")
            ->type_name(sfm->get_type_name())
            ->group(sfm->get_group());
    app.add_option("--quality", flags->quality, "Preset that fills all settings below.")
        ->type_name("draft|standard|high")
        ->check(one_of(qualities()))
        ->default_str(flags->quality)
        ->each([flags = flags.get()](const std::string&) { flags->has_quality = true; });
}

void apply_param_flags(SceneParams& params, const Given& given) {
    visit_sections(params,
                   [&](std::string_view section, auto& fields) { apply_fields(std::string(section), fields, given); });
    // Who names a number of Gaussians means it.
    if (given.count("--splat-count") && !given.count("--splat-per-m2")) params.splat.per_m2 = 0;
}

// stdout: where the scene is.
void make_and_print(const SceneRequest& request, const RunFolder& folder, const Run& run, const Session& session) {
    const Json report = make_scene(request, folder, run);
    if (request.last_stage == "splat") session.print(folder.root.string(), report);
    else session.print(folder.stage(request.last_stage).string(), report);
    if (request.last_stage == "splat" && std::filesystem::exists(folder.viewer_html()))
        run.note(fmt::format("open {} in a browser to walk through it", folder.viewer_html().string()));
}

}  // namespace

Verb add_starting_verb(CLI::App& app, const std::string& name, const std::string& sentence,
                       const std::string& last_stage) {
    auto flags = std::make_shared<RequestFlags>();
    CLI::App* verb = app.add_subcommand(name, sentence);
    verb->add_option("prompt", flags->prompt,
                     "The scene in a sentence, for example \"a cozy bedroom with a red armchair\".")
        ->type_name("PROMPT");
    verb->add_option("-o,--out", flags->out, "Folder of the run; default: out/ and the words of the prompt.")
        ->type_name("DIR");
    verb->add_option("--seed", flags->seed, "Same seed, same scene, byte for byte.")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option("--panorama", flags->picture,
                     "Start from this 2:1 picture (.jpg, .png, .webp, .tif, .hdr, .exr) instead of a prompt; or "
                     "diffusion360: paint the prompt with --weights.")
        ->type_name("FILE|diffusion360");
    verb->add_option("--weights", flags->weights,
                     "Folder of Diffusion360's weights as diffusers saves them: unet/ vae/ text_encoder/ tokenizer/ "
                     "scheduler/; default: those of "
                     "`models pull diffusion360`.")
        ->type_name("DIR");
    verb->add_option("--photo", flags->photo,
                     "With --panorama diffusion360: a photo that is continued all around. How wide it sees: "
                     "--panorama-photo-fov-deg.")
        ->type_name("FILE");
    verb->add_option(
            "--range", flags->range_map,
            "Range map of that picture (.exr, .pfm, .tif, 16-bit .png in millimetres); without it range is estimated.")
        ->type_name("FILE");
    verb->add_option("--more", flags->more,
                     "Further panoramas of the same place with their poses, a list in JSON (docs/depth.md).")
        ->type_name("FILE");
    verb->add_flag("--strict", flags->strict, "Refuse a prompt with words that are not understood.");
    verb->add_option("--assets", flags->assets,
                     "Furniture pack: none, public domain models (default), or all, with credits.txt to keep.")
        ->type_name("none|cc0|all")
        ->check(one_of({"none", "cc0", "all"}));
    verb->add_flag("--force", flags->force, "Throw away what another prompt or seed has left in the folder.");
    add_param_flags(*verb, flags, last_stage);

    return {verb, [flags, last_stage, verb](const Session& session) {
                if (flags->picture.empty() && verb->count("prompt") == 0)
                    throw UsageError("{}: expected a prompt in quotes, or --panorama FILE", verb->get_name());
                SceneRequest request;
                const auto backend = flags->given->find("--panorama-backend");
                const bool painted = flags->picture == "diffusion360" ||
                                     (backend != flags->given->end() && backend->second == "diffusion360");
                if (painted) flags->picture.clear();
                const auto upscale = flags->given->find("--panorama-upscale");
                const bool larger = upscale != flags->given->end() && upscale->second != "none";
                if (larger && !painted && flags->picture.empty())
                    throw UsageError(
                        "--panorama-upscale: expected together with --panorama diffusion360 or --panorama FILE, found "
                        "alone");
                if (!painted && !larger && !flags->weights.empty())
                    throw UsageError(
                        "--weights: expected together with --panorama diffusion360, or --panorama FILE and "
                        "--panorama-upscale, found alone");
                if (!painted && !flags->photo.empty())
                    throw UsageError(
                        "--photo: expected together with --panorama diffusion360, found alone; a 2:1 panorama goes to "
                        "--panorama FILE");
                if (painted && flags->prompt.find_first_not_of(" \t\r\n") == std::string::npos)
                    throw UsageError("{}: expected a prompt in quotes, found none", verb->get_name());
                request.source = {flags->prompt,  flags->picture, flags->range_map,
                                  flags->weights, flags->photo,   flags->more};
                request.quality = flags->quality;
                request.params = params_of_quality(flags->quality);
                if (painted) request.params.panorama.width = 1024;  // what the model was trained for
                if (!flags->photo.empty()) request.params.panorama.diffusion.guidance = kGuidanceAroundPhoto;
                apply_param_flags(request.params, *flags->given);
                if (painted) request.params.panorama.backend = "diffusion360";
                if (flags->strict) request.params.panorama.strict = true;
                if (!flags->assets.empty()) request.params.panorama.assets = flags->assets;
                if (!flags->picture.empty()) request.params.panorama.backend = "image";
                if (flags->picture.empty() && request.params.panorama.backend == "image")
                    throw UsageError("--panorama-backend image: expected --panorama FILE, found none");
                request.last_stage = last_stage;
                request.start_over = flags->force;
                const Run run = session.run(number_from<std::uint64_t>("--seed", flags->seed));
                use_cached_weights(request, run);
                // The prompt is looked at before it becomes a folder's name.
                if (flags->picture.empty() && !painted) read_prompt(flags->prompt, request.params.panorama);
                const std::string title = flags->picture.empty()
                                              ? flags->prompt
                                              : std::filesystem::path(flags->picture).stem().string();
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
                recorded.request.last_stage = name;
                const Run run = session.run(recorded.seed);
                use_cached_weights(recorded.request, run);
                make_and_print(recorded.request, folder, run, session);
            }};
}

}  // namespace fastscene::cli
