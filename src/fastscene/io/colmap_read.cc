#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "fastscene/base/file.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/capture_parts.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Numbers and words of one line of a text model.
class Line {
  public:
    Line(const fs::path& path, std::size_t number, std::string_view text) : path_(path), number_(number), rest_(text) {}
    std::string_view word() {
        const std::size_t begin = rest_.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) refuse("expected another word, found the end of the line");
        const std::size_t end = std::min(rest_.find_first_of(" \t\r", begin), rest_.size());
        const std::string_view out = rest_.substr(begin, end - begin);
        rest_.remove_prefix(end);
        return out;
    }
    // The rest of the line, trimmed.
    std::string tail() {
        const std::size_t begin = rest_.find_first_not_of(" \t\r"), end = rest_.find_last_not_of(" \t\r");
        return begin == std::string_view::npos ? "" : std::string(rest_.substr(begin, end - begin + 1));
    }
    bool empty() const { return rest_.find_first_not_of(" \t\r") == std::string_view::npos; }
    template <class T>
    T number() {
        const std::string_view text = word();
        T value{};
        if constexpr (std::is_floating_point_v<T>)
            if (text.find('#') != std::string_view::npos)  // old Windows programs: 1.#QNAN, -1.#IND, 1.#INF
                return std::numeric_limits<T>::quiet_NaN();
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (code != std::errc() || end != text.data() + text.size())
            refuse("expected a number, found \"" + std::string(text) + "\"");
        return value;
    }
    bool skip_number() {
        const std::string_view text = word();
        double value = 0;
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
        return code == std::errc() && end == text.data() + text.size();
    }
    [[noreturn]] void refuse(const std::string& what) const {
        throw Error("{}: line {}: {}", path_.string(), number_, what);
    }

  private:
    const fs::path& path_;
    std::size_t number_;
    std::string_view rest_;
};

// Calls read(line) for each line, skipping comments, and empty lines unless they are significant.
template <class Read>
void each_line(const fs::path& path, bool with_empty, const Read& read) {
    const std::string text = read_file(path);
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        Line line(path, ++number, std::string_view(text).substr(at, end - at));
        const bool comment = text[at] == '#';
        if (!comment && (with_empty || !line.empty())) read(line);
        at = end + 1;
    }
}

// A camera whose numbers are not finite has none: its pictures are left out.
using Cameras = std::map<std::int64_t, std::optional<Lens>>;

// The photos of a model, and those that it has but that cannot be used, with the reason.
struct ModelPhotos {
    std::vector<Photo> photos;
    std::vector<std::string> unusable;
};

bool all_finite(const auto& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); });
}

template <class In>
std::optional<Lens> checked_lens(const In& in, const LensModel& model, std::uint64_t width, std::uint64_t height,
                                 const std::vector<double>& parameters) {
    if (width < 1 || height < 1 || width > 65536 || height > 65536)
        in.refuse(fmt::format("expected a picture size, found {} x {}", width, height));
    if (!all_finite(parameters)) return {};
    const Lens lens = lens_of(model, static_cast<int>(width), static_cast<int>(height), parameters);
    if (lens.kind == LensKind::unified && !(lens.k[0] >= 0 && lens.k[0] <= 1 && lens.k[1] > 0))
        in.refuse(fmt::format("expected an EUCM camera's alpha from 0 to 1 and a positive beta, found {} and {}",
                              lens.k[0], lens.k[1]));
    if (lens.kind != LensKind::equirectangular && !(lens.fx > 0 && lens.fy > 0))
        in.refuse(fmt::format("expected a positive focal length, found {}", lens.fx));
    return lens;
}

template <class In>
Rigidd pose_of(const In& in, const std::array<double, 7>& v) {
    const Quatd q{v[0], v[1], v[2], v[3]};
    if (const double n = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z; !(n > 0.1 && n < 10))
        in.refuse("expected a unit quaternion, found one of another length");
    return inverse(Rigidd{matrix_of(q), {v[4], v[5], v[6]}});
}

Cameras cameras_of_text(const fs::path& path) {
    Cameras out;
    each_line(path, false, [&](Line& in) {
        const auto id = in.number<std::int64_t>();
        const std::string name(in.word());
        const auto model = lens_model(name);
        if (!model) in.refuse(fmt::format("expected a camera model among {}, found {}", lens_model_names(), name));
        const auto width = in.number<std::uint64_t>(), height = in.number<std::uint64_t>();
        std::vector<double> parameters;
        const bool sphere = model->name ==
                            "EQUIRECTANGULAR";  // determined by its size; some writers omit the parameters
        for (std::size_t i = 0; i < model->parameters; ++i)
            parameters.push_back(sphere && in.empty() ? 0 : in.number<double>());
        out[id] = checked_lens(in, *model, width, height, parameters);
    });
    return out;
}

