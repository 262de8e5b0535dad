#include "fastscene/base/content_identity.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/hash.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kWhole = 16u << 20, kBlock = 16u << 10, kPlaces = 256;

void add_bytes(Hash& hash, std::ifstream& in, const fs::path& file, std::uintmax_t begin, std::uintmax_t count) {
    std::string bytes(count, '\0');
    in.seekg(static_cast<std::streamoff>(begin));
    if (!in.read(bytes.data(), static_cast<std::streamsize>(count))) throw Error("{}: cannot be read", file.string());
    hash.add(bytes);
}

void add_file(Hash& hash, const fs::path& file) {
    const std::uintmax_t size = fs::file_size(file);
    std::ifstream in(file, std::ios::binary);
    hash.add(static_cast<std::uint64_t>(size));
    if (size <= kWhole) return add_bytes(hash, in, file, 0, size);
    for (std::uintmax_t i = 0; i < kPlaces; ++i) add_bytes(hash, in, file, (size - kBlock) / (kPlaces - 1) * i, kBlock);
    add_bytes(hash, in, file, size - kBlock, kBlock);
}

}  // namespace

std::string content_identity(const fs::path& file_or_folder) {
    Hash hash;
    if (!fs::is_directory(file_or_folder)) {
        add_file(hash, file_or_folder);
        return hash.hex();
    }
    std::vector<fs::path> files;
    for (const auto& entry :
         fs::recursive_directory_iterator(file_or_folder, fs::directory_options::follow_directory_symlink))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        hash.add(fs::relative(file, file_or_folder).generic_string());
        add_file(hash, file);
    }
    return hash.hex();
}

}  // namespace fastscene
