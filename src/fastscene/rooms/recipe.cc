#include "fastscene/rooms/file_fields.h"
#include "fastscene/rooms/recipe.h"

#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_patterns.h"
#include "fastscene/rooms/layout_recipe.h"

namespace fastscene {
namespace {

using furnishing::StepKind;

constexpr double kMostPull = 5, kLeastGap = -1, kMostGap = 3, kLongest = 6;  // the latter in metres
constexpr int kMostTimes = 20, kMostPieces = 99;
constexpr double kLongestRun = 12;    // metres
constexpr double kWidestPitch = 20;   // metres: one vault over a whole hall
constexpr double kHighestRise = 0.5;  // metres: steeper seats want a rail before them

// Keys that every step may have.
constexpr std::string_view kEveryStep[] = {"do",        "only_asked",    "if_asked",     "if_not_asked",  "if_to_place",
                                           "if_placed", "if_not_placed", "unless_asked", "unless_placed", "late",
                                           "at",        "count"};

bool is_thing(const std::string& name) {
    const Thing* thing = find_thing(name);
    return thing && !thing->has(Role::shell);
}

std::vector<RecipeStep> read_steps(const TomlTable& table, std::string_view key, bool in_step);

class StepReader {
  public:
    StepReader(const TomlTable& table, const StepKind& kind, bool in_step)
        : t_(table), kind_(kind), in_step_(in_step) {}

    RecipeStep read() {
        s_.kind = &kind_;
        read_conditions();
        read_thing();
        read_place();
        read_pattern();
        if (t_.has("then")) s_.then = read_steps(t_, "then", in_step_ || kind_.name != furnishing::kStepsAlone);
        if (kind_.at_a_piece && !in_step_ && s_.at.empty())
            t_.fail_missing("at", fmt::format("the things at which \"{}\" may place its thing", kind_.name));
        return std::move(s_);
    }

  private:
    bool may_have(std::string_view key) const {
        return std::find(kind_.keys.begin(), kind_.keys.end(), key) != kind_.keys.end();
    }
    float number(std::string_view key, float otherwise, double low, double high) const {
        return static_cast<float>(t_.number(key, otherwise, low, high));
    }

    std::string thing(std::string_view key) const {
        const std::string name = t_.text(key);
        if (!is_thing(name)) t_.fail(key, fmt::format("expected a thing of the catalogue, found \"{}\"", name));
        return name;
    }
    std::vector<std::string> things(std::string_view key) const {
        std::vector<std::string> names = t_.texts(key);
        for (std::size_t i = 0; i < names.size(); ++i)
            if (!is_thing(names[i]))
                t_.fail_item(key, i, fmt::format("expected a thing of the catalogue, found \"{}\"", names[i]));
        return names;
    }

    void read_conditions() {
        StepConditions& when = s_.when;
        when.only_asked = t_.flag("only_asked", false);
        when.if_asked = things("if_asked");
        when.if_not_asked = things("if_not_asked");
        when.if_to_place = things("if_to_place");
        when.if_placed = things("if_placed");
        when.if_not_placed = things("if_not_placed");
        when.unless_asked = things("unless_asked");
        when.unless_placed = things("unless_placed");
        s_.late = t_.flag("late", false);
        s_.at = things("at");
        s_.count = t_.whole("count", 1, 1, kMostTimes);
    }

    void read_thing() {
        if (may_have("thing")) {
            if (!t_.has("thing")) t_.fail_missing("thing", "a thing of the catalogue");
            s_.thing = thing("thing");
        }
        s_.first_asked = things("first_asked");
        if (t_.has("other")) {
            s_.other = thing("other");
            s_.thing_share = static_cast<float>(t_.needed_number("thing_share", 0, 1));
        }
        s_.probability = number("probability", 1, 0, 1);
        s_.by_clutter = t_.flag("by_clutter", false);
        s_.needed = t_.flag("needed", false);
    }

