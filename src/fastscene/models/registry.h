// Registry of third-party model files: URL, size, hash and licence. Sizes and hashes were determined from the original
// locations; what could not be is marked as unknown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

struct ModelFile {
    std::string name;        // relative to the model's folder; alternatives separated by '|', tried in order
    std::int64_t bytes = 0;  // 0: unknown
    std::string sha256;      // 64 digits; empty: unknown, recorded on first pull
    std::string url = {};    // empty: the model's base URL plus the name

    std::vector<std::string> names() const;  // the alternatives
};

struct Model {
    std::string name;
    std::string folder;   // relative to the cache; related models share a folder
    std::string what;     // one-sentence description
    std::string use;      // the command that uses it
    std::string licence;  // licence name and owner
    std::string licence_url;
    std::string home;  // web page
    std::string base;  // URL prefix of the files; empty: not downloadable, must be fetched by hand from `home`
    std::vector<ModelFile> files;

    bool by_hand() const { return base.empty(); }
    std::int64_t known_bytes() const;  // sum of the known sizes
};

// URLs of the file's alternatives, in order; empty if it must be fetched by hand.
std::vector<std::string> urls_of(const Model& model, const ModelFile& file);

const std::vector<Model>& models();
// Throws UsageError listing the available names.
const Model& model_named(std::string_view name);

}  // namespace fastscene
