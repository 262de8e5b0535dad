// Splat files as people meet them: headers by hand, other types, records, extensions, places far from the origin. All
// hold the same two splats, which must come out right.
#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/image/color.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/glb.h"
#include "fastscene/io/glb_container.h"
#include "fastscene/io/gzip.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/splat_frames.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/spz_layout.h"
#include "fastscene/io/test_scratch.h"
#include "fastscene/io/test_splats.h"

namespace fastscene {
namespace {

// Red low right far, blue high left near; unequal scales, turned by no symmetry.
Splats two() {
    Splats s;
    s.resize(2);
    s.mean_m = {{0.5f, 0.25f, 2.f}, {-0.4f, -0.6f, 1.f}};
    s.log_scale = {{std::log(0.3f), std::log(0.1f), std::log(0.05f)},
                   {std::log(0.05f), std::log(0.2f), std::log(0.1f)}};
    s.rotation = {{0.9f, 0.3f, 0.2f, 0.1f}, {0.7f, -0.1f, 0.6f, 0.2f}};
    s.opacity_logit = {std::log(9.f), std::log(1.5f)};
    const auto dc = [](Vec3f c) { return (c - Vec3f{0.5f, 0.5f, 0.5f}) / kSh0; };
    s.sh0 = {dc({0.9f, 0.1f, 0.1f}), dc({0.1f, 0.2f, 0.9f})};
    return s;
}

// Squared standard deviation along a direction: says where a Gaussian's axes are, whatever they are called.
float spread(const Splats& s, std::size_t i, Vec3f along) {
    const auto [w, x, y, z] = unit_quaternion(s.rotation[i]);
    const Mat3f axes = matrix_of(Quatf{w, x, y, z});
    float sum = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const float part = dot(axes.column(a), along) * std::exp(s.log_scale[i][a]);
        sum += part * part;
    }
    return sum;
}

void expect_two(const Splats& s, float within, const std::string& what) {
    const Splats right = two();
    ASSERT_EQ(s.size(), 2u) << what;
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LT(length(s.mean_m[i] - right.mean_m[i]), within) << what << i;
        EXPECT_LT(length(s.sh0[i] - right.sh0[i]), 20 * within) << what << i;
        EXPECT_NEAR(sigmoid(s.opacity_logit[i]), sigmoid(right.opacity_logit[i]), within) << what << i;
        for (const Vec3f along : {Vec3f{1, 0, 0}, Vec3f{0, 0.6f, 0.8f}, Vec3f{0.6f, -0.8f, 0}, Vec3f{-0.6f, 0, 0.8f}})
            EXPECT_NEAR(spread(s, i, along), spread(right, i, along), within) << what << i;
    }
}

