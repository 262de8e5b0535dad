// Trains splats on a capture (photographs with cameras from another program) in a run folder: the splat stage on its
// own.
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
// report. A finished run of the same request is left unchanged. Throws as make_scene does.
Json train_capture(const CaptureRequest& request, const RunFolder& folder, const Run& run);

// The request recorded by train_capture; empty for other folders.
struct RecordedCapture {
    CaptureRequest request;
    std::uint64_t seed = 0;
};
std::optional<RecordedCapture> recorded_capture(const RunFolder& folder);

}  // namespace fastscene
