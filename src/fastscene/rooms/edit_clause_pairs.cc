// Two clauses that say one thing: "keep two and remove the rest", "take it away and put a bench in its place".
#include <algorithm>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {

// "everything but the sofa", "all pictures but the largest one"
bool says_all(const Words& words) {
    return std::any_of(words.begin(), words.end(), [](const std::string& w) {
        return is_one_of(w, {"everything", "all", "every", "each"});
    });
}

// Where words take back what was said before, past them; 0: none do.
std::size_t taken_back_at(const Words& words, std::size_t at) {
    if (at == 0 || is_joint(words[at])) return 0;
    std::size_t next = at + correction_at(words, at, false);
    if (next == at) next = at + correction_at(words, at, true);
    if (next == at) return 0;
    next = past_polite(words, next);
    const bool begins = next < words.size() && beginning_at(words, next);
    return correction_at(words, at, begins);
}

namespace {

// "I don't like the rug, make it blue": it stays, and is blue. "The table needs a vase, add a red one": one vase.
void disliked(Clause& clause, const Clause& next) {
    const bool needs = clause.verb == Verb::want && find_word(clause.words, {"needs", "need"}, 1) < clause.words.size();
    const bool put = is_one_of(next.words.empty() ? "" : next.words.front(), {"it", "them"}) &&
                     (next.verb == Verb::put || next.verb == Verb::move);
    if (needs && (put || (find_word(next.words, {"one", "ones"}, 1) < next.words.size() && begins_anew(next.words)))) {
        clause.verb = Verb::remark;
        return;
    }
    const bool dislikes = clause.verb == Verb::remove && clause.said.starts_with("i d") &&
                          (clause.said.ends_with("like") || next.verb == Verb::remove);
    if (!dislikes || find_word(next.words, {"it", "them", "they", "one", "ones"}) == next.words.size()) return;
    clause.words.insert(clause.words.begin(), {"i", "dislike"});
    clause.verb = Verb::remark;
}

// "Remove everything from the desk but leave the lamp": everything except the lamp.
bool leaves_some(Clause& clause, const Clause& next) {
    const bool takes = clause.verb == Verb::clear || (clause.verb == Verb::remove && says_all(clause.words));
    if (!takes || next.verb != Verb::keep || next.words.empty() || has_word(next.words, {"rest", "others", "else"}) ||
        has_word(clause.words, {"except"}) ||
        (next_place(next.words) < next.words.size() && !is_one_of(next.words[1], {"one", "ones"})))
        return false;
    Words kept = next.words;
    while (kept.size() > 1 && is_one_of(kept.back(), {"there", "alone", "only", "is", "are", "it", "they", "as",
                                                      "where", "though", "standing"}))
        kept.pop_back();
    clause.words.push_back("except");
    clause.words.insert(clause.words.end(), kept.begin(), kept.end());
    return true;
}

// "Keep two chairs and remove the rest": only those stay.
bool takes_the_rest(Clause& clause, const Clause& next) {
    if (clause.verb != Verb::keep || next.verb != Verb::remove || clause.words.empty()) return false;
    if (!says_the_rest(next.words)) return false;
    const bool only = is_one_of(clause.words.front(), {"only", "just"});
    if (!only && (!number_said(clause.words.front()) || is_one_of(clause.words.front(), {"a", "an"}))) return false;
    if (!only) clause.words.insert(clause.words.begin(), "only");
    return true;
}

// "Take away two chairs and put a bench in their place": a bench for two chairs.
bool comes_in_place(Clause& clause, const Clause& next) {
    if (clause.verb != Verb::remove || !next.its_place || (next.verb != Verb::put && next.verb != Verb::add))
        return false;
    if (!begins_anew(next.words) || next_place(next.words) < next.words.size() || clause.taken_back) return false;
    if (has_word(clause.words, {"with", "and", ",", "except", "everything"}) || clause.words.empty()) return false;
    clause.verb = Verb::replace, clause.said = "replace";
    clause.words = joined_words(joined_words(clause.words, {"with"}), next.words);
    return true;
}

// "Two chairs, no, three": one clause.
void amend(std::vector<Clause>& clauses) {
    for (std::size_t i = 1; i < clauses.size();)
        if (clauses[i].amends) {
            clauses[i - 1] = amended(clauses[i - 1], clauses[i]);
            clauses.erase(clauses.begin() + static_cast<std::ptrdiff_t>(i));
        } else ++i;
}

}  // namespace

void join_clauses(std::vector<Clause>& clauses) {
    for (std::size_t i = 0; i + 1 < clauses.size();)
        if (Clause& one = clauses[i], &next = clauses[i + 1];
            leaves_some(one, next) || takes_the_rest(one, next) || comes_in_place(one, next))
            clauses.erase(clauses.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        else disliked(one, next), ++i;
    amend(clauses);
}

}  // namespace fastscene::editing
