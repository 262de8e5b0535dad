#include "fastscene/evaluate/evaluate.h"

#include "fastscene/cli/checks.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/verb.h"
#include "fastscene/evaluate/write.h"
#include "fastscene/metrics/images.h"

namespace fastscene::cli {
namespace {

struct EvaluateFlags {
    std::string suite, out, quality, weights, redraw, scenes = "0";
    std::vector<std::string> peers;
    bool show = false;
};

SuitePeer peer_from(const std::string& text) {
    const std::size_t at = text.find('=');
    if (at == std::string::npos || at == 0 || at + 1 == text.size())
        throw UsageError("--peer: expected NAME=DIR, found \"{}\"", text);
    return {text.substr(0, at), text.substr(at + 1)};
}

std::string list_of_suites() {
    std::string text = "Suites that ship:\n";
    for (const auto& [name, title] : shipped_suites()) text += fmt::format("  {:<14} {}\n", name, title);
    return text;
}

// Regenerates the report page from existing measurements.
void redraw(const std::filesystem::path& folder, const Session& session) {
    if (!std::filesystem::exists(folder / "results.json"))
        throw UsageError("--redraw: expected the folder of an evaluation, found no {}",
                         (folder / "results.json").string());
    const Json results = read_json(folder / "results.json");
    try {
        write_results(folder, results);
    } catch (const Json::exception& e) {
        throw Error("{}: expected what evaluate writes: {}", (folder / "results.json").string(), e.what());
    }
    session.print((folder / "report.html").string(), results);
}

// "1 of 4 scenes", "1 of 4 scenes and 2 of 3 of other systems"; empty: none.
std::string failed_text(const Json& results) {
    std::string text;
    for (const auto& [kind, what] : {std::pair{"ours", "scenes"}, std::pair{"peer", "of other systems"}}) {
        int failed = 0, all = 0;
        for (const Json& record : results.at("records")) {
            if (record.at("kind") != kind) continue;
            ++all;
            failed += record.contains("failed");
        }
        if (failed > 0) text += fmt::format("{}{} of {} {}", text.empty() ? "" : " and ", failed, all, what);
    }
    return text;
}

void act(const EvaluateFlags& flags, const Session& session) {
    if (!flags.redraw.empty()) return redraw(flags.redraw, session);
    if (flags.suite.empty()) {
        Json json = Json::array();
        for (const auto& [name, title] : shipped_suites()) json.push_back({{"name", name}, {"title", title}});
        std::string text = list_of_suites();
        text.pop_back();
        return session.print(text, json);
    }
    const SuiteText found = find_suite(flags.suite);
    const Suite suite = read_suite(found.text, found.name, found.file, flags.quality);
    if (flags.show)
        return session.print(found.text.substr(0, found.text.find_last_not_of('\n') + 1),
                             {{"name", found.name}, {"text", found.text}});
    EvaluateOptions options;
    options.out = flags.out.empty() ? std::filesystem::path("out") / ("evaluate-" + slug_of(suite.name))
                                    : std::filesystem::path(flags.out);
    options.weights = flags.weights;
    options.scenes = number_from<int>("--scenes", flags.scenes);
    if (options.scenes < 0) throw UsageError("--scenes: expected a number from 0, found {}", options.scenes);
    for (const std::string& peer : flags.peers) options.peers.push_back(peer_from(peer));
    const Run run = session.run(0);
    const Json results = evaluate(suite, options, run);
    std::string text = table_markdown(results);
    text.pop_back();
    session.print(text, results);
    run.note(fmt::format("open {} in a browser", (options.out / "report.html").string()));
    const std::string failed = failed_text(results);
    if (!failed.empty()) throw Error("{} failed; {} says why", failed, (options.out / "report.html").string());
}

}  // namespace

Verb add_evaluate(CLI::App& app) {
    auto flags = std::make_shared<EvaluateFlags>();
    CLI::App* verb = app.add_subcommand(
        "evaluate",
        "Makes and measures the scenes of a suite: one table, one report. Without a suite: lists those that ship.");
    verb->add_option("suite", flags->suite, "Name of a suite that ships, or a file (docs/evaluate.md).")
        ->type_name("SUITE");
    verb->add_option("-o,--out", flags->out,
                     "Folder of scenes, measures and report; goes on where it was. Default: out/evaluate-SUITE.")
        ->type_name("DIR");
    verb->add_option("--quality", flags->quality, "Preset for all scenes, instead of what the suite says.")
        ->type_name("draft|standard|high")
        ->check(one_of(qualities()));
    verb->add_option("--scenes", flags->scenes, "Only the first N scenes; 0: all.")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option(
            "--peer", flags->peers,
            "Another system as a row: NAME=DIR with SCENE/*.png, SCENE/source.png or SCENE.ply. May be given often.")
        ->type_name("NAME=DIR")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb->add_option("--weights", flags->weights,
                     "Folder of the metrics' parameters and networks, as for `metrics images`.")
        ->type_name("DIR");
    verb->add_option("--redraw", flags->redraw,
                     "Only write tables and page anew from DIR/results.json; nothing is made or measured.")
        ->type_name("DIR");
    verb->add_flag("--show", flags->show, "Check the suite and print its text, to begin one's own with.");
    verb->footer(list_of_suites());
    return {verb, [flags](const Session& session) { act(*flags, session); }};
}

}  // namespace fastscene::cli
