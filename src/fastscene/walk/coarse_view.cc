#include "fastscene/walk/coarse_view.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

#include "fastscene/base/parallel.h"
#include "fastscene/walk/silhouettes.h"

namespace fastscene {
namespace {

constexpr int kBandRows = 32;        // rows of the target per task
constexpr float kEdgeSlack = 0.01f;  // in pixels: triangles overlap slightly, so that rounding opens no cracks
// largest depth jump that is bridged by a surface; tuned on walks through rooms with ground truth, as is the next
constexpr float kDeepestFold_m = 0.25f;
// the same where the far side is sky: a gap in a curtain's folds is rarely a window
constexpr float kDeepestGuess_m = 0.6f;
// times the jump: a bridge yields to the far surface of its own cell, allowing for a little slope
constexpr float kBridgeYields = 1.05f;
constexpr float kSkyRange = 0.5f * kFarthestRange;

// Directions of all pixels, from precomputed sines and cosines of rows and columns.
struct Directions {
    std::vector<Vec2f> column, row;  // (sine, cosine) of longitude and latitude

    explicit Directions(EquirectSize size)
        : column(static_cast<std::size_t>(size.width)), row(static_cast<std::size_t>(size.height)) {
        for (int x = 0; x < size.width; ++x) {
            const Vec3f d = direction_at(Vec2f{static_cast<float>(x) + 0.5f, 0.5f * static_cast<float>(size.height)},
                                         size);
            column[static_cast<std::size_t>(x)] = {d.x, d.z};
        }
        for (int y = 0; y < size.height; ++y) {
            const Vec3f d = direction_at(Vec2f{0.5f * static_cast<float>(size.width), static_cast<float>(y) + 0.5f},
                                         size);
            row[static_cast<std::size_t>(y)] = {d.y, d.z};
        }
    }
    Vec3f at(int x, int y) const {
        const Vec2f lon = column[static_cast<std::size_t>(x)], lat = row[static_cast<std::size_t>(y)];
        return {lat.y * lon.x, lat.x, lat.y * lon.y};
    }
};

struct Corner {
    Vec3f point;  // relative to the target position
    Vec2f pixel;  // its projection in the target
    Vec2f uv;     // position within the cell of four colors
};
// Four corner colors (top left, top right, bottom left, bottom right); within a surface also their outer neighbours,
// for cubic interpolation.
struct Colors {
    std::array<Vec3f, 4> corners;
    const WarpSource* around = nullptr;
    int x = 0, y = 0;
    Cover cover = Cover::front;  // a bridge between two surfaces: each color extends up to the middle
    // depth tolerance: a bridge yields to surfaces up to this far behind it, such as those that it joins
    float behind_m = 0;
};
bool is_bridge(Cover c) { return c == Cover::bridge || c == Cover::guess; }

// Sample positions of the target: every pixel's center, or the four quarters of some pixels.
struct Looks {
    EquirectSize size;
    Directions directions;  // per pixel; for quarters: of a picture of twice the size
    // for quarters: index of a pixel's four samples in the view, or -1; otherwise empty
    Image<std::int32_t> first_quarter;

    explicit Looks(EquirectSize s) : size(s), directions(s) {}
    explicit Looks(const ImageMask& marked)
        : size{marked.width, marked.height},
          directions({2 * marked.width, 2 * marked.height}),
          first_quarter(marked.width, marked.height, -1) {
        for (std::size_t i = 0; i < marked.size(); ++i)
            if (marked.pixels[i]) first_quarter.pixels[i] = std::exchange(count_, count_ + 4);
    }
    bool in_quarters() const { return !first_quarter.empty(); }
    // Size of the resulting view.
    EquirectSize view_size() const { return in_quarters() ? EquirectSize{count_, 1} : size; }

