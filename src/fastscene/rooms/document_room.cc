// A document and its room, both ways.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "fastscene/base/check.h"
#include "fastscene/base/error.h"
#include "fastscene/rooms/daylight.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/footprint.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/tops.h"

namespace fastscene {
namespace {

// ---- a room as a document

}  // namespace

DocumentThing thing_of(const Placed& p, const std::vector<std::string>& ids, std::size_t index) {
    const PieceRequest& r = *p.piece.made_from;
    const auto id = [&](int i) { return i < 0 ? std::string() : ids[static_cast<std::size_t>(i)]; };
    DocumentThing t;
    t.id = ids[index];
    t.kind = r.kind;
    t.position = p.position;
    t.yaw = p.yaw;
    t.on = id(p.on), t.below = id(p.below), t.with = id(p.with);
    t.window = p.sill;
    t.size_m = p.piece.size_m;
    t.seed = r.seed;
    t.style = r.style ? r.style->name : "";
    t.color = r.color_name, t.color2 = r.color2_name, t.material = r.material, t.pattern = r.pattern;
    t.holder_color = r.holder_color, t.holder_material = r.holder_material;
    t.back_color = r.back_color, t.back_material = r.back_material;
    t.cooks = r.cooks;
    t.screens = r.screens;
    t.size_factor = r.size_factor;
    t.asked_size_m = r.size_m;
    if (r.model) t.model = r.model->path;
    if (p.piece.mount != p.piece.made_mount) t.mount = p.piece.mount;
    if (p.flat != (t.kind == "rug")) t.flat = p.flat;
    if (p.overhead != (p.piece.mount == Mount::ceiling)) t.overhead = p.overhead;
    t.lit = p.lit;
    if (!p.wish.kind.empty()) t.asked = p.wish;
    return t;
}

namespace {

std::vector<DocumentThing> things_of(const std::vector<Placed>& placed, const std::vector<std::string>& ids) {
    std::vector<DocumentThing> out;
    for (std::size_t i = 0; i < placed.size(); ++i) out.push_back(thing_of(placed[i], ids, i));
    return out;
}

DocumentPlan plan_of(const Plan& plan) {
    DocumentPlan out;
    out.width = plan.width, out.depth = plan.depth, out.height = plan.height;
    out.blocks = plan.blocks;
    out.platforms = plan.platforms;
    out.openings = plan.openings;
    out.skylights = plan.skylights;
    out.knee = plan.knee, out.slope_run = plan.slope_run;
    out.measured = plan.measured, out.beams = plan.beams, out.tray = plan.tray, out.neon = plan.neon;
    out.recessed_lights = plan.recessed_lights, out.coffers = plan.coffers, out.bay = plan.bay;
    out.wall_relief = plan.relief;
    out.cabin = plan.cabin, out.tunnel = plan.tunnel, out.cove = plan.cove;
    out.mezzanine = plan.mezzanine;
    out.vault = plan.vault, out.spring = plan.spring, out.oculus = plan.oculus;
    out.panelling = plan.panelling;
    if (plan.accent) out.accent_wall = plan.accent_wall;
    out.neon_color = plan.neon_color;
    out.asked = plan.asked_parts;
    return out;
}

// ---- a document as a room

class Builder {
  public:
    Builder(const RoomDocument& document, std::string file, std::shared_ptr<const FurniturePack> pack, const Run& run)
        : document_(document), file_(std::move(file)), pack_(std::move(pack)), run_(run) {
        run_.seed = document.seed.value_or(run.seed);
    }

    DocumentRoom room() {
        check_document(document_, file_, pack_.get());
        DocumentRoom out;
        out.spec = spec();
        out.seed = run_.seed;
        assume_time(out.spec, run_.seed);
        Random rng(run_.seed, "room:" + document_.prompt);
        FurnishedRoom& room = out.furnished;
        room.plan = first_plan(out.spec, rng);
        out.spec.style = room.plan.style.name;
        room.placed = placed(document_.things, "/things", room.plan.style);
        if (document_.plan.platforms.empty()) lift_onto_platforms(room);
        check_inside(room);
        if (document_.furnish) complete(out.spec, rng, room);
        if (document_.next_room) {
            auto next = std::make_shared<NextRoom>(*room.plan.next);
            room.placed_next = placed(document_.next_room->things, "/next_room/things", next->plan.style);
        } else if (document_.furnish) {
            furnish_next(out.spec, run_, {}, room);
        }
        stand_camera(out.spec, rng, room);
        room.lamps = document_.light.lamps;
        if (document_.light.towards_sun) room.towards_sun = normalize(*document_.light.towards_sun);
        assume_outlook(out.spec, room.plan.style, run_.seed);
        return out;
    }

