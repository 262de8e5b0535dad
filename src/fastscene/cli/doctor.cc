// Shows what is installed, what is missing, and how to get it.
#include <sys/statvfs.h>

#include <fstream>
#include <sstream>

#include "fastscene/base/data_files.h"
#include "fastscene/base/file.h"
#include "fastscene/base/isa.h"
#include "fastscene/base/memory.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/program.h"
#include "fastscene/cli/verb.h"
#include "fastscene/gpu/device.h"
#include "fastscene/models/cache.h"
#include "fastscene/nn/diffusion_memory.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/rooms/pack.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct Finding {
    std::string what, state, remedy;  // remedy empty: all is well
};

std::string instruction_sets() {
    std::string names;
    const auto add = [&](bool has, const char* name) {
        if (has) names += (names.empty() ? "" : " ") + std::string(name);
    };
#if defined(__x86_64__)
    add(__builtin_cpu_supports("sse4.2"), "sse4.2");
    add(__builtin_cpu_supports("avx"), "avx");
    add(__builtin_cpu_supports("avx2"), "avx2");
    add(__builtin_cpu_supports("fma"), "fma");
    add(__builtin_cpu_supports("avx512f"), "avx512f");
#endif
    return names.empty() ? "baseline" : names;
}

std::string instruction_set_in_use() {
    const char* const why = isa() < processor_isa() ? "as FASTSCENE_ISA says" : "the best of this processor";
    return fmt::format("{} in use, {}; compiled for {} and above", isa_name(isa()), why, isa_name(compiled_isa()));
}

// Listed with the number that --splat-device and --panorama-trace-device take.
Finding graphics_card(const gpu::DeviceInfo& d) {
    const std::string state = fmt::format("{}: {}, {:.1f} GiB, {}{}", d.index, d.name,
                                          static_cast<double>(d.memory) / (1 << 30), d.driver,
                                          d.is_card ? "" : "; a processor, used only if asked for by number or name");
    if (d.missing.empty()) return {"graphics card", state, ""};
    return {"graphics card", fmt::format("{}; lacks {}", state, fmt::join(d.missing, ", ")),
            "install a newer driver; --splat-backend cpu and --panorama-trace-backend cpu work without"};
}

double memory_gib(const std::string& field) {
    std::ifstream info("/proc/meminfo");
    for (std::string word; info >> word;)
        if (word == field + ":") {
            double kib = 0;
            info >> kib;
            return kib / (1024 * 1024);
        }
    return 0;
}

Finding memory() {
    constexpr double kNeedGib = 4;  // what a standard run may take
    const double have = static_cast<double>(available_memory()) / (1 << 30);
    return {"memory", fmt::format("{:.1f} GiB, {:.1f} available", memory_gib("MemTotal"), have),
            have >= kNeedGib ? "" : "close other programs, or use --quality draft"};
}

// Memory needs of --panorama diffusion360 by setting, and whether the smallest fits.
Finding painting_memory() {
    const auto need = [](int width, const char* precision, bool low) {
        return gib_text(standard_diffusion_memory(width, precision, low));
    };
    std::string state;
    for (const int width : {1024, 2048})
        state += fmt::format("{}{} x {}: {}, bf16 {}, low memory {}", state.empty() ? "" : "; ", width, width / 2,
                             need(width, "float", false), need(width, "bf16", false), need(width, "float", true));
    const std::int64_t have = available_memory(), all = standard_diffusion_memory(1024, "float", false),
                       least = standard_diffusion_memory(1024, "float", true);
    const std::string remedy = have == 0 || have >= all ? ""
                               : have >= least
                                   ? "use --panorama-low-memory"
                                   : "optional: generating a panorama needs more free memory than available";
    return {"to paint", state, remedy};
}

Finding pulled_models() {
    std::vector<std::string> here;
    for (const Model& model : models())
        if (is_in_cache(model)) here.push_back(model.name);
    return {"models",
            fmt::format("{} of {} in {} (optional: fastscene models list){}{}", here.size(), models().size(),
                        models_root().string(), here.empty() ? "" : ": ", fmt::join(here, ", ")),
            ""};
}

Finding disk() {
    struct statvfs info {};
    if (::statvfs(".", &info) != 0) return {"disk here", "unknown", ""};
    const double gib = static_cast<double>(info.f_bavail) * static_cast<double>(info.f_frsize) / (1 << 30);
    return {"disk here", fmt::format("{:.1f} GiB free", gib),
            gib >= 1 ? "" : "a run takes up to 1 GiB: free some, or choose another folder with -o"};
}

