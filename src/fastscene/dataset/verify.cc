#include "fastscene/dataset/verify.h"

#include <algorithm>
#include <map>
#include <set>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/parallel.h"
#include "fastscene/dataset/checksum.h"
#include "fastscene/dataset/export.h"
#include "fastscene/dataset/set.h"

namespace fastscene::dataset {
namespace {

namespace fs = std::filesystem;

struct PictureCheck {
    std::vector<FoundFault> faults;
    std::int64_t files = 0;
    // The room's document is shared by its pictures: looked at once, later.
    std::optional<Checksum> document;
};

PictureCheck check_picture(const fs::path& folder, int number, const DatasetParams& params, bool quick) {
    PictureCheck out;
    const std::string stem = picture_stem(number, params.shard), json_name = stem + ".json";
    const auto add = [&](const std::string& file, const std::string& fault) {
        if (!fault.empty()) out.faults.push_back({file, fault, number});
    };
    ++out.files;
    if (!fs::exists(folder / json_name)) return add(json_name, "missing"), out;
    try {
        const Json about = read_json(folder / json_name);
        if (!is_sealed(about)) return add(json_name, "damaged: its content does not match its checksum"), out;
        for (const auto& [name, sum] : about.at("files").items()) {
            const Checksum expected = checksum_from_json(sum);
            if (name == "room_document") {
                out.document = expected;
                continue;
            }
            const std::string file = (fs::path(stem).parent_path() / about.at(name).get<std::string>()).string();
            ++out.files;
            add(file, fault_of(folder / file, expected, quick));
        }
    } catch (const std::exception&) {
        add(json_name, "damaged: expected a picture's JSON");
    }
    return out;
}

VerifyReport verify_set(const fs::path& folder, bool quick, const Run& run) {
    const Json settings = read_set_settings(folder);
    const MadeFrom from = made_from(settings, folder);
    const DatasetParams& params = from.request.params;
    std::vector<PictureCheck> checks(static_cast<std::size_t>(from.request.count));
    Progress progress(run, "pictures", from.request.count);
    parallel_for(from.request.count, 16, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (std::int64_t i = begin; i < end; ++i)
            checks[static_cast<std::size_t>(i)] = check_picture(folder, static_cast<int>(i), params, quick);
        progress.advance(end - begin);
    });
    VerifyReport report;
    std::map<int, Checksum> documents;
    for (std::size_t i = 0; i < checks.size(); ++i) {
        report.files += checks[i].files;
        report.faults.insert(report.faults.end(), checks[i].faults.begin(), checks[i].faults.end());
        if (checks[i].document) documents.emplace(static_cast<int>(i) / params.views, *checks[i].document);
    }
    for (const auto& [room, expected] : documents) {
        const std::string name = room_document_name(room);
        ++report.files;
        if (const std::string fault = fault_of(folder / name, expected, quick); !fault.empty())
            report.faults.push_back({name, fault, -1, room});
    }
    // What the last process writes; a set that is still in work has neither.
    if (!report.faults.empty()) return report;
    const std::string index = index_text(from.request.count, params.shard);
    for (const auto& [name, fault] :
         {std::pair{"index.txt", fault_of(folder / "index.txt", checksum_of_bytes(index), quick)},
          {"README.md", std::string(fs::exists(folder / "README.md") ? "" : "missing")}}) {
        ++report.files;
        if (!fault.empty()) report.faults.push_back({name, fault});
    }
    return report;
}

}  // namespace

VerifyReport verify(const fs::path& folder, bool quick, const Run& run) {
    if (!is_export(folder)) return verify_set(folder, quick, run);
    VerifyReport report;
    report.is_export = true;
    const std::vector<ExportedFile> files = exported_files(folder);
    std::vector<std::string> faults(files.size());
    Progress progress(run, "files", static_cast<std::int64_t>(files.size()));
    parallel_for(static_cast<std::int64_t>(files.size()), 4, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            faults[i] = fault_of(folder / files[i].name, files[i].sum, quick);
        progress.advance(end - begin);
    });
    report.files = static_cast<std::int64_t>(files.size());
    for (std::size_t i = 0; i < files.size(); ++i)
        if (!faults[i].empty()) report.faults.push_back({files[i].name, faults[i]});
    return report;
}

void forget_damaged(const fs::path& folder, const VerifyReport& report) {
    const DatasetParams params = made_from(read_set_settings(folder), folder).request.params;
    std::error_code none;
    for (const FoundFault& fault : report.faults) {
        if (fault.picture >= 0) fs::remove(folder / (picture_stem(fault.picture, params.shard) + ".json"), none);
        if (fault.room >= 0) fs::remove(folder / room_document_name(fault.room), none);
    }
}

}  // namespace fastscene::dataset
