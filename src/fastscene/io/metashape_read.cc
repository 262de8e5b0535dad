// Metashape's "Export Cameras" as XML. Cameras look along z with y down, as here; a camera's transform leads to its
// component, whose transform (rotation, translation, scale) leads to the world that the exported points are in.
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/capture_parts.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Where a component lies in the world.
struct Component {
    Mat3d rotation;
    Vec3d translation;
    double scale = 1;
};

class Metashape {
  public:
    explicit Metashape(const fs::path& file) : file_(file), text_(read_file(file)) {
        const pugi::xml_parse_result parsed = document_.load_buffer(text_.data(), text_.size());
        if (!parsed) refuse(fmt::format("byte {}: expected XML, found: {}", parsed.offset, parsed.description()));
        chunk_ = document_.select_node("//chunk[cameras]").node();
        if (!chunk_) refuse("expected the cameras of a chunk (File, Export, Export Cameras), found none");
        for (const pugi::xml_node sensor : chunk_.child("sensors").children("sensor")) read_sensor(sensor);
        for (const pugi::xml_node part : chunk_.child("components").children("component"))
            if (part.child("transform")) components_[part.attribute("id").value()] = component(part.child("transform"));
        if (chunk_.child("transform")) whole_ = component(chunk_.child("transform"));
    }

    Capture capture() {
        Capture out;
        out.source = file_.string();
        std::vector<std::string> without;
        for (const pugi::xpath_node& found : chunk_.child("cameras").select_nodes(".//camera"))
            if (!add(found.node(), out)) without.push_back(found.node().attribute("label").value());
        if (!without.empty())
            out.warnings.push_back(
                fmt::format("{}: {} of {} pictures have no pose or no calibrated sensor and are left out, {} first",
                            out.source, without.size(), without.size() + out.photos.size(), without.front()));
        return out;
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const { throw Error("{}: {}", file_.string(), what); }

    std::vector<double> numbers(const pugi::xml_node& node, std::size_t count) const {
        std::istringstream in(node.child_value());
        std::vector<double> out;
        for (std::string word; out.size() <= count && in >> word;) {
            char* end = nullptr;
            out.push_back(std::strtod(word.c_str(), &end));
            if (*end) refuse(fmt::format("<{}>: expected a number, found \"{}\"", node.name(), word));
        }
        if (out.size() != count)
            refuse(fmt::format("<{}>: expected {} numbers, found {}", node.name(), count, out.size()));
        return out;
    }
    double number(const pugi::xml_node& owner, const char* name) const {
        return owner.child(name) ? numbers(owner.child(name), 1)[0] : 0;
    }

    Component component(const pugi::xml_node& transform) const {
        Component out;
        if (const pugi::xml_node r = transform.child("rotation")) {
            const auto m = numbers(r, 9);
            out.rotation = {{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}};
        }
        if (const pugi::xml_node t = transform.child("translation")) {
            const auto v = numbers(t, 3);
            out.translation = {v[0], v[1], v[2]};
        }
        if (transform.child("scale")) out.scale = number(transform, "scale");
        if (!(out.scale > 0)) refuse(fmt::format("<scale>: expected a positive number, found {}", out.scale));
        return out;
    }

    void read_sensor(const pugi::xml_node& sensor) {
        const std::string id = sensor.attribute("id").value(), type = sensor.attribute("type").value();
        const pugi::xml_node size = sensor.child("resolution");
        Lens lens;
        lens.width = size.attribute("width").as_int(), lens.height = size.attribute("height").as_int();
        if (lens.width < 1 || lens.height < 1 || lens.width > 65536 || lens.height > 65536)
            refuse(fmt::format("sensor {}: expected a picture size, found {} x {}", id, lens.width, lens.height));
        if (type == "spherical") lens.kind = LensKind::equirectangular;
        else if (type == "fisheye" || type == "equidistant_fisheye") lens.kind = LensKind::fisheye;
        else if (type != "frame")
            refuse(fmt::format("sensor {}: expected a frame, fisheye or spherical camera, found {}", id, type));
        pugi::xml_node c = sensor.find_child_by_attribute("calibration", "class", "adjusted");
        if (!c) c = sensor.child("calibration");
        if (lens.kind != LensKind::equirectangular) {
            if (!c) return;  // not calibrated: its cameras are left out
            read_calibration(id, c, lens);
        }
        sensors_[id] = lens;
    }
    // x' = x (1 + k1 r^2 + …) + p1 (r^2 + 2 x^2) + 2 p2 x y: Metashape's p1 is OpenCV's p2.
    void read_calibration(const std::string& id, const pugi::xml_node& c, Lens& lens) const {
        const double f = c.child("f") ? number(c, "f") : number(c, "fx");
        lens.fx = f + number(c, "b1"), lens.fy = c.child("fy") ? number(c, "fy") : f;
        lens.cx = lens.width / 2.0 + number(c, "cx"), lens.cy = lens.height / 2.0 + number(c, "cy");
        constexpr std::array<const char*, 4> kRadial{"k1", "k2", "k3", "k4"};
        for (std::size_t i = 0; i < kRadial.size(); ++i)
            if (const double k = number(c, kRadial[i]); i < 3 || lens.kind == LensKind::fisheye) lens.k[i] = k;
            else if (k != 0)
                refuse(fmt::format("sensor {}: expected a k4 of 0, found {}: optimize the cameras without k4", id, k));
        lens.p1 = number(c, "p2"), lens.p2 = number(c, "p1");
        if (!(lens.fx > 0 && lens.fy > 0 && std::isfinite(lens.fx + lens.fy + lens.cx + lens.cy)))
            refuse(fmt::format("sensor {}: expected a positive focal length, found {}", id, f));
        constexpr double kMostSkew_px = 1;
        if (const double skew = number(c, "b2"); std::fabs(skew) * lens.height / 2 / lens.fy > kMostSkew_px)
            refuse(fmt::format("sensor {}: expected a skew b2 of almost 0, found {}: optimize without b2", id, skew));
    }

    bool add(const pugi::xml_node& camera, Capture& out) const {
        const auto sensor = sensors_.find(camera.attribute("sensor_id").value());
        const pugi::xml_node transform = camera.child("transform");
        if (sensor == sensors_.end() || !transform) return false;
        const auto m = numbers(transform, 16);
        for (const double v : m)
            if (!std::isfinite(v)) return false;
        const auto part = components_.find(camera.attribute("component_id").value());
        const Component& to = part == components_.end() ? whole_ : part->second;
        const Mat3d turn = to.rotation * Mat3d{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}};
        const Vec3d at = (to.rotation * Vec3d{m[3], m[7], m[11]}) * to.scale + to.translation;
        out.photos.push_back(
            {camera.attribute("label").value(), {}, {}, sensor->second, {matrix_of(quaternion_of(turn)), at}});
        return true;
    }

    fs::path file_;
    std::string text_;
    pugi::xml_document document_;
    pugi::xml_node chunk_;
    std::map<std::string, Lens> sensors_;
    std::map<std::string, Component> components_;
    Component whole_;
};

}  // namespace

Capture load_metashape_capture(const fs::path& file, const CaptureFolders& folders) {
    Capture capture = Metashape(file).capture();
    name_labelled_files(capture, folders, file.parent_path());
    finish_capture(capture, folders);
    return capture;
}

}  // namespace fastscene
