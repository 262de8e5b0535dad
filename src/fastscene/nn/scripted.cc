#include "fastscene/nn/scripted.h"

#include <c10/core/InferenceMode.h>
#include <torch/script.h>

#include <mutex>

#include "fastscene/base/error.h"
#include "fastscene/base/failure.h"
#include "fastscene/base/file.h"
#include "fastscene/models/trust.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/runtime.h"

namespace fastscene {
namespace fs = std::filesystem;

struct ScriptedNetwork::State {
    fs::path file;
    std::string sha256;
    at::Device device;
    torch::jit::Module module;
    std::mutex one_at_a_time;
};

ScriptedNetwork::ScriptedNetwork(std::unique_ptr<State> state) : state_(std::move(state)) {}
ScriptedNetwork::ScriptedNetwork(ScriptedNetwork&&) noexcept = default;
ScriptedNetwork& ScriptedNetwork::operator=(ScriptedNetwork&&) noexcept = default;
ScriptedNetwork::~ScriptedNetwork() = default;
const std::string& ScriptedNetwork::sha256() const { return state_->sha256; }
const fs::path& ScriptedNetwork::file() const { return state_->file; }

ScriptedNetwork ScriptedNetwork::load(const fs::path& file, const std::vector<std::string>& trusted,
                                      const DeviceChoice& choice) {
    const std::string hash = check_trusted(file, trusted);
    const at::Device device = nn::device_named(choice.name, choice.flag);
    try {
        torch::jit::Module module = torch::jit::load(file.string(), device);
        module.eval();
        return ScriptedNetwork(std::unique_ptr<State>(new State{file, hash, device, std::move(module), {}}));
    } catch (const c10::Error& e) {
        throw Error("{}: expected a network exported as TorchScript (torch.jit.save), found: {}", file.string(),
                    short_message(e));
    }
}

namespace {

// The network's own traceback ends with what went wrong: "RuntimeError: …".
std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \n");
    if (end == std::string::npos) return text;
    const std::size_t begin = text.find_last_of('\n', end);
    return text.substr(begin == std::string::npos ? 0 : begin + 1,
                       end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

// The tensor that `wanted` names in what a network returned.
c10::IValue chosen_output(const fs::path& file, c10::IValue value, const std::string& wanted) {
    if (value.isTensor()) return value;
    if (value.isGenericDict()) {
        for (const auto& entry : value.toGenericDict())
            if (wanted.empty() || (entry.key().isString() && entry.key().toStringRef() == wanted)) return entry.value();
        throw Error("{}: expected an output \"{}\", found none of that name", file.string(), wanted);
    }
    std::vector<c10::IValue> parts;
    if (value.isTuple()) {
        const auto& elements = value.toTupleRef().elements();
        parts.assign(elements.begin(), elements.end());
    } else if (value.isList()) {
        const auto elements = value.toListRef();
        parts.assign(elements.begin(), elements.end());
    }
    const std::size_t index = wanted.empty() ? 0 : std::strtoul(wanted.c_str(), nullptr, 10);
    if (index >= parts.size())
        throw Error("{}: expected an output number {}, found {} outputs", file.string(), index, parts.size());
    return parts[index];
}

}  // namespace

PicturePlanes ScriptedNetwork::run(const std::vector<PicturePlanes>& inputs, const std::string& output,
                                   const Run& run) const {
    run.check_stop();
    const std::lock_guard lock(state_->one_at_a_time);
    use_our_threads();
    const c10::InferenceMode inference;
    std::vector<c10::IValue> tensors;
    for (const PicturePlanes& p : inputs)
        tensors.emplace_back(at::from_blob(const_cast<float*>(p.values.data()), {1, p.count, p.height, p.width})
                                 .clone()
                                 .to(state_->device));
    at::Tensor found;
    try {
        const c10::IValue value = chosen_output(state_->file, state_->module.forward(std::move(tensors)), output);
        if (!value.isTensor())
            throw Error("{}: expected a tensor as output, found {}", state_->file.string(), value.tagKind());
        found = value.toTensor().to(at::kFloat).cpu();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {  // of libtorch, or raised by the network's own code
        if (is_lack_of_memory(e)) throw std::bad_alloc();
        throw Error("{}: cannot run on {} x {} pixels: {}", state_->file.string(), inputs.at(0).width,
                    inputs.at(0).height, last_line(short_message(e)));
    }
    while (found.dim() > 3 && found.size(0) == 1) found = found.squeeze(0);
    if (found.dim() == 2) found = found.unsqueeze(0);
    if (found.dim() != 3 || found.numel() == 0)
        throw Error("{}: expected an output of the shape [1, planes, height, width], found {} axes",
                    state_->file.string(), found.dim());
    found = found.contiguous();
    PicturePlanes out(static_cast<int>(found.size(0)), static_cast<int>(found.size(2)),
                      static_cast<int>(found.size(1)));
    std::copy_n(found.data_ptr<float>(), out.values.size(), out.values.begin());
    return out;
}

Json beside_network(const fs::path& file) {
    for (const fs::path& beside : {fs::path(file.string() + ".json"), fs::path(file).replace_extension(".json")})
        if (beside != file && fs::is_regular_file(beside)) {
            Json json = read_json(beside);
            if (!json.is_object()) throw Error("{}: expected an object, found another kind of JSON", beside.string());
            return json;
        }
    return Json::object();
}

}  // namespace fastscene
