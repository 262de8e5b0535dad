#include "fastscene/walk/mirrors.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/math/solve.h"

namespace fastscene {
namespace {

constexpr std::size_t kMostMirrors = 4;
constexpr std::size_t kLeastPixels = 64;
constexpr double kFlat_m = 0.01;         // maximum RMS distance of one glass's pixels from their plane
constexpr float kBeforeGlass_m = 0.04f;  // anything less far in front of the glass is its frame or the wall around it
constexpr Vec3f kSilver{0.92f, 0.93f, 0.92f};

// Connected components of pixels that look into glass.
std::vector<std::vector<std::size_t>> parts_of(const ImageMask& glass) {
    const int w = glass.width, h = glass.height;
    ImageMask left = glass;
    std::vector<std::vector<std::size_t>> parts;
    for (std::size_t seed = 0; seed < glass.size(); ++seed) {
        if (!left.pixels[seed]) continue;
        left.pixels[seed] = 0;
        std::vector<std::size_t> part{seed};
        for (std::size_t k = 0; k < part.size(); ++k) {
            const int x = static_cast<int>(part[k]) % w, y = static_cast<int>(part[k]) / w;
            for (const auto& [i, j] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
                if (j < 0 || j >= h) continue;
                const std::size_t next = static_cast<std::size_t>(j) * static_cast<std::size_t>(w) +
                                         static_cast<std::size_t>(wrap_column(i, w));
                if (!left.pixels[next]) continue;
                left.pixels[next] = 0;
                part.push_back(next);
            }
        }
        if (part.size() >= kLeastPixels) parts.push_back(std::move(part));
    }
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    parts.resize(std::min(parts.size(), kMostMirrors));
    return parts;
}

// Fits a plane to the pixels' surfaces (m . p = 1, least squares; panorama 0 is not on it). False if they are not
// planar.
bool fit_plane(const Panorama& first, const std::vector<std::size_t>& pixels, Mirror& mirror) {
    Mat3d squares{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    Vec3d sum{};
    std::vector<Vec3d> points;
    for (const std::size_t i : pixels) {
        const auto w = static_cast<std::size_t>(first.range.width);
        const Vec3f q = direction_of_pixel(static_cast<int>(i % w), static_cast<int>(i / w), first.size()) *
                        first.range.pixels[i];
        const Vec3d p{q.x, q.y, q.z};
        squares.row0 += p * p.x, squares.row1 += p * p.y, squares.row2 += p * p.z;
        sum += p;
        points.push_back(p);
    }
    const auto m = solved(squares, sum, 1e-12);
    if (!m) return false;
    const double length_m = length(*m);
    double error = 0;
    for (const Vec3d p : points) error += std::pow((dot(*m, p) - 1) / length_m, 2);
    if (!(std::sqrt(error / static_cast<double>(points.size())) < kFlat_m)) return false;
    mirror.normal = Vec3f{static_cast<float>(-m->x / length_m), static_cast<float>(-m->y / length_m),
                          static_cast<float>(-m->z / length_m)};
    mirror.offset = static_cast<float>(-1 / length_m);
    const auto middle = sum / static_cast<double>(points.size());
    for (const Vec3d p : points) mirror.reach = std::max(mirror.reach, static_cast<float>(length(p - middle)));
    mirror.middle = {static_cast<float>(middle.x), static_cast<float>(middle.y), static_cast<float>(middle.z)};
    return true;
}

// Panorama 0 as its mirror image behind the glass would have taken it, without the pixels behind the glass plane or in
// the glass.
WarpSource mirrored_room(const Panorama& first, Vec3f normal, float offset) {
    const EquirectSize size = first.size();
    const Vec3f n2 = normal * 2.f;
    const Mat3f real_from_image{Vec3f{1, 0, 0} - n2 * normal.x, Vec3f{0, 1, 0} - n2 * normal.y,
                                Vec3f{0, 0, 1} - n2 * normal.z};
    ImageF range(size.width, size.height);
    ImageMask used(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f real = real_from_image * direction_of_pixel(x, y, size);
            const Vec2f at = pixel_of_direction(real, size);
            const float r = first.range.at(wrap_column(static_cast<int>(at.x), size.width),
                                           std::clamp(static_cast<int>(at.y), 0, size.height - 1));
            range.at(x, y) = r;
            used.at(x, y) = std::isfinite(r) ? dot(normal, real * r) - offset > kBeforeGlass_m : dot(normal, real) > 0;
        }
    return make_warp_source(equirect_from_equirect(first.color, size, real_from_image), range,
                            Image<std::int16_t>(size.width, size.height, kNoPlane), used, normal * (2 * offset));
}

// Keeps only the mirrored pixels that are behind the glass as seen from `position`; its bounding disc makes the test
// fast.
void keep_behind_glass(Mirror& mirror, Vec3f position) {
    WarpSource& image = mirror.image[0];
    const EquirectSize size{image.color.width, image.color.height};
    const float reach = mirror.reach + 0.1f, near = mirror.offset - dot(mirror.normal, position);  // < 0
    parallel_for(size.height, 16, [&](std::int64_t begin, std::int64_t end) {
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < size.width; ++x) {
                image.used.at(x, y) = 0;
                if (!mirror.room.at(x, y)) continue;
                const float inverse = std::max(image.inverse_range.at(x, y), 1e-4f);
                const Vec3f to = image.position + direction_of_pixel(x, y, size) / inverse - position;
                const float towards = dot(mirror.normal, to);
                if (!(towards < 0)) continue;
                image.used.at(x, y) = length(position + to * (near / towards) - mirror.middle) < reach;
            }
    });
}

// Renders the mirror's image in each marked pixel, as the mean of the quarters that show something beyond the glass:
// take(pixel, color, range).
void draw_image(Mirror& mirror, const ImageMask& marked, Vec3f position,
                const std::function<void(std::size_t, Vec3f, float)>& take) {
    keep_behind_glass(mirror, position);
    const CoarseView quarters = quarters_view(mirror.image, marked, position);
    std::size_t quarter = 0;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (!marked.pixels[i]) continue;
        Vec3f sum{};
        float count = 0, range = 0;
        for (int k = 0; k < 4; ++k, ++quarter) {
            if (quarters.cover.pixels[quarter] != Cover::front) continue;
            sum += quarters.color.pixels[quarter];
            range = quarters.range.pixels[quarter];
            ++count;
        }
        if (count > 0) take(i, sum / count, range);
    }
}

// The mirror's tint, measured where panorama 0 saw an object both directly and in the mirror.
Vec3f tint_of(Mirror& mirror, const Panorama& first) {
    Vec3f both{}, squares{};
    draw_image(mirror, mirror.glass, {}, [&](std::size_t i, Vec3f color, float) {
        both += color * first.color.pixels[i];
        squares += color * color;
    });
    Vec3f tint = kSilver;
    for (std::size_t c = 0; c < 3; ++c)
        if (squares[c] > 1.f) tint[c] = std::clamp(both[c] / squares[c], 0.7f, 1.f);
    return tint;
}

}  // namespace

