#include "fastscene/studio/send_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <httplib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

using namespace std::chrono_literals;

// Worker threads, started when none is idle. A stream of the studio's events keeps one, and so does a client
// that sends a byte now and then: these many slow ones do not keep others out. Each takes 100 KB or less.
constexpr std::size_t kMostClients = 400;  // below the usual limit of 1024 open files
// A connection without a request gives its thread back after this long. Browsers open another, which takes no time on
// one machine.
constexpr auto kIdle = 1s;
constexpr auto kReadWait = 5s, kWriteWait = 5s;  // for a client that sends or takes nothing
constexpr std::size_t kMostRanges = 4;

std::string type_of(const fs::path& file) {
    static constexpr std::pair<std::string_view, const char*> kTypes[] = {{".html", "text/html; charset=utf-8"},
                                                                          {".js", "text/javascript; charset=utf-8"},
                                                                          {".css", "text/css; charset=utf-8"},
                                                                          {".json", "application/json"},
                                                                          {".wasm", "application/wasm"},
                                                                          {".svg", "image/svg+xml"},
                                                                          {".png", "image/png"},
                                                                          {".jpg", "image/jpeg"},
                                                                          {".jpeg", "image/jpeg"},
                                                                          {".webp", "image/webp"},
                                                                          {".woff2", "font/woff2"},
                                                                          {".txt", "text/plain; charset=utf-8"},
                                                                          {".glb", "model/gltf-binary"}};
    const std::string ending = file.extension().string();
    for (const auto& [known, type] : kTypes)
        if (ending == known) return type;
    return "application/octet-stream";
}

class ClientThreads final : public httplib::TaskQueue {
  public:
    void enqueue(std::function<void()> task) override {
        const std::lock_guard lock(mutex_);
        tasks_.push_back(std::move(task));
        if (tasks_.size() > idle_ && threads_.size() < kMostClients) threads_.emplace_back([this] { work(); });
        changed_.notify_one();
    }
    void shutdown() override {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        changed_.notify_all();
        threads_.clear();  // joins
    }

  private:
    void work() {
        std::unique_lock lock(mutex_);
        while (true) {
            ++idle_;
            changed_.wait(lock, [&] { return ends_ || !tasks_.empty(); });
            --idle_;
            if (tasks_.empty()) return;
            const std::function<void()> task = std::move(tasks_.front());
            tasks_.pop_front();
            lock.unlock();
            task();
            lock.lock();
        }
    }
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> tasks_;
    std::size_t idle_ = 0;
    bool ends_ = false;
    std::vector<std::jthread> threads_;
};

struct OpenFile {
    int descriptor;
    explicit OpenFile(const fs::path& path) : descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW)) {}
    ~OpenFile() {
        if (descriptor >= 0) ::close(descriptor);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
};

}  // namespace

std::optional<fs::path> file_below(const fs::path& root, const std::string& relative) {
    if (relative.find('\0') != std::string::npos || relative.find('\\') != std::string::npos) return {};
    fs::path path = root;
    std::error_code none;
    for (const fs::path& part : fs::path(relative)) {
        if (part.empty() || part.string().front() == '.' || part == "/") return {};
        path /= part;
        if (fs::is_symlink(fs::symlink_status(path, none))) return {};
    }
    if (!fs::is_regular_file(path, none)) return {};
    return path;
}

// Splats may be larger than what is left of memory. An open file stays whole when it is replaced.
void send_file(const httplib::Request& request, httplib::Response& response, const fs::path& path, const char* policy) {
    const auto file = std::make_shared<OpenFile>(path);
    struct stat status {};
    if (file->descriptor < 0 || ::fstat(file->descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        response.status = 404;
        response.set_header("Cache-Control", "no-store");
        return response.set_content(R"({"error":"there is no such file"})", "application/json");
    }
    const std::string tag = fmt::format("\"{:x}-{:x}-{:x}\"", status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
                                        status.st_size);
    response.set_header("ETag", tag);
    if (!response.has_header("Cache-Control")) response.set_header("Cache-Control", "no-cache");
    response.set_header("Content-Security-Policy", policy);
    if (request.get_header_value("If-None-Match") == tag) {
        response.status = 304;
        return;
    }
    if (status.st_size == 0) return response.set_content("", type_of(path));
    response.set_content_provider(static_cast<std::size_t>(status.st_size), type_of(path),
                                  [file](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                      std::vector<char> piece(std::min<std::size_t>(length, 1 << 18));
                                      const ssize_t got = ::pread(file->descriptor, piece.data(), piece.size(),
                                                                  static_cast<off_t>(offset));
                                      return got > 0 && sink.write(piece.data(), static_cast<std::size_t>(got));
                                  });
}

void set_safe_headers(httplib::Response& response) {
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cross-Origin-Opener-Policy", "same-origin");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
}

void limit_clients(httplib::Server& server) {
    server.new_task_queue = [] { return new ClientThreads; };
    server.set_keep_alive_timeout(std::chrono::seconds(kIdle).count());
    server.set_read_timeout(kReadWait);
    server.set_write_timeout(kWriteWait);
    server.set_tcp_nodelay(true);
    // By default the library would let two servers share a port silently.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
}

bool has_too_many_ranges(const httplib::Request& request) { return request.ranges.size() > kMostRanges; }

}  // namespace fastscene::studio
