#include "fastscene/walk/repeats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "fastscene/base/random.h"

namespace fastscene {
namespace {

// metres per pixel of the coarse picture on which motions are searched, before refinement
constexpr float kCell_m = 0.04f;
constexpr int kMostCells =
    256;  // maximum side of the coarse picture, since the search is quadratic in it; halls get larger cells
constexpr float kAbout_m = 0.4f;  // metres: seen pixels this close to a hidden one are used to test motions
constexpr float kPattern =
    0.002f;  // minimum variance there (linear color, three channels): uniform surfaces need no motion
constexpr float kAgrees =
    0.4f;  // maximum residual, as a share of that variance; unrelated patches leave about twice the variance
constexpr std::size_t kFirst = 60;  // a motion that explains none of the first few queries is rejected
constexpr int kMostQuestions = 240, kMostWitnesses = 40, kMostMotions = 8;
constexpr int kMirrors = 90;            // mirror axis directions tested over 180 degrees
constexpr float kLeastOfWindow = 0.1f;  // minimum share of a window's pixels that must be comparable
// Each pixel is judged by the smallest window with enough comparable pixels; the larger the window, the better a motion
// must agree.
struct Window {
    float reach_m, agrees;
};
constexpr std::array<Window, 3> kWindows{{{0.3f, kAgrees}, {0.6f, 0.25f}, {1.2f, 0.15f}}};

// A translation, or a reflection with translation: images of the picture's axes and origin; pixels.
struct Motion {
    Vec2f x{1, 0}, y{0, 1}, shift;
    Vec2f operator()(Vec2f p) const { return x * p.x + y * p.y + shift; }
    bool mirrors() const { return x.x * y.y < x.y * y.x; }
};
Vec2f turned(Vec2f v, float by) {
    return {std::cos(by) * v.x - std::sin(by) * v.y, std::sin(by) * v.x + std::cos(by) * v.y};
}
// A reflection at an axis with this angle and distance from the origin.
Motion mirror(float axis, float distance) {
    return {turned({1, 0}, 2 * axis), turned({0, -1}, 2 * axis), turned({0, 2 * distance}, axis)};
}

// Colors with a mask of seen pixels.
struct SeenPart {
    ImageColor color;
    ImageMask hole;
    bool has(Vec2f p) const {
        return p.x >= 0 && p.y >= 0 && p.x < static_cast<float>(hole.width) && p.y < static_cast<float>(hole.height) &&
               !hole.at(static_cast<int>(p.x), static_cast<int>(p.y));
    }
    Vec3f at(Vec2f p) const { return color.at(static_cast<int>(p.x), static_cast<int>(p.y)); }
};

// Downsampled by `factor`; a pixel is seen if most of its source pixels are.
SeenPart shrunk(const SeenPart& fine, int factor) {
    const int w = fine.hole.width / factor, h = fine.hole.height / factor;
    SeenPart out{ImageColor(w, h), ImageMask(w, h)};
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            Vec3f sum;
            int count = 0;
            for (int j = y * factor; j < (y + 1) * factor; ++j)
                for (int i = x * factor; i < (x + 1) * factor; ++i)
                    if (!fine.hole.at(i, j)) sum += fine.color.at(i, j), ++count;
            out.hole.at(x, y) = 2 * count < factor * factor;
            if (count > 0) out.color.at(x, y) = sum * (1.f / static_cast<float>(count));
        }
    return out;
}

// A hidden position and the seen ones around it; cell centers, in cells.
struct Question {
    Vec2f place;
    std::vector<Vec2f> witnesses;
    float variance = 0;
};

float variance_of(const std::vector<Vec2f>& places, const SeenPart& seen) {
    Vec3f mean;
    float squares = 0;
    for (const Vec2f p : places) mean += seen.at(p), squares += dot(seen.at(p), seen.at(p));
    const float one = 1.f / static_cast<float>(places.size());
    return squares * one - dot(mean, mean) * one * one;
}

// Every n-th element of `all`, so that at most `most` remain.
template <class T>
std::vector<T> thinned(const std::vector<T>& all, int most) {
    std::vector<T> out;
    const std::size_t step = all.size() / static_cast<std::size_t>(most) + 1;
    for (std::size_t i = step / 2; i < all.size(); i += step) out.push_back(all[i]);
    return out;
}

std::vector<Question> questions_of(const SeenPart& seen, int reach) {
    const int w = seen.hole.width, h = seen.hole.height;
    std::vector<Question> questions;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (!seen.hole.at(x, y)) continue;
            Question q{{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, {}, 0};
            for (int j = std::max(0, y - reach); j <= std::min(h - 1, y + reach); ++j)
                for (int i = std::max(0, x - reach); i <= std::min(w - 1, x + reach); ++i)
                    if (!seen.hole.at(i, j))
                        q.witnesses.push_back({static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f});
            if (static_cast<int>(q.witnesses.size()) < kMostWitnesses) continue;
            q.witnesses = thinned(q.witnesses, kMostWitnesses);
            q.variance = variance_of(q.witnesses, seen);
            if (q.variance > kPattern) questions.push_back(std::move(q));
        }
    questions = thinned(questions, kMostQuestions);
    Random random(0, "walk/repeats");
    for (std::size_t i = questions.size(); i > 1; --i)
        std::swap(questions[i - 1], questions[static_cast<std::size_t>(random.index(static_cast<int>(i)))]);
    return questions;
}

// The residual of a motion around the query's position, as a share of the variance, at most kAgrees; kAgrees if it
// fails or has no data there.
float left_by(const Motion& motion, const Question& q, const SeenPart& seen) {
    if (!seen.has(motion(q.place))) return kAgrees;
    float sum = 0;
    int count = 0, gone = 0;
    for (const Vec2f p : q.witnesses) {
        const Vec2f other = motion(p);
        if (!seen.has(other)) {
            if (++gone * 2 > static_cast<int>(q.witnesses.size())) return kAgrees;
            continue;
        }
        const Vec3f d = seen.at(p) - seen.at(other);
        sum += dot(d, d);
        if (++count == kMostWitnesses / 4 && sum > q.variance * static_cast<float>(2 * count)) return kAgrees;
    }
    return std::min(kAgrees, sum / (q.variance * static_cast<float>(count)));
}

float gain_of(const Motion& motion, const std::vector<Question>& questions, const SeenPart& seen) {
    float gain = 0;
    for (const Question& q : questions) gain += kAgrees - left_by(motion, q, seen);
    return gain;
}

// Searches all whole-cell translations and all reflections: for each query, the motion that explains it and the most
// others.
std::vector<Motion> find_motions(const std::vector<Question>& questions, const SeenPart& seen) {
    struct Answer {
        float gain = 0;
        Motion motion;
    };
    std::vector<Answer> best(questions.size());
    std::vector<std::size_t> answered;
    const auto judge = [&](const Motion& motion) {
        float gain = 0;
        answered.clear();
        for (std::size_t i = 0; i < questions.size() && (i < kFirst || !answered.empty()); ++i)
            if (const float left = left_by(motion, questions[i], seen); left < kAgrees)
                gain += kAgrees - left, answered.push_back(i);
        for (const std::size_t i : answered)
            if (gain > best[i].gain) best[i] = {gain, motion};
    };
    const int w = seen.hole.width, h = seen.hole.height;
    for (int y = -h / 2; y <= h / 2; ++y)
        for (int x = -w / 2; x <= w / 2; ++x) judge({{1, 0}, {0, 1}, {static_cast<float>(x), static_cast<float>(y)}});
    const int longest = static_cast<int>(std::hypot(static_cast<float>(w), static_cast<float>(h)));
    for (int turn = 0; turn < kMirrors; ++turn)
        for (int k = -2 * longest; k <= 2 * longest; ++k)  // in half cells
            judge(mirror(kPi * static_cast<float>(turn) / kMirrors, 0.5f * static_cast<float>(k)));
    std::sort(best.begin(), best.end(), [](const Answer& a, const Answer& b) { return a.gain > b.gain; });
    std::vector<Motion> motions;
    for (std::size_t i = 0; i < best.size() && best[i].gain > 0 && static_cast<int>(motions.size()) < kMostMotions; ++i)
        if (i == 0 || best[i].gain != best[i - 1].gain) motions.push_back(best[i].motion);
    return motions;
}

// Refines a motion on a picture `factor` times finer, by a pattern search with halving steps.
Motion refined(Motion motion, std::vector<Question> questions, const SeenPart& fine, int factor) {
    const auto scale = static_cast<float>(factor);
    motion.shift = motion.shift * scale;
    for (Question& q : questions) {
        q.place = q.place * scale;
        for (Vec2f& p : q.witnesses) p = p * scale;
        std::erase_if(q.witnesses, [&](Vec2f p) { return !fine.has(p); });
        if (!q.witnesses.empty()) q.variance = variance_of(q.witnesses, fine);
    }
    std::erase_if(questions, [](const Question& q) {
        return static_cast<int>(q.witnesses.size()) < kMostWitnesses / 4 || q.variance < kPattern;
    });
    if (questions.empty()) return motion;
    const Vec2f pivot = questions[questions.size() / 2].place;
    float most = gain_of(motion, questions, fine);
    for (float step = 0.5f * scale; step >= 0.25f; step *= 0.5f)
        for (bool better = true; better;) {
            better = false;
            const float turn = motion.mirrors() ? step / 100 : 0;  // one step at a distance of a hundred pixels
            const std::array<std::array<float, 3>, 6> tries{
                {{step, 0, 0}, {-step, 0, 0}, {0, step, 0}, {0, -step, 0}, {0, 0, turn}, {0, 0, -turn}}};
            for (const auto& [x, y, by] : tries) {
                if (x == 0 && y == 0 && by == 0) continue;  // translations have no angle
                Motion other{turned(motion.x, by), turned(motion.y, by), {}};
                other.shift = motion(pivot) - other(pivot) + Vec2f{x, y};
                if (const float gain = gain_of(other, questions, fine); gain > most)
                    most = gain, motion = other, better = true;
            }
        }
    return motion;
}

// Constant-time box sums over pairs of a pixel and its image under the motion, both seen.
class Witnesses {
  public:
    Witnesses(const Motion& motion, const SeenPart& seen) : sums_(seen.hole.width + 1, seen.hole.height + 1) {
        for (int y = 0; y < seen.hole.height; ++y)
            for (int x = 0; x < seen.hole.width; ++x) {
                Sum s = sums_.at(x + 1, y) + sums_.at(x, y + 1) - sums_.at(x, y);
                const Vec2f p{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, other = motion(p);
                if (!seen.hole.at(x, y) && seen.has(other)) {
                    const Vec3f c = seen.at(p), d = c - seen.at(other);
                    s = s + Sum{{1, static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z),
                                 static_cast<double>(dot(c, c)), static_cast<double>(dot(d, d))}};
                }
                sums_.at(x + 1, y + 1) = s;
            }
    }
    // The motion's residual, as a share of the variance, within `reach` pixels; none with too few comparable pixels,
    // infinite without texture.
    std::optional<float> left(int x, int y, int reach) const {
        const int x0 = std::max(0, x - reach), y0 = std::max(0, y - reach),
                  x1 = std::min(sums_.width - 1, x + reach + 1), y1 = std::min(sums_.height - 1, y + reach + 1);
        const Sum s = sums_.at(x1, y1) - sums_.at(x0, y1) - sums_.at(x1, y0) + sums_.at(x0, y0);
        const double n = s[0];
        if (n < static_cast<double>(kLeastOfWindow) * (2 * reach + 1) * (2 * reach + 1)) return {};
        const double variance = s[4] / n - (s[1] * s[1] + s[2] * s[2] + s[3] * s[3]) / (n * n);
        return variance > static_cast<double>(kPattern) ? static_cast<float>(s[5] / n / variance)
                                                        : std::numeric_limits<float>::infinity();
    }

