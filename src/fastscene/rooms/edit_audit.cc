// What of a clause cannot be seen in the room that it left: looks that nothing has, things that nothing was done to,
// places where nothing stands, words that were not understood.
#include "fastscene/rooms/edit_audit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/materials.h"

namespace fastscene::editing {

const Shown* Snapshot::find(const std::string& id) const {
    const auto found = std::find_if(things.begin(), things.end(), [&](const Shown& s) { return s.thing.id == id; });
    return found == things.end() ? nullptr : &*found;
}

Snapshot snapshot_of(const Talk& talk) {
    const Editor& editor = talk.editor;
    Snapshot out;
    out.surfaces = editor.document().surfaces, out.light = editor.document().light;
    out.style = editor.document().style;
    out.changes = editor.result().changes.size(), out.spoken = talk.last;
    const std::vector<Placed>& placed = editor.room().furnished.placed;
    for (std::size_t i = 0; i < editor.document().things.size(); ++i)
        out.things.push_back(
            {editor.document().things[i], footprint_of(placed[i]), placed[i].piece.mount, placed[i].flat});
    return out;
}

namespace {

bool differs(const std::optional<Material>& a, const std::optional<Material>& b) {
    return a.has_value() != b.has_value() || (a && (a->name != b->name || a->color_a != b->color_a));
}

constexpr float kWhich = 1;  // metres: how much further off what is meant by its place may be

class Audit {
  public:
    Audit(Talk& talk, const Clause& clause, const Snapshot& before)
        : talk_(talk),
          clause_(clause),
          before_(before),
          after_(snapshot_of(talk)),
          words_(clause.words),
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

