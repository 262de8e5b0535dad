#include "fastscene/evaluate/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace fastscene {
namespace {

const Json& cell_at(const Json& row, const Json& column) {
    return row.at("cells").at(column.at("key").get<std::string>());
}

void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ", ") + item; }

// a … z, aa, ab …
std::string mark_of(std::size_t i) { return (i < 26 ? "" : mark_of(i / 26 - 1)) + static_cast<char>('a' + i % 26); }

// "inf": equal to its reference, and so better than any number.
double value_of(const Json& cell) {
    const Json& value = cell.at("value");
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::infinity();
}

bool same_scenes(const Json& a, const Json& b) {
    return a.contains("scenes") && b.contains("scenes") ? a.at("scenes") == b.at("scenes")
                                                        : a.value("count", 0) == b.value("count", 0);
}

std::string names_of(const Json& files) {
    std::string names;
    for (const Json& file : files) append(names, std::filesystem::path(file.get<std::string>()).filename().string());
    return names;
}

}  // namespace

std::string cell_text(const Json& cell, int digits) {
    if (!cell.contains("value")) return "–";
    return cell.at("value").is_string() ? cell.at("value").get<std::string>()
                                        : fmt::format("{:.{}f}", cell.at("value").get<double>(), digits);
}

std::string deviation_text(const Json& cell, int digits) {
    return cell.contains("sd") ? fmt::format("{:.{}f}", cell.at("sd").get<double>(), digits) : "";
}

std::string share_text(const Json& cell) {
    const int count = cell.value("count", 0), of = cell.value("of", 0);
    return cell.contains("value") && count < of ? fmt::format("{} of {}", count, of) : "";
}

std::string row_title(const Json& row) {
    const std::string name = row.at("name"), group = row.at("group");
    return group.empty() ? name : name + ", " + group;
}

std::string published_title(const Json& row) {
    std::string title = row_title(row);
    if (row.at("kind") != "published") return title;
    if (!title.ends_with(")")) return title + " (published)";
    title.pop_back();
    return title + ", published)";
}

std::string row_scenes(const Json& row) {
    const int scenes = row.at("scenes"), of = row.value("of", scenes);
    return row.at("kind") == "published" ? ""
           : scenes < of                 ? fmt::format("{} of {}", scenes, of)
                                         : fmt::format("{}", scenes);
}

bool scene_counts_differ(const Json& results) {
    int first = -1;
    for (const Json& row : results.at("rows")) {
        if (row.at("kind") == "published") continue;
        const int of = row.value("of", row.at("scenes").get<int>());
        if (first >= 0 && of != first) return true;
        first = of;
    }
    return false;
}

bool is_best(const Json& results, const Json& row, const Json& column) {
    const std::string better = column.at("better");
    const int digits = column.at("digits");
    const auto counts = [&](const Json& r) {
        return (r.at("kind") == "ours" || r.at("kind") == "peer") && r.at("group") == row.at("group") &&
               cell_at(r, column).contains("value");
    };
    if (better == "neither" || !counts(row)) return false;
    const Json& own = cell_at(row, column);
    int rivals = 0;
    for (const Json& other : results.at("rows")) {
        if (&other == &row || !counts(other)) continue;
        const Json& cell = cell_at(other, column);
        if (!same_scenes(own, cell) || cell_text(own, digits) == cell_text(cell, digits)) return false;
        const double difference = value_of(cell) - value_of(own);
        if (better == "higher" ? difference > 0 : difference < 0) return false;
        ++rivals;
    }
    return rivals > 0;
}

std::vector<std::string> cell_notes(const Json& cell) {
    std::vector<std::string> out;
    for (const Json& note : cell.value("notes", Json::array())) out.push_back(note);
    const std::string older = cell.value("note", "");
    if (!older.empty() && older != "not measured" && older != "not published") out.push_back(older);
    return out;
}

Footnotes::Footnotes(const Json& results) {
    for (const Json& row : results.at("rows"))
        for (const Json& column : results.at("columns"))
            for (const std::string& note : cell_notes(cell_at(row, column))) {
                const std::string label = column.at("label");
                const auto known = std::find_if(list_.begin(), list_.end(),
                                                [&](const Footnote& f) { return f.text == note; });
                if (known == list_.end()) list_.push_back({mark_of(list_.size()), label, note});
                else if ((", " + known->columns + ", ").find(", " + label + ", ") == std::string::npos)
                    append(known->columns, label);
            }
}

std::string Footnotes::marks(const Json& cell) const {
    std::string marks;
    const std::vector<std::string> notes = cell_notes(cell);
    for (const Footnote& footnote : list_)
        if (std::find(notes.begin(), notes.end(), footnote.text) != notes.end()) append(marks, footnote.mark);
    return marks;
}

std::vector<std::string> failures_of(const Json& results, const std::string& variant) {
    std::vector<std::string> out;
    for (const Json& record : results.at("records")) {
        if (!record.contains("failed") || (!variant.empty() && record.at("variant") != variant)) continue;
        const std::string seed = record.at("kind") == "ours"
                                     ? fmt::format(", seed {}", record.at("seed").get<std::uint64_t>())
                                     : "";
        const std::string variant_of = record.at("variant"), scene = record.at("scene"), why = record.at("failed");
        out.push_back(fmt::format("{}, {}{}: {}", variant_of, scene, seed, why));
    }
    return out;
}

std::vector<ParameterNote> parameter_notes(const Json& results) {
    std::vector<ParameterNote> out;
    const Json parameters = results.value("parameters", Json::object());
    for (const Json& column : results.at("columns")) {
        const std::string label = column.at("label");
        const Json used = parameters.value(column.at("key").get<std::string>(), Json::array());
        std::string text;
        for (const Json& one : used) {
            const std::string what = fmt::format("{} ({})", names_of(one.at("files")),
                                                 one.at("identity").get<std::string>().substr(0, 8));
            if (used.size() == 1) text = "with " + what;
            else text += fmt::format("{}{} scenes with {}", text.empty() ? "" : ", ", one.at("scenes").size(), what);
        }
        if (used.size() > 1) text += ": these figures do not compare; evaluate again";
        if (!text.empty()) out.push_back({label, text, used.size() > 1});
    }
    return out;
}

}  // namespace fastscene
