#include "fastscene/metrics/niqe.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/mat_file.h"
#include "fastscene/metrics/naturalness.h"
#include "fastscene/metrics/symmetric.h"

namespace fastscene {
namespace {

// threshold relative to the sharpest block of a pristine picture (section III-B of the paper)
constexpr double kSharpEnough = 0.75;

void append_features(const Plane& structure, Block block, std::vector<double>& out) {
    const Aggd own = fit_aggd(block_values(structure, block));
    out.push_back(own.alpha);
    out.push_back((own.left_std + own.right_std) / 2 * own.scale());
    constexpr int shifts[4][2] = {{0, 1}, {1, 0}, {1, 1}, {1, -1}};  // rows, columns
    for (const auto& [dy, dx] : shifts) {
        const Aggd pair = fit_aggd(neighbor_products(structure, block, dy, dx));
        const double left = pair.left_std * pair.scale(), right = pair.right_std * pair.scale();
        out.insert(out.end(), {pair.alpha, (right - left) * pair.ratio(), left, right});
    }
}

double mean_over(const Plane& plane, Block block) {
    double sum = 0;
    for (const double v : block_values(plane, block)) sum += v;
    return sum / (block.width * block.height);
}

bool all_finite(const std::vector<double>& row) {
    return std::all_of(row.begin(), row.end(), [](double v) { return std::isfinite(v); });
}

// Mean over the rows where a feature is defined, covariance over complete rows: MATLAB's nanmean and nancov.
NiqeModel gaussian_of(const std::vector<std::vector<double>>& rows) {
    NiqeModel model;
    std::vector<std::vector<double>> whole;
    for (std::size_t k = 0; k < kNiqeFeatures; ++k) {
        double sum = 0, count = 0;
        for (const auto& row : rows)
            if (!std::isnan(row[k])) sum += row[k], ++count;
        model.mean.push_back(sum / count);
    }
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(whole), all_finite);
    std::vector<double> center(kNiqeFeatures);
    for (const auto& row : whole)
        for (std::size_t k = 0; k < kNiqeFeatures; ++k) center[k] += row[k] / static_cast<double>(whole.size());
    model.covariance.assign(kNiqeFeatures * kNiqeFeatures, 0);
    for (const auto& row : whole)
        for (std::size_t i = 0; i < kNiqeFeatures; ++i)
            for (std::size_t j = 0; j < kNiqeFeatures; ++j)
                model.covariance[i * kNiqeFeatures + j] += (row[i] - center[i]) * (row[j] - center[j]) /
                                                           static_cast<double>(whole.size() - 1);
    return model;
}

std::vector<double> numbers(const Json& json, const char* key, std::size_t count, const std::filesystem::path& path) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array() || found->size() != count)
        throw Error("{}: expected \"{}\" with {} numbers, found {}", path.string(), key, count,
                    found == json.end() ? "none" : "something else");
    std::vector<double> out;
    for (const Json& v : *found) {
        if (!v.is_number()) throw Error("{}: expected only numbers in \"{}\", found {}", path.string(), key, v.dump());
        out.push_back(v.get<double>());
    }
    return out;
}

std::vector<double> matrix(const std::map<std::string, MatMatrix>& file, const std::string& name, int rows,
                           const std::filesystem::path& path) {
    const auto found = file.find(name);
    if (found == file.end()) throw Error("{}: expected the matrix \"{}\", found none", path.string(), name);
    const MatMatrix& m = found->second;
    if (m.rows != rows || m.columns != kNiqeFeatures)
        throw Error("{}: expected \"{}\" to be {} x {}, found {} x {}", path.string(), name, rows, kNiqeFeatures,
                    m.rows, m.columns);
    if (!all_finite(m.values)) throw Error("{}: expected finite numbers in \"{}\", found others", path.string(), name);
    return m.values;
}

}  // namespace

NiqeModel load_niqe_model(const std::filesystem::path& path) {
    constexpr std::size_t n = kNiqeFeatures;
    const std::string bytes = read_file(path);
    if (bytes.starts_with("MATLAB")) {
        const auto file = load_mat_file(path);
        return {matrix(file, "mu_prisparam", 1, path), matrix(file, "cov_prisparam", kNiqeFeatures, path)};
    }
    if (const std::size_t begin = bytes.find_first_not_of(" \t\r\n"); begin == std::string::npos || bytes[begin] != '{')
        throw Error("{}: expected NIQE's parameters (the authors' .mat, or a .json of niqe-fit), found {}",
                    path.string(),
                    bytes.empty()            ? "an empty file"
                    : bytes.starts_with("<") ? "a web page: was the download refused?"
                                             : "something else");
    const Json json = read_json(path);
    const auto count = [&](const char* key) {
        return json.contains(key) && json.at(key).is_number_unsigned() ? json.at(key).get<std::size_t>() : 0;
    };
    return {numbers(json, "mean", n, path), numbers(json, "covariance", n * n, path), count("blocks"),
            count("pictures")};
}

