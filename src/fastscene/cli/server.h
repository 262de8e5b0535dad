// The small web server behind `fastscene view`.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "fastscene/pipeline/run_folder.h"

namespace fastscene::cli {

// Serves the viewer's page with the run's splats on 127.0.0.1 until `stop`; calls `ready` with the address once it
// listens. Without a viewer folder the run's own viewer.html is served. Throws Error when the port is taken.
void serve_scene(const RunFolder& folder, const std::optional<std::filesystem::path>& viewer_dir, int port,
                 std::stop_token stop, const std::function<void(const std::string& address)>& ready);

}  // namespace fastscene::cli
