// A folder belongs to one run: its source and its seed.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {

// Writes run.json. Throws UsageError when the folder holds another run, or files under our names that no run made; with
// `start_over` those are removed instead. `clash` says what the recorded run is a run of, where it is another than the
// wanted one; `described` says the same of that.
void claim_folder(const RunFolder& folder, const Json& wanted, bool start_over,
                  const std::function<std::optional<std::string>(const Json& recorded)>& clash,
                  const std::string& described);

}  // namespace fastscene
