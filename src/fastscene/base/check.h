// Checks: a failed check is a programming error, never the user's (for that see error.h).
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace fastscene {

// Thrown by FASTSCENE_CHECK: an assumption of the program is violated.
struct CheckFailed : std::logic_error {
    using std::logic_error::logic_error;
};

namespace detail {
template <class A, class B>
[[noreturn]] void check_failed(const char* file, int line, const char* text, const A& a, const B& b) {
    std::ostringstream message;
    message << file << ':' << line << ": check failed: " << text << " (" << a << " vs. " << b << ')';
    throw CheckFailed(message.str());
}
[[noreturn]] inline void check_failed(const char* file, int line, const char* text) {
    throw CheckFailed(std::string(file) + ':' + std::to_string(line) + ": check failed: " + text);
}
}  // namespace detail
}  // namespace fastscene

#define FASTSCENE_CHECK(condition)                                                           \
    do {                                                                                     \
        if (!(condition)) ::fastscene::detail::check_failed(__FILE__, __LINE__, #condition); \
    } while (false)

#define FASTSCENE_CHECK_EQ(a, b)                                                                      \
    do {                                                                                              \
        if (!((a) == (b))) ::fastscene::detail::check_failed(__FILE__, __LINE__, #a " == " #b, a, b); \
    } while (false)
