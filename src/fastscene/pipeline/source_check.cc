#include "fastscene/pipeline/source_check.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/depth/estimator.h"
#include "fastscene/panorama/diffusion360.h"
#include "fastscene/panorama/more_panoramas.h"
#include "fastscene/panorama/picture_check.h"
#include "fastscene/pipeline/resolve.h"
#include "fastscene/rooms/document.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> words_of(const PromptSpec& prompt, PromptWord::Fate fate) {
    std::vector<std::string> out;
    for (const PromptWord& word : prompt.words_with(fate)) out.push_back(word.words);
    return out;
}

void tell_what_was_understood(const PromptSpec& prompt, const Run& run) {
    const auto unknown = words_of(prompt, PromptWord::Fate::not_understood);
    if (!prompt.names_a_room())
        run.warn(
            "the prompt names nothing that belongs to a room: a plausible room is made instead (see "
            "panorama/prompt.json)");
    if (!prompt.unread.empty())
        run.warn(fmt::format(
            "the prompt is in {}, which is not supported: expected English, German, French, Spanish or Italian",
            prompt.unread));
    if (!unknown.empty()) run.warn(fmt::format("not understood in the prompt: {}", fmt::join(unknown, ", ")));
    for (const PromptWord& word : prompt.words_with(PromptWord::Fate::approximated))
        run.note(word.words + ": " + word.meaning);
}

void tell_doubts(const fs::path& file, const PictureFile& picture, const Run& run) {
    for (const std::string& remark : picture.remarks) run.note(fmt::format("{}: {}", file.string(), remark));
    if (!picture.missing.empty()) return;  // its borders and poles are the fill's
    for (const std::string& doubt : doubts_about_panorama(picture.color()))
        run.warn(fmt::format("{}: {}", file.string(), doubt));
}

void check_further(const MorePanorama& more, const DepthParams& params, SourceFiles& files, const Run& run) {
    tell_doubts(more.color, files.picture(more.color), run);
    if (!more.range.empty()) {
        range_from_file(more.range, files.size(more.color));
        return;
    }
    const float down = more.world_from_pano.translation.y;
    const DepthParams depth = depth_of_further(params, more.world_from_pano.translation);
    make_depth_estimator(depth);  // its weights may be missing, even if the first panorama needs none
    if (params.camera_height_m - down < kLeastCameraHeight)
        run.warn(
            fmt::format("{}: expected a position above the floor, which is {} m below the first camera, found {} m "
                        "below it (y points down)",
                        more.color.string(), params.camera_height_m, down));
    run.note(fmt::format("depth: {}: no range: estimated from the picture, the camera {} m above the floor",
                         more.color.string(), depth.camera_height_m));
}

void check_more(const PictureSource& source, const SceneParams& params, SourceFiles& files, const Run& run) {
    if (const WalkParams walk = walk_of(source, params.depth, params.walk); walk.kind != "ours")
        throw UsageError("--walk {}: expected ours together with --more; the published walks support a single panorama",
                         walk.kind);
    for (const MorePanorama& more : read_more_panoramas(source.more)) check_further(more, params.depth, files, run);
}

// Inputs shared by the checks of all sources.
struct Checking {
    const SceneParams& params;
    const std::string& last_stage;
    SourceFiles& files;
    const Run& run;
};

void check(const PromptSource& source, const Checking& with) {
    std::vector<std::string> complaints;
    tell_what_was_understood(read_prompt(source.prompt, with.params.panorama, &complaints), with.run);
    // The pack is optional: report its absence only if it was requested.
    for (const std::string& complaint : complaints)
        if (complaint.starts_with("no furniture pack") && with.params.panorama.assets != "all")
            with.run.note(complaint);
        else with.run.warn(complaint);
}

void check(const DocumentSource& source, const Checking& with) {
    known_room({source.prompt, source.document}, with.params.panorama, with.run);
}

void check(const PaintingSource& source, const Checking& with) {
    check_diffusion360(source, with.params.panorama, with.run);
    if (with.last_stage != "panorama") make_depth_estimator(with.params.depth);
}

void check(const PictureSource& source, const Checking& with) {
    const auto& [params, last_stage, files, run] = with;
    if (!source.more.empty()) check_more(source, params, files, run);
    if (!source.weights.empty() && !source.range_map.empty())
        throw UsageError("--range: expected together with --panorama FILE as it is, found with --panorama-upscale");
    const PictureFile& picture = files.picture(source.picture);
    tell_doubts(source.picture, picture, run);
    if (!source.weights.empty() && params.panorama.diffusion.upscale != "none")
        check_enlarging({source.prompt, source.weights, {}}, params.panorama,
                        std::min(picture.size().width, params.panorama.width), run);
    if (!source.range_map.empty()) {
        range_from_file(source.range_map, picture.size());
        return;
    }
    make_depth_estimator(params.depth);  // its weights may be missing: better to fail now
    run.note(fmt::format("depth: no --range: estimated from the picture, the camera {} m above the floor",
                         params.depth.camera_height_m));
}

void check(const CaptureSource& source, const Checking&) {
    throw UsageError("{}: expected a prompt or a panorama to make a scene from, found photographs",
                     source.source.string());
}

}  // namespace

void check_source(const SceneSource& source, const SceneParams& params, const std::string& last_stage,
                  SourceFiles& files, const Run& run) {
    depth_backend(source, params.depth);
    std::visit([&](const auto& one) { check(one, Checking{params, last_stage, files, run}); }, source);
}

}  // namespace fastscene
