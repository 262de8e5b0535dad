#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/capture_parts.h"
#include "fastscene/io/image_io.h"

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
        for (const Json& frame : json_.at("frames")) out.photos.push_back(photo(frame, fmt::format("frames[{}]", number++)));
        if (json_.contains("ply_file_path") && json_.at("ply_file_path").is_string())
            read_points(dir_ / json_.at("ply_file_path").get<std::string>(), out);
        sort_by_name(out.photos);
        return out;
    }

  private:
    static void read_points(const fs::path& file, Capture& out) {
        if (fs::exists(file))
            out.points = points_of_ply(file);
        else
            out.missing_points = file;
    }
    [[noreturn]] void refuse(const std::string& where, const std::string& what) const {
        throw Error("{}: {}{}{}", file_.string(), where, where.empty() ? "" : ": ", what);
    }

    // A number of the frame, or of the file for all frames.
    std::optional<double> number(const Json& frame, const std::string& where, const char* name) const {
        const Json* owner = frame.contains(name) ? &frame : json_.contains(name) ? &json_ : nullptr;
        if (!owner) return {};
        const Json& value = owner->at(name);
        if (!value.is_number() || !std::isfinite(value.get<double>()))
            refuse(where, fmt::format("expected a number as \"{}\", found {}", name, value.dump().substr(0, 40)));
        return value.get<double>();
    }
    std::optional<std::string> text(const Json& frame, const char* name) const {
        const Json* owner = frame.contains(name) ? &frame : json_.contains(name) ? &json_ : nullptr;
        return owner && owner->at(name).is_string() ? std::optional<std::string>(owner->at(name).get<std::string>()) : std::nullopt;
    }

    // NeRF's files leave the ending away; smaller copies lie in images_2, images_4 …
    fs::path picture(const std::string& name) const {
        std::vector<fs::path> places;
        const fs::path path(name);
        if (!folders_.images.empty()) places = {folders_.images / path.filename()};
        if (folders_.images.empty() && folders_.downscale > 1 && path.has_parent_path())
            places.push_back(dir_ / (path.parent_path().string() + "_" + std::to_string(folders_.downscale)) / path.filename());
        if (folders_.images.empty()) places.push_back(dir_ / path);
        for (const fs::path& place : places) {
            if (fs::is_regular_file(place)) return place;
            for (const char* ending : kPictureEndings)
                if (const fs::path whole = place.string() + ending; fs::is_regular_file(whole)) return whole;
        }
        return places.back();
    }

    Lens lens(const Json& frame, const std::string& where, const fs::path& file) const {
        const std::string name = text(frame, "camera_model").value_or("OPENCV");
        static constexpr std::array kKnown{"OPENCV", "PINHOLE", "SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL", "PERSPECTIVE", "OPENCV_FISHEYE", "EQUIRECTANGULAR"};
        if (std::find(kKnown.begin(), kKnown.end(), name) == kKnown.end())
            refuse(where, fmt::format("expected camera_model {}, found {}", fmt::join(kKnown, ", "), name));
        double width = number(frame, where, "w").value_or(0), height = number(frame, where, "h").value_or(0);
        if (width == 0 || height == 0) {
            if (!fs::exists(file)) refuse(where, fmt::format("expected w and h, or the picture to ask; found neither w and h nor {}", file.string()));
            const PictureInfo info = picture_info(file);
            width = info.width, height = info.height;
        }
        if (!(width >= 1 && height >= 1 && width <= 65536 && height <= 65536))
            refuse(where, fmt::format("expected a picture size, found {} x {}", width, height));
        Lens lens;
        lens.width = static_cast<int>(width), lens.height = static_cast<int>(height);
        if (name == "EQUIRECTANGULAR") return lens.kind = LensKind::equirectangular, lens;
        if (name == "OPENCV_FISHEYE") lens.kind = LensKind::fisheye;
        const auto angle_x = number(frame, where, "camera_angle_x"), angle_y = number(frame, where, "camera_angle_y");
        const auto fl_x = number(frame, where, "fl_x"), fl_y = number(frame, where, "fl_y");
        lens.fx = fl_x ? *fl_x : angle_x ? width / 2 / std::tan(*angle_x / 2) : fl_y.value_or(0);
        lens.fy = fl_y ? *fl_y : angle_y ? height / 2 / std::tan(*angle_y / 2) : lens.fx;
        lens.cx = number(frame, where, "cx").value_or(width / 2), lens.cy = number(frame, where, "cy").value_or(height / 2);
        if (!(lens.fx > 0 && lens.fy > 0))
            refuse(where, fmt::format("expected a positive focal length (fl_x, or camera_angle_x), found {}", lens.fx));
        constexpr std::array<const char*, 4> kNames{"k1", "k2", "k3", "k4"};
        for (std::size_t i = 0; i < kNames.size(); ++i)
            if (lens.kind == LensKind::fisheye || i < 3) lens.k[i] = number(frame, where, kNames[i]).value_or(0);
        if (lens.kind == LensKind::perspective) lens.p1 = number(frame, where, "p1").value_or(0), lens.p2 = number(frame, where, "p2").value_or(0);
        return lens;
    }

    // Camera to world with the camera's y up and z back: its second and third columns change their signs.
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
        const Vec3d right = column(0) * (1 / size), up = column(1) * (1 / length(column(1))), back = column(2) * (1 / length(column(2)));
        const Vec3d place = column(3);
        const bool turn = std::fabs(dot(right, up)) < 0.02 && length(cross(right, up) - back) < 0.02 && size > 1e-9;
        if (!(turn && std::isfinite(place.x + place.y + place.z)))
            refuse(where, "expected a rotation and a place in transform_matrix, found another matrix");
        return {matrix_of(quaternion_of(Mat3d::from_columns(right, -up, -back))), place};
    }

    Photo photo(const Json& frame, const std::string& where) const {
        if (!frame.is_object() || !frame.contains("file_path") || !frame.at("file_path").is_string()) refuse(where, "expected file_path, found none");
        Photo out;
        out.name = frame.at("file_path").get<std::string>();
        if (out.name.starts_with("./")) out.name.erase(0, 2);
        if (out.name.empty()) refuse(where, "expected file_path, found an empty one");
        out.file = picture(out.name);
        if (const auto mask = text(frame, "mask_path")) out.mask = dir_ / *mask;
        if (out.mask.empty()) out.mask = mask_for(folders_.masks.empty() ? dir_ / "masks" : folders_.masks, fs::path(out.name).filename().string());
        out.lens = lens(frame, where, out.file);
        out.world_from_camera = pose(frame, where);
        return out;
    }

    fs::path file_, dir_;
    CaptureFolders folders_;
    Json json_;
};

}  // namespace

Capture load_nerfstudio_capture(const fs::path& file, const CaptureFolders& folders) {
    return Transforms(fs::is_directory(file) ? file / "transforms.json" : file, folders).capture();
}

}  // namespace fastscene
