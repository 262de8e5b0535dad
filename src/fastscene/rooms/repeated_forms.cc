#include "fastscene/rooms/repeated_forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "fastscene/base/hash.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/furniture/wall/framed_art.h"

namespace fastscene {
namespace {

constexpr float kLeastHigh = 0.01f;  // metres
constexpr float kAlike = 1000;       // per metre, and per unit of color: differences below 1 mm and 1/1000 are not seen

void add_rounded(Hash& hash, Vec3f v) {
    for (std::size_t a = 0; a < 3; ++a) hash.add(static_cast<std::int32_t>(std::lround(v[a] * kAlike)));
}

// What one sees of a material, but for the random course of its grain.
void add_look(Hash& hash, const Material& m) {
    hash.add(static_cast<int>(m.pattern)).add(static_cast<int>(m.variant)).add(m.image.get() != nullptr);
    if (m.image) hash.add(reinterpret_cast<std::uintptr_t>(m.image.get()));
    add_rounded(hash, m.color_a), add_rounded(hash, m.color_b), add_rounded(hash, m.color_c);
}

// The triangles and materials of a piece.
std::string look_of(const Piece& piece) {
    Hash hash;
    for (const Mesh& mesh : piece.meshes) {
        add_look(hash, piece.materials[static_cast<std::size_t>(mesh.material)]);
        hash.add(mesh.triangles.size());
        for (const Vec3f p : mesh.positions) add_rounded(hash, p);
        // Which of the pictures on a sheet.
        const bool printed = piece.materials[static_cast<std::size_t>(mesh.material)].image != nullptr;
        for (std::size_t i = 0; printed && i < mesh.coords.size(); ++i) add_rounded(hash, mesh.coords[i]);
    }
    return hash.hex();
}

// What is the same thing whatever the kind: the pictures that a piece shows; the body of a vase or a lamp.
std::vector<std::string> motifs_of(const Piece& piece) {
    std::vector<std::string> out;
    const bool vessel = has_role(piece.kind, Role::vase) || has_role(piece.kind, Role::light);
    for (const Mesh& mesh : piece.meshes) {
        const Material& m = piece.materials[static_cast<std::size_t>(mesh.material)];
        if (m.pattern == Pattern::art) {
            Hash hash;
            add_look(hash, m);
            out.push_back("art " + hash.hex());
        }
        // A photograph or painting, whatever is cut off of it.
        if (m.pattern == Pattern::image && m.name == furniture::kFramedArt)
            out.push_back(fmt::format("art {}", fmt::ptr(m.image.get())));
        constexpr std::size_t kBody = 3 * 60;  // corners: smaller parts are screws and feet
        if (!vessel || mesh.material != piece.main_material || mesh.triangles.size() < kBody) continue;
        float high = 0;
        for (const Vec3f p : mesh.positions) high = std::max(high, p.y);
        Hash hash;
        hash.add(static_cast<int>(m.pattern));
        add_rounded(hash, m.color_a);
        constexpr float kShape = 0.25f;  // of the height, as metres: parts of it below 1/250 are not seen
        for (const Vec3f p : mesh.positions) add_rounded(hash, p * (kShape / std::max(high, kLeastHigh)));
        out.push_back("body " + hash.hex());
    }
    return out;
}

class Sets {
  public:
    explicit Sets(const std::vector<Placed>& placed) : placed_(placed) {}

    bool together(int i, int k) const {
        if (i == k) return true;
        const Placed &a = at(i), &b = at(k);
        if (of_one_make(a) && of_one_make(b)) return true;
        if (a.wish.id >= 0 && a.wish.id == b.wish.id && a.wish.count > 1) return true;
        if (a.with == k || b.with == i) return true;
        // By one piece, or by two that are themselves a set.
        if (a.with >= 0 && b.with >= 0 && alike(a.with, b.with)) return true;
        if (a.on < 0 || b.on < 0) return false;
        if (a.on == b.on) return a.piece.kind == b.piece.kind && comes_in_numbers(a.piece.kind);
        return alike(a.on, b.on);
    }

  private:
    const Placed& at(int i) const { return placed_[static_cast<std::size_t>(i)]; }
    bool alike(int i, int k) const { return i == k || (at(i).piece.kind == at(k).piece.kind && together(i, k)); }
    // What a house is fitted with: curtains and blinds, lamps at the ceiling, radiators; what is bought alike.
    static bool of_one_make(const Placed& p) {
        return p.overhead || has_role(p.piece.kind, Role::ceiling_light) || is_curtain(p.piece.kind) ||
               has_role(p.piece.kind, Role::blind) || has_nyu40_label(p.piece.kind, "other structure") ||
               has_role(p.piece.kind, Role::alike);
    }
    static bool comes_in_numbers(std::string_view kind) {
        return has_role(kind, Role::in_groups) || has_role(kind, Role::before_seats) || has_role(kind, Role::heap);
    }
    const std::vector<Placed>& placed_;
};

}  // namespace

std::vector<std::string> looks_of(const Piece& piece) {
    std::vector<std::string> out = motifs_of(piece);
    const bool art = std::any_of(out.begin(), out.end(), [](const std::string& key) { return key.starts_with("art"); });
    out.push_back("look " + piece.kind + " " + look_of(piece));
    if (!piece.form.empty() && !art) out.push_back("form " + piece.kind + " " + piece.form);
    return out;
}

bool is_set(const std::vector<Placed>& placed, int i, int k) { return Sets(placed).together(i, k); }

std::vector<RepeatedForm> repeated_forms(const std::vector<Placed>& placed) {
    std::map<std::string, std::vector<int>> seen;
    std::vector<RepeatedForm> out;
    for (int i = 0; i < static_cast<int>(placed.size()); ++i) {
        const Piece& piece = placed[static_cast<std::size_t>(i)].piece;
        if (is_shell(piece.kind) || piece.meshes.empty()) continue;
        std::vector<int> alike;
        for (const std::string& key : looks_of(piece)) {
            std::vector<int>& those = seen[key];
            alike.insert(alike.end(), those.begin(), those.end());
            those.push_back(i);
        }
        std::erase(alike, i);
        // With one of those it is a set: a third lamp that hangs with the second is no repetition of the first.
        if (alike.empty() || std::any_of(alike.begin(), alike.end(), [&](int k) { return is_set(placed, i, k); }))
            continue;
        out.push_back({i, *std::min_element(alike.begin(), alike.end())});
    }
    return out;
}

}  // namespace fastscene
