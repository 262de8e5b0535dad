// Backend "image": a panorama and range map provided by the user. Both are untrusted input.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/image/orientation.h"
#include "fastscene/io/gpano.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/panorama/picture_file.h"
#include "fastscene/trace/film.h"

namespace fastscene {
namespace {

constexpr int kLeastWidth = 64;        // minimum width: smaller "panoramas" are icons
constexpr int kGreatestWidth = 16384;  // 16384 x 8192 floats of color are 1.6 GB, the maximum for a desktop

// `found`: the file's own size.
void check_panorama_width(const std::filesystem::path& path, int width, EquirectSize found) {
    if (!(width >= kLeastWidth && width <= kGreatestWidth))
        throw Error("{}: expected a panorama {} to {} pixels wide, found {} x {}", path.string(), kLeastWidth,
                    kGreatestWidth, found.width, found.height);
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

// Formats of cameras that hold what the lenses saw, not a panorama.
void refuse_unstitched(const std::filesystem::path& file, const std::string& what) {
    throw Error(
        "{}: expected a stitched panorama, found {}: stitch it first, with the camera's own program (Insta360 "
        "Studio, RICOH THETA, GoPro Player, DJI Studio, Samsung Gear 360) or with Hugin",
        file.string(), what);
}
void check_name(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const char* raw : {".insp", ".insv", ".360", ".osv"})
        if (ending == raw)
            refuse_unstitched(file, fmt::format("two fisheye pictures as the camera saves them ({})", raw));
}

SpherePart part_in(const std::filesystem::path& picture, std::string_view bytes, const PictureInfo& info,
                   const PictureLayout& layout) {
    const EquirectSize size = lies_on_its_side(info.orientation) ? EquirectSize{info.height, info.width}
                                                                 : EquirectSize{info.width, info.height};
    check_name(picture);
    SpherePart part = sphere_part(picture, size, gpano_of(bytes), layout);
    check_panorama_width(picture, part.size().width, size);
    if (size.width > kGreatestWidth || size.height > kGreatestWidth)
        throw Error("{}: expected a picture of at most {} pixels a side, found {} x {}", picture.string(),
                    kGreatestWidth, size.width, size.height);
    return part;
}

void check_content(const std::filesystem::path& file, const ImageRgb8& picture, const SpherePart& part,
                   const PictureLayout& layout) {
    if (part.kind == SpherePart::Kind::cross && layout.projection == "auto" && !has_blank_corners(picture))
        throw Error("{}: expected a panorama twice as wide as high (equirectangular), found {} x {}", file.string(),
                    picture.width, picture.height);
    if (layout.projection == "auto" && part.is_whole() && looks_like_two_fisheyes(picture))
        refuse_unstitched(file, "two fisheye pictures side by side");
}

ImageMask either(const ImageMask& a, const ImageMask& b) {
    if (a.empty() || b.empty()) return a.empty() ? b : a;
    ImageMask out = a;
    for (std::size_t i = 0; i < out.size(); ++i) out.pixels[i] |= b.pixels[i];
    return out;
}

// Alpha below full: nothing was photographed there, or only in part.
ImageMask not_opaque(const ImageMask& alpha) {
    ImageMask out = alpha;
    for (std::uint8_t& v : out.pixels) v = v < 255 ? 255 : 0;
    return out;
}

ImageRgb8 as_picture(const ImageMask& mask) {
    ImageRgb8 out(mask.width, mask.height);
    for (std::size_t i = 0; i < mask.size(); ++i) out.pixels[i] = {mask.pixels[i], mask.pixels[i], mask.pixels[i]};
    return out;
}

// What of the sphere a picture's own gaps (alpha, black borders) leave out, and what its coverage does.
ImageMask missing_of(const ImageMask& gaps, const SpherePart& part, ImageMask uncovered) {
    if (gaps.empty()) return uncovered;
    ImageMask own(part.size().width, part.size().height);
    const WholeSphere<Rgb8> placed = whole_sphere(as_picture(gaps), part);
    for (std::size_t i = 0; i < own.size(); ++i) own.pixels[i] = placed.color.pixels[i].r > 0 ? 255 : 0;
    return either(own, uncovered);
}

void remark_missing(PictureFile& picture) {
    if (picture.missing.empty()) return;
    double missing = 0, all = 0;
    const EquirectSize size{picture.missing.width, picture.missing.height};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            all += pixel_solid_angle(y, size);
            missing += picture.missing.at(x, y) ? pixel_solid_angle(y, size) : 0;
        }
    picture.remarks.push_back(
        fmt::format("{:.0f} % of the sphere is missing and will be invented", std::ceil(100 * missing / all)));
}

}  // namespace

EquirectSize PictureFile::size() const {
    return light.empty() ? EquirectSize{rgb.width, rgb.height} : EquirectSize{light.width, light.height};
}

ImageColor PictureFile::color() const& { return light.empty() ? linear_from_srgb8(rgb) : light; }
ImageColor PictureFile::color() && { return light.empty() ? linear_from_srgb8(rgb) : std::move(light); }

