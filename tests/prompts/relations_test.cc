// Relations in the sentences of tests/data/relations.txt, judged from poses.
#include <gtest/gtest.h>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/rooms.h"
#include "judge.h"

namespace fastscene {
namespace {

TEST(Judge, TellsWhatHoldsFromPosesAlone) {
    const auto object = [](const char* kind, float x, float low, float z, Vec3f size, bool asked) {
        // Faces +z; heights grow against y.
        return Json{{"class", kind},
                    {"requested", asked},
                    {"size_m", {size.x, size.y, size.z}},
                    {"world_from_object", {{-1, 0, 0, x}, {0, -1, 0, -low}, {0, 0, 1, z}, {0, 0, 0, 1}}}};
    };
    Json room{{"bounds_m", {{"min", {-2, -3, -3}}, {"max", {2, 0, 3}}}}, {"objects", Json::array()}};
    room["objects"] = {object("desk", 0, 0, -2.6f, {1.4f, 0.75f, 0.7f}, true),
                       object("globe", 0.3f, 0.75f, -2.6f, {0.3f, 0.4f, 0.3f}, true),
                       object("plant", 1.7f, 0, 2.6f, {0.4f, 1, 0.4f}, true)};
    const auto holds = [&](const char* thing, const char* relation, const char* place) {
        judge::Demand demand{{thing}, 1, relation, {}, ""};
        if (place) demand.places.push_back({place});
        return judge::complaint(room, demand).empty();
    };
    EXPECT_TRUE(holds("globe", "on", "desk"));
    EXPECT_FALSE(holds("globe", "under", "desk"));
    EXPECT_FALSE(holds("plant", "on", "desk"));
    EXPECT_TRUE(holds("plant", "corner", nullptr));
    EXPECT_FALSE(holds("desk", "corner", nullptr));
    EXPECT_FALSE(holds("plant", "next", "desk"));
    EXPECT_FALSE(holds("plant", "above", "sofa")) << "there is none";
}

// One room per sentence; bench_relations makes more (docs/benchmarks.md).
TEST(Relations, MostStandWhereTheSentenceSays) {
    std::vector<std::string> complaints;
    const auto pack = FurniturePack::open(FurniturePack::default_folder(), {Assets::cc0, {}}, complaints);
    int asked = 0, kept = 0;
    std::string list;
    for (const judge::Sentence& sentence :
         judge::read_sentences(std::string(FASTSCENE_SOURCE_DIR) + "/tests/data/relations.txt")) {
        PromptSpec spec = understand_prompt(sentence.text, false, pack);
        const Json room = room_json(make_room(spec, {1, nullptr, {}}), {});
        for (const judge::Demand& demand : sentence.demands) {
            const std::string complaint = judge::complaint(room, demand);
            ++asked, kept += complaint.empty();
            if (!complaint.empty()) list += "\n  " + sentence.text + ": " + complaint;
        }
    }
    EXPECT_GE(asked, 110);
    EXPECT_GE(kept, 0.94 * asked) << kept << " of " << asked << list;
}

}  // namespace
}  // namespace fastscene
