#include "fastscene/studio/local_request.h"

#include <gtest/gtest.h>

namespace fastscene::studio {
namespace {

bool answered(const std::string& host) { return !refusal({host}, {}); }

TEST(LocalRequest, NamesOfTheLoopbackInterfaceAreAnsweredAtAnyPort) {
    for (const char* host : {"127.0.0.1", "127.0.0.1:8080", "localhost:9000", "LocalHost:80", "[::1]:8080"})
        EXPECT_TRUE(answered(host)) << host;
}

TEST(LocalRequest, AReboundNameIsRefused) {
    for (const char* host :
         {"evil.example", "evil.example:8080", "127.0.0.1.evil.example", "localhost.evil.example:8080", "127.0.0.10",
          "192.168.0.2:8080", "localhost:", "localhost:80x", "localhost:123456", "localhost:8080@evil.example", ""})
        EXPECT_FALSE(answered(host)) << host;
}

TEST(LocalRequest, ExactlyOneHostIsExpected) {
    EXPECT_TRUE(refusal({}, {}));
    EXPECT_TRUE(refusal({"localhost:8080", "evil.example"}, {}));
    EXPECT_TRUE(refusal({"localhost:8080", "localhost:8080"}, {}));
}

TEST(LocalRequest, OnlyThePageItselfIsAnOrigin) {
    EXPECT_FALSE(refusal({"localhost:8080"}, {"http://localhost:8080"}));
    for (const char* origin : {"http://evil.example", "null", "", "http://localhost:3000", "https://localhost:8080",
                               "http://127.0.0.1:8080", "http://localhost:8080.evil.example"})
        EXPECT_TRUE(refusal({"localhost:8080"}, {origin})) << origin;
    EXPECT_TRUE(refusal({"localhost:8080"}, {"http://localhost:8080", "http://evil.example"}));
}

}  // namespace
}  // namespace fastscene::studio
