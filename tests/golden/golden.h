// Golden outputs: results of the official implementations, and what a checker needs to compare ours with them. A set is
// a folder of <network>/manifest.json + data.bin, described in docs/goldens.md.
#pragma once

#include <ATen/ATen.h>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/hashed.h"

namespace fastscene::golden {

// The comparison of one named tensor or value.
struct Finding {
    std::string name;
    double max_abs = 0, relative_l2 = 0, tolerance = 0;
    bool good = false;
    std::string remark;
};

// The file as it is, or decompressed from FILE.zst.
std::string read_packed(const std::filesystem::path& file);

// One network's manifest and data.
class Network {
  public:
    Network(std::filesystem::path set, std::string name);
    const std::string& name() const { return name_; }
    const std::filesystem::path& set() const { return set_; }
    const Json& json() const { return json_; }
    // Factor on the tolerance in the manifest: 1, unless <set>/wider.json says otherwise.
    double wider(const std::string& of_case, const std::string& tensor) const;
    // The stored elements of a tensor, which may be a subset.
    at::Tensor stored(const Json& tensor) const;

  private:
    std::filesystem::path set_;
    std::string name_;
    Json json_, wider_;
    std::string data_;
};

// One case. The checker computes results and submits them; missing ones fail.
class Case {
  public:
    Case(const Network& network, std::string name, const Json& json)
        : network_(network), name_(std::move(name)), json_(json) {}
    const Network& network() const { return network_; }
    const std::string& name() const { return name_; }
    const Json& json() const { return json_; }
    std::string input() const { return json_.at("input").get<std::string>(); }
    std::vector<std::int64_t> shape(const char* key = "shape") const {
        return json_.at(key).get<std::vector<std::int64_t>>();
    }
    bool wants(const std::string& tensor_or_value) const;
    std::vector<std::string> tensor_names() const;

    // Compares with all tensors of that name in the case, if any.
    void tensor(const std::string& name, const at::Tensor& ours);
    // `relative` applies if the manifest has no tolerance.
    void value(const std::string& name, double ours, double relative = 1e-5);
    // Texts with numbers, "1 1:-0.58 2:-0.39": words must be equal, numbers within 1e-3.
    void number_text(const std::string& name, const std::string& ours);
    void value(const std::string& name, const Json& ours);
    // Submits a comparison made elsewhere, for tolerances that are sentences.
    void put(Finding finding);
    // Declares a tensor or value that this program intentionally omits, with the reason.
    void leave_out(const std::string& name, const std::string& why);
    // Declares a tensor or value that cannot be compared completely without a missing file. Submitted results still
    // count.
    void lack(const std::string& name, const std::string& file);
    // The missing files.
    const std::set<std::string>& lacked() const { return lacked_; }
    // A listener for Scope that compares every output whose name is a tensor of this case.
    nn::Listener listener();

    std::vector<Finding> findings() const;  // in the manifest's order, including missing ones

  private:
    const Network& network_;
    std::string name_;
    const Json& json_;
    std::map<std::string, std::vector<Finding>> found_;
    std::set<std::string> lacked_;
};

// Thrown by a checker that can do nothing without an optional file; what() is the file.
struct Skipped : std::runtime_error {
    using std::runtime_error::runtime_error;
};

using Checker = std::function<void(Case&)>;
// Network name (or prefix with "*") -> checker.
using Checkers = std::vector<std::pair<std::string, Checker>>;

// Raw hashed numbers of a stream, and (u + 1) / 2.
at::Tensor raw(const std::string& name, at::IntArrayRef shape);
at::Tensor unit(const std::string& name, at::IntArrayRef shape);
// 8-bit pictures as [H, W, 3].
at::Tensor bytes_of(const ImageRgb8& image);
// A third-party file that is not part of this project. Searched as `relative` (data/metrics/allmodel) in <set>/../data,
// in $FASTSCENE_SHARED and in <source>/../shared; then among the pulled models (`fastscene models pull MODEL`).
struct OthersFile {
    std::string relative, model, pulled;  // `pulled`: its name there, "" = the model's folder
};
std::optional<std::filesystem::path> find_others_file(const std::filesystem::path& set, const OthersFile& file);
// A file of the set itself; throws Skipped if it does not exist.
std::filesystem::path needed_input(const std::filesystem::path& set, const std::string& relative);

// Verifies a partial copy of a set, from which cases may be omitted with a reason in <copy>/left_out.json, against the
// original. Reports differences; returns whether there are none.
bool is_a_true_copy(const std::filesystem::path& copy, const std::filesystem::path& original);

// The checkers, one file per family.
void add_depth_checkers(Checkers& checkers);  // EGformer, DA-2
void add_diffusion_checkers(Checkers& checkers);
void add_metrics_checkers(Checkers& checkers);
void add_geometry_checkers(Checkers& checkers);
void add_nets_checkers(Checkers& checkers);  // AOT-GAN

}  // namespace fastscene::golden
