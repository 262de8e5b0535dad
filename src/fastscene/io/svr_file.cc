#include "fastscene/io/svr_file.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {
namespace {

double number_of(std::string_view text, const std::filesystem::path& path, int line) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw Error("{}:{}: expected a number, found \"{}\"", path.string(), line, text);
    return value;
}

// `count`: number of support vectors according to the file. With some missing, the regression would silently give a
// wrong score.
void check_model(const SvrModel& model, double count, const std::filesystem::path& path) {
    if (count != static_cast<double>(model.weights.size()))
        throw Error("{}: expected {} support vectors as its head says, found {} (cut off?)", path.string(), count,
                    model.weights.size());
    if (model.features < 1 || model.weights.empty() ||
        model.vectors.size() != model.weights.size() * static_cast<std::size_t>(model.features))
        throw Error("{}: expected support vectors of equal length with a weight each, found {} weights and {} numbers",
                    path.string(), model.weights.size(), model.vectors.size());
    if (!(model.gamma > 0)) throw Error("{}: expected gamma > 0, found {}", path.string(), model.gamma);
}

// One line "weight 1:a 2:b …"; omitted features are 0.
void read_support_vector(const std::string& line, SvrModel& model, const std::filesystem::path& path, int number) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    model.weights.push_back(number_of(word, path, number));
    std::vector<double> vector(static_cast<std::size_t>(model.features));
    while (words >> word) {
        const std::size_t colon = word.find(':');
        if (colon == std::string::npos)
            throw Error("{}:{}: expected index:value, found \"{}\"", path.string(), number, word);
        const double index = number_of(std::string_view(word).substr(0, colon), path, number);
        if (!(index >= 1 && index <= 4096))
            throw Error("{}:{}: expected an index from 1 to 4096, found {}", path.string(), number, index);
        const auto i = static_cast<std::size_t>(index);
        if (i > vector.size()) vector.resize(i);
        vector[i - 1] = number_of(std::string_view(word).substr(colon + 1), path, number);
    }
    if (model.weights.size() == 1) model.features = static_cast<int>(vector.size());
    if (static_cast<int>(vector.size()) != model.features)
        throw Error("{}:{}: expected {} features, found {}", path.string(), number, model.features, vector.size());
    model.vectors.insert(model.vectors.end(), vector.begin(), vector.end());
}

// The numbers of a YAML flow list "key: [ a, b, … ]" after position `from`, which is advanced.
std::optional<std::vector<double>> yaml_list(std::string_view text, std::string_view key, std::size_t& from,
                                             const std::filesystem::path& path) {
    const std::size_t at = text.find(key, from);
    if (at == std::string_view::npos) return std::nullopt;
    const std::size_t open = at + key.size(), close = text.find(']', open);
    if (close == std::string_view::npos)
        throw Error("{}: expected \"]\" after \"{}\", found the end of the file", path.string(), key);
    std::vector<double> out;
    for (std::size_t p = open; p < close;) {
        const std::size_t begin = text.find_first_not_of(" ,\r\n\t", p);
        if (begin >= close) break;
        const std::size_t end = std::min(close, text.find_first_of(" ,\r\n\t]", begin));
        std::string_view word = text.substr(begin, end - begin);
        if (word.ends_with('.')) word.remove_suffix(1);  // "1024."
        out.push_back(number_of(word, path, 1));
        p = end;
    }
    from = close;
    return out;
}
double yaml_number(std::string_view text, std::string_view key, const std::filesystem::path& path) {
    const std::size_t at = text.find(key);
    if (at == std::string_view::npos) throw Error("{}: expected \"{}\", found none", path.string(), key);
    const std::size_t begin = text.find_first_not_of(' ', at + key.size()), end = text.find_first_of("\r\n", begin);
    return number_of(text.substr(begin, end - begin), path, 1);
}

}  // namespace

double SvrModel::value(const std::vector<double>& x) const {
    double sum = -rho;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        double distance = 0;
        const double* v = vectors.data() + i * static_cast<std::size_t>(features);
        for (std::size_t k = 0; k < static_cast<std::size_t>(features); ++k) distance += (x[k] - v[k]) * (x[k] - v[k]);
        sum += weights[i] * std::exp(-gamma * distance);
    }
    return sum;
}

std::vector<double> FeatureRanges::scaled(const std::vector<double>& x) const {
    std::vector<double> out(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) out[i] = -1 + 2 * (x[i] - low[i]) / (high[i] - low[i]);
    return out;
}

