// Inputs to begin with, in the formats that we write: fuzz_seeds FOLDER makes FOLDER/READER/…. Texts and weights come
// from fuzz/seeds/ and tests/data (fuzz/run).
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "fastscene/base/bytes.h"
#include "fastscene/base/file.h"
#include "fastscene/io/camera_path_io.h"
#include "fastscene/io/glb_container.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/npy.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/test_splats.h"
#include "fastscene/io/view_io.h"

using namespace fastscene;
namespace fs = std::filesystem;

namespace {

ImageRgb8 picture(int width, int height) {
    ImageRgb8 out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            out.at(x, y) = {static_cast<std::uint8_t>(9 * x), static_cast<std::uint8_t>(17 * y), 90};
    return out;
}

void write_splats(const fs::path& to) {
    for (const auto& [reader, ending] : {std::pair{"ply", ".ply"}, {"compressed_ply", ".compressed.ply"},
                                         {"splat", ".splat"}, {"ksplat", ".ksplat"}, {"spz", ".spz"}, {"sog", ".sog"},
                                         {"glb", ".glb"}, {"usda", ".usda"}})
        for (const int degree : {0, 2}) {
            const fs::path file = to / reader / ("degree" + std::to_string(degree) + ending);
            make_directories(file.parent_path());
            try {
                save_splats(file, some_splats(5, degree));
            } catch (const std::exception& e) {
                std::fprintf(stderr, "%s: %s\n", file.c_str(), e.what());  // read, not written
            }
        }
}

void write_pictures(const fs::path& to) {
    make_directories(to / "picture"), make_directories(to / "map");
    for (const auto& [width, height] : {std::pair{1, 1}, {5, 3}, {16, 8}}) {
        const std::string size = std::to_string(width);
        save_png(to / "picture" / (size + ".png"), picture(width, height));
        save_png(to / "picture" / (size + "-gray.png"), ImageMask(width, height, 7));
        save_jpeg(to / "picture" / (size + ".jpg"), picture(width, height));
        save_exr(to / "map" / (size + ".exr"), ImageF(width, height, 1.5f));
        save_pfm(to / "map" / (size + ".pfm"), ImageF(width, height, 1.5f));
        save_png16(to / "map" / (size + ".png"), Image<std::uint16_t>(width, height, 1500));
    }
}

// The files of a model as one input (readers.cc).
void join(const fs::path& from, const std::vector<std::string>& names, const fs::path& to) {
    std::string all;
    for (const std::string& name : names)
        if (fs::exists(from / name)) all += (all.empty() ? "=== " : "\n=== ") + name + "\n" + read_file(from / name);
    make_directories(to.parent_path());
    if (!all.empty()) write_file(to, all);
}

void write_models(const fs::path& to) {
    ViewSet set;
    for (int i = 0; i < 2; ++i) {
        View view;
        view.name = std::to_string(i) + ".png";
        view.color = picture(8, 6);
        view.camera = Pinhole::with_fov(8, 6, 60);
        set.views.push_back(view);
    }
    set.points.push_back({});
    const fs::path model = to / "model";
    save_views(model, set);
    const fs::path sparse = model / "sparse/0";
    join(sparse, {"cameras.bin", "images.bin", "points3D.bin", "frames.bin", "rigs.bin"}, to / "colmap_binary/model");
    join(sparse, {"cameras.txt", "images.txt", "points3D.txt", "frames.txt", "rigs.txt"}, to / "colmap_text/model");
    make_directories(to / "nerfstudio");
    fs::copy_file(model / "transforms.json", to / "nerfstudio/transforms.json", fs::copy_options::overwrite_existing);
    fs::remove_all(model);
}

void write_paths(const fs::path& to) {
    CameraPath path;
    for (int i = 0; i < 3; ++i) {
        CameraKey key;
        key.time_s = static_cast<float>(i), key.yaw_deg = 20.f * static_cast<float>(i);
        path.keys.push_back(key);
    }
    path.width = 64, path.height = 48, path.fps = 4;
    make_directories(to / "path_json"), make_directories(to / "path_chan");
    save_camera_path(to / "path_json/ours.json", path, PathFormat::fastscene);
    save_camera_path(to / "path_json/nerfstudio.json", path, PathFormat::nerfstudio);
    save_camera_path(to / "path_json/supersplat.json", path, PathFormat::supersplat);
    save_camera_path(to / "path_chan/blender.chan", path, PathFormat::blender);
}

// A triangle with a texture, normals left to the reader, in a node with a transform.
void write_gltf(const fs::path& to) {
    make_directories(to);
    save_png(to / "picture.png", picture(4, 4));
    std::string data;
    for (const float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f}) append(data, v);
    for (const std::uint16_t i : {0, 1, 2, 0}) append(data, i);
    const std::string png = read_file(to / "picture.png");
    fs::remove(to / "picture.png");
    Json json = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"children": [1], "rotation": [0, 0, 0, 1], "scale": [1, -2, 1]}, {"mesh": 0, "translation": [1, 2, 3]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
"materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "roughnessFactor": 0.5},
"alphaMode": "MASK"}],
"textures": [{"source": 0}], "images": [{"bufferView": 3, "mimeType": "image/png"}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
{"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24},
{"buffer": 0, "byteOffset": 60, "byteLength": 8}, {"buffer": 0, "byteOffset": 68}]})");
    json["bufferViews"][3]["byteLength"] = png.size();
    data += png;
    json["buffers"] = {{{"byteLength", data.size()}}};
    write_file(to / "triangle.glb", glb_bytes(json, data));
    json["buffers"][0]["uri"] = "model.bin";
    write_file(to / "triangle", "=== model.gltf\n" + json.dump() + "\n=== model.bin\n" + data);
}

}  // namespace

int main(int count, char** arguments) try {
    if (count != 2) return std::fputs("fuzz_seeds FOLDER\n", stderr), 2;
    const fs::path to = arguments[1];
    write_splats(to);
    write_pictures(to);
    write_models(to);
    write_paths(to);
    write_gltf(to / "gltf");
    make_directories(to / "npy");
    write_file(to / "npy/labels.npy", npy_bytes(std::vector<std::uint16_t>{1, 2, 3}));
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "fuzz_seeds: %s\n", e.what());
    return 1;
}
