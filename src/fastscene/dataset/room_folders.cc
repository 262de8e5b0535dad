#include "fastscene/dataset/room_folders.h"

#include "fastscene/base/parallel.h"
#include "fastscene/dataset/range_points.h"
#include "fastscene/io/image_io.h"

namespace fastscene::dataset {
namespace {

constexpr int kPointsOfPicture = 10000;  // enough to begin splats with, a few hundred kilobytes a room

}  // namespace

void for_each_room(const ExportJob& job, const std::function<void(const RoomFolder&)>& work) {
    std::vector<RoomFolder> rooms;
    for (std::size_t s = 0; s < kSplits.size(); ++s) {
        int last = -1;
        for (const SetPicture* picture : job.splits[s]) {
            if (picture->room != last) rooms.push_back({fmt::format("{}/room-{:07}/", kSplits[s], picture->room), {}});
            last = picture->room;
            rooms.back().pictures.push_back(picture);
        }
    }
    Progress progress(job.run, "rooms", static_cast<std::int64_t>(rooms.size()));
    parallel_for(static_cast<std::int64_t>(rooms.size()), 1, [&](std::int64_t begin, std::int64_t) {
        job.run.check_stop();
        const RoomFolder& room = rooms[static_cast<std::size_t>(begin)];
        work(room);
        job.out.write(room.name + "room.json", job.set.bytes(*room.pictures.front(), "room_document"));
        progress.advance();
    });
}

std::string write_room_color(const ExportJob& job, const RoomFolder& room, const SetPicture& picture) {
    const std::string name = picture.name + job.set.file(picture, "color").extension().string();
    job.out.write(room.name + "images/" + name, job.set.bytes(picture, "color"));
    return name;
}

std::string write_room_depth(const ExportJob& job, const RoomFolder& room, const SetPicture& picture) {
    const std::string name = picture.name + ".png";
    job.out.write_by(room.name + "depth/" + name,
                     [&](const std::filesystem::path& path) { save_png16(path, depth_millimetres(job.set, picture)); });
    return name;
}

std::vector<SurfacePoint> room_points(const ExportJob& job, const RoomFolder& room) {
    std::vector<SurfacePoint> out;
    for (const SetPicture* picture : room.pictures) {
        const std::vector<SurfacePoint> some = range_points(job.set, *picture, kPointsOfPicture);
        out.insert(out.end(), some.begin(), some.end());
    }
    return out;
}

}  // namespace fastscene::dataset
