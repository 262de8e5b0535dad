#include "fastscene/rooms/validate.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/crossings.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene {
namespace {

constexpr float kTolerance = 0.01f;
constexpr float kEyeAir = 0.45f;  // free ball about the camera

class Checker {
  public:
    Checker(const Plan& plan, const std::vector<Placed>& placed, const Passage& passage, const std::vector<bool>& round)
        : plan_(plan), placed_(placed), passage_(passage), round_(round) {}

    std::vector<Fault> faults(Vec3f camera) {
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            inside(i);
            supported(i);
            if (placed_[i].flat) continue;
            for (std::size_t k = i + 1; k < placed_.size(); ++k) apart(i, k);
            openings(i);
        }
        way(camera);
        return std::move(faults_);
    }

  private:
    std::string name(std::size_t i) const { return placed_[i].piece.kind + " #" + std::to_string(i); }
    void add(const char* kind, std::string text) { faults_.push_back({kind, std::move(text)}); }

    void inside(std::size_t i) {
        if (placed_[i].sill >= 0 || has_role(placed_[i].piece.kind, Role::roof)) return;  // in an opening, over walls
        if (!plan_.holds(shrunk(footprint_of(placed_[i]), kTolerance)))
            add("outside", name(i) + " reaches into a wall, the floor or the ceiling");
    }

    // Above its middle; below a vault above all of it.
    float lowest_ceiling(const Placed& p) const {
        float low = plan_.ceiling_at(flat(p.position));
        if (plan_.vault != Vault::flat)
            for (const Vec2f corner : corners_of(footprint_of(p))) low = std::min(low, plan_.ceiling_at(corner));
        return low;
    }

    // On the floor, on the top of what carries it, at a wall, at the ceiling.
    void supported(std::size_t i) {
        const Placed& p = placed_[i];
        if (p.on >= 0) {
            const Placed& below = placed_[static_cast<std::size_t>(p.on)];
            const bool on_top = std::any_of(
                below.piece.surfaces.begin(), below.piece.surfaces.end(),
                [&](const Surface& s) { return std::abs(below.position.y + s.center.y - p.position.y) < kTolerance; });
            if (!on_top || distance_to(footprint_of(below), footprint_of(p).center) > 0.f)
                add("unsupported", name(i) + " floats above " + name(static_cast<std::size_t>(p.on)));
            return;
        }
        if (p.below >= 0) {
            const Placed& table = placed_[static_cast<std::size_t>(p.below)];
            if (table.piece.surfaces.empty() || p.piece.size_m.y > table.piece.surfaces.front().center.y)
                add("unsupported",
                    name(i) + " is too tall for its place under " + name(static_cast<std::size_t>(p.below)));
        }
        if (p.sill >= 0) {
            if (p.piece.mount == Mount::wall && !hangs_in_window(plan_, p))
                add("unsupported", name(i) + " does not hang in its window");
            if (p.piece.mount != Mount::wall && !stands_on_sill(plan_, p))
                add("unsupported", name(i) + " does not stand on its window's sill");
            return;
        }
        switch (p.piece.mount) {
            case Mount::floor:
                if (p.piece.kind == "curtain") break;
                if (!plan_.platforms.empty() ? !stands_level(plan_, p) : std::abs(p.position.y) > 0.02f)
                    add("unsupported", name(i) + " does not stand on the floor");
                break;
            case Mount::surface: add("unsupported", name(i) + " stands on nothing"); break;
            case Mount::ceiling:
                if (std::abs(p.position.y - lowest_ceiling(p)) > 0.3f)
                    add("unsupported", name(i) + " does not hang from the ceiling");
                break;
            case Mount::wall: {
                const Vec3f back{std::sin(p.yaw), 0, std::cos(p.yaw)};
                bool at_wall = false;
                for (const WallFace& face : plan_.faces()) {
                    const Vec3f to = p.position - face.origin;
                    const float u = dot(to, face.along), off = dot(to, face.inward);
                    at_wall = at_wall || (hangs_at(face) && dot(face.inward, back) > 0.99f && off > -kTolerance &&
                                          off < 0.08f && u > -kTolerance && u < face.length + kTolerance);
                }
                if (!at_wall) add("unsupported", name(i) + " hangs on no wall");
            }
        }
    }

    void apart(std::size_t i, std::size_t k) {
        const Placed &a = placed_[i], &b = placed_[k];
        if (b.flat || b.on == static_cast<int>(i) || a.on == static_cast<int>(k)) return;
        // What stands under a table stands between its legs.
        if (b.below == static_cast<int>(i) || a.below == static_cast<int>(k)) return;
        if (shelters(placed_, static_cast<int>(i), b) || shelters(placed_, static_cast<int>(k), a)) return;
        if (overlap(shrunk(footprint_of(a), kTolerance / 2), shrunk(footprint_of(b), kTolerance / 2)) &&
            !off_round(i, b) && !off_round(k, a))
            add("overlap", name(i) + " and " + name(k) + " stand in each other");
    }

    // In a corner of its box alone.
    bool off_round(std::size_t i, const Placed& other) const {
        if (i >= round_.size() || !round_[i]) return false;
        const float radius = std::max(placed_[i].piece.size_m.x, placed_[i].piece.size_m.z) / 2;
        return distance_to(footprint_of(other), flat(placed_[i].position)) > radius - kTolerance;
    }

