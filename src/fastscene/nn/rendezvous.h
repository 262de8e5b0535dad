// Rendezvous: how processes that train together find each other, at the start and again after one was lost. Process 0
// hosts the store, at an endpoint that all know; the others register there, and process 0 decides who takes part in the
// next round. Private to nn/process_group.cc.
#pragma once

#include "fastscene/nn/libtorch.h"

#ifdef FASTSCENE_GLOO
#include <map>
#include <string>
#include <torch/csrc/distributed/c10d/TCPStore.hpp>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/nn/connections.h"

namespace fastscene::nn {

// Who takes part, and where the others reach this process. A process's rank is its index in `members`, the world size
// their number.
struct RendezvousRound {
    int number = 0;            // from 1
    std::vector<int> members;  // processes, in increasing order
    std::string address;       // of this process
};

struct Expected {
    std::vector<int> processes;
    double timeout_s = 0;
    bool all_required = false;  // after the timeout: fail if one is missing, instead of going on without it
};

class Rendezvous {
  public:
    // Process 0 opens the store; the others wait for it at most `timeout_s`. Throws std::exception of libtorch.
    Rendezvous(const Endpoint& endpoint, int process, int processes, double timeout_s);

    // Process 0: waits for the expected processes, and admits all that are registered. The others: register and wait to
    // be admitted. Throws Error if process 0 is gone or a required process is missing; Stopped.
    RendezvousRound next_round(const Run& run, const Expected& expected);
    // Process 0: whether a process that is not in the last round is registered.
    bool has_newcomer();
    std::uint16_t port() const { return endpoint_.port; }
    // The store of a round's process group.
    c10::intrusive_ptr<c10d::Store> store_of(const RendezvousRound& round) const;

  private:
    RendezvousRound admit(const Run& run, const Expected& expected);
    RendezvousRound wait_to_be_admitted(const Run& run);
    int last_round() const;  // 0: none yet
    Json registration_of(int process) const;

    Endpoint endpoint_;
    int process_, processes_;
    c10::intrusive_ptr<c10d::TCPStore> store_;
    RendezvousRound last_;
    std::map<int, std::string> admitted_;  // process 0: the last ticket of each that was
};

}  // namespace fastscene::nn
#endif
