#include "fastscene/pipeline/source_files.h"

#include "fastscene/base/file.h"
#include "fastscene/panorama/panorama.h"

namespace fastscene {
namespace fs = std::filesystem;

const std::string& SourceFiles::bytes(const fs::path& file) {
    const auto [entry, is_new] = bytes_.try_emplace(file);
    if (is_new) try {
            entry->second = read_file(file);
        } catch (...) {
            bytes_.erase(entry);
            throw;
        }
    return entry->second;
}

const PictureFile& SourceFiles::picture(const fs::path& file) {
    const auto found = pictures_.find(file);
    if (found != pictures_.end()) return found->second;
    const PictureFile& picture = pictures_.emplace(file, picture_file_from(bytes(file), file)).first->second;
    sizes_[file] = picture.size();
    return picture;
}

EquirectSize SourceFiles::size(const fs::path& file) {
    const auto found = sizes_.find(file);
    return found != sizes_.end() ? found->second : sizes_[file] = panorama_size(file);
}

PictureFile SourceFiles::take(const fs::path& file) {
    picture(file);
    return std::move(pictures_.extract(file).mapped());
}

}  // namespace fastscene
