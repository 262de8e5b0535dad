#include "fastscene/trace/irradiance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/surface.h"

namespace fastscene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kMaxSamples = 12;      // places kept in a cell
constexpr std::int32_t kBias = 1 << 18;

std::uint64_t key_of(std::int32_t x, std::int32_t y, std::int32_t z, int facing) {
    const auto part = [](std::int32_t v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v + kBias) & 0xfffffu); };
    return part(x) << 43 | part(y) << 23 | part(z) << 3 | static_cast<std::uint64_t>(facing);
}
std::int32_t cell_index(float v) { return static_cast<std::int32_t>(std::floor(v)); }

// Cosine-weighted direction about n.
Vec3f cosine_direction(Vec3f n, float u, float v) {
    Vec3f s, t;
    make_frame(n, s, t);
    const float r = std::sqrt(u), phi = 2 * kPi * v;
    return s * (r * std::cos(phi)) + t * (r * std::sin(phi)) + n * std::sqrt(std::max(0.f, 1 - u));
}

// A low-discrepancy sequence in the plane, shifted by a random offset (Roberts' R2).
Vec2f r2_point(std::uint32_t i, Vec2f shift) {
    const float u = shift.x + static_cast<float>((i * 3242174889u) >> 8) * 0x1p-24f, v = shift.y + static_cast<float>((i * 2447445414u) >> 8) * 0x1p-24f;
    return {u - std::floor(u), v - std::floor(v)};
}

float distance_epsilon(Vec3f p) { return 1e-4f + 2e-5f * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)); }

}  // namespace

int facing_of(Vec3f n) {
    const float x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    if (x >= y && x >= z) return n.x > 0 ? 0 : 1;
    if (y >= z) return n.y > 0 ? 2 : 3;
    return n.z > 0 ? 4 : 5;
}

// Spreads points over every triangle, half a cell apart or closer, and sorts them into cells.
void IrradianceCache::build(const Room& room, const std::vector<Vec3f>& albedo) {
    struct Entry {
        std::uint64_t key;
        std::uint32_t order;  // random: which points a full cell keeps
        Sample sample;
        float area;
        int material;
    };
    std::vector<Entry> entries;
    float area = 0;    // what each point of the triangle at hand stands for
    int material = 0;
    const float step = 0.5f * cell_m_;
    const auto add = [&](Vec3f p, Vec3f n) {
        const Vec3f q = (p - origin_) / cell_m_;
        const std::uint64_t key = key_of(cell_index(q.x), cell_index(q.y), cell_index(q.z), facing_of(n));
        entries.push_back({key, static_cast<std::uint32_t>(mix64(entries.size())), {p, n}, area, material});
    };
    for (const Mesh& mesh : room.meshes) {
        // Sheets are lit from both sides.
        const bool both = !is_closed(mesh);
        material = mesh.material;
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const std::size_t i[3] = {mesh.triangles[t], mesh.triangles[t + 1], mesh.triangles[t + 2]};
            const Vec3f a = mesh.positions[i[0]], ab = mesh.positions[i[1]] - a, ac = mesh.positions[i[2]] - a;
            const Vec3f flat = normalize(cross(ab, ac));
            const int nu = std::max(1, static_cast<int>(std::ceil(length(ab) / step))), nv = std::max(1, static_cast<int>(std::ceil(length(ac) / step)));
            const int points = nu == 1 && nv == 1 ? 1 : std::max(1, nu * nv / 2);
            area = 0.5f * length(cross(ab, ac)) / static_cast<float>(points);
            for (int ui = 0; ui < nu; ++ui)
                for (int vi = 0; vi < nv; ++vi) {
                    float u = (static_cast<float>(ui) + 0.5f) / static_cast<float>(nu), v = (static_cast<float>(vi) + 0.5f) / static_cast<float>(nv);
                    if (u + v > 1.f) {
                        if (nu > 1 || nv > 1) continue;
                        u = v = 1.f / 3;
                    } else if (nu == 1 && nv == 1) {
                        u = v = 1.f / 3;
                    }
                    Vec3f n = normalize(mesh.normals[i[0]] * (1 - u - v) + mesh.normals[i[1]] * u + mesh.normals[i[2]] * v);
                    if (!(dot(n, flat) > 0.1f)) n = flat;
                    add(a + ab * u + ac * v, n);
                    if (both) add(a + ab * u + ac * v, -n);
                }
            area = 0;
            // The rim, where a neighbouring cell may be touched by a hair.
            if (nu > 1 || nv > 1)
                for (const auto& [u, v] : {std::pair{0.001f, 0.001f}, std::pair{0.998f, 0.001f}, std::pair{0.001f, 0.998f}, std::pair{0.5f, 0.499f}}) {
                    Vec3f n = normalize(mesh.normals[i[0]] * (1 - u - v) + mesh.normals[i[1]] * u + mesh.normals[i[2]] * v);
                    if (!(dot(n, flat) > 0.1f)) n = flat;
                    add(a + ab * u + ac * v, n);
                    if (both) add(a + ab * u + ac * v, -n);
                }
        }
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.order < b.order; });
    for (std::size_t i = 0; i < entries.size();) {
        std::size_t end = i;
        Vec3f center{}, normal{};
        keys_.push_back(entries[i].key);
        first_sample_.push_back(static_cast<std::uint32_t>(samples_.size()));
        int kept = 0;
        float whole = 0;
        const Vec3f color = albedo[static_cast<std::size_t>(entries[i].material)];
        for (; end < entries.size() && entries[end].key == entries[i].key; ++end) {
            whole += entries[end].area;
            if (kept < kMaxSamples) {
                samples_.push_back(entries[end].sample);
                center += entries[end].sample.position;
                normal += entries[end].sample.normal;
                ++kept;
            }
        }
        cells_.push_back({{}, {}, {}, normalize(normal), center / static_cast<float>(kept), color, whole,
                          room.materials[static_cast<std::size_t>(entries[i].material)].transmission});
        i = end;
    }
    first_sample_.push_back(static_cast<std::uint32_t>(samples_.size()));
}