  private:
    std::int32_t count_ = 0;
};

struct Band {
    CoarseView& view;
    ImageF& order;  // depth buffer: range plus behind_m of what was drawn
    const Looks& looks;
    int begin, end;
};

// Rows and columns that a triangle may touch. Columns may lie outside the picture: they wrap.
struct Box {
    int x0, x1, y0, y1;
};
Box box_of(const Corner& a, const Corner& b, const Corner& c, const Looks& looks) {
    const EquirectSize size = looks.size;
    // margin: samples lie this far within their pixel
    const float early = looks.in_quarters() ? 0.76f : 0.51f, late = 1.f - early;
    const float w = static_cast<float>(size.width), h = static_cast<float>(size.height);
    const auto near_a = [&](float x) {
        return x - a.pixel.x > 0.5f * w ? x - w : a.pixel.x - x > 0.5f * w ? x + w : x;
    };
    const float bx = near_a(b.pixel.x), cx = near_a(c.pixel.x);
    const float x0 = std::min({a.pixel.x, bx, cx}), x1 = std::max({a.pixel.x, bx, cx});
    float y0 = std::min({a.pixel.y, b.pixel.y, c.pixel.y}), y1 = std::max({a.pixel.y, b.pixel.y, c.pixel.y});
    // A straight edge curves towards the pole; a triangle may even contain the pole.
    const float turn = (x1 - x0) / w;
    const float bulge = turn * turn * h * 2.f;
    if (y0 < 0.5f * h) y0 -= bulge;
    if (y1 > 0.5f * h) y1 += bulge;
    if (turn > 0.25f) {
        if (y0 < 0.3f * h) y0 = 0;
        if (y1 > 0.7f * h) y1 = h;
        return {0, size.width - 1, static_cast<int>(std::floor(y0 - early)), static_cast<int>(std::ceil(y1 - late))};
    }
    return {static_cast<int>(std::ceil(x0 - early)), static_cast<int>(std::floor(x1 - late)),
            static_cast<int>(std::ceil(y0 - early)), static_cast<int>(std::floor(y1 - late))};
}

// Catmull-Rom weights of the four pixels around a position t between the middle two.
std::array<float, 4> cubic_weights(float t) {
    return {t * (-0.5f + t * (1.f - 0.5f * t)), 1.f + t * t * (-2.5f + 1.5f * t), t * (0.5f + t * (2.f - 1.5f * t)),
            t * t * (-0.5f + 0.5f * t)};
}

// Five pixels of three channels plus padding; only the first four pixels of sums are used.
using Lanes = float __attribute__((vector_size(64)));

Vec3f cubic_in_cell(const ImageColor& image, int x, int y, const std::array<float, 4>& wu,
                    const std::array<float, 4>& wv) {
    const auto w = static_cast<std::size_t>(image.width),
               first = static_cast<std::size_t>(y - 1) * w + static_cast<std::size_t>(x - 1);
    Vec3f sum;
    if (x >= 1 && x + 2 < image.width && first + 3 * w + 6 <= image.size()) [[likely]] {
        Lanes rows{};
        for (std::size_t j = 0; j < 4; ++j) {
            Lanes line;
            std::memcpy(&line, static_cast<const void*>(&image.pixels[first + j * w]), sizeof line);
            rows += line * wv[j];
        }
        for (int i = 0; i < 4; ++i)
            sum += Vec3f{rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]} * wu[static_cast<std::size_t>(i)];
    } else {
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                sum += image.at(wrap_column(x - 1 + i, image.width), y - 1 + j) *
                       (wu[static_cast<std::size_t>(i)] * wv[static_cast<std::size_t>(j)]);
    }
    return {std::max(0.f, sum.x), std::max(0.f, sum.y), std::max(0.f, sum.z)};
}

// Bicubic within a surface: bilinear interpolation would make warped panoramas visibly softer.
Vec3f color_in_cell(const Colors& c, float u, float v) {
    if (c.around) return cubic_in_cell(c.around->color, c.x, c.y, cubic_weights(u), cubic_weights(v));
    if (is_bridge(c.cover)) return c.corners[(u > 0.5f ? 1 : 0) + (v > 0.5f ? 2 : 0)];
    return lerp(lerp(c.corners[0], c.corners[1], u), lerp(c.corners[2], c.corners[3], u), v);
}

// A pixel's ray d hits the triangle if the three volumes d . (P_j x P_k) have the same sign.
void draw(const Band& band, const Corner& a, const Corner& b, const Corner& c, const Colors& colors,
          std::int16_t plane) {
    const Looks& looks = band.looks;
    const EquirectSize size = looks.size;
    const Box box = box_of(a, b, c, looks);
    const int y0 = std::max(box.y0, band.begin), y1 = std::min(box.y1, band.end - 1);
    if (y0 > y1 || box.x0 > box.x1) return;
    const Vec3f na = cross(b.point, c.point), nb = cross(c.point, a.point), nc = cross(a.point, b.point);
    const float volume = dot(a.point, na);
    if (volume == 0.f || !std::isfinite(volume)) return;
    const float sign = volume > 0 ? 1.f : -1.f;
    const auto look = [&](Vec3f d, std::size_t i) {
        const float ea = dot(d, na) * sign, eb = dot(d, nb) * sign, ec = dot(d, nc) * sign;
        const float sum = ea + eb + ec;
        const float slack = -kEdgeSlack * sum;
        if (!(sum > 0.f) || ea < slack || eb < slack || ec < slack) return;
        const float t = volume * sign / sum;
        float& range = band.view.range.pixels[i];
        float& order = band.order.pixels[i];
        if (!(t + colors.behind_m < order) || (is_bridge(colors.cover) && sign < 0)) return;
        if (colors.cover == Cover::guess && range < kSkyRange && band.view.cover.pixels[i] != Cover::guess) return;
        range = t;
        order = t + colors.behind_m;
        const Vec2f uv = (a.uv * ea + b.uv * eb + c.uv * ec) * (1.f / sum);
        band.view.color.pixels[i] = color_in_cell(colors, std::clamp(uv.x, 0.f, 1.f), std::clamp(uv.y, 0.f, 1.f));
        band.view.plane.pixels[i] = plane;
        band.view.cover.pixels[i] = sign > 0 ? colors.cover : Cover::back;
    };
    for (int y = y0; y <= y1; ++y)
        for (int column = box.x0; column <= box.x1; ++column) {
            const int x = column < 0 ? column + size.width : column >= size.width ? column - size.width : column;
            if (!looks.in_quarters()) {
                look(looks.directions.at(x, y),
                     static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x));
                continue;
            }
            const std::int32_t first = looks.first_quarter.at(x, y);
            if (first < 0) continue;
            for (int k = 0; k < 4; ++k)
                look(looks.directions.at(2 * x + k % 2, 2 * y + k / 2), static_cast<std::size_t>(first + k));
        }
}

