#include <cstdio>
// libjpeg's header requires FILE and size_t to be declared.
#include <jpeglib.h>

#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/io/formats.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct Manager {
    jpeg_error_mgr base;
    std::jmp_buf jump;
    char message[JMSG_LENGTH_MAX];
};
void on_error(j_common_ptr info) {
    auto* manager = reinterpret_cast<Manager*>(info->err);
    manager->base.format_message(info, manager->message);
    std::longjmp(manager->jump, 1);
}
// libjpeg only warns about truncated files and fills them with gray; we treat them as errors.
void on_message(j_common_ptr info, int level) {
    if (level < 0) on_error(info);
}

jpeg_error_mgr* prepare(Manager& manager) {
    jpeg_std_error(&manager.base);
    manager.base.error_exit = on_error;
    manager.base.emit_message = on_message;
    manager.message[0] = 0;
    return &manager.base;
}

bool decode(std::string_view bytes, bool header_only, int& width, int& height, std::vector<JSAMPLE>& pixels,
            std::string& message) {
    Manager manager;
    jpeg_decompress_struct info;
    std::memset(&info, 0, sizeof info);
    info.err = prepare(manager);
    if (setjmp(manager.jump)) {
        jpeg_destroy_decompress(&info);
        message = manager.message;
        return false;
    }
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_read_header(&info, TRUE);
    width = static_cast<int>(info.image_width);
    height = static_cast<int>(info.image_height);
    if (!header_only && !plausible_size(width, height)) {
        jpeg_destroy_decompress(&info);
        message = fmt::format("{} x {} pixels", width, height);
        return false;
    }
    if (!header_only) {
        const bool ink = info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
        info.out_color_space = ink ? JCS_CMYK : JCS_RGB;
        jpeg_start_decompress(&info);
        const std::size_t channels = ink ? 4 : 3, stride = static_cast<std::size_t>(width) * channels;
        pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3 + stride);
        while (info.output_scanline < info.output_height) {
            JSAMPLE* row = pixels.data() +
                           static_cast<std::size_t>(info.output_scanline) * static_cast<std::size_t>(width) * 3;
            jpeg_read_scanlines(&info, &row, 1);
            // Adobe writes inverted CMYK: color = ink * key / 255.
            if (ink)
                for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x)
                    for (std::size_t c = 0; c < 3; ++c)
                        row[3 * x + c] = static_cast<JSAMPLE>(row[4 * x + c] * row[4 * x + 3] / 255);
        }
        jpeg_finish_decompress(&info);
    }
    jpeg_destroy_decompress(&info);
    return true;
}

bool encode(const ImageRgb8& image, int quality, std::string& out, std::string& message) {
    Manager manager;
    jpeg_compress_struct info;
    std::memset(&info, 0, sizeof info);
    unsigned char* volatile buffer = nullptr;
    unsigned long size = 0;
    unsigned char* memory = nullptr;
    info.err = prepare(manager);
    if (setjmp(manager.jump)) {
        jpeg_destroy_compress(&info);
        std::free(buffer);
        message = manager.message;
        return false;
    }
    jpeg_create_compress(&info);
    jpeg_mem_dest(&info, &memory, &size);
    info.image_width = static_cast<JDIMENSION>(image.width);
    info.image_height = static_cast<JDIMENSION>(image.height);
    info.input_components = 3;
    info.in_color_space = JCS_RGB;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, quality, TRUE);
    // No chroma subsampling: red on gray stays sharp.
    info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = 1;
    jpeg_start_compress(&info, TRUE);
    while (info.next_scanline < info.image_height) {
        auto* row = const_cast<JSAMPLE*>(
            reinterpret_cast<const JSAMPLE*>(image.row(static_cast<int>(info.next_scanline))));
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    buffer = memory;
    out.assign(reinterpret_cast<const char*>(memory), size);
    jpeg_destroy_compress(&info);
    std::free(memory);
    return true;
}

}  // namespace

PictureInfo jpeg_info(const fs::path& path, std::string_view bytes) {
    PictureInfo info;
    std::vector<JSAMPLE> none;
    std::string message;
    if (!decode(bytes, true, info.width, info.height, none, message))
        throw Error("{}: expected a JPEG header, found: {}", path.string(), message);
    return info;
}

ImageRgb8 decode_jpeg(std::string_view bytes, const std::string& where) {
    int width = 0, height = 0;
    std::vector<JSAMPLE> pixels;
    std::string message;
    if (!decode(bytes, false, width, height, pixels, message))
        throw Error("{}: expected a whole JPEG picture, found: {}", where, message);
    ImageRgb8 image(width, height);
    std::memcpy(image.pixels.data(), pixels.data(), image.size() * 3);
    return image;
}

std::string encode_jpeg(const ImageRgb8& image, int quality) {
    std::string bytes, message;
    if (!encode(image, quality, bytes, message))
        throw Error("a picture of {} x {} cannot be written as JPEG: {}", image.width, image.height, message);
    return bytes;
}

void save_jpeg(const fs::path& path, const ImageRgb8& image, int quality) {
    std::string bytes, message;
    if (!encode(image, quality, bytes, message))
        throw Error("{}: cannot be written as JPEG: {}", path.string(), message);
    write_file(path, bytes);
}

}  // namespace fastscene
