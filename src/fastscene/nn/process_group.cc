#include "fastscene/nn/process_group.h"

#include "fastscene/nn/libtorch.h"

#ifdef FASTSCENE_GLOO
#include <gloo/context.h>

#include <torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>
#endif

#include <algorithm>
#include <chrono>
#include <numeric>
#include <tuple>

#include "fastscene/nn/connections.h"
#include "fastscene/nn/meeting.h"

namespace fastscene::nn {
namespace {

using Clock = std::chrono::steady_clock;
using Patience = std::chrono::milliseconds;
// Long enough for the first process to evaluate many held-out pictures while the others wait. A process that is lost is
// noticed long before, by its connections.
constexpr std::chrono::hours kPatience{1};
// For members of a new group to connect; one may be lost in that moment, too.
constexpr std::chrono::seconds kConnecting{30};
constexpr int kTriesToConnect = 5;

[[maybe_unused]] Place place_from(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    const std::string digits = colon == std::string::npos ? "" : text.substr(colon + 1);
    const bool number = !digits.empty() && digits.size() <= 5 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
    const int port = number ? std::stoi(digits) : 0;
    if (colon == 0 || port < 1 || port > 65535)
        throw UsageError("--meet: expected HOST:PORT of the first process, found \"{}\"", text);
    return {text.substr(0, colon), static_cast<std::uint16_t>(port)};
}

// Flattened into one vector and back: one message instead of one per tensor.
at::Tensor together(const std::vector<at::Tensor>& tensors) {
    std::vector<at::Tensor> flat;
    for (const at::Tensor& t : tensors) flat.push_back(t.detach().to(at::kCPU, at::kFloat).reshape(-1));
    return at::cat(flat);
}
void apart(const at::Tensor& all, const std::vector<at::Tensor>& tensors) {
    std::int64_t at = 0;
    for (const at::Tensor& t : tensors) {
        t.detach().copy_(all.slice(0, at, at + t.numel()).reshape(t.sizes()));
        at += t.numel();
    }
}

}  // namespace

#ifdef FASTSCENE_GLOO
// Gloo's group; its patience while it connects is another than afterwards.
class Gloo final : public c10d::ProcessGroupGloo {
  public:
    static c10::intrusive_ptr<Gloo> open(const Gathering& gathering, int rank,
                                         const c10::intrusive_ptr<c10d::Store>& store) {
        auto options = Options::create(kConnecting);
        options->devices.push_back(createDeviceForHostname(gathering.address));
        auto group = c10::make_intrusive<Gloo>(store, rank, static_cast<int>(gathering.members.size()), options);
        options->timeout = kPatience;
        // What setTimeout() does; that would need Gloo to be linked, and libtorch may have one inside.
        for (const auto& context : group->contexts_) (*context).*(&OpenContext::timeout_) = kPatience;
        return group;
    }
    using ProcessGroupGloo::ProcessGroupGloo;

  private:
    struct OpenContext : ::gloo::Context {
        using ::gloo::Context::timeout_;
    };
};

struct ProcessGroup::Connection {
    Meeting meeting;
    int process;
    c10::intrusive_ptr<Gloo> gloo;

