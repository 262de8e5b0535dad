#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "bind.h"
#include "calls.h"
#include "fastscene/base/file.h"
#include "fastscene/export/room_glb.h"
#include "fastscene/image/color.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/edit.h"
#include "fastscene/scene/walkable_json.h"
#include "fastscene/trace/standable.h"
#include "fastscene/trace/trace.h"
#include "fastscene/walk/walkable_walk.h"
#include "settings.h"

namespace fastscene::python {
namespace {

constexpr const char* kDocument = "document";  // stands for its file in messages

Vec3f point_from(std::array<float, 3> p) { return {p[0], p[1], p[2]}; }

py::object plan(const std::string& prompt, std::uint64_t seed) {
    return python_of(long_call(seed, py::none(), [&](const Run& run, Caller&) {
        PromptSpec spec = read_prompt(prompt, {});
        return document_json(plan_document(spec, run));
    }));
}

py::tuple edit(const py::object& document, const std::string& sentence) {
    const std::string text = json_text(document);
    const EditResult result = long_call(0, py::none(), [&](const Run& run, Caller&) {
        return edit_by_sentence(read_document(text, kDocument), sentence, furniture_pack({}), run);
    });
    py::list changes;
    for (const EditChange& change : result.changes) changes.append(py::make_tuple(change.id, change.what));
    return py::make_tuple(python_of(document_json(result.document)), changes);
}

// A sentence or a document.
RoomOrigin origin_from(const py::object& room) {
    if (py::isinstance<py::str>(room)) return {room.cast<std::string>(), {}};
    return {{}, json_text(room)};
}

std::shared_ptr<TracedRoom> traced(const py::object& room, std::uint64_t seed, py::object on_progress,
                                   const py::kwargs& given) {
    PanoramaParams params;
    Settings settings(given);
    settings.take(params.trace);
    settings.finish();
    check_fields("", params.trace);
    const RoomOrigin origin = origin_from(room);
    return long_call(seed, std::move(on_progress),
                     [&](const Run& run, Caller&) { return make_traced_room(origin, params, run); });
}

py::list objects_of(const TracedRoom& room) {
    py::list out;
    for (const RoomObject& object : room.room().objects) {
        py::dict entry;
        entry["id"] = object.id, entry["kind"] = object.kind, entry["name"] = object.name,
        entry["color"] = object.color;
        entry["size_m"] = std::vector<float>{object.size_m.x, object.size_m.y, object.size_m.z};
        entry["world_from_object"] = matrix_of_pose(object.world_from_object);
        entry["requested"] = object.requested;
        out.append(entry);
    }
    return out;
}

Panorama panorama_of(const TracedRoom& room, int width, const py::object& pose, int samples, std::uint64_t seed,
                     py::object on_progress) {
    if (width < 16 || width > 16384 || width % 2 != 0)
        throw UsageError("width: expected an even number from 16 to 16384, found {}", width);
    const Rigid at = pose_from(pose, "world_from_pano");
    return long_call(seed, std::move(on_progress), [&](const Run& run, Caller&) {
        Shot shot = room.panorama(at, {width, width / 2}, final_parts(samples), run);
        return Panorama{std::move(shot.color), std::move(shot.range), {}, at};
    });
}

Shot perspective_of(const TracedRoom& room, const Pinhole& camera, const py::object& pose, int samples,
                    std::uint64_t seed, py::object on_progress) {
    const Rigid at = pose_from(pose);
    return long_call(seed, std::move(on_progress), [&](const Run& run, Caller&) {
        ShotParts parts = final_parts(samples);
        parts.normal = parts.object = true;
        return room.perspective(at, camera, parts, run);
    });
}

void bind_pictures_of_rooms(py::module_& m) {
    py::class_<Panorama>(m, "Panorama", "The full 360 degree view from a place: equirectangular.")
        .def(py::init([](const py::array& color, const py::array& range, const py::object& pose) {
                 return Panorama{
                     color_from(color, "color"), floats_from(range, "range"), {}, pose_from(pose, "world_from_pano")};
             }),
             py::arg("color"), py::arg("range"), py::arg("world_from_pano") = py::none())
        .def_property_readonly(
            "color", [](py::object self) { return shown(self.cast<Panorama&>().color, self); },
            "Height x width x 3, linear.")
        .def_property_readonly(
            "range", [](py::object self) { return shown(self.cast<Panorama&>().range, self); },
            "Metres along each pixel's ray; inf: the sky.")
        .def_property_readonly("world_from_pano", [](const Panorama& p) { return matrix_of_pose(p.world_from_pano); })
        .def(
            "rgb8", [](const Panorama& p) { return array_of(srgb8_from_linear(p.color)); }, "As sRGB of uint8.");
    py::class_<Shot>(m, "Shot", "A traced picture and what it shows, per pixel.")
        .def_property_readonly("color", [](py::object self) { return shown(self.cast<Shot&>().color, self); })
        .def_property_readonly(
            "range", [](py::object self) { return shown(self.cast<Shot&>().range, self); },
            "Metres along the ray; inf: outside.")
        .def_property_readonly(
            "normal", [](py::object self) { return shown(self.cast<Shot&>().normal, self); }, "World frame.")
        .def_property_readonly(
            "object", [](py::object self) { return shown(self.cast<Shot&>().object, self); },
            "Index into TracedRoom.objects; -1: walls, floor, ceiling; -2: outside.")
        .def(
            "rgb8", [](const Shot& s) { return array_of(srgb8_from_linear(s.color)); }, "As sRGB of uint8.");
}

void bind_traced_room(py::module_& m) {
    py::class_<TracedRoom, std::shared_ptr<TracedRoom>>(m, "TracedRoom")
        .def("panorama", &panorama_of, py::arg("width") = 1024, py::arg("world_from_pano") = py::none(),
             py::arg("samples") = 32, py::arg("seed") = 0, py::arg("on_progress") = py::none(),
             "The room all around; samples: maximum rays per pixel.")
        .def("perspective", &perspective_of, py::arg("camera"), py::arg("world_from_camera") = py::none(),
             py::arg("samples") = 32, py::arg("seed") = 0, py::arg("on_progress") = py::none())
        .def_property_readonly("objects", &objects_of, "Everything in the room.")
        .def(
            "distance",
            [](const TracedRoom& room, std::array<float, 3> from, std::array<float, 3> direction) {
                return room.distance(point_from(from), normalize(point_from(direction)));
            },
            py::arg("origin"), py::arg("direction"), "Metres to the first surface along a ray; inf: none.")
        .def(
            "clearance",
            [](const TracedRoom& room, std::array<float, 3> point, float limit) {
                return room.clearance(point_from(point), limit);
            },
            py::arg("point"), py::arg("limit_m") = 1.f, "Radius of the largest empty ball around a point.")
        .def(
            "walkable",
            [](const TracedRoom& room) { return python_of(walkable_json(walkable_room(passable_floor(room)))); },
            "Where a person can walk: polygon_m, rings_m, eye_heights_m, floor_y_m; levels of a floor with tiers.")
        .def(
            "save_glb",
            [](const TracedRoom& room, const std::filesystem::path& path) {
                long_call(0, py::none(), [&](const Run& run, Caller&) {
                    write_file(path, room_glb_bytes(room.room(), {}, run));
                    return true;
                });
            },
            py::arg("path"), "The room for engines and modellers.");
}

}  // namespace

void bind_rooms(py::module_& m) {
    bind_pictures_of_rooms(m);
    m.def(
        "understand_prompt",
        [](const std::string& text, bool strict) {
            PanoramaParams params;
            params.strict = strict;
            return python_of(to_json(read_prompt(text, params)));
        },
        py::arg("text"), py::arg("strict") = false,
        "What became of every word of a sentence: understood, approximated, not_understood.");
    m.def("plan_document", &plan, py::arg("prompt"), py::arg("seed") = 0,
          "The furnished room that a sentence asks for, as a document.");
    m.def("edit_by_sentence", &edit, py::arg("document"), py::arg("sentence"),
          "Changes a document in words; returns the new one and a list of (id, what changed).");
    m.def("make_traced_room", &traced, py::arg("room"), py::arg("seed") = 0, py::arg("on_progress") = py::none(),
          "The room of a sentence or a document, with its light: ready to be rendered. Settings: those of --panorama "
          "that concern light, as cell, cell_samples, outside_detail.");
    bind_traced_room(m);
}

}  // namespace fastscene::python
