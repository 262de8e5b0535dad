#include "fastscene/pipeline/same_room.h"

#include <gtest/gtest.h>

#include "fastscene/base/error.h"
#include "fastscene/depth/depth.h"
#include "fastscene/panorama/panorama.h"

namespace fastscene {
namespace {

TracedRoom room_of(std::uint64_t seed) {
    PromptSpec prompt = read_prompt("a cozy bedroom", PanoramaParams{});
    return TracedRoom(make_room(prompt, fastscene::Run{seed, nullptr, {}}));
}

TEST(SameRoom, ARangeMapTellsWhichRoomItIsOf) {
    const TracedRoom room = room_of(0), other = room_of(1);
    const ImageF range = exact_range(room, {128, 64}, {});
    EXPECT_NO_THROW(check_same_room(room, range, "out/bedroom"));
    try {
        check_same_room(other, range, "out/bedroom");
        FAIL() << "another room passed";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("out/bedroom"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace fastscene
