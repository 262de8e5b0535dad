#include "fastscene/rooms/pack.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/leading_number.h"
#include "fastscene/base/random.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/pack_parts.h"
#include "fastscene/rooms/prompt_text.h"
#include "fastscene/rooms/user_model.h"
#include "fastscene/rooms/user_texture.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

std::string class_of(const std::string& name) {
    std::string kind = folded(name);
    for (char& c : kind)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return kind;
}

using Properties = std::map<std::string, std::string>;

float number(const Properties& p, const std::string& key, float otherwise) {
    const auto at = p.find(key);
    if (at == p.end()) return otherwise;
    const auto value = static_cast<float>(number_in(at->second).value_or(std::nan("")));
    return std::isfinite(value) ? value : otherwise;
}
std::string text(const Properties& p, const std::string& key) {
    const auto at = p.find(key);
    return at == p.end() ? std::string{} : at->second;
}

// Nine numbers, row by row.
std::optional<Mat3f> rotation_from(const std::string& words) {
    if (words.empty()) return {};
    std::string_view rest = words;
    std::array<float, 9> v{};
    for (float& x : v) {
        const auto found = leading_number(rest);
        if (!found) return {};
        x = static_cast<float>(*found);
    }
    return Mat3f{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
}

std::string license_of(const std::string& header) {
    if (header.find("Public domain") != std::string::npos) return "CC0 1.0";
    return header.find("United States") != std::string::npos ? "CC BY 3.0 US" : "CC BY 3.0";
}

std::optional<PackModel> model_from(const Properties& p, const std::string& number_sign, const std::string& pack,
                                    const std::string& license) {
    constexpr float kMetresPerUnit = 0.01f;  // catalogues are in centimetres
    const auto key = [&](const char* name) { return std::string(name) + number_sign; };
    PackModel m;
    m.name = text(p, key("name"));
    m.path = text(p, key("model"));
    m.size_m = Vec3f{number(p, key("width"), 0), number(p, key("height"), 0), number(p, key("depth"), 0)} *
               kMetresPerUnit;
    if (m.name.empty() || m.path.empty() || !(m.size_m.x > 0 && m.size_m.y > 0 && m.size_m.z > 0)) return {};
    if (m.path.front() == '/') m.path.erase(0, 1);
    m.kind = class_of(m.name);
    m.category = text(p, key("category"));
    m.elevation_m = number(p, key("elevation"), 0) * kMetresPerUnit;
    if (const float top = number(p, key("dropOnTopElevation"), -1); top > 0) m.top_m = top * kMetresPerUnit;
    m.rotation = rotation_from(text(p, key("modelRotation")));
    m.opening = text(p, key("doorOrWindow")) == "true" || p.contains(key("staircaseCutOutShape"));
    m.credit = m.name + " by " + text(p, key("creator")) + ", " + pack + " (" + license + ")";
    m.free = license.starts_with("CC0");
    return m;
}

// Whether a term of a prompt is that name, singular or plural.
bool is_named(const std::string& words, const std::string& name) {
    const auto forms = base_forms(words);
    return words == name || std::find(forms.begin(), forms.end(), name) != forms.end();
}

// The names and contents of what is used of a folder.
std::string fingerprint_of(const fs::path& folder, const UserAssets& assets) {
    std::vector<fs::path> files{folder / kAssetsFile};
    for (const UserModel& m : assets.models)
        for (const fs::path& file : files_of_model(folder / m.file)) files.push_back(file);
    for (const UserTexture& t : assets.textures)
        for (const fs::path& file : {t.color, t.normals, t.roughness, t.metal, t.height})
            if (!file.empty()) files.push_back(folder / file);
    for (const UserSky& s : assets.skies) files.push_back(folder / s.file);
    Hash hash;
    for (const fs::path& file : files) try {
            hash.add(file.lexically_relative(folder).generic_string()).add(read_file(file));
        } catch (const Error&) {  // told where it is used
        }
    return hash.hex();
}

}  // namespace

AssetsChoice assets_named(const std::string& text) {
    const auto pack_named = [](std::string_view word) -> std::optional<Assets> {
        if (word == "none") return Assets::none;
        if (word == "cc0") return Assets::cc0;
        if (word == "all") return Assets::all;
        return {};
    };
    AssetsChoice choice;
    if (const auto pack = pack_named(text)) return {*pack, {}};
    const auto comma = text.find(',');
    const auto pack = comma == std::string::npos ? std::nullopt : pack_named(std::string_view(text).substr(0, comma));
    if (pack) choice.pack = *pack;
    choice.folder = pack ? text.substr(comma + 1) : text;
    std::error_code code;
    if (!fs::is_directory(choice.folder, code))
        throw UsageError("--assets: expected none, cc0, all or a folder of models, found \"{}\"", text);
    return choice;
}

