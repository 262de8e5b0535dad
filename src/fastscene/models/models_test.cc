// Pulling from servers that disconnect, report wrong sizes, corrupt bytes, ignore ranges or redirect; mirrors,
// licences, verification.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <mutex>
#include <thread>

#include "fastscene/base/file.h"
#include "fastscene/models/download.h"
#include "fastscene/models/pull.h"
#include "fastscene/models/sha256.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

struct Request {
    std::string path, if_range;
    std::int64_t from = 0;  // from "Range: bytes=from-"
};

std::string header_of(const std::string& request, const std::string& name) {
    const std::size_t at = request.find("\r\n" + name + ": ");
    if (at == std::string::npos) return "";
    const std::size_t begin = at + name.size() + 4;
    return request.substr(begin, request.find("\r\n", begin) - begin);
}

// Sends exactly the given bytes and closes the connection, so it can simulate anything.
class Server {
  public:
    using Answer = std::function<std::string(const Request&)>;
    explicit Server(Answer answer) : answer_(std::move(answer)), socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
        EXPECT_EQ(::listen(socket_, 8), 0);
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
        port_ = ntohs(address.sin_port);
        thread_ = std::jthread([this] { serve(); });
    }
    ~Server() { ::shutdown(socket_, SHUT_RDWR), thread_.join(), ::close(socket_); }
    std::string url(const std::string& path = "") const {
        return "http://127.0.0.1:" + std::to_string(port_) + "/" + path;
    }
    std::vector<Request> seen() const {
        const std::lock_guard guard(mutex_);
        return seen_;
    }

  private:
    void serve() {
        for (int client; (client = ::accept(socket_, nullptr, nullptr)) >= 0; ::close(client)) {
            std::string text;
            char buffer[4096];
            while (text.find("\r\n\r\n") == std::string::npos) {
                const auto got = ::recv(client, buffer, sizeof buffer, 0);
                if (got <= 0) break;
                text.append(buffer, static_cast<std::size_t>(got));
            }
            Request request{text.substr(4, text.find(' ', 4) - 4), header_of(text, "If-Range"), 0};
            if (const std::string range = header_of(text, "Range"); !range.empty())
                request.from = std::stoll(range.substr(6));
            {
                const std::lock_guard guard(mutex_);
                seen_.push_back(request);
            }
            const std::string bytes = answer_(request);
            for (std::size_t sent = 0; sent < bytes.size();) {
                const auto put = ::send(client, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
                if (put <= 0) break;
                sent += static_cast<std::size_t>(put);
            }
        }
    }
    Answer answer_;
    int socket_;
    int port_ = 0;
    mutable std::mutex mutex_;
    std::vector<Request> seen_;
    std::jthread thread_;
};

std::string reply(const std::string& status, const std::string& headers, const std::string& body) {
    return "HTTP/1.1 " + status + "\r\nConnection: close\r\n" + headers + "\r\n" + body;
}
std::string length(std::size_t bytes) { return "Content-Length: " + std::to_string(bytes) + "\r\n"; }

const std::string kBytes = [] {
    std::string text;
    for (int i = 0; i < 300000; ++i) text += static_cast<char>((i * 2654435761u) >> 13);
    return text;
}();

// A well-behaved server with ranges and an ETag.
std::string decent(const Request& request, const std::string& bytes = kBytes, const std::string& etag = "\"one\"",
                   std::size_t cut = std::string::npos) {
    const std::string tag = "ETag: " + etag + "\r\n";
    const bool same = request.if_range.empty() || request.if_range == etag;
    if (request.from == 0 || !same) return reply("200 OK", tag + length(bytes.size()), bytes.substr(0, cut));
    const auto from = static_cast<std::size_t>(request.from);
    if (from >= bytes.size())
        return reply("416 Range Not Satisfiable",
                     "Content-Range: bytes */" + std::to_string(bytes.size()) + "\r\n" + length(0), "");
    return reply("206 Partial Content",
                 tag + fmt::format("Content-Range: bytes {}-{}/{}\r\n", from, bytes.size() - 1, bytes.size()) +
                     length(bytes.size() - from),
                 bytes.substr(from, cut));
}

