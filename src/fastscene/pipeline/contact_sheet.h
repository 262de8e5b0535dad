// Contact sheet: pictures of every room type in every style, side by side, to inspect the room generator.
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
    std::string view = "panorama";  // panorama or perspective
    TraceParams trace{.cell_m = 0.07f, .cell_samples = 64, .pixel_samples = 16, .outside_detail = 4};
};
template <class V>
void visit_fields(SheetParams& p, V&& v) {
    v("width", p.width, Bounds{64, 4096}, "Width of one picture in pixels; even.");
    v("view", p.view, Choices{{"panorama", "perspective"}},
      "View of a room: a panorama, or two perspective views of 100 degrees, forward and back.");
    visit_fields(p.trace, v);
}

// Renders "a <style> <room>" for every pair (empty lists: all) to folder/<room>-<style>.png, and combines them:
// folder/sheet.jpg has a row per room and a column per style, folder/<room>.jpg two styles per row. Existing pictures
// of the same settings, seed and version are kept. Returns the sheets' paths. Throws UsageError for an unknown room or
// style.
std::vector<std::filesystem::path> make_contact_sheet(const std::filesystem::path& folder,
                                                      std::vector<std::string> rooms, std::vector<std::string> styles,
                                                      const SheetParams& params, const Run& run);

}  // namespace fastscene