std::string absolute_assets(const std::string& text) {
    const AssetsChoice choice = assets_named(text);
    if (choice.folder.empty()) return text;
    const std::string folder = fs::weakly_canonical(choice.folder).string();
    return choice.pack == Assets::none ? "none," + folder : choice.pack == Assets::all ? "all," + folder : folder;
}

fs::path FurniturePack::default_folder() {
    if (const char* place = std::getenv("FASTSCENE_FURNITURE_DIR"); place && *place) return place;
    return "/usr/share/sweethome3d/furniture";
}

void FurniturePack::read_archive(std::size_t archive, bool free_only) {
    const ZipFile& zip = archives_[archive];
    const Properties english = packs::read_properties(zip.read("PluginFurnitureCatalog.properties"));
    const std::string pack = text(english, "name"), license = license_of(text(english, "license"));
    std::map<std::string, std::size_t> model_at;  // "#12" -> index
    for (const auto& [key, value] : english) {
        if (!key.starts_with("name#")) continue;
        auto model = model_from(english, key.substr(4), pack, license);
        if (!model) continue;
        if (free_only && !model->free) {
            if (!model->opening) excluded_.emplace(model->kind, model->credit);
            continue;
        }
        model->archive = archive;
        model_at[key.substr(4)] = models_.size();
        by_class_.emplace(model->kind, models_.size());
        by_name_.emplace(folded(model->name), models_.size());
        models_.push_back(std::move(*model));
    }
    for (const std::string& name : zip.names()) {
        if (!name.starts_with("PluginFurnitureCatalog_") || !name.ends_with(".properties") || model_at.empty())
            continue;
        for (const auto& [key, value] : packs::read_properties(zip.read(name)))
            if (key.starts_with("name#"))
                if (const auto at = model_at.find(key.substr(4)); at != model_at.end())
                    by_name_.emplace(folded(value), at->second);
    }
}

void FurniturePack::open_archives(const fs::path& folder, Assets assets, std::vector<std::string>& complaints,
                                  Hash& hash) {
    const std::string remedy = "install it with: apt-get install --no-install-recommends sweethome3d-furniture";
    std::error_code code;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, code))
        if (entry.path().extension() == ".sh3f") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    if (files.empty()) {
        complaints.push_back("no furniture pack in " + folder.string() + ": only the built-in pieces are used; " +
                             remedy);
        return;
    }
    for (const fs::path& file : files) try {
            archives_.emplace_back(file);
            read_archive(archives_.size() - 1, assets == Assets::cc0);
            hash.add(file.filename().string()).add(std::to_string(fs::file_size(file, code)));
        } catch (const Error& error) {
            complaints.push_back("furniture pack: " + std::string(error.what()) + "; it goes on without this one");
        }
    if (models_.empty() && complaints.empty())
        complaints.push_back("furniture pack: no usable model in " + folder.string() +
                             ": only the built-in pieces are used; " + remedy);
}

// Their sizes are needed before any of them is placed, and what is damaged is better told at once.
void FurniturePack::open_users(const fs::path& folder, std::vector<std::string>& complaints, Hash& hash) {
    users_folder_ = folder;
    users_ = read_user_assets(folder);
    complaints.insert(complaints.end(), users_.complaints.begin(), users_.complaints.end());
    for (std::size_t i = 0; i < users_.models.size(); ++i) try {
            const UserModel& user = users_.models[i];
            const UserPiece made = load_user_model(folder, user, false);
            PackModel m;
            m.kind = user.kind;
            m.name = user.names.front();
            m.path = user.file.generic_string();
            m.size_m = made.piece.size_m;
            m.elevation_m = made.piece.mount == Mount::wall ? std::max(0.5f, made.piece.hang_height_m) : 0.f;
            m.credit = made.piece.source;
            m.user = static_cast<int>(i);
            by_class_.emplace(m.kind, models_.size());
            for (const std::string& name : user.names) by_name_.emplace(name, models_.size());
            models_.push_back(std::move(m));
        } catch (const Error& error) {
            complaints.push_back(std::string(error.what()) + "; it goes on without this model");
        }
    hash.add(fingerprint_of(folder, users_));
}

std::shared_ptr<const FurniturePack> FurniturePack::open(const fs::path& folder, const AssetsChoice& choice,
                                                         std::vector<std::string>& complaints) {
    auto pack = std::make_shared<FurniturePack>();
    Hash hash;
    // Names of the user's come first where the pack has the same.
    if (!choice.folder.empty()) pack->open_users(choice.folder, complaints, hash);
    if (choice.pack != Assets::none) pack->open_archives(folder, choice.pack, complaints, hash);
    if (pack->models_.empty() && choice.folder.empty()) return nullptr;
    pack->fingerprint_ = hash.add(choice.pack == Assets::all ? "all" : "cc0").hex();
    return pack;
}