class Pulled : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(root_);
        write_file((fs::create_directories(root_.parent_path()), root_.parent_path() / "bytes"), kBytes);
        hash_ = sha256_of_file(root_.parent_path() / "bytes");
    }
    void TearDown() override { fs::remove_all(root_.parent_path()); }
    Model model(const std::string& base, std::int64_t bytes = 0, const std::string& sha256 = "") const {
        return {"toy",          "toy",       "A toy.",
                "nobody",       "A licence", "https://licence",
                "https://home", base,        {{"part/a.bin", bytes, sha256}}};
    }
    PullOptions options() const { return {root_, "", true, milliseconds(1)}; }
    fs::path file() const { return root_ / "toy/part/a.bin"; }
    fs::path part() const { return root_ / "toy/part/a.bin.part"; }
    std::string complaint(const Model& wanted, const PullOptions& how) const {
        try {
            pull_model(wanted, how, {});
        } catch (const Error& e) {
            return e.what();
        }
        return "none";
    }
    fs::path root_ = fs::temp_directory_path() / ("fastscene_models_test_" + std::to_string(::getpid())) / "cache";
    std::string hash_;
};

TEST_F(Pulled, AWholeFileArrivesOnce) {
    Server server([](const Request& r) { return decent(r); });
    const Model toy = model(server.url(), static_cast<std::int64_t>(kBytes.size()), hash_);
    EXPECT_FALSE(is_in_cache(toy, root_));
    const ModelReport report = pull_model(toy, options(), {});
    EXPECT_EQ(report.files[0].state, FileState::fetched);
    EXPECT_EQ(read_file(file()), kBytes);
    EXPECT_TRUE(is_in_cache(toy, root_));
    EXPECT_EQ(pull_model(toy, options(), {}).files[0].state, FileState::here);
    EXPECT_EQ(server.seen().size(), 1u);
    EXPECT_EQ(server.seen()[0].path, "/part/a.bin");
    EXPECT_EQ(verify_model(toy, root_, {}).files[0].state, FileState::here);
    EXPECT_FALSE(fs::exists(part()));
}

TEST_F(Pulled, TheLicenceIsShownAndAcceptedOnce) {
    Server server([](const Request& r) { return decent(r); });
    const Model toy = model(server.url());
    PullOptions how = options();
    how.accept = false;
    EXPECT_THROW(pull_model(toy, how, {}), UsageError);
    const std::string text = complaint(toy, how);
    for (const char* word : {"A licence", "https://licence", "--accept"})
        EXPECT_NE(text.find(word), std::string::npos) << text;
    EXPECT_TRUE(server.seen().empty());
    pull_model(toy, options(), {});
    fs::remove(file());
    EXPECT_EQ(complaint(toy, how), "none") << "accepted before";
    Model other = toy;
    other.licence = "Another licence";
    fs::remove(file());
    EXPECT_NE(complaint(other, how).find("Another licence"), std::string::npos)
        << "a licence that changed is shown again";
}

TEST_F(Pulled, ABrokenConnectionGoesOnWhereItWas) {
    Server server([](const Request& r) { return decent(r, kBytes, "\"one\"", 90000); });
    pull_model(model(server.url(), static_cast<std::int64_t>(kBytes.size()), hash_), options(), {});
    EXPECT_EQ(read_file(file()), kBytes);
    const auto seen = server.seen();
    ASSERT_EQ(seen.size(), 4u);
    for (std::size_t i = 1; i < seen.size(); ++i) {
        EXPECT_EQ(seen[i].from, static_cast<std::int64_t>(90000 * i));
        EXPECT_EQ(seen[i].if_range, "\"one\"");
    }
}

TEST_F(Pulled, WhatArrivedIsKeptForTheNextPull) {
    std::atomic<bool> well = false;
    Server server([&](const Request& r) {
        return well ? decent(r) : r.from == 0 ? decent(r, kBytes, "\"one\"", 1000) : reply("503 Busy", length(0), "");
    });
    const Model toy = model(server.url());
    const std::string text = complaint(toy, options());
    EXPECT_NE(text.find("503"), std::string::npos) << text;
    EXPECT_NE(text.find("attempts"), std::string::npos) << text;
    EXPECT_EQ(fs::file_size(part()), 1000u);
    EXPECT_FALSE(fs::exists(file()));
    well = true;
    const std::size_t before = server.seen().size();
    pull_model(toy, options(), {});
    EXPECT_EQ(server.seen()[before].from, 1000);
    EXPECT_EQ(read_file(file()), kBytes);
}

