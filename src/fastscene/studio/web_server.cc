#include "fastscene/studio/web_server.h"

#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <thread>

#include "fastscene/base/error.h"
#include "fastscene/studio/local_request.h"
#include "fastscene/studio/send_file.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

using namespace std::chrono_literals;
using httplib::Request;
using httplib::Response;

constexpr int kMostStreams = 32;      // each keeps a thread (send_file.cc)
constexpr auto kStreamEvery = 250ms;  // pages need no faster updates
constexpr auto kStreamWait = 1000ms;  // a closed page and the program's end are noticed within
constexpr std::size_t kMostJsonBytes = 1 << 20;
constexpr const char* kCookie = "fastscene_studio";

// The page: no resources of other origins, no inline scripts, no embedding in frames.
constexpr const char* kPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; img-src 'self' blob: data:; media-src "
    "'self'; connect-src 'self'; frame-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'";
// Files of scenes, which may come from others: scripts of viewer.html run, in an origin of their own that may not speak
// to the studio.
constexpr const char* kFilePolicy =
    "sandbox allow-scripts allow-pointer-lock; default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob: "
    "data:; style-src 'unsafe-inline'; img-src data: blob:; font-src data:; connect-src data: blob:; worker-src blob: "
    "data:; frame-ancestors 'self'; base-uri 'none'; form-action 'none'";

std::vector<std::string> values_of(const Request& request, const std::string& name) {
    std::vector<std::string> values;
    for (auto [at, end] = request.headers.equal_range(name); at != end; ++at) values.push_back(at->second);
    return values;
}

// In constant time, which does not reveal where they differ.
bool equal(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    unsigned differ = 0;
    for (std::size_t i = 0; i < a.size(); ++i) differ |= static_cast<unsigned char>(a[i] ^ b[i]);
    return differ == 0;
}

std::string cookie_of(const Request& request) {
    for (const std::string& header : values_of(request, "Cookie"))
        for (std::size_t at = 0; at < header.size();) {
            const std::size_t end = std::min(header.find(';', at), header.size());
            std::string_view pair(header.data() + at, end - at);
            while (pair.starts_with(' ')) pair.remove_prefix(1);
            const std::string key = std::string(kCookie) + "=";
            if (pair.starts_with(key)) return std::string(pair.substr(key.size()));
            at = end + 1;
        }
    return {};
}

std::vector<std::string> parts_of(const std::string& path) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at < path.size();) {
        const std::size_t end = std::min(path.find('/', at), path.size());
        if (end > at) parts.push_back(path.substr(at, end - at));
        at = end + 1;
    }
    return parts;
}

void send_json(Response& response, int status, const Json& json) {
    response.status = status;
    response.set_header("Cache-Control", "no-store");
    response.set_content(json.dump(-1, ' ', false, Json::error_handler_t::replace), "application/json");
}

class WebServer {
  public:
    WebServer(Api& api, Library& library, const Board& board, const WebParams& params, std::stop_token stop)
        : api_(api), library_(library), board_(board), params_(params), stop_(std::move(stop)) {}

    void run(const std::function<void(const std::string&)>& ready) {
        httplib::Server& server = make_server();
        limit_clients(server);
        server.set_payload_max_length(static_cast<std::size_t>(kMostUploadBytes));
        server.Get("/.*", [this](const Request& q, Response& r) {
            if (allowed(q, r)) get(q, r);
        });
        server.Post("/api/upload/.*", [this](const Request& q, Response& r, const httplib::ContentReader& content) {
            upload(q, r, content);
        });
        // The body is read before a request is refused: what is left on a connection would be taken for the next one.
        server.Post("/.*", [this](const Request& q, Response& r) {
            if (allowed(q, r)) post(q, r);
        });
        server.set_error_handler([](const Request&, Response& r) {
            if (!r.body.empty() || r.has_header("Content-Type")) return;
            const char* text = r.status == 413 ? "too large" : "invalid request";
            r.set_content(Json{{"error", text}}.dump(), "application/json");
        });
        server.set_post_routing_handler([](const Request&, Response& r) {
            set_safe_headers(r);
            if (!r.has_header("Content-Security-Policy")) r.set_header("Content-Security-Policy", kPagePolicy);
        });
        listen(server, ready);
    }