  private:
    PromptSpec spec() const {
        PromptSpec spec;
        spec.text = document_.prompt;
        spec.room = document_.type;
        spec.style = document_.style;
        const DocumentLight& light = document_.light;
        spec.time = light.hour, spec.weather = light.weather, spec.outlook = light.outlook;
        spec.light = light.light, spec.mood = light.mood;
        spec.pack = pack_;
        spec.size_m = {document_.plan.width, document_.plan.height, document_.plan.depth};
        return spec;
    }

    Plan first_plan(PromptSpec& spec, Random& rng) const {
        const DocumentPlan& given = document_.plan;
        if (!given.openings) {
            Plan outline;  // of the size that the outline has, the rest as for a prompt
            if (!given.polygon.empty()) {
                apply_polygon(given.polygon, file_ + ": /plan/polygon", outline);
                spec.size_m = {outline.width, given.height, outline.depth};
            }
            Plan plan = make_plan(spec, rng);
            if (!given.polygon.empty() || given.width > 0) plan.blocks = outline.blocks;
            if (given.width > 0) plan.width = given.width;
            if (given.depth > 0) plan.depth = given.depth;
            if (given.polygon.empty() && given.width > 0) plan.measured = true, cut_corners(outline_asked(spec), plan);
            if (given.accent_wall) plan.accent = true, plan.accent_wall = *given.accent_wall;
            if (!given.platforms.empty()) plan.platforms = given.platforms;
            plan.beams |= given.beams, plan.neon |= given.neon, plan.coffers |= given.coffers;
            dress(document_.surfaces, plan.style);
            plan.own_walls = document_.surfaces.walls;
            return plan;
        }
        Plan plan = plan_from(given, document_.surfaces, "/plan");
        if (document_.next_room) {
            auto next = std::make_shared<NextRoom>();
            next->type = document_.next_room->type;
            next->room_from_next = document_.next_room->room_from_next;
            next->plan = plan_from(document_.next_room->plan, document_.next_room->surfaces, "/next_room/plan");
            next->plan.joined = true;
            plan.next = std::move(next);
        }
        return plan;
    }
    Plan plan_from(const DocumentPlan& given, const DocumentSurfaces& surfaces, const std::string& pointer) const {
        Plan plan;
        plan.style = document_.style.empty() ? all_styles().front() : style_named(document_.style);
        dress(surfaces, plan.style);
        plan.own_walls = surfaces.walls;
        const RoomType& type = room_type(document_.type);
        plan.width = given.width > 0 ? given.width : (type.width_low_m + type.width_high_m) / 2;
        plan.depth = given.depth > 0 ? given.depth : (type.depth_low_m + type.depth_high_m) / 2;
        plan.height = given.height > 0 ? given.height : plan.style.ceiling_m;
        plan.blocks = given.blocks;
        plan.platforms = given.platforms;
        plan.measured = given.measured;
        if (!given.polygon.empty()) apply_polygon(given.polygon, file_ + ": " + pointer + "/polygon", plan);
        if (given.openings) plan.openings = *given.openings;
        plan.skylights = given.skylights;
        plan.knee = given.knee, plan.slope_run = given.slope_run;
        plan.beams = given.beams, plan.tray = given.tray, plan.neon = given.neon;
        plan.recessed_lights = given.recessed_lights, plan.coffers = given.coffers, plan.bay = given.bay;
        plan.relief = given.wall_relief;
        plan.cabin = given.cabin, plan.tunnel = given.tunnel, plan.cove = given.cove;
        plan.mezzanine = given.mezzanine;
        plan.vault = given.vault, plan.spring = given.spring, plan.oculus = given.oculus;
        plan.glazed = type.windows.glazed;
        plan.door = type.door;
        plan.panelling = given.panelling;
        plan.accent = given.accent_wall.has_value();
        plan.accent_wall = given.accent_wall.value_or(0);
        plan.neon_color = given.neon_color;
        plan.asked_parts = given.asked;
        return plan;
    }

