// Whether what was put somewhere stands there, is as large as was said, and no less.
#include "fastscene/rooms/edit_audit_parts.h"

namespace fastscene::editing {

std::vector<const Shown*> Audit::subjects_of(std::size_t k) const {
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

std::vector<Landmark> Audit::landmarks_behind(std::size_t k) const {
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

bool Audit::holds(const Shown& s, std::string relation, const std::vector<Landmark>& at, float slack) const {
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
    // "Between them", of which only one was spoken of before.
    const auto others = std::count_if(at.begin(), at.end(), [&](const Landmark& l) { return l.id != s.thing.id; });
    if (relation == "between" && others < 2) return true;
    if (relation == "between") return is_between_those(s, at, at);
    // A lamp on a desk by the window is by the window.
    if (const Shown* under = after_.find(s.thing.on); under && relation != "on" && holds(*under, relation, at, slack))
        return true;
    return std::any_of(at.begin(), at.end(), [&](const Landmark& one) {
        return (one.id.empty() || one.id != s.thing.id) && holds_at(s, relation, one, slack);
    });
}

bool Audit::names_more_places(std::size_t k, std::size_t j) const {
    const std::size_t from = mentions_[std::max(k, j)].from;
    return from > 0 && is_joint(words_[from - 1]);
}

namespace {

// "Closer to the fireplace" is closer than it was.
bool is_nearer(const Mention& m, const Shown& now, const Shown& was, const std::vector<Landmark>& at) {
    constexpr float kSeen_m = 0.1f;
    return (m.term.starts_with("closer") || m.term.starts_with("nearer")) &&
           std::any_of(at.begin(), at.end(),
                       [&](const Landmark& one) { return apart(now, one) < apart(was, one) - kSeen_m; });
}

}  // namespace

void Audit::check_places() {
    if ((clause_.verb == Verb::turn || clause_.verb == Verb::face) && says_any({"slightly", "bit", "little"})) return;
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
            const bool there = holds(*s, m.meaning, at) || (was && holds(*was, m.meaning, at, kWhich)) ||
                               (was && is_nearer(m, *s, *was, at));
            any = any || there;
            if (!there) off.push_back(s);
        }
        // "On the desk and on both tables", "on the desk and the shelf": some here, some there.
        const auto is_at_another = [&](const Shown* one) {
            for (std::size_t j = 0; j < mentions_.size(); ++j) {
                const Mention& other = mentions_[j];
                if (j != k && other.kind == Mention::Kind::relation && names_more_places(k, j) &&
                    holds(*one, other.meaning, landmarks_behind(j)))
                    return true;
                const bool listed = j > k && other.kind == Mention::Kind::thing && other.from > 1 &&
                                    is_definite(words_[other.from - 1]) && is_joint(words_[other.from - 2]);
                if (listed && holds(*one, m.meaning, landmarks_called(talk_.editor, after_, other))) return true;
            }
            return false;
        };
        if (any) std::erase_if(off, is_at_another);
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
            std::copy_if(off.begin(), off.end(), std::back_inserter(far), [&](const Shown* s) { return !is_by(s); });
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

std::string Audit::how_far(const Shown& s, const std::vector<Landmark>& at) {
    float least = 1e9f;
    for (const Landmark& one : at)
        if (one.id != s.thing.id) least = std::min(least, apart(s, one));
    return least > 0.5f && least < 1e8f ? fmt::format(": {:.1f} m away", least) : "";
}

// "And hang a mirror there": where that stood which went.
void Audit::check_there() {
    constexpr float kThere = 1.1f;  // metres
    if (!clause_.there || !talk_.last_gone || !talk_.last_gone_from.empty() || added_.size() != 1) return;
    const float off = length(added_.front()->box.center - *talk_.last_gone);
    if (off > kThere) missing_.push_back(fmt::format("{} is not there: {:.1f} m away", added_.front()->thing.id, off));
}

// "A bigger lamp", "two small pictures"
void Audit::check_sizes() {
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
}  // namespace fastscene::editing
