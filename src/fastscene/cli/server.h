// The small web server of `fastscene view`.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "fastscene/pipeline/run_folder.h"

namespace fastscene::cli {

// Serves the run's viewer.html on 127.0.0.1 until `stop`; calls `ready` with the URL once it listens. Where the splats
// are newer than viewer.html, or there is none, serves them with the page in the viewer's folder. Throws Error if the
// port is in use.
void serve_scene(const RunFolder& folder, const std::optional<std::filesystem::path>& viewer_dir, int port,
                 std::stop_token stop, const std::function<void(const std::string& address)>& ready);

}  // namespace fastscene::cli
