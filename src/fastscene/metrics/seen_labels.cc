#include "fastscene/metrics/seen_labels.h"

#include <set>

#include "fastscene/base/check.h"
#include "fastscene/scene/splat_edit.h"

namespace fastscene {
namespace {

// A channel that is full for splats with its label, and empty for all others.
constexpr float kFull = 0.5f / kSh0;

}  // namespace

// Three labels at a time, one per channel of color: their shares are what a picture of them shows.
std::vector<Image<std::uint16_t>> seen_labels(const Splats& splats, const std::vector<std::uint16_t>& labels,
                                              const std::vector<LabelView>& views, const SplatBackend& backend,
                                              const Run& run) {
    FASTSCENE_CHECK(labels.size() == splats.size());
    const std::set<std::uint16_t> unique(labels.begin(), labels.end());
    const std::vector<std::uint16_t> all(unique.begin(), unique.end());
    Splats colored = splats;
    reduce_sh(colored, 0);
    std::vector<Image<std::uint16_t>> seen;
    std::vector<ImageF> share;
    for (const LabelView& view : views) {
        seen.emplace_back(view.camera.width, view.camera.height);
        share.emplace_back(view.camera.width, view.camera.height, 0.f);
    }
    Progress progress(run, "labels", static_cast<std::int64_t>((all.size() + 2) / 3));
    for (std::size_t first = 0; first < all.size(); first += 3) {
        run.check_stop();
        for (std::size_t i = 0; i < labels.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                colored.sh0[i][c] = first + c < all.size() && all[first + c] == labels[i] ? kFull : -kFull;
        const SplatRenderer renderer(colored, backend);
        for (std::size_t v = 0; v < views.size(); ++v) {
            const SplatPicture picture = renderer.picture(views[v].camera, views[v].world_from_camera);
            for (std::size_t p = 0; p < seen[v].size(); ++p)
                for (std::size_t c = 0; c < 3 && first + c < all.size(); ++c) {
                    const std::uint16_t label = all[first + c];
                    const float found = picture.color.pixels[p][c] + (label == 0 ? 1 - picture.alpha.pixels[p] : 0.f);
                    if (found <= share[v].pixels[p]) continue;
                    share[v].pixels[p] = found;
                    seen[v].pixels[p] = label;
                }
        }
        progress.advance();
    }
    return seen;
}

double agreement(const Image<std::uint16_t>& a, const Image<std::uint16_t>& b, const std::vector<int>& of) {
    FASTSCENE_CHECK(a.same_size(b));
    std::size_t equal = 0;
    for (std::size_t p = 0; p < a.size(); ++p) equal += of.at(a.pixels[p]) == of.at(b.pixels[p]);
    return a.size() ? static_cast<double>(equal) / static_cast<double>(a.size()) : 1;
}

}  // namespace fastscene