// Cells that nobody in the room can see are no cells: the outside of the walls (every ray leaves), and what is buried in
// something solid (every ray meets a back face). They would only darken their neighbours and draw samples to themselves.
void IrradianceCache::drop_unseen(const SceneBvh& bvh, const std::vector<bool>& closed) {
    constexpr int kRays = 24;
    std::vector<std::uint8_t> seen(cells_.size(), 0);
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const std::uint32_t first = first_sample_[c], n = first_sample_[c + 1] - first;
            for (int s = 0; s < kRays && !seen[c]; ++s) {
                const Sample& at = samples_[first + static_cast<std::uint32_t>(s) % n];
                const Vec2f uv = r2_point(static_cast<std::uint32_t>(s), {0.5f, 0.5f});
                const RayHit hit = bvh.first_hit(at.position + at.normal * distance_epsilon(at.position), cosine_direction(at.normal, uv.x, uv.y));
                seen[c] = hit && !(hit.back && closed[static_cast<std::size_t>(hit.mesh)]);
            }
        }
    });
    std::vector<Cell> cells;
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> first_sample;
    std::vector<Sample> samples;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        if (!seen[c]) continue;
        cells.push_back(cells_[c]);
        keys.push_back(keys_[c]);
        first_sample.push_back(static_cast<std::uint32_t>(samples.size()));
        samples.insert(samples.end(), samples_.begin() + first_sample_[c], samples_.begin() + first_sample_[c + 1]);
    }
    first_sample.push_back(static_cast<std::uint32_t>(samples.size()));
    cells_ = std::move(cells);
    keys_ = std::move(keys);
    first_sample_ = std::move(first_sample);
    samples_ = std::move(samples);
}

