// Views: cuts panoramas into perspective pictures with known cameras, plus initial points for the splats. Paper: MVP
// (multi-view projection). COLMAP is not needed, since the poses are known by construction.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/scene/outside.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/view.h"

namespace fastscene {

struct ViewsParams {
    int size = 640;  // width and height of a view
    float fov_deg = 90;
    int points = 200000;          // number of initial points on surfaces
    float outside_density = 12;   // of the outside: points per square degree …
    int outside_points = 200000;  // … up to so many
    int backdrop = 0;             // … plus this many on a sphere behind everything
    std::string sfm = "known";    // source of the camera poses
    int weight_carried = 200;     // of 255: inpainted at an earlier viewpoint
    int weight_invented = 110;    // of 255: inpainted at this one
    int weight_silhouette = 130;  // of 255: maximum for pixels next to a warped silhouette
};
template <class V>
void visit_fields(ViewsParams& p, V&& v) {
    v("size", p.size, Bounds{16, 4096}, "Width and height of a view in pixels.");
    v("fov", p.fov_deg, Bounds{30, 120}, "Field of view in degrees.");
    v("points", p.points, Bounds{1, 1e7}, "Number of initial points sampled from the range maps.");
    v("outside-density", p.outside_density, Bounds{0.1, 1000},
      "Initial points per square degree of the outside, as seen through windows.");
    v("outside-points", p.outside_points, Bounds{0, 1e7}, "Maximum number of initial points of the outside.");
    v("backdrop", p.backdrop, Bounds{0, 1e6},
      "Additional initial points on a distant sphere, so that gaps are not transparent; 0: none.");
    v("sfm", p.sfm, Choices{{"known", "colmap", "triangulate"}},
      "Cameras: known by construction; estimated by COLMAP, as in the paper; or known, with points triangulated by "
      "COLMAP.");
    v("weight-carried", p.weight_carried, Bounds{0, 255},
      "Training weight, of 255, of pixels inpainted at an earlier viewpoint.");
    v("weight-invented", p.weight_invented, Bounds{0, 255},
      "Training weight, of 255, of pixels inpainted at this viewpoint.");
    v("weight-silhouette", p.weight_silhouette, Bounds{0, 255},
      "Maximum training weight, of 255, next to a warped silhouette.");
}

// Cuts every panorama into overlapping views that cover the whole sphere (14 at 90 degrees). Deterministic in
// (panoramas, params, run.seed). If the panoramas are moved in, each is freed once its views are cut: twenty of 4096
// columns are 3 GB. `outside`: the view through the windows, if known (null: as seen by the panoramas).
ViewSet project_views(std::vector<Panorama> panoramas, const ViewsParams& params, const Run& run,
                      const Outside* outside = nullptr);

}  // namespace fastscene
