#include <cstdlib>

#include "fastscene/cli/request.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/depth/train.h"
#include "fastscene/nn/launch.h"
#include "fastscene/pipeline/cached_weights.h"
#include "fastscene/pipeline/depth_report.h"

namespace fastscene::cli {
namespace {

struct TrainFlags {
    std::vector<std::string> data;
    std::string out, start, seed = "0";
    std::shared_ptr<Given> given = std::make_shared<Given>();
};

CLI::App* add_train(CLI::App& depth, const std::shared_ptr<TrainFlags>& flags) {
    CLI::App* verb = depth.add_subcommand("train",
                                          "Trains EGformer on panoramas with range: our rooms, Structured3D, Pano3D.");
    verb->add_option("--data", flags->data,
                     "Folder of `fastscene rooms dataset`, of Structured3D (scene_NNNNN/) or of Pano3D (*_color_*.png, "
                     "*_depth_*.exr); may be repeated. Without it: synthetic rooms only.")
        ->type_name("DIR")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb->add_option(
            "-o,--out", flags->out,
            "Folder of the training: egformer.safetensors, curves, sheets, checkpoint. The same command resumes it.")
        ->type_name("DIR")
        ->required();
    verb->add_option("--start", flags->start,
                     "Initial weights (the published .pkl, or .safetensors) instead of random ones.")
        ->type_name("FILE");
    verb->add_option("--seed", flags->seed, "Seed of the initial weights and the order of the pictures.")
        ->type_name("N")
        ->capture_default_str();
    add_fields(*verb, "", DepthTrainParams{}, flags->given, "Settings of the training");
    verb->footer("Example:\n  fastscene depth train --data data/rooms --data /media/Structured3D -o out/depth");
    return verb;
}

void train(const TrainFlags& flags, const Session& session) {
    DepthTraining training{{flags.data.begin(), flags.data.end()}, flags.start, {}};
    apply_fields("", training.params, *flags.given);
    check_fields("", training.params);
    take_launch(training.params.training, ::getenv);
    const EgformerTrained trained = train_depth(training, flags.out,
                                                session.run(number_from<std::uint64_t>("--seed", flags.seed)));
    if (training.params.training.process > 0)  // only the first process evaluates held-out pictures
        return session.print(fmt::format("done, {} steps; process 0 saves the network", trained.steps),
                             {{"steps", trained.steps}});
    session.print(fmt::format("{}: {} steps; held out, aligned: AbsRel {:.4f}, d1 {:.4f}", trained.weights.string(),
                              trained.steps, trained.abs_rel, trained.delta1),
                  {{"weights", trained.weights.string()},
                   {"steps", trained.steps},
                   {"abs_rel", trained.abs_rel},
                   {"delta1", trained.delta1}});
}

struct CheckFlags {
    std::string data, count = "50";
    bool all = false;
    std::shared_ptr<Given> given = std::make_shared<Given>();
};

CLI::App* add_check(CLI::App& depth, const std::shared_ptr<CheckFlags>& flags) {
    CLI::App* verb = depth.add_subcommand(
        "check",
        "Evaluates range estimation on the held-out pictures of a dataset, one per place: AbsRel, RMSE, delta.");
    verb->add_option("--data", flags->data, "Folder of panoramas with range, as for `depth train`.")
        ->type_name("DIR")
        ->required();
    verb->add_option("--count", flags->count, "Number of places to evaluate.")->type_name("N")->capture_default_str();
    verb->add_flag("--all", flags->all,
                   "Use all places instead of held-out ones only (every tenth of our rooms): for a set that the "
                   "network was not trained on.");
    add_fields(*verb, "depth", DepthParams{}, flags->given, "Settings of depth");
    verb->footer("Example:\n  fastscene depth check --data data/rooms --depth-weights out/depth/egformer.safetensors");
    return verb;
}

void check(const CheckFlags& flags, const Session& session) {
    DepthCheck wanted{flags.data, number_from<int>("--count", flags.count), flags.all, {}};
    if (wanted.count < 1) throw UsageError("--count: expected at least 1, found {}", wanted.count);
    apply_fields("depth", wanted.depth, *flags.given);
    check_fields("depth", wanted.depth);
    depth_backend_of(wanted.depth);  // refuses exact and image: a data set has neither a room nor one map
    const Run run = session.run(0);
    use_cached_depth_weights(wanted.depth, run);
    const Json report = check_depth(wanted, run);
    session.print(depth_check_text(report), report);
}

}  // namespace

Verb add_depth(CLI::App& app) {
    Verb depth = add_stage_verb(app, "depth", "Panorama -> range along each ray.");
    auto training = std::make_shared<TrainFlags>();
    auto checking = std::make_shared<CheckFlags>();
    CLI::App *train_verb = add_train(*depth.app, training), *check_verb = add_check(*depth.app, checking);
    depth.app->footer("Example:\n  fastscene depth out/photo --depth-camera-height 1.4");
    for (CLI::App* verb : {train_verb, check_verb})
        verb->fallthrough();  // --json, --threads and --progress belong to the command
    // A run folder is required for the stage only.
    CLI::Option* folder = depth.app->get_option("folder")->required(false);
    return {depth.app, [=, act = depth.act](const Session& session) {
                for (const CLI::App* part : {train_verb, check_verb})  // a folder would be accepted but ignored
                    if (part->parsed() && folder->count())
                        throw UsageError("depth {}: expected its folder after --data, found only \"{}\"",
                                         part->get_name(), folder->as<std::string>());
                if (train_verb->parsed()) return train(*training, session);
                if (check_verb->parsed()) return check(*checking, session);
                if (folder->count() == 0) throw UsageError("depth: expected the folder of a run");
                act(session);
            }};
}

}  // namespace fastscene::cli
