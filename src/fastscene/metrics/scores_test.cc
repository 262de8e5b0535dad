#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/brisque.h"
#include "fastscene/metrics/naturalness.h"
#include "fastscene/metrics/niqe.h"
#include "fastscene/metrics/symmetric.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

fs::path scratch(const std::string& name) {
    const fs::path dir = fs::temp_directory_path() / ("fastscene_scores_" + name);
    fs::remove_all(dir);
    fs::create_directories(dir);
    return dir;
}

// Dead leaves model: photograph-like statistics with occluding edges at all scales, plus slight grain.
ImageRgb8 dead_leaves(int width, int height, std::uint64_t seed) {
    Random random(seed, "leaves");
    Plane plane(width, height, 128);
    for (int i = 0; i < 700; ++i) {
        const double radius = 3 / (0.06 + 0.94 * random.uniform()), cx = random.uniform() * width,
                     cy = random.uniform() * height;
        const double shade = 40 + 180 * random.uniform();
        for (int y = std::max(0, static_cast<int>(cy - radius)); y < std::min<double>(height, cy + radius); ++y)
            for (int x = std::max(0, static_cast<int>(cx - radius)); x < std::min<double>(width, cx + radius); ++x)
                if (std::hypot(x - cx, y - cy) < radius) plane.at(x, y) = shade;
    }
    ImageRgb8 out(width, height);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto v = static_cast<std::uint8_t>(std::clamp(plane.pixels[i] + 3 * random.normal(), 0.0, 255.0));
        out.pixels[i] = {v, v, v};
    }
    return out;
}

ImageRgb8 blurred_picture(const ImageRgb8& image, int times) {
    Plane plane = matlab_gray(image);
    for (int i = 0; i < times; ++i) plane = blurred(plane, Border::replicate);
    ImageRgb8 out(image.width, image.height);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto v = static_cast<std::uint8_t>(std::clamp(plane.pixels[i] + 0.5, 0.0, 255.0));
        out.pixels[i] = {v, v, v};
    }
    return out;
}

// Generalized Gaussian samples: alpha 2 = normal, 1 = Laplace, with a scale per side.
std::vector<double> samples(double alpha, double left, double right, int count) {
    Random random(5, "ggd");
    std::vector<double> out;
    for (int i = 0; i < count; ++i) {
        const bool negative = random.uniform() < left / (left + right);
        const double size = alpha == 2 ? std::abs(random.normal())
                                       : -std::log(1 - static_cast<double>(random.uniform())) / std::numbers::sqrt2;
        out.push_back(negative ? -left * size : right * size);
    }
    return out;
}

TEST(Statistics, FitsFindTheShapeThatMadeTheSamples) {
    EXPECT_NEAR(fit_ggd(samples(2, 1, 1, 200000)).alpha, 2, 0.05);
    EXPECT_NEAR(fit_ggd(samples(1, 3, 3, 200000)).alpha, 1, 0.03);
    EXPECT_NEAR(fit_ggd(samples(1, 3, 3, 200000)).variance, 9, 0.2);
    const Aggd skew = fit_aggd(samples(1, 1, 2.5, 200000));
    EXPECT_NEAR(skew.alpha, 1, 0.03);
    EXPECT_NEAR(skew.left_std, 1, 0.03);
    EXPECT_NEAR(skew.right_std, 2.5, 0.05);
}

TEST(Statistics, HalvingKeepsConstantsAndLinesAndRoundsUp) {
    Plane ramp(41, 30);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 41; ++x) ramp.at(x, y) = 3 * x - 2 * y;
    const Plane half = matlab_half(ramp);
    EXPECT_EQ(half.width, 21);
    EXPECT_EQ(half.height, 15);
    EXPECT_NEAR(half.at(8, 6), 3 * 16.5 - 2 * 12.5, 1e-9);
    EXPECT_NEAR(matlab_half(Plane(9, 1, 7)).at(4, 0), 7, 1e-12);
}

