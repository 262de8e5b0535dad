#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include <string>
#include <vector>

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

namespace {

// One channel after the other into floats; `stride` of them a pixel.
void read_channels(const fs::path& path, const std::vector<std::string>& wanted, float* pixels, std::size_t stride) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i box = file.header().dataWindow();
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        frame.insert(wanted[i], Imf::Slice::Make(Imf::FLOAT, pixels + i, box, stride * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(box.min.y, box.max.y);
}

PictureInfo checked_info(const fs::path& path) {
    const PictureInfo info = exr_info(path);
    if (!plausible_size(info.width, info.height))
        throw Error("{}: expected a picture of at most {} pixels a side, found {} x {}", path.string(), kMaxPictureSide, info.width, info.height);
    return info;
}

std::string single_channel(const fs::path& path) {
    const std::string channel = range_channel(Imf::InputFile(path.c_str()).header().channels());
    if (channel.empty()) throw Error("{}: expected a channel of floats, found none", path.string());
    return channel;
}

}  // namespace

ImageF load_exr(const fs::path& path) {
    const PictureInfo info = checked_info(path);
    try {
        ImageF image(info.width, info.height);
        read_channels(path, {single_channel(path)}, image.pixels.data(), 1);
        return image;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        refuse(path, e);
    }
}

ImageColor load_exr_color(const fs::path& path) {
    const PictureInfo info = checked_info(path);
    try {
        bool colored = true;
        {
            const Imf::InputFile file(path.c_str());
            for (const char* name : {"R", "G", "B"}) colored = colored && file.header().channels().findChannel(name);
        }
        ImageColor image(info.width, info.height);
        static_assert(sizeof(Vec3f) == 3 * sizeof(float));
        read_channels(path, colored ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{single_channel(path)},
                      &image.pixels.data()->x, 3);
        if (!colored)
            for (Vec3f& c : image.pixels) c = {c.x, c.x, c.x};
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
