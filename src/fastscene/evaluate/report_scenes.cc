// The page's scene sections, one per room. Results of several rows are side by side, shared pictures are shown once.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fastscene/evaluate/cells.h"
#include "fastscene/evaluate/charts.h"
#include "fastscene/evaluate/report_figures.h"
#include "fastscene/evaluate/report_parts.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct RoomResults {
    std::string scene;
    std::uint64_t seed = 0;
    std::vector<const Json*> records;  // one per row
};

// In order of first appearance; a peer's scene joins the first room of the same name.
std::vector<RoomResults> rooms_of(const Json& results) {
    std::vector<RoomResults> rooms;
    for (const Json& record : results.at("records")) {
        const std::string scene = record.at("scene");
        const std::uint64_t seed = record.at("seed");
        const bool peer = record.at("kind") == "peer";
        auto room = std::find_if(rooms.begin(), rooms.end(),
                                 [&](const RoomResults& r) { return r.scene == scene && (peer || r.seed == seed); });
        if (room == rooms.end()) room = rooms.insert(rooms.end(), {scene, seed, {}});
        room->records.push_back(&record);
    }
    return rooms;
}

// Figures of a room: a table row per group of each row, a column for each figure that any of them has.
std::string facts_html(const RoomResults& room, const Json& results) {
    std::vector<std::pair<std::string, std::map<std::string, std::string>>> rows;  // title, column -> text
    std::vector<const Json*> shown;
    for (const Json* record : room.records)
        for (const Json& sample : record->value("samples", Json::array())) {
            if (sample.contains("at")) continue;
            const std::string title = row_title({{"name", record->at("variant")}, {"group", sample.at("group")}});
            auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.first == title; });
            if (row == rows.end()) row = rows.insert(rows.end(), {title, {}});
            for (const Json& column : results.at("columns")) {
                const std::string key = column.at("key");
                if (!sample.at("values").contains(key)) continue;
                row->second[key] = cell_text({{"value", sample.at("values").at(key)}}, column.at("digits"));
                if (std::find(shown.begin(), shown.end(), &column) == shown.end()) shown.push_back(&column);
            }
        }
    std::erase_if(rows, [](const auto& row) { return row.second.empty(); });
    if (shown.empty()) return "";
    std::sort(shown.begin(), shown.end());  // pointers into one array: sorts into the table's order
    std::string out = "<div class=\"wide-facts\"><table class=\"facts\"><tr><th></th>";
    for (const Json* column : shown) out += "<th>" + html_escaped(label_of(*column)) + "</th>";
    for (auto& [title, texts] : rows) {
        out += "</tr>\n<tr><td>" + html_escaped(title) + "</td>";
        for (const Json* column : shown) out += "<td>" + texts[column->at("key").get<std::string>()] + "</td>";
    }
    return out + "</tr></table></div>\n";
}

// Combines the figures of several rows: the reference once, then each result above its difference.
Json beside(const std::vector<std::pair<std::string, const Json*>>& figures) {
    const Json& first = *figures.front().second;
    Json merged{{"caption", first.at("caption")},
                {"wide", first.at("wide")},
                {"columns", figures.size() + 1},
                {"pictures", Json::array()}};
    const auto add = [&](const std::string& label, const Json& picture) {
        merged["pictures"].push_back({{"label", label}, {"file", picture.at("file")}});
    };
    add(first.at("pictures")[0].at("label"), first.at("pictures")[0]);
    if (first.at("wide")) {
        for (const auto& [variant, figure] : figures)
            for (const std::size_t i : {1u, 2u})
                add(i == 1 ? variant : variant + ", difference", figure->at("pictures")[i]);
        return merged;
    }
    for (const auto& [variant, figure] : figures) add(variant, figure->at("pictures")[1]);
    merged["pictures"].push_back({{"label", ""}, {"file", ""}});
    for (const auto& [variant, figure] : figures) add("difference", figure->at("pictures")[2]);
    return merged;
}

// Groups the rows' figures by position and kind; figures of a single row are labelled with its name.
Json figures_of(const RoomResults& room) {
    Json out = Json::array();
    std::size_t most = 0;
    for (const Json* record : room.records) most = std::max(most, record->value("figures", Json::array()).size());
    for (std::size_t i = 0; i < most; ++i) {
        std::vector<std::pair<std::string, const Json*>> pairs;
        for (const Json* record : room.records) {
            if (!record->contains("figures") || i >= record->at("figures").size()) continue;
            const Json& figure = record->at("figures")[i];
            const std::string variant = record->at("variant");
            const bool pair = figure.at("pictures").size() == 3;
            if (pair && (pairs.empty() || pairs.front().second->at("caption") == figure.at("caption"))) {
                pairs.emplace_back(variant, &figure);
                continue;
            }
            out.push_back(figure);
            const std::string caption = figure.at("caption");
            if (room.records.size() > 1) out.back()["caption"] = caption.empty() ? variant : variant + ": " + caption;
        }
        if (pairs.size() == 1) out.push_back(*pairs.front().second);
        if (pairs.size() > 1) out.push_back(beside(pairs));
    }
    return out;
}

// Panorama 0, once per way of making it.
std::string panoramas_html(const RoomResults& room, const fs::path& out) {
    std::vector<std::string> shown;
    std::string html;
    for (const Json* record : room.records) {
        const std::string quality = text_of(*record, "quality");
        if (!record->contains("panorama") || std::find(shown.begin(), shown.end(), quality) != shown.end()) continue;
        shown.push_back(quality);
        if (const std::string data = picture_data(out, text_of(*record, "panorama"), 1060); !data.empty())
            html += fmt::format("<img class=\"panorama\" alt=\"panorama 0, {}\" src=\"{}\">\n", html_escaped(quality),
                                data);
    }
    return html;
}

std::string room_html(const RoomResults& room, const Json& results, const fs::path& out) {
    const Json& first = *room.records.front();
    const std::string prompt = text_of(first, "prompt");
    std::string html = fmt::format("<section class=\"scene\"><h3>{}</h3>\n",
                                   html_escaped(prompt.empty() ? room.scene : "“" + prompt + "”"));
    for (const Json* record : room.records)
        html += fmt::format("<div class=\"hint\">{}{}{}, {}</div>\n", html_escaped(text_of(*record, "variant")),
                            record->at("kind") == "ours" ? fmt::format(", seed {}", room.seed) : "",
                            record->contains("quality") ? ", quality " + html_escaped(text_of(*record, "quality")) : "",
                            html_escaped(text_of(*record, "folder")));
    for (const Json* record : room.records)
        if (record->contains("failed"))
            html += fmt::format("<div class=\"todo failed\"><p>{} failed</p>{}</div>\n",
                                html_escaped(text_of(*record, "variant")), html_escaped(text_of(*record, "failed")));
    const Json figures = figures_of(room);
    // Panoramic comparisons show panorama 0 anyway.
    if (std::none_of(figures.begin(), figures.end(), [](const Json& figure) { return figure.at("wide").get<bool>(); }))
        html += panoramas_html(room, out);
    html += facts_html(room, results);
    if (!figures.empty())
        html += "<details open><summary>Pictures</summary>" + figures_html(figures, out) + "</details>";
    return html + "</section>\n";
}

}  // namespace

std::string scenes_html(const Json& results, const fs::path& out) {
    std::string html;
    for (const RoomResults& room : rooms_of(results)) html += room_html(room, results, out);
    return html;
}

}  // namespace fastscene