    PieceRequest request(const DocumentThing& t, const Style& style) const {
        PieceRequest r;
        r.kind = t.kind;
        r.style = t.style.empty() ? &style : &style_named(t.style);
        r.seed = t.seed;
        if (!t.color.empty()) r.color = document_fields::color_said(t.color);
        r.color_name = t.color, r.color2_name = t.color2, r.material = t.material, r.pattern = t.pattern;
        r.holder_color = t.holder_color, r.holder_material = t.holder_material;
        r.back_color = t.back_color, r.back_material = t.back_material;
        r.cooks = t.cooks;
        r.screens = t.screens;
        r.size_factor = t.size_factor;
        r.size_m = t.asked_size_m;
        if (!pack_) return r;
        if (t.model.empty()) {
            if (!std::binary_search(piece_classes().begin(), piece_classes().end(), t.kind))
                r.model = pack_->choose(t.kind, t.seed);
        } else {
            for (const PackModel& model : pack_->models())
                if (model.path == t.model) r.model = &model;
        }
        if (r.model) r.pack = pack_;
        return r;
    }
    Piece piece(const DocumentThing& t, const Style& style) const {
        PieceRequest r = request(t, style);
        Piece piece = make_piece(r);
        constexpr float kSame = 1e-3f;  // metres
        bool other = false;
        for (std::size_t a = 0; a < 3; ++a)
            other = other || (t.size_m[a] > 0 && std::abs(t.size_m[a] - piece.size_m[a]) > kSame);
        if (other) {
            for (std::size_t a = 0; a < 3; ++a) r.size_m[a] = t.size_m[a] > 0 ? t.size_m[a] : piece.size_m[a];
            r.size_factor = 1;
            piece = make_piece(r);
        }
        if (t.mount) mount_as(piece, *t.mount);
        return piece;
    }
    std::vector<Placed> placed(const std::vector<DocumentThing>& things, const std::string&, const Style& style) const {
        std::map<std::string, int> index;
        for (std::size_t i = 0; i < things.size(); ++i) index[things[i].id] = static_cast<int>(i);
        const auto at = [&](const std::string& id) { return id.empty() ? -1 : index.at(id); };
        std::vector<Placed> out;
        for (const DocumentThing& t : things) {
            Placed p;
            p.id = t.id;
            p.piece = piece(t, style);
            p.position = t.position;
            p.yaw = t.yaw;
            p.on = at(t.on), p.below = at(t.below), p.with = at(t.with);
            p.sill = t.window;
            p.flat = t.flat.value_or(t.kind == "rug");
            p.overhead = t.overhead.value_or(p.piece.mount == Mount::ceiling);
            p.lit = t.lit;
            if (t.asked) p.wish = *t.asked;
            p.wish.id = -1;
            out.push_back(std::move(p));
        }
        // An edit may set things down on what was built without a top.
        for (std::size_t i = 0; i < out.size(); ++i)
            if (out[i].on >= 0) add_flat_top(out[static_cast<std::size_t>(out[i].on)].piece);
        return out;
    }

    // A document that says nothing of the floor means by y = 0 the floor, wherever a thing is.
    static void lift_onto_platforms(FurnishedRoom& room) {
        if (room.plan.platforms.empty()) return;
        std::vector<float> lifts;
        for (const Placed& p : room.placed) {
            const Placed* root = &p;
            while (root->on >= 0) root = &room.placed[static_cast<std::size_t>(root->on)];
            const bool stands = root->piece.mount == Mount::floor && root->sill < 0;
            lifts.push_back(stands ? room.plan.floor_below(footprint_of(*root)) : 0.f);
        }
        for (std::size_t i = 0; i < lifts.size(); ++i) room.placed[i].position.y += lifts[i];
    }

    void check_inside(const FurnishedRoom& room) const {
        constexpr float kTolerance = 0.01f;
        for (std::size_t i = 0; i < room.placed.size(); ++i)
            if (room.placed[i].sill < 0 && !has_role(room.placed[i].piece.kind, Role::roof) &&
                !room.plan.holds(shrunk(footprint_of(room.placed[i]), kTolerance)))
                throw Error("{}: /things/{}: {} reaches into a wall, the floor or the ceiling", file_, i,
                            document_.things[i].id);
    }

    // What the document has stays, and counts as what was asked for of its kind.
    void complete(PromptSpec& spec, Random& rng, FurnishedRoom& room) const {
        std::vector<Placed> given = room.placed;
        std::set<std::string> kinds;
        for (Placed& p : given) {
            if (p.wish.kind.empty()) p.wish.kind = p.piece.kind;
            if (!kinds.insert(p.wish.kind).second) continue;
            PromptObject known;
            known.kind = known.words = p.wish.kind;
            known.count = 0;
            known.counted = true;
            spec.objects.push_back(known);
        }
        Layout layout(room.plan, spec, rng);
        layout.begin_with(given);
        furnish(layout);
        std::vector<Placed> all = layout.placed();
        for (std::size_t i = 0; i < given.size(); ++i) all[i].wish = room.placed[i].wish;
        room.placed = std::move(all);
        spec.objects.clear();
    }

