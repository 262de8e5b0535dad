// What is wrong with a document, beyond its JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/base/suggest.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

class Checker {
  public:
    Checker(const RoomDocument& document, const std::string& file, const FurniturePack* pack)
        : document_(document), file_(file), pack_(pack) {}

    void check() {
        known("/room", document_.type, room_types_of_all());
        if (!document_.style.empty()) known("/style", document_.style, styles());
        plan("/plan", document_.plan);
        things("/things", document_.things, document_.plan);
        if (!document_.next_room) return;
        if (!document_.plan.openings)
            fail("/next_room", "expected \"openings\" in the plan as well: the doorway to it stands there");
        known("/next_room/room", document_.next_room->type, room_types_of_all());
        plan("/next_room/plan", document_.next_room->plan);
        things("/next_room/things", document_.next_room->things, document_.next_room->plan);
    }

  private:
    [[noreturn]] void fail(const std::string& pointer, const std::string& text) const {
        throw Error("{}: {}: {}", file_, pointer, text);
    }
    void known(const std::string& pointer, const std::string& name, const std::vector<std::string>& names) const {
        if (std::find(names.begin(), names.end(), name) != names.end()) return;
        const std::string near = nearest_word(name, names);
        constexpr std::size_t kFew = 40;
        fail(pointer, fmt::format("unknown \"{}\"{}", name,
                                  !near.empty()          ? fmt::format("; did you mean \"{}\"?", near)
                                  : names.size() <= kFew ? fmt::format("; known are {}", fmt::join(names, ", "))
                                                         : ""));
    }
    static std::vector<std::string> room_types_of_all() {
        std::vector<std::string> out;
        for (const RoomType& type : all_room_types()) out.push_back(type.name);
        return out;
    }

    void plan(const std::string& pointer, const DocumentPlan& p) const {
        constexpr float kLeast = 1, kMost = 30, kLowest = 1.9f, kHighest = 12;
        const auto within = [&](const char* key, float value, float low, float high) {
            if (value != 0 && !(value >= low && value <= high))
                fail(pointer + "/" + key, fmt::format("expected {} to {} metres, found {}", low, high, value));
        };
        within("width_m", p.width, kLeast, kMost);
        within("depth_m", p.depth, kLeast, kMost);
        within("height_m", p.height, kLowest, kHighest);
        if (!p.polygon.empty()) {
            if (p.width > 0 || p.depth > 0 || !p.blocks.empty())
                fail(pointer + "/polygon", "expected either a polygon, or width_m, depth_m and blocks, found both");
            Plan outline;
            apply_polygon(p.polygon, file_ + ": " + pointer + "/polygon", outline);
        }
        if (p.knee > 0 && !(p.slope_run > 0)) fail(pointer + "/slope_run_m", "expected more than 0 below a slope");
        if (p.vault != Vault::flat && !(p.spring > 0 && (p.height == 0 || p.spring < p.height)))
            fail(pointer + "/spring_m",
                 fmt::format("expected more than 0 and less than height_m below a vault, found {}", p.spring));
        if (const Mezzanine& m = p.mezzanine; m.depth > 0) {
            if (p.depth > 0 && m.depth >= p.depth)
                fail(pointer + "/mezzanine_m",
                     fmt::format("expected less than the room's {:.2f} m, found {:.2f}", p.depth, m.depth));
            if (!(m.floor > kMezzanineSlab && (p.height == 0 || m.floor < p.height)))
                fail(pointer + "/mezzanine_floor_m",
                     fmt::format("expected a height between floor and ceiling, found {:.2f}", m.floor));
            if (m.stairs_wall == 2) fail(pointer + "/mezzanine_stairs", "expected the wall 1 or 3, found 2");
        }
        if (p.oculus > 0 && p.vault != Vault::dome) fail(pointer + "/oculus_m", "expected a vault that is a dome");
        for (std::size_t i = 0; i < p.blocks.size(); ++i)
            if (cuts_corner(p.blocks[i]) && p.width > 0 && p.depth > 0 && !is_at_corner(p.blocks[i], p))
                fail(fmt::format("{}/blocks/{}", pointer, i), "expected a corner of the box");
        for (std::size_t i = 0; i < p.blocks.size(); ++i)
            if (!(p.blocks[i].low.x < p.blocks[i].high.x && p.blocks[i].low.y < p.blocks[i].high.y))
                fail(fmt::format("{}/blocks/{}", pointer, i), "expected low below high");
        for (std::size_t i = 0; i < p.platforms.size(); ++i)
            platform(fmt::format("{}/platforms/{}", pointer, i), p.platforms[i], p);
        if (p.openings)
            for (std::size_t i = 0; i < p.openings->size(); ++i)
                opening(fmt::format("{}/openings/{}", pointer, i), (*p.openings)[i], p);
    }
    void platform(const std::string& pointer, const Platform& f, const DocumentPlan& p) const {
        constexpr float kHead = 1.9f;
        if (!(f.low.x < f.high.x && f.low.y < f.high.y)) fail(pointer, "expected low below high");
        if (!(f.height > 0) || (p.height > 0 && f.height > p.height - kHead))
            fail(pointer, fmt::format("height_m: expected more than 0 and {} m below the ceiling, found {:.2f}", kHead,
                                      f.height));
    }
    static bool is_at_corner(const Block& b, const DocumentPlan& p) {
        constexpr float kTolerance = 1e-3f;
        const auto ends = [](float low, float high, float half) {
            return (std::abs(low + half) < kTolerance) != (std::abs(high - half) < kTolerance);
        };
        return ends(b.low.x, b.high.x, p.width / 2) && ends(b.low.y, b.high.y, p.depth / 2);
    }
    void opening(const std::string& pointer, const Opening& o, const DocumentPlan& p) const {
        constexpr float kTolerance = 1e-3f;
        if (!(o.u0 < o.u1 && o.y0 < o.y1)) fail(pointer, "expected from_m below to_m and low_m below high_m");
        const float length = o.wall % 2 == 0 ? p.width : p.depth;
        if (length > 0 && o.u1 > length + kTolerance)
            fail(pointer, fmt::format("to_m: expected at most the wall's {:.2f} m, found {:.2f}", length, o.u1));
        if (p.height > 0 && o.y1 > p.height + kTolerance)
            fail(pointer, fmt::format("high_m: expected at most the room's {:.2f} m, found {:.2f}", p.height, o.y1));
    }