std::string refusal(const std::filesystem::path& file) {
    try {
        load_splats(file);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(FoundPly, HeadersWithBlanksAndRemarks) {
    const std::string whole = splat_ply_bytes(two(), PlyBands::present), end = "end_header\n";
    std::string head = whole.substr(0, whole.find(end) + end.size()), body = whole.substr(head.size());
    std::string found;
    for (const char c : head) found += c == ' ' ? "  " : c == '\n' ? " \t\r\n" : std::string(1, c);
    found.insert(found.find("element"), "comment Vertical Axis: z \r\nobj_info  by hand\r\n");
    write_file(scratch("blanks.ply"), found + body);
    expect_two(load_splats(scratch("blanks.ply")).splats, 1e-5f, "blanks");
}

TEST(FoundPly, ColorsAsRedGreenBlue) {
    const auto file_of = [&](const char* type, double top) {
        const Splats s = two();
        std::string text = "ply\nformat ascii 1.0\nelement vertex 2\n";
        for (const char* name : {"x", "y", "z"}) text += fmt::format("property double {}\n", name);
        for (const char* name : {"red", "green", "blue"}) text += fmt::format("property {} {}\n", type, name);
        for (const char* name : {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"})
            text += fmt::format("property float {}\n", name);
        text += "end_header\n";
        for (std::size_t i = 0; i < 2; ++i) {
            const Vec3f p = s.mean_m[i], l = s.log_scale[i], c = s.sh0[i] * kSh0 + Vec3f{0.5f, 0.5f, 0.5f};
            const Quatf q = s.rotation[i];
            const auto put = [&](double v) { text += fmt::format("{} ", v); };
            for (const float v : {p.x, p.y, p.z}) put(v);
            for (const float v : {c.x, c.y, c.z}) put(top == 1 ? v : std::round(v * top));
            for (const float v : {s.opacity_logit[i], l.x, l.y, l.z, q.w, q.x, q.y, q.z}) put(v);
            text += "\n";
        }
        return text;
    };
    // A text file's numbers are read as floats; a binary one's as what they are: both say how bright 255 is.
    for (const auto& [type, top] : {std::pair{"uchar", 255.0}, {"float", 1.0}, {"float", 255.0}}) {
        write_file(scratch("rgb.ply"), file_of(type, top));
        expect_two(load_splats(scratch("rgb.ply")).splats, 3e-3f, fmt::format("{} up to {}", type, top));
    }
    std::string cloud = file_of("uchar", 255);
    for (std::size_t at; (at = cloud.find("scale_")) != std::string::npos;) cloud.replace(at, 6, "other");
    write_file(scratch("cloud.ply"), cloud);
    EXPECT_NE(refusal(scratch("cloud.ply")).find("a cloud of colored points"), std::string::npos);
}

std::string record(std::uint32_t id, const std::string& content) {
    std::string out;
    append(out, id), append(out, static_cast<std::uint32_t>(content.size()));
    return out + content;
}
std::string number(std::uint32_t v) {
    std::string out;
    append(out, v);
    return out;
}
constexpr std::size_t kFlagsAt = 14;
// Version 3 with records behind the data.
std::string spz3_with(const Splats& splats, const std::string& records) {
    std::string bytes = inflated(spz_bytes(splats, 3), "bytes");
    bytes[kFlagsAt] = static_cast<char>(bytes[kFlagsAt] | kSpzHasExtensions);
    return gzipped(bytes + records);
}
// Splats whose numbers in RUB, SPZ's own axes, are those of `splats` in the axes given.
Splats stored_in(const Splats& splats, const char* axes) {
    const Mat3d file{
        {axes[0] == 'R' ? 1.0 : -1.0, 0, 0}, {0, axes[1] == 'D' ? 1.0 : -1.0, 0}, {0, 0, axes[2] == 'F' ? 1.0 : -1.0}};
    Splats out = splats;
    transform(out, {transpose(kSpzFromWorld) * file, 1, {}});
    return out;
}

TEST(FoundSpz, AxesOfTheRecord) {
    const char* kAxes[] = {"LDB", "RDB", "LUB", "RUB", "LDF", "RDF", "LUF", "RUF"};  // 1 to 8
    Splats lit = two();                                                              // harmonics are mirrored, too
    lit.sh_degree = 1;
    lit.resize(2);
    lit.sh_rest[0] = 0.4f, lit.sh_rest[2] = 0.25f;
    for (std::uint32_t n = 1; n <= 8; ++n) {
        const Splats stored = stored_in(lit, kAxes[n - 1]);
        const std::filesystem::path file = scratch("axes.spz");
        write_file(file, spz3_with(stored, record(kSpzAxesRecord, number(n))));
        LoadedSplats loaded = load_splats(file);
        expect_two(loaded.splats, 6e-3f, kAxes[n - 1]);
        EXPECT_NEAR(loaded.splats.sh_rest[0], 0.4f, 0.04f) << kAxes[n - 1];
        EXPECT_NEAR(loaded.splats.sh_rest[2], 0.25f, 0.04f) << kAxes[n - 1];
        EXPECT_TRUE(loaded.warnings.empty());
        std::string four = spz_bytes(stored, 4);
        four.replace(kSpzHeader4 + kSpzRecordHeader, 4, number(n));
        write_file(file, four);
        expect_two(load_splats(file).splats, 6e-3f, std::string("version 4, ") + kAxes[n - 1]);
    }
}

TEST(FoundSpz, Version4SaysItsAxes) {
    const std::string four = spz_bytes(two(), 4);
    EXPECT_EQ(number_at<std::uint32_t>(four, kSpzHeader4), 0xadbe0003u);
    EXPECT_EQ(number_at<std::uint32_t>(four, kSpzHeader4 + 4), 4u);
    EXPECT_EQ(number_at<std::uint32_t>(four, kSpzHeader4 + 8), 4u);  // right, up, back
    EXPECT_EQ(number_at<std::uint32_t>(four, 16), kSpzHeader4 + 12);
    EXPECT_EQ(inflated(spz_bytes(two(), 3), "bytes")[kFlagsAt] & kSpzHasExtensions,
              0);  // old readers refuse more bytes
}

TEST(FoundSpz, UnknownRecordsAreOneWarning) {
    write_file(scratch("unknown.spz"), spz3_with(two(), record(0xadbe0002, std::string(12, 'a')) + record(7, "bcd")));
    const LoadedSplats loaded = load_splats(scratch("unknown.spz"));
    expect_two(loaded.splats, 6e-3f, "unknown records");
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_NE(loaded.warnings[0].find("adbe0002 (12 bytes), 00000007 (3 bytes)"), std::string::npos)
        << loaded.warnings[0];
    write_file(scratch("long.spz"), spz3_with(two(), record(9, "ab").substr(0, 9)));
    EXPECT_NE(refusal(scratch("long.spz")).find("long.spz"), std::string::npos);
    write_file(scratch("odd.spz"), spz3_with(two(), record(kSpzAxesRecord, number(9))));
    EXPECT_NE(refusal(scratch("odd.spz")).find("axes 1 to 8"), std::string::npos);
}

// A glTF file of ours, its JSON and data changed.
struct Glb {
    Json json;
    std::string binary;
    explicit Glb(const std::string& bytes) {
        const auto size = number_at<std::uint32_t>(bytes, 12);
        json = Json::parse(bytes.substr(20, size));
        binary = bytes.substr(28 + size);
    }
    Json& primitive() { return json["meshes"][0]["primitives"][0]; }
    std::size_t add_view(const std::string& data) {
        binary.resize((binary.size() + 3) / 4 * 4);
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", data.size()}});
        binary += data;
        return json["bufferViews"].size() - 1;
    }
    template <class T>
    void replace(const std::string& name, const char* type, int component, bool normalized, std::vector<T> values) {
        std::string data;
        for (const T v : values) append(data, v);
        Json accessor{{"bufferView", add_view(data)}, {"componentType", component}, {"count", 2}, {"type", type}};
        if (normalized) accessor["normalized"] = true;
        json["accessors"].push_back(accessor);
        primitive()["attributes"]["KHR_gaussian_splatting:" + name] = json["accessors"].size() - 1;
    }
    LoadedSplats loaded() const {
        write_file(scratch("made.glb"), glb_bytes(json, binary));
        return load_splats(scratch("made.glb"));
    }
};

TEST(FoundGlb, BytesAndShorts) {
    Glb glb(splat_glb_bytes(two()));
    glb.replace<std::uint16_t>("SCALE", "VEC3", 5123, true, {19661, 6554, 3277, 3277, 13107, 6554});
    glb.replace<std::uint8_t>("OPACITY", "SCALAR", 5121, true, {230, 153});
    Splats turned = two();  // as the file's rotations are, in shorts
    transform(turned, {kGltfFromWorld, 1, {}});
    std::vector<std::int16_t> quaternions;
    for (const Quatf q : turned.rotation) {
        const auto [w, x, y, z] = unit_quaternion(q);
        for (const float v : {x, y, z, w}) quaternions.push_back(static_cast<std::int16_t>(std::lround(v * 32767)));
    }
    glb.replace<std::int16_t>("ROTATION", "VEC4", 5122, true, quaternions);
    expect_two(glb.loaded().splats, 3e-3f, "shorts and bytes");
    // Not normalized: whole metres.
    glb.replace<std::uint8_t>("SCALE", "VEC3", 5121, false, {3, 1, 2, 4, 5, 6});
    const Splats large = glb.loaded().splats;
    EXPECT_NEAR(std::exp(large.log_scale[0].x), 3, 1e-4);
    EXPECT_NEAR(std::exp(large.log_scale[1].z), 6, 1e-4);
}

TEST(FoundGlb, LinearColors) {
    Glb glb(splat_glb_bytes(two()));
    glb.primitive()["extensions"]["KHR_gaussian_splatting"]["colorSpace"] = "lin_rec709_display";
    const LoadedSplats loaded = glb.loaded();
    EXPECT_NEAR(loaded.splats.sh0[0].x * kSh0 + 0.5f, srgb_from_linear(0.9f), 1e-4);
    EXPECT_NEAR(loaded.splats.sh0[1].y * kSh0 + 0.5f, srgb_from_linear(0.2f), 1e-4);
    EXPECT_EQ(loaded.warnings.size(), 1u);
    glb.primitive()["extensions"]["KHR_gaussian_splatting"]["colorSpace"] = "other";
    EXPECT_THROW(glb.loaded(), Error);
}

TEST(FoundGlb, NodesAndExtensionsThatSplatsDoNotNeed) {
    Glb glb(splat_glb_bytes(two()));
    glb.json["extensionsRequired"] = {"KHR_materials_unlit", "KHR_lights_punctual"};
    expect_two(glb.loaded().splats, 1e-5f, "required extensions");
    glb.json["nodes"][0].update(
        {{"translation", {1, 2, 3}}, {"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}, {"scale", {2, 2, 2}}});
    const Splats moved = glb.loaded().splats;
    EXPECT_LT(length(moved.mean_m[0] - Vec3f{-5, -1.5f, 4}), 1e-4f);  // by hand
    glb.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
    EXPECT_THROW(glb.loaded(), Error);  // its data are needed
}

TEST(FoundGlb, SpzInside) {
    // In the node's axes: as if they were SPZ's own.
    Splats as_stored = two();
    transform(as_stored, {transpose(kSpzFromWorld) * kGltfFromWorld, 1, {}});
    const std::string spz = spz_bytes(as_stored, 2);
    for (const bool on_primitive : {false, true})
        for (const char* name : {"KHR_gaussian_splatting_compression_spz_2", "KHR_gaussian_splatting_compression_spz",
                                 "KHR_spz_gaussian_splats_compression"}) {
            Glb glb(splat_glb_bytes(some_splats(2, 0)));  // the plain ones are others
            Json& extensions = glb.primitive()["extensions"];
            (on_primitive ? extensions : extensions["KHR_gaussian_splatting"]["extensions"])[name] = {
                {"bufferView", glb.add_view(spz)}};
            if (on_primitive) extensions.erase("KHR_gaussian_splatting");
            for (auto& [attribute, accessor] : glb.primitive()["attributes"].items())
                if (attribute != "POSITION") glb.json["accessors"][accessor.get<std::size_t>()].erase("bufferView");
            glb.json["extensionsRequired"] = {name};
            expect_two(glb.loaded().splats, 2e-2f, name);
        }
    // No SPZ where it should be: the plain splats beside it, with a warning.
    Glb glb(splat_glb_bytes(two()));
    Json& inner = glb.primitive()["extensions"]["KHR_gaussian_splatting"]["extensions"];
    inner["KHR_gaussian_splatting_compression_spz_2"] = {{"bufferView", 0}};
    const LoadedSplats loaded = glb.loaded();
    expect_two(loaded.splats, 1e-5f, "plain beside");
    EXPECT_EQ(loaded.warnings.size(), 1u);
}

TEST(FoundSplats, FarFromTheOrigin) {
    const Vec3d offset{4512000, 0, 654000};
    const std::filesystem::path ply = scratch("far.ply"), glb = scratch("far.glb"), spz = scratch("far.spz");
    for (const auto& file : {ply, glb}) {
        save_splats(file, two(), {PlyBands::present, 3, offset});
        const LoadedSplats loaded = load_splats(file);
        EXPECT_EQ(loaded.offset_m, offset) << file;
        expect_two(loaded.splats, 1e-5f, file.string());
    }
    EXPECT_NE(read_file(ply).find("property double x\n"), std::string::npos);  // absolute positions
    EXPECT_FALSE(load_splats(ply).format->empty == false);
    EXPECT_FALSE(splat_format_of_name(spz)->offset);
    save_splat_ply(ply, two(), PlyBands::all, offset);  // as runs keep it: relative, the offset in a comment
    EXPECT_NE(read_file(ply).find("property float x\n"), std::string::npos);
    EXPECT_EQ(load_splats(ply).offset_m, offset);
    expect_two(load_splats(ply).splats, 1e-5f, "kept");
}

std::uint16_t half_of(float v) {  // of numbers that half floats can hold well
    int exponent = 0;
    const float mantissa = std::frexp(std::fabs(v), &exponent);
    const auto bits = static_cast<std::uint16_t>((exponent + 14) << 10 |
                                                 (static_cast<int>(std::lround(mantissa * 2048)) - 1024));
    return static_cast<std::uint16_t>(bits | (v < 0 ? 0x8000 : 0));
}

TEST(FoundKsplat, BucketsAndHalfFloats) {
    for (const int level : {1, 2}) {
        const Splats s = two();
        std::string out;
        append(out, std::uint16_t{0x0100}), append(out, std::uint16_t{0});  // version 0.1
        for (const std::uint32_t v : {1u, 1u, 2u, 2u}) append(out, v);
        append(out, static_cast<std::uint16_t>(level));
        out.resize(36, '\0');
        append(out, -2.f), append(out, 2.f);  // the range of harmonics
        out.resize(4096, '\0');
        for (const std::uint32_t v : {2u, 2u, 256u, 2u}) append(out, v);  // two buckets, each partly filled
        append(out, 5.f), append(out, std::uint16_t{12}), append(out, std::uint16_t{0}), append(out, 0u),
            append(out, 0u);
        append(out, 0u), append(out, 2u), append(out, std::uint16_t{1});
        out.resize(4096 + 1024, '\0');
        append(out, 1u), append(out, 1u);  // lengths of the partly filled buckets
        const Vec3f middles[] = {{1, 0, 1.5f}, {-1, 0, 0}};
        for (const Vec3f m : middles) append(out, m.x), append(out, m.y), append(out, m.z);
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t a = 0; a < 3; ++a)
                append(out, static_cast<std::uint16_t>(32767 +
                                                       std::lround((s.mean_m[i][a] - middles[i][a]) / 2.5f * 32767)));
            for (std::size_t a = 0; a < 3; ++a) append(out, half_of(std::exp(s.log_scale[i][a])));
            const Quatf q = s.rotation[i];
            for (const float v : {q.w, q.x, q.y, q.z}) append(out, half_of(v));
            for (std::size_t c = 0; c < 3; ++c) append(out, byte_near((s.sh0[i][c] * kSh0 + 0.5f) * 255));
            append(out, byte_near(sigmoid(s.opacity_logit[i]) * 255));
            for (int k = 0; k < 9; ++k)  // red, green and blue of each of three
                if (level == 1) append(out, half_of(k == 1 ? 0.5f : 0.25f));
                else append(out, static_cast<std::uint8_t>(k == 1 ? 159 : 143));
        }
        write_file(scratch("two.ksplat"), out);
        const Splats read = load_splats(scratch("two.ksplat")).splats;
        expect_two(read, 4e-3f, fmt::format("level {}", level));
        ASSERT_EQ(read.sh_degree, 1);
        EXPECT_NEAR(read.sh_rest[1], 0.5f, 0.01f);  // red of the second harmonic
        EXPECT_NEAR(read.sh_rest[3], 0.25f, 0.13f);
        for (std::size_t keep = 0; keep < out.size(); keep += 1 + keep / 7) {
            write_file(scratch("cut.ksplat"), out.substr(0, keep));
            EXPECT_NE(refusal(scratch("cut.ksplat")).find("cut.ksplat"), std::string::npos) << keep;
        }
    }
}

}  // namespace
}  // namespace fastscene
