#include "fastscene/rooms/rooms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/daylight.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/user_texture.h"
#include "fastscene/scene/pose_json.h"

namespace fastscene {
namespace {

std::string name_of(const Placed& placed) {
    std::string name = placed.piece.kind;
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!placed.wish.material.empty()) name = placed.wish.material + " " + name;
    if (!placed.wish.color.empty()) name = placed.wish.color + " " + name;
    return name;
}

// Fires burn always; candles when they were asked for, or when lamps are lit; all of them as was said of them.
bool is_burning(const Placed& placed, float lamps) {
    if (placed.lit) return *placed.lit > 0;
    return lamps > 0 || !placed.wish.kind.empty() || placed.piece.kind == "fireplace";
}

void add_piece(const Placed& placed, float lamps, Room& room) {
    constexpr float kSignByNight = 0.15f;
    const auto object = static_cast<int>(room.objects.size());
    const auto first_material = static_cast<int>(room.materials.size());
    const float share = placed.lit.value_or(lamps);
    for (Material material : placed.piece.materials) {
        // Screens and flames glow by day too; lamps only as the hour asks.
        if (material.pattern != Pattern::screen && !material.burns) material.emission = material.emission * share;
        // Eyes and cameras open up by night: a sign as bright as by day would burn out the wall that it stands before,
        // and itself with it.
        if (placed.piece.kind == "neon_sign" && lamps > 0) material.emission = material.emission * kSignByNight;
        room.materials.push_back(std::move(material));
    }
    const Rigid room_from_object{rotation_about(Vec3f{0, 1, 0}, placed.yaw), placed.position};
    RoomObject entry;
    entry.id = placed.id;
    // Another builder may stand in for what was asked for; the name says which.
    entry.kind = placed.wish.kind.empty() ? placed.piece.kind : placed.wish.kind;
    entry.name = name_of(placed);
    entry.color = placed.wish.color;
    entry.world_from_object = room_from_object;
    entry.size_m = placed.piece.size_m;
    entry.source = placed.piece.source;
    entry.requested = !placed.wish.kind.empty();
    room.objects.push_back(entry);
    const bool burning = is_burning(placed, lamps);
    for (Mesh mesh : placed.piece.meshes) {
        if (!burning && placed.piece.materials[static_cast<std::size_t>(mesh.material)].burns) continue;
        mesh.material += first_material;
        mesh.object = object;
        for (Vec3f& p : mesh.positions) p = room_from_object * p;
        for (Vec3f& n : mesh.normals) n = room_from_object.rotation * n;
        room.meshes.push_back(std::move(mesh));
    }
}

void turn_into_world(const Rigid& world_from_room, Room& room) {
    for (Mesh& mesh : room.meshes) {
        for (Vec3f& p : mesh.positions) p = world_from_room * p;
        for (Vec3f& n : mesh.normals) n = world_from_room.rotation * n;
    }
    for (RoomObject& o : room.objects) o.world_from_object = world_from_room * o.world_from_object;
    for (Portal& p : room.portals) {
        p.corner = world_from_room * p.corner;
        p.edge_u = world_from_room.rotation * p.edge_u;
        p.edge_v = world_from_room.rotation * p.edge_v;
    }
}

// "a two metre wide bed" that is not so wide.
void tell_size(const Placed& placed, PromptSpec& spec) {
    static constexpr std::array<const char*, 3> kExtents{"wide", "high", "deep"};
    const Vec3f &is = placed.piece.size_m, &said = placed.wish.size_m;
    std::string text;
    for (std::size_t a = 0; a < 3; ++a)
        if (said[a] > 0 && std::abs(is[a] - said[a]) > 0.02f + 0.04f * said[a])
            text += fmt::format("{}{:.2f} m {}", text.empty() ? "" : ", ", is[a], kExtents[a]);
    if (text.empty()) return;
    for (PromptWord& word : spec.words)
        if (word.object == placed.wish.id && word.measure)
            word.fate = PromptWord::Fate::approximated, word.meaning = "the " + placed.wish.words + " is " + text;
}

// How many of each wish stand. Parts of the shell are there unless make_plan said why not.
void count_placed(const FurnishedRoom& room, PromptSpec& spec) {
    for (PromptObject& object : spec.objects) object.placed = 0;
    for (const Placed& placed : room.placed) {
        if (placed.wish.id < 0) continue;
        ++spec.objects[static_cast<std::size_t>(placed.wish.id)].placed;
        if (const auto there = stands_as_asked(room.plan, room.placed, placed, placed.wish); there && !*there)
            for (PromptWord& word : spec.words)
                if (word.object == placed.wish.id && word.relation)
                    word.fate = PromptWord::Fate::approximated,
                    word.meaning = "the " + placed.wish.words + " stands elsewhere: no free place there";
        tell_size(placed, spec);
        if (placed.piece.kind == placed.wish.kind) continue;
        if (placed.wish.kind == "plant" && is_one_of(placed.piece.kind, {"plant_small", "hanging_plant"}))
            continue;  // in a smaller pot they are plants
        for (PromptWord& word : spec.words)
            if (word.object == placed.wish.id && word.words == placed.wish.words &&
                word.fate == PromptWord::Fate::understood) {
                word.fate = PromptWord::Fate::approximated;
                word.meaning += "; shown as " + placed.piece.kind;
            }
    }
    for (const Placed& placed : room.placed_next)
        if (placed.wish.id >= 0) ++spec.objects[static_cast<std::size_t>(placed.wish.id)].placed;
    for (PromptObject& object : spec.objects)
        if (is_shell(object.kind) && !object.forbidden)
            object.placed = object.count -
                            static_cast<int>(std::count_if(
                                spec.not_placed.begin(), spec.not_placed.end(),
                                [&](const std::string& line) { return line.starts_with(object.words + ": "); }));
}

bool is_asked_next_door(const PromptObject& o) { return !o.forbidden && o.relation == "in the next room"; }

// "A green wall behind the bed": the wall that the bed came to stand at.
void turn_accent(const PromptSpec& spec, const std::vector<Placed>& placed, Plan& plan) {
    for (const PromptObject& wish : spec.objects) {
        if (wish.kind != "wall" || wish.forbidden || wish.relation != "behind") continue;
        const auto piece = std::find_if(placed.begin(), placed.end(), [&](const Placed& p) {
            return p.piece.kind == wish.relation_to || p.wish.kind == wish.relation_to;
        });
        if (piece == placed.end()) continue;
        for (int i = 0; i < 4; ++i)
            if (dot(plan.wall(i).inward, front_of(piece->yaw)) > 0.9f) plan.accent_wall = i;
        return;
    }
}

FurnishedRoom furnish_once(PromptSpec& spec, const Run& run, const std::string& draw, const AnnealParams& annealing) {
    Random rng(run.seed, "room:" + spec.text + draw);
    assume_time(spec, run.seed);
    FurnishedRoom out;
    out.plan = make_plan(spec, rng);
    Layout layout(out.plan, spec, rng, annealing);
    furnish(layout);
    out.annealed = layout.annealed();
    out.placed = layout.placed();
    turn_accent(spec, out.placed, out.plan);
    out.camera = layout.viewpoint();
    out.looks = usual_look(out, spec.room);
    out.hidden_wishes = static_cast<int>(layout.unseen(out.camera).size());
    furnish_next(spec, run, annealing, out);
    return out;
}

// Whether one can walk from the door to where the camera stands.
bool has_a_way(const FurnishedRoom& room) {
    Ways ways(room.plan);
    for (const Placed& p : room.placed) ways.add(p);
    return ways.open() && ways.reaches(flat(room.camera));
}

// Share of the floor between the furniture that cannot be walked to.
float share_cut_off(const FurnishedRoom& room) {
    Ways ways(room.plan);
    for (const Placed& p : room.placed) ways.add(p);
    return ways.cut_off() / std::max(ways.free_floor(), 0.01f);
}

// Pieces that do not stand where the prompt says.
std::size_t misplaced(const FurnishedRoom& room) {
    return static_cast<std::size_t>(std::count_if(room.placed.begin(), room.placed.end(), [&](const Placed& p) {
        return p.wish.id >= 0 && !stands_as_asked(room.plan, room.placed, p, p.wish).value_or(true);
    }));
}

// A room is for who asked for it by its beds: one of them is missing.
bool lacks_a_bed(const FurnishedRoom& room, const PromptSpec& spec) {
    constexpr int kMost = 3;  // more is for halls
    return std::any_of(spec.objects.begin(), spec.objects.end(), [&](const PromptObject& o) {
        return has_role(o.kind, Role::bed) && !o.forbidden && o.relation != "in the next room" && o.count <= kMost &&
               std::count_if(room.placed.begin(), room.placed.end(),
                             [&](const Placed& p) { return p.wish.id == o.id; }) < o.count;
    });
}

// What the first view is of: the thing that such a room is known by. Null: none.
const Placed* main_thing(const FurnishedRoom& room, const std::string& type) {
    const auto first = [&](std::string_view kind) {
        const auto at = std::find_if(room.placed.begin(), room.placed.end(), [&](const Placed& p) {
            return p.piece.kind == kind &&
                   std::hypot(p.position.x - room.camera.x, p.position.z - room.camera.z) > 0.4f;
        });
        return at == room.placed.end() ? nullptr : &*at;
    };
    if (const Placed* thing = first(room_type(type).look_at)) return thing;
    for (const char* kind : {"bed", "bed_single", "canopy_bed", "four_poster_bed", "floor_bed", "bunk_bed", "loft_bed",
                             "cabin_bed", "crib", "sofa", "loveseat", "dining_table", "kitchen_counter", "bathtub",
                             "desk", "sideboard", "washing_machine"})
        if (const Placed* thing = first(kind)) return thing;
    return nullptr;
}

// The share of the first view, to both sides of its middle, that something tall close by fills which nobody asked to
// see; with `walls`, walls too.
float share_blocked(const FurnishedRoom& room, Vec3f look, const Placed* shown, bool walls) {
    constexpr float kClose = 1.5f, kHalfView = 36.f * kPi / 180;  // metres, radians
    constexpr int kRays = 13;
    const auto may_block = [&](const Placed& p) {
        return &p != shown && !p.flat && (p.wish.kind.empty() || p.wish.count > 1);
    };
    int blocked = 0;
    for (int i = 0; i < kRays; ++i) {
        const float turn = kHalfView * (2.f * static_cast<float>(i) / (kRays - 1) - 1), c = std::cos(turn),
                    s = std::sin(turn);
        const Vec3f to = room.camera + Vec3f{c * look.x + s * look.z, 0, c * look.z - s * look.x} * kClose;
        const bool outside = std::abs(to.x) > room.plan.width / 2 || std::abs(to.z) > room.plan.depth / 2;
        blocked += (walls && outside) || std::any_of(room.placed.begin(), room.placed.end(), [&](const Placed& p) {
                       return may_block(p) && passes(footprint_of(p), room.camera, to);
                   });
    }
    return static_cast<float>(blocked) / kRays;
}

}  // namespace

