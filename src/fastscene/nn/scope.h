// A named position in a network, as in its checkpoint: scope / "mid_block" / "resnets" / 0 / "conv1" requests
// mid_block.resnets.0.conv1.weight. Networks are functions of a scope and a tensor, so names in the code match names in
// the file, and a misshaped parameter is reported where it is used. Private to nn/ (torch).
#pragma once

#include <ATen/ATen.h>

#include <functional>
#include <string>
#include <string_view>

namespace fastscene::nn {

// Provides parameters by name.
class WeightSource {
  public:
    virtual ~WeightSource() = default;
    // The parameter in the network's number type and on its device. Throws Error naming the file and the key if it is
    // absent or has another shape.
    virtual at::Tensor get(const std::string& key, at::IntArrayRef shape) = 0;
    virtual bool has(const std::string& key) const = 0;
};

// Receives the output of each named part of a network.
using Listener = std::function<void(const std::string& name, const at::Tensor& output)>;

class Scope {
  public:
    explicit Scope(WeightSource& source, std::string prefix = "", const Listener* listener = nullptr)
        : source_(&source), prefix_(std::move(prefix)), listener_(listener) {}
    Scope operator/(std::string_view name) const {
        return Scope(*source_, prefix_.empty() ? std::string(name) : prefix_ + "." + std::string(name), listener_);
    }
    Scope operator/(std::int64_t index) const { return *this / std::string_view(std::to_string(index)); }

    at::Tensor parameter(std::string_view name, at::IntArrayRef shape) const {
        return source_->get((*this / name).prefix_, shape);
    }
    bool has(std::string_view name) const { return source_->has((*this / name).prefix_); }
    const std::string& prefix() const { return prefix_; }

    bool is_heard() const { return listener_ && *listener_; }
    // Returns the output, after reporting it to the listener.
    at::Tensor out(at::Tensor tensor) const {
        if (is_heard()) (*listener_)(prefix_, tensor);
        return tensor;
    }

  private:
    WeightSource* source_;
    std::string prefix_;
    const Listener* listener_;
};

}  // namespace fastscene::nn