Cameras cameras_of_binary(const fs::path& path) {
    const std::string bytes = read_file(path);
    ByteReader in(path, bytes);
    Cameras out;
    for (std::size_t n = in.count(24); n > 0; --n) {
        const auto id = in.get<std::int32_t>(), number = in.get<std::int32_t>();
        const auto model = lens_model(number);
        if (!model)
            in.refuse(fmt::format("expected a camera model among {}, found number {}", lens_model_names(), number));
        const auto width = in.get<std::uint64_t>(), height = in.get<std::uint64_t>();
        std::vector<double> parameters;
        for (std::size_t i = 0; i < model->parameters; ++i) parameters.push_back(in.get<double>());
        out[id] = checked_lens(in, *model, width, height, parameters);
    }
    return out;
}

// `v`: quaternion and translation.
template <class In>
void add_photo(const In& in, const Cameras& cameras, std::int64_t camera, const std::array<double, 7>& v,
               const std::string& name, ModelPhotos& out) {
    const auto found = cameras.find(camera);
    if (found == cameras.end()) in.refuse(fmt::format("expected a camera {} among the model's, found none", camera));
    if (!is_name_below(name)) in.refuse("expected a picture's name below the folder of images, found \"" + name + "\"");
    if (!found->second) out.unusable.push_back(fmt::format("{} (camera {} is not finite)", name, camera));
    else if (!all_finite(v)) out.unusable.push_back(name + " (its pose is not finite)");
    else out.photos.push_back({name, {}, {}, *found->second, pose_of(in, v)});
}

// Triples of x, y and point id. In files without these lines every second picture would be lost.
void check_points_line(Line& in) {
    bool all_numbers = true;
    int words = 0;
    for (; !in.empty(); ++words) all_numbers = in.skip_number() && all_numbers;
    if (!all_numbers || words % 3 != 0)
        in.refuse("expected the points of the picture above (x, y, number), or an empty line; found another line");
}

ModelPhotos photos_of_text(const fs::path& path, const Cameras& cameras) {
    ModelPhotos out;
    bool points_follow = false;  // each image has a second line with its points, possibly empty
    each_line(path, true, [&](Line& in) {
        if (points_follow) {
            points_follow = false;
            return check_points_line(in);
        }
        if (in.empty()) return;
        (void)in.number<std::int64_t>();
        std::array<double, 7> v{};
        for (double& number : v) number = in.number<double>();
        const auto camera = in.number<std::int64_t>();
        add_photo(in, cameras, camera, v, in.tail(), out);
        points_follow = true;
    });
    return out;
}

ModelPhotos photos_of_binary(const fs::path& path, const Cameras& cameras) {
    const std::string bytes = read_file(path);
    ByteReader in(path, bytes);
    ModelPhotos out;
    for (std::size_t n = in.count(4 + 7 * 8 + 4 + 1 + 8); n > 0; --n) {
        (void)in.get<std::int32_t>();
        std::array<double, 7> v{};
        for (double& number : v) number = in.get<double>();
        const auto camera = in.get<std::int32_t>();
        const std::string name = in.text();
        in.skip(in.count(24) * 24);
        add_photo(in, cameras, camera, v, name, out);
    }
    return out;
}

std::vector<CapturePoint> points_of_text(const fs::path& path) {
    std::vector<CapturePoint> out;
    each_line(path, false, [&](Line& in) {
        (void)in.number<std::uint64_t>();
        CapturePoint p;
        for (std::size_t a = 0; a < 3; ++a) p.position[a] = in.number<double>();
        p.color.r = in.number<std::uint8_t>(), p.color.g = in.number<std::uint8_t>(),
        p.color.b = in.number<std::uint8_t>();
        out.push_back(p);
    });
    return out;
}

std::vector<CapturePoint> points_of_binary(const fs::path& path) {
    const std::string bytes = read_file(path);
    ByteReader in(path, bytes);
    std::vector<CapturePoint> out;
    for (std::size_t n = in.count(8 + 24 + 3 + 8 + 8); n > 0; --n) {
        (void)in.get<std::uint64_t>();
        CapturePoint p;
        for (std::size_t a = 0; a < 3; ++a) p.position[a] = in.get<double>();
        p.color.r = in.get<std::uint8_t>(), p.color.g = in.get<std::uint8_t>(), p.color.b = in.get<std::uint8_t>();
        (void)in.get<double>();
        in.skip(in.count(8) * 8);
        out.push_back(p);
    }
    return out;
}

}  // namespace

bool is_colmap_model(const fs::path& dir) {
    const auto has = [&](const char* part) {
        return fs::exists(dir / (std::string(part) + ".bin")) || fs::exists(dir / (std::string(part) + ".txt"));
    };
    return has("cameras") && has("images");
}

