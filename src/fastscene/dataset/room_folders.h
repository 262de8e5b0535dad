// Exports with a folder for each room, as programs that reconstruct scenes take them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fastscene/dataset/format.h"
#include "fastscene/scene/view.h"

namespace fastscene::dataset {

struct RoomFolder {
    std::string name;  // "train/room-0000010/"
    std::vector<const SetPicture*> pictures;
};
// Calls work(room) for every room, several at a time, and writes the room's document.
void for_each_room(const ExportJob& job, const std::function<void(const RoomFolder&)>& work);

// Write images/NUMBER.jpg and depth/NUMBER.png (16 bit, millimetres along the axis) of a room's folder; return the
// name without its folder.
std::string write_room_color(const ExportJob& job, const RoomFolder& room, const SetPicture& picture);
std::string write_room_depth(const ExportJob& job, const RoomFolder& room, const SetPicture& picture);
// Points of all its pictures.
std::vector<SurfacePoint> room_points(const ExportJob& job, const RoomFolder& room);

}  // namespace fastscene::dataset
