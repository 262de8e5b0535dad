#include "fastscene/pipeline/claim.h"

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

void remove_all_but_record(const RunFolder& folder) {
    for (const std::string& name : RunFolder::owned()) {
        if (name == folder.run_json().filename()) continue;
        std::error_code code;
        fs::remove_all(folder.root / name, code);
        if (code) throw Error("{}: cannot be removed: {}", (folder.root / name).string(), code.message());
    }
}

}  // namespace

void claim_folder(const RunFolder& folder, const Json& wanted, bool start_over,
                  const std::function<std::optional<std::string>(const Json&)>& clash, const std::string& described) {
    if (start_over) {
        // The record first: on a full disk the old run stays, and whoever is killed while it is removed finds the new
        // one begun.
        write_json(folder.run_json(), wanted);
        return remove_all_but_record(folder);
    }
    if (fs::exists(folder.run_json())) {
        if (const auto other = clash(read_json(folder.run_json())))
            throw UsageError(
                "{}: expected a new folder or a run of {}, found a run of {}; choose another folder with -o, or "
                "--force to delete that run",
                folder.root.string(), described, *other);
    } else {
        for (const std::string& name : RunFolder::owned())
            if (fs::exists(folder.root / name))
                throw UsageError(
                    "{}: expected a new folder or a run, found {} but no run.json; choose another folder with -o, or "
                    "--force to replace what is there",
                    folder.root.string(), name);
    }
    write_json(folder.run_json(), wanted);
}

}  // namespace fastscene