std::vector<Mirror> find_mirrors(const Panorama& first) {
    std::vector<Mirror> mirrors;
    if (first.mirrored_range.empty()) return mirrors;
    ImageMask glass(first.range.width, first.range.height);
    for (std::size_t i = 0; i < glass.size(); ++i)
        glass.pixels[i] = first.mirrored_range.pixels[i] != first.range.pixels[i];
    for (const std::vector<std::size_t>& part : parts_of(glass)) {
        Mirror mirror;
        if (!fit_plane(first, part, mirror)) continue;
        mirror.glass = ImageMask(glass.width, glass.height);
        for (const std::size_t i : part) mirror.glass.pixels[i] = 1;
        mirror.image.push_back(mirrored_room(first, mirror.normal, mirror.offset));
        mirror.room = mirror.image[0].used;
        mirror.tint = tint_of(mirror, first);
        mirrors.push_back(std::move(mirror));
    }
    return mirrors;
}

void look_into(std::vector<Mirror>& mirrors, Vec3f position, CoarseView& view, Image<Known>& known) {
    const EquirectSize size{view.color.width, view.color.height};
    for (Mirror& mirror : mirrors) {
        ImageMask marked(size.width, size.height);
        bool any = false;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                if (known.at(x, y) != Known::invented) continue;
                const Vec3f d = direction_of_pixel(x, y, size);
                const float towards = dot(mirror.normal, d),
                            t = (mirror.offset - dot(mirror.normal, position)) / towards;
                if (!(towards < -1e-3f && t > 0)) continue;
                const Vec2f at = pixel_of_direction(position + d * t, size);
                if (!mirror.glass.at(wrap_column(static_cast<int>(at.x), size.width),
                                     std::clamp(static_cast<int>(at.y), 0, size.height - 1)))
                    continue;
                marked.at(x, y) = 1;
                any = true;
            }
        if (!any) continue;
        draw_image(mirror, marked, position, [&](std::size_t i, Vec3f color, float range) {
            view.color.pixels[i] = color * mirror.tint;
            view.range.pixels[i] = range;
            view.plane.pixels[i] = kNoPlane;
            view.cover.pixels[i] = Cover::front;
            known.pixels[i] = Known::carried;
        });
    }
}

}  // namespace fastscene
