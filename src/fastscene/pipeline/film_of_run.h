// Camera paths through the scene of a run.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/film/plan.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene {

// Plans a film over `area`, the run's walkable area (walkable_in), that shows what the sentence named; of a room of
// ours also by what hides what. Throws as plan_film.
CameraPath film_of_run(const RunFolder& folder, const WalkableArea& area, const FilmWish& wish, const Run& run);

}  // namespace fastscene
