#include "fastscene/views/photo_picture.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

struct Picture {
    ImageRgb8 color;
    ImageMask weight;  // empty: all pixels count
};

void combine(ImageMask& weight, const ImageMask& other) {
    if (weight.empty()) weight = ImageMask(other.width, other.height, 255);
    for (std::size_t i = 0; i < weight.size(); ++i)
        weight.pixels[i] = static_cast<std::uint8_t>(weight.pixels[i] * other.pixels[i] / 255);
}

// Resizes a mask with nearest neighbours.
ImageMask resized(const ImageMask& mask, int width, int height) {
    ImageMask out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            out.at(x, y) = mask.at(
                static_cast<int>((static_cast<std::int64_t>(x) * 2 + 1) * mask.width / (2 * width)),
                static_cast<int>((static_cast<std::int64_t>(y) * 2 + 1) * mask.height / (2 * height)));
    return out;
}

// Whether the aspect ratio matches that of `of`, within a pixel of rounding on each side plus a small tolerance.
bool has_shape(PictureSize found, PictureSize of) {
    const double shape = static_cast<double>(found.width) / found.height,
                 expected = static_cast<double>(of.width) / of.height;
    return std::fabs(shape / expected - 1) < 0.02 + 1.0 / std::min(found.width, found.height);
}

Picture load(const Photo& photo, const PhotosParams& params) {
    Picture picture{load_rgb8(photo.file), {}};
    const PictureSize size{picture.color.width, picture.color.height};
    if (!has_shape(size, {photo.lens.width, photo.lens.height}))
        throw Error("{}: expected the shape of its camera, {} x {}, found {} x {}", photo.file.string(),
                    photo.lens.width, photo.lens.height, size.width, size.height);
    if (params.alpha == "mask")
        if (ImageMask alpha = load_alpha(photo.file); !alpha.empty()) picture.weight = std::move(alpha);
    if (!photo.mask.empty()) {
        ImageMask mask = load_mask(photo.mask);
        if (!has_shape({mask.width, mask.height}, size))
            throw Error("{}: expected the shape of its picture, {} x {}, found {} x {}", photo.mask.string(),
                        size.width, size.height, mask.width, mask.height);
        if (params.invert_masks)
            for (std::uint8_t& v : mask.pixels) v = static_cast<std::uint8_t>(255 - v);
        combine(picture.weight,
                mask.same_size(picture.color) ? mask : resized(mask, picture.color.width, picture.color.height));
    }
    return picture;
}

// Bilinear, in sRGB-encoded values, as splats are trained.
Vec3f sample(const ImageRgb8& image, Vec2d at) {
    const double px = std::clamp(at.x - 0.5, 0.0, image.width - 1.0),
                 py = std::clamp(at.y - 0.5, 0.0, image.height - 1.0);
    const int x = static_cast<int>(px), y = static_cast<int>(py), x1 = std::min(x + 1, image.width - 1),
              y1 = std::min(y + 1, image.height - 1);
    const auto u = static_cast<float>(px - x), v = static_cast<float>(py - y);
    const auto value = [&](int i, int j) { return unit_from_srgb8(image.at(i, j)); };
    return lerp(lerp(value(x, y), value(x1, y), u), lerp(value(x, y1), value(x1, y1), u), v);
}

// Undistorts the picture to the ideal camera; samples are no farther apart than the source's pixels.
void straighten(const Picture& source, const Lens& lens, View& view) {
    const Pinhole& camera = view.camera;
    const double reach = lens.reach();
    const int n = std::clamp(static_cast<int>(std::ceil(lens.fx / static_cast<double>(camera.fx) - 0.05)), 1, 32);
    view.color = ImageRgb8(camera.width, camera.height);
    ImageMask weight(camera.width, camera.height);
    bool all_count = true;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            Vec3f sum;
            float seen = 0, counts = 0;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const double px = x + (i + 0.5) / n, py = y + (j + 0.5) / n;
                    const auto at = lens.pixel_of(
                        {(px - static_cast<double>(camera.cx)) / static_cast<double>(camera.fx),
                         (py - static_cast<double>(camera.cy)) / static_cast<double>(camera.fy), 1},
                        reach);
                    if (!at || !(at->x >= 0 && at->y >= 0 && at->x <= lens.width && at->y <= lens.height)) continue;
                    sum += sample(source.color, *at);
                    ++seen;
                    counts += source.weight.empty() ? 255.f
                                                    : static_cast<float>(source.weight.at(
                                                          std::min(static_cast<int>(at->x), lens.width - 1),
                                                          std::min(static_cast<int>(at->y), lens.height - 1)));
                }
            if (seen > 0) sum = sum * (1 / seen);
            view.color.at(x, y) = {byte_from_unit(sum.x), byte_from_unit(sum.y), byte_from_unit(sum.z)};
            weight.at(x, y) = static_cast<std::uint8_t>(counts / static_cast<float>(n * n) + 0.5f);
            all_count = all_count && weight.at(x, y) == 255;
        }
    if (!all_count) view.weight = std::move(weight);
}

