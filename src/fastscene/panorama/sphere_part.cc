#include "fastscene/panorama/sphere_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/parallel.h"
#include "fastscene/geometry/cubemap.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr double kHalfTurn = std::numbers::pi, kOneDegree = kHalfTurn / 180;
constexpr int kMostOff_px = 4;       // of the width from twice the height: stitchers round
constexpr double kSameShape = 0.01;  // ratio of sides: a picture scaled after its XMP was written
constexpr double kLeastTilt_deg = 0.05;

std::string shape(EquirectSize s) { return fmt::format("{} x {}", s.width, s.height); }

// A crop that the XMP describes, or why it cannot be used.
std::string what_is_wrong(const GPano& g, EquirectSize size) {
    if (!(*g.full_width >= 1 && *g.full_height >= 1 && *g.cropped_width >= 1 && *g.cropped_height >= 1))
        return "its sizes are not positive";
    if (*g.cropped_width > *g.full_width || *g.cropped_height > *g.full_height)
        return fmt::format("the cropped area ({} x {}) is larger than the whole panorama ({} x {})", *g.cropped_width,
                           *g.cropped_height, *g.full_width, *g.full_height);
    if (*g.top < -0.5 || *g.top + *g.cropped_height > *g.full_height + 0.5)
        return "the cropped area extends beyond a pole";
    const double is = static_cast<double>(size.width) / size.height, says = *g.cropped_width / *g.cropped_height;
    if (std::fabs(is / says - 1) > kSameShape)
        return fmt::format("it describes a picture of {} x {}, this one is {}", *g.cropped_width, *g.cropped_height,
                           shape(size));
    return "";
}

void place_crop(const GPano& g, SpherePart& part) {
    part.left = (*g.left / *g.full_width - 0.5) * 2 * kHalfTurn;
    part.across = *g.cropped_width / *g.full_width * 2 * kHalfTurn;
    part.top = (0.5 - *g.top / *g.full_height) * kHalfTurn;
    part.down = *g.cropped_height / *g.full_height * kHalfTurn;
}

void place_cylinder(double across, double vertical, SpherePart& part) {
    part.kind = SpherePart::Kind::cylinder;
    part.across = across, part.left = -across / 2;
    part.horizon_px = part.height / 2.0;
    part.focal_px = vertical > 0 ? part.height / (2 * std::tan(vertical / 2)) : part.width / across;
}

void place_by_angles(double across, double vertical, SpherePart& part) {
    part.across = across, part.left = -across / 2;
    part.down = vertical > 0 ? vertical : std::min(kHalfTurn, across * part.height / part.width);
    part.top = part.down / 2;
}

std::string covered(const SpherePart& part) {
    const double vertical = part.kind == SpherePart::Kind::cylinder ? 2 * std::atan(part.height / 2.0 / part.focal_px)
                                                                    : part.down;
    return fmt::format("{:.0f} x {:.0f} degrees", part.across / kOneDegree, vertical / kOneDegree);
}

bool place_cube(const std::filesystem::path& file, bool asked, SpherePart& part) {
    const int w = part.width, h = part.height;
    using Kind = SpherePart::Kind;
    if (w == 6 * h) part.kind = Kind::row;
    else if (6 * w == h) part.kind = Kind::column;
    else if (3 * w == 4 * h) part.kind = Kind::cross;
    else if (asked)
        throw Error("{}: expected the faces of a cube in a row (6:1), in a column (1:6) or as a cross (4:3), found {}",
                    file.string(), shape({w, h}));
    else return false;
    return true;
}

}  // namespace

bool SpherePart::is_whole() const {
    return kind == Kind::sphere && width == 2 * height && across > 2 * kHalfTurn - 1e-9 && down > kHalfTurn - 1e-9 &&
           left < -kHalfTurn + 1e-9 && level_from_picture == Mat3d{};
}

