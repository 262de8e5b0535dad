#include "fastscene/pipeline/stage_depth.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/base/events.h"
#include "fastscene/base/file.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/image/colormap.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/more_panoramas.h"
#include "fastscene/pipeline/resolve.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/walk/agreement.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// Visualization: near is blue, far is red, no range is black. The view through a window does not stretch the scale.
ImageRgb8 picture_of_range(const ImageF& range) {
    std::vector<float> known;
    for (const float r : range.pixels)
        if (r > 0.f && std::isfinite(r)) known.push_back(r);
    if (known.empty()) return ImageRgb8(range.width, range.height);
    const auto at = known.begin() + static_cast<std::ptrdiff_t>(known.size() * 98 / 100);
    std::nth_element(known.begin(), at, known.end());
    return colored(reduced_range(range, 1024), 0.f, *at);
}

// Forwards events about one of several pictures, prefixed with its file name.
class SaidOfPicture : public EventSink {
  public:
    SaidOfPicture(const fs::path& picture, EventSink* sink) : picture_(picture.string()), sink_(sink) {}
    void tell(const Event& event) override {
        if (!sink_) return;
        if (const auto* note = std::get_if<NoteEvent>(&event)) sink_->tell(NoteEvent{picture_ + ": " + note->text});
        else if (const auto* warning = std::get_if<WarningEvent>(&event))
            sink_->tell(WarningEvent{picture_ + ": " + warning->text});
        else sink_->tell(event);
    }

  private:
    std::string picture_;
    EventSink* sink_;
};

// Range of each further panorama: from its own map, or estimated and scaled to agree with the first's. Returns
// assumptions and findings for each.
Json save_more_ranges(const fs::path& list, const DepthParams& params, SourceFiles& files, const RunFolder& folder,
                      const ImageF& first_range, const fs::path& out, const Run& run) {
    make_directories(out);
    const Panorama first{load_color(folder.panorama_color()), first_range, {}, {}};
    const std::vector<Viewpoint> viewpoints = load_viewpoints(folder.more_panoramas() / "poses.json");
    const std::vector<MorePanorama> given = read_more_panoramas(list);
    Json about = Json::array();
    for (std::size_t i = 0; i < viewpoints.size(); ++i) {
        run.check_stop();
        const auto& [name, pose] = viewpoints[i];
        Panorama one{load_color(folder.more_panoramas() / (name + ".png")), {}, {}, pose};
        Json entry{{"name", name}, {"picture", given[i].color.filename().string()}};
        if (!given[i].range.empty()) {
            one.range = range_in_first_orientation(range_from_file(given[i].range, files.size(given[i].color), run),
                                                   given[i].world_from_pano.rotation, one.size());
            entry["backend"] = kMapDepth;
        } else {
            SaidOfPicture said(given[i].color, run.events);
            EstimatedRange found = make_depth_estimator(depth_of_further(params, pose.translation))
                                       ->estimate(one.color, {run.seed, &said, run.stop});
            one.range = std::move(found.range);
            const float scale = scale_to_agree(first, one);
            for (float& r : one.range.pixels) r *= scale;
            entry.update(found.assumptions);
            entry["scaled_to_agree_by"] = scale;
        }
        save_exr(out / (name + ".exr"), one.range);
        about.push_back(std::move(entry));
    }
    return about;
}

}  // namespace

void make_depth(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& params,
                SourceFiles& files, const RunFolder& folder, const fs::path& out, const Run& run) {
    const PictureInfo info = picture_info(folder.panorama_color());
    const EquirectSize size{info.width, info.height};
    const std::string backend = depth_backend(source, params);
    EstimatedRange found{{}, {{"backend", backend}}};
    if (backend == kExactDepth) {
        // The room is laid out again instead of being kept: it is fast, and what a resumed run would do.
        const TracedRoom room = make_unlit_room(origin_of(source), panorama, run);
        found.range = exact_range(room, size, run);
        if (const ImageF mirrored = exact_mirrored_range(room, size, run); !mirrored.empty())
            save_exr(out / folder.depth_mirrored_range().filename(), mirrored);
    } else if (backend == kMapDepth) {
        found.range = reduced_range(range_from_file(range_map_of(source), files.size(picture_of(source)), run),
                                    size.width);
    } else {
        found = make_depth_estimator(params)->estimate(load_color(folder.panorama_color()), run);
    }
    save_exr(out / "range.exr", found.range);
    if (const fs::path list = more_of(source); !list.empty())
        found.assumptions["more"] = save_more_ranges(list, params, files, folder, found.range, out / "more", run);
    save_png(out / "range.png", picture_of_range(found.range));
    write_json(out / "about.json", found.assumptions);
}

}  // namespace fastscene
