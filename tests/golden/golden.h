// Golden outputs: numbers that the official code of a network put out, and what a checker needs to hold ours against
// them. A set is a folder of <network>/manifest.json + data.bin; its form is told in docs/goldens.md.
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

// How one named tensor or value compared.
struct Finding {
    std::string name;
    double max_abs = 0, relative_l2 = 0, tolerance = 0;
    bool good = false;
    std::string remark;
};

// The file as it is, or unpacked from FILE.zst where that lies in its place.
std::string read_packed(const std::filesystem::path& file);

// One network's manifest and data.
class Network {
  public:
    Network(std::filesystem::path set, std::string name);
    const std::string& name() const { return name_; }
    const std::filesystem::path& set() const { return set_; }
    const Json& json() const { return json_; }
    // How many times the tolerance of its manifest a tensor gets: 1 but where <set>/wider.json says otherwise.
    double wider(const std::string& of_case, const std::string& tensor) const;
    // The stored elements of a tensor, as far as they were stored.
    at::Tensor stored(const Json& tensor) const;

  private:
    std::filesystem::path set_;
    std::string name_;
    Json json_, wider_;
    std::string data_;
};

// One case. The checker computes and hands in; what it does not hand in fails.
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

    // Compares with the tensor of that name, if the case has one. Every tensor of that name, when several share it.
    void tensor(const std::string& name, const at::Tensor& ours);
    // `relative` holds where the manifest names no tolerance.
    void value(const std::string& name, double ours, double relative = 1e-5);
    // Texts of numbers, "1 1:-0.58 2:-0.39": equal words, numbers within 1e-3.
    void number_text(const std::string& name, const std::string& ours);
    void value(const std::string& name, const Json& ours);
    // A comparison made elsewhere, for tolerances that are sentences.
    void put(Finding finding);
    // A tensor or value that this program leaves out on purpose, and why.
    void leave_out(const std::string& name, const std::string& why);
    // A tensor or value that cannot be compared, or not wholly, without a file that is not there. What was handed in
    // still counts.
    void lack(const std::string& name, const std::string& file);
    // The files that were lacked.
    const std::set<std::string>& lacked() const { return lacked_; }
    // A listener for Scope: every output whose name is a tensor of this case is compared.
    nn::Listener listener();

    std::vector<Finding> findings() const;  // in the order of the manifest, what is missing included

  private:
    const Network& network_;
    std::string name_;
    const Json& json_;
    std::map<std::string, std::vector<Finding>> found_;
    std::set<std::string> lacked_;
};

// Thrown by a checker that can do nothing without a file which not every clone has. what() is the file.
struct Skipped : std::runtime_error {
    using std::runtime_error::runtime_error;
};

using Checker = std::function<void(Case&)>;
// Network name (or its beginning up to "*") -> checker.
using Checkers = std::vector<std::pair<std::string, Checker>>;

// Raw hashed numbers of a stream, and (u + 1) / 2.
at::Tensor raw(const std::string& name, at::IntArrayRef shape);
at::Tensor unit(const std::string& name, at::IntArrayRef shape);
// 8-bit pictures as [H, W, 3].
at::Tensor bytes_of(const ImageRgb8& image);
// A file that others made and that is not part of this project. Looked for under the name `relative`
// (data/metrics/allmodel) in <set>/../data, in the folder of the variable FASTSCENE_SHARED and in <source>/../shared;
// then among the models that were pulled (`fastscene models pull MODEL`).
struct OthersFile {
    std::string relative, model, pulled;  // `pulled`: its name there, "" = the model's folder
};
std::optional<std::filesystem::path> find_others_file(const std::filesystem::path& set, const OthersFile& file);
// A file of the set itself; Skipped when there is none.
std::filesystem::path needed_input(const std::filesystem::path& set, const std::string& relative);

// Holds a copy of a set, with cases left out where <copy>/left_out.json says why, against the original. Says what
// differs; returns whether nothing does.
bool is_a_true_copy(const std::filesystem::path& copy, const std::filesystem::path& original);

// The lists of the checkers; one file a family.
void add_depth_checkers(Checkers& checkers);  // EGformer
void add_diffusion_checkers(Checkers& checkers);
void add_metrics_checkers(Checkers& checkers);
void add_geometry_checkers(Checkers& checkers);
void add_nets_checkers(Checkers& checkers);  // AOT-GAN

}  // namespace fastscene::golden
