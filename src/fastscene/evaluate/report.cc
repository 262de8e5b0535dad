// The page: table, charts, protocol, scenes. Everything is inside it, so that it can be sent and opened anywhere.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fastscene/evaluate/charts.h"
#include "fastscene/evaluate/report_figures.h"
#include "fastscene/evaluate/write.h"

namespace fastscene {
extern const std::string_view kReportStyle;  // report.css

namespace {
namespace fs = std::filesystem;

std::string text_of(const Json& json, const char* key) { return json.value(key, std::string()); }
std::string escaped(const Json& json, const char* key) { return html_escaped(text_of(json, key)); }

std::string better_hint(const Json& column) {
    const std::string better = column.at("better");
    return better == "higher" ? "higher is better" : better == "lower" ? "lower is better" : "";
}
// A label may already say its unit.
std::string label_of(const Json& column) {
    const std::string unit = text_of(column, "unit");
    return text_of(column, "label") + (unit.empty() || unit == "min" ? "" : " (" + unit + ")");
}

// What to do about a figure that is not there, in few words: the command, where the note names one in `quotes`.
std::string short_note(const std::string& note) {
    if (note.starts_with("failed")) return "failed";
    if (!note.starts_with("fetch ")) return "–";
    const std::size_t begin = note.find("`fastscene models pull"), end = begin == std::string::npos ? begin : note.find('`', begin + 1);
    return end == std::string::npos ? "needs weights" : "needs " + note.substr(begin + 11, end - begin - 11);
}

std::string cell_html(const Json& results, const Json& row, const Json& column) {
    const Json& cell = row.at("cells").at(column.at("key").get<std::string>());
    if (!cell.contains("value")) {
        const std::string note = text_of(cell, "note");
        return fmt::format("<td class=\"none\" title=\"{}\">{}</td>", html_escaped(note), html_escaped(short_note(note)));
    }
    const std::string sd = cell.contains("sd") ? fmt::format(" <small>± {:.{}f}</small>", cell.at("sd").get<double>(), column.at("digits").get<int>()) : "";
    return fmt::format("<td{}>{}{}</td>", is_best(results, row, column) ? " class=\"best\"" : "", cell_text(cell, column.at("digits")), sd);
}

std::string table_html(const Json& results) {
    std::string out = "<div class=\"scroll\"><table>\n<tr><th></th>";
    for (const Json& column : results.at("columns")) {
        const std::string better = column.at("better"), arrow = better == "higher" ? " ↑" : better == "lower" ? " ↓" : "";
        out += fmt::format("<th title=\"{}\">{}{}</th>", escaped(column, "about"), html_escaped(label_of(column)), arrow);
    }
    out += "</tr>\n";
    std::string before;
    for (const Json& row : results.at("rows")) {
        const std::string kind = row.at("kind");
        const bool turn = before == "published" && kind != "published";
        out += fmt::format("<tr class=\"{}{}{}\"><td><i class=\"swatch {}\"></i>{}{}</td>", kind, row.value("ours", false) ? " target" : "", turn ? " turn" : "", kind,
                           html_escaped(row_title(row)), kind == "published" ? "<span class=\"tag\">published</span>" : "");
        for (const Json& column : results.at("columns")) out += cell_html(results, row, column);
        out += "</tr>\n";
        before = kind;
    }
    return out + "</table></div>\n";
}

// What is missing, once, with how to get it.
std::string missing_html(const Json& results) {
    std::string items, failures;
    for (const Json& column : results.at("columns"))
        for (const std::string& reason : reasons_of(results, column.at("key")))
            if (!reason.starts_with("failed")) items += fmt::format("<li><b>{}</b>: {}</li>\n", escaped(column, "label"), html_escaped(reason));
    for (const Json& record : results.at("records"))
        if (record.contains("failed")) failures += fmt::format("<li><b>{}, {}</b>: {}</li>\n", escaped(record, "variant"), escaped(record, "scene"), escaped(record, "failed"));
    std::string out;
    if (!failures.empty()) out += "<div class=\"todo failed\"><p>Scenes that failed</p><ul>" + failures + "</ul></div>\n";
    if (!items.empty()) out += "<div class=\"todo\"><p>Figures that are not there, and why</p><ul>" + items + "</ul></div>\n";
    return out;
}

// In a chart of one variant its rows need not repeat its name.
std::string short_title(const Json& results, const Json& row) {
    const std::string group = row.at("group");
    const auto& rows = results.at("rows");
    const bool alone = std::none_of(rows.begin(), rows.end(), [&](const Json& r) { return r.at("kind") != "published" && r.at("name") != row.at("name"); });
    return alone && !group.empty() ? group : row_title(row);
}

// Bars for columns that at least two rows have a number in.
std::string bars_html(const Json& results) {
    std::string out;
    for (const Json& column : results.at("columns")) {
        std::vector<Bar> bars;
        for (const Json& row : results.at("rows")) {
            if (row.contains("at")) continue;
            const Json& cell = row.at("cells").at(column.at("key").get<std::string>());
            if (cell.contains("value") && cell.at("value").is_number())
                bars.push_back({short_title(results, row), text_of(row, "kind"), cell.at("value"), cell_text(cell, column.at("digits"))});
        }
        if (bars.size() > 1) out += "<div>" + bar_chart(label_of(column), better_hint(column), bars) + "</div>\n";
    }
    return out;
}

// Curves: one chart for each row's name, series and unit.
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
            labels[title] = {series.empty() ? "radius, m" : "step, share of the greatest range", group.empty() ? (unit == "%" ? "holes, % of the picture" : unit) : better_hint(column)};
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
        if (!curves.empty()) out += "<div>" + line_chart(title, labels[title].first, labels[title].second, curves) + "</div>\n";
    }
    return out;
}

