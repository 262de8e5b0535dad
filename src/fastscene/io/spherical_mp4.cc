#include "fastscene/io/spherical_mp4.h"

#include <functional>
#include <vector>

#include <fmt/format.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {
namespace {

constexpr std::string_view kUuidV1("\xff\xcc\x82\x63\xf8\x55\x4a\x93\x88\x14\x58\x7a\x02\x52\x1f\xdd", 16);
// A video's sample entry: box header, then 78 bytes of fixed fields before its child boxes.
constexpr std::size_t kVisualEntry = 78;
constexpr std::size_t kFullBox = 4;  // version and flags

std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
    return value;
}
std::string number_bytes(std::uint64_t value, std::size_t size) {
    std::string out;
    for (std::size_t i = size; i-- > 0;) out += static_cast<char>(value >> (8 * i) & 0xff);
    return out;
}
std::string box(std::string_view name, std::string_view content) {
    return number_bytes(content.size() + 8, 4) + std::string(name) + std::string(content);
}

struct Box {
    std::string_view name, content;
    std::size_t begin = 0, header = 8;  // in the parsed bytes
};

// The boxes one after the other. Throws Error if one claims more bytes than there are.
std::vector<Box> boxes_in(std::string_view bytes, const std::string& where) {
    std::vector<Box> boxes;
    for (std::size_t at = 0; at + 8 <= bytes.size();) {
        std::uint64_t size = number_at(bytes, at, 4);
        std::size_t header = 8;
        if (size == 1) size = number_at(bytes, at + 8, 8), header = 16;
        if (size == 0) size = bytes.size() - at;
        if (size < header || size > bytes.size() - at)
            throw Error("{}: expected an MP4 film, found a box of {} bytes where {} are left", where, size,
                        bytes.size() - at);
        boxes.push_back({bytes.substr(at + 4, 4), bytes.substr(at + header, size - header), at, header});
        at += size;
    }
    return boxes;
}

std::optional<std::string_view> child(std::string_view bytes, std::string_view name, const std::string& where) {
    for (const Box& one : boxes_in(bytes, where))
        if (one.name == name) return one.content;
    return {};
}

bool is_video(std::string_view trak, const std::string& where) {
    const auto mdia = child(trak, "mdia", where);
    const auto hdlr = mdia ? child(*mdia, "hdlr", where) : std::nullopt;
    return hdlr && hdlr->size() >= 12 && hdlr->substr(8, 4) == "vide";
}

std::string st3d(const SphericalFilm& film) {
    return box("st3d", number_bytes(0, kFullBox) + static_cast<char>(film.stereo));
}

std::string sv3d(const SphericalFilm& film) {
    const std::string version = number_bytes(0, kFullBox);
    const std::string maker = box("svhd", version + std::string("fastscene") + '\0');
    const std::string pose = box("prhd", version + number_bytes(0, 12));  // yaw, pitch, roll
    // What of the sphere's picture is cut off above, below, left and right, in parts of 2^32: a quarter on both sides.
    const std::uint64_t side = film.half ? 0x40000000u : 0;
    const std::string bounds = box("equi",
                                   version + number_bytes(0, 8) + number_bytes(side, 4) + number_bytes(side, 4));
    return box("sv3d", maker + box("proj", pose + bounds));
}

std::string uuid_v1(const SphericalFilm& film) {
    const std::string stereo = film.stereo == StereoLayout::top_bottom
                                   ? "<GSpherical:StereoMode>top-bottom</GSpherical:StereoMode>"
                               : film.stereo == StereoLayout::left_right
                                   ? "<GSpherical:StereoMode>left-right</GSpherical:StereoMode>"
                                   : "";
    return box(
        "uuid",
        std::string(kUuidV1) +
            "<?xml version=\"1.0\"?><rdf:SphericalVideo xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
            "xmlns:GSpherical=\"http://ns.google.com/videos/1.0/spherical/\">"
            "<GSpherical:Spherical>true</GSpherical:Spherical><GSpherical:Stitched>true</GSpherical:Stitched>"
            "<GSpherical:StitchingSoftware>fastscene</GSpherical:StitchingSoftware>"
            "<GSpherical:ProjectionType>equirectangular</GSpherical:ProjectionType>" +
            stereo + "</rdf:SphericalVideo>");
}

bool is_v1(const Box& one) { return one.name == "uuid" && one.content.starts_with(kUuidV1); }

// The same boxes, each replaced by what `change` makes of it; an empty text leaves it out.
std::string changed(std::string_view bytes, const std::string& where,
                    const std::function<std::string(const Box&, std::string_view whole)>& change) {
    std::string out;
    for (const Box& one : boxes_in(bytes, where))
        out += change(one, bytes.substr(one.begin, one.header + one.content.size()));
    return out;
}

std::string marked_entry(std::string_view entry, const SphericalFilm& film, const std::string& where) {
    if (entry.size() < kVisualEntry) throw Error("{}: expected a video's description, found a shorter one", where);
    std::string out(entry.substr(0, kVisualEntry));
    out += changed(entry.substr(kVisualEntry), where, [](const Box& one, std::string_view whole) {
        return one.name == "st3d" || one.name == "sv3d" ? "" : std::string(whole);
    });
    return out + st3d(film) + sv3d(film);
}