    void things(const std::string& pointer, const std::vector<DocumentThing>& all, const DocumentPlan& p) {
        std::map<std::string, std::size_t> index;
        std::vector<std::string> ids;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string at = fmt::format("{}/{}", pointer, i);
            if (all[i].id.empty()) fail(at + "/id", "expected a name, found none");
            if (const auto [twin, is_new] = places_.try_emplace(all[i].id, at); !is_new)
                fail(at + "/id", fmt::format("\"{}\" stands twice: {} has it too", all[i].id, twin->second));
            index[all[i].id] = i;
            ids.push_back(all[i].id);
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string at = fmt::format("{}/{}", pointer, i);
            thing(at, all[i]);
            for (const auto& [key, id] : {std::pair{"on", all[i].on}, {"below", all[i].below}, {"with", all[i].with}})
                if (!id.empty()) known(at + "/" + key, id, ids);
            if (all[i].window >= 0 && (!p.openings || all[i].window >= static_cast<int>(p.openings->size())))
                fail(at + "/window", fmt::format("expected the index of an opening, found {}", all[i].window));
            std::size_t top = i;
            for (std::size_t steps = 0; !all[top].on.empty(); top = index[all[top].on])
                if (++steps > all.size()) fail(at + "/on", "expected what stands on the floor at last, found a circle");
        }
    }
    void thing(const std::string& at, const DocumentThing& t) const {
        if (!t.model.empty()) return model(at, t);
        const auto& kinds = piece_classes();
        if (!std::binary_search(kinds.begin(), kinds.end(), t.kind) && !(pack_ && pack_->choose(t.kind, t.seed)))
            known(at + "/kind", t.kind, kinds);
        if (!t.style.empty()) known(at + "/style", t.style, styles());
        if (t.color.starts_with("#") && !document_fields::color_said(t.color))
            fail(at + "/color", fmt::format("expected a color's name or #rrggbb, found \"{}\"", t.color));
    }
    void model(const std::string& at, const DocumentThing& t) const {
        const bool there = pack_ && std::any_of(pack_->models().begin(), pack_->models().end(),
                                                [&](const PackModel& m) { return m.path == t.model; });
        if (!there)
            fail(at + "/model",
                 fmt::format("the model \"{}\" is in no furniture pack in use (sweethome3d-furniture; --assets)",
                             t.model));
    }

    const RoomDocument& document_;
    const std::string& file_;
    const FurniturePack* pack_;
    std::map<std::string, std::string> places_;  // of ids
};

}  // namespace

void check_document(const RoomDocument& document, const std::string& file, const FurniturePack* pack) {
    Checker(document, file, pack).check();
}

}  // namespace fastscene
