#include "fastscene/scene/splat_edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "fastscene/base/check.h"
#include "fastscene/base/parallel.h"
#include "fastscene/scene/sh.h"

namespace fastscene {
namespace {

double determinant(const Mat3d& m) { return dot(m.row0, cross(m.row1, m.row2)); }
Mat3d negated(const Mat3d& m) { return {-m.row0, -m.row1, -m.row2}; }

Vec3f to_float(Vec3d v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
Vec3d to_double(Vec3f v) { return {v.x, v.y, v.z}; }

// Limits of drawable values: beyond them exp() and squares overflow float.
constexpr float kFarthest_m = 1e9f, kLargestLogScale = 20.f, kSmallestLogScale = -30.f, kLargestLogit = 30.f,
                kLargestSh = 1e4f;

bool within(float v, float limit) { return v >= -limit && v <= limit; }  // false for NaN
bool within(Vec3f v, float limit) { return within(v.x, limit) && within(v.y, limit) && within(v.z, limit); }

}  // namespace

Similarity inverse(const Similarity& s) {
    const Mat3d r = transpose(s.new_from_old);
    return {r, 1 / s.scale, (r * s.translation) * (-1 / s.scale)};
}

Similarity compose(const Similarity& c_from_b, const Similarity& b_from_a) {
    return {c_from_b.new_from_old * b_from_a.new_from_old, c_from_b.scale * b_from_a.scale,
            (c_from_b.new_from_old * b_from_a.translation) * c_from_b.scale + c_from_b.translation};
}

void transform(Splats& splats, const Similarity& s) {
    FASTSCENE_CHECK(s.scale > 0);
    const Mat3d& m = s.new_from_old;
    // An identity transform preserves every bit, including signs of zeros.
    if (m == Mat3d{} && s.scale == 1 && s.translation == Vec3d{}) return;
    // A Gaussian is point-symmetric, so -m acts on it like m; one of the two is a rotation.
    const Quatd turn = quaternion_of(determinant(m) < 0 ? negated(m) : m);
    const Quatf q{static_cast<float>(turn.w), static_cast<float>(turn.x), static_cast<float>(turn.y),
                  static_cast<float>(turn.z)};
    const ShTurn sh = sh_turn(m);
    const auto log_scale = static_cast<float>(std::log(s.scale));
    const auto k = static_cast<std::size_t>(splats.rest_coefficients());
    parallel_for(static_cast<std::int64_t>(splats.size()), 4096, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            splats.mean_m[i] = to_float((m * to_double(splats.mean_m[i])) * s.scale + s.translation);
            splats.rotation[i] = q * splats.rotation[i];
            splats.log_scale[i] += Vec3f{log_scale, log_scale, log_scale};
            for (std::size_t channel = 0; channel < 3; ++channel) {
                float* f = splats.sh_rest.data() + (i * 3 + channel) * k;
                std::array<double, kShFunctions - 1> turned{};
                for (std::size_t a = 0; a < k; ++a)
                    for (std::size_t b = 0; b < k; ++b) turned[a] += sh[a][b] * static_cast<double>(f[b]);
                for (std::size_t a = 0; a < k; ++a) f[a] = static_cast<float>(turned[a]);
            }
        }
    });
}

Splats chosen(const Splats& splats, const std::vector<std::uint32_t>& indices) {
    Splats out;
    out.sh_degree = splats.sh_degree, out.filter = splats.filter;
    out.resize(indices.size());
    const std::size_t rest = 3 * static_cast<std::size_t>(splats.rest_coefficients());
    for (std::size_t k = 0; k < indices.size(); ++k) {
        const std::size_t i = indices[k];
        out.mean_m[k] = splats.mean_m[i];
        out.log_scale[k] = splats.log_scale[i];
        out.rotation[k] = splats.rotation[i];
        out.opacity_logit[k] = splats.opacity_logit[i];
        out.sh0[k] = splats.sh0[i];
        std::copy_n(splats.sh_rest.begin() + static_cast<std::ptrdiff_t>(i * rest), rest,
                    out.sh_rest.begin() + static_cast<std::ptrdiff_t>(k * rest));
    }
    return out;
}

Splats cropped(const Splats& splats, Vec3f low, Vec3f high) {
    std::vector<std::uint32_t> inside;
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const Vec3f p = splats.mean_m[i];
        if (p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z)
            inside.push_back(static_cast<std::uint32_t>(i));
    }
    return chosen(splats, inside);
}