TEST(Statistics, ProductsOfNeighborsCloseToATorus) {
    Plane plane(3, 2);
    plane.pixels = {1, 2, 3, 4, 5, 6};
    EXPECT_EQ(neighbor_products(plane, {0, 0, 3, 2}, 0, 1), (std::vector<double>{3, 2, 6, 24, 20, 30}));
    EXPECT_EQ(neighbor_products(plane, {0, 0, 3, 2}, 1, -1), (std::vector<double>{5, 12, 12, 8, 15, 6}));
}

TEST(Symmetric, PseudoInverseOfAKnownMatrix) {
    EXPECT_NEAR(pseudo_inverse_form({2, 1, 1, 2}, {1, 1}), 2.0 / 3, 1e-12);
    EXPECT_NEAR(pseudo_inverse_form({1, 1, 1, 1}, {1, 1}), 1, 1e-12) << "one eigenvalue is 0 and does not count";
    EXPECT_NEAR(pseudo_inverse_form({1, 1, 1, 1}, {1, -1}), 0, 1e-12);
}

TEST(Niqe, AnOwnModelRanksSharpAboveBlurredAndNoisy) {
    const fs::path dir = scratch("niqe");
    std::vector<fs::path> pictures;
    for (int i = 0; i < 9; ++i) {
        pictures.push_back(dir / (std::to_string(i) + ".png"));
        save_png(pictures.back(), dead_leaves(768, 576, 100 + static_cast<std::uint64_t>(i)));
    }
    const fastscene::Run run;
    const NiqeModel fitted = fit_niqe(pictures, run);
    save_niqe_model(dir / "own.json", fitted);
    const NiqeModel model = load_niqe_model(dir / "own.json");
    EXPECT_EQ(model.covariance, fitted.covariance) << "every digit survives the file";
    EXPECT_EQ(model.pictures, 9u);
    EXPECT_GE(model.blocks, kLeastNiqeBlocks);
    EXPECT_EQ(model.blocks, fitted.blocks);
    const ImageRgb8 sharp = dead_leaves(400, 300, 7);
    ImageRgb8 noisy = sharp;
    Random random(1, "noise");
    for (Rgb8& p : noisy.pixels) p.g = static_cast<std::uint8_t>(std::clamp(p.g + 60 * random.normal(), 0.f, 255.f));
    const double good = niqe(sharp, model);
    EXPECT_LT(good, niqe(blurred_picture(sharp, 3), model));
    EXPECT_LT(good, niqe(noisy, model));
    EXPECT_THROW(fit_niqe({pictures[0]}, run), Error) << "too few blocks for a covariance";
    write_file(dir / "cut.png", read_file(pictures[0]).substr(0, 5000));
    std::vector<fs::path> with_damage = pictures;
    with_damage.insert(with_damage.begin() + 3, dir / "cut.png");
    EXPECT_EQ(fit_niqe(with_damage, run).covariance, fitted.covariance) << "what cannot be read is left out";
}

TEST(Scores, PicturesWithoutStructureGetAMessageAndNoNan) {
    NiqeModel model{std::vector<double>(36), std::vector<double>(36 * 36)};
    for (const ImageRgb8& picture :
         {ImageRgb8(1, 1), ImageRgb8(300, 200, Rgb8{128, 128, 128}), ImageRgb8(95, 500, Rgb8{1, 2, 3})}) {
        EXPECT_THROW(niqe(picture, model), Error);
        EXPECT_THROW(brisque_features(picture, BrisqueVariant::authors), Error);
        EXPECT_THROW(brisque_features(picture, BrisqueVariant::opencv), Error);
    }
    EXPECT_THROW(niqe(dead_leaves(150, 150, 1), model), Error) << "one block has no covariance";
}

