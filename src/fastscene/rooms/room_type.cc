#include "fastscene/rooms/room_type.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "fastscene/base/check.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/file_fields.h"

namespace fastscene {

// room_types/*.toml, by cmake/embed.cmake.
extern const file_fields::EmbeddedFile kRoomTypeTexts[];
extern const std::size_t kRoomTypeCount;

namespace {

float share(const TomlTable& table, std::string_view key) { return static_cast<float>(table.needed_number(key, 0, 1)); }

std::pair<float, float> range_of(const TomlTable& table, std::string_view key) {
    constexpr double kLeast = 1.5, kMost = 12;
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

class TypeReader {
  public:
    TypeReader(const toml::table& document, const std::string& file)
        : top_(document, file, "",
               {"name", "title", "rank", "wet", "for_children", "deep_paints", "next_rooms", "size", "shape", "touches",
                "furnished_as", "recipe"}) {}

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
        t_.furnished_as = top_.text("furnished_as");
        t_.recipe = read_recipe(top_, "recipe");
        if (t_.furnished_as.empty() == t_.recipe.empty())
            top_.fail_missing("recipe", "either [[recipe]] or furnished_as = \"the name of a room type\"");
        read_shape();
        read_touches();
        return std::move(t_);
    }

  private:
    TomlTable table(std::string_view key, const std::vector<std::string>& keys) const {
        return {top_.needed_table(key), top_.file(), fmt::format("[{}]", key), keys};
    }

    void read_shape() {
        const TomlTable size = table("size", {"width_m", "depth_m"});
        std::tie(t_.width_low_m, t_.width_high_m) = range_of(size, "width_m");
        std::tie(t_.depth_low_m, t_.depth_high_m) = range_of(size, "depth_m");
        const TomlTable shape = table("shape", {"breast_probability", "corner_probability", "bay_probability",
                                                "alcove_probability", "doorway_probability"});
        t_.breast_probability = share(shape, "breast_probability");
        t_.corner_probability = share(shape, "corner_probability");
        t_.bay_probability = share(shape, "bay_probability");
        t_.alcove_probability = share(shape, "alcove_probability");
        t_.doorway_probability = share(shape, "doorway_probability");
    }

    void read_touches() {
        const TomlTable t = table("touches", {"pieces", "pieces_per_m2", "sills", "shelves", "wall_shelf_probability",
                                              "mirror_probability", "clock_probability"});
        t_.pieces = things(t, "pieces");
        t_.pieces_per_m2 = share(t, "pieces_per_m2");
        t_.sills = things(t, "sills");
        t_.shelves = file_fields::choice<Shelves>(t, "shelves");
        t_.wall_shelf_probability = share(t, "wall_shelf_probability");
        t_.mirror_probability = share(t, "mirror_probability");
        t_.clock_probability = share(t, "clock_probability");
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

const RoomType& room_type(std::string_view name) {
    for (const RoomType& type : all_room_types())
        if (type.name == name) return type;
    return all_room_types().front();
}

const std::vector<RecipeStep>& recipe_of(std::string_view name) {
    const RoomType& type = room_type(name);
    return type.furnished_as.empty() ? type.recipe : room_type(type.furnished_as).recipe;
}

}  // namespace fastscene
