#include "fastscene/rooms/room_type.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "fastscene/base/check.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/file_fields.h"
#include "fastscene/rooms/style.h"

namespace fastscene {

// room_types/*.toml, by cmake/embed.cmake.
extern const file_fields::EmbeddedFile kRoomTypeTexts[];
extern const std::size_t kRoomTypeCount;

namespace {

float share(const TomlTable& table, std::string_view key) { return static_cast<float>(table.needed_number(key, 0, 1)); }

float share_or(const TomlTable& table, std::string_view key, float otherwise) {
    return static_cast<float>(table.number(key, otherwise, 0, 1));
}

std::pair<float, float> range_of(const TomlTable& table, std::string_view key) {
    constexpr double kLeast = 1.1, kMost = 16;
    const std::vector<double> ends = table.numbers(key);
    if (ends.size() != 2 || !(ends[0] >= kLeast && ends[0] <= ends[1] && ends[1] <= kMost))
        table.fail(key, fmt::format("expected [low, high] between {} and {}", kLeast, kMost));
    return {static_cast<float>(ends[0]), static_cast<float>(ends[1])};
}

std::vector<std::string> things(const TomlTable& table, std::string_view key) {
    std::vector<std::string> names = table.texts(key);
    if (names.empty()) table.fail_missing(key, "a list of things of the catalogue");
    for (std::size_t i = 0; i < names.size(); ++i)
        if (!find_thing(names[i]))
            table.fail_item(key, i, fmt::format("expected a thing of the catalogue, found \"{}\"", names[i]));
    return names;
}

const std::vector<std::string>& keys_of_types() {
    static const std::vector<std::string> keys{
        "name",         "title",          "words",       "words_near",  "rank",         "wet",
        "for_children", "deep_paints",    "next_rooms",  "next_door",   "second_room",  "upstairs",
        "styles",       "look_at",        "surfaces",    "kind_of",     "house",        "guess_rank",
        "main_thing",   "as_thing",       "thing_words", "own_things",  "table",        "table_when_near",
        "cooks",        "upright_chairs", "per_person",  "most_people", "mess",         "meanings",
        "size",         "shape",          "windows",     "touches",     "furnished_as", "recipe",
        "glazed",       "look_along",     "door"};
    return keys;
}

class TypeReader {
  public:
    TypeReader(const toml::table& document, const std::string& file) : top_(document, file, "", keys_of_types()) {}

    RoomType read() {
        t_.name = top_.needed_text("name");
        t_.title = top_.needed_text("title");
        t_.rank = top_.needed_whole("rank", 1, 1000);
        t_.wet = top_.needed_flag("wet");
        t_.for_children = top_.needed_flag("for_children");
        t_.deep_paints = top_.needed_flag("deep_paints");
        const std::vector<std::string> next = top_.texts("next_rooms");
        if (next.size() != 2) top_.fail("next_rooms", fmt::format("expected two room types, found {}", next.size()));
        t_.next_rooms = {next[0], next[1]};
        t_.next_door = top_.flag("next_door", t_.next_door);
        t_.second_room = top_.text("second_room");
        t_.upstairs = top_.text("upstairs");
        t_.kind_of = top_.text("kind_of");
        t_.house = top_.flag("house", t_.house);
        t_.furnished_as = top_.text("furnished_as");
        t_.recipe = read_recipe(top_, "recipe");
        if (t_.furnished_as.empty() == t_.recipe.empty())
            top_.fail_missing("recipe", "either [[recipe]] or furnished_as = \"the name of a room type\"");
        read_styles();
        read_shape();
        read_surfaces();
        read_windows();
        read_door();
        read_touches();
        read_words();
        read_things();
        return std::move(t_);
    }

  private:
    TomlTable table(std::string_view key, const std::vector<std::string>& keys) const {
        return {top_.needed_table(key), top_.file(), fmt::format("[{}]", key), keys};
    }

    void read_styles() {
        t_.look_at = one_thing("look_at");
        if (top_.has("look_along")) t_.look_along = share(top_, "look_along");
        t_.styles = top_.texts("styles");
        const std::vector<std::string> known = styles();
        for (std::size_t i = 0; i < t_.styles.size(); ++i)
            if (std::find(known.begin(), known.end(), t_.styles[i]) == known.end())
                top_.fail_item("styles", i, fmt::format("expected a style, found \"{}\"", t_.styles[i]));
    }

