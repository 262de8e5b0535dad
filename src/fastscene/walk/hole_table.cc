#include "fastscene/walk/hole_table.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/shortest.h"
#include "fastscene/walk/free_space.h"
#include "fastscene/walk/published_warp.h"
#include "fastscene/walk/ready.h"

namespace fastscene {
namespace {

constexpr int kPublishedWidth = 1024;

struct PaperStep {
    char axis;
    double share, hole;  // Table 1: "Pose (m)", given as shares of the greatest range, and "Mask (%)", as a share
};
constexpr PaperStep kPaper[] = {
    {'x', 0.33, 0.643},  {'x', 0.27, 0.587},  {'x', 0.21, 0.519}, {'x', 0.15, 0.432},  {'x', 0.09, 0.332},
    {'x', 0.03, 0.177},  {'x', -0.02, 0.149}, {'y', 0.20, 0.289}, {'y', 0.16, 0.242},  {'y', 0.12, 0.196},
    {'y', 0.09, 0.153},  {'y', 0.05, 0.112},  {'y', 0.02, 0.071}, {'y', -0.02, 0.076}, {'z', 0.33, 0.622},
    {'z', 0.27, 0.567},  {'z', 0.21, 0.500},  {'z', 0.15, 0.419}, {'z', 0.09, 0.315},  {'z', 0.03, 0.167},
    {'z', -0.02, 0.160},
};

ImageF at_published_size(const ImageF& range) {
    if (range.width <= kPublishedWidth) return range;
    // nearest neighbour: an interpolated range lies on neither surface
    ImageF out(kPublishedWidth, kPublishedWidth / 2);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.at(x, y) = range.at((2 * x + 1) * range.width / (2 * out.width),
                                    (2 * y + 1) * range.height / (2 * out.height));
    return out;
}

double share_of(const ImageMask& mask) {
    return static_cast<double>(
               std::count_if(mask.pixels.begin(), mask.pixels.end(), [](std::uint8_t v) { return v != 0; })) /
           static_cast<double>(mask.size());
}

// Share of the pixels of `a` that have a pixel of `b` at most `reach` away, with the counts.
double share_inside(const ImageMask& a, const ImageMask& b, int reach) {
    std::int64_t all = 0, inside = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            if (!a.at(x, y)) continue;
            ++all;
            bool found = false;
            for (int j = std::max(0, y - reach); j <= std::min(a.height - 1, y + reach) && !found; ++j)
                for (int i = x - reach; i <= x + reach && !found; ++i) found = b.at(wrap_column(i, a.width), j) != 0;
            inside += found;
        }
    return all ? static_cast<double>(inside) / static_cast<double>(all) : 1;
}

}  // namespace

ImageMask our_holes(const WarpSource& source, EquirectSize size, Vec3f position) {
    const CoarseView view = coarse_view({source}, size, position);
    ImageMask out(size.width, size.height);
    std::transform(view.cover.pixels.begin(), view.cover.pixels.end(), out.pixels.begin(),
                   [](Cover c) { return c == Cover::front ? std::uint8_t{0} : std::uint8_t{255}; });
    return out;
}

ImageMask true_holes(EquirectSize size, Vec3f position, const Distance& distance) {
    ImageMask out(size.width, size.height);
    parallel_for(size.height, 4, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Vec3f d = direction_of_pixel(x, y, size);
                const float far = distance(position, d);
                if (!std::isfinite(far)) {  // sky: visible from the first viewpoint if nothing is in that direction
                    out.at(x, y) = std::isfinite(distance({}, d)) ? 255 : 0;
                    continue;
                }
                const Vec3f p = position + d * far;
                out.at(x, y) = distance({}, normalize(p)) < length(p) * 0.998f - 0.003f ? 255 : 0;
            }
    });
    return out;
}

HoleTruth compare_holes(const ImageMask& ours, const ImageMask& truth, int reach) {
    return {share_of(truth), share_inside(ours, truth, 0), share_inside(truth, ours, 0),
            share_inside(ours, truth, reach), share_inside(truth, ours, reach)};
}

HoleTruth hole_truth(const WarpSource& source, Vec3f position, const Distance& distance) {
    const EquirectSize size{kFiner * source.color.width, kFiner * source.color.height};
    return compare_holes(our_holes(source, size, position), true_holes(size, position, distance), kFiner);
}

