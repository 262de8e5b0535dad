#include "fastscene/studio/looks.h"

#include <sys/resource.h>

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/program.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

// A room that is recognized, in two and a half seconds of one core, most of them for building it.
const std::vector<std::string> kCoarse{"--quality",
                                       "draft",
                                       "--panorama-width",
                                       "320",
                                       "--panorama-cell",
                                       "0.2",
                                       "--panorama-cell-samples",
                                       "12",
                                       "--panorama-pixel-samples",
                                       "1",
                                       "--panorama-outside-detail",
                                       "0",
                                       "--progress",
                                       "none"};
constexpr int kNiceness = 10;           // of a wish: scenes in the making go first
constexpr std::size_t kMostLooks = 96;  // with the rooms; each has some hundred kilobytes

}  // namespace

Looks::Looks(Library& library, Board& board, fs::path program)
    : library_(library), board_(board), program_(std::move(program)) {
    worker_ = std::jthread([this](std::stop_token end) { work(end); });
}

Looks::~Looks() {
    worker_.request_stop();
    const std::lock_guard lock(mutex_);
    stop_.request_stop();
}

std::string Looks::key_of(const std::vector<std::string>& arguments) {
    Hash hash;
    for (const std::string& argument : arguments) hash.add(argument);
    return hash.hex();
}

fs::path Looks::picture(const std::string& key) const {
    const fs::path picture = library_.own("looks") / key / "panorama" / "color.png";
    return is_scene_name(key) && fs::exists(picture) ? picture : fs::path();
}

fs::path Looks::room_file(std::string_view document) const {
    const fs::path file = library_.own("looks") / ("room-" + Hash().add(std::string(document)).hex() + ".json");
    if (!fs::exists(file)) write_file(file, document);
    return file;
}

std::string Looks::latest() const {
    const std::lock_guard lock(mutex_);
    return latest_;
}

void Looks::wish(const std::vector<std::string>& arguments) {
    {
        const std::lock_guard lock(mutex_);
        if (in_work_ == key_of(arguments)) return;
        wished_ = arguments;
        stop_.request_stop();
    }
    condition_.notify_all();
}

void Looks::make(const std::vector<std::string>& arguments, const std::stop_token& stop) {
    const std::string key = key_of(arguments);
    {
        std::unique_lock lock(mutex_);
        condition_.wait(lock, stop, [&] { return in_work_ != key; });
    }
    if (stop.stop_requested()) throw Stopped();
    if (picture(key).empty()) run(arguments, 0, stop);
}

void Looks::run(const std::vector<std::string>& arguments, int niceness, const std::stop_token& stop) const {
    forget_old();
    const fs::path folder = library_.own("looks") / key_of(arguments);
    std::vector<std::string> all = arguments;
    all.insert(all.begin() + 1, kCoarse.begin(), kCoarse.end());
    all.insert(all.begin() + 1, {"-o", folder.string()});
    const fs::path log = library_.own("looks") / "log";
    std::error_code none;
    fs::remove(log, none);
    run_program(program_, all, {log, {}, stop, [&](int pid) {
                                    if (niceness > 0) ::setpriority(PRIO_PROCESS, static_cast<id_t>(pid), niceness);
                                }});
}

void Looks::work(const std::stop_token& end) {
    while (!end.stop_requested()) {
        std::vector<std::string> arguments;
        std::stop_token stop;
        {
            std::unique_lock lock(mutex_);
            if (!condition_.wait(lock, end, [&] { return wished_.has_value(); })) return;
            arguments = *std::exchange(wished_, {});
            in_work_ = key_of(arguments);
            stop_ = std::stop_source();
            stop = stop_.get_token();
        }
        try {
            if (picture(key_of(arguments)).empty()) run(arguments, kNiceness, stop);
        } catch (const std::exception&) {  // given up, or it cannot be made
        }
        {
            const std::lock_guard lock(mutex_);
            if (!picture(in_work_).empty()) latest_ = in_work_;
            in_work_.clear();
        }
        condition_.notify_all();
        board_.changed();
    }
}

void Looks::forget_old() const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(library_.own("looks")))
        if (entry.path().filename() != "log") all.push_back(entry.path());
    if (all.size() < kMostLooks) return;
    std::sort(all.begin(), all.end(),
              [](const fs::path& a, const fs::path& b) { return fs::last_write_time(a) < fs::last_write_time(b); });
    std::error_code none;
    for (std::size_t i = 0; i + kMostLooks / 2 < all.size(); ++i) fs::remove_all(all[i], none);
}

}  // namespace fastscene::studio