TEST_F(Pulled, AFileThatChangedMeanwhileBeginsAnew) {
    std::string other = kBytes;
    other[10] ^= 1;
    std::atomic<int> asked = 0;
    Server server([&](const Request& r) {
        return asked++ == 0 ? decent(r, kBytes, "\"one\"", 1000) : decent(r, other, "\"two\"");
    });
    pull_model(model(server.url()), options(), {});
    EXPECT_EQ(read_file(file()), other);
}

TEST_F(Pulled, AServerThatIgnoresRangesIsReadFromTheBeginning) {
    std::atomic<int> asked = 0;
    Server server([&](const Request&) {
        return reply("200 OK", "ETag: \"one\"\r\n" + length(kBytes.size()),
                     kBytes.substr(0, asked++ == 0 ? 5000 : kBytes.size()));
    });
    pull_model(model(server.url(), 0, hash_), options(), {});
    EXPECT_EQ(read_file(file()), kBytes);
    EXPECT_EQ(server.seen()[1].from, 5000);
}

TEST_F(Pulled, AServerThatAlwaysBreaksOffIsGivenUp) {
    Server server([](const Request&) { return reply("200 OK", length(kBytes.size()), kBytes.substr(0, 5000)); });
    EXPECT_NE(complaint(model(server.url()), options()).find("given up"), std::string::npos);
    EXPECT_LE(server.seen().size(), 6u);
    Server wrong([](const Request& r) {
        return r.from == 0 ? decent(r, kBytes, "\"one\"", 100)
                           : reply("206 Partial Content", "Content-Range: bytes 0-9/10\r\n" + length(10), "0123456789");
    });
    EXPECT_NE(complaint(model(wrong.url()), options()).find("given up"), std::string::npos)
        << "other bytes than were asked for";
    EXPECT_FALSE(fs::exists(file()));
}

TEST_F(Pulled, LiesAboutSizesAreTold) {
    const auto size = static_cast<std::int64_t>(kBytes.size());
    Server larger([](const Request&) { return reply("200 OK", length(kBytes.size() + 7), kBytes + "1234567"); });
    EXPECT_NE(complaint(model(larger.url(), size), options()).find(std::to_string(size + 7)), std::string::npos);
    Server endless([](const Request&) { return reply("200 OK", "", kBytes + "and more"); });  // no Content-Length
    EXPECT_NE(complaint(model(endless.url(), size), options()).find("found more"), std::string::npos);
    EXPECT_FALSE(fs::exists(part()));
    Server smaller([](const Request&) { return reply("200 OK", "", kBytes.substr(0, 77)); });
    EXPECT_NE(complaint(model(smaller.url(), size), options()).find("77 of"), std::string::npos);
    EXPECT_FALSE(fs::exists(file()));
}

TEST_F(Pulled, CorruptBytesAreThrownAway) {
    std::string damaged = kBytes;
    damaged[1234] ^= 1;
    Server server([&](const Request& r) { return decent(r, damaged); });
    const std::string text = complaint(model(server.url(), 0, hash_), options());
    EXPECT_NE(text.find("expected SHA-256 " + hash_), std::string::npos) << text;
    EXPECT_FALSE(fs::exists(file()));
    EXPECT_FALSE(fs::exists(part()));
}

TEST_F(Pulled, ADamagedBeginningIsFetchedOnceMore) {
    std::atomic<bool> well = false;
    Server server([&](const Request& r) {
        return well ? decent(r) : r.from == 0 ? decent(r, kBytes, "\"one\"", 1000) : reply("500 Oh", length(0), "");
    });
    const Model toy = model(server.url(), 0, hash_);
    EXPECT_NE(complaint(toy, options()), "none");
    std::fstream(part(), std::ios::in | std::ios::out | std::ios::binary).seekp(10).put('?');
    well = true;
    pull_model(toy, options(), {});
    EXPECT_EQ(read_file(file()), kBytes);
}