std::vector<HoleRow> hole_table(const ImageF& given, const Run& run, const Distance& distance) {
    Panorama first;
    first.range = at_published_size(given);
    first.color = ImageColor(first.range.width, first.range.height);
    first = ready_to_walk(std::move(first), run);
    const WarpSource source = make_warp_source(first.color, first.range, {}, {}, {});
    Image<double> range(first.range.width, first.range.height);
    double most = 0;
    for (std::size_t i = 0; i < range.size(); ++i) {
        range.pixels[i] = static_cast<double>(first.range.pixels[i]);
        if (std::isfinite(range.pixels[i])) most = std::max(most, range.pixels[i]);
    }
    range = published_units(range);
    const ImageRgb8 blank(range.width, range.height);
    std::vector<HoleRow> rows;
    Progress progress(run, "hole table", static_cast<std::int64_t>(std::size(kPaper)));
    for (const PaperStep& step : kPaper) {
        run.check_stop();
        const Vec3d move = step.axis == 'x'   ? Vec3d{step.share, 0, 0}
                           : step.axis == 'y' ? Vec3d{0, step.share, 0}
                                              : Vec3d{0, 0, step.share};
        const Vec3d world = world_from_published(move) * most;
        const Vec3f position{static_cast<float>(world.x), static_cast<float>(world.y), static_cast<float>(world.z)};
        HoleRow row{step.axis,
                    step.share,
                    step.share * most,
                    distance_ahead(first.range, normalize(position)) > length(position),
                    0,
                    0,
                    step.hole,
                    {}};
        row.published = published_warp(blank, range, move).hole_ratio();
        const ImageMask ours = our_holes(source, first.size(), position);
        row.ours = share_of(ours);
        if (distance && row.in_room) row.truth = hole_truth(source, position, distance);
        rows.push_back(row);
        progress.advance();
    }
    return rows;
}

std::string hole_table_text(const std::vector<HoleRow>& rows) {
    const bool truth = std::any_of(rows.begin(), rows.end(), [](const HoleRow& r) { return r.truth.has_value(); });
    bool outside = false;
    std::string text = "Holes in % of the picture, by axis and step (shares of the greatest range)\n";
    text += "axis   step   metres   paper  published    ours";
    text += truth ? "    true  precision  recall\n" : "\n";
    for (const HoleRow& row : rows) {
        text += fmt::format("{:<4} {:>+6.2f} {:>+7.2f}{} {:>6.1f} {:>10.1f} {:>7.1f}", row.axis, row.share, row.step_m,
                            row.in_room ? ' ' : '*', 100 * row.paper, 100 * row.published, 100 * row.ours);
        if (row.truth)
            text += fmt::format(" {:>7.1f} {:>10.1f} {:>7.1f}", 100 * row.truth->ratio, 100 * row.truth->precision_near,
                                100 * row.truth->recall_near);
        text += "\n";
        outside |= !row.in_room;
    }
    text += "x: to the middle of the picture; y: up; z: to its right\n";
    if (truth)
        text += "precision, recall: of our holes against those of the true room, within one of the panorama's pixels\n";
    if (outside) text += "*: the step ends in or behind a surface\n";
    return text;
}

Json hole_table_json(const std::vector<HoleRow>& rows) {
    const auto number = [](double v) {
        return shortest(static_cast<float>(v));
    };  // more than seven digits would be false precision
    Json out = Json::array();
    for (const HoleRow& row : rows) {
        Json json{{"axis", std::string(1, row.axis)}, {"share", number(row.share)},
                  {"step_m", number(row.step_m)},     {"in_room", row.in_room},
                  {"paper", number(row.paper)},       {"published", number(row.published)},
                  {"ours", number(row.ours)}};
        if (row.truth)
            json["truth"] = {{"ratio", number(row.truth->ratio)},
                             {"precision", number(row.truth->precision)},
                             {"recall", number(row.truth->recall)},
                             {"precision_near", number(row.truth->precision_near)},
                             {"recall_near", number(row.truth->recall_near)}};
        out.push_back(json);
    }
    return {{"rows", out}};
}

}  // namespace fastscene
