#include "fastscene/models/cache.h"

#include <algorithm>
#include <cstdlib>

#include "fastscene/base/check.h"

namespace fastscene {
namespace fs = std::filesystem;

fs::path models_root() {
    if (const char* own = std::getenv("FASTSCENE_MODELS"); own && *own) return own;
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return fs::path(cache) / "fastscene/models";
    const char* home = std::getenv("HOME");
    return fs::path(home && *home ? home : ".") / ".cache/fastscene/models";
}

std::optional<fs::path> file_in_cache(const Model& model, const ModelFile& file, const fs::path& root) {
    for (const std::string& name : file.names()) {
        const fs::path path = root / model.folder / name;
        std::error_code code;
        if (!fs::is_regular_file(path, code)) continue;
        const auto size = fs::file_size(path, code);
        if (!code && size > 0 && (file.bytes == 0 || static_cast<std::int64_t>(size) == file.bytes)) return path;
    }
    return std::nullopt;
}

bool is_in_cache(const Model& model, const fs::path& root) {
    return std::all_of(model.files.begin(), model.files.end(),
                       [&](const ModelFile& file) { return file_in_cache(model, file, root).has_value(); });
}

std::optional<fs::path> cached_model(std::string_view name) {
    const Model& model = model_named(name);
    return is_in_cache(model) ? std::optional(models_root() / model.folder) : std::nullopt;
}

std::optional<fs::path> cached_file(std::string_view name) {
    const Model& model = model_named(name);
    FASTSCENE_CHECK_EQ(model.files.size(), 1u);
    return file_in_cache(model, model.files[0]);
}

}  // namespace fastscene
