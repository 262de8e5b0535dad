#include "fastscene/walk/vector_trig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fastscene/base/check.h"

namespace fastscene {
namespace {

// A few units in the last place: ten times the difference between instruction sets, which is one (1.1e-16 below 1,
// 4.4e-16 near pi).
constexpr double kLastDigits = 1.2e-15, kLastDigitsNearPi = 4.5e-15;

TEST(VectorTrig, AgreesWithTheScalarFunctionsForAnyCount) {
    for (const int count : {0, 1, 2, 3, 4, 5, 7, 8, 513}) {
        std::vector<double> angle, sine(static_cast<std::size_t>(count)), cosine(sine), turned(sine);
        for (int i = 0; i < count; ++i) angle.push_back((2.0 * i / std::max(1, count - 1) - 1) * std::numbers::pi);
        sines(angle, sine);
        cosines(angle, cosine);
        arc_tangents(sine, cosine, turned);
        for (std::size_t i = 0; i < angle.size(); ++i) {
            EXPECT_NEAR(sine[i], std::sin(angle[i]), kLastDigits) << angle[i];
            EXPECT_NEAR(cosine[i], std::cos(angle[i]), kLastDigits) << angle[i];
            EXPECT_NEAR(turned[i], std::atan2(sine[i], cosine[i]), kLastDigitsNearPi) << angle[i];
        }
    }
}

TEST(VectorTrig, ZerosInfinitiesAndNaNAreTheLibrarys) {
    const double endless = std::numeric_limits<double>::infinity(), none = std::nan("");
    for (const double y : {0.0, -0.0, 1.0, -2.0, 1e-300, endless, -endless, none})
        for (const double x : {0.0, -0.0, 1.0, -2.0, 1e300, endless, -endless, none}) {
            const std::vector<double> up{1, y}, ahead{1, x};
            std::vector<double> out(2);
            arc_tangents(up, ahead, out);
            const double wanted = std::atan2(y, x);
            if (std::isnan(wanted)) {
                EXPECT_TRUE(std::isnan(out[1])) << y << ' ' << x;
                continue;
            }
            EXPECT_NEAR(out[1], wanted, kLastDigitsNearPi) << y << ' ' << x;
            EXPECT_EQ(std::signbit(out[1]), std::signbit(wanted)) << y << ' ' << x;
        }
}

TEST(VectorTrig, LengthsMustAgree) {
    std::vector<double> two(2), three(3);
    EXPECT_THROW(sines(two, three), CheckFailed);
    EXPECT_THROW(arc_tangents(two, three, two), CheckFailed);
}

}  // namespace
}  // namespace fastscene