Vec3f usual_look(const FurnishedRoom& room, const std::string& type) {
    if (room_type(type).look_along || room.plan.mezzanine.depth > 0) return {0, 0, 1};
    const Placed* shown = main_thing(room, type);
    const Vec3f wanted = shown
                             ? normalize(Vec3f{shown->position.x - room.camera.x, 0, shown->position.z - room.camera.z})
                         : room.plan.depth >= room.plan.width ? Vec3f{0, 0, 1}
                                                              : Vec3f{1, 0, 0};
    // A shelf or a rack close by hides what the view is of: it turns aside, no farther than it must.
    constexpr float kMostBlocked = 0.3f, kPerHalfTurn = 0.5f;  // what half a turn costs, as a share blocked
    constexpr int kDirections = 24;
    Vec3f best = wanted;
    if (share_blocked(room, wanted, shown, false) <= kMostBlocked) return wanted;
    float least = share_blocked(room, wanted, shown, true);
    for (int i = 1; i < kDirections; ++i) {
        const float turn = 2 * kPi * static_cast<float>(i) / kDirections, c = std::cos(turn), s = std::sin(turn);
        const Vec3f look{c * wanted.x + s * wanted.z, 0, c * wanted.z - s * wanted.x};
        const float cost = share_blocked(room, look, shown, true) +
                           kPerHalfTurn * std::acos(std::clamp(c, -1.f, 1.f)) / kPi;
        if (cost < least) least = cost, best = look;
    }
    return best;
}

