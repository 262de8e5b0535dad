#include "fastscene/rooms/layout_wall_art.h"

#include <algorithm>
#include <optional>

#include "fastscene/rooms/furniture/wall/panels.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene::furnishing {
namespace {

// Interior designers fill a half to three quarters of a bare wall.
constexpr float kShare = 0.58f;
constexpr float kLeastStretch_m = 0.6f;
// From here on one picture of usual size is lost on the wall: a large one or several panels.
constexpr float kLongStretch_m = 1.6f, kForThree_m = 2.2f;

struct BareWall {
    int wall = 0;
    float from = 0, to = 0;  // metres along it
    float length() const { return to - from; }
    float middle() const { return (from + to) / 2; }
};

// The longest stretch on which a narrow picture could hang anywhere.
std::optional<BareWall> longest_bare_wall(const Layout& layout, const Piece& probe) {
    constexpr float kTry = 0.1f;
    const float half = probe.size_m.x / 2;
    std::optional<BareWall> best;
    for (int wall = 0; wall < 4; ++wall) {
        std::optional<BareWall> open;
        for (float u = half; u <= layout.plan().wall(wall).length - half; u += kTry) {
            if (!layout.can_hang_at(probe, wall, u)) {
                open.reset();
                continue;
            }
            if (!open) open = BareWall{wall, u - half, u + half};
            open->to = u + half;
            if (!best || open->length() > best->length()) best = open;
        }
    }
    return best;
}

class Art {
  public:
    Art(Layout& layout, const std::string& kind) : l_(layout), kind_(kind) {}

    void hang(int most) {
        PieceRequest narrow = l_.request(kind_);
        narrow.size_m = {0.3f, 0.6f, 0};
        const Piece probe = make_piece(narrow);
        for (int i = 0; i < most; ++i) {
            const auto bare = longest_bare_wall(l_, probe);
            if (!bare || bare->length() < kLeastStretch_m || !hang_on(*bare)) return;
        }
    }

  private:
    bool hang_on(const BareWall& bare) {
        const bool is_long = bare.length() >= kLongStretch_m, for_child = room_type(l_.spec().room).for_children;
        if (is_long && !for_child && l_.rng().chance(0.5f) && hang_panels(bare)) return true;
        const float w = is_long ? std::clamp(kShare * bare.length(), 0.9f, 1.4f)
                                : std::clamp(kShare * bare.length(), 0.35f, 0.8f);
        PieceRequest r = l_.request(kind_);
        r.size_m = {w, w * (w > 0.6f ? l_.rng().uniform(0.62f, 0.75f) : l_.rng().uniform(0.8f, 1.4f)), 0};
        if (for_child) r.pattern = picture_for_a_child(l_);
        return l_.hang_at(make_piece(r), bare.wall, bare.middle(), {}).has_value();
    }

    bool hang_panels(const BareWall& bare) {
        const int count = bare.length() >= kForThree_m ? 3 : 2;
        const float gap = furniture::kPanelGap_m, gaps = gap * static_cast<float>(count - 1),
                    w = std::clamp((kShare * bare.length() - gaps) / static_cast<float>(count), 0.35f, 0.6f);
        PieceRequest r = l_.request(kind_);
        r.size_m = {w, w * l_.rng().uniform(1.35f, 1.6f), 0};
        const std::size_t before = l_.mark();
        std::optional<int> first;
        for (int i = 0; i < count; ++i) {
            // From the left of who looks at the wall: along it, or against its direction.
            const WallFace face = l_.plan().wall(bare.wall);
            const Vec3f left = right_of(yaw_of(face.inward)) * -1.f;
            r.pattern = furniture::pattern_of({i, count});
            const float aside = (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1)) * (w + gap),
                        u = bare.middle() + (dot(left, face.along) < 0 ? aside : -aside);
            const auto panel = l_.hang_at(make_piece(r), bare.wall, u, {});
            if (!panel) {
                l_.undo(before);
                return false;
            }
            if (first) l_.join(*panel, *first);
            else first = panel;
        }
        return true;
    }

    Layout& l_;
    const std::string& kind_;
};

}  // namespace

void hang_art(Layout& layout, const std::string& kind, int most) { Art(layout, kind).hang(most); }

}  // namespace fastscene::furnishing
