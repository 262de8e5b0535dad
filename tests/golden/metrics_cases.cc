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
        gradient[0][k].copy_(at::from_blob(const_cast<double*>(g.pixels.data()), {g.height, g.width}, at::kDouble) / static_cast<double>(channels));
    }
    c.value("ssim_3dgs", sum / static_cast<double>(channels));
    c.tensor("d ssim_3dgs / d img1", gradient);
}

std::filesystem::path parameters(const Case& c, const std::string& file) { return needed_shared_file(c.network().set(), "data/metrics/" + file); }

at::Tensor row(const std::vector<double>& v) { return at::tensor(v, at::kDouble); }

// BasicSR works in single precision, which is noise in flat areas. How much, its gray tells, of which both precisions were recorded.
void check_luma(Case& c, double ours) {
    constexpr const char *y = "niqe BasicSR convert_to=y", *gray = "niqe BasicSR convert_to=gray (0.299/0.587/0.114, as MATLAB rgb2gray, rounded)";
    std::map<std::string, double> recorded;
    for (const Json& entry : c.json().value("values", Json::array()))
        if (entry.at("value").is_number()) recorded[entry.at("name")] = entry.at("value");
    if (!recorded.contains(y)) return;
    const double noise = std::abs(recorded.at(gray) - recorded.at("niqe BasicSR niqe() on the same gray in float64")),
                 off = std::abs(ours - recorded.at(y));
    const double tolerance = 0.02 + noise;
    c.put({y, off, off / recorded.at(y), tolerance, off <= tolerance, "0.02, and what single precision costs the gray"});
    c.leave_out(gray, "the authors' own values are compared");
}

void check_natural(Case& c) {
    if (c.name() == "window") {
        const Window w = gaussian_window();
        c.tensor(c.tensor_names().front(), row({w.begin(), w.end()}));
        return;
    }
    const ImageRgb8 image = load_rgb8(needed_input(c.network().set(), c.json().at("file")));
    const NiqeModel model = load_niqe_model(parameters(c, "modelparameters_niqe.mat"));
    const BrisqueModel authors = load_brisque_model(parameters(c, "allmodel"), parameters(c, "allrange"));
    const BrisqueModel opencv = load_brisque_model(parameters(c, "brisque_model_live.yml"), parameters(c, "brisque_range_live.yml"));
    const std::vector<double> features = brisque_features(image, BrisqueVariant::authors);
    c.tensor("brisque 36 features (MATLAB transcription)", row(features));
    c.tensor("OpenCV brisque features", row(brisque_features(image, BrisqueVariant::opencv)));
    double gray = 0;
    for (const double v : matlab_gray(image).pixels) gray += v;
    c.value("mean gray (rounded MATLAB rgb2gray)", gray / static_cast<double>(image.size()));
    c.value("niqe AUTHORS MATLAB code in octave (double) - the value to match", niqe(image, model));
    c.value("niqe BasicSR niqe() on the same gray in float64", niqe(image, model));
    check_luma(c, niqe(image, model, NiqeGray::luma));
    const double score = brisque(image, authors);
    c.value("brisque utlive: numpy transcription of brisque_feature.m + svm-scale/svm-predict with allrange/allmodel", score);
    c.value("brisque AUTHORS MATLAB features in octave + svm-scale/svm-predict - the value to match", score);
    c.value("brisque OpenCV 4.6 quality module (BGR uint8)", brisque(image, opencv));
    c.value("brisque octave 36 features", Json(features));
    std::string scaled = "1";
    const std::vector<double> numbers = brisque_scaled(features, authors);
    for (std::size_t i = 0; i < numbers.size(); ++i) scaled += fmt::format(" {}:{:.6g}", i + 1, numbers[i]);
    c.number_text("brisque svm-scaled features (svm-scale output)", scaled);
}

}  // namespace

void add_metrics_checkers(Checkers& checkers) {
    checkers.emplace_back("psnr_ssim", [](Case& c) { c.name().find(" vs ") != std::string::npos ? check_pictures(c) : check_gradient(c); });
    checkers.emplace_back("niqe_brisque", check_natural);
}

}  // namespace fastscene::golden