    // What is of the kind whatever the style: the tiles of a shop, the linoleum of a hospital.
    void read_surfaces() {
        if (!top_.has("surfaces")) return;
        const TomlTable t = table("surfaces", {"floor", "wall", "ceiling"});
        if (t.has("floor")) t_.floor = file_fields::material(t, "floor");
        if (t.has("wall")) t_.wall = file_fields::material(t, "wall");
        if (t.has("ceiling")) t_.ceiling = file_fields::material(t, "ceiling");
    }

    void read_shape() {
        const TomlTable size = table("size", {"width_m", "depth_m", "height_m"});
        if (size.has("height_m")) std::tie(t_.height_low_m, t_.height_high_m) = range_of(size, "height_m");
        std::tie(t_.width_low_m, t_.width_high_m) = range_of(size, "width_m");
        std::tie(t_.depth_low_m, t_.depth_high_m) = range_of(size, "depth_m");
        const TomlTable shape = table(
            "shape",
            {"breast_probability", "corner_probability", "bay_probability", "alcove_probability", "doorway_probability",
             "sloped_ceiling", "high_ceiling", "coffers", "panelling", "accent_wall", "wall_tiles", "wall_relief",
             "beams", "cabin", "cove_m", "outline", "vault", "rise_m", "oculus_m"});
        t_.breast_probability = share(shape, "breast_probability");
        t_.corner_probability = share(shape, "corner_probability");
        t_.bay_probability = share(shape, "bay_probability");
        t_.alcove_probability = share(shape, "alcove_probability");
        t_.doorway_probability = share(shape, "doorway_probability");
        t_.sloped_ceiling = shape.flag("sloped_ceiling", t_.sloped_ceiling);
        t_.high_ceiling = shape.flag("high_ceiling", t_.high_ceiling);
        t_.beams = shape.flag("beams", t_.beams);
        t_.coffers = shape.flag("coffers", t_.coffers);
        t_.panelling = shape.flag("panelling", t_.panelling);
        t_.accent_wall = shape.flag("accent_wall", t_.accent_wall);
        t_.wall_tiles = shape.flag("wall_tiles", t_.wall_tiles);
        t_.cabin = shape.flag("cabin", t_.cabin);
        constexpr double kWidestCove_m = 1;
        t_.cove_m = static_cast<float>(shape.number("cove_m", t_.cove_m, 0, kWidestCove_m));
        if (shape.has("outline")) t_.outline = file_fields::choice<Outline>(shape, "outline");
        if (shape.has("vault")) {
            constexpr double kLeastRise_m = 0.3, kMostRise_m = 5, kWidestOculus_m = 2;
            t_.vault = file_fields::choice<Vault>(shape, "vault");
            if (t_.vault != Vault::flat)
                t_.rise_m = static_cast<float>(shape.needed_number("rise_m", kLeastRise_m, kMostRise_m));
            t_.oculus_m = static_cast<float>(shape.number("oculus_m", 0, 0, kWidestOculus_m));
        }
        if (shape.has("wall_relief")) t_.wall_relief = file_fields::choice<WallRelief>(shape, "wall_relief");
    }

    void read_regular_windows(const TomlTable& t) {
        if (!t.has("walls")) return;
        constexpr double kMost_m = 6;
        RoomWindows& w = t_.windows;
        w.regular = true;
        for (const std::string& name : t.texts("walls"))
            w.walls.push_back(static_cast<int>(t.choice_of("walls", name, file_fields::kWallNames)));
        w.every_m = static_cast<float>(t.number("every_m", w.every_m, 0.5, kMost_m));
        w.width_m = static_cast<float>(t.number("width_m", w.width_m, 0.3, kMost_m));
        w.sill_m = static_cast<float>(t.number("sill_m", w.sill_m, 0.05, kMost_m));
        w.head_m = static_cast<float>(t.number("head_m", w.head_m, 0.5, kMost_m));
        w.arched = t.flag("arched", false);
        w.round = t.flag("round", false);
        w.glazed = t.flag("glazed", true);
    }