    // ---- places
    std::vector<const Shown*> subjects_of(std::size_t k) const {
        // The nearest nouns before it, back to the joint; without any, whatever changed its place.
        std::size_t begin = begin_of_part(mentions_[k].from);
        // "A chair and a lamp by the window": both, unless the first has a place of its own.
        while (begin > 1 && clause_.verb != Verb::make && clause_.verb != Verb::color) {
            const std::size_t other = begin_of_part(begin - 1);
            if (words_[begin - 1] != "and" || next_place(part_of(words_, other, begin - 1)) < begin - 1 - other) break;
            begin = other;
        }
        std::vector<const Shown*> changed = added_;
        changed.insert(changed.end(), moved_.begin(), moved_.end());
        bool named = false;
        std::vector<const Shown*> out;
        for (std::size_t i = k; i-- > 0 && mentions_[i].from >= begin;) {
            if (mentions_[i].kind == Mention::Kind::pronoun && !named) return changed;
            if (!is_head(i) || is_anchor(i)) continue;
            named = true;
            const auto some = called(changed, mentions_[i]);
            out.insert(out.end(), some.begin(), some.end());
        }
        return named ? out : changed;
    }
    std::vector<Landmark> landmarks_behind(std::size_t k) const {
        std::vector<Landmark> out;
        for (std::size_t i = k + 1; i < mentions_.size(); ++i) {
            const Mention& m = mentions_[i];
            if (m.kind == Mention::Kind::relation) break;
            if (begin_of_part(m.from) != begin_of_part(mentions_[k].from) && mentions_[k].meaning != "between") break;
            if (m.term == "each" && m.to < words_.size() && words_[m.to] == "other") {
                for (const auto* all : {&added_, &moved_})
                    for (const Shown* s : *all) out.push_back(landmark_of(*s));
                return out;
            }
            if (m.kind == Mention::Kind::pronoun) {
                for (const std::string& id : before_.spoken)
                    if (const Shown* s = after_.find(id)) out.push_back(landmark_of(*s));
                if (out.empty()) return {};
                for (const Shown* s : added_) out.push_back(landmark_of(*s));
                return out;
            }
            if (m.kind == Mention::Kind::thing && !is_head(i)) continue;
            if (m.kind != Mention::Kind::thing && m.kind != Mention::Kind::part) continue;
            auto some = landmarks_called(talk_.editor, after_, m);
            // A bathroom's "sink" is its washbasin.
            if (some.empty() && m.kind == Mention::Kind::thing)
                for (const int one : all_named(talk_.editor, "all " + m.term))
                    some.push_back(landmark_of(after_.things[static_cast<std::size_t>(one)]));
            out.insert(out.end(), some.begin(), some.end());
            if (mentions_[k].meaning != "between") return out;
        }
        return out;
    }
    bool holds(const Shown& s, std::string relation, const std::vector<Landmark>& at, float slack = 0) const {
        if ((clause_.verb == Verb::turn || clause_.verb == Verb::face) && is_one_of(relation, {"to", "at", "next to"}))
            relation = "facing";
        // "In the center" of what carries it
        const Shown* carrier = after_.find(s.thing.on);
        if (relation == "in the middle" && carrier) {
            constexpr float kMiddle = 0.35f;  // of its half
            const Vec2f off = s.box.center - carrier->box.center;
            const auto axes = axes_of(carrier->box);
            return std::abs(dot(off, axes[0])) < kMiddle * carrier->box.half.x + 0.05f &&
                   std::abs(dot(off, axes[1])) < kMiddle * carrier->box.half.y + 0.05f;
        }
        if (is_one_of(relation, {"in the corner", "in the middle", "against"}) && at.empty())
            return holds_in_room(talk_.editor.plan(), s, relation);
        if (at.empty() || is_one_of(relation, {"from", "far wall"})) return true;
        if (relation == "between" && at.size() < 2) return true;
        if (relation == "between") return is_between_those(s, at, at);
        // A lamp on a desk by the window is by the window.
        if (const Shown* under = after_.find(s.thing.on);
            under && relation != "on" && holds(*under, relation, at, slack))
            return true;
        return std::any_of(at.begin(), at.end(), [&](const Landmark& one) {
            return (one.id.empty() || one.id != s.thing.id) && holds_at(s, relation, one, slack);
        });
    }
    void check_places() {
        if ((clause_.verb == Verb::turn || clause_.verb == Verb::face) && says_any({"slightly", "bit", "little"}))
            return;
        for (std::size_t k = 0; k < mentions_.size(); ++k) {
            const Mention& m = mentions_[k];
            if (m.kind != Mention::Kind::relation || is_denied(m)) continue;
            const std::vector<Landmark> at = landmarks_behind(k);
            // "And a lamp to the left": of what?
            if (is_one_of(m.meaning, {"left of", "right of"}) && m.to == words_.size() &&
                m.term.find("its") == m.term.npos && !added_.empty() && k > 0)
                missing_.push_back(fmt::format("\"{}\" was not understood", m.term));
            // "Around a new table", which must have come.
            if (m.to + 1 < words_.size() && is_one_of(words_[m.to], {"a", "an"}) &&
                is_one_of(words_[m.to + 1], {"new", "second", "third"}) && !at.empty() &&
                std::none_of(added_.begin(), added_.end(), [&](const Shown* s) {
                    return std::any_of(at.begin(), at.end(), [&](const Landmark& l) { return l.id == s->thing.id; });
                }))
                missing_.push_back(fmt::format("nothing new is there {}", text_of(words_, m.from)));
            std::vector<const Shown*> off;
            const auto subjects = subjects_of(k);
            bool any = false;
            for (const Shown* s : subjects) {
                const Shown* was = before_.find(s->thing.id);
                const bool there = holds(*s, m.meaning, at) || (was && holds(*was, m.meaning, at, kWhich));
                any = any || there;
                if (!there) off.push_back(s);
            }
            // What shares a corner stands by what is in it.
            if (m.meaning == "in the corner" && off.size() < subjects.size()) {
                constexpr float kBy = 0.8f;  // metres
                const auto is_by = [&](const Shown* s) {
                    return std::any_of(subjects.begin(), subjects.end(), [&](const Shown* other) {
                        return other != s && std::find(off.begin(), off.end(), other) == off.end() &&
                               apart(*s, landmark_of(*other)) < kBy;
                    });
                };
                std::vector<const Shown*> far;
                std::copy_if(off.begin(), off.end(), std::back_inserter(far),
                             [&](const Shown* s) { return !is_by(s); });
                off = far;
            }
            // "A table with two chairs in the corner": some of them.
            if (any && find_word(words_, {"with"}, begin_of_part(m.from)) < m.from) continue;
            if (off.empty()) continue;
            std::vector<std::string> ids;
            for (const Shown* s : off) ids.push_back(s->thing.id);
            std::size_t end = k + 1 < mentions_.size() ? mentions_[k + 1].to : words_.size();
            missing_.push_back(fmt::format("{} {} not {}{}", fmt::join(ids, ", "), ids.size() > 1 ? "are" : "is",
                                           text_of(words_, m.from, end), how_far(*off.front(), at)));
        }
    }
    static std::string how_far(const Shown& s, const std::vector<Landmark>& at) {
        float least = 1e9f;
        for (const Landmark& one : at)
            if (one.id != s.thing.id) least = std::min(least, apart(s, one));
        return least > 0.5f && least < 1e8f ? fmt::format(": {:.1f} m away", least) : "";
    }