// A source transformed to the target: corner positions, and the range of target rows of each row of cells.
struct Placed {
    const WarpSource& source;
    EquirectSize source_size, size;
    Vec3f shift;  // source position relative to the target
    Image<Vec3f> point;
    Image<Vec2f> pixel;
    std::vector<Vec2f> rows;  // minimum and maximum target row of a source row's corners
    Directions directions;

    Placed(const WarpSource& s, EquirectSize target, Vec3f position)
        : source(s),
          source_size{s.color.width, s.color.height},
          size(target),
          shift(s.position - position),
          point(s.color.width, s.color.height),
          pixel(s.color.width, s.color.height),
          rows(static_cast<std::size_t>(s.color.height)),
          directions(source_size) {
        parallel_for(source_size.height, 16, [&](std::int64_t begin, std::int64_t end) {
            for (int y = static_cast<int>(begin); y < end; ++y) place_row(y);
        });
    }
    void place_row(int y) {
        Vec2f span{1e9f, -1e9f};
        for (int x = 0; x < source_size.width; ++x) {
            if (!used(x, y)) continue;
            point.at(x, y) = shift + directions.at(x, y) / source.inverse_range.at(x, y);
            pixel.at(x, y) = pixel_of_direction(point.at(x, y), size);
            span = {std::min(span.x, pixel.at(x, y).y), std::max(span.y, pixel.at(x, y).y)};
        }
        rows[static_cast<std::size_t>(y)] = span;
    }
    bool used(int x, int y) const { return source.used.empty() || source.used.at(x, y); }

    Corner corner(int x, int y, Vec2f uv) const { return {point.at(x, y), pixel.at(x, y), uv}; }
    Corner corner_at(Vec2f at, float inverse, Vec2f uv) const {
        const Vec3f p = shift + direction_at(at, source_size) / inverse;
        return {p, pixel_of_direction(p, size), uv};
    }
};

