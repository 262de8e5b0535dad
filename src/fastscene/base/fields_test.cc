#include "fastscene/base/fields.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fastscene {
namespace {

struct SoupParams {
    int spoons = 4;
    float salt_g = 0.5f;
    std::string pot = "iron";
    bool lid = true;
};
template <class V>
void visit_fields(SoupParams& p, V&& v) {
    v("spoons", p.spoons, Bounds{1, 12}, "How many eat.");
    v("salt", p.salt_g, Bounds{0, 5}, "Grams of salt.");
    v("pot", p.pot, Choices{{"iron", "clay"}}, "What it cooks in.");
    v("lid", p.lid, "Whether it is covered.");
}

std::string complaint(const SoupParams& params, std::string_view section) {
    try {
        check_fields(section, params);
    } catch (const UsageError& e) {
        return e.what();
    }
    return "";
}

TEST(Fields, BecomeJsonInTheirOrder) {
    EXPECT_EQ(fields_json(SoupParams{}).dump(), R"({"spoons":4,"salt":0.5,"pot":"iron","lid":true})");
}

TEST(Fields, NumbersStandAsPeopleWroteThem) {
    SoupParams written{.salt_g = 0.2f};
    EXPECT_EQ(fields_json(written)["salt"].dump(), "0.2");
    SoupParams read;
    fields_from_json(fields_json(written), read);
    EXPECT_EQ(read.salt_g, 0.2f);
}

TEST(Fields, OutOfBoundsNamesFlagBoundsAndValue) {
    EXPECT_EQ(complaint({}, "soup"), "");
    EXPECT_EQ(complaint({.spoons = 13}, "soup"), "--soup-spoons: expected a number from 1 to 12, found 13");
    EXPECT_EQ(complaint({.spoons = 0}, ""), "--spoons: expected a number from 1 to 12, found 0");
    EXPECT_EQ(complaint({.pot = "glass"}, "soup"), "--soup-pot: expected one of iron, clay, found \"glass\"");
}

TEST(Fields, NaNIsOutOfBounds) { EXPECT_NE(complaint({.salt_g = std::nanf("")}, "soup"), ""); }

}  // namespace
}  // namespace fastscene
