// A network that another program exported as TorchScript, with a small JSON beside it that says what it wants. It is
// code, and runs only if the user trusts it (models/trust.h). The interface is free of libtorch.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/base/run.h"
#include "fastscene/nn/device.h"

namespace fastscene {

// PicturePlanes of a picture, each row by row: values[(plane * height + y) * width + x].
struct PicturePlanes {
    int count = 0, width = 0, height = 0;
    std::vector<float> values;
    PicturePlanes(int planes, int w, int h)
        : count(planes),
          width(w),
          height(h),
          values(static_cast<std::size_t>(planes) * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    float& at(int plane, int x, int y) {
        return values[(static_cast<std::size_t>(plane) * static_cast<std::size_t>(height) +
                       static_cast<std::size_t>(y)) *
                          static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    float at(int plane, int x, int y) const { return const_cast<PicturePlanes*>(this)->at(plane, x, y); }
};

class ScriptedNetwork {
  public:
    // Throws UsageError if the file is not trusted, Error naming it if it is no TorchScript.
    static ScriptedNetwork load(const std::filesystem::path& file, const std::vector<std::string>& trusted,
                                const DeviceChoice& device);
    ScriptedNetwork(ScriptedNetwork&&) noexcept;
    ScriptedNetwork& operator=(ScriptedNetwork&&) noexcept;
    ~ScriptedNetwork();

    // One picture: each input becomes a tensor [1, planes, height, width]; the output is a tensor of that kind, without
    // the first one or two axes, or a tuple, list or dictionary of such: `output` is the key or number of the one
    // wanted, empty: the first. Throws Error naming the file, the expected and the actual shape.
    PicturePlanes run(const std::vector<PicturePlanes>& inputs, const std::string& output, const Run& run) const;
    const std::string& sha256() const;
    const std::filesystem::path& file() const;

  private:
    struct State;
    explicit ScriptedNetwork(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// The JSON beside the file: network.pt.json, or network.json for network.pt. An empty object if there is none.
Json beside_network(const std::filesystem::path& file);

}  // namespace fastscene
