#include "fastscene/pipeline/health.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/image/picture_health.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/scene/camera_path.h"
#include "fastscene/splat/splat.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Of many pictures these many, evenly spread: what is broken is broken in more than one.
constexpr std::size_t kMostPictures = 12;
constexpr std::size_t kMostLooks = 4;  // renderings of the splats
constexpr int kLookWidth = 256;        // pixels of a sphere: holes that matter are wider than one and a half degrees
// Where one walks, a room is closed. Photographs show no sky that splats would be trained on.
constexpr double kMostTransparent = 0.05, kMostTransparentOfPhotos = 0.8;
constexpr double kMostUnknownRange = 0.5;  // of a range map: 0, or no number

template <class T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t most) {
    if (all.size() <= most) return all;
    std::vector<T> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * (all.size() - 1) / (most - 1)]);
    return some;
}

std::vector<fs::path> pictures_of(const RunFolder& folder) {
    std::vector<fs::path> out;
    for (const fs::path& file : {folder.panorama_color(), folder.preview_jpg()})
        if (fs::exists(file)) out.push_back(file);
    std::vector<fs::path> walk, views;
    if (fs::exists(folder.walk() / "poses.json"))
        for (const Viewpoint& at : load_viewpoints(folder.walk() / "poses.json"))
            walk.push_back(folder.walk() / at.name / "color.png");
    if (fs::exists(folder.views() / "images"))
        for (const auto& entry : fs::recursive_directory_iterator(folder.views() / "images"))
            if (entry.is_regular_file() && has_picture_ending(entry.path())) views.push_back(entry.path());
    std::sort(views.begin(), views.end());
    for (const auto& some : {some_of(walk, kMostPictures), some_of(views, kMostPictures)})
        out.insert(out.end(), some.begin(), some.end());
    return out;
}

class Examination {
  public:
    Examination(const RunFolder& folder, const Run& run) : folder_(folder), run_(run) {}

    Json result() {
        for (const fs::path& file : pictures_of(folder_))
            look(name_of(file), [&] { return complaint_of_picture(file); });
        if (fs::exists(folder_.depth_range()))
            look(name_of(folder_.depth_range()), [&] { return complaint_of_range(); });
        if (fs::exists(folder_.scene_ply())) look(name_of(folder_.scene_ply()), [&] { return complaint_of_splats(); });
        for (const std::string& problem : problems_) run_.warn(problem);
        Json out{{"ok", problems_.empty()}, {"problems", problems_}, {"looked_at", looked_at_}};
        if (!splats_.is_null()) out["splats"] = splats_;
        return out;
    }

  private:
    std::string name_of(const fs::path& file) const { return file.lexically_relative(folder_.root).generic_string(); }

    template <class Find>
    void look(const std::string& name, const Find& find) {
        run_.check_stop();
        ++looked_at_;
        try {
            if (const std::string found = find(); !found.empty())
                problems_.push_back((folder_.root / name).string() + ": " + found);
        } catch (const Error& e) {
            problems_.emplace_back(e.what());
        }
    }

    // A view that looks at an even wall shows one color, and rightly.
    std::string complaint_of_picture(const fs::path& file) const {
        PictureHealth health = health_of(load_rgb8(file));
        if (file.parent_path().filename() == "images") health.contrast = 1;
        return complaint(health);
    }

    std::string complaint_of_range() const {
        const ImageF range = load_float(folder_.depth_range());
        std::size_t nan = 0, unknown = 0;
        for (const float r : range.pixels) nan += std::isnan(r) ? 1u : 0u, unknown += r > 0 ? 0u : 1u;
        const double n = std::max<double>(1, static_cast<double>(range.size()));
        if (nan > 0) return fmt::format("{} of its pixels are no numbers", nan);
        if (static_cast<double>(unknown) / n > kMostUnknownRange)
            return fmt::format("{:.0f} % of it has no range", 100 * static_cast<double>(unknown) / n);
        return {};
    }

    std::string complaint_of_splats() {
        // Readers leave out splats whose numbers are none; we write none.
        const LoadedSplats loaded = load_splats(folder_.scene_ply());
        const Splats& splats = loaded.splats;
        const std::size_t broken = loaded.cleaned.dropped;
        splats_ = {{"count", splats.size() + loaded.cleaned.dropped}, {"not_finite", broken}};
        if (broken > 0) return fmt::format("{} of its splats are no numbers", broken);
        if (splats.size() == 0) return "it has no splats";
        return complaint_of_looks(splats);
    }

    std::string complaint_of_looks(const Splats& splats) {
        const SplatRenderer renderer(splats);
        std::string worst;
        double transparent = 0;
        const auto judge = [&](const SplatPicture& picture, double most) {
            const PictureHealth health = health_of(picture.color, picture.alpha);
            transparent = std::max(transparent, health.transparent);
            if (const std::string found = complaint(health, most); worst.empty()) worst = found;
        };
        if (const auto glance = first_glance_of_capture(folder_)) {
            const Splats upright = load_splat_ply(folder_.stage("splat") / "viewer.compressed.ply");
            const SplatRenderer shown(upright);
            const Vec3f f = normalize(glance->forward);
            judge(shown.picture(Pinhole::with_fov(kLookWidth, kLookWidth * 3 / 4, glance->fov_deg),
                                world_from_camera_at(glance->position_m, degrees(std::atan2(f.x, f.z)),
                                                     degrees(std::asin(std::clamp(-f.y, -1.f, 1.f))))),
                  kMostTransparentOfPhotos);
        } else {
            std::vector<Rigid> poses{{}};
            if (fs::exists(folder_.walk() / "poses.json")) poses = load_walk_poses(folder_);
            for (const Rigid& pose : some_of(poses, kMostLooks)) {
                run_.check_stop();
                judge(renderer.picture(Pinhole{kLookWidth, kLookWidth / 2}, pose, {}, CameraModel::equirectangular),
                      kMostTransparent);
            }
        }
        splats_["transparent"] = std::round(transparent * 1e4) / 1e4;
        return worst.empty() ? worst : "seen from where it was made, " + worst;
    }
    static float degrees(float radians) { return radians * 57.2957795f; }

    const RunFolder& folder_;
    const Run& run_;
    std::vector<std::string> problems_;
    int looked_at_ = 0;
    Json splats_;
};

}  // namespace

Json check_health(const RunFolder& folder, const Run& run) { return Examination(folder, run).result(); }

}  // namespace fastscene
