// Meeting: how processes that train together find each other, at the beginning and again after one was lost. Process 0
// keeps a store, at an address that all know; the others write there that they wait, and process 0 decides who takes
// part in the next group. Private to nn/process_group.cc.
#pragma once

#include "fastscene/nn/libtorch.h"

#ifdef FASTSCENE_GLOO
#include <string>
#include <torch/csrc/distributed/c10d/TCPStore.hpp>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/nn/connections.h"

namespace fastscene::nn {

// Who takes part, and where this process is reached by the others.
struct Gathering {
    int number = 0;            // of this gathering, from 1
    std::vector<int> members;  // processes, in increasing order
    std::string address;       // of this process
};

struct Wanted {
    std::vector<int> processes;
    double patience_s = 0;
    bool all = false;  // without one of them there is no gathering
};

class Meeting {
  public:
    // Opens the store, or waits for it at most `patience_s`. Throws std::exception of libtorch.
    Meeting(const Place& place, int process, int processes, double patience_s);

    // Process 0: waits until all that are wanted are there, and takes all who are. The others: wait until they are
    // taken. Throws Error if process 0 is gone, or if somebody lacks whom it cannot go on without; Stopped.
    Gathering gather(const Run& run, const Wanted& wanted);
    // Process 0: whether one that is not in the last gathering waits.
    bool has_newcomer();
    std::uint16_t port() const { return place_.port; }
    // What the members of a gathering share.
    c10::intrusive_ptr<c10d::Store> shared(const Gathering& gathering) const;

  private:
    Gathering take_those_here(const Run& run, const Wanted& wanted);
    Gathering wait_until_taken(const Run& run);

    Place place_;
    int process_, processes_;
    c10::intrusive_ptr<c10d::TCPStore> store_;
    Gathering last_;
};

}  // namespace fastscene::nn
#endif