EquirectSize SpherePart::size() const {
    double w = 0;
    switch (kind) {
        case Kind::row: w = 4 * height; break;
        case Kind::column: w = 4 * width; break;
        case Kind::cross: w = width; break;
        default: w = width * 2 * kHalfTurn / across;
    }
    // A whole sphere that is not quite 2:1 loses a column or row instead of gaining one.
    if (kind == Kind::sphere && across > 2 * kHalfTurn - 1e-9 && down > kHalfTurn - 1e-9)
        w = std::min(width, 2 * height) / 2 * 2;
    constexpr double kGreatest = 16384;  // the largest panorama that is read
    const int half = static_cast<int>(std::lround(std::min(w, kGreatest) / 2));
    return {2 * half, half};
}

SpherePart sphere_part(const std::filesystem::path& file, EquirectSize size, const std::optional<GPano>& gpano,
                       const PictureLayout& layout) {
    SpherePart part;
    part.width = size.width, part.height = size.height;
    const double across = layout.fov_deg > 0 ? layout.fov_deg * kOneDegree : 2 * kHalfTurn,
                 vertical = layout.vertical_fov_deg * kOneDegree;
    const bool angles = layout.fov_deg > 0 || layout.vertical_fov_deg > 0;
    std::string wrong;
    const bool crop = gpano && gpano->has_crop() && (wrong = what_is_wrong(*gpano, size)).empty();
    if (!wrong.empty()) part.remarks.push_back(fmt::format("its XMP is ignored: {}", wrong));
    const bool tall_cylinder = gpano && gpano->projection == "cylindrical";
    if (layout.projection == "cube") {
        place_cube(file, true, part);
    } else if (layout.projection == "cylinder" || (layout.projection == "auto" && tall_cylinder)) {
        place_cylinder(!angles && crop ? *gpano->cropped_width / *gpano->full_width * 2 * kHalfTurn : across, vertical,
                       part);
        part.remarks.push_back(fmt::format("a cylinder of {}", covered(part)));
    } else if (angles) {
        place_by_angles(across, vertical, part);
        part.remarks.push_back(fmt::format("covers {}", covered(part)));
    } else if (crop) {
        place_crop(*gpano, part);
        if (part.across < 2 * kHalfTurn - 1e-9 || part.down < kHalfTurn - 1e-9)
            part.remarks.push_back(fmt::format("covers {}, as its XMP says", covered(part)));
    } else if (std::abs(size.width - 2 * size.height) <= kMostOff_px) {
        place_by_angles(2 * kHalfTurn, kHalfTurn, part);
        if (size.width != 2 * size.height)
            part.remarks.push_back(fmt::format("{} is almost 2:1: resampled to {}", shape(size), shape(part.size())));
    } else if (layout.projection == "sphere" || !place_cube(file, false, part)) {
        throw Error(
            "{}: expected a panorama twice as wide as high (equirectangular), found {}; if it is a part of one, "
            "say how much it covers (--panorama-fov-deg, --panorama-vertical-fov-deg), or what else it is "
            "(--panorama-projection)",
            file.string(), shape(size));
    }
    if (part.is_cube()) part.remarks.push_back("the six faces of a cube");
    if (gpano && !layout.keep_tilt && !part.is_cube() &&
        (std::fabs(gpano->pitch_deg) > kLeastTilt_deg || std::fabs(gpano->roll_deg) > kLeastTilt_deg)) {
        part.level_from_picture = rotation_about(Vec3d{1, 0, 0}, gpano->pitch_deg * kOneDegree) *
                                  rotation_about(Vec3d{0, 0, 1}, gpano->roll_deg * kOneDegree);
        part.remarks.push_back(
            fmt::format("leveled by its XMP: pitch {:.1f}, roll {:.1f} degrees", gpano->pitch_deg, gpano->roll_deg));
    }
    return part;
}

namespace {

Vec3f values_of(Rgb8 p) { return {static_cast<float>(p.r), static_cast<float>(p.g), static_cast<float>(p.b)}; }
Vec3f values_of(Vec3f p) { return p; }
void put(Rgb8& to, Vec3f v) {
    const auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.f, 255.f))); };
    to = {byte(v.x), byte(v.y), byte(v.z)};
}
void put(Vec3f& to, Vec3f v) { to = v; }

