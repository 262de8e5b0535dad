#include <charconv>
#include <cmath>
#include <map>

#include "fastscene/base/file.h"
#include "fastscene/io/bytes.h"
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

using Cameras = std::map<std::int64_t, Lens>;

template <class In>
Lens checked_lens(const In& in, const LensModel& model, std::uint64_t width, std::uint64_t height,
                  const std::vector<double>& parameters) {
    if (width < 1 || height < 1 || width > 65536 || height > 65536)
        in.refuse(fmt::format("expected a picture size, found {} x {}", width, height));
    for (const double p : parameters)
        if (!std::isfinite(p)) in.refuse("expected finite camera parameters, found another");
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
    for (const double number : v)
        if (!std::isfinite(number)) in.refuse("expected a finite pose, found another");
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

template <class In>
Photo photo_of(const In& in, const Cameras& cameras, std::int64_t camera, const Rigidd& world_from_camera,
               const std::string& name) {
    const auto found = cameras.find(camera);
    if (found == cameras.end()) in.refuse(fmt::format("expected a camera {} among the model's, found none", camera));
    if (!is_name_below(name)) in.refuse("expected a picture's name below the folder of images, found \"" + name + "\"");
    return {name, {}, {}, found->second, world_from_camera};
}

// Triples of x, y and point id. In files without these lines every second picture would be lost.
void check_points_line(Line& in) {
    bool all_numbers = true;
    int words = 0;
    for (; !in.empty(); ++words) all_numbers = in.skip_number() && all_numbers;
    if (!all_numbers || words % 3 != 0)
        in.refuse("expected the points of the picture above (x, y, number), or an empty line; found another line");
}

std::vector<Photo> photos_of_text(const fs::path& path, const Cameras& cameras) {
    std::vector<Photo> out;
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
        out.push_back(photo_of(in, cameras, camera, pose_of(in, v), in.tail()));
        points_follow = true;
    });
    return out;
}

std::vector<Photo> photos_of_binary(const fs::path& path, const Cameras& cameras) {
    const std::string bytes = read_file(path);
    ByteReader in(path, bytes);
    std::vector<Photo> out;
    for (std::size_t n = in.count(4 + 7 * 8 + 4 + 1 + 8); n > 0; --n) {
        (void)in.get<std::int32_t>();
        std::array<double, 7> v{};
        for (double& number : v) number = in.get<double>();
        const Rigidd pose = pose_of(in, v);
        const auto camera = in.get<std::int32_t>();
        const std::string name = in.text();
        in.skip(in.count(24) * 24);
        out.push_back(photo_of(in, cameras, camera, pose, name));
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

std::vector<Photo> photos_of_model(const fs::path& model) {
    if (is_binary(model))
        return photos_of_binary(part_of(model, "images", ".bin"), cameras_of_binary(part_of(model, "cameras", ".bin")));
    return photos_of_text(part_of(model, "images", ".txt"), cameras_of_text(part_of(model, "cameras", ".txt")));
}

// If pictures overlap too little, the mapper writes several models, 0, 1 …, and the first need not be the largest.
std::string larger_model_beside(const fs::path& model, std::size_t photos) {
    std::string said;
    for (int number = 1; is_colmap_model(model.parent_path() / std::to_string(number)); ++number) {
        const fs::path other = model.parent_path() / std::to_string(number);
        std::size_t there = 0;
        try {
            there = photos_of_model(other).size();
        } catch (const Error&) {  // not the requested one
        }
        if (there <= photos) continue;
        photos = there;
        said = fmt::format("{} is used, but {} has more pictures ({}): --colmap {} --images DIR would use that",
                           model.string(), other.string(), there, other.string());
    }
    return said;
}

}  // namespace

Capture load_colmap_model(const fs::path& model) {
    Capture capture;
    capture.source = model.string();
    capture.photos = photos_of_model(model);
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
        Capture capture = load_colmap_model(*place);
        capture.source = dir.string();
        if (place->filename() == "0") capture.warning = larger_model_beside(*place, capture.photos.size());
        name_files(capture, folders.images.empty() ? dir / "images" : folders.images,
                   folders.masks.empty() ? dir / "masks" : folders.masks, folders.downscale);
        return capture;
    }
    if (!fs::exists(dir)) throw Error("{}: cannot be read: No such file or directory", dir.string());
    throw Error(
        "{}: expected COLMAP's cameras and images (.bin or .txt) in sparse/0, sparse or the folder itself, found none",
        dir.string());
}

}  // namespace fastscene