    void stand_camera(PromptSpec& spec, Random& rng, FurnishedRoom& room) const {
        if (!document_.camera) {
            Layout layout(room.plan, spec, rng);
            layout.begin_with(room.placed);
            room.camera = layout.viewpoint();
            room.looks = usual_look(room, spec.room);
            return;
        }
        room.camera = document_.camera->position;
        const std::string place = file_ + ": /camera/position";
        if (!(room.plan.air_around(room.camera) > 0))
            throw Error("{}: expected a place in the room, found one in a wall or outside", place);
        constexpr float kHead = 0.1f;  // metres above and below the eyes
        for (std::size_t i = 0; i < document_.things.size(); ++i) {
            const auto high = part_above(room.placed[i], room.camera.y - kHead);
            if (high && high->y0 < room.camera.y + kHead && distance_to(*high, flat(room.camera)) == 0.f)
                throw CameraInside("{}: the camera stands inside {}", place, document_.things[i].id);
        }
        const auto& looks = document_.camera->looks;
        room.looks = looks ? level(*looks) : usual_look(room, spec.room);
    }
    // Of length 1 already, as it was written: unchanged.
    static Vec3f level(Vec3f v) {
        v.y = 0;
        const float l = length(v);
        constexpr float kOff = 1e-5f;
        return std::abs(l - 1) < kOff ? v : normalize(v);
    }

    const RoomDocument& document_;
    std::string file_;
    std::shared_ptr<const FurniturePack> pack_;
    Run run_;
};

}  // namespace

std::vector<std::string> thing_ids(const FurnishedRoom& room) {
    std::vector<const Placed*> all;
    for (const std::vector<Placed>* part : {&room.placed, &room.placed_next})
        for (const Placed& p : *part) all.push_back(&p);
    std::set<std::string> taken;
    for (const Placed* p : all) taken.insert(p->id);
    std::map<std::string, int> count;
    std::vector<std::string> out;
    for (const Placed* p : all) {
        const std::string& kind = p->wish.kind.empty() ? p->piece.kind : p->wish.kind;
        std::string id = p->id;
        while (id.empty() || (p->id.empty() && taken.contains(id))) id = fmt::format("{}-{}", kind, ++count[kind]);
        out.push_back(id);
    }
    return out;
}

RoomDocument document_of(const PromptSpec& spec, const FurnishedRoom& furnished, std::uint64_t seed) {
    RoomDocument out;
    out.type = spec.room;
    out.style = furnished.plan.style.name;
    out.prompt = spec.text;
    out.seed = seed;
    PromptSpec lit = spec;
    assume_outlook(lit, furnished.plan.style, seed);
    out.light = {spec.time, spec.weather, lit.outlook, spec.light, spec.mood, furnished.lamps, furnished.towards_sun};
    out.camera = DocumentCamera{furnished.camera, furnished.looks};
    out.plan = plan_of(furnished.plan);
    out.surfaces = surfaces_of(furnished.plan.style, style_named(out.style));
    out.surfaces.walls = furnished.plan.own_walls;
    std::vector<std::string> ids = thing_ids(furnished);
    out.things = things_of(furnished.placed, ids);
    if (const auto& next = furnished.plan.next) {
        ids.erase(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(furnished.placed.size()));
        out.next_room = DocumentNextRoom{next->type, next->room_from_next, plan_of(next->plan),
                                         surfaces_of(next->plan.style, style_named(out.style)),
                                         things_of(furnished.placed_next, ids)};
    }
    return out;
}

Room room_of(DocumentRoom& room) { return room_of(room.spec, room.furnished, {room.seed, nullptr, {}}); }
RoomDocument document_of(const DocumentRoom& room) { return document_of(room.spec, room.furnished, room.seed); }

Json room_file_json(const RoomDocument& document, const Room& room, const Image<std::int32_t>& object_of_pixel) {
    Json out = document_json(document), shown = room_json(room, object_of_pixel);
    // Parts of the shell come first, then the things in order.
    std::vector<const std::string*> ids;
    for (const DocumentThing& t : document.things) ids.push_back(&t.id);
    if (document.next_room)
        for (const DocumentThing& t : document.next_room->things) ids.push_back(&t.id);
    Json& objects = shown["objects"];
    FASTSCENE_CHECK(ids.size() <= objects.size());
    for (std::size_t i = 0, first = objects.size() - ids.size(); i < ids.size(); ++i)
        objects[first + i]["id"] = *ids[i];
    out.update(shown);
    return out;
}

RoomDocument plan_document(PromptSpec& spec, const Run& run) {
    const FurnishedRoom furnished = furnish_room(spec, run);
    return document_of(spec, furnished, run.seed);
}

DocumentRoom furnish_document(const RoomDocument& document, const std::string& file,
                              std::shared_ptr<const FurniturePack> pack, const Run& run) {
    return Builder(document, file, std::move(pack), run).room();
}

RoomDocument completed(const RoomDocument& document, const std::string& file, std::shared_ptr<const FurniturePack> pack,
                       const Run& run) {
    return document_of(furnish_document(document, file, std::move(pack), run));
}

}  // namespace fastscene