// Gradient of the inverse range at a pixel, from neighbours on the same surface.
Vec2f slope_at(const WarpSource& s, int x, int y) {
    const int w = s.color.width, h = s.color.height;
    const float q = s.inverse_range.at(x, y);
    const auto used = [&](int x1, int y1) { return s.used.empty() || s.used.at(x1, y1); };
    const int left = wrap_column(x - 1, w), right = wrap_column(x + 1, w);
    float before = 0, after = 0;
    bool has_before = !(s.cuts.at(left, y) & kCutRight) && used(left, y),
         has_after = !(s.cuts.at(x, y) & kCutRight) && used(right, y);
    if (has_before) before = q - s.inverse_range.at(left, y);
    if (has_after) after = s.inverse_range.at(right, y) - q;
    // The smaller of two slopes: at a crease, the larger one would extrapolate outward.
    const auto choose = [](bool b, float vb, bool a, float va) {
        if (a && b) return va * vb <= 0 ? 0.f : std::fabs(va) < std::fabs(vb) ? va : vb;
        return a ? va : b ? vb : 0.f;
    };
    Vec2f slope;
    slope.x = choose(has_before, before, has_after, after);
    has_before = y > 0 && !(s.cuts.at(x, y - 1) & kCutDown) && used(x, y - 1);
    has_after = y + 1 < h && !(s.cuts.at(x, y) & kCutDown) && used(x, y + 1);
    if (has_before) before = q - s.inverse_range.at(x, y - 1);
    if (has_after) after = s.inverse_range.at(x, y + 1) - q;
    slope.y = choose(has_before, before, has_after, after);
    return slope;
}

// A cell crossed by silhouettes. Its four pixels are numbered as in Colors; positions in the cell are 0 to 1.
struct CutCell {
    float top = 0.5f, bottom = 0.5f, left = 0.5f,
          right = 0.5f;        // positions on the cell's four sides where the parts of two pixels meet
    Vec2f middle{0.5f, 0.5f};  // where all parts meet
};

// Position of the cut between two pixels, measured from the first. An object one pixel wide is cut on both sides; its
// missing coverage is divided between them.
float place_of_cut(const WarpSource& s, int x0, int y0, int x1, int y1) {
    if (s.share.empty()) return 0.5f;
    const int w = s.color.width;
    const auto share = [&](int x, int y) {
        const float own = own_share(s.share.at(x, y));
        const bool both = y0 == y1 ? s.cuts.at(x, y) & kCutRight && s.cuts.at(wrap_column(x - 1, w), y) & kCutRight
                                   : s.cuts.at(x, y) & kCutDown && y > 0 && s.cuts.at(x, y - 1) & kCutDown;
        return both ? 0.5f * (1.f + own) : own;
    };
    return std::clamp(0.5f + share(x0, y0) - share(x1, y1), 0.f, 1.f);
}

CutCell cut_cell(const WarpSource& s, int x, int y) {
    const int r = wrap_column(x + 1, s.color.width);
    const auto cut = [&](int x0, int y0, int x1, int y1) {
        const bool used = s.used.empty() || (s.used.at(x0, y0) && s.used.at(x1, y1));
        return used && s.cuts.at(x0, y0) & (y0 == y1 ? kCutRight : kCutDown);
    };
    CutCell cell;
    Vec2f sum;
    int count = 0;
    const auto met = [&](Vec2f place) { sum = sum + place, ++count; };
    if (cut(x, y, r, y)) met({cell.top = place_of_cut(s, x, y, r, y), 0.f});
    if (cut(x, y + 1, r, y + 1)) met({cell.bottom = place_of_cut(s, x, y + 1, r, y + 1), 1.f});
    if (cut(x, y, x, y + 1)) met({0.f, cell.left = place_of_cut(s, x, y, x, y + 1)});
    if (cut(r, y, r, y + 1)) met({1.f, cell.right = place_of_cut(s, r, y, r, y + 1)});
    if (count >= 2)
        // a single silhouette crosses the cell in a straight line
        cell.middle = sum * (1.f / static_cast<float>(count));
    return cell;
}

// At a silhouette each pixel keeps its own part of the cell: a piece of its tangent plane in its own color.
void draw_part(const Band& band, const Placed& placed, int x, int y, int cell_x, int cell_y, bool right, bool below,
               const CutCell& cell) {
    const WarpSource& s = placed.source;
    const float q = s.inverse_range.at(x, y);
    const Vec2f slope = slope_at(s, x, y), own{right ? 1.f : 0.f, below ? 1.f : 0.f};
    const auto at = [&](Vec2f place) {
        const Vec2f o = place - own;
        const float inverse = std::clamp(q + slope.x * o.x + slope.y * o.y, 0.8f * q, 1.25f * q);
        return placed.corner_at(
            {static_cast<float>(cell_x) + 0.5f + place.x, static_cast<float>(cell_y) + 0.5f + place.y}, inverse,
            {0.5f, 0.5f});
    };
    const Corner a = at(own), b = at({below ? cell.bottom : cell.top, own.y}), c = at(cell.middle),
                 d = at({own.x, right ? cell.right : cell.left});
    const Vec3f color = s.color.at(x, y);
    const Colors colors{{color, color, color, color}};
    const std::int16_t plane = s.plane.empty() ? kNoPlane : s.plane.at(x, y);
    // In winding order, so that front faces stay front faces.
    if (right == below) {
        draw(band, a, b, c, colors, plane);
        draw(band, a, c, d, colors, plane);
    } else {
        draw(band, a, c, b, colors, plane);
        draw(band, a, d, c, colors, plane);
    }
}

