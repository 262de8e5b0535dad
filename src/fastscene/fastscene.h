// The library fastscene::fastscene: the whole stream from a sentence or a picture to a scene, and each stage by itself.
// Frames and units: docs/conventions.md; threads and errors: docs/library.md.
#pragma once

#include "fastscene/rooms.h"
#include "fastscene/splat.h"
// The whole: a run folder is made, or gone on with.
#include "fastscene/pipeline/pipeline.h"
#include "fastscene/pipeline/share.h"
// Films: planned camera paths, camera files, both eyes, video files.
#include "fastscene/film/encode.h"
#include "fastscene/film/plan.h"
#include "fastscene/film/stereo.h"
#include "fastscene/film/subjects.h"
#include "fastscene/io/camera_path_io.h"
// The stages, left to right.
#include "fastscene/depth/depth.h"
#include "fastscene/inpaint/inpaint.h"
#include "fastscene/metrics/metrics.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/walk/walk.h"
