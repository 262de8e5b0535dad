// The run that an edited one begins from. Whatever the edit leaves unchanged is taken from it: light, pixels, splats.
#pragma once

#include <memory>

#include "fastscene/pipeline/run_folder.h"
#include "fastscene/trace/room_change.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct EarlierRun {
    RunFolder folder;
    std::shared_ptr<const TracedRoom> room;  // lit
    RoomChange change;                       // what the edit changes
    int edits = 0;                           // since a whole run: this one included
};

}  // namespace fastscene
