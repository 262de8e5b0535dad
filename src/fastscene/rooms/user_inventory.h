// What a folder of the user's own holds, opened and judged: `fastscene assets`.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/rooms/user_assets.h"

namespace fastscene {

struct InventoryItem {
    std::string what;  // "model", "texture", "sky"
    std::filesystem::path file;
    std::string kind;                // of a model
    std::vector<std::string> names;  // what prompts call it
    Vec3f size_m{};                  // of a model
    std::size_t triangles = 0;
    std::string credit;
    std::vector<std::string> notes;
    std::string error;  // why it cannot be used; empty: it can
};
struct Inventory {
    std::filesystem::path folder;
    std::vector<InventoryItem> items;
    std::vector<std::string> complaints;  // of rows that are wrong
    std::size_t refused() const;
};

Inventory take_inventory(const std::filesystem::path& folder, const Run& run);
std::string text_of(const Inventory& inventory, bool with_notes = false);
Json json_of(const Inventory& inventory);

// A row to be written.
struct NewModel {
    std::string kind, up, front;  // empty: from the file's name; y; z
    std::vector<std::string> names;
    Vec3f size_m{};  // 0: not said
    Attribution attribution;
};
// Copies a model, with the files beside it that a .gltf or .obj names, into `folder` and appends its row to
// assets.toml. Nothing is written unless it can be used. Throws Error for what cannot, and UsageError for a file that
// is there already.
Inventory add_model(const std::filesystem::path& folder, const std::filesystem::path& file, const NewModel& model,
                    const Run& run);

}  // namespace fastscene
