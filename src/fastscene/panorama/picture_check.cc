#include "fastscene/panorama/picture_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

float luma(Vec3f linear) {
    const float r = srgb_from_linear(linear.x), g = srgb_from_linear(linear.y), b = srgb_from_linear(linear.z);
    return 0.299f * r + 0.587f * g + 0.114f * b;
}

ImageF luma_of(const ImageColor& color) {
    ImageF out(color.width, color.height);
    std::transform(color.pixels.begin(), color.pixels.end(), out.pixels.begin(), luma);
    return out;
}

// Mean change between two columns, over the middle of the picture where columns are far apart.
double column_change(const ImageF& image, int a, int b) {
    double sum = 0;
    const int top = image.height / 8, bottom = image.height - top;
    for (int y = top; y < bottom; ++y) sum += std::abs(image.at(a, y) - image.at(b, y));
    return sum / (bottom - top);
}

struct RowStats {
    double mean = 0, deviation = 0;
};
RowStats row_stats(const ImageF& image, int y) {
    RowStats s;
    double squares = 0;
    for (int x = 0; x < image.width; ++x) s.mean += image.at(x, y), squares += static_cast<double>(image.at(x, y)) * image.at(x, y);
    s.mean /= image.width;
    s.deviation = std::sqrt(std::max(0., squares / image.width - s.mean * s.mean));
    return s;
}

// The seam may pass an edge of the room; so it is held against the upper tenth of what columns elsewhere do.
bool seam_is_open(const ImageF& image) {
    std::vector<double> changes;
    const int step = std::max(1, image.width / 256);
    for (int x = 0; x + 1 < image.width; x += step) changes.push_back(column_change(image, x, x + 1));
    const auto at = changes.begin() + static_cast<std::ptrdiff_t>(changes.size() * 9 / 10);
    std::nth_element(changes.begin(), at, changes.end());
    return column_change(image, image.width - 1, 0) > std::max(0.03, 3 * *at);
}

int black_rows(const ImageF& image, bool top) {
    int rows = 0;
    while (rows < image.height) {
        const RowStats s = row_stats(image, top ? rows : image.height - 1 - rows);
        if (s.mean > 0.012 || s.deviation > 0.012) break;
        ++rows;
    }
    return rows;
}

// A tripod, a stand or a logo: within the lowest 20 degrees a ring where the brightness jumps all around.
bool has_nadir_disc(const ImageF& image) {
    const int from = image.height * 8 / 9;
    double strongest = 0, usual = 0;
    int count = 0;
    for (int y = from; y + 2 < image.height; ++y) {
        double jump = 0;
        for (int x = 0; x < image.width; ++x) jump += std::abs(image.at(x, y) - image.at(x, y + 2));
        jump /= image.width;
        strongest = std::max(strongest, jump);
        usual += jump;
        ++count;
    }
    return count > 4 && strongest > 0.08 && strongest > 4 * usual / count;
}

}  // namespace

std::vector<std::string> doubts_about_panorama(const ImageColor& color) {
    std::vector<std::string> doubts;
    const ImageF image = luma_of(color);
    double mean = 0;
    for (const float v : image.pixels) mean += v;
    mean /= static_cast<double>(image.size());
    if (!(mean > 0.01)) return {"the picture is black: expected a room with light in it"};

    const int top = black_rows(image, true), bottom = black_rows(image, false);
    if (top > image.height / 64 || bottom > image.height / 64)
        doubts.push_back(fmt::format("black borders ({} rows at the top, {} at the bottom): expected a full sphere; they will be taken for surfaces",
                                     top, bottom));
    else {
        // Each row of pixels at a pole is one point of the world.
        const RowStats zenith = row_stats(image, 0), nadir = row_stats(image, image.height - 1);
        if (zenith.deviation > 0.12 || nadir.deviation > 0.12)
            doubts.push_back(fmt::format(
                "the {} is not one color along its row: expected an equirectangular picture (360 x 180 degrees), this may be an ordinary photo",
                zenith.deviation > nadir.deviation ? "top" : "bottom"));
    }
    if (seam_is_open(image))
        doubts.push_back("the left and the right edge do not meet: expected a picture that closes, or is it a part of a panorama?");
    if (has_nadir_disc(image)) doubts.push_back("a disc straight below (a tripod or a logo?): it will be taken for the floor's texture");
    return doubts;
}

std::vector<std::string> remarks_on_file(const std::filesystem::path& picture) {
    std::vector<std::string> remarks;
    const PictureInfo info = picture_info(picture);
    if (info.light) remarks.push_back("light in floats, not a finished picture: exposed automatically");
    if (info.light) return remarks;
    if (info.orientation != 1) remarks.push_back(fmt::format("EXIF orientation {}: turned upright", info.orientation));
    const ImageMask alpha = load_alpha(picture);
    const auto clear = std::count_if(alpha.pixels.begin(), alpha.pixels.end(), [](std::uint8_t a) { return a < 128; });
    if (clear > 0)
        remarks.push_back(fmt::format("{:.1f} % of it can be seen through: black was put behind",
                                      100. * static_cast<double>(clear) / static_cast<double>(alpha.size())));
    return remarks;
}

}  // namespace fastscene