void IrradianceCache::index() {
    std::uint32_t capacity = 16;
    while (capacity < cells_.size() * 2 + 2) capacity *= 2;
    mask_ = capacity - 1;
    slots_.assign(capacity, 0);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        auto slot = static_cast<std::uint32_t>(mix64(keys_[c])) & mask_;
        while (slots_[slot]) slot = (slot + 1) & mask_;
        slots_[slot] = static_cast<std::uint32_t>(c) + 1;
    }
}

int IrradianceCache::find(std::int32_t x, std::int32_t y, std::int32_t z, int facing) const {
    const std::uint64_t key = key_of(x, y, z, facing);
    for (auto slot = static_cast<std::uint32_t>(mix64(key)) & mask_; slots_[slot]; slot = (slot + 1) & mask_)
        if (keys_[slots_[slot] - 1] == key) return static_cast<int>(slots_[slot]) - 1;
    return -1;
}

// The entry whose surface the point lies on, or the nearest around it that faces the same way.
int IrradianceCache::nearest(Vec3f position, Vec3f normal) const {
    const Vec3f q = (position - origin_) / cell_m_;
    const std::int32_t x = cell_index(q.x), y = cell_index(q.y), z = cell_index(q.z);
    const int facing = facing_of(normal);
    if (const int c = find(x, y, z, facing); c >= 0) return c;
    int best = -1;
    float best_far = 1e9f;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                for (int f = 0; f < 6; ++f) {
                    const int c = find(x + dx, y + dy, z + dz, f);
                    if (c < 0) continue;
                    const Cell& cell = cells_[static_cast<std::size_t>(c)];
                    const float agree = dot(cell.normal, normal), far = length(cell.center - position) + cell_m_ * (1 - agree) * 2;
                    if (agree > 0.2f && far < best_far) best_far = far, best = c;
                }
    return best;
}

Vec3f IrradianceCache::near(Vec3f position, Vec3f normal, bool with_sun) const {
    const int c = nearest(position, normal);
    if (c < 0) return {};
    const Cell& cell = cells_[static_cast<std::size_t>(c)];
    return with_sun ? cell.direct + cell.indirect + cell.sun : cell.direct + cell.indirect;
}

// Cells that the sun reaches; curtains shine on both sides.
std::vector<IrradianceCache::SunPatch> IrradianceCache::sun_patches() const {
    std::vector<SunPatch> patches;
    for (const Cell& cell : cells_) {
        const Vec3f back = cell.sun * cell.albedo;
        if (!(luminance(back) * cell.area > 0)) continue;
        const float lift = 0.02f * cell_m_;
        patches.push_back({cell.center + cell.normal * lift, cell.normal, back * (1.f - cell.transmission), cell.area});
        if (cell.transmission > 0) patches.push_back({cell.center - cell.normal * lift, -cell.normal, back * cell.transmission, cell.area});
    }
    return patches;
}

// For each patch, the share of some places in the room that see it: the outer side of a curtain is bright and lights nothing.
std::vector<float> IrradianceCache::usefulness(const std::vector<SunPatch>& patches, const SceneBvh& bvh, std::uint64_t seed) const {
    constexpr int kPlaces = 24;
    std::vector<float> useful(patches.size());
    parallel_for(static_cast<std::int64_t>(patches.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const SunPatch& patch = patches[static_cast<std::size_t>(i)];
            Random random(seed, "usefulness", static_cast<std::uint64_t>(i));
            float seen = 0;
            for (int k = 0; k < kPlaces; ++k) {
                const Cell& place = cells_[static_cast<std::size_t>(random.index(static_cast<int>(cells_.size())))];
                const Vec3f from = place.center + place.normal * (0.05f * cell_m_), to = patch.position - from;
                const float far = length(to);
                if (!(dot(to, patch.normal) < 0 && dot(to, place.normal) > 0)) continue;
                seen += bvh.blocked(from, to / far, 0.f, far - 0.3f * cell_m_) ? 0.f : 1.f;
            }
            // Never quite zero: a few places may see it that were not asked.
            useful[static_cast<std::size_t>(i)] = 0.02f + seen / kPlaces;
        }
    });
    return useful;
}