  private:
    struct Sum : std::array<double, 6> {  // count, color, squared color, squared difference
        friend Sum operator+(Sum a, const Sum& b) {
            for (std::size_t i = 0; i < 6; ++i) a[i] += b[i];
            return a;
        }
        friend Sum operator-(Sum a, const Sum& b) {
            for (std::size_t i = 0; i < 6; ++i) a[i] -= b[i];
            return a;
        }
    };
    Image<Sum> sums_;
};

}  // namespace

void fill_from_repeats(ImageColor& color, ImageMask& hole, float metres_per_pixel) {
    const SeenPart fine{color, hole};
    const int factor = std::max({1, static_cast<int>(std::lround(kCell_m / metres_per_pixel)),
                                 (std::max(hole.width, hole.height) - 1) / kMostCells + 1});
    const SeenPart coarse = shrunk(fine, factor);
    const std::vector<Question> questions = questions_of(
        coarse, static_cast<int>(kAbout_m / (metres_per_pixel * static_cast<float>(factor))));
    if (questions.empty()) return;
    const std::vector<Motion> motions = find_motions(questions, coarse);
    ImageF least(hole.width, hole.height);
    ImageMask window(hole.width, hole.height,
                     static_cast<std::uint8_t>(kWindows.size()));  // window size that the pixel was last judged by
    for (const Motion& coarse_motion : motions) {
        const Motion motion = refined(coarse_motion, questions, fine, factor);
        const Witnesses witnesses(motion, fine);
        for (int y = 0; y < hole.height; ++y)
            for (int x = 0; x < hole.width; ++x) {
                if (!fine.hole.at(x, y)) continue;
                std::uint8_t& judged = window.at(x, y);
                std::optional<float> left;
                std::uint8_t k = 0;
                for (; k < kWindows.size() && k <= judged; ++k)
                    if (left = witnesses.left(x, y, static_cast<int>(kWindows[k].reach_m / metres_per_pixel)); left)
                        break;
                if (!left) continue;
                if (k < judged) judged = k, least.at(x, y) = kWindows[k].agrees, hole.at(x, y) = 1;
                const Vec2f from = motion({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
                if (*left >= least.at(x, y) || !fine.has(from)) continue;
                least.at(x, y) = *left;
                color.at(x, y) = fine.at(from);
                hole.at(x, y) = 0;
            }
    }
}

}  // namespace fastscene
