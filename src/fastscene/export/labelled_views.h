// The views of a run as a labelled data set: pictures and cameras as COLMAP and nerfstudio read them, and maps beside.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

inline constexpr std::array kViewMaps{"depth", "normal", "instance", "class"};

// Writes into `out`: images/, sparse/, transforms.json (copied from `views`, with the maps' names), a folder per map of
// `wanted`, and instances.json. Returns the number of views. Throws UsageError if the views' cameras were estimated.
std::size_t write_labelled_views(const std::filesystem::path& views, const std::filesystem::path& out,
                                 const TracedRoom& room, const std::vector<std::string>& wanted, const Run& run);

}  // namespace fastscene