void furnish_next(PromptSpec& spec, const Run& run, const AnnealParams& annealing, FurnishedRoom& room) {
    if (room.plan.next) {
        PromptSpec next;
        next.room = room.plan.next->type;
        next.style = spec.style;
        next.time = spec.time;
        next.mood = spec.mood;
        next.clutter = spec.clutter;
        next.pack = spec.pack;
        for (PromptObject o : spec.objects) {
            const bool there = is_asked_next_door(o);
            if (there) o.relation.clear();
            if (o.forbidden || there) next.objects.push_back(o);
        }
        Random next_rng(run.seed, "next room:" + spec.text);
        Layout beyond(room.plan.next->plan, next, next_rng, annealing);
        furnish(beyond);
        room.placed_next = beyond.placed();
        spec.not_placed.insert(spec.not_placed.end(), next.not_placed.begin(), next.not_placed.end());
        for (Placed& p : room.placed_next) {
            const Rigid& move = room.plan.next->room_from_next;
            p.position = move * p.position;
            p.yaw = yaw_of(move.rotation * front_of(p.yaw));
        }
    } else {
        for (const PromptObject& o : spec.objects)
            for (int i = 0; i < (is_asked_next_door(o) ? o.count : 0); ++i)
                spec.not_placed.push_back(o.words + ": there is no second room");
    }
}

