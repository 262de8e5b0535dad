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
            .offset = true,
            .file_from_world = kGltfFromWorld,
            .recognizes = is_glb,
            .read = splats_of_glb,
            .write = [](const Splats& splats, const SplatWriting& writing) {
                return splat_glb_bytes(splats, writing.offset_m);
            }};
}

}  // namespace fastscene::splat_formats
