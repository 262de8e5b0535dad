// A clause as it is checked against the rooms before and after it. edit_audit.cc, places in edit_audit_places.cc.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_audit.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/materials.h"

namespace fastscene::editing {

inline bool differs(const std::optional<Material>& a, const std::optional<Material>& b) {
    return a.has_value() != b.has_value() || (a && (a->name != b->name || a->color_a != b->color_a));
}

inline constexpr float kWhich = 1;  // metres: how much further off what is meant by its place may be

class Audit {
  public:
    Audit(Talk& talk, const Clause& clause, const Snapshot& before)
        : talk_(talk),
          clause_(clause),
          before_(before),
          after_(snapshot_of(talk)),
          words_(seen_in(clause)),
          mentions_(mentions_in(words_)) {
        find_changes();
    }

    void tell() {
        check_words();
        check_looks();
        check_shapes();
        check_things();
        check_places();
        check_there();
        check_sizes();
        check_counts();
        for (const Shown* s : added_)
            if (mount_of(talk_.editor, s->thing.kind) == Mount::surface && s->thing.on.empty() && s->box.y0 < 0.05f &&
                s->thing.window < 0 && has_role(s->thing.kind, Role::light) && !says_any({"floor", "ground"}))
                talk_.editor.note(s->thing.id, "it stands on the floor: nothing there carries it");
        if (!missing_.empty())
            talk_.editor.note(kNotDone,
                              fmt::format("\"{} {}\": {}", clause_.said, text_of(words_), fmt::join(missing_, "; ")));
    }

  private:
    // "The chair by a bench", "for a bench": that comes for it, and stands by nothing.
    static Words seen_in(const Clause& clause) {
        Words out = clause.words;
        const std::size_t by = find_word(out, {"by", "for", "with"}, 1);
        if ((clause.verb == Verb::replace || clause.verb == Verb::swap) && by < out.size()) out[by] = "with";
        return out;
    }
    void find_changes() {
        for (const Shown& now : after_.things) {
            const Shown* was = before_.find(now.thing.id);
            if (!was) added_.push_back(&now);
            else if (was->thing.position != now.thing.position || was->thing.yaw != now.thing.yaw ||
                     was->thing.on != now.thing.on)
                moved_.push_back(&now);
            else if (looks_other(was->thing, now.thing)) other_.push_back(&now);
        }
        // What stands on a thing goes along with it.
        const auto goes_along = [&](const Shown* s) {
            const Shown *was = before_.find(s->thing.id), *under = after_.find(s->thing.on);
            return under && was->thing.on == s->thing.on &&
                   std::find(moved_.begin(), moved_.end(), under) != moved_.end();
        };
        along_.assign(moved_.begin(), moved_.end());
        std::erase_if(along_, [&](const Shown* s) { return !goes_along(s); });
        std::erase_if(moved_,
                      [&](const Shown* s) { return std::find(along_.begin(), along_.end(), s) != along_.end(); });
        for (const Shown& was : before_.things)
            if (!after_.find(was.thing.id)) gone_.push_back(&was);
        const DocumentSurfaces &s = before_.surfaces, &t = after_.surfaces;
        const auto surface = [&](const std::optional<Material>& was, const std::optional<Material>& is) {
            if (differs(was, is) && is) surfaces_.push_back(&*is);
        };
        surface(s.floor, t.floor), surface(s.wall, t.wall), surface(s.accent_wall, t.accent_wall);
        surface(s.ceiling, t.ceiling), surface(s.trim, t.trim);
        for (std::size_t w = 0; w < s.walls.size(); ++w) surface(s.walls[w], t.walls[w]);
    }
    static bool looks_other(const DocumentThing& a, const DocumentThing& b) {
        return a.color != b.color || a.color2 != b.color2 || a.material != b.material || a.pattern != b.pattern ||
               a.holder_color != b.holder_color || a.holder_material != b.holder_material || a.size_m != b.size_m ||
               a.lit != b.lit || a.kind != b.kind || a.seed != b.seed;
    }

    std::string word(std::size_t at) const { return at < words_.size() ? words_[at] : ""; }
    bool says_any(std::initializer_list<std::string_view> any) const { return has_word(words_, any); }
    // "Not", "instead of the red one": what is not to be.
    bool is_denied(const Mention& m) const {
        if (find_word(words_, {"except"}) < m.from) return true;
        for (std::size_t i = m.from; i-- > 0 && !is_joint(words_[i]);)
            if (is_one_of(words_[i], {"not", "no", "without", "instead", "except", "but", "than", "like", "from", "as",
                                      "match", "where", "was", "were"}))
                return true;
        return false;
    }
    std::size_t begin_of_part(std::size_t at) const {
        while (at > 0 && !is_joint(words_[at - 1])) --at;
        return at;
    }

    void check_words() {
        for (const Mention& m : mentions_)
            if (m.kind == Mention::Kind::unknown) missing_.push_back(fmt::format("\"{}\" was not understood", m.term));
    }

