// splat: a stage of a run, and a verb of its own for photographs with cameras.
#include "fastscene/cli/request.h"
#include "fastscene/pipeline/capture_run.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct CaptureFlags {
    std::string colmap, nerfstudio, images, masks, out, seed = "0";
    bool force = false;
    std::shared_ptr<Given> given = std::make_shared<Given>();
};

// How large pictures may be grows with the preset.
int max_size_of(const std::string& quality) { return quality == "draft" ? 640 : quality == "standard" ? 1024 : 1600; }

void train(const CaptureRequest& request, const RunFolder& folder, std::uint64_t seed, const Session& session) {
    const Run run = session.run(seed);
    const Json report = train_capture(request, folder, run);
    session.print(folder.root.string(), report);
    if (fs::exists(folder.viewer_html())) run.note(fmt::format("open {} in a browser to walk through it", folder.viewer_html().string()));
}

CaptureRequest request_of(const CaptureFlags& flags, const RequestFlags& stage) {
    CaptureRequest request;
    request.kind = flags.nerfstudio.empty() ? "colmap" : "nerfstudio";
    request.source = flags.nerfstudio.empty() ? flags.colmap : flags.nerfstudio;
    request.folders = {flags.images, flags.masks, 1};
    request.quality = stage.quality;
    request.splat = params_of_quality(stage.quality).splat;
    request.photos.max_size = max_size_of(stage.quality);
    request.start_over = flags.force;
    return request;
}

}  // namespace

Verb add_splat(CLI::App& app) {
    auto stage = std::make_shared<RequestFlags>();
    auto flags = std::make_shared<CaptureFlags>();
    Verb verb = add_stage_verb(app, "splat", "Views -> 3D Gaussians, and a page to walk through them; also of photographs with cameras.", stage);
    verb.app->get_option("folder")->required(false);
    const std::string group = "Photographs with cameras (instead of a run's folder)";
    verb.app->add_option("--colmap", flags->colmap, "Folder with images/ and COLMAP's model (text or binary) in sparse/0 or sparse.")
        ->type_name("DIR")
        ->group(group);
    verb.app->add_option("--nerfstudio", flags->nerfstudio, "transforms.json of nerfstudio or NeRF, or the folder it lies in.")
        ->type_name("FILE")
        ->group(group);
    verb.app->add_option("-o,--out", flags->out, "Folder to make; default: out/ and the name of the source.")->type_name("DIR")->group(group);
    verb.app->add_option("--images", flags->images, "Folder of the pictures; default: images beside the model.")->type_name("DIR")->group(group);
    verb.app->add_option("--masks", flags->masks, "Folder of masks, white = counts; default: masks beside the model, where it is.")
        ->type_name("DIR")
        ->group(group);
    verb.app->add_option("--seed", flags->seed, "Same seed, same splats, byte for byte.")->type_name("N")->default_str("0")->group(group);
    verb.app->add_flag("--force", flags->force, "Throw away what another run has left in the folder.")->group(group);
    PhotosParams photos;
    photos.max_size = max_size_of("standard");
    add_fields(*verb.app, "", photos, flags->given, group);

    const auto continue_run = verb.act;
    verb.act = [stage, flags, continue_run](const Session& session) {
        const int sources = !stage->out.empty() + !flags->colmap.empty() + !flags->nerfstudio.empty();
        if (sources != 1) throw UsageError("splat: expected one of the folder of a run, --colmap DIR and --nerfstudio FILE, found {}", sources);
        if (!stage->out.empty()) {
            const RunFolder folder{stage->out};
            auto recorded = recorded_capture(folder);
            if (!recorded) return continue_run(session);
            if (stage->has_quality) recorded->request.splat = params_of_quality(stage->quality).splat;
            apply_fields("splat", recorded->request.splat, *stage->given);
            apply_fields("", recorded->request.photos, *flags->given);
            return train(recorded->request, folder, recorded->seed, session);
        }
        CaptureRequest request = request_of(*flags, *stage);
        apply_fields("splat", request.splat, *stage->given);
        apply_fields("", request.photos, *flags->given);
        fs::path source = fs::absolute(request.source).lexically_normal();
        if (source.filename().empty()) source = source.parent_path();
        const std::string name = source.extension() == ".json" ? source.parent_path().filename().string() : source.filename().string();
        const RunFolder folder{flags->out.empty() ? fs::path("out") / slug_of(name) : fs::path(flags->out)};
        train(request, folder, number_from<std::uint64_t>("--seed", flags->seed), session);
    };
    return verb;
}

}  // namespace fastscene::cli
