// No form twice in a room, but for sets.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/wall/panels.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/repeated_forms.h"

namespace fastscene {
namespace {

constexpr float kSlack = 0.004f;  // metres by which what stands in another's place may be larger

// Of the same place: no larger, mounted alike, and as long as something stands on it, with the same tops.
bool takes_place_of(const Piece& fresh, const Piece& old, bool carries) {
    for (std::size_t a = 0; a < 3; ++a)
        if (fresh.size_m[a] > old.size_m[a] + kSlack) return false;
    if (fresh.mount != old.mount) return false;
    if (!carries) return true;
    if (fresh.surfaces.size() != old.surfaces.size()) return false;
    for (std::size_t i = 0; i < old.surfaces.size(); ++i)
        if (length(fresh.surfaces[i].center - old.surfaces[i].center) > kSlack ||
            length(fresh.surfaces[i].half - old.surfaces[i].half) > kSlack)
            return false;
    return true;
}

using Looks = std::vector<std::string>;

// Draws pieces again for their places.
class Redrawing {
  public:
    Redrawing(std::vector<Placed>& placed, const Style& style) : placed_(placed), style_(style) {
        for (const Placed& p : placed_) looks_.push_back(looks_of(p.piece));
    }

    // Another form first, then another color. Whether there was one.
    bool redraw(int piece) {
        const Placed& p = at(piece);
        if (!p.piece.made_from || p.piece.made_from->model) return false;  // a model is as it is
        const PieceRequest& made = *p.piece.made_from;
        PieceRequest request = made;
        constexpr int kForms = 16;
        // Of the size that was asked for, then of the size that it has.
        for (const Vec3f size : {made.size_m, p.piece.size_m}) {
            request.size_m = size;
            for (int tries = 0; tries < kForms; ++tries) {
                request.seed = mix64(request.seed);
                if (stands(piece, request)) return true;
            }
        }
        if (!made.color_name.empty() || made.color) return false;
        static constexpr std::array<const char*, 6> kPaints{"charcoal", "cream",      "olive",
                                                            "taupe",    "terracotta", "navy"};
        request = made;
        for (std::size_t c = 0; c < kPaints.size(); ++c) {
            request.color_name = kPaints[(made.seed + c) % kPaints.size()];
            request.color = color_named(request.color_name);
            if (stands(piece, request)) return true;
        }
        return false;
    }

  private:
    Placed& at(int i) { return placed_[static_cast<std::size_t>(i)]; }
    Looks& looks(int i) { return looks_[static_cast<std::size_t>(i)]; }
    int count() const { return static_cast<int>(placed_.size()); }

    Piece made(const PieceRequest& request, const Placed& for_place) const {
        PieceRequest r = request;
        if (!r.style) r.style = &style_;
        Piece fresh = make_piece(r);
        if (for_place.piece.mount != for_place.piece.made_mount) mount_as(fresh, for_place.piece.mount);
        return fresh;
    }

    bool carries(int i) const {
        return std::any_of(placed_.begin(), placed_.end(),
                           [&](const Placed& other) { return other.on == i || other.below == i; });
    }

    // Whether it finds its place and looks like nothing else in the room; then it stands there, and so do those that
    // were a set with it.
    bool stands(int piece, const PieceRequest& request) {
        Piece fresh = made(request, at(piece));
        if (!takes_place_of(fresh, at(piece).piece, carries(piece))) return false;
        Looks its = looks_of(fresh);
        for (int k = 0; k < count(); ++k)
            if (k != piece && !is_set(placed_, piece, k) &&
                std::any_of(its.begin(), its.end(), [&](const std::string& look) {
                    return std::find(looks(k).begin(), looks(k).end(), look) != looks(k).end();
                }))
                return false;
        const Looks before = std::exchange(looks(piece), its);
        at(piece).piece = std::move(fresh);
        for (int k = 0; k < count(); ++k) {
            if (k == piece || looks(k) != before || !is_set(placed_, piece, k)) continue;
            Piece like_it = made(request, at(k));
            if (!takes_place_of(like_it, at(k).piece, carries(k))) continue;
            at(k).piece = std::move(like_it);
            looks(k) = its;
        }
        return true;
    }

    std::vector<Placed>& placed_;
    const Style& style_;
    std::vector<Looks> looks_;
};

}  // namespace

void Layout::tell_apart() {
    const auto is_panel = [this](int piece) {
        const auto& made = placed_[static_cast<std::size_t>(piece)].piece.made_from;
        return made && furniture::panel_of(made->pattern).has_value();
    };
    constexpr int kRounds = 3;  // what was drawn again may part with its set
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<RepeatedForm> repeated = repeated_forms(placed_);
        if (repeated.empty()) return;
        Redrawing redrawing(placed_, plan_.style);
        // A panel alone would no longer continue its neighbor.
        for (const RepeatedForm& r : repeated)
            if ((is_panel(r.piece) || !redrawing.redraw(r.piece)) && !is_panel(r.first)) redrawing.redraw(r.first);
    }
}

}  // namespace fastscene