TEST(Brisque, AHandMadeRegressionIsReadFromBothForms) {
    const fs::path dir = scratch("brisque");
    std::string sv = "-2", zero = "3", ranges = "x\n-1 1\n", list = "[ ", low, high;
    for (int i = 1; i <= 36; ++i) {
        sv += " " + std::to_string(i) + ":0.5";
        ranges += std::to_string(i) + " 0 4\n";
        list += i == 1 ? "0.5" : ", 0.5";
        low += i == 1 ? "0." : ", 0.";
        high += ", 4.";
    }
    write_file(dir / "allmodel",
               "svm_type epsilon_svr\nkernel_type rbf\ngamma 0.05\nnr_class 2\ntotal_sv 2\nrho -1.5\nSV\n" + sv + "\n" +
                   zero + " 36:0\n");
    write_file(dir / "allrange", ranges);
    EXPECT_EQ(load_libsvm_model(dir / "allmodel").weights, (std::vector<double>{-2, 3}));
    const BrisqueModel text = load_brisque_model(dir / "allmodel", dir / "allrange");
    EXPECT_EQ(text.variant, BrisqueVariant::authors);
    const std::vector<double> middle(36, 3);  // scaled to 0.5: equal to the first support vector
    EXPECT_NEAR(text.regression.value(brisque_scaled(middle, text)), -2 + 3 * std::exp(-0.05 * 9) + 1.5, 1e-12);

    std::string zeros = list;
    for (std::size_t at; (at = zeros.find("0.5")) != std::string::npos;) zeros.replace(at, 3, "0.");
    write_file(dir / "model.yml",
               "%YAML:1.0\n---\nopencv_ml_svm:\n   svmType: EPS_SVR\n   kernel:\n      type: RBF\n      gamma: 0.05\n  "
               " var_count: 36\n"
               "   sv_total: 2\n   support_vectors:\n      - " +
                   list + " ]\n      - " + zeros +
                   " ]\n   decision_functions:\n      -\n         rho: -1.5\n         alpha: [ -2., 3. ]\n");
    write_file(
        dir / "range.yml",
        "%YAML:1.0\n---\nrange: !!opencv-matrix\n   rows: 2\n   cols: 36\n   dt: f\n   data: [ " + low + high + " ]\n");
    const BrisqueModel yaml = load_brisque_model(dir / "model.yml", dir / "range.yml");
    EXPECT_EQ(yaml.variant, BrisqueVariant::opencv);
    EXPECT_NEAR(yaml.regression.value(brisque_scaled(middle, yaml)),
                text.regression.value(brisque_scaled(middle, text)), 1e-12);

    const auto refuses = [&](const char* file, const std::string& from, const std::string& to, const std::string& why) {
        const std::string whole = read_file(dir / file);
        std::string damaged = whole;
        damaged.replace(damaged.find(from), from.size(), to);
        write_file(dir / file, damaged);
        try {
            std::string(file).ends_with("yml") ? load_brisque_model(dir / "model.yml", dir / "range.yml")
                                               : load_brisque_model(dir / "allmodel", dir / "allrange");
            ADD_FAILURE() << file << ": " << from << " -> " << to;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find((dir / file).string() + ": " + why), std::string::npos) << e.what();
        }
        write_file(dir / file, whole);
    };
    refuses("allmodel", zero + " 36:0\n", "",
            "expected 2 support vectors as its head says, found 1");  // truncated between two lines
    refuses("allmodel", "rho -1.5\n", "", "expected a line \"rho\"");
    refuses("allmodel", "total_sv 2\n", "", "expected a line \"total_sv\"");
    refuses("model.yml", "alpha: [ -2., 3. ]", "alpha: [ -2. ]",
            "expected 2 support vectors as its head says, found 1");
    refuses("range.yml", "4. ]", "0. ]", "expected low < high of feature 36");

    write_file(dir / "allmodel", "svm_type c_svc\nkernel_type rbf\nSV\n");
    EXPECT_THROW(load_brisque_model(dir / "allmodel", dir / "allrange"), Error);
    write_file(dir / "allrange", "x\n-1 1\n1 0 nan\n");
    EXPECT_THROW(load_libsvm_ranges(dir / "allrange"), Error);
}

}  // namespace
}  // namespace fastscene
