#include "fastscene/panorama/picture_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"

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

// Mean difference between two columns, over the middle rows, where columns are far apart.
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
    for (int x = 0; x < image.width; ++x)
        s.mean += image.at(x, y), squares += static_cast<double>(image.at(x, y)) * image.at(x, y);
    s.mean /= image.width;
    s.deviation = std::sqrt(std::max(0., squares / image.width - s.mean * s.mean));
    return s;
}

// The seam may coincide with an edge of the room, so it is compared with other columns: their upper tenth, and how many
// are as strong.
bool seam_is_open(const ImageF& image) {
    constexpr int kEnough = 3;
    std::vector<double> changes;
    for (int x = 0; x + 1 < image.width; x += std::max(1, image.width / 1024))
        changes.push_back(column_change(image, x, x + 1));
    std::sort(changes.begin(), changes.end());
    const double seam = column_change(image, image.width - 1, 0), usual = changes[changes.size() * 9 / 10];
    const auto as_strong = std::count_if(changes.begin(), changes.end(), [&](double c) { return c > 0.9 * seam; });
    return seam > 0.03 && as_strong < kEnough && (seam > 3 * usual || as_strong == 0);
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

int black_columns(const ImageF& image, bool left) {
    int columns = 0;
    for (; columns < image.width; ++columns) {
        const int x = left ? columns : image.width - 1 - columns;
        for (int y = 0; y < image.height; ++y)
            if (image.at(x, y) > 0.03f) return columns;
    }
    return columns;
}

// Detects a tripod, stand or logo: within the lowest 40 degrees, a ring with a brightness step all around.
bool has_nadir_disc(const ImageF& image) {
    const int from = image.height * 7 / 9;
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

    const auto [least, most] = std::minmax_element(image.pixels.begin(), image.pixels.end());
    if (*most - *least < 0.01f) return {"the picture is one color throughout: expected a room"};

    const bool open = seam_is_open(image);
    const int top = black_rows(image, true), bottom = black_rows(image, false), left = black_columns(image, true),
              right = black_columns(image, false);
    if (std::max(top, bottom) > image.height / 64 || std::max(left, right) > image.width / 128)
        doubts.push_back(
            fmt::format("black borders ({} rows at the top, {} at the bottom, {} columns at the left, {} at the "
                        "right): expected a full sphere; they will be "
                        "taken for surfaces",
                        top, bottom, left, right));
    else {
        // Each pixel row at a pole is a single point of the world. A rug's edge or a tripod's leg may be there, so one
        // pole alone is not evidence.
        const RowStats zenith = row_stats(image, 0), nadir = row_stats(image, image.height - 1);
        const double less = std::min(zenith.deviation, nadir.deviation),
                     more = std::max(zenith.deviation, nadir.deviation);
        if (more > 0.12 && (less > 0.06 || open))
            doubts.push_back(
                fmt::format("the {} is not one color along its row: expected an equirectangular picture (360 x 180 "
                            "degrees), this may be an ordinary photo",
                            zenith.deviation > nadir.deviation ? "top" : "bottom"));
    }
    if (open)
        doubts.push_back(
            "the left and the right edge do not meet: expected a picture that closes, or is it a part of a panorama?");
    if (has_nadir_disc(image))
        doubts.push_back("a disc straight below (a tripod or a logo?): it will be taken for the floor's texture");
    return doubts;
}

}  // namespace fastscene
