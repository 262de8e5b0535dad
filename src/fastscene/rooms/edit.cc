// Edits of a document by steps.
#include "fastscene/rooms/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/base/suggest.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace editing {
namespace {

constexpr const char* kName = "room";  // of the document, in messages

}  // namespace

std::string in_words(std::string kind) {
    const std::string name = kind;
    std::replace(kind.begin(), kind.end(), '_', ' ');
    // "Bed single" is a single bed.
    const std::size_t last = kind.rfind(' ');
    if (last == kind.npos) return kind;
    const std::string turned = kind.substr(last + 1) + " " + kind.substr(0, last);
    const auto word = look_up(turned);
    return word && word->kind == WordKind::object && word->meaning == name ? turned : kind;
}

Editor::Editor(const RoomDocument& document, std::shared_ptr<const FurniturePack> pack, const Run& run)
    : pack_(std::move(pack)), run_(run), room_(furnish_document(document, kName, pack_, run)) {
    result_.document = document_of(room_);
    // What leaves nothing open was built as it stands.
    if (document_json(result_.document) != document_json(document)) build();
}

void Editor::build() {
    try {
        room_ = furnish_document(result_.document, kName, pack_, run_);
    } catch (const CameraInside&) {
        RoomDocument without = result_.document;
        without.camera.reset();
        const DocumentRoom room = furnish_document(without, kName, pack_, run_);
        const auto eye = free_viewpoint(room.furnished);
        if (!eye) throw;
        result_.document.camera->position = *eye;
        room_ = furnish_document(result_.document, kName, pack_, run_);
    }
}

int Editor::index_of(const std::string& id) const {
    const std::vector<DocumentThing>& things = result_.document.things;
    const auto found = std::find_if(things.begin(), things.end(), [&](const DocumentThing& t) { return t.id == id; });
    if (found != things.end()) return static_cast<int>(found - things.begin());
    std::vector<std::string> ids;
    for (const DocumentThing& t : things) ids.push_back(t.id);
    const std::string near = nearest_word(id, ids);
    throw UsageError("there is no \"{}\" in the room{}", id,
                     near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near));
}

const Placed& Editor::placed(const std::string& id) const { return placed(index_of(id)); }

std::vector<int> Editor::with_riders(const std::vector<int>& roots) const {
    const std::vector<Placed>& all = room_.furnished.placed;
    std::vector<int> out = roots;
    for (std::size_t k = 0; k < out.size(); ++k)
        for (int i = 0; i < static_cast<int>(all.size()); ++i)
            if (placed(i).on == out[k] && std::find(out.begin(), out.end(), i) == out.end()) out.push_back(i);
    return out;
}

void Editor::tell(const std::string& id, const std::string& what) { result_.changes.push_back({id, what}); }

// Once, however many ways lead to it.
void Editor::tell_smaller(const std::string& id) {
    if (smaller_.insert(id).second) tell(id, "smaller than usual: there was no more room");
}

std::string Editor::new_id(const std::string& kind) const {
    const RoomDocument& document = result_.document;
    std::set<std::string> ids;
    for (const DocumentThing& t : document.things) ids.insert(t.id);
    if (document.next_room)
        for (const DocumentThing& t : document.next_room->things) ids.insert(t.id);
    int n = 1;
    while (ids.contains(fmt::format("{}-{}", kind, n))) ++n;
    return fmt::format("{}-{}", kind, n);
}

void Editor::take(const std::vector<std::string>& ids) {
    std::vector<int> roots;
    for (const std::string& id : ids) roots.push_back(index_of(id));
    std::set<std::string> gone;
    for (const int i : with_riders(roots)) gone.insert(thing(i).id);
    std::vector<DocumentThing>& things = result_.document.things;
    for (const DocumentThing& t : things)
        if (gone.contains(t.id)) tell(t.id, t.on.empty() || !gone.contains(t.on) ? "removed" : "removed with " + t.on);
    std::erase_if(things, [&](const DocumentThing& t) { return gone.contains(t.id); });
    for (DocumentThing& t : things)
        for (std::string* id : {&t.on, &t.below, &t.with})
            if (gone.contains(*id)) id->clear();
    build();
}

