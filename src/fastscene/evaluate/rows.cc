#include "fastscene/evaluate/rows.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fastscene/evaluate/columns.h"
#include "fastscene/evaluate/measures.h"

namespace fastscene {
namespace {

void add_once(std::vector<std::string>& list, const std::string& item) {
    if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

struct RowKey {
    std::string name, group, kind;
    friend bool operator==(const RowKey&, const RowKey&) = default;
};

// All figures of one cell.
struct Cell {
    std::vector<double> values;
    std::vector<std::string> scenes, infinite;  // scenes with a figure, and those with an infinite one
    std::vector<std::pair<std::string, std::vector<std::string>>> notes;  // each once, with the scenes it applies to
    int counted = 0, pictures = 0;
    bool shared = false;

    void note(const std::string& text, const std::string& scene) {
        for (auto& [known, where] : notes)
            if (known == text) return add_once(where, scene);
        notes.push_back({text, {scene}});
    }

    // `measured`: scenes of the row that did not fail.
    Json json(int of, std::size_t measured) const {
        Json cell = Json::object();
        if (values.empty() && !infinite.empty())
            cell = {{"value", "inf"}, {"count", infinite.size()}, {"of", of}, {"scenes", infinite}};
        if (!values.empty()) {
            double mean = 0, square = 0;
            for (const double v : values) mean += v / static_cast<double>(values.size());
            for (const double v : values) square += (v - mean) * (v - mean);
            cell = {{"value", mean}, {"count", values.size()}, {"of", of}, {"scenes", scenes}};
            if (values.size() > 1 && !shared) cell["sd"] = std::sqrt(square / static_cast<double>(values.size() - 1));
        }
        std::vector<std::string> said;
        for (const auto& [text, where] : notes)
            said.push_back(where.size() < measured ? fmt::format("{}: {}", fmt::join(where, ", "), text) : text);
        if (!values.empty() && !infinite.empty())
            said.push_back(fmt::format("{}: infinite, not in the mean", fmt::join(infinite, ", ")));
        if (!said.empty()) cell["notes"] = said;
        if (counted < pictures) cell["pictures"] = {{"counted", counted}, {"of", pictures}};
        return cell;
    }
};

struct Row {
    RowKey key;
    std::vector<std::string> scenes;
    std::map<std::string, Cell> cells;
    Json curve = Json::object();  // series and at, if it is a point of a curve
};

Row& row_of(std::vector<Row>& rows, const RowKey& key) {
    for (Row& row : rows)
        if (row.key == key) return row;
    return rows.emplace_back(Row{key, {}, {}, Json::object()});
}

void add_sample(Row& row, const Json& sample, const std::string& scene) {
    for (const auto& [column, value] : sample.at("values").items()) {
        Cell& cell = row.cells[column];
        cell.shared |= sample.value("shared", false) || column_of(column).quoted;
        if (!value.is_number()) {
            cell.infinite.push_back(scene);
            continue;
        }
        cell.values.push_back(value.get<double>());
        cell.scenes.push_back(scene);
    }
    for (const auto& [column, notes] : sample.at("notes").items())
        for (const Json& note : notes) row.cells[column].note(note, scene);
    const Json pictures = sample.value("pictures", Json::object());
    for (const auto& [column, share] : pictures.items()) {
        row.cells[column].counted += share.at("counted").get<int>();
        row.cells[column].pictures += share.at("of").get<int>();
    }
}

// A scene's name, with its seed if it has several.
std::string scene_id(const Suite& suite, const Json& record) {
    const std::string name = record.at("scene");
    for (const SuiteScene& scene : suite.scenes)
        if (scene.name == name && scene.seeds.size() > 1 && record.at("kind") == "ours")
            return fmt::format("{}, seed {}", name, record.at("seed").get<std::uint64_t>());
    return name;
}

// How many scenes a row should have.
int scenes_asked(const Suite& suite, const RowKey& row) {
    std::size_t count = 0;
    for (const SuiteScene& scene : suite.scenes)
        if (row.kind == "peer") ++count;
        else if (scene.run.empty() || scene.variant == row.name) count += scene.seeds.size();
    return static_cast<int>(count);
}

Json published_rows(const Suite& suite) {
    Json out = Json::array();
    for (const PublishedRow& row : suite.published) {
        Json cells = Json::object();
        for (const std::string& column : suite.columns) {
            cells[column] = Json::object();
            if (row.values.contains(column)) cells[column]["value"] = row.values.at(column);
        }
        out.push_back({{"name", row.name},
                       {"group", ""},
                       {"kind", "published"},
                       {"ours", row.ours},
                       {"scenes", 0},
                       {"of", 0},
                       {"cells", cells}});
    }
    return out;
}

}  // namespace

Json table_rows(const Suite& suite, const std::vector<Json>& records) {
    std::vector<Row> rows;
    for (const Json& record : records) {
        const std::string name = record.at("variant"), kind = record.at("kind"), scene = scene_id(suite, record);
        if (record.contains("failed")) {
            row_of(rows, {name, "", kind});
            continue;
        }
        for (const Json& sample : record.at("samples")) {
            const std::string group = sample.at("group");
            Row& row = row_of(rows, {name, group, group == kInputGroup ? "source" : kind});
            add_sample(row, sample, scene);
            if (sample.contains("at")) row.curve = {{"series", sample.at("series")}, {"at", sample.at("at")}};
            add_once(row.scenes, scene);
        }
    }
    // A variant with nothing but its cost (its figures are curves) would be an empty row.
    std::erase_if(rows, [&](const Row& row) {
        const bool has_groups = std::any_of(
            rows.begin(), rows.end(), [&](const Row& r) { return r.key.name == row.key.name && !r.key.group.empty(); });
        const bool has_shown = std::any_of(suite.columns.begin(), suite.columns.end(), [&](const std::string& c) {
            return row.cells.contains(c) && !row.cells.at(c).values.empty();
        });
        return row.key.group.empty() && has_groups && !has_shown;
    });
    // A variant's main row comes before those of its groups, and points of curves come last.
    const auto place_of = [&](const Row& row) {
        const auto first = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
            return r.key.name == row.key.name && (r.key.kind == "peer") == (row.key.kind == "peer");
        });
        return std::pair(first - rows.begin(),
                         row.key.group.empty()                                                                ? 0
                         : row.curve.contains("series") && !row.curve.at("series").get<std::string>().empty() ? 2
                                                                                                              : 1);
    };
    std::vector<std::pair<decltype(place_of(rows[0])), Row>> placed;
    for (const Row& row : rows) placed.emplace_back(place_of(row), row);
    std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Json out = published_rows(suite);
    for (const auto& [place, row] : placed) {
        const int of = scenes_asked(suite, row.key);
        Json cells = Json::object();
        for (const std::string& column : suite.columns) {
            const auto found = row.cells.find(column);
            cells[column] = found != row.cells.end() ? found->second.json(of, row.scenes.size()) : Json::object();
        }
        out.push_back({{"name", row.key.name},
                       {"group", row.key.group},
                       {"kind", row.key.kind},
                       {"scenes", row.scenes.size()},
                       {"of", of},
                       {"cells", cells}});
        out.back().update(row.curve);
    }
    return out;
}

Json parameters_used(const Suite& suite, const std::vector<Json>& records) {
    Json out = Json::object();
    for (const Json& record : records) {
        const Json parameters = record.value("parameters", Json::object());
        for (const auto& [column, used] : parameters.items()) {
            Json& list = out[column];
            if (list.is_null()) list = Json::array();
            auto known = std::find_if(list.begin(), list.end(),
                                      [&](const Json& other) { return other.at("identity") == used.at("identity"); });
            if (known == list.end()) {
                list.push_back(used);
                list.back()["scenes"] = Json::array();
                known = std::prev(list.end());
            }
            known->at("scenes").push_back(record.at("variant").get<std::string>() + ", " + scene_id(suite, record));
        }
    }
    return out;
}

}  // namespace fastscene