namespace {

fs::path part_of(const fs::path& model, const char* part, const char* ending) {
    return model / (std::string(part) + ending);
}

// Prefers the binary files if both exist, like COLMAP.
bool is_binary(const fs::path& model) {
    return fs::exists(part_of(model, "cameras", ".bin")) && fs::exists(part_of(model, "images", ".bin"));
}

ModelPhotos photos_of_model(const fs::path& model) {
    if (is_binary(model))
        return photos_of_binary(part_of(model, "images", ".bin"), cameras_of_binary(part_of(model, "cameras", ".bin")));
    return photos_of_text(part_of(model, "images", ".txt"), cameras_of_text(part_of(model, "cameras", ".txt")));
}

std::size_t photos_in(const fs::path& model) {
    try {
        return photos_of_model(model).photos.size();
    } catch (const Error&) {  // damaged: never the largest
        return 0;
    }
}

// If pictures overlap too little, the mapper writes several models, 0, 1 …, and the first need not be the largest.
// Returns the largest, and says so if it had to choose.
fs::path largest_model_beside(const fs::path& model, std::vector<std::string>& said) {
    std::vector<std::pair<fs::path, std::size_t>> models;
    for (int n = 0; is_colmap_model(model.parent_path() / std::to_string(n)); ++n)
        models.emplace_back(model.parent_path() / std::to_string(n), n);
    if (models.size() < 2) return model;
    for (auto& [place, photos] : models) photos = photos_in(place);
    std::stable_sort(models.begin(), models.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    const auto& [largest, photos] = models.front();
    if (largest == model) return model;
    said.push_back(fmt::format(
        "{} of {} models is used, the largest: {} pictures; the next has {} ({}); --colmap {} "
        "--images DIR would use that",
        largest.string(), models.size(), photos, models[1].second, models[1].first.string(), models[1].first.string()));
    return largest;
}

// More than half of the pictures without a usable camera: that is the reconstruction's failure, not an exception.
void tell_unusable(const fs::path& model, const ModelPhotos& found, Capture& capture) {
    constexpr std::size_t kNamed = 10;
    const std::size_t unusable = found.unusable.size(), all = unusable + found.photos.size();
    if (unusable == 0) return;
    std::vector<std::string> named(found.unusable.begin(),
                                   found.unusable.begin() + static_cast<std::ptrdiff_t>(std::min(unusable, kNamed)));
    if (unusable > kNamed) named.push_back(fmt::format("and {} more", unusable - kNamed));
    const std::string list = fmt::format("{}", fmt::join(named, "; "));
    if (2 * unusable > all)
        throw Error("{}: expected finite cameras and poses, found {} of {} pictures without: {}", model.string(),
                    unusable, all, list);
    capture.warnings.push_back(
        fmt::format("{}: {} of {} pictures are left out: {}", model.string(), unusable, all, list));
}

}  // namespace

Capture load_colmap_model(const fs::path& model) {
    Capture capture;
    capture.source = model.string();
    ModelPhotos found = photos_of_model(model);
    tell_unusable(model, found, capture);
    capture.photos = std::move(found.photos);
    if (const fs::path file = part_of(model, "points3D", ".bin"); is_binary(model) && fs::exists(file))
        capture.points = points_of_binary(file);
    else if (const fs::path text = part_of(model, "points3D", ".txt"); fs::exists(text))
        capture.points = points_of_text(text);
    else if (const fs::path ply = part_of(model, "points3D", ".ply"); fs::exists(ply))
        capture.points = points_of_ply(ply);
    sort_by_name(capture.photos);
    return capture;
}

std::optional<fs::path> colmap_model_in(const fs::path& dir) {
    for (const fs::path& place : {dir / "sparse" / "0", dir / "sparse", dir / "colmap" / "sparse" / "0", dir})
        if (is_colmap_model(place)) return place;
    return {};
}

Capture load_colmap_capture(const fs::path& dir, const CaptureFolders& folders) {
    if (const auto place = colmap_model_in(dir)) {
        std::vector<std::string> said;
        const bool chosen = place->filename() == "0" && *place != dir;  // by the program, not by its user
        Capture capture = load_colmap_model(chosen ? largest_model_beside(*place, said) : *place);
        capture.source = dir.string();
        capture.warnings.insert(capture.warnings.begin(), said.begin(), said.end());
        name_files(capture, folders.images.empty() ? dir / "images" : folders.images,
                   folders.masks.empty() ? dir / "masks" : folders.masks, folders.downscale);
        finish_capture(capture, folders);
        return capture;
    }
    if (!fs::exists(dir)) throw Error("{}: cannot be read: No such file or directory", dir.string());
    throw Error(
        "{}: expected COLMAP's cameras and images (.bin or .txt) in sparse/0, sparse or the folder itself, found none",
        dir.string());
}

}  // namespace fastscene