    void openings(std::size_t i) {
        const Placed& p = placed_[i];
        const Footprint box = footprint_of(p);
        for (const Opening& o : plan_.openings) {
            const WallFace face = plan_.wall(o.wall);
            const float yaw = std::atan2(face.inward.x, face.inward.z);
            const bool window = o.kind == Opening::Kind::window;
            if (!plan_.needs_room(o)) continue;
            const float deep = window ? 0.12f
                                      : 0.7f;  // before a window things may stand, but not touch it above its sill
            const Vec3f middle = face.point((o.u0 + o.u1) / 2, 0) + face.inward * (deep / 2);
            Footprint zone{flat(middle), {(o.u1 - o.u0) / 2 - 0.04f, deep / 2 - 0.01f}, yaw, 0.02f, 2.f};
            if (window) zone.y0 = free_before(o, 0.25f), zone.y1 = o.y1 - 0.02f;
            if (window && (p.piece.kind == "curtain" || p.on >= 0 || p.sill >= 0)) continue;
            if (overlap(box, zone))
                add(window ? "window" : "door", name(i) + (window ? " stands in a window" : " blocks a door"));
        }
    }

    void way(Vec3f camera) {
        Ways ways(plan_, passage_);
        for (const Placed& p : placed_) ways.add(p);
        if (!ways.open()) add("way", "no way leads from the door to a place for the camera");
        else if (!ways.reaches(flat(camera))) add("way", "no way leads from the door to the camera");
        float nearest = plan_.air_around(camera);
        std::string what = "a wall";
        for (std::size_t i = 0; i < placed_.size(); ++i) {
            if (placed_[i].flat) continue;
            const auto apart = [&](const Footprint& box) {
                return std::hypot(distance_to(box, flat(camera)),
                                  std::max({0.f, box.y0 - camera.y, camera.y - box.y1}));
            };
            if (apart(footprint_of(placed_[i])) >= nearest) continue;
            // Of a bed the head alone is as high as that.
            const auto high = part_above(placed_[i], camera.y - kEyeAir);
            if (const float far = high ? apart(*high) : nearest; far < nearest) nearest = far, what = name(i);
        }
        if (!(nearest >= kEyeAir))
            add("camera", what + " is " + std::to_string(nearest).substr(0, 4) + " m from the camera");
    }

    const Plan& plan_;
    const std::vector<Placed>& placed_;
    const Passage& passage_;
    const std::vector<bool>& round_;
    std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> room_faults(const Plan& plan, const std::vector<Placed>& placed, Vec3f camera,
                               const Passage& passage) {
    return room_faults(plan, placed, camera, passage, {});
}

std::vector<Fault> room_faults(const Plan& plan, const std::vector<Placed>& placed, Vec3f camera,
                               const Passage& passage, const std::vector<bool>& round) {
    return Checker(plan, placed, passage, round).faults(camera);
}

namespace {

void add_crossings(PromptSpec spec, std::uint64_t seed, std::vector<Fault>& faults) {
    const Room room = make_room(spec, {seed, nullptr, {}});
    const auto name = [&](int object) {
        return object < 0 ? std::string("the room") : room.objects[static_cast<std::size_t>(object)].kind;
    };
    for (const Crossing& c : room_crossings(room))
        faults.push_back(
            {"crossing", fmt::format("{} reaches {:.0f} mm into {}", name(c.object), 1000 * c.depth_m, name(c.into))});
}

}  // namespace

CheckReport check_sentences(const std::vector<std::string>& sentences, int count, const CheckDepth& depth,
                            const Run& run) {
    CheckReport report;
    const auto total = static_cast<std::int64_t>(sentences.size()) * count;
    std::vector<CheckedRoom> checked(static_cast<std::size_t>(total));
    std::vector<int> pieces(checked.size(), 0);
    Progress progress(run, "rooms", total);
    parallel_for(total, 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            run.check_stop();
            CheckedRoom& c = checked[static_cast<std::size_t>(i)];
            c.prompt = sentences[static_cast<std::size_t>(i / count)];
            c.seed = run.seed + static_cast<std::uint64_t>(i % count);
            PromptSpec spec = understand_prompt(c.prompt, false);
            const PromptSpec asked = spec;
            const FurnishedRoom room = furnish_room(spec, {c.seed, nullptr, {}});
            c.faults = room_faults(room.plan, room.placed, room.camera);
            if (depth.triangles) add_crossings(asked, c.seed, c.faults);
            if (depth.measures) c.measures = measure_layout(room.plan, room.placed);
            pieces[static_cast<std::size_t>(i)] = static_cast<int>(room.placed.size());
            progress.advance();
        }
    });
    report.rooms = static_cast<int>(total);
    for (std::size_t i = 0; i < checked.size(); ++i) {
        report.pieces += pieces[i];
        report.measures.add(checked[i].measures);
        if (!checked[i].measures.findings.empty()) report.measured.push_back(checked[i]);
        if (!checked[i].faults.empty()) report.faulty.push_back(std::move(checked[i]));
    }
    return report;
}

CheckReport check_rooms(const std::vector<std::string>& rooms, const std::vector<std::string>& styles, int count,
                        const CheckDepth& depth, const Run& run) {
    std::vector<std::string> sentences;
    for (const std::string& room : rooms)
        for (const std::string& style : styles) sentences.push_back("a " + style + " " + room_title(room));
    return check_sentences(sentences, count, depth, run);
}

}  // namespace fastscene
