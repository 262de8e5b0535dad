#include "fastscene/base/error.h"
#include "fastscene/base/registry.h"
#include "fastscene/io/capture_io.h"

namespace fastscene {

const std::vector<CaptureKind>& capture_kinds() {
    static const std::vector<CaptureKind> kinds{
        {"colmap", "DIR", "Folder with images/ and COLMAP's model (text or binary) in sparse/0 or sparse.",
         load_colmap_capture},
        {"nerfstudio", "FILE", "transforms.json of nerfstudio or NeRF, or the folder that contains it.",
         load_nerfstudio_capture},
        {"realityscan", "FILE",
         "RealityScan's or RealityCapture's CSV of cameras (Internal/External camera parameters).",
         load_realityscan_capture},
        {"metashape", "FILE", "Metashape's cameras as XML (Export Cameras).", load_metashape_capture},
        {"polycam", "DIR", "Polycam's raw data: the folder with keyframes/.", load_polycam_capture}};
    return kinds;
}

const CaptureKind& capture_kind(const std::string& name) {
    for (const CaptureKind& kind : capture_kinds())
        if (kind.name == name) return kind;
    std::vector<std::string> names;
    for (const CaptureKind& kind : capture_kinds()) names.emplace_back(kind.name);
    throw Error("expected photographs of the kind {}, found \"{}\"", any_of(names), name);
}

}  // namespace fastscene
