// Several wishes: those that can be done are done, the others are told.
#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "fastscene/base/error.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

struct Failure {
    std::string words, why;
    bool already = false;  // it is so as it is
    std::exception_ptr error;
};

// All of them at once; the first says whether the sentence was wrong or the room.
[[noreturn]] void throw_all(const std::vector<Failure>& failures) {
    if (failures.size() == 1) std::rethrow_exception(failures.front().error);
    const auto first = std::find_if(failures.begin(), failures.end(), [](const Failure& f) { return !f.already; });
    if (first == failures.end()) std::rethrow_exception(failures.front().error);
    std::string all;
    for (const Failure& f : failures)
        if (all.find(f.why) == std::string::npos) all += (all.empty() ? "" : "; ") + f.why;
    try {
        std::rethrow_exception(first->error);
    } catch (const UsageError&) {
        throw UsageError("{}", all);
    } catch (const Error&) {
        throw Error("{}", all);
    }
}

}  // namespace

void do_each(Editor& editor, std::size_t count, const std::function<void(std::size_t)>& act,
             const std::function<std::string(std::size_t)>& words) {
    std::vector<Failure> failures;
    const std::size_t before = editor.deeds();
    for (std::size_t i = 0; i < count; ++i) {
        const auto failed = [&](const Error& e, bool already) {
            failures.push_back({words ? words(i) : "", e.what(), already, std::current_exception()});
        };
        try {
            act(i);
        } catch (const AlreadySo& e) {
            failed(e, true);
        } catch (const Error& e) {
            failed(e, false);
        }
    }
    if (failures.empty()) return;
    if (editor.deeds() == before) throw_all(failures);
    for (const Failure& f : failures)
        if (f.already) editor.note("room", f.why);
        else editor.note(kNotDone, f.words.empty() ? f.why : fmt::format("\"{}\": {}", f.words, f.why));
}

}  // namespace fastscene::editing
