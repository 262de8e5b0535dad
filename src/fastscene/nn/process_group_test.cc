// Processes that train together, as threads of one: one is lost, one comes back.
#include "fastscene/nn/process_group.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <future>
#include <latch>
#include <thread>

#include "fastscene/base/leading_number.h"
#include "fastscene/nn/connections.h"
#include "fastscene/nn/rendezvous.h"

namespace fastscene::nn {
namespace {

// Three processes with the same endpoint.
struct Three {
    TrainingParams params;
    Three() {
        std::signal(SIGPIPE, SIG_IGN);  // as the program does: Gloo writes to connections that were lost
        const int s = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in at{};
        at.sin_family = AF_INET, at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof at;
        EXPECT_EQ(::bind(s, reinterpret_cast<sockaddr*>(&at), sizeof at), 0);
        EXPECT_EQ(::getsockname(s, reinterpret_cast<sockaddr*>(&at), &size), 0);
        ::close(s);
        params.processes = 3;
        params.meet = fmt::format("localhost:{}", ntohs(at.sin_port));
    }
    std::uint16_t port() const {
        return static_cast<std::uint16_t>(std::stoi(params.meet.substr(params.meet.find(':') + 1)));
    }
    std::unique_ptr<ProcessGroup> join(int process) const {
        TrainingParams mine = params;
        mine.process = process;
        return ProcessGroup::join(mine, {}, 30);
    }
};

float mean_of(ProcessGroup& group, float mine) {
    const at::Tensor one = at::full({3}, mine);
    group.all_reduce_mean({one});
    return one[2].item<float>();
}

TEST(ProcessGroup, ContinuesWithoutALostProcessAndReadmitsIt) {
    const Three three;
    std::latch without_two(2);
    const auto member = [&](int process) {
        const auto group = three.join(process);
        EXPECT_EQ(group->world_size(), 3);
        EXPECT_EQ(group->rank(), process);
        EXPECT_EQ(mean_of(*group, static_cast<float>(process)), 1);
        EXPECT_THROW(mean_of(*group, 0), ProcessLost);
        group->rejoin({}, 1);
        EXPECT_EQ(group->members(), (std::vector<int>{0, 1}));
        EXPECT_EQ(mean_of(*group, static_cast<float>(process)), 0.5);
        without_two.count_down();
        for (bool back = false; !back;) back = group->broadcast(process == 0 && group->has_newcomer());
        group->rejoin({}, 30);
        EXPECT_EQ(group->members(), (std::vector<int>{0, 1, 2}));
        EXPECT_EQ(mean_of(*group, static_cast<float>(process)), 1);
        EXPECT_EQ(group->take_costs().bytes, 3 * 3 * 4);  // three means were taken
        EXPECT_EQ(group->take_costs().bytes, 0);
    };
    auto zero = std::async(std::launch::async, member, 0), one = std::async(std::launch::async, member, 1);
    {
        const auto two = three.join(2);
        EXPECT_EQ(mean_of(*two, 2), 1);
    }
    without_two.wait();
    const auto two = three.join(2);
    EXPECT_EQ(two->world_size(), 3);
    EXPECT_EQ(mean_of(*two, 2), 1);
    zero.get();
    one.get();
}

// Ends this process's TCP connections but those to or from a port.
void break_connections_except(std::uint16_t port) {
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
        const auto descriptor = static_cast<int>(number_in(entry.path().filename().string()).value_or(-1));
        sockaddr_in here{}, there{};
        socklen_t here_size = sizeof here, there_size = sizeof there;
        if (::getsockname(descriptor, reinterpret_cast<sockaddr*>(&here), &here_size) != 0 ||
            ::getpeername(descriptor, reinterpret_cast<sockaddr*>(&there), &there_size) != 0)
            continue;
        if (ntohs(here.sin_port) != port && ntohs(there.sin_port) != port) ::shutdown(descriptor, SHUT_RDWR);
    }
}

// Gloo itself says nothing to whoever has a message half sent or half received.
TEST(ProcessGroup, NoticesALossAmidAMessage) {
    constexpr std::int64_t kLong = 1 << 24;  // a message that takes a while
    const Three three;
    std::atomic<int> exchanging = 0;
    const auto member = [&](int process) {
        const auto group = three.join(process);
        const at::Tensor gradients = at::ones({kLong});
        for (int i = 0; process > 0 || i < 12; ++i) {
            EXPECT_THROW(
                for (;;) {
                    ++exchanging;
                    group->all_reduce_mean({gradients});
                    ++exchanging;
                    group->broadcast({gradients});
                },
                ProcessLost);
            try {
                group->rejoin({}, 30);
            } catch (const Error&) {  // process 0 has seen enough
                EXPECT_GT(process, 0);
                return;
            }
            EXPECT_EQ(group->world_size(), 3);
        }
    };
    std::vector<std::future<void>> members;
    for (int process = 0; process < 3; ++process) members.push_back(std::async(std::launch::async, member, process));
    const auto done = [&](std::chrono::milliseconds wait) {
        return members[0].wait_for(wait) == std::future_status::ready;
    };
    while (!done(std::chrono::milliseconds(1))) {
        const int before = exchanging;
        while (exchanging < before + 6 && !done(std::chrono::milliseconds(1))) {
        }
        done(std::chrono::milliseconds(before * 37 % 400));  // amid something else each time
        break_connections_except(three.port());
    }
    for (auto& one : members) one.get();
}

TEST(ProcessGroup, EndsWithoutProcessZero) {
    const Three three;
    const auto other = [&](int process) {
        const auto group = three.join(process);
        EXPECT_EQ(mean_of(*group, static_cast<float>(process)), 1);
        EXPECT_THROW(mean_of(*group, 0), ProcessLost);
        EXPECT_THROW(group->rejoin({}, 1), Error);
    };
    auto one = std::async(std::launch::async, other, 1), two = std::async(std::launch::async, other, 2);
    {
        const auto zero = three.join(0);
        EXPECT_EQ(mean_of(*zero, 0), 1);
    }
    one.get();
    two.get();
}

TEST(ProcessGroup, ProcessZeroDoesNotWaitForever) {
    Three three;
    const auto one = std::async(std::launch::async, [&] { EXPECT_THROW(three.join(1), Error); });
    try {
        ProcessGroup::join(three.params, {}, 2);
        FAIL() << "joined without the third";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("expected 3 processes to join"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("found 2"), std::string::npos) << e.what();
    }
}

#ifdef FASTSCENE_GLOO
TEST(Rendezvous, AdmitsAgainWhoMissedItsRound) {
    const Three three;
    const Endpoint endpoint{"localhost", three.port()};
    Rendezvous first(endpoint, 0, 2, 30);
    auto second = std::async(std::launch::async, [&] {
        Rendezvous rendezvous(endpoint, 1, 2, 30);
        RendezvousRound round;
        do round = rendezvous.next_round({}, {});
        while (round.number == 1);  // if it was quick enough
        return round;
    });
    EXPECT_EQ(first.next_round({}, {{0, 1}, 30, true}).members, (std::vector<int>{0, 1}));
    EXPECT_EQ(first.next_round({}, {{0}, 0, false}).members, std::vector<int>{0});  // before the other looks again
    EXPECT_EQ(first.next_round({}, {{0, 1}, 30, true}).number, 3);
    EXPECT_EQ(second.get().number, 3);
    EXPECT_FALSE(first.has_newcomer());
}
#endif

TEST(Connections, KnowTheirAddresses) {
    const std::optional<Route> route = route_to({"localhost", 20000});
    ASSERT_TRUE(route);
    EXPECT_TRUE(is_loopback(route->here));
    EXPECT_TRUE(is_loopback(route->there));
    EXPECT_FALSE(is_loopback("10.0.0.1"));
    EXPECT_FALSE(route_to({"no-such-host.invalid", 20000}));
}

}  // namespace
}  // namespace fastscene::nn
