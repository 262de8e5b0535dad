#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/io/color_maps.h"
#include "fastscene/io/formats.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_of(const Imf::ChannelList& channels) {
    std::vector<std::string> names;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) names.emplace_back(channel.name());
    return names;
}
std::string last_part(const std::string& name) { return name.substr(name.rfind('.') + 1); }

// Renderers store layers in one file: "ViewLayer.Combined.R", "ViewLayer.Depth.Z". Range is taken from Z, a channel
// called depth, Y (luminance), R, or the only channel.
std::string range_channel(const std::vector<std::string>& names) {
    const auto first = [&](auto is) {
        const auto found = std::find_if(names.begin(), names.end(), is);
        return found == names.end() ? std::string() : *found;
    };
    const auto called_depth = [](std::string name) {
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return name.find("depth") != std::string::npos || name.find("range") != std::string::npos ||
               name.find("distance") != std::string::npos;
    };
    std::string found = first([](const std::string& n) { return n == "Z"; });
    if (found.empty()) found = first(called_depth);
    for (const char* name : {"Y", "R"})
        if (found.empty()) found = first([&](const std::string& n) { return n == name; });
    for (const char* name : {"Z", "Y", "R"})
        if (found.empty()) found = first([&](const std::string& n) { return last_part(n) == name; });
    return found.empty() && names.size() == 1 ? names[0] : found;
}

// The layer that contains R, G and B: "" or "ViewLayer.Combined.".
std::optional<std::string> color_layer(const std::vector<std::string>& names) {
    const auto has = [&](const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::vector<std::string> layers{""};
    for (const std::string& name : names)
        if (name.size() > 2 && name.ends_with(".R")) layers.push_back(name.substr(0, name.size() - 1));
    std::stable_partition(layers.begin(), layers.end(),
                          [](const std::string& layer) { return layer.empty() || layer.ends_with("Combined."); });
    for (const std::string& layer : layers)
        if (has(layer + "R") && has(layer + "G") && has(layer + "B")) return layer;
    return {};
}

[[noreturn]] void refuse(const std::string& where, const std::exception& e) {
    throw Error("{}: expected an OpenEXR picture, found: {}", where, e.what());
}

// An input stream over a file in memory.
class MemoryStream : public Imf::IStream {
    using Position = decltype(std::declval<Imf::IStream&>().tellg());  // OpenEXR's 64-bit type

  public:
    MemoryStream(std::string_view bytes, const std::string& where) : Imf::IStream(where.c_str()), bytes_(bytes) {}
    bool read(char out[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (at_ > bytes_.size() || size > bytes_.size() - at_) throw std::runtime_error("the file ends too early");
        std::memcpy(out, bytes_.data() + at_, size);
        at_ += size;
        return at_ < bytes_.size();
    }
    Position tellg() override { return at_; }
    void seekg(Position at) override { at_ = static_cast<std::size_t>(at); }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

// Bytes of the values of one size.
constexpr std::pair<std::string_view, std::uint32_t> kAttributeBytes[]{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
};

// A list of channels is a name, which ends in a zero, and 16 bytes for each; an empty name ends it.
bool is_channel_list(std::string_view value) {
    constexpr std::size_t kChannelBytes = 16;
    std::size_t at = 0;
    while (at < value.size() && value[at] != 0) {
        at = value.find('\0', at);
        if (at == std::string_view::npos) return false;
        at += 1 + kChannelBytes;
    }
    return at + 1 == value.size();
}

// OpenEXR allocates what an attribute's size says before it reads the value, and reads as many bytes as its type has:
// where the two differ, it takes the sizes that follow from elsewhere. An attribute is a name and a type, which end in
// a zero, a size and a value; an empty name ends a header.
void check_attribute_sizes(std::string_view bytes, const std::string& where) {
    constexpr std::size_t kVersion = 4, kFirstHeader = 8;  // bytes from the beginning
    constexpr std::uint32_t kMultiPart = 0x1000;
    const auto number_at = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, sizeof value);
        return value;
    };
    if (bytes.size() < kFirstHeader) return;  // too short: OpenEXR says so, here and below
    std::size_t at = kFirstHeader;
    do {
        while (at < bytes.size() && bytes[at] != 0) {
            std::string_view type;
            for (int texts = 0; texts < 2; ++texts) {
                const std::size_t end = bytes.find('\0', at);
                if (end == std::string_view::npos) return;
                type = bytes.substr(at, end - at);
                at = end + 1;
            }
            if (bytes.size() - at < sizeof(std::uint32_t)) return;
            const std::uint32_t size = number_at(at);
            at += sizeof size;
            if (size > bytes.size() - at)
                throw Error("{}: expected an OpenEXR picture, found an attribute of {} bytes in a file of {}", where,
                            size, bytes.size());
            for (const auto& [known, expected] : kAttributeBytes)
                if (type == known && size != expected)
                    throw Error(
                        "{}: expected an OpenEXR picture whose attributes of type {} have {} bytes, found one "
                        "of {}",
                        where, type, expected, size);
            if (type == "chlist" && !is_channel_list(bytes.substr(at, size)))
                throw Error("{}: expected an OpenEXR picture, found a damaged list of channels", where);
            at += size;
        }
        ++at;
    } while (number_at(kVersion) & kMultiPart && at < bytes.size() && bytes[at] != 0);
}

}  // namespace

