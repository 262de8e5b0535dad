// The library fastscene::rooms: a sentence becomes a furnished room, and the room is path traced from any viewpoint, or
// written for engines.
// Frames and units: docs/conventions.md; threads and errors: docs/library.md.
#pragma once

// The room: what the sentence says, and triangles, materials and lights.
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/edit.h"
#include "fastscene/rooms/pack.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/scene/room.h"
// Pictures of it.
#include "fastscene/geometry/pinhole.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/image/image.h"
#include "fastscene/io/image_io.h"
#include "fastscene/math/rigid.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/trace/standable.h"
#include "fastscene/trace/trace.h"
// Files for engines.
#include "fastscene/export/collision.h"
#include "fastscene/export/labels.h"
#include "fastscene/export/room_glb.h"
// What every call shares.
#include "fastscene/base/error.h"
#include "fastscene/base/events.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/run.h"
#include "fastscene/version.h"
