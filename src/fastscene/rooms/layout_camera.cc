// Where the camera stands, and what it sees of what was asked for.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/layout_sight.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

constexpr float kWorthSeeing = 0.6f;  // of a piece that was asked for, in the score of a place for the camera
constexpr float kSeen = 16.f;         // pixels of 512 x 256, estimated from a few points: a mug on a table at 2.5 m

}  // namespace

// How many of the pieces that were asked for nothing can be seen of: other pieces' boxes stand before them.
int Layout::likely_hidden(Vec3f eye) const {
    int hidden = 0;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
        if (placed_[i].wish.kind.empty()) continue;
        const Footprint box = footprint_of(placed_[i]);
        const auto axes = axes_of(box);
        bool seen = false;
        for (const float along : {0.f, -0.7f, 0.7f})
            for (const float up : {0.95f, 0.5f}) {
                if (seen) break;
                const Vec2f at = box.center + axes[0] * (along * box.half.x);
                const Vec3f target{at.x, box.y0 + up * (box.y1 - box.y0), at.y};
                seen = true;
                for (std::size_t k = 0; k < placed_.size() && seen; ++k) {
                    if (k == i || placed_[k].flat || placed_[k].on == static_cast<int>(i) ||
                        placed_[i].on == static_cast<int>(k) || placed_[i].below == static_cast<int>(k))
                        continue;
                    seen = !passes(footprint_of(placed_[k]), eye, target);
                }
            }
        hidden += !seen;
    }
    return hidden;
}

std::vector<int> Layout::unseen(Vec3f eye) const {
    std::vector<int> out;
    if (std::all_of(placed_.begin(), placed_.end(), [](const Placed& p) { return p.wish.kind.empty(); })) return out;
    const Sight sight(plan_, placed_);
    for (int i = 0; i < static_cast<int>(placed_.size()); ++i)
        if (!placed_[static_cast<std::size_t>(i)].wish.kind.empty() && sight.look(i, eye).pixels < kSeen)
            out.push_back(i);
    return out;
}

// What stands in the room, as it is about the camera: where a piece reaches into the heights about the eyes (a bed with
// its head alone, a desk with its lamp), and where it only keeps the feet away.
struct Layout::Surroundings {
    struct Box {
        Footprint box;
        std::array<Vec2f, 2> axes;
    };
    std::vector<Box> tall, low;
};

// … from each level of the floor.
class Layout::Levels {
  public:
    explicit Levels(const Layout& layout) : layout_(layout) {
        for (const Platform& p : layout.plan_.platforms) highest_ = std::max(highest_, p.height);
    }
    Vec3f eye(float x, float z) const { return {x, layout_.plan_.floor_at({x, z}) + kEyeHeight, z}; }
    float ease_of(Vec3f eye) {
        // From among the upper rows one sees the tiers and what they rise to see; from the very last, a wall is near.
        constexpr float kOverlook = 2.5f, kUpper = 0.75f;
        const float floor = layout_.plan_.floor_at(flat(eye));
        const float over = highest_ > 0 ? std::min(floor / highest_, kUpper) / kUpper : 0.f;
        return layout_.ease_of(eye, things(floor)) + kOverlook * over;
    }
    const Surroundings& things(float floor) {
        const auto found = things_.find(floor);
        return found != things_.end() ? found->second
                                      : things_.emplace(floor, layout_.surroundings(floor)).first->second;
    }

  private:
    const Layout& layout_;
    float highest_ = 0;
    std::map<float, Surroundings> things_;
};

Layout::Surroundings Layout::surroundings(float floor) const {
    constexpr float kBall = 0.7f;  // about the eyes
    const float eyes = floor + kEyeHeight;
    Surroundings out;
    for (const Placed& p : placed_) {
        if (p.flat) continue;
        const Footprint whole = footprint_of(p);
        if (floor > 0 && whole.y1 < floor) continue;  // on a lower tier
        if (whole.y1 < eyes) out.low.push_back({whole, axes_of(whole)});
        if (whole.y0 >= eyes + kBall) continue;
        if (const auto tall = part_above(p, eyes - kBall)) out.tall.push_back({*tall, axes_of(*tall)});
    }
    return out;
}

