#include "fastscene/batch/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

Json to_json(const BatchRecord& r) {
    Json json{{"name", r.name},   {"prompt", r.prompt},  {"key", r.key}, {"status", r.done ? "done" : "failed"},
              {"tries", r.tries}, {"seconds", r.seconds}};
    if (!r.error.empty()) json["error"] = r.error;
    return json;
}
BatchRecord record_of(const Json& json) {
    return {json.at("name"),  json.at("prompt"),  json.at("key"),         json.at("status") == "done",
            json.at("tries"), json.at("seconds"), json.value("error", "")};
}

// The whole lines of a file, and how many bytes they have.
std::size_t read_lines(const fs::path& file, BatchRecords& records) {
    std::ifstream in(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t end = text.rfind('\n');
    const std::size_t whole = end == std::string::npos ? 0 : end + 1;
    int number = 0;
    for (std::size_t at = 0; at < whole;) {
        const std::size_t next = text.find('\n', at);
        ++number;
        try {
            records.keep(record_of(Json::parse(text.substr(at, next - at))));
        } catch (const Json::exception&) {
            throw Error("{}:{}: expected a record of a batch, found other text", file.string(), number);
        }
        at = next + 1;
    }
    return whole;
}

// The journals of chunks, in the order of their numbers.
std::vector<fs::path> chunk_journals(const fs::path& folder) {
    std::vector<fs::path> out;
    if (!fs::exists(folder / "tasks")) return out;
    for (const auto& entry : fs::directory_iterator(folder / "tasks"))
        if (entry.path().extension() == ".jsonl") out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

void BatchRecords::keep(BatchRecord record) {
    const auto [found, is_new] = places_.try_emplace(record.name, all_.size());
    if (is_new) all_.push_back(std::move(record));
    else all_[found->second] = std::move(record);
}

const BatchRecord* BatchRecords::find(const std::string& name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? nullptr : &all_[found->second];
}

BatchJournal::BatchJournal(const fs::path& folder, const std::string& name) : file_(folder / name) {
    const std::size_t whole = read_lines(file_, records_);
    if (fs::exists(file_) && whole < fs::file_size(file_)) fs::resize_file(file_, whole);
}

void BatchJournal::add(const BatchRecord& record) {
    const std::string line = to_json(record).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    const int file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (file < 0) throw Error("{}: cannot be written: {}", file_.string(), std::strerror(errno));
    const off_t end = ::lseek(file, 0, SEEK_END);
    errno = ENOSPC;  // what a short write means
    bool written = ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    int problem = errno;
    // No half a line before the next record.
    if (!written && ::ftruncate(file, end) != 0) problem = errno;
    if (::close(file) != 0 && written) written = false, problem = errno;
    if (!written) throw Error("{}: cannot be written: {}", file_.string(), std::strerror(problem));
    records_.keep(record);
}

BatchRecords all_records(const fs::path& folder) {
    BatchRecords records;
    read_lines(folder / "batch.jsonl", records);
    for (const fs::path& file : chunk_journals(folder)) read_lines(file, records);
    return records;
}

void collect_journals(const fs::path& folder) {
    BatchRecords records;
    for (const fs::path& file : chunk_journals(folder)) read_lines(file, records);
    BatchJournal journal(folder);
    for (const BatchRecord& record : records.all()) journal.add(record);
    fs::remove_all(folder / "tasks");  // what tasks noted beside their journals is of the past, too
}

}  // namespace fastscene
