#include "fastscene/models/trust.h"

#include <algorithm>
#include <cctype>

#include "fastscene/base/error.h"
#include "fastscene/models/sha256.h"

namespace fastscene {
namespace fs = std::filesystem;

std::string check_trusted(const fs::path& file, const std::vector<std::string>& trusted) {
    const std::string hash = sha256_of_file(file);
    for (std::string word : trusted) {
        std::error_code absent;
        if (fs::equivalent(word, file, absent)) return hash;
        std::transform(word.begin(), word.end(), word.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (word == hash) return hash;
    }
    throw UsageError(
        "{}: TorchScript is a program that can read files of this machine, and runs only if you trust it: "
        "expected --trust {} or --trust {} (its SHA-256), found {}",
        file.string(), file.string(), hash, trusted.empty() ? "neither" : "others");
}

}  // namespace fastscene
