// PSNR, SSIM, NIQE, BRISQUE.
#include <cmath>
#include <map>

#include "fastscene/image/ssim.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/brisque.h"
#include "fastscene/metrics/naturalness.h"
#include "fastscene/metrics/niqe.h"
#include "golden.h"

namespace fastscene::golden {
namespace {

// "photo_0 vs photo_0_blur", "… rolled by 2 columns (np.roll axis=1)", "… (identical)".
ImageRgb8 second_picture(const std::filesystem::path& set, const std::string& text) {
    const std::string name = text.substr(0, text.find(' '));
    ImageRgb8 out = load_rgb8(needed_input(set, "inputs/" + name + ".png"));
    const std::size_t rolled = text.find("rolled by ");
    if (rolled == std::string::npos) return out;
    const int by = std::stoi(text.substr(rolled + 10));
    const ImageRgb8 from = out;
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) out.at((x + by + out.width) % out.width, y) = from.at(x, y);
    return out;
}

void check_pictures(Case& c) {
    const std::size_t versus = c.name().find(" vs ");
    const ImageRgb8 a = load_rgb8(needed_input(c.network().set(), "inputs/" + c.name().substr(0, versus) + ".png"));
    const ImageRgb8 b = second_picture(c.network().set(), c.name().substr(versus + 4));
    double l1 = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Rgb8 p = a.pixels[i], q = b.pixels[i];
        l1 += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
    }
    c.value("l1_3dgs", l1 / (255.0 * 3 * static_cast<double>(a.size())));
    c.value("mse", mean_squared_error(a, b) * 255 * 255);
    c.value("psnr_db", psnr(a, b));
    c.value("ssim_3dgs", ssim(a, b));
    c.value("ssim_3dgs_fp64", ssim(a, b));
    c.value("ssim_skimage_gaussian", ssim(a, b, Ssim::valid));
    c.value("ssim_wang_gray_valid", ssim(a, b, Ssim::wang));
}

Image<double> plane_of(const at::Tensor& picture, std::int64_t channel) {
    const at::Tensor p = picture[0][channel].to(at::kDouble).contiguous();
    Image<double> out(static_cast<int>(p.size(1)), static_cast<int>(p.size(0)));
    std::copy_n(p.data_ptr<double>(), out.size(), out.pixels.data());
    return out;
}

void check_gradient(Case& c) {
    const at::Tensor a = unit(c.input() + "/a", c.shape());
    const at::Tensor b = at::clamp(a + 0.15f * raw(c.input() + "/b", c.shape()), 0, 1);
    double sum = 0;
    at::Tensor gradient = at::zeros(c.shape(), at::kDouble);
    const std::int64_t channels = a.size(1);
    for (std::int64_t k = 0; k < channels; ++k) {
        const Image<double> x = plane_of(a, k), y = plane_of(b, k);
        sum += ssim_of_channel(x, y, 1, false);
        const Image<double> g = ssim_gradient(x, y);
        gradient[0][k].copy_(at::from_blob(const_cast<double*>(g.pixels.data()), {g.height, g.width}, at::kDouble) /
                             static_cast<double>(channels));
    }
    c.value("ssim_3dgs", sum / static_cast<double>(channels));
    c.tensor("d ssim_3dgs / d img1", gradient);
}

// NIQE's model of pristine pictures and BRISQUE's regressions belong to their authors and are not part of the source
// tree; the features that they evaluate need neither.
const OthersFile kNiqe{"data/metrics/modelparameters_niqe.mat", "niqe", "modelparameters.mat"},
    kBrisque{"data/metrics/allmodel", "brisque", "allmodel"},
    kBrisqueRanges{"data/metrics/allrange", "brisque", "allrange"},
    kOpencv{"data/metrics/brisque_model_live.yml", "brisque-opencv", "brisque_model_live.yml"},
    kOpencvRanges{"data/metrics/brisque_range_live.yml", "brisque-opencv", "brisque_range_live.yml"};

at::Tensor row(const std::vector<double>& v) { return at::tensor(v, at::kDouble); }

constexpr const char *kNiqeLuma = "niqe BasicSR convert_to=y",
                     *kNiqeGray = "niqe BasicSR convert_to=gray (0.299/0.587/0.114, as MATLAB rgb2gray, rounded)";

