// One program for all readers: fuzz_readers --reader=NAME [libFuzzer's flags] CORPUS. Each input is what the reader
// gets as a file. Errors that the reader throws are its duty; crashes, sanitizer reports, broken checks (CheckFailed),
// other exceptions and memory beyond what the input justifies are findings.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "fastscene/base/check.h"
#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/camera_path_io.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/exif.h"
#include "fastscene/io/gltf_model.h"
#include "fastscene/io/gpano.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/mat_file.h"
#include "fastscene/io/npy.h"
#include "fastscene/io/obj.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/svr_file.h"
#include "fastscene/io/toml_table.h"
#include "fastscene/weights/mapped_file.h"
#include "fastscene/weights/weights.h"
#include "fastscene/rooms/document.h"
#include "fastscene/rooms/rooms.h"

namespace {

using namespace fastscene;
namespace fs = std::filesystem;

// In memory; one per process.
const fs::path& scratch() {
    static const fs::path folder = [] {
        const fs::path path = fs::path("/dev/shm") / ("fastscene-fuzz-" + std::to_string(::getpid()));
        fs::create_directories(path);
        std::atexit([] { fs::remove_all(fs::path("/dev/shm") / ("fastscene-fuzz-" + std::to_string(::getpid()))); });
        return path;
    }();
    return folder;
}

void put(const fs::path& path, std::string_view bytes) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) std::abort();
    if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) std::abort();
    std::fclose(file);
}

fs::path as_file(std::string_view bytes, const std::string& name) {
    put(scratch() / name, bytes);
    return scratch() / name;
}

// Several files in one input: each begins with a line "=== NAME". Only these names are made.
fs::path as_folder(std::string_view bytes, const std::vector<std::string>& names) {
    const fs::path folder = scratch() / "folder";
    fs::remove_all(folder);
    for (const std::string& name : names) fs::create_directories((folder / name).parent_path());
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t next = std::min(bytes.find("\n=== ", at), bytes.size());
        std::string_view part = bytes.substr(at, next - at);
        if (part.starts_with("=== ")) {
            const std::size_t line = std::min(part.find('\n'), part.size());
            const std::string name(part.substr(4, line - 4));
            for (const std::string& known : names)
                if (name == known) put(folder / name, part.substr(std::min(line + 1, part.size())));
        }
        at = next + 1;
    }
    return folder;
}

using Read = std::function<void(std::string_view bytes)>;

Read splats(const char* ending) {
    return [ending](std::string_view b) { load_splats(as_file(b, std::string("splats") + ending)); };
}
Read path(const char* ending) {
    return [ending](std::string_view b) { load_camera_path(as_file(b, std::string("path") + ending)); };
}

void read_picture(std::string_view b) {
    (void)exif_orientation(b);
    (void)gpano_of(b);
    const PictureInfo info = picture_info(b, "picture");
    constexpr int kLarge = 4096;  // whoever opens pictures refuses larger ones by their header
    if (info.width > kLarge || info.height > kLarge) return;
    if (info.light) decode_light(b, "picture");
    else decode_rgb8(b, "picture"), decode_alpha(b, "picture"), decode_color_and_alpha(b, "picture");
}

