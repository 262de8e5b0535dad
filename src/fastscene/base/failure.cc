#include "fastscene/base/failure.h"

#include <mutex>
#include <new>
#include <vector>

namespace fastscene {
namespace {

struct Readers {
    std::mutex mutex;
    std::vector<FailureReader> all;
};

Readers& readers() {
    static Readers readers;
    return readers;
}

Failure read(const std::exception& error) {
    Readers& known = readers();
    const std::lock_guard lock(known.mutex);
    for (const FailureReader reader : known.all)
        if (std::optional<Failure> failure = reader(error)) return *failure;
    return {error.what(), dynamic_cast<const std::bad_alloc*>(&error) != nullptr};
}

}  // namespace

std::string short_message(const std::exception& error) { return read(error).message; }

bool is_lack_of_memory(const std::exception& error) { return read(error).lack_of_memory; }

void add_failure_reader(FailureReader reader) {
    Readers& known = readers();
    const std::lock_guard lock(known.mutex);
    known.all.push_back(reader);
}

}  // namespace fastscene
