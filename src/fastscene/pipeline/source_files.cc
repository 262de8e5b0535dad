#include "fastscene/pipeline/source_files.h"

#include "fastscene/base/file.h"
#include "fastscene/panorama/panorama.h"

namespace fastscene {
namespace fs = std::filesystem;

const std::string& SourceFiles::bytes(const fs::path& file) {
    const auto [entry, is_new] = bytes_.try_emplace(file);
    if (is_new) try {
            if (fs::is_directory(file))
                for (const fs::path& face : cube_face_files(file)) entry->second += read_file(face);
            else entry->second = read_file(file);
        } catch (...) {
            bytes_.erase(entry);
            throw;
        }
    return entry->second;
}

const PictureFile& SourceFiles::picture(const fs::path& file) {
    const auto found = pictures_.find(file);
    if (found != pictures_.end()) return found->second;
    const PictureFile& picture = pictures_
                                     .emplace(file, fs::is_directory(file)
                                                        ? picture_file_of_faces(file)
                                                        : picture_file_from(bytes(file), file, layout_))
                                     .first->second;
    sizes_[file] = picture.size();
    return picture;
}

EquirectSize SourceFiles::size(const fs::path& file) {
    const auto found = sizes_.find(file);
    return found != sizes_.end() ? found->second : picture(file).size();
}

PictureFile SourceFiles::take(const fs::path& file) {
    picture(file);
    return std::move(pictures_.extract(file).mapped());
}

}  // namespace fastscene
