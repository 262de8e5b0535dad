#include <webp/encode.h>

#include <memory>

#include "fastscene/base/error.h"
#include "fastscene/io/webp_lossless.h"

namespace fastscene {

std::string encode_webp_lossless(const RgbaBytes& image) {
    constexpr int kEffort = 4;  // of 0 to 9: 9 is a few percent smaller in ten times the time
    WebPConfig config;
    WebPPicture picture;
    if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, kEffort) || !WebPPictureInit(&picture))
        throw Error("WebP: cannot start the encoder");
    config.exact = 1;  // colors count where alpha is 0, too
    picture.use_argb = 1;
    picture.width = image.width;
    picture.height = image.height;
    const std::unique_ptr<WebPPicture, void (*)(WebPPicture*)> picture_guard(&picture, WebPPictureFree);
    WebPMemoryWriter writer;
    WebPMemoryWriterInit(&writer);
    const std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter*)> writer_guard(&writer, WebPMemoryWriterClear);
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &writer;
    if (!WebPPictureImportRGBA(&picture, image.bytes.data(), image.width * 4) || !WebPEncode(&config, &picture))
        throw Error("WebP: cannot encode {} x {} pixels (error {})", image.width, image.height,
                    static_cast<int>(picture.error_code));
    return {reinterpret_cast<const char*>(writer.mem), writer.size};
}

}  // namespace fastscene
