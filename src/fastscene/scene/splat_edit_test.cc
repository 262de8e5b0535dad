#include "fastscene/scene/splat_edit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fastscene/base/random.h"
#include "fastscene/scene/sh.h"

namespace fastscene {
namespace {

Splats random_splats(std::size_t count, int degree) {
    Random random(1, "splats");
    Splats s;
    s.sh_degree = degree;
    s.resize(count);
    const auto three = [&] { return Vec3f{random.normal(), random.normal(), random.normal()}; };
    for (std::size_t i = 0; i < count; ++i) {
        s.mean_m[i] = three();
        s.log_scale[i] = three() - Vec3f{3, 3, 3};
        s.rotation[i] = {random.normal(), random.normal(), random.normal(), random.normal()};
        s.opacity_logit[i] = random.normal();
        s.sh0[i] = three();
    }
    for (float& f : s.sh_rest) f = random.normal();
    return s;
}

Mat3d random_turn(Random& random) {
    return matrix_of(Quatd{random.normal(), random.normal(), random.normal(), random.normal()});
}
Mat3d covariance(const Splats& s, std::size_t i) {
    const Quatf q = s.rotation[i];
    const Mat3d r = matrix_of(Quatd{q.w, q.x, q.y, q.z});
    const auto scaled = [&](std::size_t a) { return r.column(a) * std::exp(static_cast<double>(s.log_scale[i][a])); };
    const Mat3d half = Mat3d::from_columns(scaled(0), scaled(1), scaled(2));
    return half * transpose(half);
}
double color(const Splats& s, std::size_t i, std::size_t channel, Vec3d d) {
    const auto basis = sh_basis(d);
    const auto k = static_cast<std::size_t>(s.rest_coefficients());
    double sum = static_cast<double>(s.sh0[i][channel]) * basis[0];
    for (std::size_t c = 0; c < k; ++c) sum += static_cast<double>(s.sh_rest[(i * 3 + channel) * k + c]) * basis[c + 1];
    return sum;
}

TEST(Sh, BasisIsOrthonormal) {
    // The mean of products over random directions is the identity over 4 pi.
    Random random(3, "directions");
    constexpr int kDirections = 200000;
    std::array<std::array<double, kShFunctions>, kShFunctions> sum{};
    for (int n = 0; n < kDirections; ++n) {
        const auto b = sh_basis(normalize(Vec3d{random.normal(), random.normal(), random.normal()}));
        for (std::size_t i = 0; i < kShFunctions; ++i)
            for (std::size_t j = 0; j < kShFunctions; ++j)
                sum[i][j] += b[i] * b[j] * 4 * 3.14159265358979 / kDirections;
    }
    for (std::size_t i = 0; i < kShFunctions; ++i)
        for (std::size_t j = 0; j < kShFunctions; ++j) EXPECT_NEAR(sum[i][j], i == j, 0.03) << i << ' ' << j;
}

// Sign tables used by other programs for the two half turns between formats.
TEST(Sh, HalfTurnsAreSignsAsOtherProgramsHaveThem) {
    const std::array<double, 15> about_x{-1, -1, 1, -1, 1, 1, -1, 1, -1, 1, -1, -1, 1, -1, 1};
    const std::array<double, 15> about_z{-1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1};
    const ShTurn x = sh_turn({{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}), z = sh_turn({{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}});
    for (std::size_t i = 0; i < 15; ++i)
        for (std::size_t j = 0; j < 15; ++j) {
            EXPECT_EQ(x[i][j], i == j ? about_x[i] : 0);
            EXPECT_EQ(z[i][j], i == j ? about_z[i] : 0);
        }
}

// Translation, rotation, scaling and reflection apply to each splat's shape and to its color from every side.
TEST(SplatEdit, TransformCarriesShapeAndColor) {
    Random random(2, "turns");
    for (const bool mirrored : {false, true}) {
        Similarity s{random_turn(random), 2.5, {1, -2, 3}};
        if (mirrored) s.new_from_old = s.new_from_old * Mat3d{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
        const Splats before = random_splats(20, 3);
        Splats after = before;
        transform(after, s);
        for (std::size_t i = 0; i < before.size(); ++i) {
            const Mat3d expected = s.new_from_old * covariance(before, i) * transpose(s.new_from_old),
                        found = covariance(after, i);
            for (std::size_t a = 0; a < 3; ++a)
                EXPECT_LT(length(expected.column(a) * 6.25 - found.column(a)), 1e-4 * length(found.column(0)) + 1e-6);
            const Vec3d p{before.mean_m[i].x, before.mean_m[i].y, before.mean_m[i].z},
                moved = (s.new_from_old * p) * 2.5 + s.translation;
            EXPECT_LT(length(moved - Vec3d{after.mean_m[i].x, after.mean_m[i].y, after.mean_m[i].z}), 1e-5);
            for (int k = 0; k < 10; ++k) {
                const Vec3d d = normalize(Vec3d{random.normal(), random.normal(), random.normal()});
                for (std::size_t channel = 0; channel < 3; ++channel)
                    EXPECT_NEAR(color(before, i, channel, d), color(after, i, channel, s.new_from_old * d), 1e-5);
            }
        }
        transform(after, inverse(s));
        for (std::size_t i = 0; i < before.sh_rest.size(); ++i) EXPECT_NEAR(after.sh_rest[i], before.sh_rest[i], 1e-5);
    }
}

TEST(SplatEdit, CropThinAndBands) {
    Splats s = random_splats(500, 3);
    for (const Vec3f p : cropped(s, {-1, -1, -1}, {1, 1, 0}).mean_m)
        EXPECT_TRUE(std::fabs(p.x) <= 1 && std::fabs(p.y) <= 1 && p.z >= -1 && p.z <= 0);
    const Splats few = strongest(s, 100);
    EXPECT_EQ(few.size(), 100u);
    EXPECT_EQ(few.sh_rest.size(), 4500u);
    EXPECT_EQ(strongest(s, 1000), s);
    const Splats whole = s;
    reduce_sh(s, 1);
    EXPECT_EQ(s.sh_rest.size(), 500u * 9);
    EXPECT_EQ(s.sh_rest[3], whole.sh_rest[15]);  // the first green one
    reduce_sh(s, 2);
    EXPECT_EQ(s.sh_degree, 1);
    Splats padded = whole;
    for (std::size_t row = 0; row < 1500; ++row)
        for (std::size_t k = 8; k < 15; ++k) padded.sh_rest[row * 15 + k] = 0;
    trim_sh(padded);
    EXPECT_EQ(padded.sh_degree, 2);
}

// Makes each number of a splat invalid in turn.
TEST(SplatEdit, CleaningLeavesOnlyWhatCanBeDrawn) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN(),
                tiny = 1e-42f;
    const Splats good = random_splats(3, 1);
    const auto slots = [](Splats& s) {
        std::vector<float*> all;
        for (std::size_t a = 0; a < 3; ++a) all.insert(all.end(), {&s.mean_m[1][a], &s.log_scale[1][a], &s.sh0[1][a]});
        all.insert(all.end(),
                   {&s.rotation[1].w, &s.rotation[1].x, &s.rotation[1].y, &s.rotation[1].z, &s.opacity_logit[1]});
        for (std::size_t k = 9; k < 18; ++k) all.push_back(&s.sh_rest[k]);
        return all;
    };
    Splats first = good;
    for (std::size_t n = 0; n < slots(first).size(); ++n)
        for (const float bad : {nan, inf, -inf, 3e38f, -3e38f, tiny}) {
            Splats s = good;
            *slots(s)[n] = bad;
            const Cleaning done = clean(s);
            EXPECT_EQ(s.size(), 3 - done.dropped);
            if (std::isnan(bad)) {
                EXPECT_EQ(done.dropped, 1u);
            }
            if (bad == tiny) {
                EXPECT_EQ(done.dropped, 0u);
            }
            for (std::size_t i = 0; i < s.size(); ++i) {
                EXPECT_TRUE(std::isfinite(dot(s.mean_m[i], s.mean_m[i])) &&
                            std::isfinite(std::exp(2 * s.log_scale[i].x)) && std::isfinite(s.opacity_logit[i]));
                const Quatf q = s.rotation[i];
                EXPECT_GT(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 0.f);
            }
        }
    Splats s = good;
    s.opacity_logit[0] = inf, s.log_scale[1].x = -inf, s.rotation[2] = {0, 0, 0, 0};
    const Cleaning done = clean(s);
    EXPECT_EQ(done.repaired, 3u);
    EXPECT_EQ(s.size(), 3u);
}

}  // namespace
}  // namespace fastscene
