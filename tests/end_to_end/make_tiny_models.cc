// make_tiny_models DIR: DIR/weights as the official folder lies, of small random networks; DIR/side.jpg, a photo that
// lies on its side as EXIF says, and DIR/upright.png, the same pixels as they are meant to be seen.
#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/image/orientation.h"
#include "fastscene/io/image_io.h"
#include "fastscene/nn/tiny_model.h"

using namespace fastscene;
namespace fs = std::filesystem;

namespace {

void write_weights(const fs::path& folder) {
    write_tiny_model(folder / "sd-base");
    write_tiny_model(folder / "sr-base", {.salt = "painter"});
    write_tiny_control(folder / "sd-i2p", 4);
    write_tiny_control(folder / "sr-control", 3);
    write_tiny_enlarger(folder / "RealESRGAN_x2plus.pth");
}

void write_photos(const fs::path& folder) {
    constexpr int orientation = 6;  // the stored top is the right side
    ImageRgb8 stored(48, 64);
    for (int y = 0; y < stored.height; ++y)
        for (int x = 0; x < stored.width; ++x)
            stored.at(x, y) = {static_cast<std::uint8_t>(5 * x), static_cast<std::uint8_t>(3 * y), 90};
    const std::string jpeg = encode_jpeg(stored);
    const std::string exif(
        "\xff\xe1\x00\x22"
        "Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
        36);
    write_file(folder / "side.jpg", jpeg.substr(0, 2) + exif + jpeg.substr(2));
    save_png(folder / "upright.png", upright(decode_rgb8(jpeg, "side.jpg"), orientation));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) throw Error("expected a folder, found {} arguments", argc - 1);
    make_directories(argv[1]);
    write_weights(fs::path(argv[1]) / "weights");
    write_photos(argv[1]);
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
}
