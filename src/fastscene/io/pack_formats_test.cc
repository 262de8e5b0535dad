// Zip archives and OBJ models, the ingredients of a furniture pack.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/obj.h"
#include "fastscene/io/zip.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

std::string le(std::uint32_t v, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) out += static_cast<char>((v >> (8 * i)) & 0xff);
    return out;
}

std::string deflated(const std::string& text) {
    z_stream s{};
    deflateInit2(&s, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string out(text.size() + 64, '\0');
    s.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    s.avail_in = static_cast<uInt>(text.size());
    s.next_out = reinterpret_cast<Bytef*>(out.data());
    s.avail_out = static_cast<uInt>(out.size());
    deflate(&s, Z_FINISH);
    out.resize(s.total_out);
    deflateEnd(&s);
    return out;
}

// One entry, written by PKWARE's APPNOTE.
std::string archive(const std::string& name, const std::string& text, bool packed) {
    const std::string data = packed ? deflated(text) : text;
    const auto crc = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
    const std::string common = le(20, 2) + le(0, 2) + le(packed ? 8 : 0, 2) + le(0, 4) + le(crc, 4) +
                               le(static_cast<std::uint32_t>(data.size()), 4) +
                               le(static_cast<std::uint32_t>(text.size()), 4) +
                               le(static_cast<std::uint32_t>(name.size()), 2) + le(0, 2);
    const std::string local = le(0x04034b50, 4) + common + name + data;
    const std::string central = le(0x02014b50, 4) + le(20, 2) + common + le(0, 2) + le(0, 2) + le(0, 2) + le(0, 4) +
                                le(0, 4) + name;
    return local + central + le(0x06054b50, 4) + le(0, 4) + le(1, 2) + le(1, 2) +
           le(static_cast<std::uint32_t>(central.size()), 4) + le(static_cast<std::uint32_t>(local.size()), 4) +
           le(0, 2);
}

class Zip : public ::testing::Test {
  protected:
    fs::path path_ = fs::path(::testing::TempDir()) / "fastscene_zip_test.zip";
    void TearDown() override { fs::remove(path_); }
};

TEST_F(Zip, ReadsStoredAndDeflatedEntries) {
    const std::string text(5000, 'x');
    for (const bool packed : {false, true}) {
        write_file(path_, archive("a/b.txt", text, packed));
        const ZipFile zip(path_);
        EXPECT_EQ(zip.names(), std::vector<std::string>{"a/b.txt"});
        EXPECT_EQ(zip.read("a/b.txt"), text);
        EXPECT_THROW(zip.read("other"), Error);
    }
}

TEST_F(Zip, DamageIsFoundAtEveryLength) {
    const std::string whole = archive("a.txt", "some text that is long enough to be packed, packed, packed", true);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        write_file(path_, whole.substr(0, length));
        EXPECT_THROW(ZipFile(path_).read("a.txt"), Error) << length;
    }
    std::string flipped = whole;
    flipped[40] = static_cast<char>(flipped[40] ^ 0x11);
    write_file(path_, flipped);
    EXPECT_THROW(ZipFile(path_).read("a.txt"), Error);
    EXPECT_THROW(ZipFile("/no/such/file.zip"), Error);
}

ObjModel parse(const std::string& text, const std::string& mtl = "") {
    return parse_obj(text, "test.obj",
                     [&](const std::string&) { return mtl.empty() ? std::nullopt : std::optional(mtl); });
}

TEST(Obj, FacesOfAnySizeNegativeIndicesAndMaterials) {
    const ObjModel m = parse(
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl red paint\nf -4/-4 "
        "-3/-3 -2/-2 -1/-1\n",
        "newmtl red paint\nKd 1 0 0\nNs 50\nd 0.5\nmap_Kd some picture.jpg\n");
    ASSERT_EQ(m.groups.size(), 1u);
    EXPECT_EQ(m.groups[0].triangles.size(), 6u);
    const ObjMaterial& red = m.materials[m.groups[0].material];
    EXPECT_EQ(red.name, "red paint");
    EXPECT_EQ(red.diffuse_map, "some picture.jpg");
    EXPECT_EQ(red.diffuse, (Vec3f{1, 0, 0}));
    EXPECT_EQ(red.opacity, 0.5f);
    for (const Vec3f n : m.groups[0].normals) EXPECT_NEAR(n.z, 1.f, 1e-6f);
}

TEST(Obj, WindingFollowsTheNormals) {
    const ObjModel m = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n");
    const auto& g = m.groups[0];
    const Vec3f wound = cross(g.positions[g.triangles[1]] - g.positions[g.triangles[0]],
                              g.positions[g.triangles[2]] - g.positions[g.triangles[0]]);
    EXPECT_LT(wound.z, 0.f);
    EXPECT_LT(g.normals[0].z, 0.f);
}

TEST(Obj, NonsenseIsRefused) {
    EXPECT_THROW(parse(""), Error);
    EXPECT_THROW(parse("v 0 0 0\nf 1 2 3\n"), Error);
    EXPECT_THROW(parse("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), Error);
    EXPECT_THROW(parse("v 0 0\n"), Error);
    EXPECT_THROW(parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n"), Error);
}

}  // namespace
}  // namespace fastscene
