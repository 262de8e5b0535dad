// EGformer and DA-2.
#include "fastscene/io/image_io.h"
#include "fastscene/nn/da2_net.h"
#include "fastscene/nn/egformer_net.h"
#include "golden.h"

namespace fastscene::golden {
namespace {

namespace fs = std::filesystem;

// "inputs/pano_*.png": the one that exists.
at::Tensor picture_input(const fs::path& set, const std::string& pattern) {
    const std::size_t star = pattern.find('*');
    fs::path path = set / pattern;
    if (star != std::string::npos) {
        const std::string begin = fs::path(pattern.substr(0, star)).filename(), end = pattern.substr(star + 1);
        for (const auto& entry : fs::directory_iterator((set / pattern).parent_path())) {
            const std::string name = entry.path().filename();
            if (name.starts_with(begin) && name.ends_with(end)) path = entry.path();
        }
    }
    return bytes_of(load_rgb8(path)).to(at::kFloat).div(255).permute({2, 0, 1}).unsqueeze(0).contiguous();
}

void check_tables(Case& c) {
    for (const std::string& name : c.tensor_names()) {
        for (const Json& tensor : c.json().at("tensors")) {
            if (tensor.at("name") != name) continue;
            const auto shape = tensor.at("shape").get<std::vector<std::int64_t>>();
            const auto size = [&](std::size_t i) { return static_cast<int>(shape.at(i)); };
            if (name.starts_with("ref_point")) {
                const nn::EgformerConstants k({2 * size(1), 2 * size(2), 32});
                c.tensor(name, k.patch[0].view(shape));
            } else {
                // A table of [rows or 1][heads][L][L], made for a grid whose stage has L tokens in a window.
                const bool vertical = name.starts_with("VRPE");
                const int h = vertical ? size(2) : size(0), w = 2 * h;
                // Stages that attend to rows begin at level 2; the bias depends on the grid alone.
                const nn::EgformerConstants k({8 * h, 8 * w, 32});
                c.tensor(name, (vertical ? k.column_bias[2] : k.row_bias[2]).reshape(shape));
            }
        }
    }
}

void check_egformer(Case& c) {
    if (!c.json().contains("input")) return check_tables(c);
    const at::Tensor color = c.input().starts_with("inputs/") ? picture_input(c.network().set(), c.input())
                                                              : unit(c.input(), c.shape());
    const int channels = [&] {
        for (const Json& entry : c.network().json().at("state_dict"))
            if (entry.at(0) == "patch_embed.0.weight") return entry.at(1).at(0).get<int>();
        return 32;
    }();
    const nn::EgformerConstants constants({static_cast<int>(color.size(2)), static_cast<int>(color.size(3)), channels});
    nn::HashedWeights weights;
    const nn::Listener listener = c.listener();
    c.tensor("output", nn::egformer(nn::Scope(weights, "", &listener), constants, color));
}

// The published configuration, with what the case overrides.
nn::Da2Config da2_config_of(const Json& overrides) {
    nn::Da2Config config;
    config.min_pixels = overrides.value("inference.min_pixels", config.min_pixels);
    config.max_pixels = overrides.value("inference.max_pixels", config.max_pixels);
    config.sphere.width = overrides.value("spherevit.sphere.width", config.sphere.width);
    config.sphere.height = overrides.value("spherevit.sphere.height", config.sphere.height);
    return config;
}

void check_da2(Case& c) {
    const bool is_file = c.input().starts_with("inputs/");
    if (is_file && c.input().find('*') == std::string::npos) needed_input(c.network().set(), c.input());
    const at::Tensor color = is_file ? picture_input(c.network().set(), c.input()) : unit(c.input(), c.shape());
    // Tensors of the manifest that are no module's output, under their names in our code.
    const auto name_in_manifest = [](const std::string& name) -> std::string {
        if (name == "dino.positions") return "pos_embed";
        if (name == "dino.tokens" || name.starts_with("dino.features.")) return name.substr(5);
        return name;
    };
    const nn::Listener listener = [&](const std::string& name, const at::Tensor& output) {
        if (name == "quantile98") c.value(name, output.item<double>());
        else c.tensor(name_in_manifest(name), output);
    };
    nn::HashedWeights weights;
    c.tensor("output", nn::da2(nn::Scope(weights, "", &listener), {}, color, da2_config_of(c.json().at("config"))));
}

}  // namespace

void add_depth_checkers(Checkers& checkers) {
    checkers.emplace_back("egformer*", check_egformer);
    checkers.emplace_back("da2*", check_da2);
}

}  // namespace fastscene::golden
