// What the prompt asks for, as the layout uses it up.
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_parts.h"

namespace fastscene::furnishing {
namespace {

bool is_opening(std::string_view kind) { return has_role(kind, Role::opening); }

}  // namespace

bool is_small(std::string_view kind) { return has_role(kind, Role::small); }
bool is_seat(std::string_view kind) { return has_role(kind, Role::seat); }
// Tables of the furniture pack have no row.
bool hangs_over(std::string_view kind) { return has_role(kind, Role::lamp_above) || kind.ends_with("table"); }

bool is_hung_screen(const PromptObject& wish) {
    return wish.kind == "tv" && wish.relation == "on" && wish.relation_to == "wall";
}

bool is_blind(std::string_view kind) { return has_role(kind, Role::blind); }
bool lights_from_above(std::string_view kind) { return has_role(kind, Role::ceiling_light); }
bool lies_about(std::string_view kind) { return has_role(kind, Role::litter); }
bool lies_on_seats(std::string_view kind) { return has_role(kind, Role::lies_on_seats); }

bool Ask::at_shell() const {
    return is_one_of(relation, {"in the corner", "in the middle", "far wall", "against"}) || is_opening(at) ||
           is_one_of(at, {"wall", "floor", "ceiling", "beams", "skylight", "alcove", "column", "sloped_ceiling"});
}
bool Ask::at_piece() const { return !relation.empty() && !at.empty() && !at_shell(); }

Wishes::Wishes(const PromptSpec& spec) : spec_(spec) {
    for (const PromptObject& o : spec.objects)
        asks_.push_back({&o, o.relation, o.relation_to, o.relation_and,
                         o.forbidden || is_shell(o.kind) || o.relation == "in the next room" ? 0 : o.count});
    const auto ask_for = [&](const std::string& kind) {
        const auto i = std::find_if(asks_.begin(), asks_.end(), [&](const Ask& a) {
            return a.left > 0 && a.wish->kind == kind && a.relation.empty();
        });
        return i == asks_.end() ? nullptr : &*i;
    };
    // A screen opposite the sofa is what every living room has: it gets its stand there.
    for (Ask& ask : asks_)
        if (ask.wish->kind == "tv" &&
            ((ask.at == "sofa" &&
              (ask.relation == "opposite" || ask.relation == "in front of" || ask.relation == "facing")) ||
             is_hung_screen(*ask.wish)))
            ask.relation = ask.at = "";
    // "a table on the rug" is a rug under the table, "a sofa under a painting" a painting above the sofa: what is
    // placed second is bound.
    for (Ask& ask : asks_) {
        if (ask.left <= 0) continue;
        const bool on_rug = ask.relation == "on" && ask.at == "rug",
                   below_hung = ask.relation == "under" && has_role(ask.at, Role::hung);
        Ask* other = on_rug || below_hung ? ask_for(ask.at) : nullptr;
        if (!other || other == &ask || (on_rug && is_small(ask.wish->kind))) continue;
        other->relation = on_rug ? "under" : "above";
        other->at = ask.wish->kind;
        ask.relation = ask.at = "";
    }
}

bool is_settled(const PromptSpec& spec, std::string_view kind) {
    return std::any_of(spec.objects.begin(), spec.objects.end(), [&](const PromptObject& o) {
        return (o.forbidden && o.kind == kind) || (o.counted && is_form_of(kind, o.kind));
    });
}

bool Wishes::forbids(std::string_view kind) const {
    return std::any_of(spec_.objects.begin(), spec_.objects.end(),
                       [&](const PromptObject& o) { return o.forbidden && o.kind == kind; });
}

const PromptObject* Wishes::next(std::string_view kind) {
    for (Ask& ask : asks_)
        if (ask.left > 0 && ask.wish->kind == kind && !ask.at_piece()) return --ask.left, ask.wish;
    return nullptr;
}

void Wishes::give_back(const PromptObject* wish) {
    for (Ask& ask : asks_)
        if (ask.wish == wish) ++ask.left;
}

int Wishes::count(std::string_view kind) const {
    int n = 0;
    for (const Ask& ask : asks_)
        if (ask.wish->kind == kind) n += ask.left;
    return n;
}

bool Wishes::asked(std::string_view kind) const {
    return std::any_of(spec_.objects.begin(), spec_.objects.end(),
                       [&](const PromptObject& o) { return !o.forbidden && o.kind == kind; });
}

}  // namespace fastscene::furnishing
