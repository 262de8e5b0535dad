// Pack: furniture beyond our own, read from Debian's sweethome3d-furniture (.sh3f files: zip archives of a catalogue
// with names in many languages, OBJ models and pictures). Optional: rooms are made without it too.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/io/zip.h"
#include "fastscene/rooms/furniture.h"

namespace fastscene {

enum class Assets : std::uint8_t { none, cc0, all };
// "none", "cc0" or "all".
Assets assets_named(const std::string& name);

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
};

class FurniturePack {
  public:
    // Where Debian installs it, or $FASTSCENE_FURNITURE_DIR.
    static std::filesystem::path default_folder();

    // Reads the catalogues; null with Assets::none or without any readable archive. What is missing or damaged is told
    // in `complaints`.
    static std::shared_ptr<const FurniturePack> open(const std::filesystem::path& folder, Assets assets,
                                                     std::vector<std::string>& complaints);

    // Whether a folded term names something in the catalogue, in any of its languages; singular or plural. The class:
    // "grand_piano".
    std::optional<std::string> class_named(const std::string& term) const;

    // The model to use for a class of the lexicon or the catalogue: the pack's if it has a good one, and a better one
    // than our own builder of that class, if there is one. `seed` chooses among several. Null: none.
    const PackModel* choose(const std::string& kind, std::uint64_t seed) const;
    // Whether a model exists that `assets` of this pack excluded: "… needs --assets all".
    bool only_with_attribution(const std::string& kind) const;

    // The model as a piece, in its catalogue size, colored as the request wishes. Throws Error for a damaged model.
    Piece piece(const PackModel& model, const PieceRequest& request) const;

    // Models that were chosen and could not be read, each with its reason; choose() takes others in their place.
    std::vector<std::string> damage() const;

    std::size_t size() const { return models_.size(); }
    const std::vector<PackModel>& models() const { return models_; }
    // A few bytes that change when the installed pack does: part of the key of the stage's cache.
    const std::string& fingerprint() const { return fingerprint_; }

  private:
    void read_archive(std::size_t archive, bool free_only);
    std::shared_ptr<const Piece> loaded(const PackModel& model) const;
    bool is_sound(const PackModel& model) const;

    std::vector<ZipFile> archives_;
    std::vector<PackModel> models_;
    std::multimap<std::string, std::size_t> by_name_;  // folded, all languages
    std::multimap<std::string, std::size_t> by_class_;
    std::map<std::string, std::string> excluded_;  // class -> credit, of models left out for their license
    std::string fingerprint_;
    mutable std::mutex mutex_;
    mutable std::map<const PackModel*, std::shared_ptr<const Piece>> loaded_;
    mutable std::map<const PackModel*, std::string> damaged_;
};

// The builder that stands in for a class nobody has a model of ("grand_piano" -> "piano"), if any.
std::optional<std::string> stand_in(const std::string& kind);

}  // namespace fastscene
