// Where entries are placed.
#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/trace/gatherer.h"
#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/surface.h"

namespace fastscene {

using namespace irradiance;

namespace {

constexpr int kMaxSamples = 12;  // sample points kept per cell
constexpr float kEven = 0.12f;   // in cells: the flatness below which a cell counts as even
enum : std::uint8_t { kBuried, kCrevice };

// The middle of piece `i` of `n`.
float middle(int i, int n) { return (static_cast<float>(i) + 0.5f) / static_cast<float>(n); }

// How many midpoints of an nu x nv subdivision of a parallelogram lie in one of its two triangles. More than half:
// those on the diagonal belong to both.
int points_within(int nu, int nv) {
    int count = 0;
    for (int ui = 0; ui < nu; ++ui)
        for (int vi = 0; vi < nv; ++vi) count += middle(ui, nu) + middle(vi, nv) <= 1.f;
    return std::max(1, count);
}

}  // namespace

// Scatters points over every triangle, at most half a cell apart, and sorts them into cells.
void IrradianceCache::build(const Room& room) {
    struct Entry {
        std::uint64_t key;
        std::uint32_t order;  // random order within a cell
        Place sample;
        float area;
        int material;
    };
    std::vector<Entry> entries;
    float area = 0;  // area that each point of the current triangle represents
    int material = 0;
    const float step = 0.5f * cell_m_;
    const auto add = [&](Vec3f p, Vec3f n) {
        const Vec3f q = (p - origin_) / cell_m_;
        const std::uint64_t key = key_of(cell_index(q.x), cell_index(q.y), cell_index(q.z), facing_of(n));
        entries.push_back({key, static_cast<std::uint32_t>(mix64(entries.size())), {p, n}, area, material});
    };
    for (const Mesh& mesh : room.meshes) {
        // Thin sheets are lit from both sides.
        const bool both = !is_closed(mesh);
        material = mesh.material;
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const std::size_t i[3] = {mesh.triangles[t], mesh.triangles[t + 1], mesh.triangles[t + 2]};
            const Vec3f a = mesh.positions[i[0]], ab = mesh.positions[i[1]] - a, ac = mesh.positions[i[2]] - a;
            const Vec3f flat = normalize(cross(ab, ac));
            const auto pieces = [&](Vec3f edge) {
                return std::max(1, static_cast<int>(std::ceil(length(edge) / step)));
            };
            const int nu = pieces(ab), nv = pieces(ac);
            area = 0.5f * length(cross(ab, ac)) / static_cast<float>(points_within(nu, nv));
            for (int ui = 0; ui < nu; ++ui)
                for (int vi = 0; vi < nv; ++vi) {
                    float u = middle(ui, nu), v = middle(vi, nv);
                    if (u + v > 1.f) {
                        if (nu > 1 || nv > 1) continue;
                        u = v = 1.f / 3;
                    } else if (nu == 1 && nv == 1) {
                        u = v = 1.f / 3;
                    }
                    Vec3f n = normalize(mesh.normals[i[0]] * (1 - u - v) + mesh.normals[i[1]] * u +
                                        mesh.normals[i[2]] * v);
                    if (!(dot(n, flat) > 0.1f)) n = flat;
                    add(a + ab * u + ac * v, n);
                    if (both) add(a + ab * u + ac * v, -n);
                }
            area = 0;
            // Points on the rim, so that a neighbouring cell that the triangle barely touches gets an entry.
            if (nu > 1 || nv > 1)
                for (const auto& [u, v] : {std::pair{0.001f, 0.001f}, std::pair{0.998f, 0.001f},
                                           std::pair{0.001f, 0.998f}, std::pair{0.5f, 0.499f}}) {
                    Vec3f n = normalize(mesh.normals[i[0]] * (1 - u - v) + mesh.normals[i[1]] * u +
                                        mesh.normals[i[2]] * v);
                    if (!(dot(n, flat) > 0.1f)) n = flat;
                    add(a + ab * u + ac * v, n);
                    if (both) add(a + ab * u + ac * v, -n);
                }
        }
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.order < b.order; });
    for (std::size_t i = 0; i < entries.size();) {
        std::size_t end = i;
        Vec3f center{}, normal{};
        keys_.push_back(entries[i].key);
        first_sample_.push_back(static_cast<std::uint32_t>(samples_.size()));
        float whole = 0;
        for (; end < entries.size() && entries[end].key == entries[i].key; ++end) whole += entries[end].area;
        const std::size_t kept = std::min<std::size_t>(kMaxSamples, end - i);
        Vec3f color{};
        float passed = entries[i].area;
        std::size_t at = i;
        for (std::size_t k = 0; k < kept; ++k) {
            // A cell with a hundred slivers of a rounded edge in front of a board is mostly board: points are drawn in
            // proportion to area, stratified along its cumulative sum. Rim points carry no area.
            if (whole > 0) {
                const float wanted = whole * (static_cast<float>(k) + 0.5f) / static_cast<float>(kept);
                while (passed < wanted && at + 1 < end) passed += entries[++at].area;
            } else {
                at = i + k;
            }
            samples_.push_back(entries[at].sample);
            center += entries[at].sample.position;
            normal += entries[at].sample.normal;
            color += reflectances_[static_cast<std::size_t>(entries[at].material)] / static_cast<float>(kept);
        }
        cells_.push_back({{},
                          {},
                          {},
                          normalize(normal),
                          center / static_cast<float>(kept),
                          color,
                          {},
                          whole,
                          room.materials[static_cast<std::size_t>(entries[i].material)].transmission,
                          0.f});
        i = end;
    }
    first_sample_.push_back(static_cast<std::uint32_t>(samples_.size()));
}

