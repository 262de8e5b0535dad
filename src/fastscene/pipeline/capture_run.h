// A capture (photographs with cameras of another program) becomes splats in a run folder: the splat stage standing on
// its own.
#pragma once

#include <optional>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/splat/splat.h"
#include "fastscene/views/photos.h"

namespace fastscene {

struct CaptureRequest {
    CaptureSource source;
    std::string quality = "standard";
    PhotosParams photos;
    SplatParams splat;
    bool start_over = false;
};

// Writes run.json, splat/{scene.ply,scene.compressed.ply,curve.json} in the capture's own coordinates,
// splat/viewer.compressed.ply (upright and metre-sized) with viewer.html, preview.jpg and report.json; returns the
// report. A finished run of the same request is left as it is. Throws as make_scene does.
Json train_capture(const CaptureRequest& request, const RunFolder& folder, const Run& run);

// The request of a folder that train_capture made; absent when another made it.
struct RecordedCapture {
    CaptureRequest request;
    std::uint64_t seed = 0;
};
std::optional<RecordedCapture> recorded_capture(const RunFolder& folder);

}  // namespace fastscene
