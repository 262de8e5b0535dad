// Pack: furniture beyond our own. The user's models (user_assets.h) come before those of Debian's sweethome3d-furniture
// (.sh3f files: zip archives of a catalogue with names in many languages, OBJ models and pictures). Both are optional:
// rooms are made without them too.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fastscene/io/zip.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/user_assets.h"
#include "fastscene/rooms/user_sky.h"

namespace fastscene {

class Hash;

enum class Assets : std::uint8_t { none, cc0, all };
// What --assets says: which models of Debian's pack may be used, and the user's own folder (empty: none).
struct AssetsChoice {
    Assets pack = Assets::cc0;
    std::filesystem::path folder;
};
// "none", "cc0", "all"; a folder, used together with cc0; or a word, a comma and a folder: "all,my/models". Throws
// UsageError for anything else.
AssetsChoice assets_named(const std::string& text);
// The same with an absolute folder, as runs record it.
std::string absolute_assets(const std::string& text);

// An entry of a catalogue.
struct PackModel {
    std::string kind;               // "grand_piano"
    std::string name;               // "Grand piano"
    std::string category;           // "Living room"
    std::size_t archive = 0;        // index of its .sh3f
    std::string path;               // of the .obj inside
    Vec3f size_m;                   // x, y (height), z (depth)
    float elevation_m = 0.f;        // of its lower edge above the floor
    std::optional<float> top_m;     // where things are dropped on it
    std::optional<Mat3f> rotation;  // of the model before it is scaled to its size
    bool opening = false;           // doors, windows, stairs: they belong into walls and floors
    std::string credit;             // "Grand piano by Jane Doe, Blend Swap (CC0)": for credits.txt
    bool free = false;              // CC0: nothing has to be named
    int user = -1;                  // index into the user's models; `path` is relative to their folder
};

class FurniturePack {
  public:
    // Where Debian installs it, or $FASTSCENE_FURNITURE_DIR.
    static std::filesystem::path default_folder();

    // Reads the catalogues, Debian's from `folder`; null if nothing is chosen or readable. What is missing or damaged
    // is told in `complaints`.
    static std::shared_ptr<const FurniturePack> open(const std::filesystem::path& folder, const AssetsChoice& choice,
                                                     std::vector<std::string>& complaints);
    // … what --assets says, Debian's from its default folder.
    static std::shared_ptr<const FurniturePack> open(const std::string& assets, std::vector<std::string>& complaints);

    // Whether a folded term names something in the catalogue, in any of its languages; singular or plural. The class:
    // "grand_piano".
    std::optional<std::string> class_named(const std::string& term) const;

    // The model to use for a class of the lexicon or the catalogue: the pack's if it has a good one, and a better one
    // than our own builder of that class, if there is one. `seed` chooses among several. Null: none.
    const PackModel* choose(const std::string& kind, std::uint64_t seed) const;
    // The user's model of a class, preferably the one whose name the words of a prompt say. Null: none.
    const PackModel* choose_users(const std::string& kind, std::uint64_t seed, const std::string& words = {}) const;
    // Whether a folded term is the name of a user's model, and not a color or the like.
    bool names_users(const std::string& term) const;
    // Whether a model exists that `assets` of this pack excluded: "… needs --assets all".
    bool only_with_attribution(const std::string& kind) const;

    // The model as a piece, in its catalogue size, colored as the request wishes. Throws Error for a damaged model.
    Piece piece(const PackModel& model, const PieceRequest& request) const;

    // The user's sky for an hour, of those that show it or else any; null: there is none, or it cannot be read.
    const UserSky* choose_sky(const std::string& time, std::uint64_t seed) const;
    std::shared_ptr<const PhotographedSky> sky(const UserSky& sky) const;

    // Whether a folded term names a texture of the user's; the name by which its material is known.
    std::optional<std::string> texture_named(const std::string& term) const;
    // Throws Error if it cannot be read, or there is none of that name.
    Material texture(const std::string& name) const;
    // "Old tiles by Jane Doe (CC0), old_tiles": for credits.txt; empty for an unknown name.
    std::string credit_of_texture(const std::string& name) const;

    // Models that were chosen and could not be read, each with its reason; choose() takes others in their place.
    std::vector<std::string> damage() const;

    std::size_t size() const { return models_.size(); }
    const std::vector<PackModel>& models() const { return models_; }
    // A few bytes that change when the installed pack or the user's files do: part of the key of the stage's cache.
    const std::string& fingerprint() const { return fingerprint_; }

  private:
    void open_archives(const std::filesystem::path& folder, Assets assets, std::vector<std::string>& complaints,
                       Hash& hash);
    void read_archive(std::size_t archive, bool free_only);
    void open_users(const std::filesystem::path& folder, std::vector<std::string>& complaints, Hash& hash);
    Piece load(const PackModel& model) const;
    std::shared_ptr<const Piece> loaded(const PackModel& model) const;
    bool is_sound(const PackModel& model) const;

    std::filesystem::path users_folder_;
    UserAssets users_;
    std::vector<ZipFile> archives_;
    std::vector<PackModel> models_;
    std::multimap<std::string, std::size_t> by_name_;  // folded, all languages
    std::multimap<std::string, std::size_t> by_class_;
    std::map<std::string, std::string> excluded_;  // class -> credit, of models left out for their license
    std::string fingerprint_;
    mutable std::mutex mutex_;
    mutable std::map<const PackModel*, std::shared_ptr<const Piece>> loaded_;
    mutable std::map<const PackModel*, std::string> damaged_;
    mutable std::set<std::string> damaged_files_;  // skies and textures, by their errors
    mutable std::map<std::string, Material> textures_;
    mutable std::map<const UserSky*, std::shared_ptr<const PhotographedSky>> skies_;
};

// The builder that stands in for a class nobody has a model of ("grand_piano" -> "piano"), if any.
std::optional<std::string> stand_in(const std::string& kind);

}  // namespace fastscene