namespace {

// "A staircase in a room 1.9 m high" is the hall of a staircase, and has none: what the room is named after does not
// fit where sizes were said.
void tell_missing(const FurnishedRoom& room, PromptSpec& spec) {
    const RoomType& type = room_type(spec.room);
    const bool measured = spec.area_m2 > 0 || spec.size_m != Vec3f{};
    const std::string& thing = type.as_thing.empty() ? type.look_at : type.as_thing;
    if (!measured || thing.empty() ||
        std::any_of(room.placed.begin(), room.placed.end(), [&](const Placed& p) { return p.piece.kind == thing; }))
        return;
    std::string name = thing;
    std::replace(name.begin(), name.end(), '_', ' ');
    for (PromptWord& word : spec.words)
        if (word.fate == PromptWord::Fate::understood && word.meaning.starts_with("room: "))
            word.fate = PromptWord::Fate::approximated, word.meaning += ", too small for its " + name;
}

}  // namespace

FurnishedRoom furnish_room(PromptSpec& spec, const Run& run, const AnnealParams& annealing) {
    // Now and then the plan itself leaves no way between its corners and what was asked for, or no place where it was
    // asked to stand, or something that was asked for stands behind something else: then another one is drawn, and the
    // best is kept.
    constexpr int kDraws = 4;
    constexpr float kMostCutOff = 0.03f;  // share of the free floor
    std::optional<FurnishedRoom> best;
    PromptSpec best_read;
    std::tuple<bool, std::size_t, float> fewest;  // no way; pieces hidden or left out; floor beyond that is cut off
    for (int draw = 0; draw < kDraws; ++draw) {
        PromptSpec read = spec;
        FurnishedRoom room = furnish_once(read, run, draw == 0 ? "" : " " + std::to_string(draw), annealing);
        const std::size_t elsewhere = misplaced(room);
        const std::tuple faults{!has_a_way(room),
                                static_cast<std::size_t>(room.hidden_wishes) + read.not_placed.size() + elsewhere,
                                std::max(0.f, share_cut_off(room) - kMostCutOff)};
        if (best && faults >= fewest) continue;
        fewest = faults;
        best = std::move(room);
        best_read = std::move(read);
        const auto [no_way, lacking, cut_off] = faults;
        if (!no_way && cut_off == 0 && best->hidden_wishes == 0 && elsewhere == 0 && !lacks_a_bed(*best, best_read))
            break;
    }
    spec = std::move(best_read);
    tell_missing(*best, spec);
    return *std::move(best);
}

Room make_room(PromptSpec& spec, const Run& run) { return room_of(spec, furnish_room(spec, run), run); }

