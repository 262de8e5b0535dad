#include "fastscene/pipeline/training_picture.h"

#include <algorithm>
#include <chrono>

#include "fastscene/base/error.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kPause{3};          // often enough to see the picture sharpen
constexpr double kPausePerCost = 40;  // pictures take 2.5 % of the time, however slow one is

class TrainingPictures {
  public:
    TrainingPictures(const RunFolder& folder, const PictureCamera& camera, const Run& run)
        : file_(folder.training_jpg()), camera_(camera), run_(run) {}

    void operator()(const StepReport& report) {
        const Clock::time_point begin = Clock::now();
        if (begin < due_) return;
        try {
            save_jpeg(file_, picture_of(report.splats(), camera_.lens, camera_.world_from_camera));
            if (!told_) run_.note(fmt::format("splat: {} shows what is trained so far", file_.string()));
            told_ = true;
        } catch (const Error& e) {
            run_.warn(fmt::format("{}; training continues without pictures", e.what()));
            due_ = Clock::time_point::max();
            return;
        }
        const Clock::time_point end = Clock::now();
        due_ = end +
               std::chrono::duration_cast<Clock::duration>(std::max(kPause, kPausePerCost * Seconds(end - begin)));
    }

  private:
    std::filesystem::path file_;
    PictureCamera camera_;
    const Run& run_;
    bool told_ = false;
    Clock::time_point due_ = Clock::time_point::min();
};

}  // namespace

StepListener pictures_of_training(const RunFolder& folder, const PictureCamera& camera, const Run& run) {
    return TrainingPictures(folder, camera, run);
}

}  // namespace fastscene