float Layout::ease_of(Vec3f eye, const Surroundings& things) const {
    const Vec2f at = flat(eye);
    const float walls = plan_.wall_distance(at);
    float tall = plan_.air_around(eye), low = 1.f;
    for (const auto& [box, axes] : things.tall) tall = std::min(tall, distance_to(box, axes, at));
    for (const auto& [box, axes] : things.low) low = std::min(low, distance_to(box, axes, at));
    // Beyond 0.9 m more space from things is no gain, beyond 1.6 m from walls and doors: close by they fill half of the
    // picture and show nothing. The middle of the room shows most of it.
    float score = 3.f * std::min(tall, 0.9f) + 1.1f * std::min(walls, 1.6f) + 1.2f * std::min(low, 0.45f) -
                  0.35f * length(at);
    // A mezzanine is seen from before it.
    constexpr float kBeforeMezzanine = 2.4f;
    if (plan_.mezzanine.depth > 0) score -= 3.f * std::max(0.f, at.y - (plan_.mezzanine_edge() - kBeforeMezzanine));
    // Air around the eyes comes before all that may be seen, and behind a barrier of tables nobody stands.
    constexpr float kMustBeFree = 0.58f, kNoWall = 1.05f;
    score -= 1.6f * std::max(0.f, kNoWall - walls);
    if (tall < kMustBeFree) score -= 100.f * (kMustBeFree - tall) + 10.f;
    return score;
}

bool Layout::looks_along() const { return room_type(spec_.room).look_along && !plan_.joined; }

// In a corridor or an aisle: near this share of the depth, in the middle of what is free there.
Vec3f Layout::position_along(float share) const {
    constexpr float kAside_m = 0.6f, kAhead_m = 1.2f, kStep_m = 0.1f, kEnough_m = 0.6f;
    Levels levels(*this);
    const float from = plan_.depth * (share - 0.5f);
    Vec3f best = levels.eye(0, from);
    float best_score = -1e9f;
    for (float x = -kAside_m; x <= kAside_m; x += kStep_m)
        for (float z = from - kAhead_m; z <= from + kAhead_m; z += kStep_m) {
            const Vec2f at{x, z};
            const Vec3f eye = levels.eye(x, z);
            const Surroundings& things = levels.things(plan_.floor_at(at));
            float free = std::min(kEnough_m, plan_.wall_distance(at));
            for (const auto* boxes : {&things.tall, &things.low})
                for (const auto& [box, axes] : *boxes) free = std::min(free, distance_to(box, axes, at));
            const float score = 4.f * free - 0.5f * std::abs(x) - 0.3f * std::abs(z - from) -
                                kWorthSeeing * static_cast<float>(likely_hidden(eye));
            if (score > best_score) best_score = score, best = eye;
        }
    return best;
}

Vec3f Layout::camera_position() const {
    if (looks_along()) return position_along(*room_type(spec_.room).look_along);
    Levels levels(*this);
    Vec3f best = levels.eye(0, 0);
    float best_score = -1e9f;
    for (float x = -plan_.width / 2 + 0.6f; x <= plan_.width / 2 - 0.6f; x += 0.1f)
        for (float z = -plan_.depth / 2 + 0.6f; z <= plan_.depth / 2 - 0.6f; z += 0.1f) {
            const Vec3f eye = levels.eye(x, z);
            float score = levels.ease_of(eye);
            if (score <= best_score) continue;
            if (!ways_.reaches({x, z})) score -= 50.f;
            if (score <= best_score) continue;
            score -= kWorthSeeing * static_cast<float>(likely_hidden(eye));
            if (score > best_score) best_score = score, best = eye;
        }
    return best;
}

// The place by boxes, if all is seen from there; else the best of places some steps apart.
Vec3f Layout::viewpoint() const {
    if (looks_along()) return camera_position();
    Vec3f best = camera_position();
    const std::size_t hidden = unseen(best).size();
    if (hidden == 0) return best;
    Levels levels(*this);
    float best_score = levels.ease_of(best) - kWorthSeeing * static_cast<float>(hidden);
    constexpr float kStep = 0.4f;
    std::vector<std::pair<float, Vec3f>> places;
    for (float x = -plan_.width / 2 + 0.6f; x <= plan_.width / 2 - 0.6f; x += kStep)
        for (float z = -plan_.depth / 2 + 0.6f; z <= plan_.depth / 2 - 0.6f; z += kStep)
            if (const float score = levels.ease_of(levels.eye(x, z)); score > best_score)
                places.push_back({score, levels.eye(x, z)});
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [ease, eye] : places) {
        if (ease <= best_score) break;
        if (!ways_.reaches(flat(eye))) continue;
        const float score = ease - kWorthSeeing * static_cast<float>(unseen(eye).size());
        if (score > best_score) best_score = score, best = eye;
    }
    return best;
}

}  // namespace fastscene