// The point of the picture that shows a direction, in its own frame; none if it lies outside.
std::optional<Vec2d> picture_point(const SpherePart& part, Vec3d d) {
    const double lon = std::atan2(d.x, d.z), flat = std::hypot(d.x, d.z), lat = std::atan2(-d.y, flat);
    double along = lon - part.left;
    along -= std::floor(along / (2 * kHalfTurn)) * 2 * kHalfTurn;
    if (along > part.across) return {};
    const double y = part.kind == SpherePart::Kind::cylinder
                         ? part.horizon_px + part.focal_px * d.y / std::max(flat, 1e-12)
                         : (part.top - lat) / part.down * part.height;
    if (!(y >= 0 && y <= part.height)) return {};
    return Vec2d{along / part.across * part.width, y};
}

template <class Pixel>
Vec3f sampled(const Image<Pixel>& picture, Vec2d at, bool wraps) {
    const double x = at.x - 0.5, y = at.y - 0.5;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    const auto pixel = [&](int i, int j) {
        const int column = wraps ? wrap_column(i, picture.width) : std::clamp(i, 0, picture.width - 1);
        return values_of(picture.at(column, std::clamp(j, 0, picture.height - 1)));
    };
    return lerp(lerp(pixel(x0, y0), pixel(x0 + 1, y0), fx), lerp(pixel(x0, y0 + 1), pixel(x0 + 1, y0 + 1), fx), fy);
}

template <class Pixel>
WholeSphere<Pixel> resampled(const Image<Pixel>& picture, const SpherePart& part) {
    const EquirectSize size = part.size();
    WholeSphere<Pixel> out{Image<Pixel>(size.width, size.height), ImageMask(size.width, size.height)};
    const Mat3d picture_from_level = transpose(part.level_from_picture);
    const bool wraps = part.across > 2 * kHalfTurn - 1e-9;
    parallel_for(size.height, 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Vec3d d = picture_from_level * direction_at(Vec2d{x + 0.5, y + 0.5}, size);
                if (const auto at = picture_point(part, d)) put(out.color.at(x, y), sampled(picture, *at, wraps));
                else out.missing.at(x, y) = 255;
            }
    });
    if (std::none_of(out.missing.pixels.begin(), out.missing.pixels.end(), [](std::uint8_t m) { return m != 0; }))
        out.missing = {};
    return out;
}

// The cells of the faces in units of a face: front, right, back, left, up, down (kCubeFaces).
std::array<std::pair<int, int>, 6> cells_of(SpherePart::Kind kind) {
    if (kind == SpherePart::Kind::cross) return {{{1, 1}, {2, 1}, {3, 1}, {0, 1}, {1, 0}, {1, 2}}};
    // right, left, up, down, front, back: the order of graphics libraries
    if (kind == SpherePart::Kind::row) return {{{4, 0}, {0, 0}, {5, 0}, {1, 0}, {2, 0}, {3, 0}}};
    return {{{0, 4}, {0, 0}, {0, 5}, {0, 1}, {0, 2}, {0, 3}}};
}

ImageColor sphere_of_cube(const ImageColor& picture, const SpherePart& part) {
    const int side = part.kind == SpherePart::Kind::row      ? part.height
                     : part.kind == SpherePart::Kind::column ? part.width
                                                             : part.width / 4;
    std::array<ImageColor, 6> faces;
    const auto cells = cells_of(part.kind);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        faces[f] = ImageColor(side, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                faces[f].at(x, y) = picture.at(cells[f].first * side + x, cells[f].second * side + y);
    }
    return equirect_from_faces(faces, Pinhole::with_fov(side, side, 90), part.size());
}

float luma(Rgb8 p) { return (54.f * p.r + 183.f * p.g + 19.f * p.b) / 256.f; }

}  // namespace

