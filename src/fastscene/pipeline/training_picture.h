// A picture of the splats while they are trained: RunFolder::training_jpg(), renewed every few seconds.
#pragma once

#include "fastscene/base/run.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/splat/splat.h"

namespace fastscene {

inline constexpr int kTrainingWidth = 640, kTrainingHeight = 360;

// A listener for fit_splats that renders and writes the picture. It takes at most a few percent of the training's time,
// and does not change what is trained. If the picture cannot be written, it warns and makes no more.
StepListener pictures_of_training(const RunFolder& folder, const PictureCamera& camera, const Run& run);

}  // namespace fastscene