    // ---- looks
    bool is_seen(const std::string& look) const {
        const auto in = [&](const std::string& text) { return text.find(look) != std::string::npos; };
        const auto has = [&](const Shown* s) {
            const DocumentThing& t = s->thing;
            for (const std::string* field : {&t.color, &t.color2, &t.material, &t.pattern, &t.holder_color,
                                             &t.holder_material, &t.back_color, &t.back_material, &t.kind})
                if (in(*field)) return true;
            return false;
        };
        for (const auto* all : {&added_, &moved_, &other_, &gone_})
            if (std::any_of(all->begin(), all->end(), has)) return true;
        return std::any_of(surfaces_.begin(), surfaces_.end(), [&](const Material* m) { return in(m->name); });
    }
    void check_looks() {
        for (const Mention& m : mentions_) {
            if (m.kind != Mention::Kind::look || is_denied(m)) continue;
            if (!surfaces_.empty() || before_.style != after_.style) continue;
            if (is_selecting(m)) continue;
            std::vector<std::string> names{m.term, m.meaning};
            if (const auto looks = looks_of(m.term))
                names.insert(names.end(), {looks->color, looks->material, looks->pattern});
            const auto seen = [&](const std::string& name) { return !name.empty() && is_seen(name); };
            if (std::none_of(names.begin(), names.end(), seen))
                missing_.push_back(fmt::format("nothing is {}", m.term));
        }
    }
    // "The red chair" is one that is red.
    bool is_selecting(const Mention& m) const {
        std::size_t next = m.to;
        for (const Mention& other : mentions_)
            if (other.from == next && other.kind == Mention::Kind::look) next = other.to;
        const bool noun = std::any_of(mentions_.begin(), mentions_.end(), [&](const Mention& other) {
            return other.from == next && (other.kind == Mention::Kind::thing || other.kind == Mention::Kind::part ||
                                          other.kind == Mention::Kind::pronoun);
        });
        for (std::size_t i = m.from; noun && i-- > 0 && !is_joint(words_[i]);) {
            if (is_definite(words_[i]) || is_one_of(words_[i], {"all", "both", "every", "each"})) return true;
            if (i + 3 < m.from) break;
        }
        return false;
    }

    // ---- things
    // Behind a relation, or a mere part of what another noun says.
    bool is_anchor(std::size_t k) const {
        const Mention& m = mentions_[k];
        for (std::size_t i = k; i-- > 0;) {
            const Mention& other = mentions_[i];
            if (begin_of_part(m.from) != begin_of_part(other.from) && other.meaning != "between") break;
            // "Into a round one with four chairs"
            if (find_word(part_of(words_, other.to, m.from), {"with"}) < m.from - other.to) return false;
            if (other.kind == Mention::Kind::relation) return true;
            if (other.kind == Mention::Kind::thing) break;
        }
        return false;
    }
    bool is_head(std::size_t k) const {
        const Mention& m = mentions_[k];
        if (m.kind != Mention::Kind::thing) return false;
        // "Desk lamp", "the chair's cushion"
        if (k + 1 < mentions_.size() && mentions_[k + 1].from == m.to &&
            (mentions_[k + 1].kind == Mention::Kind::thing || mentions_[k + 1].kind == Mention::Kind::part))
            return false;
        // "The floor light oak"
        if (!surfaces_.empty() && !noun_of(m.term.substr(0, m.term.find(' '))).empty()) return false;
        // "A bowl of fruit", "everything off the table", "the tables that have a vase"
        std::size_t before = m.from;
        while (before > 0 && (is_definite(words_[before - 1]) || number_said(words_[before - 1]))) --before;
        if (is_one_of(m.from > 0 ? words_[m.from - 1] : "", {"of", "for", "like"})) return false;
        // "One side of the island", but "two of the chairs"
        if (before > 1 && words_[before - 1] == "of" && is_one_of(words_[before - 2], {"side", "end", "front", "back"}))
            return false;
        return before == 0 || !is_one_of(words_[before - 1], {"off", "have", "has", "from", "as", "than", "match"});
    }
    template <class Any>
    std::vector<const Shown*> called(const Any& all, const Mention& m) const {
        std::vector<const Shown*> out;
        for (const Shown* s : all)
            if (is_called(s->thing, m)) out.push_back(s);
        return out;
    }
    bool is_touched(const Mention& m) const {
        for (const auto* all : {&added_, &moved_, &other_, &gone_, &along_})
            if (!called(*all, m).empty()) return true;
        return false;
    }
    bool was_told_of(const Mention& m) const {
        const auto& changes = talk_.editor.result().changes;
        const std::string noun = singular(m.term.substr(m.term.rfind(' ') + 1));
        return std::any_of(changes.begin() + static_cast<std::ptrdiff_t>(before_.changes), changes.end(),
                           [&](const EditChange& c) {
                               return c.id.find(noun) != std::string::npos || c.what.find(noun) != std::string::npos ||
                                      c.what.find(m.meaning) != std::string::npos;
                           });
    }
    // A kitchen's "cupboards" are its counter's.
    bool is_meant_otherwise(const Mention& m) const {
        for (const int i : all_named(talk_.editor, "all " + m.term)) {
            const std::string& id = talk_.editor.document().things[static_cast<std::size_t>(i)].id;
            for (const auto* all : {&added_, &moved_, &other_})
                if (std::any_of(all->begin(), all->end(), [&](const Shown* s) { return s->thing.id == id; }))
                    return true;
        }
        return false;
    }
    // "The big round table" is one of those that are there.
    bool is_of_those(std::size_t at) const {
        while (at-- > 0 && !is_joint(words_[at])) {
            if (is_definite(words_[at])) return true;
            if (is_one_of(words_[at], {"a", "an", "to", "into"}) || !noun_of(words_[at]).empty()) return false;
            if (const auto known = look_up(words_[at]); known && known->kind == WordKind::object) return false;
        }
        return false;
    }
    // "A round one"
    void check_shapes() {
        for (std::size_t i = 0; i + 1 < words_.size(); ++i) {
            const std::string shape = shape_said({words_[i]});
            if (shape.empty() || is_definite(words_[i + 1]) || is_of_those(i)) continue;
            const auto is_so = [&](const Shown* s) {
                return shape_of(talk_.editor.placed(s->thing.id).piece) == shape;
            };
            bool any = !gone_.empty();
            for (const auto* all : {&added_, &moved_, &other_})
                any = any || std::any_of(all->begin(), all->end(), is_so);
            // Kinds without shapes are not checked.
            if (!any && (!moved_.empty() || !other_.empty()) && added_.empty())
                missing_.push_back(fmt::format("nothing became {}", shape));
        }
    }
    void check_things() {
        if (clause_.verb == Verb::clear) return;  // what stands on them goes
        for (std::size_t k = 0; k < mentions_.size(); ++k) {
            const Mention& m = mentions_[k];
            if (!is_head(k) || is_anchor(k) || is_denied(m) || is_touched(m) || was_told_of(m)) continue;
            if (is_meant_otherwise(m) || has_role(m.meaning, Role::person)) continue;
            missing_.push_back(fmt::format("nothing was done to \"{}\"", m.term));
        }
    }

