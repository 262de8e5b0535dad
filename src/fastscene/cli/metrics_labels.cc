// metrics labels: what labelled splats show, against the room's own surfaces.
#include <algorithm>
#include <numeric>

#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/labelled_scene.h"
#include "fastscene/cli/metrics.h"
#include "fastscene/export/view_maps.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/metrics.h"
#include "fastscene/metrics/seen_labels.h"
#include "fastscene/pipeline/room_of_run.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct LabelFlags {
    std::string folder, out, views = "12", size = "384", seed = "0";
};

constexpr float kPoseFov_deg = 75;  // as `metrics --truth` looks

// A color per instance, neighbours far apart; white where the two differ.
ImageRgb8 side_by_side(const Image<std::uint16_t>& seen, const Image<std::uint16_t>& truth) {
    ImageRgb8 out(3 * seen.width, seen.height);
    const auto color_of = [](std::uint16_t instance) {
        const std::uint64_t bits = mix64(instance + 1);
        const auto part = [&](int k) { return static_cast<std::uint8_t>(40 + (bits >> (8 * k) & 0xff) * 3 / 4); };
        return instance ? Rgb8{part(0), part(1), part(2)} : Rgb8{};
    };
    for (int y = 0; y < seen.height; ++y)
        for (int x = 0; x < seen.width; ++x) {
            const std::uint16_t a = seen.at(x, y), b = truth.at(x, y);
            out.at(x, y) = color_of(a);
            out.at(x + seen.width, y) = color_of(b);
            out.at(x + 2 * seen.width, y) = a == b ? color_of(b) : Rgb8{255, 255, 255};
        }
    return out;
}

void measure(const LabelFlags& flags, const Session& session) {
    TruthParams poses;
    poses.views = number_from<int>("--views", flags.views);
    poses.size_px = number_from<int>("--size", flags.size);
    check_fields("", poses);
    const Run run = session.run(number_from<std::uint64_t>("--seed", flags.seed));
    const RunFolder folder{flags.folder};
    const auto room = unlit_room_of_run(folder, recorded_run(folder), run);
    const LabelledScene scene = labelled_scene(folder.root, *room, run);
    const std::vector<Instance>& instances = scene.instances;
    if (!flags.out.empty()) make_directories(flags.out);
    std::vector<LabelView> views;
    const Pinhole camera = Pinhole::with_fov(poses.size_px, poses.size_px, kPoseFov_deg);
    for (const TruthPose& pose : truth_poses(*room, poses, run.seed)) views.push_back({camera, pose.world_from_camera});
    const auto seen = seen_labels(scene.splats, scene.labels, views, {}, run);
    std::vector<int> class_of, instance_of(instances.size());
    for (const Instance& instance : instances) class_of.push_back(instance.nyu40);
    std::iota(instance_of.begin(), instance_of.end(), 0);
    double classes = 0, same = 0, worst = 1;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const ViewMaps truth = view_maps(*room, camera, views[v].world_from_camera, {run.seed, nullptr, run.stop});
        const double agreed = agreement(seen[v], truth.instance, class_of);
        classes += agreed, worst = std::min(worst, agreed);
        same += agreement(seen[v], truth.instance, instance_of);
        if (!flags.out.empty())
            save_png(fs::path(flags.out) / fmt::format("{:03}.png", v), side_by_side(seen[v], truth.instance));
    }
    classes /= static_cast<double>(views.size()), same /= static_cast<double>(views.size());
    session.print(
        fmt::format("pixels that agree: class {:.4f} (worst view {:.4f}), instance {:.4f}", classes, worst, same),
        {{"views", views.size()}, {"class", classes}, {"class_worst", worst}, {"instance", same}});
}

}  // namespace

Verb add_metrics_labels(CLI::App& metrics) {
    auto flags = std::make_shared<LabelFlags>();
    CLI::App* verb = metrics.add_subcommand(
        "labels", "Class and instance maps of labelled splats, against the room's surfaces at poses never trained on.");
    verb->add_option("scene", flags->folder, "Folder of a finished run from a prompt.")->type_name("DIR")->required();
    verb->add_option("--views", flags->views, "Number of poses.")->type_name("N")->capture_default_str();
    verb->add_option("--size", flags->size, "Width and height of a pose's maps in pixels.")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option("--seed", flags->seed, "Seed of the poses.")->type_name("N")->capture_default_str();
    verb->add_option("-o,--out", flags->out,
                     "Folder for pictures: the splats' labels, the true ones, and both where they agree.")
        ->type_name("DIR");
    verb->footer("Example:\n  fastscene metrics labels out/bedroom");
    return {verb, [flags](const Session& session) { measure(*flags, session); }};
}

}  // namespace fastscene::cli
