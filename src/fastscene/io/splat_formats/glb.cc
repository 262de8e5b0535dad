#include "fastscene/io/glb.h"

#include "fastscene/io/splat_format.h"
#include "fastscene/io/splat_frames.h"
#include "fastscene/io/splat_io.h"

namespace fastscene::splat_formats {

SplatFormat glb() {
    return {.name = "glb",
            .ending = ".glb",
            .about = "glTF binary with `KHR_gaussian_splatting`",
            .readers = "Cesium, three.js, Khronos' sample viewer",
            .empty = false,
            .file_from_world = kGltfFromWorld,
            .recognizes = is_glb,
            .read = splats_of_glb,
            .write = [](const Splats& splats, const SplatWriting&) { return splat_glb_bytes(splats); }};
}

}  // namespace fastscene::splat_formats