TEST_F(Pulled, RedirectsAreFollowedWithinReason) {
    Server server([&](const Request& r) {
        if (r.path == "/part/a.bin") return reply("302 Found", "Location: /elsewhere\r\n" + length(0), "");
        if (r.path == "/elsewhere") return decent(r, kBytes, "\"one\"", 200000);
        return reply("302 Found", "Location: " + r.path + "x\r\n" + length(0), "");
    });
    pull_model(model(server.url(), 0, hash_), options(), {});
    EXPECT_EQ(read_file(file()), kBytes);
    fs::remove(file());
    EXPECT_NE(complaint(model(server.url("loop/")), options()).find("redirects"), std::string::npos);
    Server thief([](const Request&) { return reply("302 Found", "Location: file:///etc/passwd\r\n" + length(0), ""); });
    EXPECT_NE(complaint(model(thief.url()), options()), "none") << "a server cannot send to this machine's own files";
    EXPECT_FALSE(fs::exists(file()));
}

TEST_F(Pulled, AnswersThatAreNoFileAreTold) {
    Server page([](const Request&) {
        return reply("200 OK", "Content-Type: text/html; charset=utf-8\r\n" + length(6), "<html>");
    });
    EXPECT_NE(complaint(model(page.url()), options()).find("web page"), std::string::npos);
    Server closed([](const Request&) { return reply("403 Forbidden", length(0), ""); });
    EXPECT_NE(complaint(model(closed.url()), options()).find("account"), std::string::npos);
    Server none([](const Request&) { return reply("404 Not Found", length(3), "no!"); });
    EXPECT_NE(complaint(model(none.url()), options()).find("no such file"), std::string::npos);
    EXPECT_NE(complaint(model("http://127.0.0.1:1/"), options()).find("given up"), std::string::npos)
        << "nobody listens";
    EXPECT_FALSE(fs::exists(file()));
}

TEST_F(Pulled, TheFirstAlternativeThatIsThereIsTaken) {
    Server server(
        [](const Request& r) { return r.path.ends_with(".bin") ? decent(r) : reply("404 Not Found", length(0), ""); });
    Model toy = model(server.url());
    toy.files[0].name = "part/a.safetensors|part/a.bin";
    EXPECT_EQ(pull_model(toy, options(), {}).files[0].name, "part/a.bin");
    EXPECT_TRUE(is_in_cache(toy, root_));
    EXPECT_EQ(verify_model(toy, root_, {}).files[0].state, FileState::here);
}

TEST_F(Pulled, AMirrorIsAFolderOrAnAddress) {
    const fs::path mirror = root_.parent_path() / "mirror";
    fs::create_directories(mirror / "toy/part");
    write_file(mirror / "toy/part/a.bin", kBytes);
    PullOptions how = options();
    const Model by_hand = model("");
    EXPECT_NE(complaint(by_hand, how).find("https://home"), std::string::npos);
    for (const std::string& address : {mirror.string(), "file://" + mirror.string() + "/"}) {
        how.mirror = address;
        EXPECT_EQ(pull_model(by_hand, how, {}).files[0].state, FileState::fetched);
        EXPECT_EQ(read_file(file()), kBytes);
        fs::remove_all(root_ / "toy");
    }
    fs::remove(mirror / "toy/part/a.bin");
    how.mirror = mirror.string();
    EXPECT_NE(complaint(by_hand, how).find("no such file"), std::string::npos);
}

TEST_F(Pulled, AMirrorThatIsNotThereIsNamed) {
    PullOptions how = options();
    write_file(root_.parent_path() / "a file", kBytes);
    for (const std::string& mirror :
         {(root_.parent_path() / "nowhere").string(), std::string("file:///no%20such%20place")}) {
        how.mirror = mirror;
        const std::string said = complaint(model(""), how);
        EXPECT_NE(said.find("mirror " + mirror + ": expected a folder"), std::string::npos) << said;
        EXPECT_NE(said.find("found none"), std::string::npos) << said;
    }
    how.mirror = (root_.parent_path() / "a file").string();
    EXPECT_NE(complaint(model(""), how).find("found a file"), std::string::npos);
}