// One scene's figures: a row for each of its groups, a column for what any of them has.
std::string facts_html(const Json& record, const Json& results) {
    std::map<std::string, std::map<std::string, std::string>> rows;  // group -> column -> text
    std::vector<std::string> groups;
    std::vector<const Json*> shown;
    for (const Json& column : results.at("columns")) {
        const std::string key = column.at("key");
        bool any = false;
        for (const Json& sample : record.at("samples")) {
            if (sample.contains("at") || !sample.at("values").contains(key)) continue;
            const std::string group = sample.at("group");
            if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
            rows[group][key] = cell_text({{"value", sample.at("values").at(key)}}, column.at("digits"));
            any = true;
        }
        if (any) shown.push_back(&column);
    }
    if (shown.empty()) return "";
    std::string out = "<table class=\"facts\"><tr><th></th>";
    for (const Json* column : shown) out += "<th>" + html_escaped(label_of(*column)) + "</th>";
    for (const std::string& group : groups) {
        out += "</tr>\n<tr><td>" + html_escaped(group.empty() ? text_of(record, "variant") : group) + "</td>";
        for (const Json* column : shown) out += "<td>" + rows[group][column->at("key").get<std::string>()] + "</td>";
    }
    return out + "</tr></table>\n";
}

std::string scene_html(const Json& record, const Json& results, const fs::path& out) {
    const std::string prompt = text_of(record, "prompt");
    std::string html = fmt::format("<section class=\"scene\"><h3>{}</h3>\n<div class=\"hint\">{}, seed {}{}, {}</div>\n",
                                   prompt.empty() ? escaped(record, "scene") : "“" + html_escaped(prompt) + "”", escaped(record, "variant"), record.at("seed").get<std::uint64_t>(),
                                   record.contains("quality") ? ", quality " + escaped(record, "quality") : "", escaped(record, "folder"));
    if (record.contains("failed")) return html + "<div class=\"todo failed\"><p>Failed</p>" + escaped(record, "failed") + "</div></section>\n";
    // A comparison all around shows panorama 0 anyway.
    const auto& figures = record.at("figures");
    const bool shown_below = std::any_of(figures.begin(), figures.end(), [](const Json& figure) { return figure.at("wide").get<bool>(); });
    if (record.contains("panorama") && !shown_below) html += fmt::format("<img class=\"panorama\" alt=\"panorama 0\" src=\"{}\">\n", picture_data(out, text_of(record, "panorama"), 1060));
    html += facts_html(record, results);
    if (!figures.empty()) html += "<details open><summary>Pictures</summary>" + figures_html(figures, out) + "</details>";
    return html + "</section>\n";
}

std::string list_html(const Json& items) {
    std::string out;
    for (const Json& item : items) out += "<li>" + html_escaped(item.get<std::string>()) + "</li>\n";
    return out.empty() ? "" : "<ul class=\"notes\">\n" + out + "</ul>\n";
}

std::string columns_html(const Json& results) {
    std::string out = "<dl>\n";
    for (const Json& column : results.at("columns")) out += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(column, "label"), escaped(column, "about"));
    return out + "</dl>\n";
}

}  // namespace

std::string report_html(const Json& results, const fs::path& out) {
    std::string html = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                       escaped(results, "title") + "</title>\n<style>\n" + std::string(kReportStyle) + "</style></head>\n<body><main>\n";
    const auto done = results.at("scenes_done").get<int>(), all = results.at("scenes_all").get<int>();
    html += fmt::format("<header><div class=\"kicker\">fastscene evaluate {}</div><h1>{}</h1>\n<p>{}</p><div class=\"meta\">{}, fastscene {}</div></header>\n", escaped(results, "suite"),
                        escaped(results, "title"), escaped(results, "about"), done < all ? fmt::format("{} of {} scenes so far", done, all) : fmt::format("{} scenes", all),
                        escaped(results.at("versions"), "fastscene"));
    html += "<h2>Results</h2>\n" + table_html(results) + missing_html(results);
    if (const std::string curves = curves_html(results); !curves.empty()) html += "<h2>Curves</h2>\n<div class=\"charts\">" + curves + "</div>\n";
    if (const std::string bars = bars_html(results); !bars.empty()) html += "<h2>Side by side</h2>\n<div class=\"charts\">" + bars + "</div>\n";
    if (!results.at("notes").empty()) html += "<h2>Protocol</h2>\n" + list_html(results.at("notes"));
    html += "<h2>Scenes</h2>\n<p class=\"hint\">Differences: none <span class=\"scale\"></span> 48 of 255 and more, mean of the three colors.</p>\n";
    for (const Json& record : results.at("records")) html += scene_html(record, results, out);
    return html + "<h2>What the columns say</h2>\n" + columns_html(results) + "</main></body></html>\n";
}

}  // namespace fastscene
