#include "fastscene/export/identities.h"

#include <fmt/format.h>

#include <map>
#include <set>

namespace fastscene {

std::vector<std::string> object_ids(const Room& room) {
    std::set<std::string> taken;
    for (const RoomObject& object : room.objects) taken.insert(object.id);
    std::map<std::string, int> count;
    std::vector<std::string> ids;
    for (const RoomObject& object : room.objects) {
        std::string id = object.id;
        while (id.empty() || (object.id.empty() && taken.contains(id)))
            id = fmt::format("{}-{}", object.kind, ++count[object.kind]);
        ids.push_back(id);
    }
    return ids;
}

}  // namespace fastscene
