#include "fastscene/studio/job_queue.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "fastscene/base/file.h"
#include "fastscene/base/program.h"
#include "fastscene/studio/refusal.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

using namespace std::chrono_literals;
constexpr auto kLogEvery = 200ms;  // how often a log is read: progress looks steady
constexpr auto kOtherEvery = 500ms;
constexpr std::uintmax_t kFullDisk = 32 << 20;  // bytes left on a disk that is called full

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool is_locked(const fs::path& folder) {
    if (!fs::is_directory(folder)) return false;
    try {
        const FolderLock lock(folder);
        return false;
    } catch (const Error&) {
        return true;
    }
}

// Whether the process still is the one that makes this folder: numbers are given again.
bool makes(int pid, const fs::path& folder) {
    std::ifstream in(fmt::format("/proc/{}/cmdline", pid), std::ios::binary);
    const std::string line(std::istreambuf_iterator<char>(in), {});
    return pid > 0 && line.find('\0' + folder.string() + '\0') != std::string::npos;
}

// After the command's name: behind a prompt after "--" they would be words.
std::vector<std::string> with_flags(std::vector<std::string> arguments, const std::vector<std::string>& flags) {
    arguments.insert(arguments.begin() + 1, flags.begin(), flags.end());
    return arguments;
}

std::string why_it_failed(const Job& job, int code, const fs::path& folder) {
    std::error_code none;
    const auto space = fs::space(folder, none);
    const bool full = !none && space.available < kFullDisk;
    if (!job.error.empty()) return job.error;
    if (full) return "the disk is full: make room, then resume";
    if (code == 128 + SIGKILL)
        return "the process was killed: is there enough memory? Resume, or choose a lower quality";
    return fmt::format("the process ended with code {} and without a message", code);
}

}  // namespace

JobQueue::JobQueue(Library& library, Board& board, Looks& looks, QueueParams params)
    : library_(library), board_(board), looks_(looks), params_(std::move(params)), folder_(library.own("jobs")) {
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(folder_))
        if (file.path().extension() == ".json") files.push_back(file.path());
    std::sort(files.begin(), files.end(),
              [](const fs::path& a, const fs::path& b) { return fs::last_write_time(a) < fs::last_write_time(b); });
    for (const fs::path& file : files) {
        try {
            Entry left;
            left.job = job_from_record(read_json(file), file.string());
            if (left.job.state == JobState::running) left.job.state = JobState::waiting;
            if (left.job.state != JobState::finished) entries_.push_back(std::move(left));
        } catch (const Error&) {  // the other jobs go on
        }
    }
    worker_ = std::jthread([this](std::stop_token end) { work(end); });
}

JobQueue::~JobQueue() {
    worker_.request_stop();
    condition_.notify_all();
}

fs::path JobQueue::record(const std::string& id) const { return folder_ / (id + ".json"); }
fs::path JobQueue::log(const std::string& id) const { return folder_ / (id + ".log"); }
fs::path JobQueue::look(const std::string& id) const {
    std::string key;
    {
        const std::lock_guard lock(mutex_);
        for (const Entry& e : entries_)
            if (e.job.id == id && !e.job.look.empty()) key = Looks::key_of(e.job.look);
    }
    return key.empty() ? fs::path() : looks_.picture(key);
}

void JobQueue::save(const Entry& entry) const { write_json(record(entry.job.id), record_of_job(entry.job)); }

JobQueue::Entry& JobQueue::entry(const std::string& id) {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.job.id == id; });
    if (found == entries_.end()) throw Refusal(404, "there is no job \"{}\"", id);
    return *found;
}

bool JobQueue::has(const std::string& id) const {
    const std::lock_guard lock(mutex_);
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const Entry& e) { return e.job.id == id && e.job.state != JobState::finished; });
}

void JobQueue::add(Job job) {
    {
        const std::lock_guard lock(mutex_);
        Entry fresh;
        fresh.job = std::move(job);
        save(fresh);
        entries_.push_back(std::move(fresh));
    }
    condition_.notify_all();
    board_.changed();
}

void JobQueue::stop(const std::string& id) {
    {
        const std::lock_guard lock(mutex_);
        Entry& e = entry(id);
        if (e.job.state == JobState::waiting) {
            e.job.state = JobState::stopped;
            save(e);
        } else if (e.job.state == JobState::running) {
            e.stop.request_stop();
        } else {
            throw Refusal(409, "{}: the job is not running", id);
        }
    }
    board_.changed();
}

void JobQueue::resume(const std::string& id) {
    {
        const std::lock_guard lock(mutex_);
        Entry& e = entry(id);
        if (e.job.state != JobState::stopped && e.job.state != JobState::failed)
            throw Refusal(409, "{}: expected a job that was stopped or has failed", id);
        e.job.state = JobState::waiting;
        e.job.error.clear();
        e.stop = std::stop_source();
        save(e);
    }
    condition_.notify_all();
    board_.changed();
}

void JobQueue::forget(const std::string& id) {
    {
        const std::lock_guard lock(mutex_);
        Entry& e = entry(id);
        if (e.job.state == JobState::running) throw Refusal(409, "{}: stop the job first", id);
        std::error_code none;
        fs::remove(record(id), none);
        fs::remove(log(id), none);
        const RunFolder folder{library_.root() / id};
        if (!fs::exists(folder.run_json())) fs::remove(folder.root / "studio.json", none);
        fs::remove(folder.root, none);  // only if nothing was made
        entries_.remove_if([&](const Entry& other) { return &other == &e; });
    }
    board_.changed();
}

