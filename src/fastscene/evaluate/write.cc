#include "fastscene/evaluate/write.h"

#include <fmt/format.h>

#include <cctype>

#include "fastscene/base/file.h"
#include "fastscene/evaluate/cells.h"

namespace fastscene {
namespace {

std::string with_unit(const Json& column) {
    const std::string label = column.at("label"), unit = column.at("unit");
    return unit.empty() || label == unit || label.ends_with("minutes") ? label : fmt::format("{}, {}", label, unit);
}
std::string arrow(const Json& column, const char* up, const char* down) {
    const std::string better = column.at("better");
    return better == "higher" ? up : better == "lower" ? down : "";
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}
// Escapes Markdown: names must not start emphasis, code, tags, links or cells. An underscore within a word needs no
// escape.
std::string markdown_escaped(const std::string& text) {
    const auto in_word = [&](std::size_t at) {
        return at < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[at])) || static_cast<unsigned char>(text[at]) >= 0x80);
    };
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool acts = std::string_view("|*`<[\\~").find(c) != std::string_view::npos ||
                          (c == '_' && !(i > 0 && in_word(i - 1) && in_word(i + 1)));
        if (acts) out += '\\';
        out += c == '\n' || c == '\r' ? ' ' : c;
    }
    return out;
}
std::string csv_quoted(const std::string& text) { return "\"" + replaced(text, "\"", "\"\"") + "\""; }
std::string latex_escaped(const std::string& text) {
    // After the \\ of the row above, LaTeX would interpret a leading [2pt] or * as its argument.
    std::string out = text.starts_with('[') || text.starts_with('*') ? "{}" : "";
    for (const char c : text) {
        if (c == '\\') out += "\\textbackslash{}";
        else if (c == '^') out += "\\textasciicircum{}";
        else if (c == '~') out += "\\textasciitilde{}";
        else if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) out += std::string("\\") + c;
        else out += c == '\n' || c == '\r' ? ' ' : c;
    }
    return out;
}
std::string one_line(const std::string& text) { return replaced(replaced(text, "\n", " "), "\r", " "); }

std::string full(const Json& cell, const char* key) {
    if (!cell.contains(key)) return "";
    const Json& value = cell.at(key);
    return value.is_string()           ? value.get<std::string>()
           : value.is_number_integer() ? value.dump()
                                       : fmt::format("{}", value.get<double>());
}

std::string markdown_cell(const Json& results, const Json& row, const Json& column, const Footnotes& footnotes) {
    const Json& cell = row.at("cells").at(column.at("key").get<std::string>());
    std::string text = cell_text(cell, column.at("digits"));
    if (is_best(results, row, column)) text = "**" + text + "**";
    if (const std::string sd = deviation_text(cell, column.at("digits")); !sd.empty()) text += " ± " + sd;
    if (const std::string share = share_text(cell); !share.empty()) text += " (" + share + ")";
    if (const std::string marks = footnotes.marks(cell); !marks.empty()) text += "<sup>" + marks + "</sup>";
    return text;
}

std::string latex_cell(const Json& results, const Json& row, const Json& column, const Footnotes& footnotes) {
    const Json& cell = row.at("cells").at(column.at("key").get<std::string>());
    std::string text = !cell.contains("value")     ? "--"
                       : cell.at("value") == "inf" ? "$\\infty$"
                                                   : cell_text(cell, column.at("digits"));
    if (is_best(results, row, column)) text = "\\textbf{" + text + "}";
    if (const std::string sd = deviation_text(cell, column.at("digits")); !sd.empty()) text += " $\\pm$ " + sd;
    if (const std::string share = share_text(cell); !share.empty()) text += " (" + share + ")";
    if (const std::string marks = footnotes.marks(cell); !marks.empty()) text += "\\textsuperscript{" + marks + "}";
    return text;
}

bool has_deviations(const Json& results) {
    for (const Json& row : results.at("rows"))
        for (const Json& cell : row.at("cells"))
            if (cell.contains("sd")) return true;
    return false;
}

// Below the table: failures first, then omissions, then the protocol.
std::string markdown_notes(const Json& results, const Footnotes& footnotes) {
    std::string notes;
    for (const std::string& failure : failures_of(results)) notes += fmt::format("- failed: {}\n", one_line(failure));
    for (const Footnote& note : footnotes.all())
        notes += fmt::format("- <sup>{}</sup> {}: {}\n", note.mark, note.columns, one_line(note.text));
    if (has_deviations(results)) notes += "- ±: the deviation between scenes.\n";
    for (const ParameterNote& note : parameter_notes(results))
        notes += fmt::format("- {} {}\n", note.column, note.text);
    for (const Json& note : results.at("notes")) notes += fmt::format("- {}\n", note.get<std::string>());
    return notes.empty() ? "" : "\n" + notes;
}

