#include "fastscene/nn/process_group.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <tuple>

#include "fastscene/nn/connections.h"
#include "fastscene/nn/gloo_group.h"
#include "fastscene/nn/rendezvous.h"

namespace fastscene::nn {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kConnectAttempts = 5;

[[maybe_unused]] Endpoint endpoint_from(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    const std::string digits = colon == std::string::npos ? "" : text.substr(colon + 1);
    const bool number = !digits.empty() && digits.size() <= 5 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
    const int port = number ? std::stoi(digits) : 0;
    if (colon == 0 || port < 1 || port > 65535)
        throw UsageError("--meet: expected HOST:PORT of the first process, found \"{}\"", text);
    return {text.substr(0, colon), static_cast<std::uint16_t>(port)};
}

// Into one vector and back: one message instead of one per tensor.
at::Tensor flatten(const std::vector<at::Tensor>& tensors) {
    std::vector<at::Tensor> flat;
    for (const at::Tensor& t : tensors) flat.push_back(t.detach().to(at::kCPU, at::kFloat).reshape(-1));
    return at::cat(flat);
}
void unflatten(const at::Tensor& all, const std::vector<at::Tensor>& tensors) {
    std::int64_t at = 0;
    for (const at::Tensor& t : tensors) {
        t.detach().copy_(all.slice(0, at, at + t.numel()).reshape(t.sizes()));
        at += t.numel();
    }
}

}  // namespace

#ifdef FASTSCENE_GLOO
struct ProcessGroup::Connection {
    Rendezvous rendezvous;
    int process;
    std::unique_ptr<GlooGroup> gloo;

    // The members of a new group, and the rank of this process.
    std::pair<std::vector<int>, int> connect(const Run& run, const Expected& expected) {
        gloo.reset();  // closes connections: whoever still waits for this process notices
        for (int i = 1;; ++i) try {
                const RendezvousRound round = rendezvous.next_round(run, expected);
                const auto me = std::find(round.members.begin(), round.members.end(), process);
                const int rank = static_cast<int>(me - round.members.begin());
                gloo = std::make_unique<GlooGroup>(round, rank, rendezvous.store_of(round));
                notice_silent_machines(rendezvous.port());
                return {round.members, rank};
            } catch (const Error&) {
                throw;
            } catch (const Stopped&) {
                throw;
            } catch (const std::exception& e) {
                if (i == kConnectAttempts)
                    throw Error("training: expected processes to connect to each other, found none to in {} tries: {}",
                                i, e.what());
            }
    }
    template <class Call>
    void together(const char* what, const Call& call) const {
        try {
            if (!gloo) throw Error("not connected");
            call(*gloo);
        } catch (const std::exception& e) {
            throw ProcessLost("training: expected all processes to {}, found one gone or unresponsive: {}", what,
                              e.what());
        }
    }
    void barrier() const {
        together("reach a barrier", [](GlooGroup& group) { group.barrier(); });
    }
    void all_reduce_sum(const at::Tensor& one) const {
        together("take part in an all-reduce", [&](GlooGroup& group) { group.all_reduce_sum(one); });
    }
    void broadcast(const at::Tensor& one) const {
        together("receive a broadcast", [&](GlooGroup& group) { group.broadcast(one); });
    }
};
#else
struct ProcessGroup::Connection {
    struct Nobody {
        bool has_newcomer() { return false; }
    } rendezvous;
    void barrier() const {}
    void all_reduce_sum(const at::Tensor&) const {}
    void broadcast(const at::Tensor&) const {}
};
#endif

ProcessGroup::ProcessGroup() = default;
ProcessGroup::~ProcessGroup() = default;

std::unique_ptr<ProcessGroup> ProcessGroup::join(const TrainingParams& params, const Run& run, double timeout_s) {
    if (params.processes == 1) return nullptr;
    if (params.process >= params.processes)
        throw UsageError("--process: expected 0 to {}, found {}", params.processes - 1, params.process);
#ifndef FASTSCENE_GLOO
    throw UsageError("--processes: expected 1, since this libtorch is built without Gloo, found {}", params.processes);
#else
    const Endpoint endpoint = endpoint_from(params.meet);
    std::vector<int> all(static_cast<std::size_t>(params.processes));
    std::iota(all.begin(), all.end(), 0);
    std::unique_ptr<ProcessGroup> group(new ProcessGroup);
    try {
        group->connection_.reset(
            new Connection{Rendezvous(endpoint, params.process, params.processes, timeout_s), params.process, {}});
    } catch (const std::exception& e) {
        throw Error("training: expected {} processes to join at {} within {:.0f} s: {}", params.processes, params.meet,
                    timeout_s, e.what());
    }
    std::tie(group->members_, group->rank_) = group->connection_->connect(run, {all, timeout_s, true});
    return group;
#endif
}

#ifdef FASTSCENE_GLOO
void ProcessGroup::rejoin(const Run& run, double timeout_s) {
    std::tie(members_, rank_) = connection_->connect(run, {members_, timeout_s, false});
}
#else
void ProcessGroup::rejoin(const Run&, double) {}
#endif

bool ProcessGroup::has_newcomer() { return connection_->rendezvous.has_newcomer(); }

void ProcessGroup::all_reduce_mean(const std::vector<at::Tensor>& tensors) {
    if (tensors.empty()) return;
    const at::NoGradGuard no_gradients;
    const at::Tensor all = flatten(tensors);
    const Clock::time_point ready = Clock::now();
    connection_->barrier();
    const Clock::time_point begin = Clock::now();
    connection_->all_reduce_sum(all);
    costs_.waiting_s += std::chrono::duration<double>(begin - ready).count();
    costs_.averaging_s += std::chrono::duration<double>(Clock::now() - begin).count();
    costs_.bytes += static_cast<std::int64_t>(all.nbytes());
    unflatten(all / world_size(), tensors);
}

void ProcessGroup::broadcast(const std::vector<at::Tensor>& tensors) {
    if (tensors.empty()) return;
    const at::NoGradGuard no_gradients;
    const at::Tensor all = flatten(tensors);
    connection_->broadcast(all);
    unflatten(all, tensors);
}

std::int64_t ProcessGroup::broadcast(std::int64_t number) {
    const at::Tensor one = at::tensor({number}, at::kLong);
    const Clock::time_point begin = Clock::now();
    connection_->broadcast(one);
    costs_.waiting_s += std::chrono::duration<double>(Clock::now() - begin).count();
    return one.item<std::int64_t>();
}

}  // namespace fastscene::nn