// BasicSR uses single precision, which is noise in uniform areas. Its magnitude follows from its gray variant, which
// was recorded in both precisions.
void check_luma(Case& c, double ours) {
    const std::string y = kNiqeLuma, gray = kNiqeGray;
    std::map<std::string, double> recorded;
    for (const Json& entry : c.json().value("values", Json::array()))
        if (entry.at("value").is_number()) recorded[entry.at("name")] = entry.at("value");
    if (!recorded.contains(y)) return;
    const double noise = std::abs(recorded.at(gray) - recorded.at("niqe BasicSR niqe() on the same gray in float64")),
                 off = std::abs(ours - recorded.at(y));
    const double tolerance = 0.02 + noise;
    c.put(
        {y, off, off / recorded.at(y), tolerance, off <= tolerance, "0.02, and what single precision costs the gray"});
    c.leave_out(gray, "the authors' own values are compared");
}

void check_niqe(Case& c, const ImageRgb8& image) {
    constexpr const char *authors = "niqe AUTHORS MATLAB code in octave (double) - the value to match",
                         *same = "niqe BasicSR niqe() on the same gray in float64";
    const auto file = find_others_file(c.network().set(), kNiqe);
    if (!file) {
        for (const char* name : {authors, same, kNiqeLuma, kNiqeGray}) c.lack(name, kNiqe.relative);
        return;
    }
    const NiqeModel model = load_niqe_model(*file);
    const double score = niqe(image, model);
    c.value(authors, score);
    c.value(same, score);
    check_luma(c, niqe(image, model, NiqeGray::luma));
}

void check_brisque(Case& c, const ImageRgb8& image, const std::vector<double>& features) {
    constexpr const char
        *transcribed =
            "brisque utlive: numpy transcription of brisque_feature.m + svm-scale/svm-predict with allrange/allmodel",
        *authors = "brisque AUTHORS MATLAB features in octave + svm-scale/svm-predict - the value to match",
        *scaled_name = "brisque svm-scaled features (svm-scale output)";
    const auto file = find_others_file(c.network().set(), kBrisque),
               ranges = find_others_file(c.network().set(), kBrisqueRanges);
    if (!file || !ranges) {
        for (const char* name : {transcribed, authors, scaled_name}) c.lack(name, kBrisque.relative);
        return;
    }
    const BrisqueModel model = load_brisque_model(*file, *ranges);
    const double score = brisque(image, model);
    c.value(transcribed, score);
    c.value(authors, score);
    std::string scaled = "1";
    const std::vector<double> numbers = brisque_scaled(features, model);
    for (std::size_t i = 0; i < numbers.size(); ++i) scaled += fmt::format(" {}:{:.6g}", i + 1, numbers[i]);
    c.number_text(scaled_name, scaled);
}

void check_brisque_opencv(Case& c, const ImageRgb8& image) {
    constexpr const char* name = "brisque OpenCV 4.6 quality module (BGR uint8)";
    const auto file = find_others_file(c.network().set(), kOpencv),
               ranges = find_others_file(c.network().set(), kOpencvRanges);
    if (!file || !ranges) return c.lack(name, kOpencv.relative);
    c.value(name, brisque(image, load_brisque_model(*file, *ranges)));
}

void check_natural(Case& c) {
    if (c.name() == "window") {
        const Window w = gaussian_window();
        c.tensor(c.tensor_names().front(), row({w.begin(), w.end()}));
        return;
    }
    const ImageRgb8 image = load_rgb8(needed_input(c.network().set(), c.json().at("file")));
    const std::vector<double> features = brisque_features(image, BrisqueVariant::authors);
    c.tensor("brisque 36 features (MATLAB transcription)", row(features));
    c.value("brisque octave 36 features", Json(features));
    c.tensor("OpenCV brisque features", row(brisque_features(image, BrisqueVariant::opencv)));
    double gray = 0;
    for (const double v : matlab_gray(image).pixels) gray += v;
    c.value("mean gray (rounded MATLAB rgb2gray)", gray / static_cast<double>(image.size()));
    check_niqe(c, image);
    check_brisque(c, image, features);
    check_brisque_opencv(c, image);
}

}  // namespace

void add_metrics_checkers(Checkers& checkers) {
    checkers.emplace_back("psnr_ssim", [](Case& c) {
        c.name().find(" vs ") != std::string::npos ? check_pictures(c) : check_gradient(c);
    });
    checkers.emplace_back("niqe_brisque", check_natural);
}

}  // namespace fastscene::golden
