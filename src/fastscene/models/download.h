// Downloads a file over http, https or file://, with libcurl. Partial data is kept when the connection breaks or the
// program is stopped, and the next attempt resumes.
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
    std::filesystem::path part;  // file for partial data
    std::int64_t bytes = 0;      // expected size; 0: as the server says
    // delay before the second attempt; doubled after each one without progress
    std::chrono::milliseconds first_wait{1000};
    std::chrono::seconds silence{60};                                  // timeout of a connection without data
    std::function<void(std::int64_t done, std::int64_t total)> heard;  // total 0: unknown
};

enum class Fetched {
    whole,   // `part` is complete according to the server
    absent,  // no such file at the URL
};

// Resumes where `part` ends, if the file is unchanged (If-Range) and the server supports it; otherwise restarts. Throws
// Error naming the URL, expected and actual: unreachable after several attempts, refused, wrong size, empty, a web page
// instead of a file, a full disk. `part` then keeps what can be resumed. Throws Stopped.
Fetched download(const Download& wanted, const Run& run);

}  // namespace fastscene
