#include "fastscene/base/on_demand.h"

#include <dlfcn.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "fastscene/base/error.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// The program or Python's module, whichever this function is in.
fs::path this_file() {
    Dl_info info{};
    if (!::dladdr(reinterpret_cast<const void*>(&this_file), &info) || !info.dli_fname)
        throw Error("the program's own file cannot be found, beside which its parts are");
    std::error_code no_proc;
    const fs::path program = fs::read_symlink("/proc/self/exe", no_proc);
    // A program's name here is as it was typed.
    return fs::path(info.dli_fname).extension() == ".so" || no_proc ? fs::canonical(info.dli_fname) : program;
}

fs::path part_file(const std::string& part) {
    const fs::path folder = this_file().parent_path(), name = "fastscene-" + part + ".so";
    return fs::exists(folder / name) ? folder / name : folder.parent_path() / FASTSCENE_PARTS_DIR / name;
}

// Never unloaded: it registers itself with libraries that stay.
void* load(const std::string& part) {
    static std::mutex mutex;
    static std::map<std::string, void*> loaded;
    const std::lock_guard lock(mutex);
    void*& library = loaded[part];
    if (library) return library;
    const fs::path file = part_file(part);
    // A part takes functions from whoever loads it. A program's can be found by all; Python keeps a module's to itself.
    if (const fs::path own = this_file(); own.extension() == ".so")
        ::dlopen(own.c_str(), RTLD_NOW | RTLD_NOLOAD | RTLD_GLOBAL);
    library = ::dlopen(file.c_str(), RTLD_NOW);
    if (!library) throw Error("a part of the program cannot be loaded: {}", ::dlerror());
    return library;
}

}  // namespace
}  // namespace fastscene

void* fastscene_function_on_demand(const char* part, const char* function) {
    void* const library = fastscene::load(part);
    if (void* const address = ::dlsym(library, function)) return address;
    throw fastscene::Error("{}: expected a part of this version of the program", fastscene::part_file(part).string());
}
