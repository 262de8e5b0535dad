// Cloth of a piece in a prompt: "bedding in white", "a gingham tablecloth".
#include <optional>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/prints.h"
#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

bool is_tablecloth(const std::string& words) {
    return is_one_of(words, {"tablecloth", "tablecloths", "table cloth", "table cloths"});
}
// Tables that a cloth is drawn for.
bool is_laid(std::string_view kind) { return has_role(kind, Role::laid); }

// "a yellow gingham tablecloth": its color and its print; the table below keeps its own.
void lay_cloth(Reading& r, std::size_t cloth, std::size_t owner) {
    PromptObject& table = r.object_of(owner);
    table.holder_material = kTableCloth;
    for (std::size_t k = 0; k < r.m.size(); ++k) {
        if (r.m[k].noun != static_cast<int>(cloth) || r.m[k].is(WordKind::count)) continue;
        const Word& word = *r.m[k].word;
        if (r.m[k].is(WordKind::color) && table.holder_color.empty())
            table.holder_color = word.meaning, r.tell(k, "tablecloth in color " + word.meaning, table.id);
        else if (r.m[k].is(WordKind::pattern) && table.pattern.empty() && is_print(word.meaning))
            table.pattern = word.meaning, r.tell(k, "tablecloth with pattern " + word.meaning, table.id);
        else r.tell_near(k, "of the tablecloth: as such cloths are", table.id);
    }
    r.tell(cloth, "cloth on the " + table.words, table.id);
}

}  // namespace

// "bedding in white", "bed with white sheets": the cloth of a piece takes color for the piece itself.
void pass_on_cloth(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        if (!r.m[i].is(WordKind::detail) || r.m[i].word->meaning != "textile" || r.m[i].negated) continue;
        std::optional<std::size_t> owner;
        // A tablecloth is a table's, wherever that is named.
        const bool of_table = is_tablecloth(r.m[i].words);
        for (std::size_t k = 0; k < r.m.size() && of_table && !owner; ++k)
            if (has_object(r.m[k]) && r.m[k].is(WordKind::object) && !r.m[k].negated && is_laid(r.object_of(k).kind))
                owner = k;
        if (of_table && owner) lay_cloth(r, i, *owner);
        if (of_table && !owner) r.tell_near(i, "no table was named that it could lie on");
        if (of_table) continue;
        for (std::size_t k = i; k-- > 0 && !owner;)
            if (has_object(r.m[k]) && r.m[k].is(WordKind::object)) owner = k;
        for (std::size_t k = i + 1; k < r.m.size() && !owner; ++k)
            if (has_object(r.m[k]) && r.m[k].is(WordKind::object)) owner = k;
        if (!owner) continue;
        for (std::size_t k = 0; k < r.m.size(); ++k)
            if (r.m[k].noun == static_cast<int>(i) && !r.m[k].is(WordKind::count)) {
                r.m[k].noun = -1;
                // Of a bunk the frame takes what is said of the piece; its bedding has a color of its own.
                PromptObject& bed = r.object_of(*owner);
                const bool framed = has_role(bed.kind, Role::framed_bed);
                if (framed && r.m[k].is(WordKind::color) && bed.holder_color.empty()) {
                    r.m[k].noun = static_cast<int>(*owner);
                    bed.holder_color = r.m[k].word->meaning;
                    r.tell(k, "bedding in color " + bed.holder_color + " of " + bed.kind, bed.id);
                } else if (framed && r.m[k].is(WordKind::material)) {
                    r.m[k].noun = static_cast<int>(*owner);
                    r.tell_near(k, "of the " + r.m[i].words + ", which is as the piece has it");
                } else {
                    bind_adjective(r, k, *owner);
                }
            }
        r.tell(i, "cloth of " + r.object_of(*owner).kind, r.m[*owner].object);
    }
}

}  // namespace fastscene::reading