    void read_glazed() {
        constexpr double kWidest_m = 6, kHighest_m = 6;
        for (const toml::table* part : top_.tables("glazed")) {
            const TomlTable t(*part, top_.file(), "[[glazed]]",
                              {"glazing", "wall", "places", "width_m", "sill_m", "head_m"});
            GlazedPart g;
            g.glazing = file_fields::choice<Glazing>(t, "glazing");
            g.wall = static_cast<int>(t.needed_choice("wall", file_fields::kWallNames));
            for (const double place : t.numbers("places")) {
                if (!(place >= 0 && place <= 1)) t.fail("places", fmt::format("expected 0 to 1, found {}", place));
                g.places.push_back(static_cast<float>(place));
            }
            if (g.places.empty()) g.places = {0.5f};
            g.width_m = static_cast<float>(t.number("width_m", 0, 0, kWidest_m));
            g.sill_m = static_cast<float>(t.needed_number("sill_m", 0, kHighest_m));
            g.head_m = static_cast<float>(t.needed_number("head_m", 0.5, kHighest_m));
            t_.windows.glazed_parts.push_back(std::move(g));
        }
    }

    void read_windows() {
        read_glazed();
        if (!top_.has("windows")) return;
        constexpr double kHighestSill = 2;
        const TomlTable t = table(
            "windows", {"size", "count", "second_probability", "first_on_far_wall", "least_sill_m",
                        "sill_beyond_doorway_m", "outlook", "outlook_probability", "walls", "every_m", "width_m",
                        "sill_m", "head_m", "arched", "round", "tunnel", "glazed"});
        RoomWindows& w = t_.windows;
        read_regular_windows(t);
        w.tunnel = t.flag("tunnel", w.tunnel);
        if (t.has("size")) w.size = file_fields::choice<WindowSize>(t, "size");
        w.count = t.whole("count", w.count, 0, 4);
        w.second_probability = share_or(t, "second_probability", w.second_probability);
        w.first_on_far_wall = t.flag("first_on_far_wall", w.first_on_far_wall);
        w.least_sill_m = static_cast<float>(t.number("least_sill_m", w.least_sill_m, 0, kHighestSill));
        w.sill_beyond_doorway_m = static_cast<float>(
            t.number("sill_beyond_doorway_m", w.sill_beyond_doorway_m, 0, kHighestSill));
        if (!t.has("outlook")) return;
        w.outlook = file_fields::choice<Sky::View>(t, "outlook");
        w.outlook_probability = share(t, "outlook_probability");
    }

    void read_door() {
        if (!top_.has("door")) return;
        constexpr double kNarrowest_m = 0.6, kWidest_m = 4, kLowest_m = 1.5, kHighest_m = 4;
        const TomlTable t = table("door", {"form", "width_m", "height_m", "arched", "middle", "material"});
        RoomDoor& door = t_.door;
        if (t.has("form")) door.form = file_fields::choice<DoorForm>(t, "form");
        door.width_m = static_cast<float>(t.number("width_m", door.width_m, kNarrowest_m, kWidest_m));
        door.height_m = static_cast<float>(t.number("height_m", door.height_m, kLowest_m, kHighest_m));
        door.arched = t.flag("arched", door.arched);
        door.middle = t.flag("middle", door.middle);
        if (t.has("material")) door.material = file_fields::material(t, "material");
    }

    void read_words() {
        t_.words = top_.texts("words");
        t_.words_near = top_.texts("words_near");
        for (const toml::table* meaning : top_.tables("meanings")) {
            const TomlTable t(*meaning, top_.file(), "[[meanings]]", {"words", "thing", "near"});
            LocalMeaning m;
            m.words = t.texts("words");
            if (m.words.empty()) t.fail_missing("words", "a list of words");
            m.thing = t.needed_text("thing", "a thing of the catalogue");
            if (!find_thing(m.thing))
                t.fail("thing", fmt::format("expected a thing of the catalogue, found \"{}\"", m.thing));
            m.near = t.flag("near", false);
            t_.meanings.push_back(std::move(m));
        }
    }

    std::string one_thing(std::string_view key) const {
        const std::string name = top_.text(key);
        if (top_.has(key) && !find_thing(name))
            top_.fail(key, fmt::format("expected a thing of the catalogue, found \"{}\"", name));
        return name;
    }
    std::vector<std::string> some_things(std::string_view key) const {
        return top_.has(key) ? things(top_, key) : std::vector<std::string>{};
    }