    // ---- places: edit_audit_places.cc
    std::vector<const Shown*> subjects_of(std::size_t k) const;
    std::vector<Landmark> landmarks_behind(std::size_t k) const;
    bool holds(const Shown& s, std::string relation, const std::vector<Landmark>& at, float slack = 0) const;
    // Whether the later of two places is that of the same things: "on the desk and on the shelf".
    bool names_more_places(std::size_t k, std::size_t j) const;
    void check_places();
    static std::string how_far(const Shown& s, const std::vector<Landmark>& at);
    // "And hang a mirror there": where that stood which went.
    void check_there();
    // "A bigger lamp", "two small pictures"
    void check_sizes();

    // ---- numbers
    void check_counts() {
        const auto& changes = talk_.editor.result().changes;
        const auto filled_up = [](const EditChange& c) {
            return c.what.find("stand there already") != std::string::npos;
        };
        if (std::any_of(changes.begin() + static_cast<std::ptrdiff_t>(before_.changes), changes.end(), filled_up))
            return;
        if (says_any({"each", "every", "both", "all", "either", "more", "of", "row", "rows", "for"})) return;
        for (std::size_t k = 0; k < mentions_.size(); ++k) {
            const Mention& m = mentions_[k];
            if (!is_head(k) || is_anchor(k) || is_denied(m) || m.from == 0) continue;
            std::size_t at = m.from;
            for (std::size_t i = k; i-- > 0 && mentions_[i].to == at && mentions_[i].kind != Mention::Kind::thing;)
                at = mentions_[i].from;
            while (at > 1 && (value_of({words_[at - 1]}) || look_up(words_[at - 1])) && !number_said(words_[at - 1]) &&
                   !is_definite(words_[at - 1]) && !relation_at(words_, at - 1) && !is_joint(words_[at - 1]))
                --at;  // "two large paintings"
            const auto number = at > 0 && !is_one_of(words_[at - 1], {"a", "an", "one", "half", "quarter", "couple"})
                                    ? number_said(words_[at - 1])
                                    : std::nullopt;
            if (!number || *number < 2) continue;
            const auto came = called(added_, m), went = called(gone_, m);
            const std::size_t most = std::max(
                {came.size(), went.size(), called(moved_, m).size(), called(other_, m).size()});
            if (most > 0 && static_cast<float>(most) < *number)
                missing_.push_back(fmt::format("{} of {:.0f} {}", most, *number, m.term));
        }
    }

    Talk& talk_;
    const Clause& clause_;
    const Snapshot& before_;
    const Snapshot after_;
    const Words words_;
    const std::vector<Mention> mentions_;
    std::vector<const Shown*> added_, moved_, other_, gone_, along_;
    std::vector<const Material*> surfaces_;
    std::vector<std::string> missing_;
};

}  // namespace fastscene::editing
