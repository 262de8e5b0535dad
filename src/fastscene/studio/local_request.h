// Which requests a web server on this machine answers: a page of another site must not read or change anything through
// the visitor's browser (DNS rebinding, cross-site posts).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene::studio {

// Why a request is refused, as a sentence; nothing if it may be answered. `hosts` and `origins` are the values of all
// Host and Origin headers. The host must be a name of the loopback interface, at any port (it may be tunneled); an
// origin, where the browser names one, must be that same host.
std::optional<std::string> refusal(const std::vector<std::string>& hosts, const std::vector<std::string>& origins);

}  // namespace fastscene::studio