    void read_things() {
        constexpr int kMostPeople = 99, kMostLying = 9;
        t_.guess_rank = top_.whole("guess_rank", 0, 0, 1000);
        t_.main_thing = one_thing("main_thing");
        t_.as_thing = one_thing("as_thing");
        t_.thing_words = top_.texts("thing_words");
        t_.own_things = some_things("own_things");
        t_.table = one_thing("table");
        t_.table_when_near = one_thing("table_when_near");
        t_.cooks = top_.flag("cooks", t_.cooks);
        t_.upright_chairs = top_.flag("upright_chairs", t_.upright_chairs);
        t_.per_person = some_things("per_person");
        t_.most_people = top_.whole("most_people", kMostPeople, 1, kMostPeople);
        if (!top_.has("mess")) return;
        t_.mess.clear();
        for (const toml::table* thing : top_.tables("mess")) {
            const TomlTable t(*thing, top_.file(), "[[mess]]", {"thing", "count", "on_floor"});
            const std::string name = t.needed_text("thing", "a thing of the catalogue");
            if (!find_thing(name))
                t.fail("thing", fmt::format("expected a thing of the catalogue, found \"{}\"", name));
            t_.mess.push_back({name, t.whole("count", 1, 1, kMostLying), t.flag("on_floor", false)});
        }
    }

    void read_touches() {
        const TomlTable t = table("touches", {"pieces", "pieces_per_m2", "sills", "shelves", "wall_shelf_probability",
                                              "mirror_probability", "clock_probability", "picture_probability",
                                              "curtains", "chandeliers", "radiators", "floor_lamp", "lived_in"});
        t_.lived_in = t.flag("lived_in", true);
        t_.pieces = things(t, "pieces");
        t_.pieces_per_m2 = share(t, "pieces_per_m2");
        t_.sills = things(t, "sills");
        t_.shelves = file_fields::choice<Shelves>(t, "shelves");
        t_.wall_shelf_probability = share(t, "wall_shelf_probability");
        t_.mirror_probability = share(t, "mirror_probability");
        t_.clock_probability = share(t, "clock_probability");
        t_.picture_probability = share_or(t, "picture_probability", t_.picture_probability);
        t_.curtains = t.flag("curtains", t_.curtains);
        t_.chandeliers = t.flag("chandeliers", t_.chandeliers);
        t_.radiators = t.flag("radiators", t_.radiators);
        if (t.has("floor_lamp")) t_.floor_lamp = file_fields::choice<FloorLamp>(t, "floor_lamp");
    }

    TomlTable top_;
    RoomType t_;
};

void check_references(const std::vector<RoomType>& all) {
    const auto check = [&](const RoomType& type, std::string_view key, const std::string& name) {
        if (std::none_of(all.begin(), all.end(), [&](const RoomType& other) { return other.name == name; }))
            throw Error("room_types/{}.toml: {}: expected the name of a room type, found \"{}\"", type.name, key, name);
    };
    for (const RoomType& type : all) {
        for (const std::string& next : type.next_rooms) check(type, "next_rooms", next);
        if (!type.furnished_as.empty()) check(type, "furnished_as", type.furnished_as);
        if (!type.upstairs.empty()) check(type, "upstairs", type.upstairs);
        if (!type.second_room.empty()) check(type, "second_room", type.second_room);
        if (!type.kind_of.empty()) check(type, "kind_of", type.kind_of);
    }
}

}  // namespace

RoomType read_room_type(std::string_view text, const std::string& file) {
    const toml::table document = parse_toml(text, file);
    return TypeReader(document, file).read();
}

const std::vector<RoomType>& all_room_types() {
    static const std::vector<RoomType> all = [] {
        std::vector<RoomType> out;
        for (std::size_t i = 0; i < kRoomTypeCount; ++i)
            out.push_back(read_room_type(kRoomTypeTexts[i].second,
                                         "room_types/" + std::string(kRoomTypeTexts[i].first) + ".toml"));
        FASTSCENE_CHECK(!out.empty());
        std::stable_sort(out.begin(), out.end(), [](const RoomType& a, const RoomType& b) { return a.rank < b.rank; });
        check_references(out);
        return out;
    }();
    return all;
}

const RoomType* find_room_type(std::string_view name) {
    for (const RoomType& type : all_room_types())
        if (type.name == name) return &type;
    return nullptr;
}

const RoomType& default_room_type() { return all_room_types().front(); }

const RoomType& room_type(std::string_view name) {
    const RoomType* found = find_room_type(name);
    return found ? *found : default_room_type();
}

bool is_own_thing(std::string_view thing, const RoomType& type) {
    return std::find(type.own_things.begin(), type.own_things.end(), thing) != type.own_things.end();
}

const std::vector<RecipeStep>& recipe_of(std::string_view name) {
    const RoomType& type = room_type(name);
    return type.furnished_as.empty() ? type.recipe : room_type(type.furnished_as).recipe;
}

}  // namespace fastscene
