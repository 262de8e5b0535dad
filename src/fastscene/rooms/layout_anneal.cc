#include "fastscene/rooms/layout_anneal.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/validate.h"

namespace fastscene {
namespace {

// Pieces that move as one; `root` is the one the others were placed by.
struct Group {
    int root = 0;
    std::vector<int> members;
    bool at_wall = false;  // else it stands free
    float off_wall = 0;    // of its middle
};

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

bool stays(const Placed& p) {
    if (p.piece.mount != Mount::floor || p.flat || p.overhead || p.fixed) return true;
    for (const char* kind : {"kitchen_counter", "curtain", "radiator"})
        if (p.piece.kind == kind) return true;
    return false;
}

class Annealer {
  public:
    Annealer(const Plan& plan, std::vector<Placed>& placed, std::uint64_t seed)
        : plan_(plan), placed_(placed), faces_(plan.faces()), rng_(seed, "anneal") {
        std::vector<int> group_of(placed.size(), -1);
        for (int i = 0; i < static_cast<int>(placed.size()); ++i) {
            const int root = root_of(i);
            int& g = group_of[static_cast<std::size_t>(root)];
            if (g < 0 && !stays(at(root)) && !has_fixed(root)) {
                g = static_cast<int>(groups_.size());
                groups_.push_back({root, {}, false, 0});
                settle_at_wall(groups_.back());
            }
            group_.push_back(g);
            if (g >= 0) groups_[static_cast<std::size_t>(g)].members.push_back(i);
        }
        for (const Placed& p : placed_) boxes_.push_back(footprint_of(p));
    }

    std::vector<std::vector<Stand>> run(const AnnealParams& params) {
        std::vector<std::vector<Stand>> found;
        if (groups_.empty() || params.steps <= 0) return found;
        float cost = layout_cost(plan_, placed_).sum(), best = cost;
        for (int step = 0; step < params.steps; ++step) {
            const float cool = static_cast<float>(step) / static_cast<float>(params.steps),
                        heat = params.hot * std::pow(params.cold / params.hot, cool);
            const std::vector<int> moved = propose(1.f - cool);
            if (moved.empty()) continue;
            bool fine = true;
            for (const int g : moved) fine = fine && stands_well(g);
            const float next = fine ? layout_cost(plan_, placed_).sum() : 0.f;
            if (!fine || (next > cost && rng_.uniform() >= std::exp((cost - next) / heat))) {
                take_back();
                continue;
            }
            cost = next;
            if (cost < best - 0.01f) {
                best = cost;
                found.emplace_back();
                for (const Placed& p : placed_) found.back().push_back({p.position, p.yaw});
            }
        }
        return found;
    }

  private:
    Placed& at(int i) { return placed_[static_cast<std::size_t>(i)]; }
    int root_of(int i) {
        for (int steps = 0; steps < 8; ++steps) {
            const int up = at(i).on >= 0 ? at(i).on : at(i).with;
            if (up < 0) break;
            i = up;
        }
        return i;
    }
    // Whether the piece, or one that would move with it, is fixed.
    bool has_fixed(int root) {
        for (int i = 0; i < static_cast<int>(placed_.size()); ++i)
            if (at(i).fixed && root_of(i) == root) return true;
        return false;
    }
    // A piece with its back at a wall keeps it there.
    void settle_at_wall(Group& g) {
        const Placed& p = at(g.root);
        for (const WallFace& face : faces_) {
            const float off = dot(p.position - face.origin, face.inward), u = dot(p.position - face.origin, face.along);
            if (dot(face.inward, front_of(p.yaw)) < 0.99f || u < 0 || u > face.length || off < 0 ||
                off - p.piece.size_m.z / 2 > 0.12f)
                continue;
            g.at_wall = true;
            g.off_wall = off;
            return;
        }
    }

