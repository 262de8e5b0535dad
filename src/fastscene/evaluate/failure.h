// One scene's failure is its own: the others go on, whatever it was.
#pragma once

#include <string>

#include "fastscene/base/check.h"
#include "fastscene/nn/runtime.h"

namespace fastscene {

// Why a scene failed, for its line below the tables. Not for Stopped, which ends the whole.
inline std::string failure_text(const std::exception& e) {
    if (dynamic_cast<const CheckFailed*>(&e)) return std::string("a mistake of ours, please report it: ") + e.what();
    return is_lack_of_memory(e) ? "not enough memory for this scene" : short_message(e);
}

}  // namespace fastscene
