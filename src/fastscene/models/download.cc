#include "fastscene/models/download.h"

#include <curl/curl.h>

#include <algorithm>
#include <charconv>
#include <condition_variable>
#include <exception>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>

#include "fastscene/base/check.h"
#include "fastscene/base/file.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr int kFruitlessAttempts = 5;
constexpr long kMostRedirects = 10, kConnectSeconds = 30;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
    return text;
}
std::string trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t\r\n"), to = text.find_last_not_of(" \t\r\n");
    return from == std::string_view::npos ? "" : std::string(text.substr(from, to - from + 1));
}
std::optional<std::int64_t> number_in(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    return code == std::errc() && end == text.data() + text.size() && value >= 0 ? std::optional(value) : std::nullopt;
}

// Headers of the last response in a chain of redirects.
struct Answer {
    std::string etag, type;
    std::optional<std::int64_t> length, range_begin, range_total;

    void read_line(const std::string& line) {
        const std::size_t colon = line.find(':');
        if (line.starts_with("HTTP/")) *this = {};
        if (colon == std::string::npos) return;
        const std::string name = lower(line.substr(0, colon)),
                          value = trimmed(std::string_view(line).substr(colon + 1));
        if (name == "etag") etag = value;
        if (name == "content-type") type = lower(value);
        if (name == "content-length") length = number_in(value);
        if (name == "content-range") read_range(value);
    }
    void read_range(std::string_view value) {  // "bytes 100-199/200", "bytes */200"
        if (!value.starts_with("bytes ")) return;
        value.remove_prefix(6);
        const std::size_t dash = value.find('-'), slash = value.find('/');
        if (dash != std::string_view::npos && dash < slash) range_begin = number_in(value.substr(0, dash));
        if (slash != std::string_view::npos) range_total = number_in(value.substr(slash + 1));
    }
};

// Stored next to partial data: the URL they came from and the server's version tag (ETag).
struct Origin {
    std::string url, etag;

    static fs::path file_of(const fs::path& part) { return part.string() + ".origin"; }
    static Origin of(const fs::path& part) {
        Origin origin;
        std::ifstream in(file_of(part));
        std::getline(in, origin.url);
        std::getline(in, origin.etag);
        return origin;
    }
    void save(const fs::path& part) const { write_file(file_of(part), url + "\n" + etag + "\n"); }
};

std::int64_t size_of(const fs::path& file) {
    std::error_code code;
    const auto size = fs::file_size(file, code);
    return code ? 0 : static_cast<std::int64_t>(size);
}

void forget(const fs::path& part) {
    std::error_code ignored;
    fs::remove(part, ignored);
    fs::remove(Origin::file_of(part), ignored);
}

