#include "fastscene/batch/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {
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

}  // namespace

BatchJournal::BatchJournal(const std::filesystem::path& folder) : file_(folder / "batch.jsonl") {
    std::ifstream in(file_, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t end = text.rfind('\n');
    const std::size_t whole = end == std::string::npos ? 0 : end + 1;
    if (whole < text.size()) std::filesystem::resize_file(file_, whole);
    int number = 0;
    for (std::size_t at = 0; at < whole;) {
        const std::size_t next = text.find('\n', at);
        ++number;
        try {
            keep(record_of(Json::parse(text.substr(at, next - at))));
        } catch (const Json::exception&) {
            throw Error("{}:{}: expected a record of a batch, found other text", file_.string(), number);
        }
        at = next + 1;
    }
}

void BatchJournal::keep(BatchRecord record) {
    const auto [found, is_new] = places_.try_emplace(record.name, records_.size());
    if (is_new) records_.push_back(std::move(record));
    else records_[found->second] = std::move(record);
}

void BatchJournal::add(const BatchRecord& record) {
    const std::string line = to_json(record).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    const int file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    const bool written = file >= 0 && ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    const int problem = errno;
    if (file >= 0) ::close(file);
    if (!written) throw Error("{}: cannot be written: {}", file_.string(), std::strerror(problem));
    keep(record);
}

const BatchRecord* BatchJournal::find(const std::string& name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? nullptr : &records_[found->second];
}

}  // namespace fastscene
