// The files of others that this program can use, as far as they are known: where they are, how large, what they must
// hash to, and under which licence. Sizes and hashes were read at the places themselves; what could not be read there
// is not known, and said so.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

struct ModelFile {
    std::string name;        // below the model's folder; alternatives joined with '|': the first one that its home has
    std::int64_t bytes = 0;  // 0: not known
    std::string sha256;      // 64 digits; empty: not known, the first pull records it
    std::string url = {};    // empty: the model's base and the name

    std::vector<std::string> names() const;  // the alternatives
};

struct Model {
    std::string name;
    std::string folder;   // below the cache; models that go together share one
    std::string what;     // a sentence
    std::string use;      // the command that looks for it
    std::string licence;  // its name, and whose it is
    std::string licence_url;
    std::string home;  // a page for people
    std::string base;  // before each file's name; empty: no address to pull from, the file is fetched by hand at home
    std::vector<ModelFile> files;

    bool by_hand() const { return base.empty(); }
    std::int64_t known_bytes() const;  // the sum of the sizes that are known
};

// Where the file's alternatives are, in their order; empty when it is fetched by hand.
std::vector<std::string> urls_of(const Model& model, const ModelFile& file);

const std::vector<Model>& models();
// Throws UsageError with the names there are.
const Model& model_named(std::string_view name);

}  // namespace fastscene
