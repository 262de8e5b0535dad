// Who is answered, and with which headers: over a real socket.
#include <gtest/gtest.h>
#include <httplib.h>

#include <filesystem>
#include <future>
#include <thread>

#include "fastscene/base/file.h"
#include "fastscene/studio/web_server.h"

namespace fastscene::studio {
namespace {

namespace fs = std::filesystem;
using httplib::Headers;

class WebServer : public testing::Test {
  protected:
    void start(const std::string& token = "") {
        root_ = fs::temp_directory_path() / fmt::format("fastscene-web-{}", ::getpid());
        fs::remove_all(root_);
        make_directories(root_ / "pages/assets");
        write_file(root_ / "pages/index.html", std::string_view("<!doctype html>page"));
        write_file(root_ / "pages/assets/a.js", std::string_view("1"));
        make_directories(root_ / "scenes/bedroom");
        write_json(root_ / "scenes/bedroom/run.json", Json::object());
        write_file(root_ / "scenes/bedroom/viewer.html", std::string_view("0123456789"));
        library_.emplace(root_ / "scenes");
        api_.emplace(*library_, board_, ApiParams{"/bin/false", {}, 0});
        params_ = {root_ / "pages", "127.0.0.1", 0, token, {}, {}};
        std::promise<std::string> address;
        auto ready = address.get_future();
        thread_ = std::jthread([this, address = std::move(address)](std::stop_token stop) mutable {
            serve(*api_, *library_, board_, params_, stop, [&](const std::string& a) { address.set_value(a); });
        });
        const std::string url = ready.get();
        const std::size_t colon = url.rfind(':');
        port_ = std::stoi(url.substr(colon + 1));
        client_.emplace("127.0.0.1", port_);
    }
    void TearDown() override {
        thread_.request_stop();
        thread_.join();
        fs::remove_all(root_);
    }
    int get(const std::string& path, const Headers& headers = {}) {
        return client_->Get(path.c_str(), headers)->status;
    }
    int post(const std::string& path, const Headers& headers, const std::string& type = "application/json") {
        return client_->Post(path.c_str(), headers, R"({"prompt":"a bedroom"})", type.c_str())->status;
    }

