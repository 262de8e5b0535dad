#include "fastscene/nn/process_group.h"

#include "fastscene/nn/libtorch.h"

#ifdef FASTSCENE_GLOO
#include <torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>
#include <torch/csrc/distributed/c10d/TCPStore.hpp>
#endif

#include <chrono>

#include "fastscene/base/error.h"

namespace fastscene::nn {
namespace {

using Patience = std::chrono::milliseconds;
// long enough for the first process to evaluate many held-out pictures while the others wait
constexpr double kPatience_s = 3600;

struct Place {
    std::string host;
    std::uint16_t port;
};
Place place_from(const std::string& text) {
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
struct ProcessGroup::Connection {
    c10::intrusive_ptr<c10d::TCPStore> store;
    c10::intrusive_ptr<c10d::ProcessGroupGloo> gloo;

    static std::unique_ptr<Connection> open(const Place& place, const TrainingParams& params, double patience_s) {
        const auto in_ms = [](double s) { return Patience(static_cast<std::int64_t>(1000 * s)); };
        auto group = std::make_unique<Connection>();
        c10d::TCPStoreOptions where;
        where.port = place.port;
        where.isServer = params.process == 0;
        where.numWorkers = static_cast<std::size_t>(params.processes);
        where.timeout = in_ms(patience_s);
        group->store = c10::make_intrusive<c10d::TCPStore>(place.host, where);
        auto options = c10d::ProcessGroupGloo::Options::create(in_ms(kPatience_s));
        options->devices.push_back(c10d::ProcessGroupGloo::createDefaultDevice());
        group->gloo = c10::make_intrusive<c10d::ProcessGroupGloo>(group->store, params.process, params.processes,
                                                                  options);
        return group;
    }
    template <class Work>
    void wait(const char* what, const Work& work) const {
        try {
            work()->wait();
        } catch (const std::exception& e) {
            throw Error("training: expected all processes to {}, found one gone or unresponsive: {}", what, e.what());
        }
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
    static std::unique_ptr<Connection> open(const Place&, const TrainingParams&, double) { return nullptr; }
    void sum(std::vector<at::Tensor>&) const {}
    void from_first(std::vector<at::Tensor>&) const {}
};
#endif

ProcessGroup::ProcessGroup(std::unique_ptr<Connection> group, int size, int process)
    : group_(std::move(group)), size_(size), process_(process) {}
ProcessGroup::~ProcessGroup() = default;

std::unique_ptr<ProcessGroup> ProcessGroup::meet(const TrainingParams& params, double patience_s) {
    if (params.processes == 1) return nullptr;
    if (params.process >= params.processes)
        throw UsageError("--process: expected 0 to {}, found {}", params.processes - 1, params.process);
#ifndef FASTSCENE_GLOO
    throw UsageError("--processes: expected 1, since this libtorch is built without Gloo, found {}", params.processes);
#endif
    const Place place = place_from(params.meet);
    std::unique_ptr<Connection> group;
    try {
        group = Connection::open(place, params, patience_s);
    } catch (const std::exception& e) {
        throw Error("training: expected {} processes to join at {} within {:.0f} s: {}", params.processes, params.meet,
                    patience_s, e.what());
    }
    return std::unique_ptr<ProcessGroup>(new ProcessGroup(std::move(group), params.processes, params.process));
}

void ProcessGroup::mean(const std::vector<at::Tensor>& tensors) const {
    if (tensors.empty()) return;
    const at::NoGradGuard no_gradients;
    std::vector<at::Tensor> all{together(tensors)};
    group_->sum(all);
    apart(all[0] / size_, tensors);
}

void ProcessGroup::from_first(const std::vector<at::Tensor>& tensors) const {
    if (tensors.empty()) return;
    const at::NoGradGuard no_gradients;
    std::vector<at::Tensor> all{together(tensors)};
    group_->from_first(all);
    apart(all[0], tensors);
}

std::int64_t ProcessGroup::from_first(std::int64_t number) const {
    std::vector<at::Tensor> one{at::tensor(number, at::kLong)};
    group_->from_first(one);
    return one[0].item<std::int64_t>();
}

}  // namespace fastscene::nn
