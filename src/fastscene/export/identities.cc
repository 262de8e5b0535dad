#include "fastscene/export/identities.h"

#include <fmt/format.h>

#include <map>

namespace fastscene {

std::vector<std::string> object_ids(const Room& room) {
    std::map<std::string, int> count;
    std::vector<std::string> ids;
    for (const RoomObject& object : room.objects)
        ids.push_back(fmt::format("{}-{}", object.kind, ++count[object.kind]));
    return ids;
}

}  // namespace fastscene
