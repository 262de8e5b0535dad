#include "fastscene/panorama/dataset_parts.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene::dataset {

int nyu40_of(const std::string& kind) { return nyu40_label(kind); }

Json nyu40_names() {
    Json names = Json::array();
    for (const std::string_view name : nyu40_labels()) names.push_back(std::string(name));
    return names;
}

}  // namespace fastscene::dataset
