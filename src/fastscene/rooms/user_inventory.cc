#include "fastscene/rooms/user_inventory.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/user_model.h"
#include "fastscene/rooms/user_sky.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

void look_at(const fs::path& folder, const UserModel& model, InventoryItem& item) {
    item.kind = model.kind;
    const UserPiece piece = load_user_model(folder, model);
    item.size_m = piece.piece.size_m, item.triangles = piece.triangles;
    item.credit = piece.piece.source;
    item.notes = piece.notes;
    if (piece.attribution.license.empty()) item.notes.push_back("no licence is stated: credits.txt says so");
    constexpr std::size_t kMany = 300'000;
    if (piece.triangles > kMany)
        item.notes.push_back(fmt::format("{} triangles: fewer than {} would do in a room", piece.triangles, kMany));
}
void look_at(const fs::path& folder, const UserTexture& texture, InventoryItem& item) {
    item.credit = credit_of(texture.attribution, texture.folder);
    for (const fs::path& file : {texture.color, texture.normals, texture.roughness, texture.metal, texture.height})
        if (!file.empty()) picture_info(folder / file);
}
void look_at(const fs::path& folder, const UserSky& sky, InventoryItem& item) {
    item.credit = credit_of(sky.attribution, sky.file);
    const PhotographedSky read = load_user_sky(folder, sky);
    if (max_component(read.sun_irradiance) == 0) item.notes.push_back("no sun stands out: the light is even");
}

template <class Asset>
InventoryItem item_of(const fs::path& folder, const char* what, const fs::path& file, const Asset& asset) {
    InventoryItem item;
    item.what = what, item.file = file, item.names = asset.names;
    try {
        look_at(folder, asset, item);
    } catch (const Error& error) {
        item.error = error.what();
    }
    return item;
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c == '\n' || c == '\t' ? ' ' : c;
    }
    return out + "\"";
}

std::string row_of(const fs::path& file, const NewModel& m) {
    std::string row = fmt::format("\n[[model]]\nfile = {}\n", quoted(file.generic_string()));
    const auto text = [&](const char* key, const std::string& value) {
        if (!value.empty()) row += fmt::format("{} = {}\n", key, quoted(value));
    };
    text("class", m.kind);
    if (!m.names.empty()) {
        std::vector<std::string> names;
        for (const std::string& name : m.names) names.push_back(quoted(name));
        row += fmt::format("names = [{}]\n", fmt::join(names, ", "));
    }
    for (const auto& [key, value] :
         {std::pair{"width_m", m.size_m.x}, {"height_m", m.size_m.y}, {"depth_m", m.size_m.z}})
        if (value != 0) row += fmt::format("{} = {}\n", key, value);
    text("up", m.up), text("front", m.front);
    text("title", m.attribution.title), text("author", m.attribution.author);
    text("licence", m.attribution.license), text("source", m.attribution.source);
    return row;
}

}  // namespace

std::size_t Inventory::refused() const {
    return complaints.size() +
           static_cast<std::size_t>(
               std::count_if(items.begin(), items.end(), [](const InventoryItem& i) { return !i.error.empty(); }));
}

Inventory take_inventory(const fs::path& folder, const Run& run) {
    const UserAssets assets = read_user_assets(folder);
    Inventory out;
    out.folder = folder;
    out.complaints = assets.complaints;
    Progress progress(run, "assets",
                      static_cast<std::int64_t>(assets.models.size() + assets.textures.size() + assets.skies.size()));
    const auto take = [&](const char* what, const fs::path& file, const auto& asset) {
        run.check_stop();
        out.items.push_back(item_of(folder, what, file, asset));
        progress.advance();
    };
    for (const UserModel& m : assets.models) take("model", m.file, m);
    for (const UserTexture& t : assets.textures) take("texture", t.folder, t);
    for (const UserSky& s : assets.skies) take("sky", s.file, s);
    return out;
}

std::string text_of(const Inventory& inventory, bool with_notes) {
    std::string text;
    for (const std::string& complaint : inventory.complaints) text += "refused  " + complaint + "\n";
    for (const InventoryItem& i : inventory.items) {
        if (!i.error.empty()) {
            text += fmt::format("refused  {}\n", i.error);
            continue;
        }
        text += fmt::format("{:<8} {}", i.what, i.file.generic_string());
        if (i.what == "model")
            text += fmt::format(": {}, {:.2f} x {:.2f} x {:.2f} m, {} triangles", i.kind, i.size_m.x, i.size_m.y,
                                i.size_m.z, i.triangles);
        text += fmt::format("\n         \"{}\"; {}\n", fmt::join(i.names, "\", \""), i.credit);
        if (with_notes)
            for (const std::string& note : i.notes) text += "         note: " + note + "\n";
    }
    if (text.empty()) text = fmt::format("nothing in {}\n", inventory.folder.string());
    text.pop_back();
    return text;
}

Json json_of(const Inventory& inventory) {
    Json items = Json::array();
    for (const InventoryItem& i : inventory.items) {
        Json item{{"what", i.what},
                  {"file", i.file.generic_string()},
                  {"names", i.names},
                  {"notes", i.notes},
                  {"usable", i.error.empty()}};
        if (!i.error.empty()) item["error"] = i.error;
        else item["credit"] = i.credit;
        if (i.what == "model" && i.error.empty())
            item.update(
                {{"class", i.kind}, {"size_m", {i.size_m.x, i.size_m.y, i.size_m.z}}, {"triangles", i.triangles}});
        items.push_back(std::move(item));
    }
    return {{"folder", inventory.folder.string()}, {"items", items}, {"complaints", inventory.complaints}};
}

Inventory add_model(const fs::path& folder, const fs::path& file, const NewModel& model, const Run& run) {
    if (!fs::exists(file)) throw Error("{}: expected a model, found nothing", file.string());
    const fs::path name = file.filename(), to = folder / name;
    if (fs::exists(to)) throw UsageError("{}: there is a file of this name already", to.string());
    make_directories(folder);
    // Tried in a folder of its own, in which it would stand as it will in the end.
    const fs::path trial = folder / (".adding-" + name.stem().string());
    fs::remove_all(trial);
    make_directories(trial);
    try {
        for (const fs::path& one : files_of_model(file)) {
            const fs::path beside = one.lexically_relative(file.parent_path());
            make_directories((trial / beside).parent_path());
            write_file(trial / beside, read_file(one));
        }
        write_file(trial / kAssetsFile, row_of(name, model));
        Inventory tried = take_inventory(trial, run);
        if (!tried.complaints.empty()) throw Error("{}", tried.complaints.front());
        for (const InventoryItem& item : tried.items)
            if (!item.error.empty()) throw Error("{}", item.error);
        const fs::path rows = folder / kAssetsFile;
        const std::string before = fs::exists(rows) ? read_file(rows) : std::string();
        fs::remove(trial / kAssetsFile);
        for (const fs::path& one : files_of_model(file)) {
            const fs::path beside = one.lexically_relative(file.parent_path());
            make_directories((folder / beside).parent_path());
            fs::rename(trial / beside, folder / beside);
        }
        write_file(rows, before + row_of(name, model));
        fs::remove_all(trial);
        tried.folder = folder;
        return tried;
    } catch (...) {
        fs::remove_all(trial);
        throw;
    }
}

}  // namespace fastscene
