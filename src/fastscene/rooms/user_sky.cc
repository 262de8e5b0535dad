#include "fastscene/rooms/user_sky.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

constexpr int kWidest = 4096;    // columns: 11 a degree, more than any window shows
constexpr int kLargest = 16384;  // columns of a file
// The sun: brighter than this many times the mean of the upper half, within so many degrees of the brightest point.
constexpr float kSunContrast = 15, kSunRadius_deg = 6;

ImageColor halved_light(const ImageColor& image) {
    ImageColor out(image.width / 2, image.height / 2);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.at(x, y) = (image.at(2 * x, 2 * y) + image.at(2 * x + 1, 2 * y) + image.at(2 * x, 2 * y + 1) +
                            image.at(2 * x + 1, 2 * y + 1)) *
                           0.25f;
    return out;
}

// Mean over the rows [from, to) of the height, weighted by solid angle.
Vec3f mean_between(const ImageColor& image, float from, float to) {
    const EquirectSize size{image.width, image.height};
    const auto first = static_cast<int>(from * static_cast<float>(image.height)),
               last = static_cast<int>(to * static_cast<float>(image.height));
    Vec3<double> sum{};
    double weight = 0;
    for (int y = first; y < last; ++y) {
        const double w = pixel_solid_angle(y, size);
        for (int x = 0; x < image.width; ++x) {
            const Vec3f c = image.at(x, y);
            sum += Vec3<double>{c.x, c.y, c.z} * w;
        }
        weight += w * image.width;
    }
    sum = sum * (1 / std::max(weight, 1e-12));
    return {static_cast<float>(sum.x), static_cast<float>(sum.y), static_cast<float>(sum.z)};
}

// What is brighter than the sky about the sun becomes a light of its own, since no sampling of the sky finds it.
void take_sun(PhotographedSky& sky) {
    ImageColor& image = sky.picture;
    const EquirectSize size{image.width, image.height};
    const int horizon = image.height / 2;
    int at_x = 0, at_y = 0;
    float brightest = 0;
    for (int y = 0; y < horizon; ++y)
        for (int x = 0; x < image.width; ++x)
            if (const float l = luminance(image.at(x, y)); l > brightest) brightest = l, at_x = x, at_y = y;
    const float limit = kSunContrast * luminance(mean_between(image, 0, 0.5f));
    if (!(brightest > limit)) return;
    const Vec3f peak = direction_of_pixel(at_x, at_y, size);
    const float cosine = std::cos(kSunRadius_deg * kPi / 180);
    Vec3f toward{};
    for (int y = 0; y < horizon; ++y)
        for (int x = 0; x < image.width; ++x) {
            Vec3f& c = image.at(x, y);
            const float l = luminance(c);
            const Vec3f direction = direction_of_pixel(x, y, size);
            if (!(l > limit) || dot(direction, peak) < cosine) continue;
            const Vec3f sky_there = c * (limit / l);
            const Vec3f sun = (c - sky_there) * static_cast<float>(pixel_solid_angle(y, size));
            sky.sun_irradiance += sun;
            toward += direction * luminance(sun);
            c = sky_there;
        }
    sky.sun_dir = normalize(toward);
}

}  // namespace

PhotographedSky photographed_sky(ImageColor radiance, const std::string& where) {
    if (radiance.width != 2 * radiance.height || radiance.width < 16)
        throw Error("{}: expected an equirectangular picture twice as wide as high, found {} x {}", where,
                    radiance.width, radiance.height);
    for (Vec3f& c : radiance.pixels)
        for (std::size_t k = 0; k < 3; ++k) c[k] = std::isfinite(c[k]) ? std::max(0.f, c[k]) : 0.f;
    while (radiance.width > kWidest && radiance.width % 4 == 0) radiance = halved_light(radiance);
    PhotographedSky sky;
    sky.picture = std::move(radiance);
    take_sun(sky);
    const float mean = luminance(mean_between(sky.picture, 0, 0.5f));
    if (!(mean > 0)) throw Error("{}: expected a sky that gives light, found black", where);
    for (Vec3f& c : sky.picture.pixels) c = c / mean;
    sky.sun_irradiance = sky.sun_irradiance / mean;
    sky.zenith = mean_between(sky.picture, 0, 0.2f);
    sky.horizon = mean_between(sky.picture, 0.3f, 0.5f);
    sky.ground = mean_between(sky.picture, 0.5f, 0.8f);
    return sky;
}

PhotographedSky load_user_sky(const std::filesystem::path& folder, const UserSky& sky) {
    const std::filesystem::path file = folder / sky.file;
    const PictureInfo info = picture_info(file);
    if (info.width > kLargest)
        throw Error("{}: expected at most {} columns, found {}", file.string(), kLargest, info.width);
    return photographed_sky(load_light(file), file.string());
}

ImageColor turned_to(const ImageColor& picture, float azimuth) {
    const auto shift = static_cast<int>(std::lround(azimuth / (2 * kPi) * static_cast<float>(picture.width)));
    ImageColor out(picture.width, picture.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) out.at(wrap_column(x + shift, out.width), y) = picture.at(x, y);
    return out;
}

}  // namespace fastscene
