#include "fastscene/nn/gloo_group.h"

#ifdef FASTSCENE_GLOO
#include <gloo/context.h>

#include <chrono>

#include "fastscene/base/error.h"

namespace fastscene::nn {
namespace {

using namespace std::chrono_literals;

// Of a message: long enough for rank 0 to evaluate many held-out pictures while the others wait. A process that is lost
// is noticed long before, by its connections.
constexpr auto kMessageTimeout = 1h;
// For members of a new group to connect; one may be lost in that moment, too.
constexpr auto kConnectTimeout = 30s;
constexpr auto kLookForLosses = 100ms;
constexpr int kMessageTag = 0, kSentinelTag = 1;

// With another timeout while it connects than afterwards.
class Gloo final : public c10d::ProcessGroupGloo {
  public:
    static c10::intrusive_ptr<Gloo> open(const RendezvousRound& round, int rank,
                                         const c10::intrusive_ptr<c10d::Store>& store) {
        auto options = Options::create(kConnectTimeout);
        options->devices.push_back(createDeviceForHostname(round.address));
        auto group = c10::make_intrusive<Gloo>(store, rank, static_cast<int>(round.members.size()), options);
        options->timeout = kMessageTimeout;
        // What setTimeout() does; that would need Gloo to be linked, and libtorch may have one inside.
        for (const auto& context : group->contexts_) (*context).*(&OpenContext::timeout_) = kMessageTimeout;
        return group;
    }
    using ProcessGroupGloo::ProcessGroupGloo;

  private:
    struct OpenContext : ::gloo::Context {
        using ::gloo::Context::timeout_;
    };
};

}  // namespace

GlooGroup::GlooGroup(const RendezvousRound& round, int rank, const c10::intrusive_ptr<c10d::Store>& store)
    : rank_(rank), size_(static_cast<int>(round.members.size())), gloo_(Gloo::open(round, rank, store)) {
    for (int other = 0; other < size_; ++other) {
        if (other == rank_) continue;
        std::vector<at::Tensor> one{at::zeros({1}, at::kByte)};
        sentinels_[other] = gloo_->recv(one, other, kSentinelTag);
    }
    watcher_ = std::jthread([this](const std::stop_token& end) { watch(end); });
}

void GlooGroup::watch(const std::stop_token& end) {
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, end, kLookForLosses, [&] { return end.stop_requested(); })) {
        for (auto one = sentinels_.begin(); one != sentinels_.end();) try {
                one->second->abort();  // makes wait() return at once
                one->second->wait();
                ++one;
            } catch (const std::exception&) {
                for (const Message& message : in_flight_)
                    if (message.rank == one->first) message.work->abort();
                one = sentinels_.erase(one);
            }
    }
}

GlooGroup::Message GlooGroup::send(const at::Tensor& tensor, int to) {
    std::vector<at::Tensor> one{tensor};
    return {to, gloo_->send(one, to, kMessageTag)};
}

GlooGroup::Message GlooGroup::receive(const at::Tensor& tensor, int from) {
    std::vector<at::Tensor> one{tensor};
    return {from, gloo_->recv(one, from, kMessageTag)};
}

void GlooGroup::finish(std::vector<Message> messages) {
    struct Landing {
        GlooGroup& group;
        ~Landing() {
            const std::lock_guard lock(group.mutex_);
            group.in_flight_.clear();
        }
    } const landing{*this};
    {
        const std::lock_guard lock(mutex_);
        in_flight_ = messages;
        for (const Message& message : messages)
            if (!sentinels_.contains(message.rank)) message.work->abort();
    }
    for (const Message& message : messages)
        // What had arrived before it was aborted counts.
        if (!message.work->wait() && !message.work->wait(1ms)) throw Error("the connection was lost amid a message");
}

// Disseminated (Hensgen et al. 1988): after k rounds each has heard of 2^k.
void GlooGroup::barrier() {
    const at::Tensor out = at::zeros({1}, at::kByte), in = at::zeros({1}, at::kByte);
    for (int distance = 1; distance < size_; distance *= 2)
        finish({receive(in, (rank_ + size_ - distance) % size_), send(out, (rank_ + distance) % size_)});
}

// In a ring (Patarasuk & Yuan 2009): of n parts each is summed up on its way round, and goes round once more.
void GlooGroup::all_reduce_sum(const at::Tensor& tensor) {
    if (size_ == 1) return;
    const std::vector<at::Tensor> parts = tensor.tensor_split(size_);
    const auto part = [&](int i) { return parts[static_cast<std::size_t>((i + 2 * size_) % size_)]; };
    const int next = (rank_ + 1) % size_, previous = (rank_ + size_ - 1) % size_;
    const at::Tensor heard = at::empty_like(parts[0]);  // the longest part
    for (int i = 0; i < size_ - 1; ++i) {
        const at::Tensor sum = part(rank_ - i - 1), theirs = heard.slice(0, 0, sum.numel());
        finish({receive(theirs, previous), send(part(rank_ - i), next)});
        sum.add_(theirs);
    }
    for (int i = 0; i < size_ - 1; ++i) finish({receive(part(rank_ - i), previous), send(part(rank_ + 1 - i), next)});
}

// In a binomial tree: in each round those that have the values pass them on.
void GlooGroup::broadcast(const at::Tensor& tensor) {
    for (int having = 1; having < size_; having *= 2) {
        if (rank_ >= having && rank_ < 2 * having) finish({receive(tensor, rank_ - having)});
        else if (rank_ < having && rank_ + having < size_) finish({send(tensor, rank_ + having)});
    }
}

}  // namespace fastscene::nn
#endif