// The packages listed in one of our files, one per line; # starts a comment.
std::vector<std::string> packages_of(const fs::path& list) {
    std::vector<std::string> names;
    if (!fs::exists(list)) return names;
    std::istringstream lines(read_file(list));
    for (std::string line; std::getline(lines, line);) {
        line = line.substr(0, line.find('#'));
        std::istringstream words(line);
        for (std::string word; words >> word;) names.push_back(word);
    }
    return names;
}

// Whether dpkg's status file lists the package as installed.
bool is_installed(const std::string& status, const std::string& package) {
    const auto at = status.find("\nPackage: " + package + "\nStatus: install ok installed");
    return at != std::string::npos;
}

Finding packages(const std::string& name, const fs::path& list) {
    std::vector<std::string> missing;
    if (!fs::exists("/var/lib/dpkg/status")) return {name, "not a Debian system: see " + list.string(), ""};
    const std::string status = "\n" + read_file("/var/lib/dpkg/status");
    const std::vector<std::string> wanted = packages_of(list);
    for (const std::string& package : wanted)
        if (!is_installed(status, package)) missing.push_back(package);
    if (missing.empty()) return {name, fmt::format("all {} installed", wanted.size()), ""};
    return {name, fmt::format("{} of {} missing", missing.size(), wanted.size()),
            fmt::format("apt-get install --no-install-recommends {}", fmt::join(missing, " "))};
}

Finding program(const std::string& name, const std::string& use, const std::string& remedy) {
    const auto found = find_program(name);
    return {name, found ? found->string() : "missing (" + use + ")", found ? "" : remedy};
}

// Optional: built-in furniture suffices for any room; the pack adds unusual pieces.
Finding furniture() {
    std::vector<std::string> complaints;
    const fs::path folder = FurniturePack::default_folder();
    const auto pack = FurniturePack::open(folder, {Assets::all, {}}, complaints);
    if (!complaints.empty())
        return {"furniture pack",
                pack ? "damaged: " + complaints.front()
                     : "missing (optional: dogs, electric guitars and other pieces beyond the built-in ones; 120 MB)",
                "apt-get install --no-install-recommends sweethome3d-furniture"};
    return {"furniture pack", fmt::format("{} models in {}", pack->size(), folder.string()), ""};
}

std::vector<Finding> examine() {
    std::vector<Finding> all;
    all.push_back(
        {"fastscene", fmt::format("{} ({})", program_version(), build_json().at("compiler").get<std::string>()), ""});
    all.push_back({"processor", instruction_sets(), ""});
    all.push_back({"instruction set", instruction_set_in_use(), ""});
    all.push_back({"threads", std::to_string(thread_count()), ""});
    for (const gpu::DeviceInfo& device : gpu::list_devices()) all.push_back(graphics_card(device));
    all.push_back(memory());
    all.push_back(painting_memory());
    all.push_back(pulled_models());
    all.push_back(disk());
    // Only build trees have these lists; an installed package declares its dependencies.
    if (const auto list = find_data("packaging/apt.txt")) all.push_back(packages("packages to build", *list));
    if (const auto list = find_data("packaging/apt-test.txt")) all.push_back(packages("packages to test", *list));
    const auto viewer = find_viewer_dir();
    all.push_back(
        {"viewer", viewer ? viewer->string() : "missing: scenes get no viewer.html", viewer ? "" : viewer_remedy()});
    all.push_back(furniture());
    all.push_back(program("node", "to install the viewer", "apt-get install --no-install-recommends nodejs"));
    all.push_back(program("npm", "to install the viewer", "apt-get install --no-install-recommends npm"));
    all.push_back(program("ffmpeg", "optional: films", "apt-get install --no-install-recommends ffmpeg"));
    all.push_back(
        program("colmap", "optional: to check the views with", "apt-get install --no-install-recommends colmap"));
    return all;
}

}  // namespace

Verb add_doctor(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("doctor", "Shows what is installed, what is missing, and how to get it.");
    return {verb, [](const Session& session) {
                std::string text;
                Json json = Json::array();
                for (const Finding& finding : examine()) {
                    text += fmt::format("{} {:<18} {}\n", finding.remedy.empty() ? "ok  " : "MISS", finding.what,
                                        finding.state);
                    if (!finding.remedy.empty()) text += fmt::format("     {:<18} -> {}\n", "", finding.remedy);
                    json.push_back({{"what", finding.what},
                                    {"state", finding.state},
                                    {"ok", finding.remedy.empty()},
                                    {"remedy", finding.remedy}});
                }
                text.pop_back();
                session.print(text, json);
            }};
}

}  // namespace fastscene::cli