WholeSphere<Rgb8> whole_sphere(const ImageRgb8& picture, const SpherePart& part) {
    if (part.is_whole()) return {picture, {}};
    if (part.is_cube()) return {srgb8_from_linear(sphere_of_cube(linear_from_srgb8(picture), part)), {}};
    return resampled(picture, part);
}
WholeSphere<Vec3f> whole_sphere(const ImageColor& picture, const SpherePart& part) {
    if (part.is_whole()) return {picture, {}};
    if (part.is_cube()) return {sphere_of_cube(picture, part), {}};
    return resampled(picture, part);
}

bool has_blank_corners(const ImageRgb8& picture) {
    const int side = picture.width / 4;
    if (side < 4 || picture.height < 3 * side) return false;
    constexpr int kMostDifference = 12;  // of a channel: JPEG
    const Rgb8 first = picture.at(side / 2, side / 2);
    for (const int column : {0, 2, 3})
        for (const int row : {0, 2})
            for (int j = side / 8; j < side - side / 8; j += std::max(1, side / 16))
                for (int i = side / 8; i < side - side / 8; i += std::max(1, side / 16)) {
                    const Rgb8 p = picture.at(column * side + i, row * side + j);
                    if (std::abs(p.r - first.r) > kMostDifference || std::abs(p.g - first.g) > kMostDifference ||
                        std::abs(p.b - first.b) > kMostDifference)
                        return false;
                }
    return true;
}

bool looks_like_two_fisheyes(const ImageRgb8& picture) {
    const int side = picture.width / 2;
    if (picture.height != side || side < 64) return false;
    constexpr float kDark = 24, kOutside = 1.15f;  // of 255; in radii of a circle that fills a half
    constexpr double kMostLit = 0.02, kLeastLit = 0.5;
    const float r = static_cast<float>(side) / 2;
    std::int64_t outside = 0, lit_outside = 0, top = 0, lit_top = 0;
    for (int y = 0; y < side; y += 2)
        for (int x = 0; x < picture.width; x += 2) {
            const float dx = (static_cast<float>(x % side) - r) / r, dy = (static_cast<float>(y) - r) / r;
            const bool lit = luma(picture.at(x, y)) > kDark;
            if (std::hypot(dx, dy) > kOutside) ++outside, lit_outside += lit;
            // Just inside the circles, at the top and bottom, where a sphere with dark poles is dark all along.
            if (std::fabs(dx) < 0.15f && std::fabs(dy) > 0.8f && std::fabs(dy) < 0.9f) ++top, lit_top += lit;
        }
    return static_cast<double>(lit_outside) < kMostLit * static_cast<double>(outside) &&
           static_cast<double>(lit_top) > kLeastLit * static_cast<double>(top);
}

ImageMask black_borders(const ImageRgb8& picture) {
    constexpr int kBlack = 3;  // of 255: JPEG's black
    const int w = picture.width, h = picture.height;
    const auto black = [&](int x, int y) {
        const Rgb8 p = picture.at(x, y);
        return p.r <= kBlack && p.g <= kBlack && p.b <= kBlack;
    };
    const auto row = [&](int y) {
        for (int x = 0; x < w; ++x)
            if (!black(x, y)) return false;
        return true;
    };
    const auto column = [&](int x) {
        for (int y = 0; y < h; ++y)
            if (!black(x, y)) return false;
        return true;
    };
    int top = 0, bottom = h, left = 0, right = w;
    while (top < h && row(top)) ++top;
    if (top == h) return {};  // all black
    while (bottom > top && row(bottom - 1)) --bottom;
    while (left < w && column(left)) ++left;
    while (right > left && column(right - 1)) --right;
    // A dark ceiling lamp or a tripod's hole is a few rows.
    if (std::max(top, h - bottom) <= h / 64) top = 0, bottom = h;
    if (std::max(left, w - right) <= w / 128) left = 0, right = w;
    if (top == 0 && bottom == h && left == 0 && right == w) return {};
    ImageMask out(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            if (y < top || y >= bottom || x < left || x >= right) out.at(x, y) = 255;
    return out;
}

}  // namespace fastscene