// Downsampled: averages as many samples as the new pixel covers source pixels.
Picture shrunk(const Picture& source, int width, int height) {
    const double step_x = static_cast<double>(source.color.width) / width,
                 step_y = static_cast<double>(source.color.height) / height;
    const int n = std::clamp(static_cast<int>(std::ceil(std::max(step_x, step_y) - 0.05)), 1, 32);
    Picture out{ImageRgb8(width, height), source.weight.empty() ? ImageMask() : ImageMask(width, height)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Vec3f sum;
            float counts = 0;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const Vec2d at{(x + (i + 0.5) / n) * step_x, (y + (j + 0.5) / n) * step_y};
                    sum += sample(source.color, at);
                    if (!source.weight.empty())
                        counts += static_cast<float>(
                            source.weight.at(std::min(static_cast<int>(at.x), source.color.width - 1),
                                             std::min(static_cast<int>(at.y), source.color.height - 1)));
                }
            const auto samples = static_cast<float>(n * n);
            out.color.at(x, y) = {byte_from_unit(sum.x / samples), byte_from_unit(sum.y / samples),
                                  byte_from_unit(sum.z / samples)};
            if (!source.weight.empty()) out.weight.at(x, y) = static_cast<std::uint8_t>(counts / samples + 0.5f);
        }
    return out;
}

// Equirectangular pictures are trained on as they are. They have fewer pixels per degree than other pictures of the
// same width.
constexpr int kSphereWider = 2;

View whole_sphere(Picture picture, const Photo& photo, const Rigid& world_from_camera, const PhotosParams& params) {
    const auto [width, height] = size_of_view(photo, {picture.color.width, picture.color.height}, params);
    if (width < picture.color.width) picture = shrunk(picture, width, height);
    View view;
    view.name = photo.name;
    view.camera = {picture.color.width, picture.color.height, 0, 0, 0, 0};
    view.world_from_camera = world_from_camera;
    view.color = std::move(picture.color);
    view.weight = std::move(picture.weight);
    view.model = CameraModel::equirectangular;
    return view;
}

}  // namespace

PictureSize size_of_view(const Photo& photo, PictureSize stored, const PhotosParams& params) {
    const bool sphere = photo.lens.kind == LensKind::equirectangular;
    const double most = sphere ? static_cast<double>(kSphereWider * params.max_size) / stored.width
                               : static_cast<double>(params.max_size) / std::max(stored.width, stored.height);
    // If the capture provides downsampled copies, they count towards the requested reduction.
    const double wanted = std::min(
        {most, static_cast<double>(photo.lens.width) / params.downscale / stored.width, 1.0});
    if (wanted >= 1) return stored;
    // Equirectangular pictures have an even width, symmetric about their center.
    const int width = sphere ? std::max(2, static_cast<int>(std::lround(stored.width * wanted / 2)) * 2)
                             : std::max(1, static_cast<int>(std::lround(stored.width * wanted)));
    return {width, std::max(1, static_cast<int>(std::lround(stored.height * wanted)))};
}

View view_of_photo(const Photo& photo, const Rigid& world_from_camera, const PhotosParams& params) {
    Picture picture = load(photo, params);
    if (photo.lens.kind == LensKind::equirectangular)
        return whole_sphere(std::move(picture), photo, world_from_camera, params);
    const Lens lens = photo.lens.resized(picture.color.width, picture.color.height);
    const auto [width, height] = size_of_view(photo, {lens.width, lens.height}, params);
    View view;
    view.name = photo.name;
    view.camera = lens.resized(width, height).pinhole();
    view.world_from_camera = world_from_camera;
    if (lens.is_pinhole() && width == lens.width && height == lens.height) {
        view.color = std::move(picture.color);
        view.weight = std::move(picture.weight);
    } else {
        straighten(picture, lens, view);
    }
    return view;
}

}  // namespace fastscene
