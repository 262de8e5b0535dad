// Which run an edited one may begin from.
#pragma once

#include <optional>
#include <string>

#include "fastscene/pipeline/earlier_run.h"
#include "fastscene/pipeline/request.h"

namespace fastscene {

// Of the results of a run's stages.
std::string hash_of_run(const RunFolder& folder);
// The source of a run that begins from `folder`.
DocumentSource edit_of(DocumentSource document, const RunFolder& folder);

// Nothing if the source is no edit of a run. Nothing with a note, which says why, if that run no longer exists or has
// been remade since, if it has other settings or another room in this version, or if the edit changes all of the light.
std::optional<EarlierRun> find_earlier_run(const SceneRequest& request, const Run& run);

}  // namespace fastscene
