// RealityScan's (RealityCapture's) "Internal/External camera parameters": a CSV with a row a picture. Camera to world
// is heading about z (clockwise), pitch about x, roll about y, in degrees; the camera looks along -z with y up, in a
// world whose z is up. Focal length and principal point are relative to the picture's longer side: the former to 36 mm.
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/capture_parts.h"
#include "fastscene/io/picture_folder.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr double kFilmWidth_mm = 36;

std::vector<std::string_view> split(std::string_view line, char by) {
    std::vector<std::string_view> out;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find(by, at), line.size());
        std::string_view word = line.substr(at, end - at);
        while (!word.empty() && (word.front() == ' ' || word.front() == '"')) word.remove_prefix(1);
        while (!word.empty() && (word.back() == ' ' || word.back() == '"' || word.back() == '\r'))
            word.remove_suffix(1);
        out.push_back(word);
        at = end + 1;
    }
    return out;
}

class Table {
  public:
    explicit Table(const fs::path& file) : file_(file), text_(read_file(file)) {
        if (text_.starts_with("\xef\xbb\xbf")) text_.erase(0, 3);
        std::string_view header;
        if (!next_line(header)) refuse("expected a header line that begins with #name, found an empty file");
        separator_ = header.find(';') != std::string_view::npos    ? ';'
                     : header.find('\t') != std::string_view::npos ? '\t'
                                                                   : ',';
        std::size_t column = 0;
        for (const std::string_view name : split(header, separator_)) columns_.emplace(std::string(name), column++);
        for (const char* name : {"#name", "x", "y", "heading", "pitch", "roll", "f"})
            if (!columns_.contains(name))
                refuse(
                    fmt::format("expected RealityScan's \"Internal/External camera parameters\" with a column {}, "
                                "found the header {}",
                                name, header.substr(0, 100)));
    }
    bool next_row() {
        std::string_view line;
        while (next_line(line)) {
            row_ = split(line, separator_);
            if (row_.size() > 1) return true;
        }
        return false;
    }
    std::string name() const { return std::string(cell("#name")); }
    // 0 if there is no such column.
    double number(const std::string& column) const {
        const std::string_view text = cell(column);
        double value = 0;
        if (text.empty() && !columns_.contains(column)) return 0;
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (code != std::errc() || end != text.data() + text.size())
            refuse(fmt::format("line {}: expected a number as {}, found \"{}\"", line_, column, text));
        return value;
    }
    bool has(const std::string& column) const { return columns_.contains(column); }
    [[noreturn]] void refuse(const std::string& what) const { throw Error("{}: {}", file_.string(), what); }

  private:
    bool next_line(std::string_view& line) {
        if (at_ >= text_.size()) return false;
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        line = std::string_view(text_).substr(at_, end - at_);
        at_ = end + 1;
        ++line_;
        return true;
    }
    std::string_view cell(const std::string& column) const {
        const auto found = columns_.find(column);
        return found == columns_.end() || found->second >= row_.size() ? std::string_view() : row_[found->second];
    }

    fs::path file_;
    std::string text_;
    std::size_t at_ = 0, line_ = 0;
    char separator_ = ',';
    std::map<std::string, std::size_t> columns_;
    std::vector<std::string_view> row_;
};

Rigidd pose_in(const Table& table) {
    constexpr double kDegree = std::numbers::pi / 180;
    const Mat3d turn = rotation_about({0, 0, 1}, -table.number("heading") * kDegree) *
                       rotation_about({1, 0, 0}, table.number("pitch") * kDegree) *
                       rotation_about({0, 1, 0}, table.number("roll") * kDegree);
    const Mat3d ours = Mat3d::from_columns(turn.column(0), -turn.column(1), -turn.column(2));
    return {ours, {table.number("x"), table.number("y"), table.number(table.has("alt") ? "alt" : "z")}};
}

// The picture's size is not in the table; until it is known, lengths are shares of its longer side.
Lens lens_in(const Table& table) {
    Lens lens;
    lens.fx = lens.fy = table.number("f") / kFilmWidth_mm;
    lens.cx = table.number("px"), lens.cy = table.number("py");
    for (std::size_t i = 0; i < 3; ++i) lens.k[i] = table.number(fmt::format("k{}", i + 1));
    lens.p1 = table.number("t1"), lens.p2 = table.number("t2");
    if (table.number("k4") != 0)
        table.refuse(fmt::format("{}: expected a k4 of 0 (distortion model Brown3), found {}", table.name(),
                                 table.number("k4")));
    if (!(lens.fx > 0)) table.refuse(fmt::format("{}: expected a positive focal length f", table.name()));
    return lens;
}

}  // namespace

Capture load_realityscan_capture(const fs::path& file, const CaptureFolders& folders) {
    Table table(file);
    Capture capture;
    capture.source = file.string();
    std::vector<std::string> unusable;
    while (table.next_row()) {
        Photo photo{table.name(), {}, {}, lens_in(table), pose_in(table)};
        const Vec3d at = photo.world_from_camera.translation;
        if (std::isfinite(at.x + at.y + at.z + photo.world_from_camera.rotation.row0.x))
            capture.photos.push_back(photo);
        else unusable.push_back(photo.name);
    }
    if (!unusable.empty())
        capture.warnings.push_back(fmt::format("{}: {} pictures without a finite pose are left out, {} first",
                                               capture.source, unusable.size(), unusable.front()));
    name_labelled_files(capture, folders, file.parent_path());
    give_sizes(capture, [](Lens& lens, int width, int height) {
        const double side = std::max(width, height);
        lens.width = width, lens.height = height;
        lens.fx *= side, lens.fy *= side;
        lens.cx = lens.cx * side + width / 2.0, lens.cy = lens.cy * side + height / 2.0;
    });
    finish_capture(capture, folders);
    return capture;
}

}  // namespace fastscene
