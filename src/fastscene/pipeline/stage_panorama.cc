#include "fastscene/pipeline/stage_panorama.h"

#include <memory>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/more_panoramas.h"
#include "fastscene/pipeline/stage_code.h"
#include "fastscene/pipeline/run_files.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

void save_more_panoramas(const fs::path& list, EquirectSize size, const fs::path& out, const Run& run) {
    make_directories(out);
    std::vector<Viewpoint> viewpoints;
    for (const MorePanorama& more : read_more_panoramas(list)) {
        run.check_stop();
        Panorama one = panorama_from_image(more.color);
        one.world_from_pano = more.world_from_pano;
        one = in_first_orientation(one, size);
        viewpoints.push_back({name_of_viewpoint(viewpoints.size() + 1), one.world_from_pano});
        save_png(out / (viewpoints.back().name + ".png"), srgb8_from_linear(one.color));
    }
    save_viewpoints(out / "poses.json", viewpoints);
}

}  // namespace

std::shared_ptr<const TracedRoom> make_panorama(const SceneSource& source, const PanoramaParams& params,
                                                const fs::path& out, const Run& run) {
    std::shared_ptr<const TracedRoom> traced;
    Json prompt, room;
    Panorama panorama;
    const PaintingSource painting{source.prompt, source.weights, source.photo};
    const PaintingMemory memory{RunFolder{out.parent_path()}.painting(), code_version("panorama")};
    if (source.is_painted()) {
        const fs::path look = out.parent_path() / "painting.png";  // people may look while it is painted
        const auto shown = [&](const ImageRgb8& preview) {
            if (!fs::exists(look)) run.note(fmt::format("a first look: {}", look.string()));
            save_png(look, preview);
        };
        panorama.color = linear_from_srgb8(panorama_by_diffusion360(painting, params, run, shown, memory));
        fs::remove(look);
        prompt = {{"text", source.prompt}, {"made_by", "diffusion360"}};
        if (!source.photo.empty()) prompt["photo"] = source.photo.filename().string();
        room = {{"objects", Json::array()}};
    } else if (source.picture.empty()) {
        RoomPanorama made = panorama_from_prompt(source.prompt, params, run);
        panorama = std::move(made.panorama);
        prompt = to_json(made.prompt);
        room = room_json(made.room->room(), made.object_of_pixel);
        traced = std::move(made.room);
    } else {
        panorama = reduced_panorama(panorama_from_image(source.picture), params.width);
        if (!source.weights.empty() && params.diffusion.upscale != "none")
            panorama.color = linear_from_srgb8(
                enlarged_by_diffusion360(srgb8_from_linear(panorama.color), painting, params, run, memory));
        prompt = {{"text", source.prompt}, {"picture", source.picture.filename().string()}};
        room = {{"objects", Json::array()}};
    }
    save_png(out / "color.png", srgb8_from_linear(panorama.color));
    if (!source.more.empty()) save_more_panoramas(source.more, panorama.size(), out / "more", run);
    write_json(out / "prompt.json", prompt);
    write_json(out / "room.json", room);
    return traced;
}

}  // namespace fastscene