    fs::path root_;
    std::optional<Library> library_;
    Board board_;
    std::optional<Api> api_;
    WebParams params_;
    std::jthread thread_;
    int port_ = 0;
    std::optional<httplib::Client> client_;
};

TEST_F(WebServer, OnlyThePageOfThisMachineIsAnswered) {
    start();
    const std::string own = fmt::format("http://127.0.0.1:{}", port_);
    EXPECT_EQ(get("/"), 200);
    EXPECT_EQ(get("/api/live"), 200);
    EXPECT_EQ(get("/", {{"Host", "evil.example"}}), 403);
    EXPECT_EQ(get("/files/bedroom/viewer.html", {{"Sec-Fetch-Site", "cross-site"}, {"Sec-Fetch-Mode", "no-cors"}}),
              403);
    EXPECT_EQ(get("/", {{"Sec-Fetch-Site", "cross-site"}, {"Sec-Fetch-Mode", "navigate"}}), 200);
    EXPECT_EQ(post("/api/plan", {{"Origin", own}}), 200);
    EXPECT_EQ(post("/api/plan", {{"Origin", "http://evil.example"}}), 403);
    EXPECT_EQ(post("/api/plan", {{"Origin", "null"}}), 403);  // viewer.html, in its sandbox
    EXPECT_EQ(post("/api/plan", {}, "text/plain"), 415);
    EXPECT_EQ(post("/api/upload/panorama?name=a.png", {}), 415);
}

TEST_F(WebServer, APageThatIsNotThereIsAPageThatSaysSo) {
    start();
    EXPECT_EQ(get("/scene/bedroom"), 200);
    EXPECT_EQ(get("/scene/attic"), 404);
    EXPECT_NE(client_->Get("/scene/attic")->body.find("page"), std::string::npos);
    EXPECT_EQ(get("/assets/a.js"), 200);
    for (const char* path : {"/assets/../index.html", "/assets/%2e%2e/%2e%2e/scenes/bedroom/run.json", "/assets/b.js",
                             "/files/bedroom/../../pages/index.html", "/files/..%2fpages/index.html",
                             "/files/bedroom/%2e%2e/bedroom/run.json", "/files/.studio/jobs"})
        EXPECT_EQ(get(path), 404) << path;
}

TEST_F(WebServer, HeadersKeepScriptsWhereTheyAre) {
    start();
    const auto page = client_->Get("/"), file = client_->Get("/files/bedroom/viewer.html");
    EXPECT_EQ(page->get_header_value("Content-Security-Policy").find("default-src 'none'; script-src 'self';"), 0u);
    EXPECT_EQ(file->get_header_value("Content-Security-Policy").find("sandbox allow-scripts allow-pointer-lock;"), 0u);
    for (const auto* response : {&page, &file})
        EXPECT_EQ((*response)->get_header_value("X-Content-Type-Options"), "nosniff");
}

TEST_F(WebServer, FilesComeInPartsAndOnce) {
    start();
    const auto whole = client_->Get("/files/bedroom/viewer.html");
    EXPECT_EQ(whole->body, "0123456789");
    const auto part = client_->Get("/files/bedroom/viewer.html", {{"Range", "bytes=2-4"}});
    EXPECT_EQ(part->status, 206);
    EXPECT_EQ(part->body, "234");
    EXPECT_EQ(get("/files/bedroom/viewer.html", {{"If-None-Match", whole->get_header_value("ETag")}}), 304);
}

// A thousand ranges of a large file would be a thousand copies of it.
TEST_F(WebServer, AFewRangesAreEnough) {
    start();
    std::string many = "bytes=0-0";
    for (int i = 0; i < 1000; ++i) many += ",0-";
    EXPECT_EQ(get("/files/bedroom/viewer.html", {{"Range", "bytes=0-1,3-4"}}), 206);
    EXPECT_EQ(get("/files/bedroom/viewer.html", {{"Range", many}}), 416);
}

TEST_F(WebServer, NoFileLiesBehindALink) {
    start();
    write_file(root_ / "secret", std::string_view("secret"));
    fs::create_symlink(root_ / "secret", root_ / "scenes/bedroom/link");
    fs::create_symlink(root_, root_ / "scenes/bedroom/folder");
    EXPECT_EQ(get("/files/bedroom/link"), 404);
    EXPECT_EQ(get("/files/bedroom/folder/secret"), 404);
}

TEST_F(WebServer, WithATokenNothingIsAnsweredWithoutIt) {
    start("0123456789abcdef");
    EXPECT_EQ(get("/"), 403);
    EXPECT_EQ(get("/api/live", {{"Cookie", "fastscene_studio=0123456789abcdee"}}), 403);
    EXPECT_EQ(get("/?token=wrong"), 403);
    const auto welcome = client_->Get("/?token=0123456789abcdef");
    EXPECT_EQ(welcome->status, 302);
    const std::string cookie = welcome->get_header_value("Set-Cookie");
    EXPECT_NE(cookie.find("HttpOnly; SameSite=Strict"), std::string::npos) << cookie;
    const Headers known{{"Cookie", "a=b; fastscene_studio=0123456789abcdef"}};
    EXPECT_EQ(get("/api/live", known), 200);
    EXPECT_EQ(post("/api/plan", {{"Cookie", "fastscene_studio=0123456789abcdef"}, {"Origin", "http://evil.example"}}),
              403);
}

TEST_F(WebServer, WhatIsTooLargeIsNotKept) {
    start();
    const std::string large(static_cast<std::size_t>(kMostUploadBytes) + 1, 'x');
    const auto answer = client_->Post("/api/upload/panorama?name=a.png", large, "application/octet-stream");
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 413);
    EXPECT_NE(answer->body.find("64 MB"), std::string::npos) << answer->body;
    EXPECT_EQ(get("/api/live"), 200);
}

TEST_F(WebServer, APortInUseIsSaid) {
    start();
    WebParams same = params_;
    same.port = port_;
    try {
        serve(*api_, *library_, board_, same, {}, [](const std::string&) { FAIL(); });
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find(fmt::format("--port {}", port_ + 1)), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace fastscene::studio
