// GlooGroup: collectives of the processes of one round, over libtorch's Gloo backend, that end when a process is lost.
//
// Gloo tells the loss of a connection to whoever waits for a message to begin, but not to whoever is in the middle of
// one: it was taken off the list of what is pending, and stays half sent or half received until the timeout
// (Pair::signalException in gloo/transport/tcp/pair.cc, of 2018 to 2025). So the collectives here consist of messages
// between two processes, which can be aborted, and a thread aborts those with a process that is lost. Private to
// nn/process_group.cc.
#pragma once

#include "fastscene/nn/libtorch.h"

#ifdef FASTSCENE_GLOO
#include <condition_variable>
#include <map>
#include <mutex>
#include <stop_token>
#include <thread>
#include <torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>
#include <vector>

#include "fastscene/nn/rendezvous.h"

namespace fastscene::nn {

class GlooGroup {
  public:
    // Connects to the others. Throws exceptions of libtorch and Gloo.
    GlooGroup(const RendezvousRound& round, int rank, const c10::intrusive_ptr<c10d::Store>& store);
    // Closes the connections: whoever still waits for this process notices.
    ~GlooGroup() = default;
    GlooGroup(const GlooGroup&) = delete;
    GlooGroup& operator=(const GlooGroup&) = delete;

    // Collectives. Tensors have one dimension and are on the CPU; they hold the result. Throw std::exception if another
    // process is lost; then the group is of no more use.
    void barrier();
    void all_reduce_sum(const at::Tensor& tensor);
    void broadcast(const at::Tensor& tensor);  // the values of rank 0

  private:
    struct Message {
        int rank;  // of the other process
        c10::intrusive_ptr<c10d::Work> work;
    };
    Message send(const at::Tensor& tensor, int to);
    Message receive(const at::Tensor& tensor, int from);
    void finish(std::vector<Message> messages);
    void watch(const std::stop_token& end);

    int rank_, size_;
    c10::intrusive_ptr<c10d::ProcessGroupGloo> gloo_;
    std::mutex mutex_;  // of all below
    std::condition_variable_any ended_;
    // By rank: a message that never comes, and so ends with the connection only. None if the process is lost.
    std::map<int, c10::intrusive_ptr<c10d::Work>> sentinels_;
    std::vector<Message> in_flight_;
    std::jthread watcher_;
};

}  // namespace fastscene::nn
#endif