    // "And hang a mirror there": where that stood which went.
    void check_there() {
        constexpr float kThere = 1.1f;  // metres
        if (!clause_.there || !talk_.last_gone || !talk_.last_gone_from.empty() || added_.size() != 1) return;
        const float off = length(added_.front()->box.center - *talk_.last_gone);
        if (off > kThere)
            missing_.push_back(fmt::format("{} is not there: {:.1f} m away", added_.front()->thing.id, off));
    }
    // "A bigger lamp", "two small pictures"
    void check_sizes() {
        for (std::size_t k = 0; k < mentions_.size(); ++k) {
            const Mention& m = mentions_[k];
            if (!is_head(k) || is_denied(m)) continue;
            std::size_t at = m.from;
            for (std::size_t i = k; i-- > 0 && mentions_[i].to == at && mentions_[i].kind == Mention::Kind::look;)
                at = mentions_[i].from;
            const std::string size = at > 0 ? words_[at - 1] : "";
            const bool large = is_one_of(size, {"big", "bigger", "large", "larger", "huge"});
            const bool small = is_one_of(size, {"small", "smaller", "tiny", "little"});
            for (const Shown* s : large || small ? called(added_, m) : std::vector<const Shown*>{}) {
                PromptObject usual;
                usual.kind = usual.words = kind_of(s->thing);
                const Vec3f is = s->thing.size_m, as = talk_.editor.usual_size(usual);
                constexpr float kSeen = 0.9f;  // of the extents' sum
                const float now = is.x + is.y + is.z, then = as.x + as.y + as.z;
                // A large one that was made smaller has the usual size at best.
                const float factor = s->thing.size_factor;
                const bool shrunk_again = large && s->thing.asked_size_m == Vec3f{} && factor < 1;
                if (then > 0 && (shrunk_again || (large ? now < kSeen * then : now > then / kSeen)))
                    missing_.push_back(
                        fmt::format("{} is not {}: {:.2f} x {:.2f} x {:.2f} m", s->thing.id, size, is.x, is.y, is.z));
            }
        }
    }

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
                   !is_definite(words_[at - 1]) && !relation_at(words_, at - 1))
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
    const Words& words_;
    const std::vector<Mention> mentions_;
    std::vector<const Shown*> added_, moved_, other_, gone_, along_;
    std::vector<const Material*> surfaces_;
    std::vector<std::string> missing_;
};

}  // namespace

void audit(Talk& talk, const Clause& clause, const Snapshot& before) {
    constexpr Verb kUnseen[] = {Verb::remark, Verb::keep, Verb::refuse, Verb::tidy};
    if (std::find(std::begin(kUnseen), std::end(kUnseen), clause.verb) != std::end(kUnseen)) return;
    const auto& changes = talk.editor.result().changes;
    const bool told = std::any_of(changes.begin() + static_cast<std::ptrdiff_t>(before.changes), changes.end(),
                                  [](const EditChange& c) { return c.id == kNotDone; });
    if (!told) Audit(talk, clause, before).tell();
}

}  // namespace fastscene::editing