    void read_place() {
        s_.center_pull = number("center_pull", 1, -kMostPull, kMostPull);
        s_.window_pull = number("window_pull", 0, -kMostPull, kMostPull);
        s_.corner = t_.flag("corner", false);
        static constexpr std::string_view kSides[] = {"left", "either", "right"};
        if (t_.has("side")) s_.side = static_cast<int>(t_.needed_choice("side", kSides)) - 1;
        s_.gap_m = number("gap_m", 0, kLeastGap, kMostGap);
        s_.facing = t_.flag("facing", false);
        s_.width_m = number("width_m", s_.width_m, 0.2, kLongest);
        s_.depth_m = number("depth_m", s_.depth_m, 0.2, kLongest);
        s_.shift_m = number("shift_m", 0, -kMostGap, kMostGap);
        s_.from_edge = t_.flag("from_edge", false);
        s_.seats = t_.whole("seats", s_.seats, 0, kMostTimes);
    }

    void read_pattern() {
        if (t_.has("pattern")) s_.pattern = t_.text("pattern");
        if (t_.has("seat")) s_.seat = thing("seat");
        if (t_.has("back")) s_.back = thing("back");
        if (t_.has("towards")) s_.towards = static_cast<int>(t_.needed_choice("towards", file_fields::kWallNames));
        if (t_.has("walls")) {
            s_.walls.clear();
            for (const std::string& name : t_.texts("walls"))
                s_.walls.push_back(static_cast<int>(t_.choice_of("walls", name, file_fields::kWallNames)));
        }
        s_.pitch_m = number("pitch_m", s_.pitch_m, 0.2, kWidestPitch);
        s_.rise_m = number("rise_m", s_.rise_m, 0, kHighestRise);
        if (s_.rise_m > 0 && !(s_.pitch_m > 0))
            t_.fail_missing("pitch_m", "how far apart the rows are that rise_m lifts, in metres");
        s_.aisle_m = number("aisle_m", s_.aisle_m, 0, kLongest);
        s_.side_m = number("side_m", s_.side_m, 0, kLongest);
        s_.front_m = number("front_m", s_.front_m, 0, kLongestRun);
        s_.rear_m = number("rear_m", s_.rear_m, 0, kLongestRun);
        s_.off_m = number("off_m", s_.off_m, 0, kLongest);
        s_.length_m = number("length_m", s_.length_m, 0, kLongestRun);
        s_.rows = t_.whole("rows", 0, 0, kMostPieces);
        s_.block = t_.whole("block", 0, 0, kMostPieces);
        s_.most = t_.whole("most", 0, 0, kMostPieces);
        s_.alike = t_.flag("alike", false);
        s_.fill = t_.flag("fill", false);
    }

    const TomlTable& t_;
    const StepKind& kind_;
    bool in_step_;
    RecipeStep s_;
};

RecipeStep read_step(const toml::table& table, const TomlTable& outer, std::string_view key, bool in_step) {
    // Every key of a table that is not yet known to be a step passes; then only those of its kind.
    std::vector<std::string> any;
    for (const auto& [name, value] : table) any.emplace_back(name.str());
    const std::string where = fmt::format("[[{}]]", key);
    const TomlTable unknown(table, outer.file(), where, any);
    std::vector<std::string_view> names;
    for (const StepKind& kind : furnishing::step_kinds()) names.push_back(kind.name);
    const StepKind& kind = furnishing::step_kinds()[unknown.needed_choice("do", names)];
    std::vector<std::string> keys(std::begin(kEveryStep), std::end(kEveryStep));
    keys.insert(keys.end(), kind.keys.begin(), kind.keys.end());
    const TomlTable known(table, outer.file(), fmt::format("{} {}", where, kind.name), keys);
    return StepReader(known, kind, in_step).read();
}

std::vector<RecipeStep> read_steps(const TomlTable& table, std::string_view key, bool in_step) {
    std::vector<RecipeStep> out;
    for (const toml::table* step : table.tables(key)) out.push_back(read_step(*step, table, key, in_step));
    return out;
}

}  // namespace

std::vector<RecipeStep> read_recipe(const TomlTable& table, std::string_view key) {
    return read_steps(table, key, false);
}

bool sets_many(const std::vector<RecipeStep>& recipe, std::string_view kind) {
    const auto patterns = furnishing::pattern_kinds();
    return std::any_of(recipe.begin(), recipe.end(), [&](const RecipeStep& step) {
        const bool pattern = std::any_of(patterns.begin(), patterns.end(),
                                         [&](const furnishing::StepKind& k) { return k.name == step.kind->name; });
        return (pattern && step.most != 1 && (step.thing == kind || step.other == kind)) || step.seat == kind ||
               sets_many(step.then, kind);
    });
}

}  // namespace fastscene