PictureInfo exr_info(std::string_view bytes, const std::string& where) {
    check_attribute_sizes(bytes, where);
    try {
        MemoryStream stream(bytes, where);
        const Imf::InputFile file(stream);
        const Imath::Box2i box = file.header().dataWindow();
        // A corrupt window may exceed the range of int.
        const auto side = [](int low, int high) {
            return static_cast<int>(std::min<std::int64_t>(std::int64_t{high} - low + 1, 0x7fffffff));
        };
        return {side(box.min.x, box.max.x), side(box.min.y, box.max.y)};
    } catch (const std::exception& e) {
        refuse(where, e);
    }
}

namespace {

// Reads channels one after the other into interleaved floats, `stride` per pixel.
void read_channels(std::string_view bytes, const std::string& where, const std::vector<std::string>& wanted,
                   float* pixels, std::size_t stride) {
    MemoryStream stream(bytes, where);
    Imf::InputFile file(stream);
    const Imath::Box2i box = file.header().dataWindow();
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        frame.insert(wanted[i], Imf::Slice::Make(Imf::FLOAT, pixels + i, box, stride * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(box.min.y, box.max.y);
}

PictureInfo checked_info(std::string_view bytes, const std::string& where) {
    const PictureInfo info = exr_info(bytes, where);
    if (!plausible_size(info.width, info.height))
        throw Error("{}: expected a picture of at most {} pixels a side, found {} x {}", where, kMaxPictureSide,
                    info.width, info.height);
    return info;
}

std::vector<std::string> channel_names(std::string_view bytes, const std::string& where) {
    MemoryStream stream(bytes, where);
    return names_of(Imf::InputFile(stream).header().channels());
}

std::string single_channel(std::string_view bytes, const std::string& where) {
    const std::vector<std::string> names = channel_names(bytes, where);
    if (names.empty()) throw Error("{}: expected a channel of floats, found none", where);
    const std::string channel = range_channel(names);
    if (channel.empty())
        throw Error("{}: expected a channel Z, depth, Y or R, found {}", where, fmt::join(names, ", "));
    return channel;
}

// Color cannot be a range map, but gray is often stored as three equal channels. Half floats and lossy compression
// round each individually.
constexpr float kSameGray = 2e-3f;

bool is_gray(const Vec3f& c) {
    const auto same = [](float a, float b) {
        return a == b || (std::isnan(a) && std::isnan(b)) ||
               std::abs(a - b) <= kSameGray * std::max(std::abs(a), std::abs(b));
    };
    return same(c.x, c.y) && same(c.x, c.z);
}

// The color channels that `channel` belongs to: R, G and B of its layer, or those next to a luminance Y; empty: it
// stands alone.
std::vector<std::string> colors_beside(const std::vector<std::string>& names, const std::string& channel) {
    const std::string last = last_part(channel), layer = channel.substr(0, channel.size() - last.size());
    const auto has = [&](const char* name) {
        return std::find(names.begin(), names.end(), layer + name) != names.end();
    };
    if (is_one_of(last, {"R", "G", "B"}) && has("R") && has("G") && has("B"))
        return {layer + "R", layer + "G", layer + "B"};
    if (last == "Y" && (has("RY") || has("BY"))) return {channel, layer + "RY", layer + "BY"};
    return {};
}

[[noreturn]] void refuse_colors(std::string_view bytes, const std::string& where, const std::string& found) {
    throw Error(
        "{}: expected a map of one number a pixel (a channel Z, depth or Y, or gray as equal R, G and B), found a "
        "color picture: channels {}{}",
        where, fmt::join(channel_names(bytes, where), ", "), found);
}

}  // namespace

ImageF decode_exr(std::string_view bytes, const std::string& where) {
    const PictureInfo info = checked_info(bytes, where);
    try {
        ImageF image(info.width, info.height);
        const std::string channel = single_channel(bytes, where);
        const std::vector<std::string> colors = colors_beside(channel_names(bytes, where), channel);
        if (colors.empty()) {
            read_channels(bytes, where, {channel}, image.pixels.data(), 1);
            return image;
        }
        if (last_part(channel) == "Y") refuse_colors(bytes, where, "");
        ImageColor color(info.width, info.height);
        read_channels(bytes, where, colors, &color.pixels.data()->x, 3);
        for (int y = 0; y < color.height; ++y)
            for (int x = 0; x < color.width; ++x) {
                const Vec3f& c = color.at(x, y);
                if (!is_gray(c))
                    refuse_colors(bytes, where,
                                  fmt::format(", with {} {} {} at column {}, row {}", c.x, c.y, c.z, x, y));
                image.at(x, y) = c.x;
            }
        return image;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        refuse(where, e);
    }
}

ImageColor decode_exr_color(std::string_view bytes, const std::string& where) {
    const PictureInfo info = checked_info(bytes, where);
    try {
        const auto layer = color_layer(channel_names(bytes, where));
        ImageColor image(info.width, info.height);
        static_assert(sizeof(Vec3f) == 3 * sizeof(float));
        read_channels(bytes, where,
                      layer ? std::vector<std::string>{*layer + "R", *layer + "G", *layer + "B"}
                            : std::vector<std::string>{single_channel(bytes, where)},
                      &image.pixels.data()->x, 3);
        if (!layer)
            for (Vec3f& c : image.pixels) c = {c.x, c.x, c.x};
        return image;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        refuse(where, e);
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

void save_exr_light(const fs::path& path, const ImageColor& image) {
    constexpr float kLargestHalf = 65504;
    std::vector<std::array<half, 3>> pixels(image.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t a = 0; a < 3; ++a)
            pixels[i][a] = half(std::clamp(image.pixels[i][a], -kLargestHalf, kLargestHalf));
    write_renamed(path, [&](const fs::path& temporary) {
        try {
            Imf::Header header(image.width, image.height);
            header.compression() = Imf::ZIP_COMPRESSION;
            Imf::FrameBuffer frame;
            const std::size_t across = sizeof pixels[0], down = across * static_cast<std::size_t>(image.width);
            for (std::size_t a = 0; a < 3; ++a) {
                const char* name = std::array{"R", "G", "B"}[a];
                header.channels().insert(name, Imf::Channel(Imf::HALF));
                frame.insert(name, Imf::Slice(Imf::HALF, reinterpret_cast<char*>(pixels.data()) + a * sizeof(half),
                                              across, down));
            }
            Imf::OutputFile file(temporary.c_str(), header);
            file.setFrameBuffer(frame);
            file.writePixels(image.height);
        } catch (const std::exception& e) {
            throw Error("{}: cannot be written: {}", path.string(), e.what());
        }
    });
}

}  // namespace fastscene
