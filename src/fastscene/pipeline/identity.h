// What a run is a run of: its prompt or its picture, and its seed. A folder belongs to one of them.
#pragma once

#include <optional>
#include <string>

#include "fastscene/pipeline/pipeline.h"

namespace fastscene {

// Reads the source as far as needed to be sure that it can be used, and warns about what was not understood; nothing is
// written. Throws UsageError or Error as make_scene does.
void check_source(const SceneSource& source, const SceneParams& params, const std::string& last_stage, const Run& run);

// Hash of the prompt, or of the contents of the picture and of its range map if it has one.
std::string identity_of(const SceneSource& source);
// For people: the prompt, or the picture's name.
std::string title_of(const SceneSource& source);

// What run.json says of this source, when files that it was read from (the picture, its range map, further panoramas)
// are gone meanwhile: what is finished was made of them, and the run goes on from there. Nothing when all are there, or
// when the record is of other files.
struct GoneSource {
    Json record;
    std::filesystem::path file;  // the first that is gone
};
std::optional<GoneSource> gone_source(const RunFolder& folder, const SceneSource& source);

// Writes run.json; of a source that is gone it keeps what was recorded. Throws UsageError when the folder holds another
// source's or another seed's run, or files under our names that no run made; with `start_over` those are removed
// instead.
void claim_folder(const RunFolder& folder, const SceneRequest& request, std::uint64_t seed,
                  const std::optional<GoneSource>& gone = {});

}  // namespace fastscene
