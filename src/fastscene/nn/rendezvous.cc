#include "fastscene/nn/rendezvous.h"

#ifdef FASTSCENE_GLOO
#include <algorithm>
#include <chrono>
#include <random>
#include <thread>
#include <torch/csrc/distributed/c10d/PrefixStore.hpp>

#include "fastscene/base/json.h"

namespace fastscene::nn {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kPollInterval = 50ms;

// In the store: the last registration of each process, as {"ticket": of this registration, "first": address of process
// 0 as seen from there}; the number of the last round; and each round, as {"tickets": {"0": "", "2": …}, "first":
// address}. Nothing is ever deleted: a process may register anew just then.
const std::string kLastRound = "round";
std::string registration_key(int process) { return fmt::format("registered/{}", process); }
std::string round_key(int number) { return fmt::format("round/{}", number); }

void set(c10d::Store& store, const std::string& key, const Json& value) {
    const std::string text = value.dump();
    store.set(key, std::vector<std::uint8_t>(text.begin(), text.end()));
}
// Null if there is none.
Json get(c10d::Store& store, const std::string& key) {
    if (!store.check({key})) return nullptr;
    const std::vector<std::uint8_t> text = store.get(key);
    return Json::parse(text.begin(), text.end());
}

// Differs for each registration, also from that of a process that died.
std::string new_ticket() {
    std::random_device random;
    return fmt::format("{:08x}{:08x}", random(), random());
}

}  // namespace

Rendezvous::Rendezvous(const Endpoint& endpoint, int process, int processes, double timeout_s)
    : endpoint_(endpoint), process_(process), processes_(processes) {
    c10d::TCPStoreOptions options;
    options.port = endpoint.port;
    options.isServer = process == 0;
    options.numWorkers = static_cast<std::size_t>(processes);
    options.waitWorkers = false;
    options.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(1000 * timeout_s));
    store_ = c10::make_intrusive<c10d::TCPStore>(endpoint.host, options);
    notice_silent_machines(endpoint.port);
}

RendezvousRound Rendezvous::next_round(const Run& run, const Expected& expected) {
    if (process_ == 0) return last_ = admit(run, expected);
    try {
        return last_ = wait_to_be_admitted(run);
    } catch (const Stopped&) {
        throw;
    } catch (const std::exception& e) {
        throw Error(
            "training: expected process 0 at {}:{}, found it gone or done; what it saved is kept, and the same "
            "commands resume: {}",
            endpoint_.host, endpoint_.port, e.what());
    }
}

RendezvousRound Rendezvous::admit(const Run& run, const Expected& expected) {
    const auto deadline = Clock::now() + std::chrono::duration<double>(expected.timeout_s);
    const auto is_registered = [&](int process) { return process == 0 || !registration_of(process).is_null(); };
    for (;;) {
        const auto here = std::count_if(expected.processes.begin(), expected.processes.end(), is_registered);
        if (here == static_cast<std::ptrdiff_t>(expected.processes.size())) break;
        if (Clock::now() >= deadline && expected.all_required)
            throw Error("training: expected {} processes to join at {}:{} within {:.0f} s, found {}",
                        expected.processes.size(), endpoint_.host, endpoint_.port, expected.timeout_s, here);
        if (Clock::now() >= deadline) break;
        run.check_stop();
        std::this_thread::sleep_for(kPollInterval);
    }
    RendezvousRound round{last_.number + 1, {0}, {}};
    Json tickets{{"0", ""}};
    for (int process = 1; process < processes_; ++process) {
        const Json one = registration_of(process);
        if (one.is_null()) continue;
        round.members.push_back(process);
        tickets[std::to_string(process)] = one.at("ticket");
        admitted_[process] = one.at("ticket");
        // Other machines cannot use the address that this one's own processes reach.
        const std::string first = one.at("first");
        if (round.address.empty() || is_loopback(round.address)) round.address = first;
    }
    if (round.address.empty()) round.address = "127.0.0.1";  // nobody else is here
    set(*store_, round_key(round.number), {{"tickets", tickets}, {"first", round.address}});
    set(*store_, kLastRound, round.number);
    return round;
}

RendezvousRound Rendezvous::wait_to_be_admitted(const Run& run) {
    const std::optional<Route> route = route_to(endpoint_);
    if (!route) throw Error("no address of {}", endpoint_.host);
    const std::string me = std::to_string(process_);
    std::string ticket;
    for (int number = last_round();; std::this_thread::sleep_for(kPollInterval)) {
        run.check_stop();
        // Where this process was admitted, but too late to join before the others gave it up, it registers anew.
        if (ticket.empty()) {
            ticket = new_ticket();
            set(*store_, registration_key(process_), {{"ticket", ticket}, {"first", route->there}});
        }
        for (const int last = last_round(); number < last;) {
            const Json found = get(*store_, round_key(++number));
            const Json& tickets = found.at("tickets");
            if (!tickets.contains(me) || tickets[me] != ticket) continue;
            if (number < last) {
                ticket.clear();
                continue;
            }
            RendezvousRound round{number, {}, is_loopback(route->here) ? found.at("first") : Json(route->here)};
            for (const auto& [process, any] : tickets.items()) round.members.push_back(std::stoi(process));
            return round;
        }
    }
}

int Rendezvous::last_round() const {
    const Json last = get(*store_, kLastRound);
    return last.is_null() ? 0 : last.get<int>();
}

// Null if there is none that was not admitted yet.
Json Rendezvous::registration_of(int process) const {
    const Json last = get(*store_, registration_key(process));
    const auto admitted = admitted_.find(process);
    return last.is_null() || (admitted != admitted_.end() && last.at("ticket") == admitted->second) ? Json() : last;
}

bool Rendezvous::has_newcomer() {
    for (int process = 1; process < processes_; ++process) {
        const bool is_member = std::binary_search(last_.members.begin(), last_.members.end(), process);
        if (!is_member && !registration_of(process).is_null()) return true;
    }
    return false;
}

c10::intrusive_ptr<c10d::Store> Rendezvous::store_of(const RendezvousRound& round) const {
    return c10::make_intrusive<c10d::PrefixStore>(fmt::format("group/{}", round.number), store_);
}

}  // namespace fastscene::nn
#endif