// The path from a track to its sample descriptions.
std::string marked_tree(const Box& one, std::string_view whole, const SphericalFilm& film, const std::string& where) {
    if (one.name == "stsd") {
        constexpr std::size_t kHead = kFullBox + 4;  // number of entries
        if (one.content.size() < kHead) throw Error("{}: expected a video's description, found none", where);
        return box("stsd", std::string(one.content.substr(0, kHead)) +
                               changed(one.content.substr(kHead), where, [&](const Box& entry, std::string_view) {
                                   return box(entry.name, marked_entry(entry.content, film, where));
                               }));
    }
    if (one.name != "mdia" && one.name != "minf" && one.name != "stbl") return std::string(whole);
    return box(one.name, changed(one.content, where, [&](const Box& inner, std::string_view all) {
                   return marked_tree(inner, all, film, where);
               }));
}

std::string marked_trak(std::string_view trak, const SphericalFilm& film, const std::string& where) {
    std::string out = changed(trak, where, [&](const Box& one, std::string_view whole) {
        return is_v1(one) ? "" : marked_tree(one, whole, film, where);
    });
    return film.half ? out : out + uuid_v1(film);
}

// Adds `shift` to the positions of samples in the file (stco, co64), anywhere below.
std::string shifted(std::string_view bytes, std::int64_t shift, const std::string& where) {
    return changed(bytes, where, [&](const Box& one, std::string_view whole) -> std::string {
        if (one.name == "trak" || one.name == "mdia" || one.name == "minf" || one.name == "stbl")
            return box(one.name, shifted(one.content, shift, where));
        if (one.name != "stco" && one.name != "co64") return std::string(whole);
        const std::size_t size = one.name == "stco" ? 4 : 8;
        std::string content(one.content.substr(0, 8));
        for (std::size_t at = 8; at + size <= one.content.size(); at += size) {
            const std::uint64_t moved = number_at(one.content, at, size) + static_cast<std::uint64_t>(shift);
            if (size == 4 && moved >> 32 != 0) throw Error("{}: expected a film below 4 GB, found a larger one", where);
            content += number_bytes(moved, size);
        }
        return box(one.name, content);
    });
}

}  // namespace

std::string with_spherical_boxes(std::string_view mp4, const SphericalFilm& film, const std::string& where) {
    const std::vector<Box> top = boxes_in(mp4, where);
    std::size_t moov_at = top.size(), data_at = top.size();
    for (std::size_t i = 0; i < top.size(); ++i) {
        if (top[i].name == "moov") moov_at = i;
        if (top[i].name == "mdat" && data_at == top.size()) data_at = i;
    }
    if (moov_at == top.size() || data_at == top.size()) throw Error("{}: expected an MP4 film, found none", where);
    bool found = false;
    std::string moov = changed(top[moov_at].content, where, [&](const Box& one, std::string_view whole) {
        if (found || one.name != "trak" || !is_video(one.content, where)) return std::string(whole);
        found = true;
        return box("trak", marked_trak(one.content, film, where));
    });
    if (!found) throw Error("{}: expected a video track, found none", where);
    if (moov_at < data_at)
        moov = shifted(moov,
                       static_cast<std::int64_t>(moov.size()) - static_cast<std::int64_t>(top[moov_at].content.size()),
                       where);
    return changed(mp4, where, [&](const Box& one, std::string_view whole) {
        return one.name == "moov" ? box("moov", moov) : std::string(whole);
    });
}

std::optional<SphericalFilm> spherical_boxes_of(std::string_view mp4) {
    const std::string where = "film";
    const auto moov = child(mp4, "moov", where);
    if (!moov) return {};
    for (const Box& trak : boxes_in(*moov, where)) {
        if (trak.name != "trak" || !is_video(trak.content, where)) continue;
        std::optional<std::string_view> at = trak.content;
        for (const char* name : {"mdia", "minf", "stbl", "stsd"}) at = at ? child(*at, name, where) : at;
        if (!at || at->size() < 8) return {};
        const std::vector<Box> entries = boxes_in(at->substr(8), where);
        if (entries.empty() || entries[0].content.size() < kVisualEntry) return {};
        const std::string_view inner = entries[0].content.substr(kVisualEntry);
        const auto sphere = child(inner, "sv3d", where), stereo = child(inner, "st3d", where);
        const auto proj = sphere ? child(*sphere, "proj", where) : std::nullopt;
        const auto equi = proj ? child(*proj, "equi", where) : std::nullopt;
        if (!equi || equi->size() != kFullBox + 16) return {};
        SphericalFilm film;
        if (stereo && stereo->size() == kFullBox + 1) film.stereo = static_cast<StereoLayout>((*stereo)[kFullBox]);
        film.half = number_at(*equi, kFullBox + 8, 4) == 0x40000000u &&
                    number_at(*equi, kFullBox + 12, 4) == 0x40000000u;
        return film;
    }
    return {};
}

void mark_spherical(const std::filesystem::path& path, const SphericalFilm& film) {
    write_file(path, with_spherical_boxes(read_file(path), film, path.string()));
}

}  // namespace fastscene