// Thrown if another attempt may succeed.
struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Attempt {
  public:
    Attempt(const Download& wanted, const Run& run)
        : wanted_(wanted), run_(run), curl_(curl_easy_init(), curl_easy_cleanup) {
        FASTSCENE_CHECK(curl_ != nullptr);
    }

    Fetched make() {
        prepare();
        const CURLcode code = curl_easy_perform(curl_.get());
        out_.close();
        if (trouble_) std::rethrow_exception(trouble_);
        run_.check_stop();
        return verdict(code);
    }
    std::int64_t reached() const { return begin_ + received_; }

  private:
    bool is_web() const { return !wanted_.url.starts_with("file:"); }
    long status() const {
        long status = 0;
        curl_easy_getinfo(curl_.get(), CURLINFO_RESPONSE_CODE, &status);
        return status;
    }
    template <class T>
    void set(CURLoption option, T value) {
        FASTSCENE_CHECK(curl_easy_setopt(curl_.get(), option, value) == CURLE_OK);
    }

    void prepare() {
        const Origin origin = Origin::of(wanted_.part);
        begin_ = size_of(wanted_.part);
        // Partial data from another URL, or from a version that cannot be verified to be the current one, is discarded.
        if (begin_ > 0 && (origin.url != wanted_.url || (is_web() && origin.etag.empty() && wanted_.bytes == 0)))
            begin_ = 0;
        set(CURLOPT_URL, wanted_.url.c_str());
        set(CURLOPT_NOSIGNAL, 1L);
        set(CURLOPT_USERAGENT, "fastscene");
        set(CURLOPT_ERRORBUFFER, error_);
        set(CURLOPT_FOLLOWLOCATION, 1L);
        set(CURLOPT_MAXREDIRS, kMostRedirects);
        set(CURLOPT_PROTOCOLS_STR, "http,https,file");
        set(CURLOPT_REDIR_PROTOCOLS_STR, wanted_.url.starts_with("https:") ? "https" : "http,https");
        set(CURLOPT_CONNECTTIMEOUT, kConnectSeconds);
        set(CURLOPT_LOW_SPEED_LIMIT, 1L);
        set(CURLOPT_LOW_SPEED_TIME, static_cast<long>(wanted_.silence.count()));
        set(CURLOPT_HEADERFUNCTION, &Attempt::on_header);
        set(CURLOPT_HEADERDATA, this);
        set(CURLOPT_WRITEFUNCTION, &Attempt::on_bytes);
        set(CURLOPT_WRITEDATA, this);
        set(CURLOPT_NOPROGRESS, 0L);
        set(CURLOPT_XFERINFOFUNCTION, &Attempt::on_progress);
        set(CURLOPT_XFERINFODATA, this);
        if (begin_ == 0) return;
        range_ = std::to_string(begin_) + "-";
        set(CURLOPT_RANGE, range_.c_str());
        if (origin.etag.empty() || origin.etag.starts_with("W/")) return;
        headers_.reset(curl_slist_append(nullptr, ("If-Range: " + origin.etag).c_str()));
        set(CURLOPT_HTTPHEADER, headers_.get());
    }

    // Called with the first bytes of the body: validates the response and determines the offset.
    void begin_writing() {
        if (is_web() && answer_.type.starts_with("text/html"))
            throw Error("{}: expected a file, found a web page (a page to log in or to confirm?)", wanted_.url);
        if (status() == 206 && answer_.range_begin != begin_) {
            forget(wanted_.part);
            throw Interrupted(fmt::format("the server was asked for byte {} and sent others", begin_));
        }
        if (is_web() && status() != 206) begin_ = 0;
        total_ = answer_.range_total ? *answer_.range_total : answer_.length ? begin_ + *answer_.length : 0;
        if (!is_web() && begin_ > 0) total_ = 0;
        if (wanted_.bytes > 0 && total_ > 0 && total_ != wanted_.bytes)
            throw Error("{}: expected {} bytes, found {} by what the server says; another file than the one known",
                        wanted_.url, wanted_.bytes, total_);
        out_.open(wanted_.part, std::ios::binary | (begin_ > 0 ? std::ios::app : std::ios::trunc));
        if (!out_) throw Error("{}: cannot be written", wanted_.part.string());
        Origin{wanted_.url, answer_.etag}.save(wanted_.part);
        check_disk();
    }
    void check_disk() const {
        std::error_code code;
        const fs::space_info space = fs::space(wanted_.part.parent_path(), code);
        const std::int64_t missing = (wanted_.bytes > 0 ? wanted_.bytes : total_) - begin_;
        if (!code && missing > 0 && static_cast<std::uint64_t>(missing) > space.available)
            throw Error("{}: expected {} MB of free disk, found {} MB", wanted_.part.parent_path().string(),
                        missing / 1000000 + 1, space.available / 1000000);
    }
    void take(const char* bytes, std::size_t count) {
        if (is_web() && status() >= 400) return;
        if (!out_.is_open()) begin_writing();
        received_ += static_cast<std::int64_t>(count);
        if (wanted_.bytes > 0 && begin_ + received_ > wanted_.bytes) {
            out_.close();
            forget(wanted_.part);
            throw Error("{}: expected {} bytes, found more; another file than the one known", wanted_.url,
                        wanted_.bytes);
        }
        out_.write(bytes, static_cast<std::streamsize>(count));
        if (!out_) throw Error("{}: cannot be written: is the disk full?", wanted_.part.string());
        if (wanted_.heard) wanted_.heard(begin_ + received_, wanted_.bytes > 0 ? wanted_.bytes : total_);
    }

    Fetched verdict(CURLcode code) {
        const long said = is_web() ? status() : 0;
        if (said == 404 || said == 410 || code == CURLE_FILE_COULDNT_READ_FILE) return Fetched::absent;
        if (said == 416) {  // nothing is left to send, or the partial data does not match
            if (answer_.range_total && *answer_.range_total == begin_ && begin_ > 0) return Fetched::whole;
            forget(wanted_.part);
            throw Interrupted("the server has no bytes beyond those already here");
        }
        if (said == 429 || said >= 500) throw Interrupted(fmt::format("the server says {}", said));
        if (said == 401 || said == 403)
            throw Error("{}: the server refuses ({}): does the file ask for an account? Fetch it by hand", wanted_.url,
                        said);
        if (said >= 400) throw Error("{}: expected the file, found the answer {}", wanted_.url, said);
        if (code == CURLE_TOO_MANY_REDIRECTS)
            throw Error("{}: expected a file, found more than {} redirects", wanted_.url, kMostRedirects);
        if (code == CURLE_URL_MALFORMAT || code == CURLE_UNSUPPORTED_PROTOCOL || code == CURLE_PEER_FAILED_VERIFICATION)
            throw Error("{}: {}", wanted_.url, reason(code));
        if (code == CURLE_BAD_DOWNLOAD_RESUME || code == CURLE_RANGE_ERROR) {
            forget(wanted_.part);
            throw Interrupted(reason(code));
        }
        if (code != CURLE_OK) throw Interrupted(reason(code));
        if (received_ == 0 && begin_ == 0 && (!is_web() || wanted_.bytes == 0))
            throw Error("{}: expected a file, found 0 bytes (a folder, or a copy that failed?)", wanted_.url);
        const std::int64_t have = size_of(wanted_.part);
        if (wanted_.bytes > 0 && have < wanted_.bytes)
            throw Interrupted(fmt::format("the server sent {} of {} bytes", have, wanted_.bytes));
        return Fetched::whole;
    }
    std::string reason(CURLcode code) const { return error_[0] ? error_ : curl_easy_strerror(code); }

    // libcurl is C: exceptions must be stored until it has returned.
    template <class Act>
    std::size_t guarded(std::size_t ok, Act&& act) {
        try {
            act();
            return ok;
        } catch (...) {
            trouble_ = std::current_exception();
            return 0;
        }
    }
    static std::size_t on_header(char* data, std::size_t size, std::size_t count, void* self) {
        static_cast<Attempt*>(self)->answer_.read_line(std::string(data, size * count));
        return size * count;
    }
    static std::size_t on_bytes(char* data, std::size_t size, std::size_t count, void* self) {
        auto* attempt = static_cast<Attempt*>(self);
        return attempt->guarded(size * count, [&] { attempt->take(data, size * count); });
    }
    static int on_progress(void* self, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
        return static_cast<Attempt*>(self)->run_.stop.stop_requested() ? 1 : 0;
    }

    const Download& wanted_;
    const Run& run_;
    std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> curl_;
    std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)> headers_{nullptr, curl_slist_free_all};
    char error_[CURL_ERROR_SIZE] = "";
    std::string range_;
    Answer answer_;
    std::ofstream out_;
    std::int64_t begin_ = 0, received_ = 0, total_ = 0;
    std::exception_ptr trouble_;
};

