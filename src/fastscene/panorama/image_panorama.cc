// Backend "image": a panorama and range map provided by the user. Both are untrusted input.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/image/orientation.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/panorama/picture_file.h"
#include "fastscene/trace/film.h"

namespace fastscene {
namespace {

constexpr int kLeastWidth = 64;        // minimum width: smaller "panoramas" are icons
constexpr int kGreatestWidth = 16384;  // 16384 x 8192 floats of color are 1.6 GB, the maximum for a desktop

void check_panorama_size(const std::filesystem::path& path, EquirectSize size) {
    if (size.width != 2 * size.height)
        throw Error("{}: expected a panorama twice as wide as high (equirectangular), found {} x {}", path.string(),
                    size.width, size.height);
    if (!(size.width >= kLeastWidth && size.width <= kGreatestWidth))
        throw Error("{}: expected a panorama {} to {} pixels wide, found {} x {}", path.string(), kLeastWidth,
                    kGreatestWidth, size.width, size.height);
}

// Tone maps radiance of unknown scale: walls bright, windows below white. White balance is kept, as the camera has
// already done it.
ImageColor developed(ImageColor light, const std::filesystem::path& path) {
    bool any = false;
    for (Vec3f& c : light.pixels) {
        for (std::size_t a = 0; a < 3; ++a) c[a] = c[a] > 0.f ? std::min(c[a], 1e6f) : 0.f;  // NaN becomes 0
        any = any || luminance(c) > 0.f;
    }
    if (!any) throw Error("{}: expected light above zero, found none in the whole picture", path.string());
    Look look = automatic_look({}, {}, light);
    look.white = {1, 1, 1};
    look.contrast = look.saturation = 1;
    for (Vec3f& c : light.pixels) c = develop(look, c);
    return light;
}

}  // namespace

namespace {

EquirectSize size_in(const std::filesystem::path& picture, const PictureInfo& info) {
    const EquirectSize size = lies_on_its_side(info.orientation) ? EquirectSize{info.height, info.width}
                                                                 : EquirectSize{info.width, info.height};
    check_panorama_size(picture, size);
    return size;
}

std::vector<std::string> remarks_on(const PictureInfo& info, const ImageMask& alpha) {
    if (info.light) return {"light in floats, not a finished picture: exposed automatically"};
    std::vector<std::string> remarks;
    if (info.orientation != 1) remarks.push_back(fmt::format("EXIF orientation {}: turned upright", info.orientation));
    const auto clear = std::count_if(alpha.pixels.begin(), alpha.pixels.end(), [](std::uint8_t a) { return a < 128; });
    if (clear > 0)
        remarks.push_back(fmt::format("{:.1f} % of it can be seen through: black was put behind",
                                      100. * static_cast<double>(clear) / static_cast<double>(alpha.size())));
    return remarks;
}

}  // namespace

EquirectSize PictureFile::size() const {
    return light.empty() ? EquirectSize{rgb.width, rgb.height} : EquirectSize{light.width, light.height};
}

ImageColor PictureFile::color() const& { return light.empty() ? linear_from_srgb8(rgb) : light; }
ImageColor PictureFile::color() && { return light.empty() ? linear_from_srgb8(rgb) : std::move(light); }

PictureFile picture_file_from(std::string_view bytes, const std::filesystem::path& file) {
    const std::string where = file.string();
    const PictureInfo info = picture_info(bytes, where);
    size_in(file, info);  // before decoding: rejects huge pictures cheaply
    PictureFile picture;
    picture.remarks = remarks_on(info, info.light ? ImageMask{} : decode_alpha(bytes, where));
    if (info.light) picture.light = developed(decode_light(bytes, where), file);
    else picture.rgb = upright(decode_rgb8(bytes, where), info.orientation);
    check_panorama_size(file, picture.size());
    return picture;
}

EquirectSize panorama_size(const std::filesystem::path& picture) { return size_in(picture, picture_info(picture)); }

Panorama panorama_from_image(const std::filesystem::path& picture) {
    Panorama panorama;
    panorama.color = picture_file_from(read_file(picture), picture).color();
    return panorama;
}

Panorama reduced_panorama(const Panorama& panorama, int width) {
    const int w = panorama.color.width, h = panorama.color.height;
    if (width >= w) return panorama;
    FASTSCENE_CHECK(width > 0 && width % 2 == 0);
    // Area averaging: first along rows, then along columns.
    const auto shrink = [](int from, int to, int i, auto&& add) {
        const double scale = static_cast<double>(from) / to, begin = i * scale, end = (i + 1) * scale;
        for (int x = static_cast<int>(begin); x < from && x < end; ++x) {
            const double share = (std::min<double>(end, x + 1) - std::max<double>(begin, x)) / scale;
            add(x, static_cast<float>(share));
        }
    };
    Panorama out = panorama;
    const int height = width / 2;
    ImageColor narrow(width, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < width; ++x)
            shrink(w, width, x, [&](int from, float share) { narrow.at(x, y) += panorama.color.at(from, y) * share; });
    out.color = ImageColor(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            shrink(h, height, y, [&](int from, float share) { out.color.at(x, y) += narrow.at(x, from) * share; });
    if (!panorama.range.empty()) out.range = reduced_range(panorama.range, width);
    out.known = {};
    return out;
}

ImageF reduced_range(const ImageF& range, int width) {
    if (width >= range.width) return range;
    FASTSCENE_CHECK(width > 0 && width % 2 == 0);
    ImageF out(width, width / 2);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.at(x, y) = range.at((2 * x + 1) * range.width / (2 * out.width),
                                    (2 * y + 1) * range.height / (2 * out.height));
    return out;
}

}  // namespace fastscene
