// One of three files that include httplib (studio/web_server.cc, send_file.cc), to contain its macros.
#include "fastscene/cli/server.h"

#include <httplib.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/viewer.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/studio/local_request.h"
#include "fastscene/studio/send_file.h"

namespace fastscene::cli {
namespace {

std::string settings_of(const RunFolder& folder, const std::stop_token& stop) {
    const bool captured = first_glance_of_capture(folder).has_value();
    const std::string title = captured ? folder.root.filename().string()
                                       : title_of(recorded_run(folder).request.source);
    return viewer_settings(viewer_scene(folder, title, {0, nullptr, stop}));
}

// The run's own page, which holds visitors to the walkable floor. The viewer's folder shows splats that were trained
// since it was made.
bool own_page_is_current(const RunFolder& folder) {
    namespace fs = std::filesystem;
    return fs::exists(folder.viewer_html()) &&
           fs::last_write_time(folder.viewer_html()) >= fs::last_write_time(folder.scene_compressed_ply());
}

std::vector<std::string> headers_named(const httplib::Request& request, const std::string& name) {
    std::vector<std::string> values;
    for (auto [at, end] = request.headers.equal_range(name); at != end; ++at) values.push_back(at->second);
    return values;
}

// The page and its scripts run, nothing comes from outside, and no other page shows it. Scenes may come from others:
// their scripts see this scene's files alone.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval' blob: data:; style-src 'self' "
    "'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self' data: blob:; worker-src "
    "'self' data: blob:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'";

void refuse(httplib::Response& response, int status, const std::string& why) {
    response.status = status;
    response.set_content("Refused: " + why + ".\n", "text/plain; charset=utf-8");
}

// Before all routes.
void refuse_other_sites(httplib::Server& server) {
    server.set_pre_routing_handler([](const httplib::Request& request, httplib::Response& response) {
        const auto why = studio::refusal(headers_named(request, "Host"), headers_named(request, "Origin"));
        if (why) refuse(response, 403, *why);
        else if (studio::has_too_many_ranges(request)) refuse(response, 416, "too many ranges");
        else return httplib::Server::HandlerResponse::Unhandled;
        return httplib::Server::HandlerResponse::Handled;
    });
    server.set_post_routing_handler([](const httplib::Request&, httplib::Response& response) {
        studio::set_safe_headers(response);
        if (!response.has_header("Content-Security-Policy")) response.set_header("Content-Security-Policy", kPolicy);
    });
}

}  // namespace

void serve_scene(const RunFolder& folder, const std::optional<std::filesystem::path>& viewer_dir, int port,
                 std::stop_token stop, const std::function<void(const std::string&)>& ready) {
    if (!viewer_dir && !std::filesystem::exists(folder.viewer_html()))
        throw Error("{}: {}", folder.viewer_html().string(), viewer_remedy());
    httplib::Server server;
    studio::limit_clients(server);
    server.set_payload_max_length(0);  // nothing is sent here
    refuse_other_sites(server);
    const std::string settings = viewer_dir && !own_page_is_current(folder) ? settings_of(folder, stop) : "";
    server.Get("/", [&](const httplib::Request&, httplib::Response& response) {
        // Splats of photographs are shown upright, whatever the axes of their model.
        const std::string splats = first_glance_of_capture(folder) ? "/splat/viewer.compressed.ply"
                                                                   : "/splat/scene.compressed.ply";
        response.set_redirect(viewer_dir && !own_page_is_current(folder)
                                  ? "/viewer/index.html?noanim&settings=/settings.json&content=" + splats
                                  : "/viewer.html");
    });
    server.Get("/settings.json", [&](const httplib::Request&, httplib::Response& response) {
        response.set_content(settings, "application/json");
    });
    // Browsers ask for an icon; an answer keeps an error out of the console.
    server.Get("/favicon.ico", [](const httplib::Request&, httplib::Response& response) { response.status = 204; });
    server.Get("/.*", [&](const httplib::Request& request, httplib::Response& response) {
        const std::string viewer = "/viewer/";
        const bool of_viewer = viewer_dir && request.path.starts_with(viewer);
        const auto file = of_viewer ? studio::file_below(*viewer_dir, request.path.substr(viewer.size()))
                                    : studio::file_below(folder.root, request.path.substr(1));
        if (file) return studio::send_file(request, response, *file, kPolicy);
        response.status = 404;
        response.set_content("There is no such file.\n", "text/plain; charset=utf-8");
    });

    const int bound = port == 0 ? server.bind_to_any_port("127.0.0.1")
                                : (server.bind_to_port("127.0.0.1", port) ? port : -1);
    if (bound <= 0)
        throw Error(
            "--port {}: cannot listen on 127.0.0.1:{}: is another program there? Choose another port, or 0 for any",
            port, port);
    ready("http://127.0.0.1:" + std::to_string(bound) + "/");
    const std::stop_callback stopper(stop, [&] { server.stop(); });
    if (!stop.stop_requested()) server.listen_after_bind();
}

}  // namespace fastscene::cli
