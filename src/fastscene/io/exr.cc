#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include "fastscene/base/file.h"
#include "fastscene/io/formats.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Y (luminance), Z (depth), R, or whatever comes first.
std::string range_channel(const Imf::ChannelList& channels) {
    for (const char* name : {"Y", "Z", "R"})
        if (channels.findChannel(name)) return name;
    return channels.begin() == channels.end() ? "" : channels.begin().name();
}

[[noreturn]] void refuse(const fs::path& path, const std::exception& e) {
    throw Error("{}: expected an OpenEXR picture, found: {}", path.string(), e.what());
}

}  // namespace

PictureInfo exr_info(const fs::path& path) {
    try {
        const Imf::InputFile file(path.c_str());
        const Imath::Box2i box = file.header().dataWindow();
        // A broken window may span more than an int.
        const auto side = [](int low, int high) { return static_cast<int>(std::min<std::int64_t>(std::int64_t{high} - low + 1, 0x7fffffff)); };
        return {side(box.min.x, box.max.x), side(box.min.y, box.max.y)};
    } catch (const std::exception& e) {
        refuse(path, e);
    }
}

ImageF load_exr(const fs::path& path) {
    const PictureInfo info = exr_info(path);
    if (!plausible_size(info.width, info.height))
        throw Error("{}: expected a picture of at most {} pixels a side, found {} x {}", path.string(), kMaxPictureSide, info.width, info.height);
    try {
        Imf::InputFile file(path.c_str());
        const std::string channel = range_channel(file.header().channels());
        if (channel.empty()) throw Error("{}: expected a channel of floats, found none", path.string());
        const Imath::Box2i box = file.header().dataWindow();
        ImageF image(info.width, info.height);
        Imf::FrameBuffer frame;
        frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, image.pixels.data(), box));
        file.setFrameBuffer(frame);
        file.readPixels(box.min.y, box.max.y);
        return image;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        refuse(path, e);
    }
}

void save_exr(const fs::path& path, const ImageF& image) {
    write_renamed(path, [&](const fs::path& temporary) {
        try {
            Imf::Header header(image.width, image.height);
            header.compression() = Imf::ZIP_COMPRESSION;
            header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
            Imf::OutputFile file(temporary.c_str(), header);
            Imf::FrameBuffer frame;
            frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, image.pixels.data(), header.dataWindow()));
            file.setFrameBuffer(frame);
            file.writePixels(image.height);
        } catch (const std::exception& e) {
            throw Error("{}: cannot be written: {}", path.string(), e.what());
        }
    });
}

}  // namespace fastscene
