// A COLMAP model for each room, with points from the range maps.
#include "fastscene/dataset/format.h"
#include "fastscene/dataset/room_folders.h"
#include "fastscene/io/view_io.h"

namespace fastscene::dataset_formats {
namespace {

using namespace dataset;

void write_colmap(const ExportJob& job) {
    for_each_room(job, [&](const RoomFolder& room) {
        ViewSet views;
        for (const SetPicture* picture : room.pictures) {
            const Camera camera = job.set.camera(*picture);
            views.views.push_back(
                {write_room_color(job, room, *picture), camera.pinhole, camera.world_from_camera, {}, {}});
            write_room_depth(job, room, *picture);
        }
        views.points = room_points(job, room);
        const std::string model = room.name + "sparse/0/";
        save_views_model(job.out.path() / model, views);
        for (const char* name : {"cameras", "images", "points3D"})
            for (const char* ending : {".txt", ".bin"}) job.out.add_written(model + name + ending);
    });
}

}  // namespace

DatasetFormat colmap() {
    return {.name = "colmap",
            .about = "a COLMAP model for each room",
            .readers = "COLMAP, gsplat, INRIA's 3DGS, `fastscene splat --colmap`",
            .panoramas = false,
            .write = write_colmap};
}

}  // namespace fastscene::dataset_formats
