#include "fastscene/pipeline/contact_sheet.h"

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/json.h"
#include "fastscene/image/color.h"
#include "fastscene/image/label.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/pipeline/stage_code.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/style.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr Rgb8 kPaper{245, 244, 240}, kInk{40, 38, 36};
constexpr int kGap = 6;

void check_names(const std::string& flag, std::vector<std::string>& names, const std::vector<std::string>& known) {
    if (names.empty()) names = known;
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw UsageError("{}: expected {}, found \"{}\"", flag, fmt::join(known, ", "), name);
}

std::string file_name(const std::string& room, const std::string& style) {
    std::string name = room + "-" + style + ".png";
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

// Two views side by side: the room's main direction, and the opposite one.
ImageRgb8 perspectives(const TracedRoom& room, int width, const ShotParts& parts, const Run& run) {
    const int half = width / 2, height = half * 3 / 4;
    const Pinhole camera = Pinhole::with_fov(half, height, 100);
    ImageRgb8 out(width, height);
    for (const bool back : {false, true}) {
        // Most furniture is below eye height.
        const Mat3f turn = rotation_about(Vec3f{0, 1, 0}, back ? 3.14159265f : 0.f) *
                           rotation_about(Vec3f{1, 0, 0}, -0.2f);
        const Shot shot = room.perspective({turn, {}}, camera, parts, run);
        paste(out, srgb8_from_linear(shot.color), back ? half : 0, 0);
    }
    return out;
}

ImageRgb8 picture_of(const std::string& room, const std::string& style, const SheetParams& params, const Run& run) {
    PromptSpec spec = understand_prompt("a " + style + " " + room_title(room), false);
    PanoramaParams panorama;
    panorama.trace = params.trace;
    const auto traced = make_traced_room(spec, panorama, {run.seed, nullptr, run.stop});
    ShotParts parts = panorama_parts(params.trace);
    parts.range = parts.object = false;
    const Run quiet{run.seed, nullptr, run.stop};
    if (params.view == "perspective") return perspectives(*traced, params.width, parts, quiet);
    return srgb8_from_linear(traced->panorama({}, {params.width, params.width / 2}, parts, quiet).color);
}

// Pictures in columns, with captions above.
struct Tile {
    ImageRgb8 picture;
    std::string name;
};
ImageRgb8 sheet_of(const std::vector<Tile>& tiles, int columns) {
    const int w = tiles.front().picture.width, h = tiles.front().picture.height, label = kGlyphHeight + 5;
    const int rows = (static_cast<int>(tiles.size()) + columns - 1) / columns;
    ImageRgb8 sheet(columns * (w + kGap) + kGap, rows * (h + label + kGap) + kGap, kPaper);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int x = kGap + static_cast<int>(i) % columns * (w + kGap),
                  y = kGap + static_cast<int>(i) / columns * (h + label + kGap);
        draw_label(sheet, tiles[i].name, x, y, kInk);
        paste(sheet, tiles[i].picture, x, y + label);
    }
    return sheet;
}

// Deletes pictures made with other settings or by another version.
void keep_only_fitting(const fs::path& folder, const SheetParams& params, const Run& run) {
    Json key = fields_json(params);
    key["seed"] = run.seed;
    key["code"] = code_version("panorama");
    const std::string text = key.dump(2);
    const fs::path note = folder / "sheet.json";
    if (fs::exists(note) && read_file(note) == text) return;
    if (fs::exists(note))
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".png") fs::remove(entry.path());
    write_file(note, text);
}

}  // namespace

std::vector<fs::path> make_contact_sheet(const fs::path& folder, std::vector<std::string> rooms,
                                         std::vector<std::string> style_names, const SheetParams& params,
                                         const Run& run) {
    check_names("--rooms", rooms, room_types());
    check_names("--styles", style_names, styles());
    check_fields("", params);
    if (params.width % 2 != 0) throw UsageError("--width: expected an even number of pixels, found {}", params.width);
    make_directories(folder);
    keep_only_fitting(folder, params, run);
    Progress progress(run, "rooms", static_cast<std::int64_t>(rooms.size() * style_names.size()));
    std::vector<Tile> all;
    std::vector<fs::path> made;
    for (const std::string& room : rooms) {
        std::vector<Tile> row;
        for (const std::string& style : style_names) {
            run.check_stop();
            const fs::path file = folder / file_name(room, style);
            if (!fs::exists(file)) save_png(file, picture_of(room, style, params, run));
            row.push_back({load_rgb8(file), style + ", " + room_title(room)});
            progress.advance();
        }
        made.push_back(folder / (room + ".jpg"));
        save_jpeg(made.back(), sheet_of(row, 2));
        std::move(row.begin(), row.end(), std::back_inserter(all));
    }
    made.push_back(folder / "sheet.jpg");
    save_jpeg(made.back(), sheet_of(all, static_cast<int>(style_names.size())), 88);
    return made;
}

}  // namespace fastscene
