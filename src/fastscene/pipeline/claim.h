// A folder belongs to one run, identified by source and seed.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {

// Writes run.json. Throws UsageError if the folder holds another run, or files with our names that do not belong to a
// run; `start_over` removes those instead. `clash` describes the recorded run's source if it differs from the wanted
// one's; `described` always does.
void claim_folder(const RunFolder& folder, const Json& wanted, bool start_over,
                  const std::function<std::optional<std::string>(const Json& recorded)>& clash,
                  const std::string& described);

}  // namespace fastscene
