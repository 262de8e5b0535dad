#include <gtest/gtest.h>

#include "fastscene/base/random.h"
#include "fastscene/math/rigid.h"
#include "fastscene/math/solve.h"

namespace fastscene {
namespace {

Quatd random_rotation(Random& r) {
    Quatd q{r.normal(), r.normal(), r.normal(), r.normal()};
    const double n = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {q.w / n, q.x / n, q.y / n, q.z / n};
}
Rigidd random_rigid(Random& r) { return {matrix_of(random_rotation(r)), {r.normal(), r.normal(), r.normal()}}; }
void expect_near(Vec3d a, Vec3d b) {
    EXPECT_NEAR(a.x, b.x, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    EXPECT_NEAR(a.z, b.z, 1e-9);
}

TEST(Rigid, InverseUndoesAndProductsAssociate) {
    Random r(1, "rigid");
    for (int i = 0; i < 100; ++i) {
        const Rigidd b_from_a = random_rigid(r), c_from_b = random_rigid(r), d_from_c = random_rigid(r);
        const Vec3d p{r.normal(), r.normal(), r.normal()};
        expect_near(inverse(b_from_a) * (b_from_a * p), p);
        expect_near((d_from_c * c_from_b * b_from_a) * p, d_from_c * (c_from_b * (b_from_a * p)));
    }
}

TEST(Quat, MatrixAndBackAndProductsAgree) {
    Random r(2, "quat");
    for (int i = 0; i < 200; ++i) {
        const Quatd a = random_rotation(r), b = random_rotation(r);
        const Vec3d v{r.normal(), r.normal(), r.normal()};
        expect_near(matrix_of(a * b) * v, matrix_of(a) * (matrix_of(b) * v));
        expect_near(matrix_of(quaternion_of(matrix_of(a))) * v, matrix_of(a) * v);
        EXPECT_GE(quaternion_of(matrix_of(a)).w, 0);
    }
}

TEST(Rotation, AboutAnAxisIsRightHanded) {
    const Vec3d x{1, 0, 0};
    expect_near(rotation_about(Vec3d{0, 0, 1}, M_PI / 2) * x, Vec3d{0, 1, 0});
}

TEST(Solve, WhatIsFoundSolvesTheEquationsAndNothingElseIsFound) {
    Random r(4, "solve");
    const auto any = [&r] { return Vec3d{r.normal(), r.normal(), r.normal()}; };
    for (int i = 0; i < 100; ++i) {
        const Mat3d m{any(), any(), any()};  // without any symmetry
        const Vec3d x = any();
        const auto found = solved(m, m * x, 1e-4);
        if (std::abs(dot(m.row0, cross(m.row1, m.row2))) <= 1e-4) continue;
        ASSERT_TRUE(found.has_value());
        expect_near(*found, x);
    }
    const Vec3d a = any(), b = any(), right = any();
    EXPECT_FALSE(solved(Mat3d{a, b, a * 2. - b}, right, 1e-12).has_value());
    EXPECT_FALSE(solved(Mat3d{a, b, {}}, right, 1e-12).has_value());
    EXPECT_FALSE(solved(Mat3d{a, b, {std::nan(""), 0, 0}}, right, 1e-12).has_value());
    EXPECT_EQ(solved(Mat3d{{0, 0, 2}, {1, 0, 0}, {0, 4, 0}}, Vec3d{6, 5, 8}, 1e-12), (Vec3d{5, 2, 3}));
}

TEST(Frame, IsOrthonormalAndRightHanded) {
    Random r(3, "frame");
    for (int i = 0; i < 100; ++i) {
        const Vec3f n = normalize(Vec3f{r.normal(), r.normal(), r.normal()});
        Vec3f s, t;
        make_frame(n, s, t);
        EXPECT_NEAR(dot(s, t), 0, 1e-5);
        EXPECT_NEAR(dot(s, n), 0, 1e-5);
        EXPECT_NEAR(dot(cross(s, t), n), 1, 1e-5);
    }
}

}  // namespace
}  // namespace fastscene
