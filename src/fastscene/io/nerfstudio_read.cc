#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/capture_parts.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/picture_folder.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class Transforms {
  public:
    Transforms(const fs::path& file, const CaptureFolders& folders)
        : file_(file), dir_(file.parent_path()), folders_(folders), json_(read_json(file)) {}

    Capture capture() {
        if (!json_.is_object() || !json_.contains("frames") || !json_.at("frames").is_array())
            refuse("", "expected \"frames\", an array, found none");
        Capture out;
        out.source = file_.string();
        std::size_t number = 0;
        for (const Json& frame : json_.at("frames"))
            out.photos.push_back(photo(frame, fmt::format("frames[{}]", number++)));
        if (!folders_.images.empty()) check_own_pictures(out.photos);
        if (json_.contains("ply_file_path") && json_.at("ply_file_path").is_string())
            read_points(dir_ / with_slashes(json_.at("ply_file_path").get<std::string>()), out);
        if (const auto text = renamed_.warning(out.source, out.photos.size())) out.warnings.push_back(*text);
        finish_capture(out, folders_);
        return out;
    }

  private:
    void read_points(const fs::path& file, Capture& out) const {
        if (fs::exists(file)) out.points = points_of_ply(file);
        else out.missing_points = file;
        if (json_.contains("applied_transform")) move_into_frame(out);
    }
    // The poses are in the frame after applied_transform. nerfstudio's own cloud is, too; that of other exporters is
    // not: the cameras tell, which see the right one.
    void move_into_frame(Capture& out) const {
        std::array<std::array<double, 4>, 3> m{};
        try {
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 4; ++j) m[i][j] = json_.at("applied_transform").at(i).at(j).get<double>();
        } catch (const Json::exception&) {
            refuse("applied_transform", "expected 3 rows of 4 numbers, found another");
        }
        const double scale = number(json_, "", "applied_scale").value_or(1);
        std::vector<CapturePoint> moved = out.points;
        for (CapturePoint& p : moved) {
            const Vec3d at = p.position;
            for (std::size_t i = 0; i < 3; ++i)
                p.position[i] = scale * (m[i][0] * at.x + m[i][1] * at.y + m[i][2] * at.z + m[i][3]);
        }
        constexpr double kClearlyMore = 0.1;  // of all pairs of a photo and a point
        if (!(share_in_view(out.photos, moved) > share_in_view(out.photos, out.points) + kClearlyMore)) return;
        out.points = std::move(moved);
        out.warnings.push_back(fmt::format(
            "{}: the cameras see the cloud only after applied_transform, which is applied to it", file_.string()));
    }
    [[noreturn]] void refuse(const std::string& where, const std::string& what) const {
        throw Error("{}: {}{}{}", file_.string(), where, where.empty() ? "" : ": ", what);
    }

    // A number of the frame, or the file's default for all frames.
    std::optional<double> number(const Json& frame, const std::string& where, const char* name) const {
        const Json* owner = frame.contains(name) ? &frame : json_.contains(name) ? &json_ : nullptr;
        if (!owner) return {};
        const Json& value = owner->at(name);
        if (!value.is_number() || !std::isfinite(value.get<double>()))
            refuse(where, fmt::format("expected a number as \"{}\", found {}", name, value.dump().substr(0, 40)));
        return value.get<double>();
    }
    std::optional<std::string> text(const Json& frame, const std::string& where, const char* name) const {
        const Json* owner = frame.contains(name) ? &frame : json_.contains(name) ? &json_ : nullptr;
        if (!owner || owner->at(name).is_null()) return {};
        if (!owner->at(name).is_string())
            refuse(where,
                   fmt::format("expected a text as \"{}\", found {}", name, owner->at(name).dump().substr(0, 40)));
        return owner->at(name).get<std::string>();
    }
    bool flag(const Json& frame, const char* name) const {
        const Json* owner = frame.contains(name) ? &frame : json_.contains(name) ? &json_ : nullptr;
        return owner && owner->at(name) == Json(true);
    }

    // Suffixes of a path, from all its folders down to the file name alone. Pictures of multi-camera rigs share file
    // names.
    static std::vector<fs::path> tails(const fs::path& name) {
        std::vector<fs::path> out;
        for (auto begin = name.begin(); begin != name.end(); ++begin) {
            fs::path tail;
            for (auto part = begin; part != name.end(); ++part)
                if (*part != "." && *part != ".." && *part != "/") tail /= *part;
            if (!tail.empty() && (out.empty() || out.back() != tail)) out.push_back(tail);
        }
        return out;
    }
    static void check_own_pictures(const std::vector<Photo>& photos) {
        std::map<fs::path, std::string> owners;
        for (const Photo& photo : photos) {
            if (!fs::is_regular_file(photo.file)) continue;  // dropped later, with a warning
            if (const auto [owner, is_new] = owners.try_emplace(photo.file, photo.name);
                !is_new && owner->second != photo.name)
                throw Error("--images: expected a picture of its own for each frame, found {} for both {} and {}",
                            photo.file.string(), owner->second, photo.name);
        }
    }

    // NeRF's files omit the extension; downsampled copies are in images_2, images_4 …
    fs::path picture(const std::string& name) {
        std::vector<fs::path> places;
        const fs::path path(name);
        if (!folders_.images.empty()) {
            for (const fs::path& tail : tails(path)) places.push_back(folders_.images / tail);
        } else {
            if (folders_.downscale > 1 && path.has_parent_path()) {
                const std::string smaller = "_" + std::to_string(folders_.downscale);
                const fs::path first = *path.begin();
                places.push_back(dir_ / (path.parent_path().string() + smaller) / path.filename());
                places.push_back(dir_ / (first.string() + smaller) / path.lexically_relative(first));
            }
            places.push_back(dir_ / path);
        }
        if (places.empty()) return dir_ / path;
        const fs::path usual = places.back();
        if (folders_.images.empty())  // written on another machine, from its root or from another folder
            for (const fs::path& tail : tails(path)) places.push_back(dir_ / tail);
        for (const fs::path& place : places) {
            if (fs::is_regular_file(place)) return place;
            for (const char* ending : kPictureEndings)
                if (const fs::path whole = place.string() + ending; fs::is_regular_file(whole)) return whole;
        }
        for (const fs::path& tail : tails(path))
            if (const fs::path other = own_pictures_.similar_to(tail.string()); !other.empty()) return other;
        return usual;
    }

    static std::optional<PictureInfo> info_of_picture(const fs::path& file) {
        try {
            return picture_info(file);
        } catch (const Error&) {
            return {};
        }
    }
    // Size of the first readable picture: missing and damaged ones will be dropped, and all have the same camera.
    std::optional<PictureInfo> usual_picture() {
        const Json& frames = json_.at("frames");
        for (std::size_t i = 0; i < frames.size() && !usual_picture_; ++i)
            usual_picture_ = info_of_picture(picture(name_of(frames[i], fmt::format("frames[{}]", i))));
        return usual_picture_;
    }

    // nerfstudio's camera model, or instant-ngp's flags.
    std::string lens_name(const Json& frame, const std::string& where) const {
        for (const char* other : {"ftheta_p0", "orthographic", "equirectangular"})
            if (frame.contains(other) || json_.contains(other))
                refuse(
                    where,
                    fmt::format(
                        "expected a lens that \"camera_model\" names (EQUIRECTANGULAR for whole spheres), found \"{}\"",
                        other));
        auto name = text(frame, where, "camera_model");
        if (name)
            for (char& c : *name) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        return name                        ? *name
               : flag(frame, "is_fisheye") ? "OPENCV_FISHEYE"
               : flag(frame, "latlong")    ? "EQUIRECTANGULAR"
                                           : "OPENCV";
    }

    Lens lens(const Json& frame, const std::string& where, const fs::path& file) {
        const std::string name = lens_name(frame, where);
        static constexpr std::array kKnown{"OPENCV", "PINHOLE",     "SIMPLE_PINHOLE", "SIMPLE_RADIAL",
                                           "RADIAL", "PERSPECTIVE", "OPENCV_FISHEYE", "EQUIRECTANGULAR"};
        if (std::find(kKnown.begin(), kKnown.end(), name) == kKnown.end())
            refuse(where, fmt::format("expected camera_model {}, found {}", fmt::join(kKnown, ", "), name));
        double width = number(frame, where, "w").value_or(0), height = number(frame, where, "h").value_or(0);
        if (width == 0 || height == 0) {
            auto info = info_of_picture(file);
            if (!info) info = usual_picture();
            if (!info)
                refuse(where, fmt::format("expected w and h, or a picture to ask; found neither w and h nor {}",
                                          file.string()));
            width = info->width, height = info->height;
        }
        if (!(width >= 1 && height >= 1 && width <= 65536 && height <= 65536))
            refuse(where, fmt::format("expected a picture size, found {} x {}", width, height));
        Lens lens;
        lens.width = static_cast<int>(width), lens.height = static_cast<int>(height);
        if (name == "EQUIRECTANGULAR") return lens.kind = LensKind::equirectangular, lens;
        if (name == "OPENCV_FISHEYE") lens.kind = LensKind::fisheye;
        const auto angle_x = number(frame, where, "camera_angle_x"), angle_y = number(frame, where, "camera_angle_y");
        const auto fov_x = number(frame, where, "x_fov"), fov_y = number(frame, where, "y_fov");  // degrees
        const auto fl_x = number(frame, where, "fl_x"), fl_y = number(frame, where, "fl_y");
        const auto focal = [](double size, double angle) { return size / 2 / std::tan(angle / 2); };
        constexpr double kDegree = std::numbers::pi / 180;
        lens.fx = fl_x      ? *fl_x
                  : angle_x ? focal(width, *angle_x)
                  : fov_x   ? focal(width, *fov_x * kDegree)
                            : fl_y.value_or(0);
        lens.fy = fl_y ? *fl_y : angle_y ? focal(height, *angle_y) : fov_y ? focal(height, *fov_y * kDegree) : lens.fx;
        lens.cx = number(frame, where, "cx").value_or(width / 2),
        lens.cy = number(frame, where, "cy").value_or(height / 2);
        if (!(lens.fx > 0 && lens.fy > 0))
            refuse(where, fmt::format("expected a positive focal length (fl_x, or camera_angle_x), found {}", lens.fx));
        constexpr std::array<const char*, 4> kNames{"k1", "k2", "k3", "k4"};
        for (std::size_t i = 0; i < kNames.size(); ++i)
            if (lens.kind == LensKind::fisheye || i < 3) lens.k[i] = number(frame, where, kNames[i]).value_or(0);
        if (const double k4 = number(frame, where, "k4").value_or(0); lens.kind == LensKind::perspective && k4 != 0)
            refuse(where,
                   fmt::format("expected a \"k4\" of 0 for {} (only OPENCV_FISHEYE has a fourth), found {}", name, k4));
        if (lens.kind == LensKind::perspective)
            lens.p1 = number(frame, where, "p1").value_or(0), lens.p2 = number(frame, where, "p2").value_or(0);
        return lens;
    }

    // Camera to world in OpenGL axes (y up, z back): the second and third columns change sign.
    Rigidd pose(const Json& frame, const std::string& where) const {
        std::array<std::array<double, 4>, 3> m{};
        try {
            const Json& rows = frame.at("transform_matrix");
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 4; ++j) m[i][j] = rows.at(i).at(j).get<double>();
        } catch (const Json::exception&) {
            refuse(where, "expected transform_matrix, 4 rows of 4 numbers, found another");
        }
        const auto column = [&](std::size_t j) { return Vec3d{m[0][j], m[1][j], m[2][j]}; };
        const double size = length(column(0));
        const Vec3d right = column(0) * (1 / size), up = column(1) * (1 / length(column(1))),
                    back = column(2) * (1 / length(column(2)));
        const Vec3d place = column(3);
        const bool turn = std::fabs(dot(right, up)) < 0.02 && length(cross(right, up) - back) < 0.02 && size > 1e-9;
        if (!(turn && std::isfinite(place.x + place.y + place.z)))
            refuse(where, "expected a rotation and a place in transform_matrix, found another matrix");
        return {matrix_of(quaternion_of(Mat3d::from_columns(right, -up, -back))), place};
    }

    std::string name_of(const Json& frame, const std::string& where) const {
        if (!frame.is_object() || !frame.contains("file_path") || !frame.at("file_path").is_string())
            refuse(where, "expected file_path, found none");
        std::string name = with_slashes(frame.at("file_path").get<std::string>());
        if (name.starts_with("./")) name.erase(0, 2);
        if (name.empty()) refuse(where, "expected file_path, found an empty one");
        return name;
    }

    Photo photo(const Json& frame, const std::string& where) {
        Photo out;
        out.name = name_of(frame, where);
        out.file = picture(out.name);
        // NeRF's names have no ending; another ending or letter case is told.
        if (fs::is_regular_file(out.file) &&
            !out.file.filename().string().starts_with(fs::path(out.name).filename().string()))
            renamed_.add(out.name, out.file);
        if (const auto mask = text(frame, where, "mask_path")) out.mask = dir_ / with_slashes(*mask);
        for (const fs::path& tail : tails(out.name))
            if (out.mask.empty())
                out.mask = mask_for(folders_.masks.empty() ? dir_ / "masks" : folders_.masks, tail.string());
        out.lens = lens(frame, where, out.file);
        out.world_from_camera = pose(frame, where);
        return out;
    }

    fs::path file_, dir_;
    CaptureFolders folders_;
    Json json_;
    std::optional<PictureInfo> usual_picture_;
    PictureFolder own_pictures_{folders_.images.empty() ? dir_ : folders_.images};
    RenamedPictures renamed_;
};

// NeRF's synthetic sets have several splits; the first is for training.
fs::path transforms_in(const fs::path& dir) {
    const fs::path part = dir / "transforms_train.json";
    return !fs::exists(dir / "transforms.json") && fs::exists(part) ? part : dir / "transforms.json";
}

}  // namespace

Capture load_nerfstudio_capture(const fs::path& file, const CaptureFolders& folders) {
    return Transforms(fs::is_directory(file) ? transforms_in(file) : file, folders).capture();
}

}  // namespace fastscene
