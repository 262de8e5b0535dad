#include "fastscene/io/picture_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "fastscene/io/image_io.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}
std::string without_ending(const std::string& name) {
    return (fs::path(name).parent_path() / fs::path(name).stem()).generic_string();
}

}  // namespace

std::string with_slashes(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

void PictureFolder::look() {
    constexpr std::size_t kMost = 1000000;  // files looked at: a whole disk would take minutes
    looked_ = true;
    std::error_code code;
    std::size_t seen = 0;
    fs::recursive_directory_iterator at(root_, fs::directory_options::skip_permission_denied, code), end;
    for (; !code && at != end && seen < kMost; at.increment(code), ++seen) {
        if (!has_picture_ending(at->path()) || !at->is_regular_file(code)) continue;
        const std::string name = lower(at->path().lexically_relative(root_).generic_string());
        by_name_[name].push_back(at->path());
        by_stem_[without_ending(name)].push_back(at->path());
        const std::string label = lower(at->path().filename().string());
        by_label_[label].push_back(at->path());
        by_label_[without_ending(label)].push_back(at->path());
    }
}

fs::path PictureFolder::similar_to(const std::string& name) {
    if (!looked_) look();
    const std::string wanted = lower(fs::path(with_slashes(name)).lexically_normal().generic_string());
    if (const auto same = by_name_.find(wanted); same != by_name_.end())
        return same->second.size() == 1 ? same->second.front() : fs::path();
    const auto stem = by_stem_.find(without_ending(wanted));
    return stem != by_stem_.end() && stem->second.size() == 1 ? stem->second.front() : fs::path();
}

fs::path PictureFolder::labelled(const std::string& label) {
    if (!looked_) look();
    if (const fs::path whole = similar_to(label); !whole.empty()) return whole;
    const std::string name = lower(fs::path(with_slashes(label)).filename().string());
    for (const std::string& wanted : {name, without_ending(name)})
        if (const auto found = by_label_.find(wanted); found != by_label_.end() && found->second.size() == 1)
            return found->second.front();
    return {};
}

void RenamedPictures::add(const std::string& in_model, const fs::path& on_disk) {
    if (count++ == 0) name = in_model, file = on_disk.string();
}

std::optional<std::string> RenamedPictures::warning(const std::string& source, std::size_t of) const {
    if (count == 0) return {};
    return fmt::format(
        "{}: {} of {} pictures have another letter case or ending on disk than in the model: {} is taken "
        "for {}",
        source, count, of, file, name);
}

}  // namespace fastscene
