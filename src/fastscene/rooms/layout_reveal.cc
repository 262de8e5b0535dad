// What was asked for is seen: small things stand on that side of a top which the camera sees, and nothing that nobody
// asked for hides them.
#include <algorithm>
#include <cmath>
#include <set>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_furnisher.h"
#include "fastscene/rooms/layout_sight.h"

namespace fastscene {
namespace {

constexpr float kWellSeen = 24.f;  // pixels of 512 x 256: no better place is looked for

// What a room keeps even when nobody asked for it.
bool makes_the_room(std::string_view kind) { return has_role(kind, Role::room_maker); }

}  // namespace

float Layout::show(int piece, Vec3f eye, bool anywhere) {
    Placed& p = placed_[static_cast<std::size_t>(piece)];
    const Placed before = p;
    const Sight sight(plan_, placed_);
    float best = sight.look(piece, eye).pixels;
    Placed best_pose = before;
    const float asked = as_asked(before, before.wish);
    std::vector<int> tops{before.on};
    for (int i = 0; anywhere && i < static_cast<int>(placed_.size()); ++i) {
        const Placed& top = placed_[static_cast<std::size_t>(i)];
        if (i != piece && i != before.on && top.on < 0 && !furnishing::is_seat(top.piece.kind) &&
            !top.piece.surfaces.empty())
            tops.push_back(i);
    }
    const auto far = [&](int i) { return length(placed_[static_cast<std::size_t>(i)].position - eye); };
    std::sort(tops.begin() + 1, tops.end(), [&](int a, int b) { return far(a) < far(b); });
    for (const int top : tops) {
        if (best >= kWellSeen) break;
        const Placed& a = placed_[static_cast<std::size_t>(top)];
        const Vec3f right = right_of(a.yaw), front = front_of(a.yaw), size = before.piece.size_m;
        for (const Surface& s : a.piece.surfaces) {
            const float slack_x = s.half.x - size.x / 2 - 0.01f, slack_z = s.half.y - size.z / 2 - 0.005f;
            if (slack_x < 0 || slack_z < 0) continue;
            for (const float u : {0.f, -0.5f, 0.5f, -1.f, 1.f})
                for (const float v : {1.f, 0.4f, -0.2f, -0.8f}) {
                    p.on = top;
                    p.yaw = a.yaw;
                    p.position = a.position + right * (s.center.x + u * slack_x) + front * (s.center.z + v * slack_z) +
                                 Vec3f{0, s.center.y, 0};
                    if (!free_on_top(p, piece) || as_asked(p, p.wish) < asked) continue;
                    if (const float seen = sight.look(piece, eye).pixels; seen > best)
                        best = seen, best_pose.position = p.position, best_pose.yaw = p.yaw, best_pose.on = top;
                }
        }
    }
    p.position = best_pose.position, p.yaw = best_pose.yaw, p.on = best_pose.on;
    return best;
}

void Layout::take_away(std::vector<int> pieces) {
    const auto bears = [&](int top, int i) {
        for (int up = i, steps = 0; up >= 0 && steps < 8; ++steps) {
            const Placed& p = placed_[static_cast<std::size_t>(up)];
            up = p.on >= 0 ? p.on : p.below;
            if (up == top) return true;
        }
        return false;
    };
    std::set<int> gone;
    for (const int top : pieces) {
        std::vector<int> whole{top};
        for (int i = 0; i < static_cast<int>(placed_.size()); ++i)
            if (bears(top, i)) whole.push_back(i);
        if (std::all_of(whole.begin(), whole.end(), [&](int i) {
                const Placed& p = placed_[static_cast<std::size_t>(i)];
                return p.wish.kind.empty() && !p.fixed;
            }))
            gone.insert(whole.begin(), whole.end());
    }
    if (gone.empty()) return;
    std::vector<int> now(placed_.size(), -1);
    std::vector<Placed> left;
    for (int i = 0; i < static_cast<int>(placed_.size()); ++i)
        if (!gone.contains(i))
            now[static_cast<std::size_t>(i)] = static_cast<int>(left.size()),
            left.push_back(std::move(placed_[static_cast<std::size_t>(i)]));
    for (Placed& p : left)
        for (int* index : {&p.on, &p.below, &p.with})
            if (*index >= 0) *index = now[static_cast<std::size_t>(*index)];
    placed_ = std::move(left);
    find_ways();
}

namespace furnishing {

// What was asked for on the floor is no background of a plant that nobody asked for.
void Furnisher::uncover(Vec3f eye) {
    constexpr float kShown = 0.5f;  // of a piece
    const Sight sight(l_.plan(), l_.placed());
    std::set<int> hiders;
    for (int i = 0; i < static_cast<int>(l_.placed().size()); ++i) {
        const Placed& p = at(i);
        if (p.wish.kind.empty() || p.piece.mount != Mount::floor || p.flat || p.on >= 0) continue;
        const Sight::View view = sight.look(i, eye);
        for (std::size_t k = 0; view.share < kShown && k < view.hiders.size() && k < 2; ++k)
            if (const int h = view.hiders[k]; at(h).wish.kind.empty() && has_role(kind_of(h), Role::movable))
                hiders.insert(h);
    }
    l_.take_away({hiders.begin(), hiders.end()});
}

void Furnisher::reveal() {
    if (l_.plan().joined) return;  // seen through its doorway alone
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
        const Vec3f eye = l_.viewpoint();
        if (round == 0) uncover(eye);
        const std::vector<int> unseen = l_.unseen(eye);
        if (unseen.empty()) return;
        for (const int i : unseen)
            if (at(i).on >= 0 && !at(i).fixed) l_.show(i, eye, round > 0 && at(i).wish.relation.empty());
        std::set<int> hiders;
        const std::vector<int> still = l_.unseen(eye);
        const Sight sight(l_.plan(), l_.placed());
        for (const int i : still)
            for (const int h : sight.look(i, eye).hiders)
                if (at(h).wish.kind.empty() && !makes_the_room(kind_of(h)) && h != at(i).on) hiders.insert(h);
        l_.take_away({hiders.begin(), hiders.end()});
    }
}

}  // namespace furnishing

}  // namespace fastscene
