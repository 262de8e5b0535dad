// Contact sheet: a picture of every room in every style, side by side: to look at what the room maker makes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct SheetParams {
    int width = 384;                // of one picture
    std::string view = "panorama";  // or "perspective"
    TraceParams trace{.cell_m = 0.07f, .cell_samples = 64, .pixel_samples = 16};
};
template <class V>
void visit_fields(SheetParams& p, V&& v) {
    v("width", p.width, Bounds{64, 4096}, "Width of one picture in pixels; even.");
    v("view", p.view, Choices{{"panorama", "perspective"}},
      "What is shown of a room: all of it, or two views of 100 degrees, ahead and back.");
    visit_fields(p.trace, v);
}

// Renders "a <style> <room>" for every pair (empty lists: all there are) into folder/<room>-<style>.png, and puts them
// together: folder/sheet.jpg has a row a room and a column a style, folder/<room>.jpg two styles a row. Pictures that
// are there from the same settings, seed and program are kept. Returns the sheets' paths. Throws UsageError for an
// unknown room or style.
std::vector<std::filesystem::path> make_contact_sheet(const std::filesystem::path& folder,
                                                      std::vector<std::string> rooms, std::vector<std::string> styles,
                                                      const SheetParams& params, const Run& run);

}  // namespace fastscene
