#include "fastscene/panorama/kept_pictures.h"

#include <chrono>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/json.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// Damaged or incomplete files are made again.
std::optional<KeptPicture> kept(const fs::path& picture, const fs::path& about, const std::string& key) {
    if (!fs::exists(about) || !fs::exists(picture)) return std::nullopt;
    try {
        const Json json = read_json(about);
        if (json.at("key") != key || json.at("hash") != Hash().add(read_file(picture)).hex()) return std::nullopt;
        return KeptPicture{load_rgb8(picture), json.at("seconds"), true};
    } catch (const Json::exception&) {
        return std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

KeptPicture KeptPictures::get(const std::string& name, const std::string& key,
                              const std::function<ImageRgb8()>& make) const {
    const fs::path file = file_of(name), about = folder_ / (name + ".json");
    if (!folder_.empty())
        if (auto found = kept(file, about, key)) return std::move(*found);
    const auto begin = std::chrono::steady_clock::now();
    KeptPicture made{make(), 0, false};
    made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (folder_.empty()) return made;
    make_directories(folder_);
    save_png(file, made.picture);
    write_json(about, {{"key", key}, {"hash", Hash().add(read_file(file)).hex()}, {"seconds", made.seconds}});
    return made;
}

}  // namespace fastscene