namespace {

// The pictures of the user's textures, wherever the room has them; they are looked up by shares of their width. `used`
// is told whose they are.
void add_pictures(const FurniturePack* pack, Room& room, std::vector<std::string>& used) {
    std::vector<bool> added(room.materials.size(), false);
    for (std::size_t i = 0; i < room.materials.size(); ++i) {
        Material& m = room.materials[i];
        if (!lacks_pictures(m)) continue;
        if (!pack) throw Error("texture \"{}\": expected --assets with the folder that holds it, found none", m.name);
        const Vec3f tint = m.color_a;
        m = pack->texture(m.name);
        m.color_a = tint;
        added[i] = true;
        const std::string credit = fmt::format("{}: {}", kTextureUsed, pack->credit_of_texture(m.name));
        if (std::find(used.begin(), used.end(), credit) == used.end()) used.push_back(credit);
    }
    for (Mesh& mesh : room.meshes)
        if (const auto i = static_cast<std::size_t>(mesh.material); added[i])
            for (Vec3f& c : mesh.coords) c = c / room.materials[i].scale_m;
}

}  // namespace

Room room_of(PromptSpec& spec, const FurnishedRoom& furnished, const Run& run) {
    const Plan& plan = furnished.plan;
    Random rng = light_draws(spec, run.seed);
    Room room;
    room.type = spec.room;
    room.style = plan.style.name;
    room.seed = mix64(run.seed ^ hash_name(spec.text));
    build_shell(plan, room);
    const float lamps = furnished.lamps.value_or(lamp_level(spec, plan));
    for (Material& material : room.materials)  // of the shell: recessed lights
        if (material.name != kNeon) material.emission = material.emission * lamps;
    for (const Placed& placed : furnished.placed) add_piece(placed, lamps, room);
    for (const Placed& placed : furnished.placed_next) add_piece(placed, lamps, room);
    add_pictures(spec.pack.get(), room, spec.assumed);
    count_placed(furnished, spec);

    // World: x right, y down, z where the camera looks; a proper rotation of the room frame, nothing is mirrored.
    const Vec3f camera = furnished.camera, forward = furnished.looks, down{0, -1, 0};
    const Mat3f rotation{cross(down, forward), down, forward};
    const Rigid world_from_room{rotation, -(rotation * camera)};
    turn_into_world(world_from_room, room);
    room.sky = make_sky(spec, plan, rotation, rng);
    if (furnished.towards_sun && !room.sky.picture) room.sky.sun_dir = rotation * *furnished.towards_sun;
    if (spec.mood == "cozy") room.look.white = {1.03f, 1.f, 0.95f};

    room.min_corner = {1e9f, 1e9f, 1e9f};
    room.max_corner = {-1e9f, -1e9f, -1e9f};
    for (const float x : {-plan.width / 2, plan.width / 2})
        for (const float y : {0.f, plan.height})
            for (const float z : {-plan.depth / 2, plan.depth / 2}) {
                const Vec3f p = world_from_room * Vec3f{x, y, z};
                for (std::size_t a = 0; a < 3; ++a) {
                    room.min_corner[a] = std::min(room.min_corner[a], p[a]);
                    room.max_corner[a] = std::max(room.max_corner[a], p[a]);
                }
            }
    return room;
}

Json room_json(const Room& room, const Image<std::int32_t>& object_of_pixel) {
    std::vector<std::int64_t> visible(room.objects.size(), 0);
    for (const std::int32_t i : object_of_pixel.pixels)
        if (i >= 0 && static_cast<std::size_t>(i) < visible.size()) ++visible[static_cast<std::size_t>(i)];
    const auto vec = [](Vec3f v) { return Json{v.x, v.y, v.z}; };
    Json objects = Json::array();
    for (std::size_t i = 0; i < room.objects.size(); ++i) {
        const RoomObject& o = room.objects[i];
        objects.push_back({{"class", o.kind},
                           {"name", o.name},
                           {"color", o.color},
                           {"visible_pixels", visible[i]},
                           {"world_from_object", json_from_pose(o.world_from_object, Decimals::exact)},
                           {"size_m", vec(o.size_m)},
                           {"source", o.source},
                           {"requested", o.requested}});
    }
    return {{"room", room.type},
            {"style", room.style},
            {"objects", objects},
            {"bounds_m", {{"min", vec(room.min_corner)}, {"max", vec(room.max_corner)}}},
            {"sun_direction", vec(room.sky.sun_dir)},
            {"windows", room.portals.size()}};
}

}  // namespace fastscene
