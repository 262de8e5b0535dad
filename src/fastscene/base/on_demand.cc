#include "fastscene/base/on_demand.h"

#include <dlfcn.h>

#include <map>
#include <mutex>
#include <string>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

// Never unloaded: it registers itself with libraries that stay.
void* load(const std::string& part) {
    static std::mutex mutex;
    static std::map<std::string, void*> loaded;
    const std::lock_guard lock(mutex);
    void*& library = loaded[part];
    if (!library) library = ::dlopen(part_file(part.c_str()).c_str(), RTLD_NOW);
    if (!library) throw Error("a part of the program cannot be loaded: {}", ::dlerror());
    return library;
}

}  // namespace

std::filesystem::path part_file(const char* part) {
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
    return program.parent_path().parent_path() / FASTSCENE_PARTS_DIR / (std::string(part) + ".so");
}

}  // namespace fastscene

void* fastscene_function_on_demand(const char* part, const char* function) {
    void* const address = ::dlsym(fastscene::load(part), function);
    if (!address) throw fastscene::Error("{}: expected a part of this version", fastscene::part_file(part).string());
    return address;
}