  private:
    bool is_tls() const { return !params_.tls_certificate.empty(); }

    httplib::Server& make_server() {
        if (!is_tls()) {
            server_ = std::make_unique<httplib::Server>();
        } else {
            server_ = std::make_unique<httplib::SSLServer>(params_.tls_certificate.c_str(), params_.tls_key.c_str());
            if (!server_->is_valid())
                throw Error("--tls-cert {}, --tls-key {}: expected a certificate and its key as PEM files",
                            params_.tls_certificate.string(), params_.tls_key.string());
        }
        return *server_;
    }

    void listen(httplib::Server& server, const std::function<void(const std::string&)>& ready) {
        const int bound = params_.port == 0 ? server.bind_to_any_port(params_.host)
                                            : (server.bind_to_port(params_.host, params_.port) ? params_.port : -1);
        if (bound <= 0)
            throw Error(
                "--port {}: cannot listen on {}:{}: is another program there? Choose another port, for example --port "
                "{}, or 0 for any",
                params_.port, params_.host, params_.port, params_.port == 65535 ? 8421 : params_.port + 1);
        ready(fmt::format("{}://{}:{}/{}", is_tls() ? "https" : "http", params_.host, bound,
                          params_.token.empty() ? "" : "?token=" + params_.token));
        const std::stop_callback stopper(stop_, [&] { server.stop(); });
        if (!stop_.stop_requested()) server.listen_after_bind();
    }

    // From a browser's page on this machine, or with the token.
    std::optional<std::string> why_refused(const Request& request) const {
        const auto hosts = values_of(request, "Host"), origins = values_of(request, "Origin");
        const std::string site = request.get_header_value("Sec-Fetch-Site");
        if ((site == "cross-site" || site == "same-site") && request.get_header_value("Sec-Fetch-Mode") != "navigate")
            return "the request comes from a page of another site";
        if (params_.token.empty()) return refusal(hosts, origins);
        if (hosts.size() != 1) return "expected one Host header";
        const std::string own = (is_tls() ? "https://" : "http://") + hosts.front();
        if (std::any_of(origins.begin(), origins.end(), [&](const std::string& o) { return o != own; }))
            return "the request comes from a page of another site";
        if (!equal(cookie_of(request), params_.token))
            return "open the address that the studio printed, with its token";
        return {};
    }

