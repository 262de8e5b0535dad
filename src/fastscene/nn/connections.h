// What TCP knows about other machines: the address at which they are reached, and when one has fallen silent.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace fastscene::nn {

struct Endpoint {
    std::string host;
    std::uint16_t port = 0;
};

// The addresses, in numbers, of the two ends of a connection.
struct Route {
    std::string here, there;
};
// Nothing if the host has no address, or none that this machine can reach.
std::optional<Route> route_to(const Endpoint& endpoint);

// Whether only processes of the same machine can use it.
bool is_loopback(const std::string& address);

// A connection to a machine that has not answered for about this long is closed.
inline constexpr int kSilence_s = 25;
// Sets that for all open connections of this process; the system's default is hours. One to `port_of_store` is closed
// only while sent data is unacknowledged: libtorch's store ends the program if an idle connection breaks.
void notice_silent_machines(std::uint16_t port_of_store);

}  // namespace fastscene::nn
