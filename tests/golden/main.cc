// golden --set DIR [--only NETWORK] [--verbose]: compares this program's networks and metrics with the outputs of the
// official code. One line per case: name, maximum difference, relative L2, tolerance, verdict (of the tensor closest to
// its tolerance, or beyond it).
#include <ATen/Parallel.h>
#include <ATen/core/grad_mode.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <thread>

#include "fastscene/base/library_settings.h"
#include "golden.h"

using namespace fastscene;
using namespace fastscene::golden;

namespace {

namespace fs = std::filesystem;

const Checker* checker_for(const Checkers& checkers, const std::string& network) {
    for (const auto& [pattern, checker] : checkers) {
        const bool open = pattern.ends_with('*');
        if (open ? network.starts_with(pattern.substr(0, pattern.size() - 1)) : network == pattern) return &checker;
    }
    return nullptr;
}

double badness(const Finding& f) {
    if (!f.good) return std::isfinite(f.max_abs) && f.tolerance > 0 ? 1e6 + f.max_abs / f.tolerance : 1e12;
    return f.tolerance > 0 ? f.max_abs / f.tolerance : 0;
}

void print(const std::string& name, const Finding& f) {
    std::cout << fmt::format("{:<52} max {:.3e}  rel-l2 {:.3e}  tol {:.3e}  {}{}", name, f.max_abs, f.relative_l2,
                             f.tolerance, f.good ? "ok" : "FAIL", f.remark.empty() ? "" : "  (" + f.remark + ")")
              << std::endl;
}

// Outcomes of the cases, and missing files with the number of cases that need them.
struct Tally {
    int ran = 0, failed = 0, skipped = 0, partly = 0;
    std::map<std::string, int> skipped_without, partly_without;
};

std::string listed(const std::map<std::string, int>& without) {
    std::string out;
    for (const auto& [file, count] : without)
        out += fmt::format("{}{} without {}", out.empty() ? "" : ", ", count, file);
    return out;
}
std::string summary(const Tally& t) {
    std::string out = fmt::format("golden: {} cases ran, {} failed, {} skipped", t.ran, t.failed, t.skipped);
    if (t.skipped) out += fmt::format(" ({})", listed(t.skipped_without));
    if (t.partly) out += fmt::format(", {} ran in part ({})", t.partly, listed(t.partly_without));
    return out;
}

void run_case(Case& one, const Checker& checker, bool verbose, Tally& tally) {
    const std::string name = one.network().name() + "/" + one.name();
    try {
        checker(one);
    } catch (const Skipped& e) {
        std::cout << fmt::format("{:<52} skipped  (needs {})", name, e.what()) << std::endl;
        ++tally.skipped;
        ++tally.skipped_without[e.what()];
        return;
    } catch (const std::exception& e) {
        std::cout << fmt::format("{:<52} FAIL  ({})", name, e.what()) << std::endl;
        ++tally.ran, ++tally.failed;
        return;
    }
    ++tally.ran;
    tally.partly += one.lacked().empty() ? 0 : 1;
    for (const std::string& file : one.lacked()) ++tally.partly_without[file];
    std::vector<Finding> findings = one.findings();
    if (findings.empty()) findings.push_back({"", 0, 0, 0, true, "nothing stored"});
    if (verbose)
        for (const Finding& f : findings) print("  " + f.name, f);
    const auto worst = std::max_element(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
        return a.good != b.good ? a.good : badness(a) < badness(b);  // failures first
    });
    Finding shown = *worst;
    const auto failed = std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return !f.good; });
    if (failed)
        shown.remark = fmt::format("{} of {}: {}{}", failed, findings.size(), worst->name,
                                   worst->remark.empty() ? "" : ": " + worst->remark);
    print(name, shown);
    tally.failed += failed ? 1 : 0;
}

int run(int argc, char** argv) {
    CLI::App app("Compares networks and measures with golden outputs of their official code.");
    std::string set, original;
    std::vector<std::string> only;
    bool verbose = false;
    int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    app.add_option("--set", set, "Folder of <network>/manifest.json and data.bin.")->required();
    app.add_option("--only", only, "Only these networks (or those that begin so).");
    app.add_option("--threads", threads, "Threads of the networks.");
    app.add_option("--copy-of", original, "Computes nothing: is the set a true copy of (part of) this one?");
    app.add_flag("--verbose", verbose, "A line for every tensor.");
    CLI11_PARSE(app, argc, argv);
    if (!original.empty()) return is_a_true_copy(set, original) ? 0 : 1;
    at::set_num_threads(std::max(1, threads));
    const at::NoGradGuard no_gradients;  // checkers of losses enable them individually

    Checkers checkers;
    add_depth_checkers(checkers);
    add_diffusion_checkers(checkers);
    add_metrics_checkers(checkers);
    add_geometry_checkers(checkers);
    add_nets_checkers(checkers);

    Tally tally;
    std::vector<std::string> networks;
    for (const auto& entry : fs::directory_iterator(set))
        if (fs::exists(entry.path() / "manifest.json") || fs::exists(entry.path() / "tokenizer.json"))
            networks.push_back(entry.path().filename());
    std::sort(networks.begin(), networks.end());
    for (const std::string& name : networks) {
        if (!only.empty() &&
            std::none_of(only.begin(), only.end(), [&](const std::string& o) { return name.starts_with(o); }))
            continue;
        const Checker* checker = checker_for(checkers, name);
        if (!checker) {
            std::cout << fmt::format("{:<52} FAIL  (no checker for this network)", name) << std::endl;
            ++tally.ran, ++tally.failed;
            continue;
        }
        const Network network(set, name);
        for (const auto& [case_name, json] : network.json().at("cases").items()) {
            Case one(network, case_name, json);
            run_case(one, *checker, verbose, tally);
        }
    }
    if (tally.ran + tally.skipped == 0) throw Error("no case was found in {}", set);
    std::cout << summary(tally) << std::endl;
    return tally.failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        begin_within_isa(argv);
        return run(argc, argv);
    } catch (const UsageError& e) {
        std::cerr << "golden: " << e.what() << '\n';
        return 2;
    } catch (const std::exception& e) {
        std::cerr << "golden: " << e.what() << '\n';
        return 1;
    }
}
