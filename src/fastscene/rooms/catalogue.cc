#include "fastscene/rooms/catalogue.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/io/toml_table.h"

namespace fastscene {

// catalogue/*.toml, by cmake/embed.cmake.
extern const std::pair<std::string_view, std::string_view> kCatalogueTexts[];
extern const std::size_t kCatalogueCount;

namespace {

// In the order of Role.
constexpr std::array<std::string_view, static_cast<std::size_t>(Role::count_)> kRoleNames{
    "shell",          "opening",        "countable",     "unbuilt",       "bed",
    "along_wall",     "framed_bed",     "seat",          "easy_chair",    "sofa",
    "sits_before",    "work_seat",      "work_place",    "takes_accent",  "takes_woven_accent",
    "lamp_above",     "small",          "hung",          "likely_above",  "too_low_below",
    "too_tall_below", "no_top",         "blind",         "ceiling_light", "overhead",
    "light",          "litter",         "lies_on_seats", "soft",          "room_maker",
    "main_piece",     "focus",          "centerpiece",   "at_edges",      "movable",
    "moves_out",      "never_plural",   "heap",          "tall",          "laid",
    "vase",           "person",         "prefers_model", "in_groups",     "beside_window",
    "garland",        "nothing_above",  "on_mantels",    "under_windows", "between_beds",
    "shows_motif",    "climbed",        "may_be_round",  "pet",           "drawn_up",
    "rug_before",     "shades_windows", "spread_out",    "before_seats",  "covers_wall",
    "roof",           "two_of_them",    "cozy",          "alike"};

constexpr std::array<std::string_view, 41> kNyu40{"outside",
                                                  "wall",
                                                  "floor",
                                                  "cabinet",
                                                  "bed",
                                                  "chair",
                                                  "sofa",
                                                  "table",
                                                  "door",
                                                  "window",
                                                  "bookshelf",
                                                  "picture",
                                                  "counter",
                                                  "blinds",
                                                  "desk",
                                                  "shelves",
                                                  "curtain",
                                                  "dresser",
                                                  "pillow",
                                                  "mirror",
                                                  "floor mat",
                                                  "clothes",
                                                  "ceiling",
                                                  "books",
                                                  "refrigerator",
                                                  "television",
                                                  "paper",
                                                  "towel",
                                                  "shower curtain",
                                                  "box",
                                                  "whiteboard",
                                                  "person",
                                                  "night stand",
                                                  "toilet",
                                                  "sink",
                                                  "lamp",
                                                  "bathtub",
                                                  "bag",
                                                  "other structure",
                                                  "other furniture",
                                                  "other prop"};

constexpr std::string_view kWords = "words";  // the file about models of the pack that no row knows

int label_named(const TomlTable& table) { return static_cast<int>(table.needed_choice("nyu40", kNyu40)); }

Thing read_thing(const std::string& kind, const toml::table& found, const std::string& file) {
    static const std::vector<std::string> kKeys{"builder",   "roles",  "nyu40",  "floor_m2",   "style",
                                                "room",      "models", "on_top", "small_form", "stand_in",
                                                "for_child", "called", "parts"};
    const TomlTable table(found, file, "[" + kind + "]", kKeys);
    Thing t;
    t.kind = kind;
    t.built = table.flag("builder", true);
    const std::vector<std::string> roles = table.texts("roles");
    for (std::size_t i = 0; i < roles.size(); ++i) t.roles.set(table.choice_of("roles", roles[i], kRoleNames));
    t.nyu40 = label_named(table);
    constexpr double kLargestPiece = 20;  // m²
    t.floor_m2 = static_cast<float>(table.number("floor_m2", 0, 0, kLargestPiece));
    t.style = table.text("style");
    t.room = table.text("room");
    t.called = table.texts("called");
    t.parts = table.texts("parts");
    t.small_form = table.text("small_form");
    t.for_child = table.text("for_child");
    t.models = table.texts("models");
    t.stand_in = table.text("stand_in");
    for (const toml::table* row : table.tables("on_top")) {
        const TomlTable habit(*row, file, "[" + kind + "] on_top", {"thing", "probability"});
        t.on_top.push_back({habit.needed_text("thing"), static_cast<float>(habit.needed_number("probability", 0, 1))});
    }
    return t;
}

// Every kind that a row names has a row, and one that can be built where it is to stand in for something.
void check_references(const std::vector<Thing>& all) {
    const auto must_be_built = [&](const Thing& from, std::string_view key, const std::string& kind) {
        if (kind.empty()) return;
        const auto at = std::find_if(all.begin(), all.end(), [&](const Thing& t) { return t.kind == kind; });
        if (at == all.end() || !at->built)
            throw Error("catalogue: [{}]: {}: expected a kind that has a builder, found \"{}\"", from.kind, key, kind);
    };
    for (const Thing& t : all) {
        must_be_built(t, "stand_in", t.stand_in);
        must_be_built(t, "small_form", t.small_form);
        must_be_built(t, "for_child", t.for_child);
        for (const TopHabit& habit : t.on_top) must_be_built(t, "on_top", habit.thing);
        if (t.has(Role::shell) && t.built)
            throw Error("catalogue: [{}]: expected builder = false, as for all parts of the shell", t.kind);
    }
}

// What words.toml holds.
struct Words {
    std::vector<std::pair<std::string, int>> nyu40_by_word;
    std::vector<std::string> floor_models;
};

Words read_words(const CatalogueFile& file) {
    const std::string name = std::string(file.name) + ".toml";
    const toml::table document = parse_toml(file.text, name);
    const TomlTable table(document, name, "", {"nyu40_by_word", "floor_models"});
    Words words;
    words.floor_models = table.texts("floor_models");
    for (const toml::table* row : table.tables("nyu40_by_word")) {
        const TomlTable entry(*row, name, "nyu40_by_word", {"word", "nyu40"});
        words.nyu40_by_word.emplace_back(entry.needed_text("word"), label_named(entry));
    }
    return words;
}

struct Catalogue {
    std::vector<Thing> things;
    std::unordered_map<std::string_view, const Thing*> by_kind;
    Words words;
};

Catalogue read_catalogue() {
    std::vector<CatalogueFile> files;
    Catalogue c;
    for (std::size_t i = 0; i < kCatalogueCount; ++i) {
        const CatalogueFile file{kCatalogueTexts[i].first, kCatalogueTexts[i].second};
        if (file.name == kWords) c.words = read_words(file);
        else files.push_back(file);
    }
    c.things = read_things(files);
    for (const Thing& t : c.things) c.by_kind.emplace(t.kind, &t);
    return c;
}

const Catalogue& catalogue() {
    static const Catalogue c = read_catalogue();
    return c;
}

}  // namespace

std::vector<Thing> read_things(std::span<const CatalogueFile> files) {
    std::vector<Thing> all;
    for (const CatalogueFile& file : files) {
        const std::string name = std::string(file.name) + ".toml";
        const toml::table document = parse_toml(file.text, name);
        // In the order of the file, which a parsed table does not keep.
        std::vector<std::pair<unsigned, const toml::key*>> keys;
        for (const auto& [key, value] : document) keys.emplace_back(key.source().begin.line, &key);
        std::sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [line, key] : keys) {
            const std::string kind(key->str());
            const toml::table* row = document[key->str()].as_table();
            if (!row) throw Error("{}:{}: expected a row [{}], found a value", name, line, kind);
            if (std::any_of(all.begin(), all.end(), [&](const Thing& t) { return t.kind == kind; }))
                throw Error("{}:{}: [{}]: there is a row of this kind already", name, line, kind);
            all.push_back(read_thing(kind, *row, name));
        }
    }
    check_references(all);
    return all;
}

