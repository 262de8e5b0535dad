// Rooms of held-back sentences by the layout's measures (docs/rooms.md).
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "fastscene/rooms/validate.h"

namespace fastscene {
namespace {

// Every `step`-th sentence.
std::vector<std::string> sentences(std::size_t first, std::size_t step) {
    std::ifstream file(std::string(FASTSCENE_SOURCE_DIR) + "/tests/data/layout_sentences.txt");
    std::vector<std::string> all, out;
    for (std::string line; std::getline(file, line);)
        if (!line.empty() && line[0] != '#') all.push_back(line);
    EXPECT_EQ(all.size(), 200u);
    for (std::size_t i = first; i < all.size(); i += step) out.push_back(all[i]);
    return out;
}

// The goals of all 200: nothing collides or is out of bounds, 99 % of the free floor is connected, 98 % of the doors
// and windows are clear, no form stands twice. Fifty have an opening or two to spare.
TEST(Layouts, RoomsOfHeldBackSentencesMeetTheGoals) {
    const CheckReport report = check_sentences(sentences(1, 4), 1, {.triangles = false, .measures = true},
                                               {0, nullptr, {}});
    const LayoutMeasures& m = report.measures;
    for (const CheckedRoom& room : report.measured)
        for (const LayoutFinding& f : room.measures.findings)
            EXPECT_TRUE(f.measure == "opening" || f.measure == "unreachable")
                << room.prompt << ": " << f.measure << ": " << f.text;
    EXPECT_TRUE(report.faulty.empty());
    EXPECT_EQ(m.rooms, 50);
    EXPECT_GT(m.pieces, 1000);
    EXPECT_EQ(m.colliding, 0);
    EXPECT_EQ(m.outside, 0);
    EXPECT_EQ(m.repeats, 0);
    EXPECT_GE(m.navigability / m.rooms, 0.99);
    EXPECT_GE(static_cast<double>(m.clear) / m.openings, 0.97);
}

}  // namespace
}  // namespace fastscene