Vec3f IrradianceCache::at(Vec3f position, Vec3f normal) const {
    const Vec3f q = (position - origin_) / cell_m_ - Vec3f{0.5f, 0.5f, 0.5f};
    const std::int32_t x = cell_index(q.x), y = cell_index(q.y), z = cell_index(q.z);
    const float fx = q.x - static_cast<float>(x), fy = q.y - static_cast<float>(y), fz = q.z - static_cast<float>(z);
    Vec3f sum{};
    float weight = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // A rounded surface fades from one main direction to the next.
        const float share = normal[axis] * normal[axis];
        if (share < 0.12f) continue;
        const int facing = static_cast<int>(2 * axis) + (normal[axis] > 0 ? 0 : 1);
        for (int k = 0; k < 8; ++k) {
            const int c = find(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2), facing);
            if (c < 0) continue;
            const Cell& cell = cells_[static_cast<std::size_t>(c)];
            const float w = share * (k & 1 ? fx : 1 - fx) * (k & 2 ? fy : 1 - fy) * (k & 4 ? fz : 1 - fz) * std::max(0.02f, dot(cell.normal, normal)) + 1e-6f * share;
            sum += (cell.direct + cell.indirect) * w;
            weight += w;
        }
    }
    if (weight > 0) return sum / weight;
    const int c = nearest(position, normal);
    return c < 0 ? Vec3f{} : cells_[static_cast<std::size_t>(c)].direct + cells_[static_cast<std::size_t>(c)].indirect;
}

// Averages each entry with its neighbours on the same surface; those that differ by much more than noise does count less.
void IrradianceCache::smooth(bool indirect, int radius, float tolerance) {
    std::vector<Vec3f> out(cells_.size());
    parallel_for(static_cast<std::int64_t>(cells_.size()), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            const Cell& cell = cells_[c];
            const Vec3f here = indirect ? cell.indirect : cell.direct;
            const std::uint64_t key = keys_[c];
            const auto part = [&](int shift) { return static_cast<std::int32_t>(key >> shift & 0xfffffu) - kBias; };
            const std::int32_t x = part(43), y = part(23), z = part(3);
            const int facing = static_cast<int>(key & 7);
            const float base = luminance(here);
            Vec3f sum{};
            float weight = 0;
            for (int dz = -radius; dz <= radius; ++dz)
                for (int dy = -radius; dy <= radius; ++dy)
                    for (int dx = -radius; dx <= radius; ++dx) {
                        const int n = find(x + dx, y + dy, z + dz, facing);
                        if (n < 0) continue;
                        const Cell& other = cells_[static_cast<std::size_t>(n)];
                        const float agree = dot(other.normal, cell.normal);
                        if (!(agree > 0.7f)) continue;
                        // A step between two levels (table top and floor) is no neighbour.
                        const float off = std::abs(dot(other.center - cell.center, cell.normal)) / cell_m_;
                        const Vec3f value = indirect ? other.indirect : other.direct;
                        const float difference = (luminance(value) - base) / (tolerance * (base + 0.02f));
                        const float r2 = static_cast<float>(dx * dx + dy * dy + dz * dz) / static_cast<float>(radius * radius);
                        const float w = std::exp(-1.2f * r2 - difference * difference - 2.f * off * off) * agree * agree;
                        sum += value * w;
                        weight += w;
                    }
            out[c] = weight > 0 ? sum / weight : here;
        }
    });
    for (std::size_t c = 0; c < cells_.size(); ++c) (indirect ? cells_[c].indirect : cells_[c].direct) = out[c];
}