void save_niqe_model(const std::filesystem::path& path, const NiqeModel& model) {
    write_json(path, {{"kind", "niqe"},
                      {"blocks", model.blocks},
                      {"pictures", model.pictures},
                      {"mean", model.mean},
                      {"covariance", model.covariance}});
}

NiqeBlocks niqe_blocks(const Plane& gray) {
    const int columns = gray.width / kNiqeBlock, rows = gray.height / kNiqeBlock;
    NiqeBlocks out;
    out.features.resize(static_cast<std::size_t>(columns * rows));
    if (out.features.empty()) return out;
    Plane plane(columns * kNiqeBlock, rows * kNiqeBlock);
    for (int y = 0; y < plane.height; ++y) std::copy_n(gray.row(y), plane.width, plane.row(y));
    for (int scale = 1; scale <= 2; ++scale) {
        const Normalized parts = normalized(plane, Border::replicate);
        const int side = kNiqeBlock / scale;
        for (int i = 0; i < columns * rows; ++i) {
            const Block block{i % columns * side, i / columns * side, side, side};
            append_features(parts.structure, block, out.features[static_cast<std::size_t>(i)]);
            if (scale == 1) out.sharpness.push_back(mean_over(parts.sigma, block));
        }
        if (scale == 1) plane = matlab_half(plane);
    }
    return out;
}

double niqe(const ImageRgb8& image, const NiqeModel& model, NiqeGray gray) {
    if (is_constant(image))
        throw Error("NIQE: expected a picture with structure, found one constant color ({} x {})", image.width,
                    image.height);
    const NiqeBlocks blocks = niqe_blocks(gray == NiqeGray::luma ? matlab_luma(image) : matlab_gray(image));
    const auto whole = std::count_if(blocks.features.begin(), blocks.features.end(), all_finite);
    if (whole < 2)
        throw Error(
            "NIQE: expected at least two blocks of {0} x {0} pixels with structure that is not all regular, found {1} "
            "in a picture of {2} x {3}",
            kNiqeBlock, whole, image.width, image.height);
    const NiqeModel own = gaussian_of(blocks.features);
    std::vector<double> difference(kNiqeFeatures), covariance(own.covariance.size());
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] = model.mean[i] - own.mean[i];
    for (std::size_t i = 0; i < covariance.size(); ++i) covariance[i] = (model.covariance[i] + own.covariance[i]) / 2;
    return std::sqrt(pseudo_inverse_form(covariance, difference));
}

NiqeModel fit_niqe(const std::vector<std::filesystem::path>& pictures, const Run& run) {
    std::vector<std::vector<double>> rows;
    std::size_t used = 0, unread = 0;
    Progress progress(run, "niqe-fit", static_cast<std::int64_t>(pictures.size()));
    for (const auto& path : pictures) {
        run.check_stop();
        progress.advance();
        ImageRgb8 image;
        try {
            image = load_rgb8(path);
        } catch (const Error& e) {
            ++unread;
            run.warn(fmt::format("left out: {}", e.what()));
            continue;
        }
        const NiqeBlocks blocks = niqe_blocks(matlab_gray(image));
        const std::size_t before = rows.size();
        const double sharpest = blocks.sharpness.empty()
                                    ? 0
                                    : *std::max_element(blocks.sharpness.begin(), blocks.sharpness.end());
        for (std::size_t i = 0; i < blocks.features.size(); ++i)
            if (blocks.sharpness[i] > kSharpEnough * sharpest && all_finite(blocks.features[i]))
                rows.push_back(blocks.features[i]);
        if (rows.size() > before) ++used;
        else
            run.warn(fmt::format("{}: no sharp block of {} x {} pixels in a picture of {} x {}, left out",
                                 path.string(), kNiqeBlock, kNiqeBlock, image.width, image.height));
    }
    const std::string without = unread == 0 ? "" : fmt::format(" ({} more cannot be read)", unread);
    if (rows.size() < kLeastNiqeBlocks)
        throw Error(
            "niqe-fit: expected pictures with at least {} sharp blocks of {} x {} pixels (good: {}), found {} in {} "
            "pictures{}",
            kLeastNiqeBlocks, kNiqeBlock, kNiqeBlock, kGoodNiqeBlocks, rows.size(), pictures.size() - unread, without);
    if (rows.size() < kGoodNiqeBlocks)
        run.warn(
            fmt::format("{} sharp blocks of {} x {} pixels in {} pictures: scores will hang on which pictures these "
                        "are; {} are good",
                        rows.size(), kNiqeBlock, kNiqeBlock, used, kGoodNiqeBlocks));
    if (unread > 0)
        run.note(fmt::format("niqe-fit: {} of {} pictures cannot be read and are left out", unread, pictures.size()));
    NiqeModel model = gaussian_of(rows);
    model.blocks = rows.size(), model.pictures = used;
    return model;
}

}  // namespace fastscene