TEST_F(Pulled, AMirrorMayHaveAnyName) {
    const Model by_hand = model("");
    PullOptions how = options();
    for (const char* name : {"mir ror", "mir#1", "100 %20?", "m\u00fcr"}) {
        const fs::path mirror = root_.parent_path() / name;
        fs::create_directories(mirror / "toy/part");
        write_file(mirror / "toy/part/a.bin", kBytes);
        how.mirror = mirror.string();
        EXPECT_EQ(complaint(by_hand, how), "none") << name;
        EXPECT_EQ(read_file(file()), kBytes) << name;
        fs::remove_all(root_ / "toy");
    }
    for (const char* name : {"mir ror", "mir%20ror", "mir#1"}) {
        how.mirror = "file://" + (root_.parent_path() / name).string();
        EXPECT_EQ(complaint(by_hand, how), "none") << name;
        fs::remove_all(root_ / "toy");
    }
}

TEST_F(Pulled, NothingIsNoFile) {
    const fs::path mirror = root_.parent_path() / "hollow";
    PullOptions how = options();
    how.mirror = mirror.string();
    fs::create_directories(mirror / "toy/part/a.bin");
    EXPECT_NE(complaint(model(""), how), "none") << "a folder in the file's place";
    fs::remove_all(mirror / "toy/part/a.bin");
    write_file(mirror / "toy/part/a.bin", std::string_view());
    EXPECT_NE(complaint(model(""), how).find("0 bytes"), std::string::npos) << complaint(model(""), how);
    Server server([](const Request&) { return reply("200 OK", length(0), ""); });
    EXPECT_NE(complaint(model(server.url()), options()).find("0 bytes"), std::string::npos);
    EXPECT_FALSE(fs::exists(file()));
    fs::create_directories(file().parent_path());
    write_file(file(), std::string_view());
    EXPECT_FALSE(is_in_cache(model(""), root_));
    EXPECT_EQ(verify_model(model(""), root_, {}).files[0].state, FileState::damaged);
    fs::remove(file());
    fs::create_directories(file());
    EXPECT_FALSE(is_in_cache(model(""), root_));
    write_file(mirror / "toy/part/a.bin", kBytes);
    EXPECT_NE(complaint(model(""), how).find("found a folder"), std::string::npos);
}

TEST_F(Pulled, WhatIsDamagedIsFetchedAgain) {
    Server server([](const Request& r) { return decent(r); });
    std::string damaged = kBytes;
    damaged[777] ^= 1;
    for (const Model& toy : {model(server.url(), static_cast<std::int64_t>(kBytes.size()), hash_),
                             model(server.url())}) {  // hash known in advance, and recorded on first pull
        fs::remove_all(root_ / "toy");
        pull_model(toy, options(), {});
        const std::size_t before = server.seen().size();
        write_file(file(), damaged);
        EXPECT_FALSE(verify_model(toy, root_, {}).whole());
        EXPECT_EQ(pull_model(toy, options(), {}).files[0].state, FileState::fetched);
        EXPECT_EQ(read_file(file()), kBytes);
        EXPECT_EQ(server.seen().size(), before + 1);
        EXPECT_TRUE(verify_model(toy, root_, {}).whole());
    }
    // The damaged file is replaced only once the new one is complete.
    write_file(file(), damaged);
    EXPECT_NE(complaint(model("http://127.0.0.1:1/", 0, hash_), options()), "none");
    EXPECT_EQ(read_file(file()), damaged);
    // Another alternative replaces it.
    Server other(
        [](const Request& r) { return r.path.ends_with(".pt") ? decent(r) : reply("404 Not Found", length(0), ""); });
    Model two = model(other.url());
    two.files[0].name = "part/a.bin|part/a.pt";
    EXPECT_EQ(pull_model(two, options(), {}).files[0].name, "part/a.pt");
    EXPECT_FALSE(fs::exists(file()));
    EXPECT_TRUE(verify_model(two, root_, {}).whole());
}