void wait(std::chrono::milliseconds time, const Run& run) {
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock lock(mutex);
    stopped.wait_for(lock, run.stop, time, [] { return false; });
    run.check_stop();
}

}  // namespace

Fetched download(const Download& wanted, const Run& run) {
    static const bool ready = curl_global_init(CURL_GLOBAL_DEFAULT) == CURLE_OK;
    FASTSCENE_CHECK(ready);
    auto pause = wanted.first_wait;
    std::int64_t farthest = size_of(wanted.part);
    for (int fruitless = 0;;) {
        run.check_stop();
        Attempt attempt(wanted, run);
        try {
            const Fetched fetched = attempt.make();
            std::error_code ignored;
            if (fetched == Fetched::whole) fs::remove(Origin::file_of(wanted.part), ignored);
            return fetched;
        } catch (const Interrupted& e) {
            const bool fruitful = attempt.reached() > farthest;
            fruitless = fruitful ? 1 : fruitless + 1;
            if (fruitful) farthest = attempt.reached(), pause = wanted.first_wait;
            if (fruitless >= kFruitlessAttempts)
                throw Error("{}: given up after {} attempts: {}; what has arrived is kept, the same command goes on",
                            wanted.url, fruitless, e.what());
            run.note(fmt::format("{}: {}; once more in {:.0f} s", wanted.url, e.what(),
                                 std::chrono::duration<double>(pause).count()));
        }
        wait(pause, run);
        pause *= 2;
    }
}

}  // namespace fastscene
