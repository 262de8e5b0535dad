#include "fastscene/io/gpano_mark.h"

#include <zlib.h>

#include <cstdint>

#include <fmt/format.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

constexpr std::string_view kXmpName("http://ns.adobe.com/xap/1.0/\0", 29);  // of the JPEG segment
constexpr std::string_view kPngKeyword = "XML:com.adobe.xmp";
constexpr std::string_view kPanoramaNamespace = "http://ns.google.com/photos/1.0/panorama/";

std::string packet_of(const SphereMark& p) {
    return fmt::format(
        "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
        "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
        "<rdf:Description rdf:about=\"\" xmlns:GPano=\"{}\" GPano:ProjectionType=\"equirectangular\" "
        "GPano:UsePanoramaViewer=\"True\" GPano:PoseHeadingDegrees=\"{:.1f}\" "
        "GPano:FullPanoWidthPixels=\"{}\" GPano:FullPanoHeightPixels=\"{}\" "
        "GPano:CroppedAreaLeftPixels=\"{}\" GPano:CroppedAreaTopPixels=\"{}\" "
        "GPano:CroppedAreaImageWidthPixels=\"{}\" GPano:CroppedAreaImageHeightPixels=\"{}\"/>\n"
        "</rdf:RDF></x:xmpmeta>\n<?xpacket end=\"w\"?>",
        kPanoramaNamespace, p.heading_deg, p.full_width, p.full_height, p.left, p.top, p.width, p.height);
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}
std::string big_endian_bytes(std::uint32_t value, std::size_t size) {
    std::string out;
    for (std::size_t i = size; i-- > 0;) out += static_cast<char>(value >> (8 * i) & 0xff);
    return out;
}

bool is_jpeg(std::string_view file) { return file.substr(0, 2) == "\xff\xd8"; }
bool is_png(std::string_view file) { return file.substr(0, 8) == "\x89PNG\r\n\x1a\n"; }

// A segment of a JPEG, or a chunk of a PNG, with its header.
struct Piece {
    std::size_t begin = 0, size = 0;
    std::string_view xmp;  // empty: another one
};

// The pieces before the picture's data.
std::vector<Piece> jpeg_pieces(std::string_view file) {
    std::vector<Piece> pieces;
    for (std::size_t at = 2; at + 4 <= file.size() && file[at] == '\xff';) {
        const std::uint32_t marker = big_endian(file, at + 1, 1), length = big_endian(file, at + 2, 2);
        if (marker == 0xda || length < 2 || at + 2 + length > file.size()) break;
        Piece piece{at, 2 + length, {}};
        const std::string_view data = file.substr(at + 4, length - 2);
        if (marker == 0xe1 && data.starts_with(kXmpName)) piece.xmp = data.substr(kXmpName.size());
        pieces.push_back(piece);
        at += piece.size;
    }
    return pieces;
}

std::vector<Piece> png_pieces(std::string_view file) {
    std::vector<Piece> pieces;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::size_t length = big_endian(file, at, 4);
        if (length > file.size() - at - 12) break;
        Piece piece{at, 12 + length, {}};
        const std::string_view kind = file.substr(at + 4, 4), data = file.substr(at + 8, length);
        // keyword, 0, compressed 0, method 0, language 0, translated keyword 0, text
        if (kind == "iTXt" && data.starts_with(kPngKeyword) && data.size() > kPngKeyword.size() + 5 &&
            data[kPngKeyword.size() + 1] == 0) {
            const std::size_t language = data.find('\0', kPngKeyword.size() + 3);
            const std::size_t text = language == data.npos ? data.npos : data.find('\0', language + 1);
            if (text != data.npos) piece.xmp = data.substr(text + 1);
        }
        pieces.push_back(piece);
        at += piece.size;
    }
    return pieces;
}

std::string jpeg_segment(const std::string& packet) {
    const std::string data = std::string(kXmpName) + packet;
    return "\xff\xe1" + big_endian_bytes(static_cast<std::uint32_t>(data.size() + 2), 2) + data;
}

std::string png_chunk(const std::string& packet) {
    const std::string body = "iTXt" + std::string(kPngKeyword) + std::string(5, '\0') + packet;
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big_endian_bytes(static_cast<std::uint32_t>(body.size() - 4), 4) + body +
           big_endian_bytes(static_cast<std::uint32_t>(crc), 4);
}

}  // namespace

SphereMark whole_sphere(int width, int height) { return {width, height, 0, 0, width, height, 0}; }

std::string with_gpano(std::string_view file, const SphereMark& pano, const std::string& where) {
    const bool jpeg = is_jpeg(file);
    if (!jpeg && !is_png(file)) throw Error("{}: expected a JPEG or PNG picture, found another format", where);
    const std::vector<Piece> pieces = jpeg ? jpeg_pieces(file) : png_pieces(file);
    const std::string mark = jpeg ? jpeg_segment(packet_of(pano)) : png_chunk(packet_of(pano));
    // After the first piece, which has to be first: JFIF's header, PNG's size.
    std::string out(file.substr(0, jpeg ? 2 : 8));
    std::size_t end = out.size();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].xmp.empty()) out += file.substr(pieces[i].begin, pieces[i].size);
        if (i == 0) out += mark;
        end = pieces[i].begin + pieces[i].size;
    }
    return out.append(file.substr(end));
}

void save_panorama(const std::filesystem::path& path, const ImageRgb8& image) {
    const bool png = path.extension() == ".png";
    png ? save_png(path, image) : save_jpeg(path, image);
    write_file(path, with_gpano(read_file(path), whole_sphere(image.width, image.height), path.string()));
}

}  // namespace fastscene
