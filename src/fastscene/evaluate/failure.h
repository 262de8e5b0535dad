// A scene's failure is isolated: the others continue.
#pragma once

#include <string>

#include "fastscene/base/check.h"
#include "fastscene/base/failure.h"

namespace fastscene {

// Why a scene failed, for the line below the table. Not for Stopped, which ends the evaluation.
inline std::string failure_text(const std::exception& e) {
    if (dynamic_cast<const CheckFailed*>(&e)) return std::string("internal error, please report it: ") + e.what();
    return is_lack_of_memory(e) ? "not enough memory for this scene" : short_message(e);
}

}  // namespace fastscene
