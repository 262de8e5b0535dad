// Which pixels of a panorama an edit of the room changes, so that the others need not be rendered again.
#pragma once

#include "fastscene/geometry/sphere.h"
#include "fastscene/trace/room_change.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

class ChangedPixels {
  public:
    // Both rooms must be lit and outlive this. `parts`: how the panoramas are rendered.
    ChangedPixels(const TracedRoom& before, const TracedRoom& now, const ShotParts& parts);

    // Nonzero where panoramas of the two rooms from this pose may differ: at every pixel that shows a changed surface,
    // and around samples, four pixels apart, whose colors differ (shadows, reflections, light). Both rooms' samples
    // draw the same random numbers, so noise does not count as a difference.
    ImageMask in_panorama(const Rigid& world_from_pano, EquirectSize size, const Run& run) const;

  private:
    const TracedRoom& before_;
    const TracedRoom& now_;
    ShotParts parts_;
    RoomChange change_;
    SceneBvh surfaces_;
};

}  // namespace fastscene