IrradianceCache IrradianceCache::gather(const Room& room, const SceneBvh& bvh, const TraceParams& params, const Run& run) {
    IrradianceCache cache;
    cache.cell_m_ = params.cell_m;
    // An odd offset, so that walls do not lie on the borders of cells.
    cache.origin_ = room.min_corner + Vec3f{0.37f, 0.41f, 0.43f} * params.cell_m;
    std::vector<Vec3f> albedo;
    for (const Material& m : room.materials) {
        // Metals and mirrors pass their light on as well, if not in all directions.
        const bool mirror = m.metal > 0 || m.mirror > 0;
        albedo.push_back(mean_albedo(m) * (mirror ? 0.7f : 1.f));
    }
    cache.build(room, albedo);
    std::vector<bool> closed;
    for (const Mesh& mesh : room.meshes) closed.push_back(is_closed(mesh));
    cache.drop_unseen(bvh, closed);
    cache.index();
    const auto count = static_cast<std::int64_t>(cache.cells_.size());

    const Lights lights(room);
    const auto key = [&](std::size_t cell, std::uint64_t pass) { return run.seed ^ mix64(cache.keys_[cell] ^ mix64(pass)); };
    const auto sample_of = [&](std::size_t c, int i) -> const Sample& {
        const std::uint32_t first = cache.first_sample_[c], n = cache.first_sample_[c + 1] - first;
        return cache.samples_[first + static_cast<std::uint32_t>(i) % n];
    };
    // Gathering is three quarters of the work: progress counts cells over all passes.
    constexpr int kPasses = 8;
    Progress progress(run, "light", (count / 1024 + 1) * (kPasses + 1));

    // The sun first: what it lights is bright and small, and lights the rest of the room.
    parallel_for(count, 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            Random random(key(c, 100));
            constexpr int kSunSamples = 16;
            Vec3f sun{};
            for (int s = 0; s < kSunSamples; ++s) sun += lights.sun(room, bvh, sample_of(c, s).position, sample_of(c, s).normal, random);
            cache.cells_[c].sun = sun / static_cast<float>(kSunSamples);
        }
    });
    const std::vector<SunPatch> patches = cache.sun_patches();
    const std::vector<float> useful = cache.usefulness(patches, bvh, run.seed);
    std::vector<float> cumulative;
    for (std::size_t i = 0; i < patches.size(); ++i)
        cumulative.push_back((i ? cumulative.back() : 0.f) + luminance(patches[i].leaving) * patches[i].area * useful[i]);
    const bool sunny = !cumulative.empty() && cumulative.back() > 0;
    // A sunlit cell close by is asked too rarely and answers too loudly: within eight cells gathering finds it instead.
    const float near_sun = 8 * params.cell_m;

    // Then lamps, windows and the first bounce of the sun, each asked directly.
    const int direct_samples = std::max(8, params.cell_samples / 2);
    parallel_for(count, 1024, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (std::int64_t i = begin; i < end; ++i) {
            const auto c = static_cast<std::size_t>(i);
            Cell& cell = cache.cells_[c];
            Random random(key(c, 0));
            const Lights::Choice choice = lights.choice_at(cell.center, cell.normal);
            const Vec2f shift{random.uniform(), random.uniform()};
            Vec3f direct{};
            for (int s = 0; s < direct_samples; ++s) {
                const Sample& at = sample_of(c, s);
                const Vec2f uv = r2_point(static_cast<std::uint32_t>(s), shift);
                const float which = (static_cast<float>(s) + random.uniform()) / static_cast<float>(direct_samples);
                direct += lights.sample(room, bvh, choice, at.position, at.normal, which, uv, random);
                if (!sunny) continue;
                // One sunlit patch, by its power and usefulness.
                const auto found = static_cast<std::size_t>(std::upper_bound(cumulative.begin(), cumulative.end(), which * cumulative.back()) - cumulative.begin());
                const std::size_t picked = std::min(found, patches.size() - 1);
                const SunPatch& patch = patches[picked];
                const Vec3f from = at.position + at.normal * distance_epsilon(at.position), to = patch.position - from;
                const float d2 = dot(to, to), far = std::sqrt(d2);
                if (!(far > near_sun)) continue;
                const Vec3f direction = to / far;
                const float here = dot(at.normal, direction), there = -dot(patch.normal, direction);
                if (!(here > 0 && there > 0) || bvh.blocked(from, direction, 0.f, far - 0.3f * cache.cell_m_)) continue;
                const float chance = luminance(patch.leaving) * patch.area * useful[picked] / cumulative.back();
                direct += patch.leaving * (here * there / (kPi * d2) * patch.area / chance);
            }
            cell.direct = direct / static_cast<float>(direct_samples);
        }
        progress.advance();
    });
    cache.smooth(false, 1, 0.3f);
    cache.smooth(false, 2, 0.15f);

    // Everything else: what each entry sees of the others, pass by pass one bounce more. The first six passes only bring the
    // light round the room (in a bright room a tenth of it has bounced more than four times); the mean of the last two is kept.
    std::vector<Vec3f> gathered(cache.cells_.size());
    std::vector<Vec3f> kept(cache.cells_.size());
    const int total = std::max(8, params.cell_samples);
    constexpr int kKept = 2;
    for (int pass = 0; pass < kPasses; ++pass) {
        const bool keep = pass >= kPasses - kKept;
        const int n = std::max(2, keep ? total / 4 : total / 12);
        parallel_for(count, 1024, [&](std::int64_t begin, std::int64_t end) {
            run.check_stop();
            for (std::int64_t i = begin; i < end; ++i) {
                const auto c = static_cast<std::size_t>(i);
                Random random(key(c, static_cast<std::uint64_t>(pass) + 1));
                const Vec2f shift{random.uniform(), random.uniform()};
                Vec3f sum{};
                int valid = 0;
                for (int s = 0; s < n; ++s) {
                    const Sample& at = sample_of(c, s);
                    const Vec2f uv = r2_point(static_cast<std::uint32_t>(s), shift);
                    const Vec3f direction = cosine_direction(at.normal, uv.x, uv.y);
                    const Vec3f from = at.position + at.normal * distance_epsilon(at.position);
                    const RayHit hit = bvh.first_hit(from, direction);
                    if (!hit) {  // through a window: counted with the windows
                        ++valid;
                        continue;
                    }
                    const Mesh& mesh = room.meshes[static_cast<std::size_t>(hit.mesh)];
                    // A back face of a solid: this bit of surface is buried in it and nobody will see it.
                    if (hit.back && closed[static_cast<std::size_t>(hit.mesh)]) continue;
                    ++valid;
                    const Vec3f p = from + direction * hit.distance;
                    Vec3f normal = shading_normal(mesh, hit);
                    if (hit.back) normal = -normal;
                    const Material& m = room.materials[static_cast<std::size_t>(mesh.material)];
                    // The sun's first bounce has been asked directly, unless it is close by.
                    const bool with_sun = hit.distance <= near_sun;
                    Vec3f arriving = cache.near(p, normal, with_sun) * (1.f - m.transmission);
                    if (m.transmission > 0) arriving += cache.near(p, -normal, with_sun) * m.transmission;
                    sum += albedo[static_cast<std::size_t>(mesh.material)] * arriving;
                    if (lights.is_large(hit.mesh)) sum += m.emission * kPi;
                }
                gathered[c] = valid ? sum / static_cast<float>(valid) : Vec3f{};
            }
            progress.advance();
        });
        for (std::size_t c = 0; c < cache.cells_.size(); ++c) {
            cache.cells_[c].indirect = gathered[c];
            if (keep) kept[c] += gathered[c] * (1.f / kKept);
        }
        if (!keep) cache.smooth(true, 2, 0.8f);
    }
    for (std::size_t c = 0; c < cache.cells_.size(); ++c) cache.cells_[c].indirect = kept[c];
    // Entries are gathered one by one; what remains of their noise is spread over the neighbours, widely because bounced
    // light changes slowly. The tolerance is a few standard deviations of a gather of this many rays.
    const float tolerance = std::clamp(3.f / std::sqrt(static_cast<float>(total)), 0.12f, 0.6f);
    cache.smooth(true, 2, tolerance);
    cache.smooth(true, 2, tolerance);
    cache.samples_ = {};
    return cache;
}

}  // namespace fastscene
