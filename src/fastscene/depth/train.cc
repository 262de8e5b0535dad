#include "fastscene/depth/train.h"

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/base/writable.h"
#include "fastscene/depth/examples.h"
#include "fastscene/depth/painted_room.h"
#include "fastscene/depth/photo_look.h"
#include "fastscene/depth/repaint.h"

namespace fastscene {
namespace {

constexpr std::size_t kMostHeldOut = 60;  // limit, since they are evaluated repeatedly
constexpr std::size_t kPaintedHeldOut = 40;
constexpr float kRepaintedSurfaces = 0.6f;  // share of a room's surfaces that are repainted

void check_sizes(const DepthTrainParams& p) {
    if (p.height % 32 != 0) throw UsageError("--height: expected a multiple of 32, found {}", p.height);
    if (p.channels % 4 != 0) throw UsageError("--channels: expected a multiple of 4, found {}", p.channels);
}

// Evenly spaced, so that every place stays represented.
template <class T>
std::vector<T> thinned(const std::vector<T>& all, std::size_t most) {
    if (all.size() <= most) return all;
    std::vector<T> out;
    for (std::size_t i = 0; i < most; ++i) out.push_back(all[i * all.size() / most]);
    return out;
}

std::vector<DepthFiles> with_fate(const std::vector<DepthFiles>& all, bool held_out, std::size_t most) {
    std::vector<DepthFiles> out;
    for (const DepthFiles& files : all)
        if (files.held_out == held_out) out.push_back(files);
    return thinned(out, most);
}

std::vector<DepthExample> painted_rooms(EquirectSize size, std::size_t count, const Run& run) {
    std::vector<DepthExample> out;
    Progress progress(run, "synthetic rooms", static_cast<std::int64_t>(count));
    for (std::size_t i = 0; i < count; ++i, progress.advance()) {
        run.check_stop();
        Random rng(run.seed, "held-out painted room", i);
        out.push_back(painted_room(size, rng));
    }
    return out;
}

}  // namespace

EgformerTrained train_depth(const DepthTraining& training, const std::filesystem::path& folder, const Run& run) {
    const DepthTrainParams& p = training.params;
    check_sizes(p);
    if (!training.start.empty() && std::filesystem::exists(folder / "checkpoint.safetensors"))
        run.warn(fmt::format("--start {}: not used, the training in {} goes on from its own checkpoint",
                             training.start.string(), folder.string()));
    const EquirectSize size{2 * p.height, p.height};
    std::vector<DepthFiles> files;
    Json names = Json::array();
    for (const auto& data : training.data) {
        for (DepthFiles& one : find_depth_files(data)) files.push_back(std::move(one));
        names.push_back(data.string());
    }
    // Before the validation rooms are rendered.
    make_directories(folder);
    check_writable(folder / "training.json");
    const auto wanted = static_cast<std::size_t>(std::max(1., p.share * static_cast<double>(files.size())));
    const std::vector<DepthExample> examples = load_examples(with_fate(files, false, wanted), false, size, run);
    std::vector<DepthExample> held_out = load_examples(with_fate(files, true, kMostHeldOut), true, size, run);
    if (examples.empty() && !files.empty())
        throw Error("{}: expected pictures to train on, found {}", names.dump(),
                    std::all_of(files.begin(), files.end(), [](const DepthFiles& f) { return f.held_out; })
                        ? "held-out ones only: more rooms are needed"
                        : "none that can be used (see the warnings above)");
    if (held_out.empty() && !files.empty()) {
        run.warn(
            fmt::format("{}: expected held-out pictures, found none (every tenth room of ours, Structured3D's scenes "
                        "from 3000 on): metrics are computed on training pictures",
                        names.dump()));
        held_out = thinned(examples, kMostHeldOut);
    }
    if (files.empty()) held_out = painted_rooms(size, kPaintedHeldOut, run);
    const std::vector<float> mean_range = mean_range_by_latitude(files.empty() ? held_out : examples);
    const double painted = files.empty() ? 1 : p.painted;

    EgformerTraining task{
        {p.height, 2 * p.height, p.channels, true},
        p.training,
        p.direct,
        {},
        std::move(held_out),
        mean_range,
        training.start,
        {{"data", names}, {"painted", painted}, {"repainted", p.repainted}}};
    task.draw = [&](Random& rng) {
        const bool paint = rng.chance(static_cast<float>(painted)),
                   repaint = rng.chance(static_cast<float>(p.repainted));
        const PhotoLook look = random_photo_look(rng);
        if (paint) return seen_as(painted_room(size, rng), look, rng);
        const DepthExample& room = examples[static_cast<std::size_t>(rng.index(static_cast<int>(examples.size())))];
        return seen_as(repaint ? repainted(room, kRepaintedSurfaces, rng) : room, look, rng);
    };
    run.note(fmt::format("depth: {} pictures to train on, {} held out, {:.0f} % of the examples are synthetic rooms",
                         examples.size(), task.held_out.size(), 100 * painted));
    return train_egformer(task, folder, run);
}

}  // namespace fastscene