Splats opaque(const Splats& splats, float least) {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < splats.size(); ++i)
        if (1.f / (1.f + std::exp(-splats.opacity_logit[i])) >= least) kept.push_back(static_cast<std::uint32_t>(i));
    return chosen(splats, kept);
}

Splats strongest(const Splats& splats, std::size_t count) {
    std::vector<std::uint32_t> order(splats.size());
    std::iota(order.begin(), order.end(), 0u);
    if (count >= order.size()) return splats;
    std::vector<float> cover(splats.size());  // logarithmic: sizes span many orders of magnitude
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const Vec3f s = splats.log_scale[i];
        // ln of the sigmoid without overflow; the area is that of the two longest axes.
        const float logit = splats.opacity_logit[i],
                    log_opacity = logit < 0 ? logit - std::log1p(std::exp(logit)) : -std::log1p(std::exp(-logit));
        cover[i] = log_opacity + s.x + s.y + s.z - min_component(s);
    }
    std::nth_element(
        order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
        [&](std::uint32_t a, std::uint32_t b) { return cover[a] != cover[b] ? cover[a] > cover[b] : a < b; });
    order.resize(count);
    std::sort(order.begin(), order.end());
    return chosen(splats, order);
}

void reduce_sh(Splats& splats, int degree) {
    if (degree >= splats.sh_degree) return;
    const auto had = static_cast<std::size_t>(splats.rest_coefficients());
    splats.sh_degree = degree;
    const auto has = static_cast<std::size_t>(splats.rest_coefficients());
    for (std::size_t row = 0; row < splats.size() * 3; ++row)  // compacted in place
        std::copy_n(splats.sh_rest.begin() + static_cast<std::ptrdiff_t>(row * had), has,
                    splats.sh_rest.begin() + static_cast<std::ptrdiff_t>(row * has));
    splats.sh_rest.resize(splats.size() * 3 * has);
    splats.sh_rest.shrink_to_fit();
}

void trim_sh(Splats& splats) {
    const auto k = static_cast<std::size_t>(splats.rest_coefficients());
    std::size_t used = 0;  // index after the last nonzero coefficient of any channel
    for (std::size_t row = 0; row < splats.size() * 3 && used < k; ++row)
        for (std::size_t a = k; a > used; --a)
            if (splats.sh_rest[row * k + a - 1] != 0.f) used = a;
    reduce_sh(splats, used == 0 ? 0 : used <= 3 ? 1 : used <= 8 ? 2 : 3);
}

Cleaning clean(Splats& splats) {
    Cleaning done;
    const std::size_t rest = 3 * static_cast<std::size_t>(splats.rest_coefficients());
    std::vector<std::uint32_t> good;
    good.reserve(splats.size());
    for (std::size_t i = 0; i < splats.size(); ++i) {
        bool drawable = within(splats.mean_m[i], kFarthest_m) && within(splats.sh0[i], kLargestSh);
        for (std::size_t a = i * rest; a < (i + 1) * rest; ++a)
            drawable = drawable && within(splats.sh_rest[a], kLargestSh);
        bool repaired = false;
        Vec3f& s = splats.log_scale[i];
        for (std::size_t a = 0; a < 3; ++a) {
            drawable = drawable && s[a] <= kLargestLogScale;
            if (s[a] < kSmallestLogScale) s[a] = kSmallestLogScale, repaired = true;
        }
        float& logit = splats.opacity_logit[i];
        if (logit > kLargestLogit || logit < -kLargestLogit)
            logit = std::clamp(logit, -kLargestLogit, kLargestLogit), repaired = true;
        drawable = drawable && within(logit, kLargestLogit);
        Quatf& q = splats.rotation[i];
        const double length2 = static_cast<double>(q.w) * q.w + static_cast<double>(q.x) * q.x +
                               static_cast<double>(q.y) * q.y + static_cast<double>(q.z) * q.z;
        if (std::isfinite(length2) && (length2 < 1e-12 || length2 > 1e12)) {
            const double scale = length2 > 1e-60 ? 1 / std::sqrt(length2) : 0;
            const auto part = [&](float v) { return static_cast<float>(static_cast<double>(v) * scale); };
            q = scale > 0 ? Quatf{part(q.w), part(q.x), part(q.y), part(q.z)} : Quatf{};
            repaired = true;
        }
        drawable = drawable && std::isfinite(length2);
        if (drawable) good.push_back(static_cast<std::uint32_t>(i));
        done.repaired += drawable && repaired;
    }
    done.dropped = splats.size() - good.size();
    if (done.dropped) splats = chosen(splats, good);
    return done;
}

}  // namespace fastscene
