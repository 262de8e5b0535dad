// What TCP knows of other machines: by which address they are reached, and when one has fallen silent.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace fastscene::nn {

struct Place {
    std::string host;
    std::uint16_t port = 0;
};

// The addresses, in numbers, of the two ends of a connection.
struct Route {
    std::string here, there;
};
// Nothing if the host has no address, or none that this machine can reach.
std::optional<Route> route_to(const Place& place);

// Whether only processes of the same machine can use it.
bool is_loopback(const std::string& address);

// A connection to a machine that answers nothing for about so long is closed.
inline constexpr int kSilence_s = 25;
// So for all connections that this process has now. A system's default is hours. One to `port_of_store` is only closed
// while something sent waits for its receipt: libtorch's store ends the program if an idle one breaks.
void notice_silent_machines(std::uint16_t port_of_store);

}  // namespace fastscene::nn
