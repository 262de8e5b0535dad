#include "fastscene/base/json.h"

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {

Json read_json(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& e) {
        if (text.starts_with("version https://git-lfs"))
            throw Error(
                "{}: expected JSON, found a pointer of Git LFS: fetch the file itself (git lfs pull, or download it)",
                path.string());
        throw Error("{}: not valid JSON at byte {}", path.string(), e.byte);
    } catch (const Json::out_of_range&) {
        throw Error("{}: expected numbers that a computer can hold, found one far too large (1e400)", path.string());
    }
}

void write_json(const std::filesystem::path& path, const Json& value) {
    write_file(path, value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace fastscene