namespace {

// A linear albedo as "#rrggbb".
std::string as_hex(Vec3f linear) {
    std::string out = "#";
    for (std::size_t a = 0; a < 3; ++a) {
        const float c = std::clamp(linear[a], 0.f, 1.f);
        const float s = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
        out += fmt::format("{:02x}", static_cast<int>(std::lround(255 * s)));
    }
    return out;
}

Vec3f color_of(const Piece& piece) {
    const auto main = static_cast<std::size_t>(piece.main_material);
    return main < piece.materials.size() ? piece.materials[main].color_a : Vec3f{0.5f, 0.5f, 0.5f};
}

void repaint(Material& m, const EditStep& step, const Style& style) {
    if (step.brighter == 1) {
        PromptObject wish = step.wish;
        if (!wish.color2.empty() && wish.material.empty() && wish.pattern.empty()) {
            // Tiles of two colors alternate.
            if (!is_tiled(m))
                throw UsageError("expected one color, or two with a pattern: \"white with black stripes\"");
            wish.material = "tile";
        }
        return apply_wish(m, wish, true, style.palette);
    }
    for (Vec3f* c : {&m.color_a, &m.color_b, &m.color_c})
        for (std::size_t a = 0; a < 3; ++a) (*c)[a] = std::min(0.85f, (*c)[a] * step.brighter);
}

}  // namespace

std::string Editor::color_seen(const std::string& id) const {
    const DocumentThing& t = result_.document.things[static_cast<std::size_t>(index_of(id))];
    return t.color.empty() ? as_hex(color_of(placed(id).piece)) : t.color;
}

void Editor::recolor(const EditStep& step) {
    const PromptObject& looks = step.wish;
    std::string said;
    for (const auto& [key, value] : {std::pair{"color", looks.color},
                                     {"second color", looks.color2},
                                     {"material", looks.material},
                                     {"pattern", looks.pattern},
                                     {"color of the top", looks.holder_color},
                                     {"top", looks.holder_material}})
        if (!value.empty()) said += fmt::format("{}{}: {}", said.empty() ? "" : ", ", key, value);
    if (!step.surface.empty()) return recolor_surface(step, said);
    for (const std::string& id : step.ids) {
        const int i = index_of(id);
        DocumentThing& t = thing(i);
        if (!t.asked) {
            t.asked.emplace();
            t.asked->kind = t.kind, t.asked->words = in_words(t.kind);
        }
        // Another material has its own color.
        if (!looks.material.empty()) t.color = t.asked->color = "", t.material = t.asked->material = looks.material;
        if (!looks.color.empty()) t.color = t.asked->color = looks.color;
        if (!looks.holder_color.empty()) t.holder_color = t.asked->holder_color = looks.holder_color;
        if (!looks.holder_material.empty()) t.holder_material = t.asked->holder_material = looks.holder_material;
        if (!looks.color2.empty()) t.color2 = t.asked->color2 = looks.color2;
        if (!looks.pattern.empty()) t.pattern = t.asked->pattern = looks.pattern;
        if (step.brighter != 1) t.color = t.asked->color = as_hex(color_of(placed(i).piece) * step.brighter);
        tell(id, step.brighter != 1 ? "color: " + t.color : said);
    }
    build();
}

// One wall alone; the others keep their look.
void Editor::recolor_wall(int wall, const EditStep& step, const std::string& said) {
    const Plan& now = plan();
    auto& own = result_.document.surfaces.walls[static_cast<std::size_t>(wall)];
    Material m = now.wall_material(wall);
    repaint(m, step, now.style);
    if (!step.wish.color.empty()) m.name = step.wish.color + " wall";
    own = m;
    tell(fmt::format("wall {}", wall), step.brighter != 1 ? (step.brighter > 1 ? "lighter" : "darker") : said);
    build();
}

