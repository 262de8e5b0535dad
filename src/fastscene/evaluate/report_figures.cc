#include "fastscene/evaluate/report_figures.h"

#include <fmt/format.h>

#include "fastscene/base/base64.h"
#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/evaluate/charts.h"
#include "fastscene/evaluate/picture.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace fs = std::filesystem;

namespace {

constexpr int kStillWidth = 300, kPairWidth = 420, kSphereWidth = 1060, kJpegQuality = 84;

}  // namespace

std::string picture_data(const fs::path& out, const fs::path& picture, int width) {
    const fs::path file = out / picture, kept = out / "measured" / "thumbnails";
    if (!fs::exists(file)) return "";  // deleted since; the page leaves a gap
    const std::string key = Hash()
                                .add(file.string())
                                .add(fs::file_size(file))
                                .add(fs::last_write_time(file).time_since_epoch().count())
                                .add(width)
                                .hex();
    const fs::path small = kept / (key + ".jpg");
    if (!fs::exists(small)) try {
            make_directories(kept);
            save_jpeg(small, thumbnail(load_rgb8(file), width), kJpegQuality);
        } catch (const Error&) {
            return "";  // another system's picture may be broken: its scores report that
        }
    return "data:image/jpeg;base64," + base64(read_file(small));
}

std::string figures_html(const Json& figures, const fs::path& out) {
    std::string html;
    for (const Json& figure : figures) {
        const bool wide = figure.at("wide").get<bool>();
        const int columns = wide ? 0 : figure.value("columns", 0);  // rows side by side
        const bool stills = columns == 0 && figure.at("pictures").size() > 3;
        const std::string caption = figure.at("caption");
        const std::string kind = wide ? " wide" : stills ? " stills" : columns ? " beside" : "";
        html += "<figure>" + (caption.empty() ? "" : "<figcaption>" + html_escaped(caption) + "</figcaption>") +
                "<div class=\"row" + kind + "\"";
        html += columns ? fmt::format(" style=\"--columns: {}\">\n", columns) : ">\n";
        for (const Json& picture : figure.at("pictures")) {
            const std::string label = html_escaped(picture.at("label"));
            if (picture.at("file") == "") {  // an empty grid cell
                html += "<div></div>\n";
                continue;
            }
            const std::string file = picture.at("file"), data = picture_data(out, file,
                                                                             wide                ? kSphereWidth
                                                                             : stills || columns ? kStillWidth
                                                                                                 : kPairWidth);
            if (data.empty()) {
                html += fmt::format("<div class=\"gone\">{}: not there, or cannot be read</div>\n",
                                    html_escaped(fs::path(file).filename().string()));
                continue;
            }
            html += fmt::format("<div><img alt=\"{}\" src=\"{}\">{}</div>\n", label, data,
                                label.empty() ? "" : "<span>" + label + "</span>");
        }
        html += "</div></figure>\n";
    }
    return html;
}

}  // namespace fastscene
