#include "fastscene/evaluate/parameters.h"

#include "fastscene/base/content_identity.h"
#include "fastscene/base/hash.h"
#include "fastscene/metrics/images.h"

namespace fastscene {

namespace fs = std::filesystem;

ParameterFiles parameters_of(const fs::path& weights, const std::string& image_measure) {
    ParameterFiles out{measure_files(weights, image_measure), ""};
    if (out.files.empty()) return out;
    Hash hash;
    for (const fs::path& file : out.files) hash.add(content_identity(file));
    out.identity = hash.hex();
    return out;
}

}  // namespace fastscene
