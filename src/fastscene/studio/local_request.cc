#include "fastscene/studio/local_request.h"

#include <algorithm>
#include <array>

namespace fastscene::studio {
namespace {

std::string lower(std::string_view text) {
    std::string out{text};
    std::ranges::transform(out, out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return out;
}

bool is_port(std::string_view text) {
    constexpr size_t kMaxDigits = 5;  // 65535
    return !text.empty() && text.size() <= kMaxDigits &&
           std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

// `host` in lower case: a name of the loopback interface, alone or with a port.
bool is_loopback(std::string_view host) {
    constexpr std::array<std::string_view, 3> kNames{"127.0.0.1", "localhost", "[::1]"};
    return std::ranges::any_of(kNames, [&](std::string_view name) {
        if (!host.starts_with(name)) return false;
        const std::string_view rest = host.substr(name.size());
        return rest.empty() || (rest.front() == ':' && is_port(rest.substr(1)));
    });
}

}  // namespace

std::optional<std::string> refusal(const std::vector<std::string>& hosts, const std::vector<std::string>& origins) {
    if (hosts.size() != 1) return "expected one Host header";
    const std::string host = lower(hosts.front());
    if (!is_loopback(host)) return "expected the host 127.0.0.1 or localhost: open the address that was printed";
    const bool same_origin = std::ranges::all_of(
        origins, [&](const std::string& origin) { return lower(origin) == "http://" + host; });
    if (!same_origin) return "the request comes from a page of another site";
    return std::nullopt;
}

}  // namespace fastscene::studio