// Visibility of each sample point: kBuried, or kCrevice + how many of eight rays travel further than half a cell. Once
// the first points of a cell, or the first rays of a point, turn out to be in the open, the rest is skipped.
std::vector<std::uint8_t> IrradianceCache::visibility(const SceneBvh& bvh) const {
    constexpr std::uint32_t kRays = 8, kFirstRays = 4, kFirstPlaces = 4;
    std::vector<std::uint8_t> sight(samples_.size(), kCrevice + kRays);
    const auto sight_of = [&](const Place& at) {
        bool seen = false;
        std::uint8_t open = 0;
        for (std::uint32_t s = 0; s < kRays; ++s) {
            if (s == kFirstRays && open == kFirstRays) return static_cast<std::uint8_t>(kCrevice + kRays);
            const Vec3f toward = cosine_direction(at.normal, r2_point(s, {0.5f, 0.5f}));
            const RayHit hit = bvh.first_hit(at.position + at.normal * distance_epsilon(at.position), toward);
            if (!hit || (hit.back && closed_[static_cast<std::size_t>(hit.mesh)])) continue;
            seen = true;
            open += hit.distance > 0.5f * cell_m_;
        }
        return seen ? static_cast<std::uint8_t>(kCrevice + open) : std::uint8_t{kBuried};
    };
    parallel_for(static_cast<std::int64_t>(cells_.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
            bool all_open = true;
            for (std::uint32_t s = first_sample_[c]; s < first_sample_[c + 1]; ++s) {
                if (s == first_sample_[c] + kFirstPlaces && all_open) break;
                sight[s] = sight_of(samples_[s]);
                all_open &= sight[s] == kCrevice + kRays;
            }
        }
    });
    return sight;
}

// Drops sample points that are not visible from inside the room: outer sides of the walls (every ray escapes), points
// inside solids (every ray hits a back face) and, where the cell also has open points, the bottom of crevices (most
// rays end within half a cell: between two boards, behind a door panel). Such points would darken the visible part of
// their cell. A cell left without points is dropped: it would only darken its neighbours and attract samples.
void IrradianceCache::drop_hidden(const std::vector<std::uint8_t>& sight) {
    std::vector<Cell> cells;
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> first_sample;
    std::vector<Place> samples;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const auto begin = sight.begin() + first_sample_[c], end = sight.begin() + first_sample_[c + 1];
        const std::uint8_t best = *std::max_element(begin, end);
        if (best == kBuried) continue;
        Cell cell = cells_[c];
        cell.center = cell.normal = Vec3f{};
        const std::size_t before = samples.size();
        for (std::uint32_t s = first_sample_[c]; s < first_sample_[c + 1]; ++s) {
            if (sight[s] == kBuried || 2 * sight[s] < best) continue;
            cell.center += samples_[s].position;
            cell.normal += samples_[s].normal;
            samples.push_back(samples_[s]);
        }
        const auto kept = static_cast<float>(samples.size() - before);
        cell.center = cell.center / kept;
        cell.normal = normalize(cell.normal);
        cell.area *= kept / static_cast<float>(end - begin);
        // Even surfaces are trusted for now; gathering finds out whether other objects are close.
        cell.trust = 1;
        for (std::size_t k = before; k < samples.size(); ++k)
            if (std::abs(dot(samples[k].position - cell.center, cell.normal)) > kEven * cell_m_) cell.trust = 0;
        cells.push_back(cell);
        keys.push_back(keys_[c]);
        first_sample.push_back(static_cast<std::uint32_t>(before));
    }
    first_sample.push_back(static_cast<std::uint32_t>(samples.size()));
    cells_ = std::move(cells);
    keys_ = std::move(keys);
    first_sample_ = std::move(first_sample);
    samples_ = std::move(samples);
}

// Adds a step in each horizontal direction around every viewpoint, as far as there is space.
void IrradianceCache::find_seen(const SceneBvh& bvh, const std::vector<Vec3f>& viewpoints, Gatherer* gatherer,
                                const Run& run) {
    constexpr float kStep_m = 0.8f, kOfTheWay = 0.8f;
    constexpr std::array<Vec3f, 6> kWays{Vec3f{1, 0, 0},  Vec3f{-1, 0, 0}, Vec3f{0, 0, 1},
                                         Vec3f{0, 0, -1}, Vec3f{0, 1, 0},  Vec3f{0, -1, 0}};
    std::vector<Vec3f> places = viewpoints;
    for (const Vec3f viewpoint : viewpoints)
        for (const Vec3f way : kWays)
            places.push_back(viewpoint + way * (kOfTheWay * std::min(kStep_m, bvh.first_hit(viewpoint, way).distance)));
    if (gatherer) {
        const std::vector<std::uint8_t> seen = gatherer->seen_from(places, run);
        for (std::size_t c = 0; c < cells_.size(); ++c) cells_[c].seen = cells_[c].transmission > 0 || seen[c];
        return;
    }
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
            Cell& cell = cells_[c];
            const Vec3f from = cell.center + cell.normal * (0.1f * cell_m_);
            // Translucent surfaces are visible from their other side.
            cell.seen = cell.transmission > 0 || std::any_of(places.begin(), places.end(), [&](Vec3f p) {
                            const Vec3f to = p - from;
                            const float far = length(to);
                            // A rounded cell is visible from slightly behind its mean plane, too.
                            return dot(to, cell.normal) > -0.2f * far && !bvh.blocked(from, to / far, 0.f, far);
                        });
        }
    });
}

}  // namespace fastscene