PictureFile picture_file_from(std::string_view bytes, const std::filesystem::path& file, const PictureLayout& layout) {
    const std::string where = file.string();
    const PictureInfo info = picture_info(bytes, where);
    const SpherePart part = part_in(file, bytes, info, layout);  // before decoding: rejects huge pictures cheaply
    PictureFile picture;
    if (info.light) {
        WholeSphere<Vec3f> sphere = whole_sphere(developed(decode_light(bytes, where), file), part);
        picture.light = std::move(sphere.color), picture.missing = std::move(sphere.missing);
        picture.remarks.push_back("floating-point radiance: exposed automatically");
    } else {
        const ImageRgb8 flat = upright(decode_rgb8(bytes, where), info.orientation);
        check_content(file, flat, part, layout);
        const ImageMask alpha = decode_alpha(bytes, where);
        ImageMask gaps = alpha.empty() ? ImageMask{} : upright(not_opaque(alpha), info.orientation);
        if (const ImageMask borders = black_borders(flat); !borders.empty() && !part.is_cube()) {
            gaps = either(gaps, borders);
            picture.remarks.push_back("its black borders count as missing");
        }
        WholeSphere<Rgb8> sphere = whole_sphere(flat, part);
        picture.missing = missing_of(gaps, part, std::move(sphere.missing));
        picture.rgb = std::move(sphere.color);
        if (info.orientation != 1)
            picture.remarks.push_back(fmt::format("EXIF orientation {}: rotated upright", info.orientation));
        const auto clear = std::count_if(alpha.pixels.begin(), alpha.pixels.end(), [](auto a) { return a < 255; });
        if (clear > 0)
            picture.remarks.push_back(
                fmt::format("{:.1f} % of it is transparent and counts as missing",
                            100. * static_cast<double>(clear) / static_cast<double>(alpha.size())));
    }
    picture.remarks.insert(picture.remarks.end(), part.remarks.begin(), part.remarks.end());
    remark_missing(picture);
    return picture;
}

std::vector<std::filesystem::path> cube_face_files(const std::filesystem::path& folder) {
    static const std::vector<std::vector<std::string>> kNames{
        {"px", "posx", "right", "r"},          {"nx", "negx", "left", "l"},  {"py", "posy", "up", "top", "u", "t"},
        {"ny", "negy", "down", "bottom", "d"}, {"pz", "posz", "front", "f"}, {"nz", "negz", "back", "b"}};
    std::vector<std::filesystem::path> files(kNames.size());
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (!has_picture_ending(entry.path())) continue;
        std::string name = entry.path().stem().string();
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        name = name.substr(name.find_last_of("_- .") + 1);
        for (std::size_t f = 0; f < files.size(); ++f)
            if (std::find(kNames[f].begin(), kNames[f].end(), name) != kNames[f].end()) {
                if (!files[f].empty())
                    throw Error("{}: expected one picture of each face of a cube, found {} and {}", folder.string(),
                                files[f].filename().string(), entry.path().filename().string());
                files[f] = entry.path();
            }
    }
    for (std::size_t f = 0; f < files.size(); ++f)
        if (files[f].empty())
            throw Error(
                "{}: expected the six faces of a cube (px nx py ny pz nz, or right left up down front back), "
                "found no {}",
                folder.string(), kNames[f][2]);
    return files;
}

PictureFile picture_file_of_faces(const std::filesystem::path& folder) {
    ImageRgb8 row;
    int number = 0;
    for (const std::filesystem::path& file : cube_face_files(folder)) {
        const PictureInfo info = picture_info(file);
        if (info.width != info.height || info.width < kLeastWidth / 4 || info.width > kGreatestWidth / 4 ||
            (number > 0 && info.width != row.height))
            throw Error("{}: expected square faces of one size, {} to {} pixels, found {} x {}", file.string(),
                        kLeastWidth / 4, kGreatestWidth / 4, info.width, info.height);
        const ImageRgb8 face = load_rgb8(file);
        if (number == 0) row = ImageRgb8(6 * face.width, face.width);
        for (int y = 0; y < face.height; ++y)
            for (int x = 0; x < face.width; ++x) row.at(number * face.width + x, y) = face.at(x, y);
        ++number;
    }
    const SpherePart part = sphere_part(folder, {row.width, row.height}, {}, {.projection = "cube"});
    PictureFile picture;
    picture.rgb = whole_sphere(row, part).color;
    picture.remarks = part.remarks;
    return picture;
}

ImageMask reduced_missing(const ImageMask& missing, int width) {
    if (missing.empty() || width >= missing.width) return missing;
    ImageMask out(width, width / 2);
    for (int y = 0; y < missing.height; ++y)
        for (int x = 0; x < missing.width; ++x)
            if (missing.at(x, y))
                out.at(static_cast<int>(std::int64_t{x} * out.width / missing.width),
                       static_cast<int>(std::int64_t{y} * out.height / missing.height)) = 255;
    return out;
}

EquirectSize panorama_size(const std::filesystem::path& picture) {
    const std::string bytes = read_file(picture);
    return part_in(picture, bytes, picture_info(bytes, picture.string()), {}).size();
}

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