    // Moves the group rigidly so that its root stands there.
    void put(const Group& g, Vec3f position, float yaw) {
        const Vec3f from = at(g.root).position;
        const float turn = yaw - at(g.root).yaw, c = std::cos(turn), s = std::sin(turn);
        for (const int i : g.members) {
            Placed& p = at(i);
            before_.push_back({i, {p.position, p.yaw}});
            const Vec3f d = p.position - from;
            p.position = {position.x + c * d.x + s * d.z, p.position.y, position.z - s * d.x + c * d.z};
            p.yaw = std::remainder(p.yaw + turn, 2 * kPi);
            boxes_[static_cast<std::size_t>(i)] = footprint_of(p);
        }
    }
    void take_back() {
        for (auto it = before_.rbegin(); it != before_.rend(); ++it) {
            at(it->first).position = it->second.position, at(it->first).yaw = it->second.yaw;
            boxes_[static_cast<std::size_t>(it->first)] = footprint_of(at(it->first));
        }
    }
    void put_at_wall(const Group& g, const WallFace& face, float u) {
        put(g, face.point(u, 0) + face.inward * g.off_wall, yaw_of(face.inward));
    }

    // Slides, turns, changes the wall, or swaps two; returns the groups that moved. `reach` in (0, 1]: moves become
    // smaller as it cools.
    std::vector<int> propose(float reach) {
        before_.clear();
        const int k = rng_.index(static_cast<int>(groups_.size()));
        const Group& g = groups_[static_cast<std::size_t>(k)];
        const float roll = rng_.uniform(), far = 0.05f + 0.6f * reach;
        const Vec3f position = at(g.root).position;
        const float yaw = at(g.root).yaw, wide = at(g.root).piece.size_m.x;
        if (g.at_wall) {
            if (roll < 0.5f) {
                put(g, position + right_of(yaw) * (far * rng_.normal()), yaw);
            } else if (roll < 0.75f) {
                const WallFace& face = faces_[static_cast<std::size_t>(rng_.index(static_cast<int>(faces_.size())))];
                if (face.length < wide + 0.04f) return {};
                put_at_wall(g, face, rng_.uniform(wide / 2 + 0.02f, face.length - wide / 2 - 0.02f));
            } else {
                const int other = rng_.index(static_cast<int>(groups_.size()));
                const Group& h = groups_[static_cast<std::size_t>(other)];
                if (other == k || !h.at_wall) return {};
                const Vec3f there = at(h.root).position;
                const float turn = at(h.root).yaw;
                put(g, there + front_of(turn) * (g.off_wall - h.off_wall), turn);
                put(h, position + front_of(yaw) * (h.off_wall - g.off_wall), yaw);
                return {k, other};
            }
            return {k};
        }
        if (roll < 0.65f) put(g, position + Vec3f{far * rng_.normal(), 0, far * rng_.normal()}, yaw);
        else
            put(g, position,
                yaw + (at(g.root).piece.kind == "armchair" || has_role(at(g.root).piece.kind, Role::easy_chair)
                           ? kPi / 12
                           : kPi / 2) *
                          (rng_.chance(0.5f) ? 1.f : -1.f));  // tables stand square
        return {k};
    }

    // Whether most of its back is at a wall still: past the end of a chimney breast there is none.
    bool has_wall_behind(const Group& g) {
        constexpr float kMost = 0.75f, kOff = 0.03f;  // share of its width; metres
        const Placed& p = at(g.root);
        const float half = p.piece.size_m.x / 2;
        return std::any_of(faces_.begin(), faces_.end(), [&](const WallFace& face) {
            const float off = dot(p.position - face.origin, face.inward), u = dot(p.position - face.origin, face.along);
            return dot(face.inward, front_of(p.yaw)) > 0.99f && std::abs(off - g.off_wall) < kOff &&
                   std::min(u + half, face.length) - std::max(u - half, 0.f) > kMost * 2 * half;
        });
    }

