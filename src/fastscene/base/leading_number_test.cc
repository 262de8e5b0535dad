#include "fastscene/base/leading_number.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>

namespace fastscene {
namespace {

TEST(LeadingNumber, ReadsWhatStandsFirst) {
    std::string_view text = " 1.5 -2e-3,+4";
    EXPECT_EQ(leading_number(text), 1.5);
    EXPECT_EQ(leading_number(text), -2e-3);
    EXPECT_EQ(text, ",+4");
    EXPECT_FALSE(leading_number(text));
    text.remove_prefix(1);
    EXPECT_EQ(leading_number(text), 4.0);
    EXPECT_TRUE(text.empty());
    EXPECT_FALSE(leading_number(text));
    for (const char* none : {"", "  ", "x1", "+-1", "+", "-", ".", "1e999"}) EXPECT_FALSE(number_in(none)) << none;
}

// In a program that speaks German, strtod reads "1.5" as 1.
TEST(LeadingNumber, DoesNotKnowTheLocale) {
    if (!std::setlocale(LC_NUMERIC, "de_DE.UTF-8")) GTEST_SKIP() << "the locale de_DE.UTF-8 is not installed";
    EXPECT_EQ(std::strtod("1.5", nullptr), 1.0);
    EXPECT_EQ(number_in("1.5"), 1.5);
    std::setlocale(LC_NUMERIC, "C");
}

}  // namespace
}  // namespace fastscene