void JobQueue::move_first(const std::string& id) {
    {
        const std::lock_guard lock(mutex_);
        if (entry(id).job.state != JobState::waiting) throw Refusal(409, "{}: the job is not waiting", id);
        const auto at = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.job.id == id; });
        entries_.splice(entries_.begin(), entries_, at);
    }
    board_.changed();
}

Json JobQueue::jobs() const {
    const std::lock_guard lock(mutex_);
    Json out = Json::array();
    for (const Entry& e : entries_) {
        Json json = json_of_job(e.job);
        if (e.job.state == JobState::running) json["seconds"] = steady_seconds() - e.started;
        const RunFolder folder{library_.root() / e.job.id};
        const bool looked = !e.job.look.empty() && !looks_.picture(Looks::key_of(e.job.look)).empty();
        std::error_code none;
        const auto trained = fs::last_write_time(folder.training_jpg(), none);
        json["picture"] = !none ? "splats" : fs::exists(folder.panorama_color()) ? "panorama" : looked ? "look" : "";
        json["picture_version"] = none ? 0
                                       : trained.time_since_epoch().count() / 1'000'000;  // ms; a new one, a new number
        out.push_back(std::move(json));
    }
    return out;
}

void JobQueue::work(const std::stop_token& end) {
    while (!end.stop_requested()) {
        Entry* next = nullptr;
        {
            std::unique_lock lock(mutex_);
            condition_.wait(lock, end, [&] {
                const auto found = std::find_if(entries_.begin(), entries_.end(),
                                                [](const Entry& e) { return e.job.state == JobState::waiting; });
                next = found == entries_.end() ? nullptr : &*found;
                return next != nullptr;
            });
            if (!next || end.stop_requested()) return;
            next->job.state = JobState::running;
            next->job.overall = 0, next->job.seconds_left = -1;
            next->job.work.clear(), next->job.warnings.clear();
            next->started = steady_seconds();
        }
        board_.changed();
        run(*next, end);
        board_.changed();
    }
}

// While it runs an entry stays in the list: forget() refuses.
void JobQueue::run(Entry& e, const std::stop_token& end) {
    const std::stop_callback end_too(end, [&] { e.stop.request_stop(); });
    const std::stop_token stop = e.stop.get_token();
    int code = 0;
    std::string failure;
    try {
        wait_for_other(e, stop);
        make_look(e, stop);
        code = make(e, stop);
    } catch (const Stopped&) {
    } catch (const std::exception& problem) {
        failure = problem.what();
    }
    const std::lock_guard lock(mutex_);
    Job& job = e.job;
    job.pid = 0;
    job.seconds = steady_seconds() - e.started;
    try {
        if (end.stop_requested()) {
            job.state = JobState::waiting;  // for the next studio
            save(e);
        } else if (stop.stop_requested()) {
            job.state = JobState::stopped;
            job.error.clear();
            save(e);
        } else if (code == 0 && failure.empty()) {
            job.state = JobState::finished;
            job.error.clear();
            std::error_code none;
            fs::remove(record(job.id), none);
        } else {
            job.state = JobState::failed;
            job.error = failure.empty() ? why_it_failed(job, code, folder_) : failure;
            save(e);
        }
    } catch (const Error& problem) {  // a full disk: the page still shows it
        if (job.error.empty()) job.error = problem.what();
    }
}

void JobQueue::wait_for_other(Entry& e, const std::stop_token& stop) {
    const fs::path folder = library_.root() / e.job.id;
    std::jthread follower;
    if (is_locked(folder)) follower = std::jthread([&](std::stop_token done) { follow_log(e, done); });
    while (is_locked(folder)) {
        if (stop.stop_requested()) {
            if (makes(e.job.pid, folder)) ::kill(e.job.pid, SIGTERM);
            throw Stopped();
        }
        std::this_thread::sleep_for(kOtherEvery);
    }
}

void JobQueue::make_look(Entry& e, const std::stop_token& stop) {
    if (e.job.look.empty() || fs::exists(RunFolder{library_.root() / e.job.id}.panorama_color())) return;
    {
        const std::lock_guard lock(mutex_);
        e.job.work = "look";
    }
    looks_.make(e.job.look, stop);
    board_.changed();
}

int JobQueue::make(Entry& e, const std::stop_token& stop) {
    std::vector<std::string> flags{"--progress", "json"};
    if (params_.threads > 0) flags.insert(flags.end(), {"--threads", std::to_string(params_.threads)});
    const std::vector<std::string> arguments = with_flags(e.job.arguments, flags);
    std::error_code none;
    fs::remove(log(e.job.id), none);
    std::jthread follower([&](std::stop_token done) { follow_log(e, done); });
    const int code = run_program(params_.program, arguments, {log(e.job.id), {}, stop, [&](int pid) {
                                                                  const std::lock_guard lock(mutex_);
                                                                  e.job.pid = pid;
                                                                  save(e);
                                                              }});
    follower.request_stop();
    follower.join();
    return code;
}

void JobQueue::follow_log(Entry& e, const std::stop_token& end) {
    std::streamoff read = 0;
    for (bool last = false; !last;) {
        last = end.stop_requested();
        bool more = false;
        {
            const std::lock_guard lock(mutex_);
            more = read_more_of_log(log(e.job.id), read, e.job);
        }
        if (more) board_.changed();
        if (!last) std::this_thread::sleep_for(kLogEvery);
    }
}

}  // namespace fastscene::studio
