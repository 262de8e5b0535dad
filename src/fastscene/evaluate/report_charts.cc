// The report's charts: bars where rows have one figure, curves where they have points.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fastscene/evaluate/cells.h"
#include "fastscene/evaluate/charts.h"
#include "fastscene/evaluate/report_parts.h"

namespace fastscene {
namespace {

std::string better_hint(const Json& column) {
    const std::string better = column.at("better");
    return better == "higher" ? "higher is better" : better == "lower" ? "lower is better" : "";
}

// In a chart of a single variant, its name is omitted from the rows.
std::string short_title(const Json& results, const Json& row) {
    const std::string group = row.at("group");
    const auto& rows = results.at("rows");
    const bool alone = std::none_of(rows.begin(), rows.end(), [&](const Json& r) {
        return r.at("kind") != "published" && r.at("name") != row.at("name");
    });
    return alone && !group.empty() ? group : row_title(row);
}

}  // namespace

// Bar charts for columns with numbers in at least two rows, not all of them published.
std::string bars_html(const Json& results) {
    std::string out;
    for (const Json& column : results.at("columns")) {
        std::vector<Bar> bars;
        bool any_measured = false;
        for (const Json& row : results.at("rows")) {
            if (row.contains("at")) continue;
            const Json& cell = row.at("cells").at(column.at("key").get<std::string>());
            if (!cell.contains("value") || !cell.at("value").is_number()) continue;
            bars.push_back({short_title(results, row), text_of(row, "kind"), cell.at("value"),
                            cell_text(cell, column.at("digits"))});
            any_measured |= row.at("kind") != "published";
        }
        if (bars.size() > 1 && any_measured)
            out += "<div>" + bar_chart(label_of(column), better_hint(column), bars) + "</div>\n";
    }
    return out;
}

// Curves: one chart per row name, series and unit.
std::string curves_html(const Json& results) {
    std::map<std::string, std::map<std::string, Curve>> charts;  // title -> curves by column
    std::vector<std::string> titles;
    std::map<std::string, std::pair<std::string, std::string>> labels;
    for (const Json& row : results.at("rows")) {
        if (!row.contains("at")) continue;
        for (const Json& column : results.at("columns")) {
            const std::string key = column.at("key"), unit = text_of(column, "unit"), series = text_of(row, "series");
            const Json& cell = row.at("cells").at(key);
            if (!cell.contains("value") || !cell.at("value").is_number() || key == "closed") continue;
            const std::string group = unit == "dB" || key.starts_with("holes") ? "" : ", " + text_of(column, "label");
            const std::string title = text_of(row, "name") + (series.empty() ? "" : ", " + series) + group;
            if (std::find(titles.begin(), titles.end(), title) == titles.end()) titles.push_back(title);
            labels[title] = {series.empty() ? "radius, m" : "step, share of the greatest range",
                             group.empty() ? (unit == "%" ? "holes, % of the picture" : unit) : better_hint(column)};
            Curve& curve = charts[title][key];
            curve.name = text_of(column, "label");
            curve.dashed = column.at("better") == "neither";
            curve.points.emplace_back(row.at("at").get<double>(), cell.at("value").get<double>());
        }
    }
    std::string out;
    for (const std::string& title : titles) {
        std::vector<Curve> curves;
        for (const Json& column : results.at("columns")) {
            const auto found = charts[title].find(column.at("key").get<std::string>());
            if (found == charts[title].end() || found->second.points.size() < 2) continue;
            std::sort(found->second.points.begin(), found->second.points.end());
            curves.push_back(found->second);
        }
        if (!curves.empty())
            out += "<div>" + line_chart(title, labels[title].first, labels[title].second, curves) + "</div>\n";
    }
    return out;
}

}  // namespace fastscene
