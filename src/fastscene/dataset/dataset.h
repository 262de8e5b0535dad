// Dataset: random rooms as training data: color, exact range, normals, class and instance ids, albedo and shading,
// optical flow, cameras, the rooms themselves.
//
// Pictures are numbered from 0 and depend on (settings, seed, number) only, so a set can be made by any number of
// processes on any number of machines, interrupted, resumed and extended; docs/dataset.md describes the files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "fastscene/base/fields.h"
#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct DatasetParams {
    std::string camera = "auto";
    std::string film = "varied";
    std::string channels;  // words of dataset/channels.h, separated by commas
    int views = 4;
    double over_things = 0.25;
    int shard = 1000;
    int stale_minutes = 20;
    TraceParams trace{.cell_m = 0.06f, .cell_samples = 160, .pixel_samples = 9, .outside_detail = 5};
};
template <class V>
void visit_fields(DatasetParams& p, V&& v) {
    v("camera", p.camera, Choices{{"auto", "panorama", "perspective"}},
      "Kind of picture; auto: a panorama if WIDTH is twice HEIGHT, else a perspective view.");
    v("film", p.film, Choices{{"varied", "clean"}},
      "varied: random lens blur, noise, tone curve and JPEG compression per picture; clean: lossless, none of these.");
    v("channels", p.channels,
      "Further maps, separated by commas: intrinsics (albedo and shading), flow (to the room's next picture).");
    v("views", p.views, Bounds{1, 1000},
      "Pictures per room, from different positions. A room's light is computed once for all of them.");
    v("over-things", p.over_things, Bounds{0, 1},
      "Share of positions above furniture, if a camera fits there: real panoramas are often taken above a bed or a "
      "table.");
    v("shard", p.shard, Bounds{1, 100000}, "Pictures per folder.");
    v("stale-minutes", p.stale_minutes, Bounds{1, 10000},
      "Take over rooms claimed by a process on another machine that has been inactive for N minutes.");
    visit_fields(p.trace, v);
}

struct DatasetRequest {
    int count = 0;  // total number of pictures
    int width = 0, height = 0;
    DatasetParams params;
};
struct DatasetState {
    int count = 0;  // requested
    int made = 0;   // by this call
    int there = 0;  // in the folder now
};
// Makes the missing pictures that no other process is working on. The process that completes the set writes its card,
// README.md, and index.txt. Throws UsageError if the folder holds a set with other settings or the request is invalid,
// Error if a file cannot be written, Stopped if asked to stop; finished pictures are kept.
DatasetState make_dataset(const DatasetRequest& request, const std::filesystem::path& folder, const Run& run);

}  // namespace fastscene
