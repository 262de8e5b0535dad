// The web app on this machine.
#include <filesystem>
#include <random>
#include <thread>

#include "fastscene/base/data_files.h"
#include "fastscene/base/program.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/request.h"
#include "fastscene/cli/verb.h"
#include "fastscene/studio/web_server.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct StudioFlags {
    std::string folder = "out", host = "127.0.0.1", token, certificate, key;
    int port = 8420;
    bool no_open = false;
    std::shared_ptr<RequestFlags> scene = std::make_shared<RequestFlags>();  // settings of all scenes
    CLI::App* verb = nullptr;
};

constexpr std::size_t kLeastToken = 16;  // characters: short ones can be guessed

// The settings given for all scenes, as the command line of one. Throws UsageError if one is out of bounds.
std::vector<std::string> flags_for_make(const StudioFlags& flags) {
    SceneParams params = params_of_quality(flags.scene->quality);
    apply_param_flags(params, *flags.scene->given);
    check_params(params);
    std::vector<std::string> out;
    for (const auto& [name, text] : *flags.scene->given) {
        out.push_back(name);
        if (flags.verb->get_option(name)->get_items_expected_max() > 0) out.push_back(text);
    }
    return out;
}

std::string random_token() {
    std::random_device device;
    std::string token;
    for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", device());
    return token;
}

studio::WebParams web_params(const StudioFlags& flags) {
    const bool local = flags.host == "127.0.0.1" || flags.host == "localhost" || flags.host == "::1";
    if (flags.certificate.empty() != flags.key.empty())
        throw UsageError("--tls-cert: expected together with --tls-key, found one of them");
    if (!flags.token.empty() && flags.token.size() < kLeastToken)
        throw UsageError("--token: expected at least {} characters, found {}", kLeastToken, flags.token.size());
    for (const std::string& file : {flags.certificate, flags.key})
        if (!file.empty() && !fs::exists(file)) throw UsageError("{}: expected a file, found none", file);
    const auto pages = find_data("studio");
    if (!pages || !fs::exists(*pages / "index.html"))
        throw Error(
            "the studio's pages are missing: run `npm ci --ignore-scripts` in the folder web/ of the sources, then "
            "build again");
    const std::string token = !flags.token.empty() || local ? flags.token : random_token();
    return {*pages, flags.host, flags.port, token, flags.certificate, flags.key};
}

// If there is a display; a missing browser is no error.
void open_in_browser(const std::string& address) {
    if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return;
    const auto opener = find_program("xdg-open");
    if (!opener) return;
    std::thread([opener = *opener, address] {
        try {
            run_program(opener, {address});
        } catch (const std::exception&) {
        }
    }).detach();
}

void act_studio(const StudioFlags& flags, const Session& session) {
    const studio::WebParams web = web_params(flags);
    studio::ApiParams params{fs::read_symlink("/proc/self/exe"), flags_for_make(flags), session.common.threads};
    studio::Library library(flags.folder);
    studio::Board board;
    studio::Api api(library, board, std::move(params));
    const std::jthread warming([&] { api.warm_up(); });
    studio::serve(api, library, board, web, session.stop, [&](const std::string& address) {
        session.print(address, {{"address", address}, {"folder", library.root().string()}});
        session.run(0).note("Ctrl-C ends it; unfinished scenes resume at the next start");
        if (!flags.no_open) open_in_browser(address);
    });
}

}  // namespace

Verb add_studio(CLI::App& app) {
    auto flags = std::make_shared<StudioFlags>();
    CLI::App* verb = app.add_subcommand(
        "studio", "Serves a web page to make scenes, walk through them and change them, until Ctrl-C.");
    flags->verb = verb;
    verb->add_option("folder", flags->folder, "Folder of the scenes; existing ones are shown.")
        ->type_name("DIR")
        ->capture_default_str();
    verb->add_option("--port", flags->port, "Port; 0 = any free one.")
        ->type_name("N")
        ->check(whole_number_within(0, 65535))
        ->capture_default_str();
    verb->add_option("--host", flags->host,
                     "Address to listen on. Any but a loopback address requires a token, which is printed.")
        ->type_name("ADDRESS")
        ->capture_default_str();
    verb->add_option("--token", flags->token, "Token that browsers must present; default with --host: a random one.")
        ->type_name("TEXT");
    verb->add_option("--tls-cert", flags->certificate, "Certificate (PEM), for https.")->type_name("FILE");
    verb->add_option("--tls-key", flags->key, "Its private key (PEM).")->type_name("FILE");
    verb->add_flag("--no-open", flags->no_open, "Do not open a browser.");
    add_param_flags(*verb, flags->scene, "splat");
    verb->remove_option(verb->get_option("--quality"));  // the page asks for it
    verb->footer("Example:\n  fastscene studio out");
    return {verb, [flags](const Session& session) { act_studio(*flags, session); }};
}

}  // namespace fastscene::cli