std::span<const Thing> things() { return catalogue().things; }

const Thing* find_thing(std::string_view kind) {
    const auto at = catalogue().by_kind.find(kind);
    return at == catalogue().by_kind.end() ? nullptr : at->second;
}

bool has_role(std::string_view kind, Role role) {
    const Thing* thing = find_thing(kind);
    return thing != nullptr && thing->has(role);
}

std::string small_form_of(const std::string& kind) {
    const Thing* thing = find_thing(kind);
    return thing && !thing->small_form.empty() ? thing->small_form : kind;
}

bool is_form_of(std::string_view kind, std::string_view plain) {
    if (!kind.starts_with(plain)) return false;
    const std::string_view form = kind.substr(plain.size());
    return is_one_of(form, {"", "_round", "_small", "_tree", "_blocks", "_single", "_tall", "_low", "_corner"});
}

std::vector<std::string> kinds_with(Role role) {
    std::vector<std::string> kinds;
    for (const Thing& t : things())
        if (t.has(role)) kinds.push_back(t.kind);
    return kinds;
}

std::span<const std::string_view> nyu40_labels() { return kNyu40; }

int nyu40_label(std::string_view kind) {
    if (const Thing* thing = find_thing(kind)) return thing->nyu40;
    constexpr int kOtherProp = 40;
    for (const auto& [word, label] : catalogue().words.nyu40_by_word)
        if (kind.find(word) != std::string_view::npos) return label;
    return kOtherProp;
}

bool has_nyu40_label(std::string_view kind, std::string_view label) {
    const auto at = static_cast<std::size_t>(nyu40_label(kind));
    return at < kNyu40.size() && kNyu40[at] == label;
}

bool is_curtain(std::string_view kind) {
    constexpr int kCurtain = 16;
    return nyu40_label(kind) == kCurtain;
}

bool is_floor_model(std::string_view model) {
    const auto& all = catalogue().words.floor_models;
    return std::find(all.begin(), all.end(), model) != all.end();
}

}  // namespace fastscene