void read_gltf_model(std::string_view b) {
    const fs::path folder = as_folder(b, {"model.gltf", "model.bin", "picture.png"});
    const bool is_folder = fs::exists(folder / "model.gltf");
    const GltfLimits limits{100'000, 1024, std::size_t{1} << 22};
    (void)read_gltf_bytes(
        is_folder ? read_file(folder / "model.gltf") : std::string(b), "model.gltf",
        [&](const std::string& name) -> std::optional<std::string> {
            const bool is_ours = name == "model.bin" || name == "picture.png";
            if (!is_ours || !fs::exists(folder / name)) return {};
            return read_file(folder / name);
        },
        limits);
}

void read_room(std::string_view b) { (void)read_document(b, "room.json"); }
void read_prompt(std::string_view b) { (void)understand_prompt(std::string(b), false); }
void make_of_prompt(std::string_view b) {
    PromptSpec spec = understand_prompt(std::string(b), false);
    (void)make_room(spec, {});
}

const std::map<std::string, Read>& readers() {
    static const std::map<std::string, Read> all{
        {"ply", splats(".ply")},
        {"compressed_ply", splats(".compressed.ply")},
        {"splat", splats(".splat")},
        {"ksplat", splats(".ksplat")},
        {"spz", splats(".spz")},
        {"sog", splats(".sog")},
        {"glb", splats(".glb")},
        {"usda", splats(".usda")},
        {"picture", read_picture},
        {"map", [](std::string_view b) { load_float(as_file(b, "map.exr")); }},
        {"colmap_binary",
         [](std::string_view b) {
             load_colmap_model(as_folder(b, {"cameras.bin", "images.bin", "points3D.bin", "frames.bin", "rigs.bin"}));
         }},
        {"colmap_text",
         [](std::string_view b) {
             load_colmap_model(as_folder(b, {"cameras.txt", "images.txt", "points3D.txt", "frames.txt", "rigs.txt"}));
         }},
        {"nerfstudio", [](std::string_view b) { load_nerfstudio_capture(as_file(b, "transforms.json"), {}); }},
        {"metashape", [](std::string_view b) { load_metashape_capture(as_file(b, "cameras.xml"), {}); }},
        {"realityscan", [](std::string_view b) { load_realityscan_capture(as_file(b, "cameras.csv"), {}); }},
        {"polycam",
         [](std::string_view b) {
             load_polycam_capture(as_folder(b, {"keyframes/corrected_cameras/1.json", "keyframes/cameras/1.json",
                                                "mesh_info.json", "keyframes/images/1.jpg"}),
                                  {});
         }},
        {"cameras_json", [](std::string_view b) { load_cameras_json(as_file(b, "cameras.json")); }},
        {"path_json", path(".json")},
        {"path_chan", path(".chan")},
        {"obj",
         [](std::string_view b) {
             const fs::path folder = as_folder(b, {"model.obj", "model.mtl"});
             parse_obj(fs::exists(folder / "model.obj") ? read_file(folder / "model.obj") : std::string(b), "model.obj",
                       [&](const std::string& name) -> std::optional<std::string> {
                           if (name != "model.mtl" || !fs::exists(folder / name)) return {};
                           return read_file(folder / name);
                       });
         }},
        {"gltf", read_gltf_model},
        {"room", read_room},
        {"prompt", read_prompt},
        {"prompt_room", make_of_prompt},
        {"toml", [](std::string_view b) { parse_toml(b, "suite.toml"); }},
        {"weights", [](std::string_view b) { load_weights(as_file(b, "weights.bin")); }},
        {"npy", [](std::string_view b) { load_npy(as_file(b, "labels.npy")); }},
        {"mat", [](std::string_view b) { load_mat_file(as_file(b, "model.mat")); }},
        {"svr", [](std::string_view b) { load_libsvm_model(as_file(b, "model.txt")); }},
        {"svr_opencv", [](std::string_view b) { load_opencv_svr(as_file(b, "model.yml")); }},
    };
    return all;
}

const Read* reader = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    for (int i = 1; i < *count; ++i) {
        const std::string_view argument = (*arguments)[i];
        if (argument == "--list") {
            for (const auto& [name, read] : readers()) std::puts(name.c_str());
            std::exit(0);
        }
        if (argument.starts_with("--reader=")) {
            const auto found = readers().find(std::string(argument.substr(9)));
            if (found != readers().end()) reader = &found->second;
        }
    }
    if (!reader) {
        std::fputs("fuzz_readers: expected --reader=NAME; --list names them\n", stderr);
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        (*reader)({reinterpret_cast<const char*>(data), size});
    } catch (const CheckFailed&) {
        throw;
    } catch (const Error&) {
        // what a reader has to say of bad input
    }
    return 0;
}