    // Members of a new group, and who of them this is.
    std::pair<std::vector<int>, int> gather(const Run& run, const Wanted& wanted) {
        gloo.reset();  // closes connections: whoever still waits for this process notices
        for (int i = 1;; ++i) try {
                const Gathering all = meeting.gather(run, wanted);
                const auto me = std::find(all.members.begin(), all.members.end(), process) - all.members.begin();
                gloo = Gloo::open(all, static_cast<int>(me), meeting.shared(all));
                notice_silent_machines(meeting.port());
                return {all.members, static_cast<int>(me)};
            } catch (const Error&) {
                throw;
            } catch (const Stopped&) {
                throw;
            } catch (const std::exception& e) {
                if (i == kTriesToConnect)
                    throw Error("training: expected processes to connect to each other, found none to in {} tries: {}",
                                i, e.what());
            }
    }
    template <class Work>
    void wait(const char* what, const Work& work) const {
        try {
            if (!gloo) throw Error("not connected");
            work()->wait();
        } catch (const std::exception& e) {
            throw ProcessLost("training: expected all processes to {}, found one gone or unresponsive: {}", what,
                              e.what());
        }
    }
    void all_here() const {
        wait("come as far", [&] { return gloo->barrier(); });
    }
    void sum(std::vector<at::Tensor>& one) const {
        wait("send their gradients", [&] { return gloo->allreduce(one); });
    }
    void from_first(std::vector<at::Tensor>& one) const {
        wait("listen to the first", [&] { return gloo->broadcast(one); });
    }
};
#else
struct ProcessGroup::Connection {
    struct Nobody {
        bool has_newcomer() { return false; }
    } meeting;
    void all_here() const {}
    void sum(std::vector<at::Tensor>&) const {}
    void from_first(std::vector<at::Tensor>&) const {}
};
#endif

ProcessGroup::ProcessGroup() = default;
ProcessGroup::~ProcessGroup() = default;

std::unique_ptr<ProcessGroup> ProcessGroup::meet(const TrainingParams& params, const Run& run, double patience_s) {
    if (params.processes == 1) return nullptr;
    if (params.process >= params.processes)
        throw UsageError("--process: expected 0 to {}, found {}", params.processes - 1, params.process);
#ifndef FASTSCENE_GLOO
    throw UsageError("--processes: expected 1, since this libtorch is built without Gloo, found {}", params.processes);
#else
    const Place place = place_from(params.meet);
    std::vector<int> all(static_cast<std::size_t>(params.processes));
    std::iota(all.begin(), all.end(), 0);
    std::unique_ptr<ProcessGroup> group(new ProcessGroup);
    try {
        group->connection_.reset(
            new Connection{Meeting(place, params.process, params.processes, patience_s), params.process, {}});
    } catch (const std::exception& e) {
        throw Error("training: expected {} processes to join at {} within {:.0f} s: {}", params.processes, params.meet,
                    patience_s, e.what());
    }
    std::tie(group->members_, group->rank_) = group->connection_->gather(run, {all, patience_s, true});
    return group;
#endif
}

#ifdef FASTSCENE_GLOO
void ProcessGroup::meet_again(const Run& run, double patience_s) {
    std::tie(members_, rank_) = connection_->gather(run, {members_, patience_s, false});
}
#else
void ProcessGroup::meet_again(const Run&, double) {}
#endif

bool ProcessGroup::has_newcomer() { return connection_->meeting.has_newcomer(); }

void ProcessGroup::mean(const std::vector<at::Tensor>& tensors) {
    if (tensors.empty()) return;
    const at::NoGradGuard no_gradients;
    std::vector<at::Tensor> all{together(tensors)};
    const Clock::time_point ready = Clock::now();
    connection_->all_here();
    const Clock::time_point begin = Clock::now();
    connection_->sum(all);
    costs_.waiting_s += std::chrono::duration<double>(begin - ready).count();
    costs_.averaging_s += std::chrono::duration<double>(Clock::now() - begin).count();
    costs_.bytes += static_cast<std::int64_t>(all[0].nbytes());
    apart(all[0] / size(), tensors);
}

void ProcessGroup::from_first(const std::vector<at::Tensor>& tensors) {
    if (tensors.empty()) return;
    const at::NoGradGuard no_gradients;
    std::vector<at::Tensor> all{together(tensors)};
    connection_->from_first(all);
    apart(all[0], tensors);
}

std::int64_t ProcessGroup::from_first(std::int64_t number) {
    std::vector<at::Tensor> one{at::tensor(number, at::kLong)};
    const Clock::time_point begin = Clock::now();
    connection_->from_first(one);
    costs_.waiting_s += std::chrono::duration<double>(Clock::now() - begin).count();
    return one[0].item<std::int64_t>();
}

}  // namespace fastscene::nn
