// What a film looks at, from the description of a run's room (panorama/room.json).
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/film/plan.h"

namespace fastscene {

// What the sentence named first, the largest in the picture before the others, windows last; then other large things,
// up to `most`. Doors are marked as such. `where` names the file in errors.
std::vector<FilmSubject> film_subjects(const Json& room, std::size_t most, const std::string& where);

}  // namespace fastscene