SvrModel load_libsvm_model(const std::filesystem::path& path) {
    std::istringstream lines(read_file(path));
    SvrModel model;
    std::string line, kind, kernel;
    int number = 0;
    bool vectors = false;
    std::optional<double> rho, count;
    while (std::getline(lines, line)) {
        ++number;
        if (line.empty() || line == "\r") continue;
        if (vectors) {
            read_support_vector(line, model, path, number);
            continue;
        }
        std::istringstream words(line);
        std::string key, value;
        words >> key >> value;
        if (key == "SV") vectors = true;
        if (key == "svm_type") kind = value;
        if (key == "kernel_type") kernel = value;
        if (key == "gamma") model.gamma = number_of(value, path, number);
        if (key == "rho") rho = number_of(value, path, number);
        if (key == "total_sv") count = number_of(value, path, number);
    }
    if (kind != "epsilon_svr" || kernel != "rbf")
        throw Error(
            "{}: expected a libsvm model with svm_type epsilon_svr and kernel_type rbf, found \"{}\" and \"{}\"",
            path.string(), kind, kernel);
    for (const auto& [key, found] : {std::pair{"rho", &rho}, std::pair{"total_sv", &count}})
        if (!*found)
            throw Error("{}: expected a line \"{}\" before the support vectors, found none", path.string(), key);
    model.rho = *rho;
    check_model(model, *count, path);
    return model;
}

FeatureRanges load_libsvm_ranges(const std::filesystem::path& path) {
    std::istringstream lines(read_file(path));
    std::string line;
    int number = 2;
    double low = 0, high = 0;
    if (!std::getline(lines, line) || line.substr(0, 1) != "x")
        throw Error("{}:1: expected \"x\" (ranges of svm-scale), found \"{}\"", path.string(), line);
    std::getline(lines, line);
    std::istringstream(line) >> low >> high;
    if (low != -1 || high != 1) throw Error("{}:2: expected the target range -1 1, found \"{}\"", path.string(), line);
    FeatureRanges ranges;
    while (std::getline(lines, line)) {
        ++number;
        std::istringstream words(line);
        std::string index, a, b;
        if (!(words >> index)) continue;
        words >> a >> b;
        if (number_of(index, path, number) != static_cast<double>(ranges.low.size() + 1))
            throw Error("{}:{}: expected feature {}, found \"{}\"", path.string(), number, ranges.low.size() + 1,
                        index);
        ranges.low.push_back(number_of(a, path, number));
        ranges.high.push_back(number_of(b, path, number));
        if (!(ranges.high.back() > ranges.low.back()))
            throw Error("{}:{}: expected low < high, found \"{}\"", path.string(), number, line);
    }
    return ranges;
}

SvrModel load_opencv_svr(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    if (text.find("svmType: EPS_SVR") == std::string::npos || text.find("type: RBF") == std::string::npos)
        throw Error("{}: expected an OpenCV SVM with svmType EPS_SVR and a kernel of type RBF", path.string());
    SvrModel model;
    model.gamma = yaml_number(text, "gamma:", path);
    model.rho = yaml_number(text, "rho:", path);
    model.features = static_cast<int>(yaml_number(text, "var_count:", path));
    std::size_t at = text.find("support_vectors:");
    const std::size_t decision = text.find("decision_functions:");
    if (at == std::string::npos || decision == std::string::npos || decision < at)
        throw Error("{}: expected support_vectors and then decision_functions, found none", path.string());
    std::vector<std::vector<double>> vectors;
    const std::string_view support = std::string_view(text).substr(0, decision);
    while (auto row = yaml_list(support, "- [", at, path)) vectors.push_back(std::move(*row));
    at = decision;
    const auto alpha = yaml_list(text, "alpha: [", at, path);
    at = decision;
    const auto index = yaml_list(text, "index: [", at, path);
    if (!alpha) throw Error("{}: expected \"alpha\", found none", path.string());
    for (std::size_t i = 0; i < alpha->size(); ++i) {
        const double which = index && i < index->size() ? (*index)[i] : static_cast<double>(i);
        if (!(which >= 0 && which < static_cast<double>(vectors.size())))
            throw Error("{}: expected an index below {}, found {}", path.string(), vectors.size(), which);
        const std::vector<double>& v = vectors[static_cast<std::size_t>(which)];
        model.weights.push_back((*alpha)[i]);
        model.vectors.insert(model.vectors.end(), v.begin(), v.end());
    }
    check_model(model, yaml_number(text, "sv_total:", path), path);
    return model;
}

FeatureRanges load_opencv_ranges(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    std::size_t at = text.find("range:");
    const auto data = at == std::string::npos ? std::nullopt : yaml_list(text, "data: [", at, path);
    if (!data || data->empty() || data->size() % 2)
        throw Error("{}: expected a matrix \"range\" of two rows, found none", path.string());
    const auto half = static_cast<std::ptrdiff_t>(data->size() / 2);
    FeatureRanges ranges{{data->begin(), data->begin() + half}, {data->begin() + half, data->end()}};
    for (std::size_t i = 0; i < ranges.low.size(); ++i)
        if (!(ranges.high[i] > ranges.low[i]))
            throw Error("{}: expected low < high of feature {}, found {} and {}", path.string(), i + 1, ranges.low[i],
                        ranges.high[i]);
    return ranges;
}

}  // namespace fastscene
