// golden --set DIR [--only NETWORK] [--verbose]: holds this program's networks and measures against the outputs of the official code.
// A line a case: name, largest difference, relative L2, tolerance, verdict (of the tensor that comes nearest to its tolerance, or beyond).
#include <ATen/Parallel.h>
#include <ATen/core/grad_mode.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <thread>

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
    std::cout << fmt::format("{:<52} max {:.3e}  rel-l2 {:.3e}  tol {:.3e}  {}{}", name, f.max_abs, f.relative_l2, f.tolerance, f.good ? "ok" : "FAIL",
                             f.remark.empty() ? "" : "  (" + f.remark + ")")
              << std::endl;
}

// Returns whether all is well.
bool run_case(Case& one, const Checker& checker, bool verbose) {
    const std::string name = one.network().name() + "/" + one.name();
    try {
        checker(one);
    } catch (const Skipped& e) {
        std::cout << fmt::format("{:<52} skipped  ({})", name, e.what()) << std::endl;
        return true;
    } catch (const std::exception& e) {
        std::cout << fmt::format("{:<52} FAIL  ({})", name, e.what()) << std::endl;
        return false;
    }
    std::vector<Finding> findings = one.findings();
    if (findings.empty()) findings.push_back({"", 0, 0, 0, true, "nothing stored"});
    if (verbose)
        for (const Finding& f : findings) print("  " + f.name, f);
    const auto worst = std::max_element(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
        return a.good != b.good ? a.good : badness(a) < badness(b);   // what failed is shown first
    });
    Finding shown = *worst;
    const auto failed = std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return !f.good; });
    if (failed) shown.remark = fmt::format("{} of {}: {}{}", failed, findings.size(), worst->name, worst->remark.empty() ? "" : ": " + worst->remark);
    print(name, shown);
    return failed == 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Compares networks and measures with golden outputs of their official code.");
    std::string set;
    std::vector<std::string> only;
    bool verbose = false;
    int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    app.add_option("--set", set, "Folder of <network>/manifest.json and data.bin.")->required();
    app.add_option("--only", only, "Only these networks (or those that begin so).");
    app.add_option("--threads", threads, "Threads of the networks.");
    app.add_flag("--verbose", verbose, "A line for every tensor.");
    CLI11_PARSE(app, argc, argv);
    at::set_num_threads(std::max(1, threads));
    const at::NoGradGuard no_gradients;  // checkers of losses turn them on for themselves

    Checkers checkers;
    add_depth_checkers(checkers);
    add_diffusion_checkers(checkers);
    add_metrics_checkers(checkers);
    add_geometry_checkers(checkers);
    add_nets_checkers(checkers);

    int cases = 0, failed = 0;
    try {
        std::vector<std::string> networks;
        for (const auto& entry : fs::directory_iterator(set))
            if (fs::exists(entry.path() / "manifest.json") || fs::exists(entry.path() / "tokenizer.json"))
                networks.push_back(entry.path().filename());
        std::sort(networks.begin(), networks.end());
        for (const std::string& name : networks) {
            if (!only.empty() && std::none_of(only.begin(), only.end(), [&](const std::string& o) { return name.starts_with(o); })) continue;
            const Checker* checker = checker_for(checkers, name);
            if (!checker) {
                std::cout << fmt::format("{:<52} FAIL  (no checker for this network)", name) << std::endl;
                ++cases, ++failed;
                continue;
            }
            const Network network(set, name);
            for (const auto& [case_name, json] : network.json().at("cases").items()) {
                Case one(network, case_name, json);
                ++cases;
                failed += run_case(one, *checker, verbose) ? 0 : 1;
            }
        }
    } catch (const std::exception& e) {
        std::cerr << "golden: " << e.what() << '\n';
        return 1;
    }
    if (cases == 0) std::cerr << "golden: no case was found in " << set << '\n';
    std::cout << fmt::format("{} cases, {} failed", cases, failed) << std::endl;
    return failed || cases == 0;
}
