#include "fastscene/io/spz.h"

#include "fastscene/io/splat_format.h"
#include "fastscene/io/splat_frames.h"
#include "fastscene/io/splat_io.h"

namespace fastscene::splat_formats {

SplatFormat spz() {
    return {.name = "spz",
            .ending = ".spz",
            .about = "Niantic's SPZ; version 3 (gzip) by default, `--spz-version 2` or `4` (zstd)",
            .readers = "Scaniverse, Babylon, Cesium, three.js",
            .low_pass = false,
            .precision = {.mean_m = 1.3e-4f,
                          .log_scale = 0.0313f,
                          .rotation = 0.006f,
                          .opacity_logit = 0.05f,
                          .sh0 = 0.0132f,
                          .sh_rest = 0.068f},
            .file_from_world = kSpzFromWorld,
            .recognizes = is_spz,
            .read = splats_of_spz,
            .write = [](const Splats& splats, const SplatWriting& writing) {
                return spz_bytes(splats, writing.spz_version);
            }};
}

}  // namespace fastscene::splat_formats
