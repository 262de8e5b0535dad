// What the studio answers when it does not do what a page asks: an HTTP status and a sentence for the user.
#pragma once

#include <utility>

#include "fastscene/base/error.h"

namespace fastscene::studio {

struct Refusal : Error {
    template <class... Args>
    explicit Refusal(int http_status, fmt::format_string<Args...> format, Args&&... args)
        : Error("{}", fmt::format(format, std::forward<Args>(args)...)), status(http_status) {}
    int status;
};

}  // namespace fastscene::studio
