// The library fastscene::splat: 3D Gaussians trained on pictures with known cameras, rendered, edited, and read and
// written in all formats. Frames and units: docs/conventions.md; threads and errors: docs/library.md.
#pragma once

// Pictures and cameras.
#include "fastscene/geometry/pinhole.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/image/image.h"
#include "fastscene/io/image_io.h"
#include "fastscene/math/rigid.h"
// Views to train on: in memory, as COLMAP and nerfstudio leave them, or cut from panoramas.
#include "fastscene/io/capture_io.h"
#include "fastscene/io/view_io.h"
#include "fastscene/scene/view.h"
#include "fastscene/views/photos.h"
#include "fastscene/views/views.h"
// Splats: training, pictures of them, changes to them, files.
#include "fastscene/io/splat_io.h"
#include "fastscene/io/viewer.h"
#include "fastscene/scene/splat_edit.h"
#include "fastscene/scene/splats.h"
#include "fastscene/splat/splat.h"
// What every call shares.
#include "fastscene/base/error.h"
#include "fastscene/base/events.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/run.h"
#include "fastscene/version.h"
