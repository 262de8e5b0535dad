// Any inpainting network exported as TorchScript: picture and mask in, picture out, as LaMa's big-lama.pt does it: RGB
// in 0..1, a mask of 1 in holes and 0 elsewhere, sides that are multiples of 8.
#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/image/color.h"
#include "fastscene/inpaint/inpaint.h"
#include "fastscene/nn/scripted.h"

namespace fastscene::inpainters {
namespace {

constexpr int kUsualMultiple = 8;
constexpr double kMostPixels = 1.5e6;  // at a time: beyond, the networks of today blur, and take 10 GB

int multiple_beside(const std::filesystem::path& file) {
    const Json json = beside_network(file);
    const Json value = json.value("multiple", Json(kUsualMultiple));
    if (!value.is_number_integer() || value.get<int>() < 1 || value.get<int>() > 512)
        throw Error("{}: the JSON beside it: expected 1 to 512 as \"multiple\" of the sides, found {}", file.string(),
                    value.dump());
    return value.get<int>();
}

// The index in 0..size-1 that a mirror at the last one shows: edges are repeated once.
int mirrored(int i, int size) {
    const int period = 2 * size, r = i % period;
    return r < size ? r : period - 1 - r;
}

class TorchscriptInpainter final : public Inpainter {
  public:
    TorchscriptInpainter(ScriptedNetwork network, int multiple) : network_(std::move(network)), multiple_(multiple) {}
    bool invents() const override { return true; }

    ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run& run) const override {
        FASTSCENE_CHECK(color.same_size(hole));
        if (std::none_of(hole.pixels.begin(), hole.pixels.end(), [](std::uint8_t v) { return v != 0; })) return color;
        const double pixels = static_cast<double>(color.width) * color.height;
        const int smaller = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostPixels))));
        const int w = (color.width + smaller - 1) / smaller, h = (color.height + smaller - 1) / smaller;
        const PicturePlanes painted = paint(color, hole, smaller, w, h, run);
        ImageColor out = color;
        for (int y = 0; y < out.height; ++y)
            for (int x = 0; x < out.width; ++x)
                if (hole.at(x, y))
                    out.at(x, y) = color_at(painted, (x + 0.5f) / static_cast<float>(smaller) - 0.5f,
                                            (y + 0.5f) / static_cast<float>(smaller) - 0.5f, w, h);
        return out;
    }

  private:
    // Runs the network on w x h pixels, each the mean of smaller x smaller; padded at the right and the bottom.
    PicturePlanes paint(const ImageColor& color, const ImageMask& hole, int smaller, int w, int h,
                        const Run& run) const {
        const auto padded = [&](int side) { return (side + multiple_ - 1) / multiple_ * multiple_; };
        PicturePlanes picture(3, padded(w), padded(h)), mask(1, picture.width, picture.height);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const int px = mirrored(x, w) * smaller, py = mirrored(y, h) * smaller;
                Vec3f sum;
                int known = 0;
                for (int j = py; j < std::min(py + smaller, color.height); ++j)
                    for (int i = px; i < std::min(px + smaller, color.width); ++i) {
                        if (hole.at(i, j)) mask.at(0, x, y) = 1;
                        else sum += srgb_from_linear(color.at(i, j)), ++known;
                    }
                for (int c = 0; c < 3 && known > 0; ++c)
                    picture.at(c, x, y) = std::clamp(sum[static_cast<std::size_t>(c)] / static_cast<float>(known), 0.f,
                                                     1.f);
            }
        PicturePlanes painted = network_.run({std::move(picture), std::move(mask)}, "", run);
        if (painted.count != 3 || painted.width != padded(w) || painted.height != padded(h))
            throw Error("{}: expected 3 planes of {} x {}, found {} of {} x {}", network_.file().string(), padded(w),
                        padded(h), painted.count, painted.width, painted.height);
        return painted;
    }
    static Vec3f color_at(const PicturePlanes& painted, float x, float y, int w, int h) {
        x = std::clamp(x, 0.f, static_cast<float>(w - 1)), y = std::clamp(y, 0.f, static_cast<float>(h - 1));
        const int x0 = static_cast<int>(x), y0 = static_cast<int>(y), x1 = std::min(x0 + 1, w - 1),
                  y1 = std::min(y0 + 1, h - 1);
        const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
        Vec3f out;
        for (int c = 0; c < 3; ++c) {
            const float top = painted.at(c, x0, y0) * (1 - fx) + painted.at(c, x1, y0) * fx,
                        low = painted.at(c, x0, y1) * (1 - fx) + painted.at(c, x1, y1) * fx;
            const float v = top * (1 - fy) + low * fy;
            out[static_cast<std::size_t>(c)] = linear_from_srgb(std::isfinite(v) ? std::clamp(v, 0.f, 1.f) : 0.5f);
        }
        return out;
    }

    ScriptedNetwork network_;
    int multiple_;
};

std::unique_ptr<Inpainter> make_torchscript(const std::filesystem::path& weights, const std::string& device,
                                            const std::vector<std::string>& trusted) {
    if (weights.empty())
        throw UsageError(
            "--walk-inpainter torchscript: expected --walk-inpaint-weights FILE, such as LaMa's "
            "big-lama.pt, found none");
    return std::make_unique<TorchscriptInpainter>(ScriptedNetwork::load(weights, trusted, {device, "--walk-device"}),
                                                  multiple_beside(weights));
}

}  // namespace

InpaintBackend torchscript() {
    return {
        .name = "torchscript",
        .about = "any network exported as TorchScript, such as LaMa's big-lama.pt (--walk-inpaint-weights, --trust)",
        .runs_code = true,
        .make = make_torchscript};
}

}  // namespace fastscene::inpainters
