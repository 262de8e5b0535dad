// The HTML report: table, charts, protocol, scenes. Self-contained, so that it can be sent and opened anywhere.
#include <fmt/format.h>

#include <set>

#include "fastscene/evaluate/cells.h"
#include "fastscene/evaluate/charts.h"
#include "fastscene/evaluate/report_parts.h"
#include "fastscene/evaluate/write.h"

namespace fastscene {
extern const std::string_view kReportStyle;  // report.css

std::string text_of(const Json& json, const char* key) { return json.value(key, std::string()); }

// Appends the unit, unless the label already contains it.
std::string label_of(const Json& column) {
    const std::string unit = text_of(column, "unit");
    return text_of(column, "label") + (unit.empty() || unit == "min" ? "" : " (" + unit + ")");
}

namespace {
namespace fs = std::filesystem;

std::string escaped(const Json& json, const char* key) { return html_escaped(text_of(json, key)); }

std::string cell_html(const Json& results, const Json& row, const Json& column, const Footnotes& footnotes) {
    const Json& cell = row.at("cells").at(column.at("key").get<std::string>());
    std::string text = cell_text(cell, column.at("digits"));
    if (const std::string sd = deviation_text(cell, column.at("digits")); !sd.empty())
        text += " <small>± " + sd + "</small>";
    if (const std::string share = share_text(cell); !share.empty())
        text += " <small class=\"share\">" + share + "</small>";
    if (const std::string marks = footnotes.marks(cell); !marks.empty()) text += "<sup>" + marks + "</sup>";
    return fmt::format("<td{}>{}</td>",
                       !cell.contains("value")         ? " class=\"none\""
                       : is_best(results, row, column) ? " class=\"best\""
                                                       : "",
                       text);
}

std::string table_html(const Json& results, const Footnotes& footnotes) {
    const bool with_scenes = scene_counts_differ(results);
    std::string out = std::string("<div class=\"scroll\"><table>\n<tr><th></th>") +
                      (with_scenes ? "<th>scenes</th>" : "");
    for (const Json& column : results.at("columns")) {
        const std::string better = column.at("better"), arrow = better == "higher"  ? "&nbsp;↑"
                                                                : better == "lower" ? "&nbsp;↓"
                                                                                    : "";
        out += fmt::format("<th title=\"{}\">{}{}</th>", escaped(column, "about"), html_escaped(label_of(column)),
                           arrow);
    }
    out += "</tr>\n";
    std::string before;
    for (const Json& row : results.at("rows")) {
        const std::string kind = row.at("kind");
        const bool turn = before == "published" && kind != "published";
        out += fmt::format("<tr class=\"{}{}{}\"><td><i class=\"swatch {}\"></i>{}</td>", kind,
                           row.value("ours", false) ? " target" : "", turn ? " turn" : "", kind,
                           html_escaped(published_title(row)));
        if (with_scenes) out += "<td>" + row_scenes(row) + "</td>";
        for (const Json& column : results.at("columns")) out += cell_html(results, row, column, footnotes);
        out += "</tr>\n";
        before = kind;
    }
    return out + "</table></div>\n";
}

// Words in `backquotes` as code.
std::string with_code(const std::string& text) {
    std::string out;
    bool inside = false;
    for (const char c : html_escaped(text))
        out += c != '`' ? std::string(1, c) : (inside = !inside) ? "<code>" : "</code>";
    return inside ? html_escaped(text) : out;
}

// Below the table: failures, omissions and reasons for empty cells, each once.
std::string notes_html(const Json& results, const Footnotes& footnotes) {
    std::string items, failures, mixed;
    for (const Footnote& note : footnotes.all())
        items += fmt::format("<li><sup>{}</sup> <b>{}</b>: {}</li>\n", note.mark, html_escaped(note.columns),
                             with_code(note.text));
    for (const std::string& failure : failures_of(results)) failures += "<li>" + html_escaped(failure) + "</li>\n";
    for (const ParameterNote& note : parameter_notes(results))
        if (note.mixed)
            mixed += fmt::format("<li><b>{}</b>: {}</li>\n", html_escaped(note.column), html_escaped(note.text));
    std::string out;
    if (!items.empty()) out += "<ul class=\"footnotes\">\n" + items + "</ul>\n";
    if (!mixed.empty())
        out += "<div class=\"todo failed\"><p>Scenes measured with different parameter files</p><ul>" + mixed +
               "</ul></div>\n";
    if (!failures.empty())
        out += "<div class=\"todo failed\"><p>Scenes that failed</p><ul>" + failures + "</ul></div>\n";
    return out;
}

std::string list_html(const Json& items) {
    std::string out;
    for (const Json& item : items) out += "<li>" + with_code(item) + "</li>\n";
    return out.empty() ? "" : "<ul class=\"notes\">\n" + out + "</ul>\n";
}

// With the parameter files of each measure.
std::string columns_html(const Json& results) {
    std::string out = "<dl>\n";
    const std::vector<ParameterNote> parameters = parameter_notes(results);
    for (const Json& column : results.at("columns")) {
        out += fmt::format("<dt>{}</dt><dd>{}", escaped(column, "label"), escaped(column, "about"));
        for (const ParameterNote& note : parameters)
            if (note.column == text_of(column, "label"))
                out += "; <span class=\"files\">" + html_escaped(note.text) + "</span>";
        out += "</dd>\n";
    }
    return out + "</dl>\n";
}

std::string count_text(std::size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

// Counts rooms, not the results of each row.
std::string size_text(const Json& results) {
    const auto done = results.at("scenes_done").get<int>(), all = results.at("scenes_all").get<int>();
    if (done < all) return fmt::format("{} of {} scenes so far", done, all);
    std::set<std::string> rooms, variants;
    for (const Json& record : results.at("records")) {
        if (record.at("kind") != "ours") continue;
        rooms.insert(
            fmt::format("{} {}", record.at("scene").get<std::string>(), record.at("seed").get<std::uint64_t>()));
        variants.insert(record.at("variant").get<std::string>());
    }
    return count_text(rooms.size(), "room", "rooms") +
           (variants.size() > 1 ? fmt::format(", made in {} ways", variants.size()) : "");
}

}  // namespace

std::string report_html(const Json& results, const fs::path& out) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width, "
        "initial-scale=1\">\n<title>" +
        escaped(results, "title") + "</title>\n<style>\n" + std::string(kReportStyle) +
        "</style></head>\n<body><main>\n";
    html += fmt::format(
        "<header><div class=\"kicker\">fastscene evaluate {}</div><h1>{}</h1>\n<p>{}</p><div class=\"meta\">{}, "
        "fastscene {}</div></header>\n",
        escaped(results, "suite"), escaped(results, "title"), escaped(results, "about"), size_text(results),
        escaped(results.at("versions"), "fastscene"));
    const Footnotes footnotes(results);
    html += "<h2>Results</h2>\n" + table_html(results, footnotes) + notes_html(results, footnotes);
    if (const std::string curves = curves_html(results); !curves.empty())
        html += "<h2>Curves</h2>\n<div class=\"charts\">" + curves + "</div>\n";
    if (const std::string bars = bars_html(results); !bars.empty())
        html += "<h2>Side by side</h2>\n<div class=\"charts\">" + bars + "</div>\n";
    if (!results.at("notes").empty()) html += "<h2>Protocol</h2>\n" + list_html(results.at("notes"));
    html +=
        "<h2>Scenes</h2>\n<p class=\"hint\">Differences: none <span class=\"scale\"></span> 48 of 255 and more, mean "
        "of the three colors.</p>\n";
    html += scenes_html(results, out);
    return html + "<h2>What the columns say</h2>\n" + columns_html(results) + "</main></body></html>\n";
}

}  // namespace fastscene
