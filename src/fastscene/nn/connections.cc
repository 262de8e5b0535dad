#include "fastscene/nn/connections.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>

#include "fastscene/base/leading_number.h"

namespace fastscene::nn {
namespace {

// An idle connection is probed from kIdle_s on; kProbes without an answer end it after kSilence_s.
constexpr int kIdle_s = 10, kEvery_s = 5, kProbes = 3;
static_assert(kIdle_s + kEvery_s * kProbes == kSilence_s);

struct Socket {
    int descriptor;
    ~Socket() { ::close(descriptor); }
};

std::string numeric_text(const sockaddr_storage& address, socklen_t size) {
    std::array<char, NI_MAXHOST> text{};
    const int failed = ::getnameinfo(reinterpret_cast<const sockaddr*>(&address), size, text.data(), text.size(),
                                     nullptr, 0, NI_NUMERICHOST);
    return failed ? "" : text.data();
}

// The port at the other end of a TCP connection; nothing if this is none.
std::optional<std::uint16_t> tcp_port_there(int descriptor) {
    int type = 0;
    socklen_t size = sizeof type;
    if (::getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_STREAM) return {};
    sockaddr_storage peer{};
    size = sizeof peer;
    if (::getpeername(descriptor, reinterpret_cast<sockaddr*>(&peer), &size) != 0) return {};
    if (peer.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(peer).sin_port);
    if (peer.ss_family == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6&>(peer).sin6_port);
    return {};
}

}  // namespace

std::optional<Route> route_to(const Endpoint& endpoint) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC, hints.ai_socktype = SOCK_DGRAM;
    addrinfo* found = nullptr;
    if (::getaddrinfo(endpoint.host.c_str(), std::to_string(endpoint.port).c_str(), &hints, &found) != 0) return {};
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> all(found, ::freeaddrinfo);
    for (const addrinfo* one = all.get(); one != nullptr; one = one->ai_next) {
        // Connecting a datagram socket sends nothing; it only chooses the route.
        const Socket probe{::socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC, one->ai_protocol)};
        if (probe.descriptor < 0 || ::connect(probe.descriptor, one->ai_addr, one->ai_addrlen) != 0) continue;
        sockaddr_storage here{}, there{};
        socklen_t here_size = sizeof here, there_size = sizeof there;
        if (::getsockname(probe.descriptor, reinterpret_cast<sockaddr*>(&here), &here_size) != 0) continue;
        if (::getpeername(probe.descriptor, reinterpret_cast<sockaddr*>(&there), &there_size) != 0) continue;
        return Route{numeric_text(here, here_size), numeric_text(there, there_size)};
    }
    return {};
}

bool is_loopback(const std::string& address) { return address.starts_with("127.") || address == "::1"; }

void notice_silent_machines(std::uint16_t port_of_store) {
    namespace fs = std::filesystem;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator("/proc/self/fd", none)) {
        const int descriptor = static_cast<int>(number_in(entry.path().filename().string()).value_or(-1));
        const std::optional<std::uint16_t> there = tcp_port_there(descriptor);
        if (!there) continue;
        const auto set = [&](int level, int option, int value) {
            ::setsockopt(descriptor, level, option, &value, sizeof value);
        };
        set(IPPROTO_TCP, TCP_USER_TIMEOUT, 1000 * kSilence_s);
        if (*there == port_of_store) continue;
        set(SOL_SOCKET, SO_KEEPALIVE, 1);
        set(IPPROTO_TCP, TCP_KEEPIDLE, kIdle_s);
        set(IPPROTO_TCP, TCP_KEEPINTVL, kEvery_s);
        set(IPPROTO_TCP, TCP_KEEPCNT, kProbes);
    }
}

}  // namespace fastscene::nn