    // In the room, apart from all others, off doors and windows, at a wall if it was.
    bool stands_well(int group) {
        if (const Group& g = groups_[static_cast<std::size_t>(group)]; g.at_wall && !has_wall_behind(g)) return false;
        for (const int i : groups_[static_cast<std::size_t>(group)].members) {
            const Placed& p = at(i);
            const Footprint& box = boxes_[static_cast<std::size_t>(i)];
            if (!clear_of_walls(plan_, p) || !stands_level(plan_, p)) return false;
            if (p.piece.mount == Mount::wall && p.on < 0 && !hangs_on_wall(plan_, faces_, p)) return false;
            if (p.piece.mount == Mount::floor && !p.flat && p.on < 0 && blocks_opening(plan_, box)) return false;
            if (p.on >= 0 && shades_window(plan_, box)) return false;
            for (std::size_t k = 0; k < placed_.size(); ++k) {
                if (group_[k] == group || placed_[k].flat != p.flat) continue;
                const Vec2f d = boxes_[k].center - box.center;
                const float near = box.half.x + box.half.y + boxes_[k].half.x + boxes_[k].half.y;
                if (std::abs(d.x) < near && std::abs(d.y) < near &&
                    (overlap(box, boxes_[k]) || hides(p, placed_[k]) || hides(placed_[k], p)))
                    return false;
            }
        }
        return true;
    }

    const Plan& plan_;
    std::vector<Placed>& placed_;
    std::vector<WallFace> faces_;
    Random rng_;
    std::vector<Group> groups_;
    std::vector<int> group_;  // of each piece; -1: it stays
    std::vector<Footprint> boxes_;
    std::vector<std::pair<int, Stand>> before_;
};

}  // namespace

std::vector<std::vector<Stand>> anneal(const Plan& plan, std::vector<Placed> placed, const AnnealParams& params,
                                       std::uint64_t seed) {
    return Annealer(plan, placed, seed).run(params);
}

void Layout::improve() {
    const double start = thread_seconds();
    std::vector<Placed> bare;  // meshes take no part
    for (const Placed& p : placed_) {
        Placed b = {};
        b.wish = p.wish, b.position = p.position, b.yaw = p.yaw, b.on = p.on, b.sill = p.sill, b.with = p.with,
        b.below = p.below, b.flat = p.flat, b.overhead = p.overhead, b.fixed = p.fixed;
        b.piece.kind = p.piece.kind, b.piece.size_m = p.piece.size_m, b.piece.mount = p.piece.mount,
        b.piece.surfaces = p.piece.surfaces;
        b.piece.clearance_front_m = p.piece.clearance_front_m, b.piece.clearance_side_m = p.piece.clearance_side_m;
        bare.push_back(std::move(b));
    }
    annealed_.before = annealed_.after = layout_cost(plan_, bare).sum();
    const std::vector<std::vector<Stand>> found = anneal(plan_, bare, annealing_, rng_.next_u64());
    const int hidden = found.empty() ? 0 : likely_hidden(camera_position());
    // The best with which nothing is wrong.
    constexpr int kTries = 4;
    const Ways before = ways_;
    int tries = 0;
    for (auto stands = found.rbegin(); stands != found.rend() && tries < kTries; ++stands, ++tries) {
        for (std::size_t i = 0; i < bare.size(); ++i) {
            bare[i].position = placed_[i].position, bare[i].yaw = placed_[i].yaw;
            placed_[i].position = (*stands)[i].position, placed_[i].yaw = (*stands)[i].yaw;
        }
        find_ways();
        const Vec3f eye = camera_position();
        const float few = std::max({before.cut_off(), kFewCutOff, kShareCutOff * ways_.free_floor()});
        if (ways_.cut_off() <= few && room_faults(plan_, placed_, eye).empty() && likely_hidden(eye) <= hidden) {
            annealed_.after = layout_cost(plan_, placed_).sum();
            break;
        }
        for (std::size_t i = 0; i < bare.size(); ++i)
            placed_[i].position = bare[i].position, placed_[i].yaw = bare[i].yaw;
        ways_ = before;
    }
    annealed_.seconds = thread_seconds() - start;
}

}  // namespace fastscene
