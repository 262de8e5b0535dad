// One file over http, https or file://, by libcurl. What has arrived stays when the connection breaks or the program is
// stopped, and the next attempt goes on after it.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "fastscene/base/run.h"

namespace fastscene {

struct Download {
    std::string url;
    std::filesystem::path part;                  // where the bytes gather
    std::int64_t bytes = 0;                      // what it must have; 0: what the server says
    std::chrono::milliseconds first_wait{1000};  // before the second attempt; doubled each time nothing came
    std::chrono::seconds silence{60};            // a connection that brings nothing for so long is given up
    std::function<void(std::int64_t done, std::int64_t total)> heard;  // total 0: not known
};

enum class Fetched {
    whole,   // `part` has all the bytes that the server wanted to send
    absent,  // there is no such file at the address
};

// Goes on where `part` ends, if the file there is still the same (If-Range) and the server can; else from the
// beginning. Throws Error naming the address, expected and found: unreachable after several attempts, refused, another
// size, no bytes at all, a web page in place of a file, a full disk. `part` then holds what is worth keeping. Throws
// Stopped.
Fetched download(const Download& wanted, const Run& run);

}  // namespace fastscene