std::string joined(const Json& note) {
    if (note.is_string()) return note;
    std::string out;
    for (const Json& one : note) out += (out.empty() ? "" : "; ") + one.get<std::string>();
    return out;
}

}  // namespace

std::string table_markdown(const Json& results) {
    const Footnotes footnotes(results);
    const bool with_scenes = scene_counts_differ(results);
    std::string out = fmt::format("# {}\n\n", markdown_escaped(results.at("title"))),
                line = with_scenes ? "| | scenes |" : "| |", rule = with_scenes ? "|---|--:|" : "|---|";
    for (const Json& column : results.at("columns")) {
        line += fmt::format(" {}{} |", markdown_escaped(with_unit(column)), arrow(column, " ↑", " ↓"));
        rule += "--:|";
    }
    out += line + "\n" + rule + "\n";
    for (const Json& row : results.at("rows")) {
        out += fmt::format("| {} |", markdown_escaped(published_title(row))) +
               (with_scenes ? fmt::format(" {} |", row_scenes(row)) : "");
        for (const Json& column : results.at("columns"))
            out += fmt::format(" {} |", markdown_cell(results, row, column, footnotes));
        out += "\n";
    }
    return out + markdown_notes(results, footnotes);
}

std::string table_csv(const Json& results) {
    std::string out = "row,group,kind,scenes,of,failed";
    for (const Json& column : results.at("columns"))
        out += fmt::format(",{0},{0}_sd,{0}_n", column.at("key").get<std::string>());
    for (const Json& row : results.at("rows")) {
        const int scenes = row.at("scenes");
        std::string failed;
        if (row.at("kind") != "published")
            for (const std::string& failure : failures_of(results, row.at("name")))
                failed += (failed.empty() ? "" : "; ") + failure;
        out += fmt::format("\n{},{},{},{},{},{}", csv_quoted(row.at("name")), csv_quoted(row.at("group")),
                           row.at("kind").get<std::string>(), scenes, row.value("of", scenes),
                           failed.empty() ? "" : csv_quoted(failed));
        for (const Json& column : results.at("columns")) {
            const Json& cell = row.at("cells").at(column.at("key").get<std::string>());
            out += fmt::format(",{},{},{}", full(cell, "value"), full(cell, "sd"), full(cell, "count"));
        }
    }
    return out + "\n";
}

std::string table_latex(const Json& results) {
    const Footnotes footnotes(results);
    const bool with_scenes = scene_counts_differ(results);
    std::string out = fmt::format("% {}\n% method{}", one_line(results.at("title")), with_scenes ? " & scenes" : "");
    for (const Json& column : results.at("columns"))
        out += " & " + with_unit(column) + arrow(column, " (higher is better)", " (lower is better)");
    for (const Footnote& note : footnotes.all())
        out += fmt::format("\n% {}: {}: {}", note.mark, note.columns, one_line(note.text));
    for (const std::string& failure : failures_of(results)) out += "\n% failed: " + one_line(failure);
    for (const ParameterNote& note : parameter_notes(results)) out += fmt::format("\n% {}: {}", note.column, note.text);
    for (const Json& row : results.at("rows")) {
        out += "\n" + latex_escaped(row_title(row)) + (with_scenes ? " & " + row_scenes(row) : "");
        for (const Json& column : results.at("columns")) out += " & " + latex_cell(results, row, column, footnotes);
        out += " \\\\";
    }
    return out + "\n";
}

std::string scenes_csv(const Json& results) {
    std::string out = "row,group,scene,seed,column,value,note\n";
    for (const Json& record : results.at("records")) {
        const std::string who = csv_quoted(record.at("variant")),
                          scene = fmt::format("{},{}", csv_quoted(record.at("scene")),
                                              record.at("seed").get<std::uint64_t>());
        if (record.contains("failed"))
            out += fmt::format("{},\"\",{},,,{}\n", who, scene,
                               csv_quoted("failed: " + record.at("failed").get<std::string>()));
        for (const Json& sample : record.value("samples", Json::array())) {
            const std::string begin = fmt::format("{},{},{}", who, csv_quoted(sample.at("group")), scene);
            for (const auto& [key, value] : sample.at("values").items())
                out += fmt::format("{},{},{},\n", begin, key, full({{"value", value}}, "value"));
            for (const auto& [key, note] : sample.at("notes").items())
                out += fmt::format("{},{},,{}\n", begin, key, csv_quoted(joined(note)));
        }
    }
    return out;
}

void write_results(const std::filesystem::path& out, const Json& results) {
    write_json(out / "results.json", results);
    write_file(out / "table.md", table_markdown(results));
    write_file(out / "table.csv", table_csv(results));
    write_file(out / "table.tex", table_latex(results));
    write_file(out / "scenes.csv", scenes_csv(results));
    write_file(out / "report.html", report_html(results, out));
}

}  // namespace fastscene
