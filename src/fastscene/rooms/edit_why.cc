// Why a thing has no place: what is in the way, or how much floor it takes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

bool is_meant(const EditStep& step, const Placed& p) {
    const auto is = [&](const std::string& kind) {
        return !kind.empty() && (p.piece.kind == kind || p.wish.kind == kind);
    };
    return is(step.wish.relation_to) || is(step.wish.relation_and);
}

}  // namespace

std::string Editor::why_none_added(EditStep step) const {
    const std::string place = place_in_words(step);
    PromptSpec spec = room_.spec;
    Random rng(room_.seed, "why");
    if (const std::string why = Layout(plan(), spec, rng).why_not(step.wish.kind); !why.empty())
        return fmt::format("{}: {}", step.wish.words, why);
    const auto hangs = [&](const Placed& p) { return asked_kind(p) == step.wish.kind && p.piece.mount == Mount::wall; };
    if (has_role(step.wish.kind, Role::soft) &&
        std::any_of(room_.furnished.placed.begin(), room_.furnished.placed.end(), hangs))
        return fmt::format("{}: they hang at the windows already; \"make the {} …\" changes them", step.wish.words,
                           step.wish.words);
    const int asked = step.wish.count;
    while (--step.wish.count > 0)
        if (!laid_out(without({}), step, nullptr).empty())
            return fmt::format("{}: there is a free place for {} of {}{}", step.wish.words, step.wish.count, asked,
                               place);
    step.wish.count = 1;
    return fmt::format("{}: there is no free place for it{}{}", step.wish.words, place,
                       what_is_missing(step, nullptr, {}));
}

// Whether it would have a place without one of the things that stand about it, or were it smaller.
std::string Editor::what_is_missing(const EditStep& step, const Placed* moving, const std::vector<int>& gone) const {
    EditStep one = step;
    one.wish.count = 1;
    const Vec3f size = moving ? moving->piece.size_m : usual_size(one.wish);
    const Mount mount = moving ? moving->piece.mount : mount_of(*this, one.wish.kind);
    if (size == Vec3f{} || mount == Mount::ceiling) return {};
    const bool hangs = mount == Mount::wall;
    const std::string takes = hangs ? fmt::format(": it takes {:.2f} x {:.2f} m of wall", size.x, size.y)
                                    : fmt::format(": it takes {:.2f} x {:.2f} m", size.x, size.z);
    if (mount == Mount::surface) return takes;
    const Squeeze tightly{.narrow = true};
    const auto fits_without = [&](const std::vector<int>& others) {
        std::vector<int> all = gone;
        for (const int i : with_riders(others))
            if (std::find(all.begin(), all.end(), i) == all.end()) all.push_back(i);
        return squeezed_in(without(all), one, moving, tightly, [](const Squeezed&) { return true; }).has_value();
    };
    // What is nearest to the place first.
    const std::vector<Footprint> anchors = anchors_of(plan(), room_.furnished.placed, one.wish.relation_to);
    std::vector<std::pair<float, int>> near;
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i) {
        const Placed& p = placed(i);
        const bool stands = p.on < 0 && !p.flat && (p.piece.mount == Mount::floor || (hangs && p.piece.mount == mount));
        if (!stands || is_meant(one, p) || std::find(gone.begin(), gone.end(), i) != gone.end()) continue;
        if (std::find(one.at.begin(), one.at.end(), p.id) != one.at.end()) continue;
        float off = anchors.empty() ? 0.f : 1e9f;
        for (const Footprint& a : anchors) off = std::min(off, distance_to(a, footprint_of(p).center));
        near.emplace_back(off, i);
    }
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    constexpr std::size_t kMostTried = 14, kMostNamed = 2;
    std::vector<std::string> blocking;
    for (std::size_t k = 0; k < std::min(kMostTried, near.size()) && blocking.size() < kMostNamed; ++k)
        if (fits_without({near[k].second})) blocking.push_back(placed(near[k].second).id);
    if (!blocking.empty())
        return fmt::format("{}, and {} {} in the way", takes, fmt::join(blocking, " or "),
                           blocking.size() > 1 ? "are" : "is");
    if (moving || !(one.wish.size_m == Vec3f{})) return takes;
    for (const float scale : {0.6f, 0.5f, 0.4f}) {
        one.wish.size_m = size * scale;
        if (fits_without({}))
            return fmt::format("{}, and there is room for {:.2f} x {:.2f} m at most", takes, size.x * scale,
                               (hangs ? size.y : size.z) * scale);
    }
    return takes;
}

}  // namespace fastscene::editing
