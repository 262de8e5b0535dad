#include "fastscene/walk/hole_table.h"

#include <gtest/gtest.h>

#include "fastscene/scene/synthetic.h"
#include "fastscene/walk/published_warp.h"

namespace fastscene {
namespace {

constexpr EquirectSize kTableSize{512, 256};
const SyntheticWorld& world() {
    static const SyntheticWorld w = SyntheticWorld::furnished(SyntheticPaint::plain, SyntheticPaint::plain);
    return w;
}
float distance_in_world(Vec3f from, Vec3f direction) { return trace_synthetic(world(), from, direction).range; }

TEST(HoleTable, OurHolesAreTheTrueDisocclusions) {
    const Panorama first = render_synthetic(world(), {}, kTableSize, 1);
    const WarpSource source = make_warp_source(first.color, first.range, {}, {}, {});
    const float most = *std::max_element(first.range.pixels.begin(), first.range.pixels.end());
    // A short step opens strips narrower than a pixel; whether a grid point hits them depends on the silhouette's
    // sub-pixel position.
    struct {
        float share;
        double precision, recall;
    } const steps[] = {{0.02f, 0.9, 0.95}, {0.05f, 0.93, 0.99}, {0.15f, 0.98, 0.98}};
    for (const auto& step : steps)
        for (const Vec3f axis : {Vec3f{-1, 0, 0}, Vec3f{0, -1, 0}}) {
            const HoleTruth truth = hole_truth(source, axis * (step.share * most), distance_in_world);
            EXPECT_GE(truth.precision_near, step.precision) << step.share;
            EXPECT_GE(truth.recall_near, step.recall) << step.share;
        }
}

TEST(HoleTable, HasThePapersRowsAndOursLeavesFewerHoles) {
    const Panorama first = render_synthetic(world(), {}, {128, 64}, 1);
    const std::vector<HoleRow> rows = hole_table(first.range, {}, distance_in_world);
    ASSERT_EQ(rows.size(), 21u);
    for (const HoleRow& row : rows) {
        EXPECT_GT(row.published, 0.02);
        EXPECT_LE(row.ours, 0.5 * row.published) << row.axis << row.share;
        EXPECT_EQ(row.truth.has_value(), row.in_room);
    }
    EXPECT_GT(rows[0].published, rows[5].published);  // a longer step opens more
    const std::string text = hole_table_text(rows);
    EXPECT_NE(text.find("precision"), std::string::npos);
    const Json json = hole_table_json(rows);
    EXPECT_EQ(json.at("rows").size(), 21u);
    EXPECT_EQ(json.at("rows").at(1).at("paper").dump(), "0.587");
    for (const Json& row : json.at("rows"))
        for (const auto& [name, value] : row.items())
            if (value.is_number_float()) {
                EXPECT_LE(value.dump().size(), 14u) << name << value.dump();
            }
}

TEST(HoleTable, AnEmptyRoomHasNoneOfOurs) {
    SyntheticWorld empty = world();
    empty.boxes.clear();
    const Panorama first = render_synthetic(empty, {}, {256, 128}, 1);
    for (const HoleRow& row : hole_table(first.range, {}))
        if (row.in_room) {
            EXPECT_EQ(row.ours, 0) << row.axis << row.share;
        }
}

}  // namespace
}  // namespace fastscene
