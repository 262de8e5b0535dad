// What a scene will cost on this machine: from finished scenes of the library, else from measured figures.
#pragma once

#include "fastscene/base/json.h"

namespace fastscene::studio {

// [{quality, seconds, gib, measured: how many finished scenes of `scenes` (Library::scenes) say so}]
Json costs(const Json& scenes, int threads);

}  // namespace fastscene::studio
