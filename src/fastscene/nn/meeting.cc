#include "fastscene/nn/meeting.h"

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

constexpr auto kLookEvery = 50ms;

// In the store: who waits, as {"ticket": which time it waits, "first": address of process 0 as it is seen from there};
// the number of the last gathering; and each gathering, as {"tickets": {"0": "", "2": …}, "first": address}.
const std::string kLast = "gathering";
std::string waiting_key(int process) { return fmt::format("waiting/{}", process); }
std::string gathering_key(int number) { return fmt::format("gathering/{}", number); }

void put(c10d::Store& store, const std::string& key, const Json& value) {
    const std::string text = value.dump();
    store.set(key, std::vector<std::uint8_t>(text.begin(), text.end()));
}
// Null if there is none.
Json look(c10d::Store& store, const std::string& key) {
    if (!store.check({key})) return nullptr;
    const std::vector<std::uint8_t> text = store.get(key);
    return Json::parse(text.begin(), text.end());
}

// Differs each time that a process waits, also from that of one that died.
std::string new_ticket() {
    std::random_device chance;
    return fmt::format("{:08x}{:08x}", chance(), chance());
}

}  // namespace

Meeting::Meeting(const Place& place, int process, int processes, double patience_s)
    : place_(place), process_(process), processes_(processes) {
    c10d::TCPStoreOptions where;
    where.port = place.port;
    where.isServer = process == 0;
    where.numWorkers = static_cast<std::size_t>(processes);
    where.waitWorkers = false;
    where.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(1000 * patience_s));
    store_ = c10::make_intrusive<c10d::TCPStore>(place.host, where);
    notice_silent_machines(place.port);
}

Gathering Meeting::gather(const Run& run, const Wanted& wanted) {
    if (process_ == 0) return last_ = take_those_here(run, wanted);
    try {
        return last_ = wait_until_taken(run);
    } catch (const Stopped&) {
        throw;
    } catch (const std::exception& e) {
        throw Error(
            "training: expected process 0 at {}:{}, found it gone or done; what it saved is kept, and the same "
            "commands resume: {}",
            place_.host, place_.port, e.what());
    }
}

Gathering Meeting::take_those_here(const Run& run, const Wanted& wanted) {
    const auto end = Clock::now() + std::chrono::duration<double>(wanted.patience_s);
    const auto waits = [&](int process) { return process == 0 || store_->check({waiting_key(process)}); };
    for (;;) {
        const auto here = std::count_if(wanted.processes.begin(), wanted.processes.end(), waits);
        if (here == static_cast<std::ptrdiff_t>(wanted.processes.size())) break;
        if (Clock::now() >= end && wanted.all)
            throw Error("training: expected {} processes to join at {}:{} within {:.0f} s, found {}",
                        wanted.processes.size(), place_.host, place_.port, wanted.patience_s, here);
        if (Clock::now() >= end) break;
        run.check_stop();
        std::this_thread::sleep_for(kLookEvery);
    }
    Gathering all{last_.number + 1, {0}, {}};
    Json tickets{{"0", ""}};
    for (int process = 1; process < processes_; ++process) {
        const Json one = look(*store_, waiting_key(process));
        if (one.is_null()) continue;
        store_->deleteKey(waiting_key(process));
        all.members.push_back(process);
        tickets[std::to_string(process)] = one.at("ticket");
        // Other machines cannot use the address that this one's own processes reach.
        const std::string first = one.at("first");
        if (all.address.empty() || is_loopback(all.address)) all.address = first;
    }
    if (all.address.empty()) all.address = "127.0.0.1";  // nobody else is here
    put(*store_, gathering_key(all.number), {{"tickets", tickets}, {"first", all.address}});
    put(*store_, kLast, all.number);
    return all;
}

Gathering Meeting::wait_until_taken(const Run& run) {
    const std::optional<Route> route = route_to(place_);
    if (!route) throw Error("no address of {}", place_.host);
    const std::string ticket = new_ticket(), me = std::to_string(process_);
    put(*store_, waiting_key(process_), {{"ticket", ticket}, {"first", route->there}});
    for (;; std::this_thread::sleep_for(kLookEvery)) {
        run.check_stop();
        const Json last = look(*store_, kLast);
        if (last.is_null()) continue;
        const Json gathering = look(*store_, gathering_key(last.get<int>()));
        const Json& tickets = gathering.at("tickets");
        if (!tickets.contains(me) || tickets[me] != ticket) continue;
        Gathering all{last.get<int>(), {}, is_loopback(route->here) ? gathering.at("first") : Json(route->here)};
        for (const auto& [process, any] : tickets.items()) all.members.push_back(std::stoi(process));
        return all;
    }
}

bool Meeting::has_newcomer() {
    for (int process = 1; process < processes_; ++process) {
        const bool is_member = std::binary_search(last_.members.begin(), last_.members.end(), process);
        if (!is_member && store_->check({waiting_key(process)})) return true;
    }
    return false;
}

c10::intrusive_ptr<c10d::Store> Meeting::shared(const Gathering& gathering) const {
    return c10::make_intrusive<c10d::PrefixStore>(fmt::format("group/{}", gathering.number), store_);
}

}  // namespace fastscene::nn
#endif