// The surface spanned by four pixels.
void draw_whole(const Band& band, const Placed& placed, int x, int y, Cover cover, float jump_m) {
    const WarpSource& s = placed.source;
    const int r = wrap_column(x + 1, s.color.width);
    const Corner a = placed.corner(x, y, {0, 0}), b = placed.corner(r, y, {1, 0}), c = placed.corner(x, y + 1, {0, 1}),
                 d = placed.corner(r, y + 1, {1, 1});
    Colors colors{{}, nullptr, x, y, cover, kBridgeYields * jump_m};
    if (cover == Cover::front && !s.inside.empty() && s.inside.at(x, y)) colors.around = &s;
    else colors.corners = {s.color.at(x, y), s.color.at(r, y), s.color.at(x, y + 1), s.color.at(r, y + 1)};
    const std::int16_t plane = s.plane.empty() ? kNoPlane : s.plane.at(x, y);
    draw(band, a, b, c, colors, plane);
    draw(band, b, d, c, colors, plane);
}

// A jump no deeper than a fold or a frame is most likely spanned by a surface, which then shows in the gap instead of
// the background.
float jump_in_cell(const WarpSource& s, int x, int y) {
    const int r = wrap_column(x + 1, s.color.width);
    const auto [low, high] = std::minmax({s.inverse_range.at(x, y), s.inverse_range.at(r, y),
                                          s.inverse_range.at(x, y + 1), s.inverse_range.at(r, y + 1)});
    return 1.f / low - 1.f / high;
}

// Conservative test whether the cell touches the band; its edges curve towards the poles as in box_of.
bool touches(const Band& band, const Placed& placed, int x, int r, int y) {
    const Vec2f a = placed.pixel.at(x, y), b = placed.pixel.at(r, y), c = placed.pixel.at(x, y + 1),
                d = placed.pixel.at(r, y + 1);
    const float turn = (std::max({a.x, b.x, c.x, d.x}) - std::min({a.x, b.x, c.x, d.x})) /
                       static_cast<float>(placed.size.width);
    if (turn > 0.25f) return true;
    const float margin = 1.f + 2.f * turn * turn * static_cast<float>(placed.size.height);
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y, d.y});
    return bottom + margin >= static_cast<float>(band.begin) && top - margin <= static_cast<float>(band.end);
}

// `guesses`: draws only the bridges over deeper jumps, which must wait until all surfaces are drawn.
void draw_cell(const Band& band, const Placed& placed, int x, int y, bool guesses) {
    const WarpSource& s = placed.source;
    const int r = x + 1 == s.color.width ? 0 : x + 1;
    const bool u00 = placed.used(x, y), u10 = placed.used(r, y), u01 = placed.used(x, y + 1),
               u11 = placed.used(r, y + 1);
    if (!(u00 || u10 || u01 || u11)) return;
    const bool whole = u00 && u10 && u01 && u11 && !(s.cuts.at(x, y) & (kCutRight | kCutDown)) &&
                       !(s.cuts.at(r, y) & kCutDown) && !(s.cuts.at(x, y + 1) & kCutRight);
    if (whole) {
        if (!guesses && touches(band, placed, x, r, y)) draw_whole(band, placed, x, y, Cover::front, 0);
        return;
    }
    const float jump = u00 && u10 && u01 && u11 ? jump_in_cell(s, x, y) : kFarthestRange;
    if (guesses) {
        if (jump >= kDeepestFold_m && jump < kDeepestGuess_m) draw_whole(band, placed, x, y, Cover::guess, jump);
        return;
    }
    const CutCell cell = cut_cell(s, x, y);
    if (u00) draw_part(band, placed, x, y, x, y, false, false, cell);
    if (u10) draw_part(band, placed, r, y, x, y, true, false, cell);
    if (u01) draw_part(band, placed, x, y + 1, x, y, false, true, cell);
    if (u11) draw_part(band, placed, r, y + 1, x, y, true, true, cell);
    if (jump < kDeepestFold_m) draw_whole(band, placed, x, y, Cover::bridge, jump);
}