std::shared_ptr<const FurniturePack> FurniturePack::open(const std::string& assets,
                                                         std::vector<std::string>& complaints) {
    return open(default_folder(), assets_named(assets), complaints);
}

std::optional<std::string> FurniturePack::class_named(const std::string& term) const {
    const auto find = [&](const std::string& name) -> std::optional<std::string> {
        const auto at = by_name_.find(name);
        return at == by_name_.end() ? std::nullopt : std::optional(models_[at->second].kind);
    };
    if (auto found = find(term)) return found;
    for (const Language language : {"", "de", "fr", "es", "it"})
        for (const std::string& form : base_forms(term, language))
            if (auto found = find(form)) return found;
    return {};
}

const PackModel* FurniturePack::choose_users(const std::string& kind, std::uint64_t seed,
                                             const std::string& words) const {
    if (users_.models.empty()) return nullptr;
    std::vector<const PackModel*> found, named;
    const auto [begin, end] = by_class_.equal_range(kind);
    for (auto at = begin; at != end; ++at) {
        const PackModel& model = models_[at->second];
        if (model.user < 0 || !is_sound(model)) continue;
        found.push_back(&model);
        const auto& names = users_.models[static_cast<std::size_t>(model.user)].names;
        if (std::any_of(names.begin(), names.end(), [&](const std::string& name) { return is_named(words, name); }))
            named.push_back(&model);
    }
    const auto& among = named.empty() ? found : named;
    return among.empty() ? nullptr : among[mix64(seed) % among.size()];
}

bool FurniturePack::names_users(const std::string& term) const {
    if (users_.models.empty()) return false;
    // A single word may be a color or a material first ("oak.glb").
    const auto known = term.find(' ') == std::string::npos ? look_up(term) : std::nullopt;
    if (known && known->kind != WordKind::object && known->kind != WordKind::nuance && known->kind != WordKind::other)
        return false;
    for (const UserModel& model : users_.models)
        if (std::any_of(model.names.begin(), model.names.end(),
                        [&](const std::string& n) { return is_named(term, n); }))
            return true;
    return false;
}

const PackModel* FurniturePack::choose(const std::string& kind, std::uint64_t seed) const {
    if (const PackModel* users = choose_users(kind, seed)) return users;
    if (packs::keeps_builder(kind)) return nullptr;
    for (const std::string& name : packs::catalogue_classes(kind)) {
        std::vector<std::size_t> found;
        const auto [begin, end] = by_class_.equal_range(name);
        for (auto at = begin; at != end; ++at)
            if (models_[at->second].user < 0 && packs::fits_a_room(models_[at->second])) found.push_back(at->second);
        std::sort(found.begin(), found.end());
        for (; !found.empty(); found.erase(found.begin() + static_cast<std::ptrdiff_t>(mix64(seed) % found.size())))
            if (const PackModel& model = models_[found[mix64(seed) % found.size()]]; is_sound(model)) return &model;
    }
    return nullptr;
}

std::optional<std::string> FurniturePack::texture_named(const std::string& term) const {
    for (const UserTexture& t : users_.textures)
        for (const std::string& name : t.names)
            if (is_named(term, name)) return t.names.front();
    return {};
}

Material FurniturePack::texture(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    if (const auto known = textures_.find(name); known != textures_.end()) return known->second;
    for (const UserTexture& t : users_.textures)
        if (t.names.front() == name) return textures_[name] = load_user_texture(users_folder_, t);
    throw Error("texture \"{}\": expected a texture of the folder in use (--assets DIR), found none of that name",
                name);
}

std::string FurniturePack::credit_of_texture(const std::string& name) const {
    for (const UserTexture& t : users_.textures)
        if (t.names.front() == name) return credit_of(t.attribution, t.folder);
    return {};
}

const UserSky* FurniturePack::choose_sky(const std::string& time, std::uint64_t seed) const {
    for (const bool of_the_hour : {true, false}) {
        std::vector<const UserSky*> found;
        for (const UserSky& s : users_.skies)
            if (s.time == (of_the_hour ? time : "") && sky(s)) found.push_back(&s);
        if (!found.empty()) return found[mix64(seed) % found.size()];
    }
    return nullptr;
}

std::shared_ptr<const PhotographedSky> FurniturePack::sky(const UserSky& sky) const {
    const std::lock_guard lock(mutex_);
    const auto [entry, is_new] = skies_.try_emplace(&sky);
    if (is_new) try {
            entry->second = std::make_shared<const PhotographedSky>(load_user_sky(users_folder_, sky));
        } catch (const Error& error) {
            damaged_files_.insert(error.what());
        }
    return entry->second;
}

bool FurniturePack::only_with_attribution(const std::string& kind) const {
    const auto classes = packs::catalogue_classes(kind);
    return std::any_of(classes.begin(), classes.end(),
                       [&](const std::string& name) { return excluded_.contains(name); });
}

}  // namespace fastscene
