#include "fastscene/nn/training_folder.h"

#include "fastscene/base/json.h"
#include "fastscene/nn/learner.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene::nn {
namespace {

namespace fs = std::filesystem;

std::int64_t metadata_number(const Weights& checkpoint, const std::string& name) {
    const auto found = checkpoint.metadata.find(name);
    if (found == checkpoint.metadata.end() || found->second.find_first_not_of("0123456789") != std::string::npos ||
        found->second.empty())
        throw Error("{}: expected a number as {} in its metadata, found {}", checkpoint.path.string(), name,
                    found == checkpoint.metadata.end() ? "none" : found->second);
    return std::stoll(found->second);
}

}  // namespace

NamedTensors whole_state(const TrainingTask& task) {
    NamedTensors all;
    for (const Learner* learner : task.learners)
        for (auto& item : learner->state()) all.push_back(std::move(item));
    return all;
}

fs::path checkpoint_of(const fs::path& folder) { return folder / "checkpoint.safetensors"; }

void save_checkpoint(const TrainingTask& task, std::int64_t step, const fs::path& folder) {
    Weights out{checkpoint_of(folder), {}, {{"step", std::to_string(step)}}, {}};
    for (const Learner* learner : task.learners)
        for (const auto& [name, tensor] : learner->state_at_rest()) out.tensors[name] = weight_of(tensor);
    for (const Learner* learner : task.learners)
        out.metadata[learner->name() + ".steps"] = std::to_string(learner->steps());
    save_safetensors(checkpoint_of(folder), out);
}

std::int64_t load_checkpoint(const TrainingTask& task, const fs::path& folder) {
    if (!fs::exists(checkpoint_of(folder))) return 0;
    const Weights checkpoint = load_weights(checkpoint_of(folder));
    load_into(whole_state(task), checkpoint);
    for (Learner* learner : task.learners) learner->set_steps(metadata_number(checkpoint, learner->name() + ".steps"));
    return metadata_number(checkpoint, "step");
}

void settle_settings(const TrainingTask& task, const TrainingParams& params, const fs::path& folder, const Run& run) {
    Json wanted = lasting_settings(params);
    wanted["seed"] = run.seed;
    wanted.update(task.settings);
    const fs::path path = folder / "training.json";
    if (!fs::exists(path)) return write_json(path, wanted);
    const Json found = read_json(path);
    for (const auto& [name, value] : wanted.items())
        if (!found.contains(name) || found[name] != value)
            throw UsageError(
                "{}: expected a training with {} = {}, found {}: use the same settings to resume, or another folder",
                path.string(), name, value.dump(), found.contains(name) ? found[name].dump() : "none");
}

}  // namespace fastscene::nn
