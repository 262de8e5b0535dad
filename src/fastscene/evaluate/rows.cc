#include "fastscene/evaluate/rows.h"

#include <algorithm>
#include <cmath>

#include "fastscene/evaluate/measures.h"

namespace fastscene {
namespace {

struct RowKey {
    std::string name, group, kind;
    friend bool operator==(const RowKey&, const RowKey&) = default;
};

// All figures of one cell.
struct Cell {
    std::vector<double> values;
    int infinite = 0;
    std::string note;

    Json json() const {
        if (values.empty()) return infinite ? Json{{"value", "inf"}, {"count", infinite}} : Json{{"note", note.empty() ? "not measured" : note}};
        double mean = 0, square = 0;
        for (const double v : values) mean += v;
        mean /= static_cast<double>(values.size());
        for (const double v : values) square += (v - mean) * (v - mean);
        Json cell{{"value", mean}, {"count", values.size()}};
        if (values.size() > 1) cell["sd"] = std::sqrt(square / static_cast<double>(values.size() - 1));
        return cell;
    }
};

struct Row {
    RowKey key;
    int scenes = 0;
    std::map<std::string, Cell> cells;
    Json curve = Json::object();  // series and at, where it is a point of a curve
};

Row& row_of(std::vector<Row>& rows, const RowKey& key) {
    for (Row& row : rows)
        if (row.key == key) return row;
    return rows.emplace_back(Row{key, 0, {}, Json::object()});
}

void add_sample(Row& row, const Json& sample) {
    for (const auto& [column, value] : sample.at("values").items()) {
        if (value.is_number()) row.cells[column].values.push_back(value.get<double>());
        else ++row.cells[column].infinite;
    }
    for (const auto& [column, note] : sample.at("notes").items()) row.cells[column].note = note.get<std::string>();
}

Json published_rows(const Suite& suite) {
    Json out = Json::array();
    for (const PublishedRow& row : suite.published) {
        Json cells = Json::object();
        for (const std::string& column : suite.columns)
            cells[column] = row.values.contains(column) ? Json{{"value", row.values.at(column)}, {"count", 1}} : Json{{"note", "not published"}};
        out.push_back({{"name", row.name}, {"group", ""}, {"kind", "published"}, {"ours", row.ours}, {"scenes", 0}, {"cells", cells}});
    }
    return out;
}

}  // namespace

Json table_rows(const Suite& suite, const std::vector<Json>& records) {
    std::vector<Row> rows;
    for (const Json& record : records) {
        const std::string name = record.at("variant"), kind = record.at("kind");
        if (record.contains("failed")) {
            Row& row = row_of(rows, {name, "", kind});
            for (const std::string& column : suite.columns)
                if (row.cells[column].note.empty()) row.cells[column].note = fmt::format("failed: {}", record.at("failed").get<std::string>());
            continue;
        }
        std::vector<std::string> counted;  // a scene's cost is a sample of its own in the same row
        for (const Json& sample : record.at("samples")) {
            const std::string group = sample.at("group");
            Row& row = row_of(rows, {name, group, group == kInputGroup ? "source" : kind});
            add_sample(row, sample);
            if (sample.contains("at")) row.curve = {{"series", sample.at("series")}, {"at", sample.at("at")}};
            if (std::find(counted.begin(), counted.end(), group) == counted.end()) ++row.scenes, counted.push_back(group);
        }
    }
    // A variant without figures of its own beside its cost (holes, several radii) would be an empty row.
    std::erase_if(rows, [&](const Row& row) {
        const bool has_groups = std::any_of(rows.begin(), rows.end(), [&](const Row& r) { return r.key.name == row.key.name && !r.key.group.empty(); });
        const bool has_shown = std::any_of(suite.columns.begin(), suite.columns.end(), [&](const std::string& c) { return row.cells.contains(c) && !row.cells.at(c).values.empty(); });
        return row.key.group.empty() && has_groups && !has_shown;
    });
    Json out = published_rows(suite);
    for (const Row& row : rows) {
        Json cells = Json::object();
        for (const std::string& column : suite.columns) {
            const auto found = row.cells.find(column);
            cells[column] = found != row.cells.end() ? found->second.json() : Json{{"note", row.key.group.empty() ? "not measured" : ""}};
        }
        out.push_back({{"name", row.key.name}, {"group", row.key.group}, {"kind", row.key.kind}, {"scenes", row.scenes}, {"cells", cells}});
        out.back().update(row.curve);
    }
    return out;
}

}  // namespace fastscene
