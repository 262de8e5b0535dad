#include "fastscene/studio/uploads.h"

#include <algorithm>
#include <fstream>

#include "fastscene/base/content_identity.h"
#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/picture_check.h"
#include "fastscene/panorama/picture_file.h"
#include "fastscene/studio/refusal.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kIdLength = 20;
constexpr std::size_t kLongestShownName = 120;

// The ending says nothing about the content, but later readers choose by it.
std::string ending_of(const std::string& name) {
    std::string ending = fs::path(name).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const bool plain = ending.size() >= 2 && ending.size() <= 6 &&
                       std::all_of(ending.begin() + 1, ending.end(),
                                   [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); });
    return plain ? ending : "";
}

struct TemporaryFile {
    fs::path path;
    ~TemporaryFile() {
        std::error_code none;
        fs::remove(path, none);
    }
};

// Errors name the file as the user knows it.
template <class Look>
Json looked_at(const fs::path& file, const std::string& name, const Look& look) {
    try {
        return look();
    } catch (const Error& e) {
        std::error_code none;
        fs::remove(file, none);
        throw Refusal(422, "{}", e.what());
    } catch (const std::bad_alloc&) {
        throw Refusal(422, "{}: too large for this machine's memory", name);
    }
}

}  // namespace

fs::path Uploads::receive(const std::string& name, const std::function<bool(const Put&)>& read) const {
    const fs::path folder = library_.own("uploads");
    TemporaryFile part{folder / fmt::format(".{}.part", fmt::ptr(&read))};
    std::int64_t bytes = 0;
    bool too_large = false;
    {
        std::ofstream out(part.path, std::ios::binary);
        const bool complete = read([&](std::string_view piece) {
            bytes += static_cast<std::int64_t>(piece.size());
            too_large = bytes > kMostUploadBytes;
            if (!too_large) out.write(piece.data(), static_cast<std::streamsize>(piece.size()));
            return !too_large && out.good();
        });
        if (too_large)
            throw Refusal(413, "{}: larger than {} MB: make the picture smaller", name, kMostUploadBytes >> 20);
        out.flush();
        if (!out.good()) throw Error("{}: cannot be written: is the disk full?", part.path.string());
        if (!complete || bytes == 0) throw Refusal(400, "{}: the upload is incomplete", name);
    }
    const fs::path file = folder / (content_identity(part.path).substr(0, kIdLength) + ending_of(name));
    fs::rename(part.path, file);
    return file;
}

Json Uploads::panorama(const std::string& given, const std::function<bool(const Put&)>& read) {
    const std::string name = given.substr(0, kLongestShownName);
    const fs::path file = receive(name, read);
    return looked_at(file, name, [&] {
        const PictureFile picture = picture_file_from(read_file(file), name);
        Json warnings = Json::array();
        for (const std::string& remark : picture.remarks) warnings.push_back(remark);
        for (const std::string& doubt : doubts_about_panorama(picture.color())) warnings.push_back(doubt);
        return Json{{"id", file.filename().string()},
                    {"name", name},
                    {"width", picture.size().width},
                    {"height", picture.size().height},
                    {"warnings", warnings}};
    });
}

Json Uploads::range_map(const std::string& given, const std::function<bool(const Put&)>& read) {
    const std::string name = given.substr(0, kLongestShownName);
    const fs::path file = receive(name, read);
    return looked_at(file, name, [&] {
        const ImageF range = load_float(file);
        return Json{{"id", file.filename().string()}, {"name", name}, {"width", range.width}, {"height", range.height}};
    });
}

fs::path Uploads::file(const std::string& id) const {
    const bool plain = is_scene_name(id) && fs::is_regular_file(fs::symlink_status(library_.own("uploads") / id));
    if (!plain) throw Refusal(404, "there is no uploaded file \"{}\": drop it into the page again", id);
    return library_.own("uploads") / id;
}

}  // namespace fastscene::studio
