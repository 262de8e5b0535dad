#include "fastscene/evaluate/write.h"

#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/file.h"

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
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
    return text;
}
std::string markdown_escaped(const std::string& text) { return replaced(replaced(text, "|", "\\|"), "\n", " "); }
std::string csv_quoted(const std::string& text) { return "\"" + replaced(text, "\"", "\"\"") + "\""; }
std::string latex_escaped(std::string text) {
    text = replaced(std::move(text), "\\", "\\textbackslash ");
    for (const char* c : {"&", "%", "$", "#", "_", "{", "}"}) text = replaced(std::move(text), c, std::string("\\") + c);
    return text;
}

std::string full(const Json& cell) {
    if (!cell.contains("value")) return "";
    return cell.at("value").is_string() ? cell.at("value").get<std::string>() : fmt::format("{}", cell.at("value").get<double>());
}

}  // namespace

std::string cell_text(const Json& cell, int digits) {
    if (!cell.contains("value")) return "–";
    return cell.at("value").is_string() ? cell.at("value").get<std::string>() : fmt::format("{:.{}f}", cell.at("value").get<double>(), digits);
}

std::string row_title(const Json& row) {
    const std::string name = row.at("name"), group = row.at("group");
    return group.empty() ? name : name + ", " + group;
}

bool is_best(const Json& results, const Json& row, const Json& column) {
    const std::string key = column.at("key"), better = column.at("better");
    const auto counts = [&](const Json& r) {
        return (r.at("kind") == "ours" || r.at("kind") == "peer") && r.at("group") == row.at("group") && r.at("cells").at(key).contains("value") && r.at("cells").at(key).at("value").is_number();
    };
    if (better == "neither" || !counts(row)) return false;
    const double own = row.at("cells").at(key).at("value");
    int rivals = 0;
    for (const Json& other : results.at("rows")) {
        if (!counts(other)) continue;
        ++rivals;
        const double v = other.at("cells").at(key).at("value");
        if (better == "higher" ? v > own : v < own) return false;
    }
    return rivals > 1;
}

std::vector<std::string> reasons_of(const Json& results, const std::string& column) {
    std::vector<std::string> out;
    for (const Json& row : results.at("rows")) {
        const Json& cell = row.at("cells").at(column);
        if (row.at("kind") == "published" || !cell.contains("note")) continue;
        const std::string note = cell.at("note");
        if (!note.empty() && note != "not measured" && std::find(out.begin(), out.end(), note) == out.end()) out.push_back(note);
    }
    return out;
}

std::string table_markdown(const Json& results) {
    std::string out = fmt::format("# {}\n\n", results.at("title").get<std::string>()), line = "| |", rule = "|---|";
    for (const Json& column : results.at("columns")) {
        line += fmt::format(" {}{} |", markdown_escaped(with_unit(column)), arrow(column, " ↑", " ↓"));
        rule += "--:|";
    }
    out += line + "\n" + rule + "\n";
    for (const Json& row : results.at("rows")) {
        out += fmt::format("| {}{} |", markdown_escaped(row_title(row)), row.at("kind") == "published" ? " (published)" : "");
        for (const Json& column : results.at("columns")) {
            const std::string text = cell_text(row.at("cells").at(column.at("key").get<std::string>()), column.at("digits"));
            out += is_best(results, row, column) ? fmt::format(" **{}** |", text) : fmt::format(" {} |", text);
        }
        out += "\n";
    }
    std::string notes;
    for (const Json& note : results.at("notes")) notes += fmt::format("- {}\n", note.get<std::string>());
    for (const Json& column : results.at("columns"))
        for (const std::string& reason : reasons_of(results, column.at("key"))) notes += fmt::format("- {}: {}\n", column.at("label").get<std::string>(), reason);
    return notes.empty() ? out : out + "\n" + notes;
}

std::string table_csv(const Json& results) {
    std::string out = "row,group,kind,scenes";
    for (const Json& column : results.at("columns")) out += "," + column.at("key").get<std::string>();
    for (const Json& row : results.at("rows")) {
        out += fmt::format("\n{},{},{},{}", csv_quoted(row.at("name")), csv_quoted(row.at("group")), row.at("kind").get<std::string>(), row.at("scenes").get<int>());
        for (const Json& column : results.at("columns")) out += "," + full(row.at("cells").at(column.at("key").get<std::string>()));
    }
    return out + "\n";
}

std::string table_latex(const Json& results) {
    std::string out = fmt::format("% {}\n% method", results.at("title").get<std::string>());
    for (const Json& column : results.at("columns")) out += " & " + with_unit(column) + arrow(column, " (higher is better)", " (lower is better)");
    for (const Json& row : results.at("rows")) {
        out += "\n" + latex_escaped(row_title(row));
        for (const Json& column : results.at("columns")) {
            const Json& cell = row.at("cells").at(column.at("key").get<std::string>());
            const std::string text = cell.contains("value") ? cell.at("value") == "inf" ? "$\\infty$" : cell_text(cell, column.at("digits")) : "--";
            out += is_best(results, row, column) ? " & \\textbf{" + text + "}" : " & " + text;
        }
        out += " \\\\";
    }
    return out + "\n";
}

std::string scenes_csv(const Json& results) {
    std::string out = "row,group,scene,seed,column,value,note\n";
    for (const Json& record : results.at("records")) {
        const std::string who = csv_quoted(record.at("variant")), scene = fmt::format("{},{}", csv_quoted(record.at("scene")), record.at("seed").get<std::uint64_t>());
        if (record.contains("failed")) out += fmt::format("{},\"\",{},,,{}\n", who, scene, csv_quoted("failed: " + record.at("failed").get<std::string>()));
        for (const Json& sample : record.value("samples", Json::array())) {
            const std::string begin = fmt::format("{},{},{}", who, csv_quoted(sample.at("group")), scene);
            for (const auto& [key, value] : sample.at("values").items()) out += fmt::format("{},{},{},\n", begin, key, full({{"value", value}}));
            for (const auto& [key, note] : sample.at("notes").items()) out += fmt::format("{},{},,{}\n", begin, key, csv_quoted(note.get<std::string>()));
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