TEST_F(Pulled, VerifyRecordsWhatNobodyKnewAndHoldsItAfterwards) {
    Model toy = model("");
    fs::create_directories(file().parent_path());
    EXPECT_EQ(verify_model(toy, root_, {}).files[0].state, FileState::missing);
    write_file(file(), kBytes);
    EXPECT_EQ(verify_model(toy, root_, {}).files[0].state, FileState::recorded);
    EXPECT_EQ(verify_model(toy, root_, {}).files[0].state, FileState::here);
    write_file(file(), kBytes + "x");
    const ModelReport report = verify_model(toy, root_, {});
    EXPECT_EQ(report.files[0].state, FileState::damaged);
    EXPECT_NE(report.files[0].problem.find(hash_), std::string::npos);
    EXPECT_FALSE(report.whole());
    toy.files[0].bytes = 3;
    EXPECT_FALSE(is_in_cache(toy, root_)) << "another size is another file";
}

TEST_F(Pulled, WhatIsKeptBesideTheFilesIsReadWithCare) {
    const Model toy = model("");
    fs::create_directories(file().parent_path());
    write_file(file(), kBytes);
    for (const char* kept : {"[]", "3", R"({"files": []})", R"({"files": {"part/a.bin": 3}})",
                             R"({"files": {"part/a.bin": {"sha256": 7}}})"}) {
        SCOPED_TRACE(kept);
        write_file(root_ / "toy/toy.record.json", kept);
        const std::string said = complaint(toy, options());
        EXPECT_NE(said.find("toy.record.json: expected"), std::string::npos) << said;
    }
    fs::remove(root_ / "toy/toy.record.json");
    write_file(root_ / "licences.json", R"({"toy": 3})");
    EXPECT_FALSE(is_accepted(toy, root_));
    write_file(root_ / "licences.json", "[1]");
    EXPECT_THROW((void)is_accepted(toy, root_), Error);
}

TEST_F(Pulled, AStopLeavesTheBeginning) {
    std::stop_source stop;
    Server server([&](const Request& r) {
        if (r.from > 0) stop.request_stop();
        return r.from > 0 ? reply("503 Busy", length(0), "") : decent(r, kBytes, "\"one\"", 1000);
    });
    EXPECT_THROW(pull_model(model(server.url()), options(), {0, nullptr, stop.get_token()}), Stopped);
    EXPECT_EQ(fs::file_size(part()), 1000u);
}

TEST(Registry, SaysWhatItKnowsOfEveryFile) {
    std::vector<std::string> names;
    for (const Model& model : models()) {
        SCOPED_TRACE(model.name);
        EXPECT_EQ(&model_named(model.name), &model);
        EXPECT_EQ(std::count(names.begin(), names.end(), model.name), 0);
        names.push_back(model.name);
        EXPECT_FALSE(model.files.empty() || model.licence.empty() || model.what.empty() || model.folder.empty());
        EXPECT_TRUE(model.licence_url.starts_with("https://") && model.home.starts_with("https://"));
        EXPECT_TRUE(model.by_hand() || (model.base.starts_with("https://") && model.base.ends_with("/")));
        for (const ModelFile& file : model.files) {
            EXPECT_TRUE(file.sha256.empty() || (file.sha256.size() == 64 &&
                                                file.sha256.find_first_not_of("0123456789abcdef") == std::string::npos))
                << file.name;
            EXPECT_EQ(urls_of(model, file).empty(), model.by_hand()) << file.name;
            EXPECT_TRUE(file.names().size() == 1 || file.sha256.empty()) << "one hash for two files: " << file.name;
            for (const std::string& name : file.names())
                EXPECT_FALSE(name.empty() || name.starts_with("/") || name.find("..") != std::string::npos);
        }
    }
    EXPECT_THROW(model_named("nothing"), UsageError);
}

TEST(Sha256, OfTheStandardsExample) {
    const fs::path file = fs::temp_directory_path() / ("fastscene_sha_" + std::to_string(::getpid()));
    write_file(file, std::string_view("abc"));
    EXPECT_EQ(sha256_of_file(file), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    fs::remove(file);
    EXPECT_THROW(sha256_of_file(file), Error);
}

}  // namespace
}  // namespace fastscene