// Closes the hole at the pole: a fan from the outermost row to its mean.
void draw_cap(const Band& band, const Placed& placed, bool top) {
    const WarpSource& s = placed.source;
    const int w = s.color.width, y = top ? 0 : s.color.height - 1;
    Vec3f color;
    float inverse = 0;
    for (int x = 0; x < w; ++x) {
        if (!placed.used(x, y)) return;
        color += s.color.at(x, y) / static_cast<float>(w);
        inverse += s.inverse_range.at(x, y) / static_cast<float>(w);
    }
    const Corner pole = placed.corner_at({0.5f * static_cast<float>(w), top ? 0.f : static_cast<float>(s.color.height)},
                                         inverse, {0.5f, 1.f});
    for (int x = 0; x < w; ++x) {
        const int r = wrap_column(x + 1, w);
        const Colors colors{{s.color.at(x, y), s.color.at(r, y), color, color}};
        const Corner a = placed.corner(x, y, {0, 0}), b = placed.corner(r, y, {1, 0});
        const std::int16_t plane = s.plane.empty() ? kNoPlane : s.plane.at(x, y);
        if (top) draw(band, b, a, pole, Colors{{colors.corners[1], colors.corners[0], color, color}}, plane);
        else draw(band, a, b, pole, colors, plane);
    }
}

void draw_source(const Band& band, const Placed& placed, bool guesses) {
    const int h = placed.source_size.height;
    const float margin = 0.06f * static_cast<float>(placed.size.height);
    const auto touches = [&](float low, float high) {
        return high + margin >= static_cast<float>(band.begin) && low - margin <= static_cast<float>(band.end);
    };
    for (int y = 0; y + 1 < h; ++y) {
        const Vec2f a = placed.rows[static_cast<std::size_t>(y)], b = placed.rows[static_cast<std::size_t>(y) + 1];
        if (!touches(std::min(a.x, b.x), std::max(a.y, b.y))) continue;
        for (int x = 0; x < placed.source_size.width; ++x) draw_cell(band, placed, x, y, guesses);
    }
    if (guesses) return;
    draw_cap(band, placed, true);
    draw_cap(band, placed, false);
}

// Render target into which sources are drawn one after the other.
class Drawing {
  public:
    Drawing(Looks looks, Vec3f position) : looks_(std::move(looks)), position_(position) {
        const auto [w, h] = looks_.view_size();
        view_ = {ImageColor(w, h), ImageF(w, h, std::numeric_limits<float>::infinity()),
                 Image<std::int16_t>(w, h, kNoPlane), Image<Cover>(w, h, Cover::hole)};
        order_ = view_.range;
    }
    void add(const WarpSource& source) {
        const Placed placed(source, looks_.size, position_);
        draw_all(placed, false);
        if (source.used.empty()) draw_all(placed, true);
    }
    void add(const PackedSource& source) {
        source.unpack(unpacked_);
        add(unpacked_);
    }
    CoarseView finish() {
        for (float& range : view_.range.pixels)
            if (range > kSkyRange) range = std::numeric_limits<float>::infinity();
        return std::move(view_);
    }

  private:
    void draw_all(const Placed& placed, bool guesses) {
        parallel_for(looks_.size.height, kBandRows, [&](std::int64_t begin, std::int64_t end) {
            draw_source({view_, order_, looks_, static_cast<int>(begin), static_cast<int>(end)}, placed, guesses);
        });
    }

    Looks looks_;
    Vec3f position_;
    CoarseView view_;
    ImageF order_;
    WarpSource unpacked_;
};

template <class Source>
CoarseView drawn(const std::vector<Source>& sources, Looks looks, Vec3f position) {
    Drawing drawing(std::move(looks), position);
    for (const Source& source : sources) drawing.add(source);
    return drawing.finish();
}

}  // namespace

CoarseView coarse_view(const std::vector<WarpSource>& sources, EquirectSize size, Vec3f position) {
    return drawn(sources, Looks(size), position);
}
CoarseView coarse_view(const std::vector<PackedSource>& sources, EquirectSize size, Vec3f position) {
    return drawn(sources, Looks(size), position);
}
CoarseView quarters_view(const std::vector<WarpSource>& sources, const ImageMask& marked, Vec3f position) {
    return drawn(sources, Looks(marked), position);
}
CoarseView quarters_view(const std::vector<PackedSource>& sources, const ImageMask& marked, Vec3f position) {
    return drawn(sources, Looks(marked), position);
}

}  // namespace fastscene