    bool allowed(const Request& request, Response& response) const {
        if (!params_.token.empty() && request.path == "/" && equal(request.get_param_value("token"), params_.token)) {
            response.set_header("Set-Cookie", fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict{}", kCookie,
                                                          params_.token, is_tls() ? "; Secure" : ""));
            response.set_redirect("/");
            return false;
        }
        const auto why = why_refused(request);
        if (why) send_json(response, 403, {{"error", "refused: " + *why}});
        else if (has_too_many_ranges(request)) send_json(response, 416, {{"error", "too many ranges"}});
        return !why && !has_too_many_ranges(request);
    }

    void get(const Request& request, Response& response) {
        const std::vector<std::string> parts = parts_of(request.path);
        const std::string first = parts.empty() ? "" : parts[0];
        if (first == "api" && parts.size() == 2 && parts[1] == "events") return stream(response);
        if (first == "api") return send(request, response, api_.answer({"GET", {parts.begin() + 1, parts.end()}, {}}));
        if (first == "files" && parts.size() > 2) {
            const std::size_t skip = request.path.find(parts[1], 6) + parts[1].size() + 1;
            const auto file = library_.file(parts[1], request.path.substr(skip));
            if (!file) return send_json(response, 404, {{"error", "there is no such file"}});
            return send_file(request, response, *file, kFilePolicy);
        }
        if (first == "assets" || first == "icon.svg" || first == "licenses.txt") return asset(request, response, parts);
        const bool known = parts.empty() || (first == "gallery" && parts.size() == 1) ||
                           (first == "scene" && parts.size() == 2 && api_.has_scene(parts[1]));
        if (!known) response.status = 404;
        send_file(request, response, params_.pages / "index.html", kPagePolicy);
    }

    void asset(const Request& request, Response& response, const std::vector<std::string>& parts) const {
        fs::path file = params_.pages;
        for (const std::string& part : parts) {
            if (part.front() == '.' || part.find('\0') != std::string::npos)
                return send_json(response, 404, {{"error", "there is no such file"}});
            file /= part;
        }
        // Their names change with their content.
        if (parts.front() == "assets") response.set_header("Cache-Control", "public, max-age=31536000, immutable");
        send_file(request, response, file, kPagePolicy);
    }

    void send(const Request& request, Response& response, const ApiAnswer& answer) {
        if (answer.file.empty()) return send_json(response, answer.status, answer.json);
        if (!answer.save_as.empty()) {
            std::string name = answer.save_as;
            std::replace_if(
                name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == '"' || c > '~'; }, '_');
            response.set_header("Content-Disposition", fmt::format("attachment; filename=\"{}\"", name));
        }
        send_file(request, response, answer.file, kFilePolicy);
    }

    void post(const Request& request, Response& response) {
        const std::vector<std::string> parts = parts_of(request.path);
        if (parts.size() < 2 || parts[0] != "api")
            return send_json(response, 404, {{"error", "there is no such address"}});
        // Pages of other sites cannot send this type unasked.
        if (!request.get_header_value("Content-Type").starts_with("application/json"))
            return send_json(response, 415, {{"error", "expected application/json"}});
        if (request.body.size() > kMostJsonBytes) return send_json(response, 413, {{"error", "too large"}});
        send(request, response,
             api_.answer({"POST", {parts.begin() + 1, parts.end()}, Json::parse(request.body, nullptr, false)}));
    }

    void upload(const Request& request, Response& response, const httplib::ContentReader& content) {
        const auto skip = [&] { content([](const char*, std::size_t) { return true; }); };
        if (!allowed(request, response)) return skip();
        if (request.get_header_value("Content-Type") != "application/octet-stream") {
            skip();
            return send_json(response, 415, {{"error", "expected application/octet-stream"}});
        }
        if (std::strtoll(request.get_header_value("Content-Length").c_str(), nullptr, 10) > kMostUploadBytes) {
            skip();
            return send_json(
                response, 413,
                {{"error", fmt::format("larger than {} MB: make the picture smaller", kMostUploadBytes >> 20)}});
        }
        const std::vector<std::string> parts = parts_of(request.path);
        const std::string kind = parts.size() == 3 ? parts[2] : "", name = request.get_param_value("name");
        const ApiAnswer answer = api_.upload(kind, name, [&](const Uploads::Put& put) {
            return content([&](const char* data, std::size_t size) { return put({data, size}); });
        });
        send(request, response, answer);
    }

    void stream(Response& response) {
        if (++streams_ > kMostStreams) {
            --streams_;
            return send_json(response, 503, {{"error", "too many open pages"}});
        }
        response.set_header("Cache-Control", "no-store");
        response.set_header("X-Accel-Buffering", "no");
        auto seen = std::make_shared<std::uint64_t>(0);
        response.set_chunked_content_provider(
            "text/event-stream",
            [this, seen](std::size_t, httplib::DataSink& sink) {
                const std::uint64_t now = board_.wait(*seen, kStreamWait);
                if (stop_.stop_requested()) return false;
                const std::string text = now == *seen
                                             ? std::string(": still here\n\n")
                                             : "data: " +
                                                   api_.live().dump(-1, ' ', false, Json::error_handler_t::replace) +
                                                   "\n\n";
                if (now != *seen) std::this_thread::sleep_for(kStreamEvery);
                *seen = now;
                return sink.write(text.data(), text.size());
            },
            [this](bool) { --streams_; });
    }

    Api& api_;
    Library& library_;
    const Board& board_;
    const WebParams& params_;
    std::stop_token stop_;
    std::unique_ptr<httplib::Server> server_;
    std::atomic<int> streams_{0};
};

}  // namespace

void serve(Api& api, Library& library, const Board& board, const WebParams& params, std::stop_token stop,
           const std::function<void(const std::string&)>& ready) {
    WebServer(api, library, board, params, std::move(stop)).run(ready);
}

}  // namespace fastscene::studio