void Editor::recolor_surface(const EditStep& step, const std::string& said) {
    const Style& style = room_.furnished.plan.style;
    DocumentSurfaces& own = result_.document.surfaces;
    if (step.wall >= 0) return recolor_wall(step.wall, step, said);
    if (step.surface == "accent_wall") {
        if (!plan().accent) throw Error("there is no accent wall in the room; name one: \"the wall behind the bed\"");
        return recolor_wall(plan().accent_wall, step, said);
    }
    if (step.surface == "wall" && !step.elsewhere) own.walls = {};  // else those with a look of their own keep it
    const std::vector<std::pair<std::string_view, std::pair<std::optional<Material>*, const Material*>>> parts{
        {"wall", {&own.wall, &style.wall}},
        {"accent_wall", {&own.accent_wall, &style.accent_wall}},
        {"floor", {&own.floor, &style.floor}},
        {"ceiling", {&own.ceiling, &style.ceiling}},
        {"trim", {&own.trim, &style.trim}}};
    for (const auto& [name, part] : parts) {
        // "The walls" are all of them.
        if (name != step.surface && !(name == "accent_wall" && step.surface == "wall")) continue;
        Material m = *part.second;
        repaint(m, step, style);
        if (!step.wish.color.empty()) m.name = step.wish.color + " " + step.surface;
        *part.first = m;
    }
    tell(step.surface, step.brighter != 1 ? (step.brighter > 1 ? "lighter" : "darker") : said);
    build();
}

namespace {

// Those of the style; wet rooms keep their tiles.
DocumentSurfaces fresh_surfaces(const DocumentSurfaces& old, const std::string& type, const Style& style) {
    DocumentSurfaces out;
    out.shelves = old.shelves;
    if (room_type(type).wet) out.floor = style.wet_floor, out.accent_wall = style.wet_wall;
    return out;
}

}  // namespace

void Editor::restyle(const std::string& name) {
    const Style& style = style_named(name);
    RoomDocument& document = result_.document;
    if (document.style == style.name) throw AlreadySo(fmt::format("the room is {} already", in_words(style.name)));
    document.surfaces = fresh_surfaces(document.surfaces, document.type, style);
    if (document.next_room)
        document.next_room->surfaces = fresh_surfaces(document.next_room->surfaces, document.next_room->type, style);
    document.style = style.name;
    tell("room", "style: " + style.name);
    build();
}

void Editor::apply(const EditStep& step) {
    const Vec3f camera = room_.furnished.camera;
    const bool blocked = camera_blocked();
    act(step);
    settle_camera(camera, blocked);
}

void Editor::act(const EditStep& step) {
    switch (step.kind) {
        case EditStep::Kind::remove: return take(step.ids);
        case EditStep::Kind::move:
        case EditStep::Kind::turn: return move(step);
        case EditStep::Kind::place: return place(step);
        case EditStep::Kind::shift: return shift(step);
        case EditStep::Kind::face: return face(step);
        case EditStep::Kind::swap: return swap(step);
        case EditStep::Kind::recolor: return recolor(step);
        case EditStep::Kind::resize: return resize(step);
        case EditStep::Kind::reshape: return reshape(step);
        case EditStep::Kind::line: return line_up(step);
        case EditStep::Kind::circle: return encircle(step);
        case EditStep::Kind::rows: return in_rows_of(step);
        case EditStep::Kind::join: return join(step);
        case EditStep::Kind::space: return space_out(step);
        case EditStep::Kind::add: return add(step);
        case EditStep::Kind::replace: return replace(step);
        case EditStep::Kind::restyle: return restyle(step.value);
        case EditStep::Kind::light: return light(step.value);
        case EditStep::Kind::shine: return shine(step);
    }
}

}  // namespace editing

EditResult edit_document(const RoomDocument& document, const std::vector<EditStep>& steps,
                         std::shared_ptr<const FurniturePack> pack, const Run& run) {
    editing::Editor editor(document, std::move(pack), run);
    for (const EditStep& step : steps) editor.apply(step);
    return editor.result();
}

}  // namespace fastscene
