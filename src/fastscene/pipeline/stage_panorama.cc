#include "fastscene/pipeline/stage_panorama.h"

#include <memory>
#include <optional>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/io/gpano_mark.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/more_panoramas.h"
#include "fastscene/pipeline/earlier_run.h"
#include "fastscene/pipeline/stage_code.h"
#include "fastscene/pipeline/run_files.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// The user's picture, at most `width` wide, with its missing parts filled.
struct Completed {
    ImageColor color;
    ImageMask missing;
};
Completed completed(PictureFile picture, int width, const Filler& filler, const Run& run) {
    Completed out;
    out.missing = reduced_missing(picture.missing, width);
    Panorama panorama;
    panorama.color = std::move(picture).color();
    out.color = reduced_panorama(panorama, width).color;
    if (!out.missing.empty())
        out.color = with_missing_filled(
            out.color, out.missing, *make_inpainter(filler.inpainter, filler.weights, filler.device, filler.trusted),
            run);
    return out;
}

void save_more_panoramas(const fs::path& list, EquirectSize size, const Filler& filler, SourceFiles& files,
                         const fs::path& out, const Run& run) {
    make_directories(out);
    std::vector<Viewpoint> viewpoints;
    for (const MorePanorama& more : read_more_panoramas(list)) {
        run.check_stop();
        Panorama one;
        one.color = completed(files.take(more.color), size.width, filler, run).color;
        one.world_from_pano = more.world_from_pano;
        one = in_first_orientation(one, size);
        viewpoints.push_back({name_of_viewpoint(viewpoints.size() + 1), one.world_from_pano});
        save_png(out / (viewpoints.back().name + ".png"), srgb8_from_linear(one.color));
    }
    save_viewpoints(out / "poses.json", viewpoints);
}

// A source's panorama with its accompanying data.
struct Made {
    ImageColor color;
    Json prompt, room = {{"objects", Json::array()}};
    std::shared_ptr<const TracedRoom> traced = {};
    ImageMask missing = {};  // of a partial panorama
    Json about = {};
};
struct Making {
    const PanoramaParams& params;
    const Filler& filler;
    SourceFiles& files;
    fs::path run_folder;
    const Run& run;
    const EarlierRun* earlier;
    PaintingMemory memory() const { return {RunFolder{run_folder}.painting(), code_version("panorama")}; }
};

Made made_from_room(const RoomOrigin& origin, const Making& with) {
    std::optional<EarlierRoom> earlier;
    if (with.earlier) earlier = {with.earlier->room, load_color(with.earlier->folder.panorama_color())};
    RoomPanorama made = panorama_of_room(origin, with.params, with.run, earlier ? &*earlier : nullptr);
    Made out{std::move(made.panorama.color), to_json(made.prompt), std::move(made.file), std::move(made.room)};
    if (earlier) {
        out.about = {
            {"edits", with.earlier->edits}, {"kept_light", made.kept_light}, {"kept_pixels", made.kept_pixels}};
        if (made.kept_light > 0)
            with.run.note(fmt::format("panorama: keeps {:.0f} % of the light and {:.0f} % of the pixels of {}",
                                      100 * made.kept_light, 100 * made.kept_pixels,
                                      with.earlier->folder.root.string()));
        else with.run.note("panorama: rendered from scratch: the edit changes the light of the whole room");
    }
    return out;
}

Made made_from(const PromptSource& source, const Making& with) { return made_from_room({source.prompt, {}}, with); }
Made made_from(const DocumentSource& source, const Making& with) {
    return made_from_room({source.prompt, source.document}, with);
}

Made made_from(const PaintingSource& source, const Making& with) {
    const fs::path look = with.run_folder / "painting.png";  // preview during generation
    const auto shown = [&](const ImageRgb8& preview) {
        if (!fs::exists(look)) with.run.note(fmt::format("a first look: {}", look.string()));
        save_png(look, preview);
    };
    Made made;
    made.color = linear_from_srgb8(panorama_by_diffusion360(source, with.params, with.run, shown, with.memory()));
    fs::remove(look);
    made.prompt = {{"text", source.prompt}, {"made_by", "diffusion360"}};
    if (!source.photo.empty()) made.prompt["photo"] = source.photo.filename().string();
    return made;
}

Made made_from(const PictureSource& source, const Making& with) {
    Completed picture = completed(with.files.take(source.picture), with.params.width, with.filler, with.run);
    Made made;
    made.color = std::move(picture.color), made.missing = std::move(picture.missing);
    if (!source.weights.empty() && with.params.diffusion.upscale != "none")
        made.color = linear_from_srgb8(enlarged_by_diffusion360(
            srgb8_from_linear(made.color), {source.prompt, source.weights, {}}, with.params, with.run, with.memory()));
    made.prompt = {{"text", source.prompt}, {"picture", source.picture.filename().string()}};
    return made;
}

Made made_from(const CaptureSource&, const Making&) {
    FASTSCENE_CHECK(!"photographs have no panorama");
    return {};
}

}  // namespace

std::shared_ptr<const TracedRoom> make_panorama(const SceneSource& source, const PanoramaParams& params,
                                                const Filler& filler, SourceFiles& files, const EarlierRun* earlier,
                                                const fs::path& out, const Run& run) {
    const Making with{params, filler, files, out.parent_path(), run, earlier};
    Made made = std::visit([&](const auto& one) { return made_from(one, with); }, source);
    save_panorama(out / "color.png", srgb8_from_linear(made.color));
    if (!made.missing.empty()) save_png(out / "missing.png", made.missing);
    if (const fs::path list = more_of(source); !list.empty())
        save_more_panoramas(list, {made.color.width, made.color.height}, filler, files, out / "more", run);
    write_json(out / "prompt.json", made.prompt);
    write_json(out / "room.json", made.room);
    if (made.traced) write_file(out / RunFolder{}.room_light().filename(), made.traced->light());
    if (made.traced && !made.traced->device().empty()) made.about["device"] = made.traced->device();
    if (!made.about.empty()) write_json(out / kAboutName, made.about);
    return made.traced;
}

}  // namespace fastscene
