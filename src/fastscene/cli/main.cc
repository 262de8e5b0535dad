// fastscene COMMAND …: results on stdout, everything else on stderr. Exit code 0, 1 (failed), 2 (usage), 128 + signal
// if stopped.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/base/isa.h"
#include "fastscene/base/library_settings.h"
#include "fastscene/base/parallel.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/inpaint.h"
#include "fastscene/cli/progress.h"
#include "fastscene/cli/signals.h"
#include "fastscene/cli/usage.h"
#include "fastscene/cli/verb.h"
#include "fastscene/base/failure.h"
#include "fastscene/pipeline/build_info.h"

namespace fastscene::cli {

void Session::print(const std::string& text, const Json& json) const {
    std::cout << (common.json ? json.dump(2, ' ', false, Json::error_handler_t::replace) : text) << std::endl;
    if (!std::cout) throw Error("stdout: cannot be written");
}

namespace {

void add_common_flags(CLI::App& verb, const std::shared_ptr<Common>& common) {
    verb.add_option("--threads", common->threads, "Number of threads; 0 = all cores. The result does not depend on it.")
        ->type_name("N")
        ->check(whole_number_within(0, 4096))
        ->capture_default_str();
    verb.add_flag("--json", common->json, "Write the result to stdout as JSON.");
    verb.add_option("--progress", common->progress, "How progress is shown on stderr.")
        ->type_name("auto|plain|json|none")
        ->check(one_of({"auto", "plain", "json", "none"}))
        ->capture_default_str();
}

int usage(const std::string& text) {
    std::cerr << "fastscene: " << printable(text) << std::endl;
    return 2;
}

// Settings that are read when libraries are loaded, for which commands with networks restart. Unless already set by the
// start script or the user: waiting libtorch threads sleep (spinning ones occupy cores: beside another program, depth
// estimation takes ten times as long), and large allocations use huge pages (a twentieth of the page faults). Libraries
// are limited to the instruction set in use. If restarting is not possible, the command continues without.
void begin_with_settings(const std::string& verb, char** argv) {
    if (!is_one_of(verb, {"make", "panorama", "depth", "walk", "inpaint", "splat", "metrics", "evaluate", "edit"}))
        return;
    std::vector<Setting> settings = library_settings(isa());
    for (const Setting& usual :
         {Setting{"OMP_WAIT_POLICY", "passive"}, Setting{"GLIBC_TUNABLES", "glibc.malloc.hugetlb=1"}}) {
        const bool taken = std::any_of(settings.begin(), settings.end(),
                                       [&](const Setting& s) { return s.name == usual.name; });
        if (!taken && !std::getenv(usual.name.c_str())) settings.push_back(usual);
    }
    begin_with(settings, argv);
}

int act(const Verb& verb, const Common& common, const SignalWatch& signals) {
    ProgressDisplay display(std::cerr, progress_style(common.progress, ::isatty(STDERR_FILENO) == 1));
    const auto fail = [&](const std::string& text, int code) {
        display.end_line();
        std::cerr << "fastscene: " << printable(text) << std::endl;
        return code;
    };
    try {
        set_threads(common.threads);
        verb.act({common, &display, signals.token()});
        return 0;
    } catch (const UsageError& e) {
        return fail(e.what(), 2);
    } catch (const Stopped&) {
        return fail(std::string(kStoppedText), 128 + signals.signal());
    } catch (const CheckFailed& e) {
        return fail(std::string("internal error, please report it: ") + e.what(), 1);
    } catch (const std::exception& e) {
        return fail(is_lack_of_memory(e) ? "not enough memory: close other programs, or use a lower --quality"
                                         : short_message(e),
                    1);
    }
}

int run(int argc, char** argv) {
    SignalWatch signals;
    CLI::App app("From a sentence to a 3D indoor scene you can walk through.", "fastscene");
    app.require_subcommand(1);
    app.option_defaults()->multi_option_policy(
        CLI::MultiOptionPolicy::TakeLast);  // so that a script's defaults can be overridden
    app.get_formatter()->column_width(34);
    bool version = false;
    app.add_flag("--version", version, "Print the version and exit.");
    const std::vector<Verb> verbs{
        add_make(app),    add_studio(app),  add_demo(app),    add_panorama(app), add_depth(app),      add_walk(app),
        add_views(app),   add_splat(app),   add_metrics(app), add_evaluate(app), add_batch(app),      add_render(app),
        add_convert(app), add_view(app),    add_edit(app),    add_export(app),   add_rooms(app),      add_dataset(app),
        add_assets(app),  add_inpaint(app), add_models(app),  add_doctor(app),   add_completion(app), add_version(app)};
    // After the commands, which would otherwise inherit it.
    app.footer("Example:\n  fastscene make \"a cozy bedroom with a red armchair and a large window\" -o out/bedroom");
    auto common = std::make_shared<Common>();
    for (const Verb& verb : verbs) add_common_flags(*verb.app, common);
    try {
        app.parse(argc, argv);
        check_values(app);
        (void)isa();  // report an invalid FASTSCENE_ISA before anything else
    } catch (const CLI::Success& e) {
        if (app.get_subcommands().empty() && has_unknown_words(app)) return usage(unknown_argument(app));  // mak --help
        return app.exit(e);                                                                                // --help
    } catch (const CLI::ExtrasError&) {
        return usage(unknown_argument(app));
    } catch (const CLI::RequiredError&) {
        if (version) {
            std::cout << "fastscene " << program_version() << std::endl;
            return 0;
        }
        if (argc <= 1) {
            std::cerr << app.help();
            return 2;
        }
        return usage(app.remaining(true).empty() ? missing_argument(app) : unknown_argument(app));
    } catch (const CLI::ParseError& e) {
        return usage(bad_value(app, e));
    } catch (const UsageError& e) {
        return usage(e.what());
    }
    for (const Verb& verb : verbs)
        if (verb.app->parsed()) {
            begin_with_settings(verb.app->get_name(), argv);
            signals.begin();
            return act(verb, *common, signals);
        }
    return 2;
}

}  // namespace
}  // namespace fastscene::cli

int main(int argc, char** argv) {
    try {
        return fastscene::cli::run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "fastscene: " << e.what() << std::endl;
        return 1;
    }
}
