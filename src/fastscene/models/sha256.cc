#include "fastscene/models/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/base/error.h"

namespace fastscene {

std::string sha256_of_file(const std::filesystem::path& file, const std::function<void(std::size_t)>& heard) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error("{}: cannot be read", file.string());
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    FASTSCENE_CHECK(context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1);
    std::vector<char> buffer(1 << 20);
    for (std::size_t done = 0; in;) {
        in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        const auto got = static_cast<std::size_t>(in.gcount());
        FASTSCENE_CHECK(EVP_DigestUpdate(context.get(), buffer.data(), got) == 1);
        if (heard) heard(done += got);
    }
    if (in.bad()) throw Error("{}: cannot be read", file.string());
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    FASTSCENE_CHECK(EVP_DigestFinal_ex(context.get(), digest.data(), &size) == 1);
    std::string text;
    for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
    return text;
}

}  // namespace fastscene
