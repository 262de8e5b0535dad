// Round trips of splats through every format, within its quantization; byte layouts that other programs rely on; files
// written by other programs. (tests/readers runs the other programs themselves.)
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/base/random.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/ply.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/test_scratch.h"
#include "fastscene/io/test_splats.h"
#include "fastscene/scene/sh.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Maximum differences; rotations are compared by the axes they produce.
struct Difference {
    float mean = 0, log_scale = 0, rotation = 0, logit = 0, sh0 = 0, sh_rest = 0;
};
Difference difference(const Splats& a, const Splats& b) {
    Difference d;
    const auto largest = [](float& most, Vec3f x, Vec3f y) {
        for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::fabs(x[i] - y[i]));
    };
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest(d.mean, a.mean_m[i], b.mean_m[i]);
        largest(d.log_scale, a.log_scale[i], b.log_scale[i]);
        largest(d.sh0, a.sh0[i], b.sh0[i]);
        d.logit = std::max(d.logit, std::fabs(a.opacity_logit[i] - b.opacity_logit[i]));
        const Mat3f p = matrix_of(a.rotation[i]), q = matrix_of(b.rotation[i]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            d.rotation = std::max(
                d.rotation, std::min(length(p.column(axis) - q.column(axis)), length(p.column(axis) + q.column(axis))));
    }
    for (std::size_t i = 0; i < a.sh_rest.size(); ++i)
        d.sh_rest = std::max(d.sh_rest, std::fabs(a.sh_rest[i] - b.sh_rest[i]));
    return d;
}

TEST(SplatFormats, SpzRoundTripsWithinItsSteps) {
    for (const int version : {2, 3, 4})
        for (const int degree : {0, 1, 2, 3})
            for (const std::size_t count : {std::size_t{1}, std::size_t{700}}) {
                const Splats splats = some_splats(count, degree);
                save_splats(scratch("s.spz"), splats, {PlyBands::all, version});
                const LoadedSplats back = load_splats(scratch("s.spz"));
                ASSERT_EQ(back.splats.size(), count);
                ASSERT_EQ(back.splats.sh_degree, degree);
                EXPECT_EQ(back.format->name, "spz");
                EXPECT_EQ(back.cleaned.dropped, 0u);
                const Difference d = difference(splats, back.splats);
                EXPECT_LT(d.mean, 1.3e-4f);
                EXPECT_LT(d.log_scale, 0.0313f);
                EXPECT_LT(d.rotation, version == 2 ? 0.25f : 0.006f);
                EXPECT_LT(d.logit, 0.05f);
                EXPECT_LT(d.sh0, 0.0132f);
                EXPECT_LT(d.sh_rest, 0.068f);
            }
}

TEST(SplatFormats, PlyPreservesTheLowPass) {
    Splats splats = some_splats(300, 1);
    EXPECT_EQ(ply_comments(splats), "") << "nothing is said of the usual one";
    splats.filter.low_pass_px2 = 0.125f;
    for (const char* name : {"l.ply", "l.compressed.ply"}) {
        save_splats(scratch(name), splats);
        EXPECT_EQ(load_splats(scratch(name)).splats.filter, splats.filter) << name;
    }
    std::string bytes = read_file(scratch("l.ply"));
    bytes.replace(bytes.find("low-pass 0.125"), 14, "low-pass 1e-30");
    write_file(scratch("l.ply"), bytes);
    EXPECT_EQ(load_splats(scratch("l.ply")).splats.filter, FootprintFilter{}) << "out of range";
}

// Every format preserves the antialiasing flag, and does not add it.
TEST(SplatFormats, AntialiasingIsKept) {
    for (const bool antialias : {false, true}) {
        Splats splats = some_splats(300, 1);
        splats.filter.antialias = antialias;
        for (const char* name : {"a.ply", "a.compressed.ply", "a.spz", "a.glb"})
            for (const int version : {2, 3, 4}) {
                save_splats(scratch(name), splats, {PlyBands::present, version});
                EXPECT_EQ(load_splats(scratch(name)).splats.filter.antialias, antialias) << name << ' ' << version;
            }
        save_splat_ply(scratch("a.ply"), splats);
        EXPECT_EQ(read_file(scratch("a.ply")).find("\ncomment SplatRenderMode: mip\n") != std::string::npos, antialias);
        EXPECT_EQ(chosen(splats, {1, 2}).filter.antialias, antialias);
    }
}

// Postshot's spelling of the same.
TEST(SplatFormats, AntialiasingInPostshotsWords) {
    save_splat_ply(scratch("p.ply"), some_splats(2, 0));
    const std::string plain = read_file(scratch("p.ply"));
    for (const char* value : {"0", "1"}) {
        std::string bytes = plain;
        bytes.insert(bytes.find("element vertex"), std::string("comment antialiased ") + value + "\n");
        write_file(scratch("p.ply"), bytes);
        EXPECT_EQ(load_splats(scratch("p.ply")).splats.filter.antialias, value[0] == '1');
    }
}

TEST(SplatFormats, GlbRoundTripsToTheLastBits) {
    for (const int degree : {0, 1, 2, 3}) {
        const Splats splats = some_splats(200, degree);
        save_splats(scratch("s.glb"), splats);
        const LoadedSplats back = load_splats(scratch("s.glb"));
        ASSERT_EQ(back.splats.size(), 200u);
        ASSERT_EQ(back.splats.sh_degree, degree);
        const Difference d = difference(splats, back.splats);
        EXPECT_EQ(d.mean, 0.f);
        EXPECT_EQ(d.sh0, 0.f);
        EXPECT_EQ(d.sh_rest, 0.f);
        EXPECT_LT(d.log_scale, 1e-6f);
        EXPECT_LT(d.rotation, 1e-5f);
        EXPECT_LT(d.logit, 1e-5f);
    }
}

TEST(SplatFormats, ACompressedPlyHasAllBoundsOfItsColorsOrNone) {
    save_splats(scratch("b.compressed.ply"), some_splats(300, 0));
    std::string bytes = read_file(scratch("b.compressed.ply"));
    bytes.replace(bytes.find("max_b"), 5, "max_q");
    write_file(scratch("b.compressed.ply"), bytes);
    try {
        load_splats(scratch("b.compressed.ply"));
        FAIL() << "expected an error";
    } catch (const Error& e) {
        EXPECT_NE(std::string_view(e.what()).find("\"max_b\""), std::string_view::npos) << e.what();
    }
}

TEST(SplatFormats, CompressedPlyRoundTripsWithinItsSteps) {
    for (const int degree : {0, 1, 2, 3}) {
        const Splats splats = some_splats(600, degree);
        save_splats(scratch("s.compressed.ply"), splats);
        const LoadedSplats back = load_splats(scratch("s.compressed.ply"));
        EXPECT_EQ(back.format->name, "compressed_ply");
        ASSERT_EQ(back.splats.size(), 600u);
        ASSERT_EQ(back.splats.sh_degree, degree);
        // The order changes: each original is matched with its nearest splat.
        std::vector<std::uint32_t> order;
        for (std::size_t i = 0; i < splats.size(); ++i) {
            std::uint32_t best = 0;
            for (std::uint32_t k = 1; k < back.splats.size(); ++k)
                if (length(back.splats.mean_m[k] - splats.mean_m[i]) <
                    length(back.splats.mean_m[best] - splats.mean_m[i]))
                    best = k;
            order.push_back(best);
        }
        const Difference d = difference(splats, chosen(back.splats, order));
        EXPECT_LT(d.mean, 0.004f);
        EXPECT_LT(d.log_scale, 0.004f);
        EXPECT_LT(d.rotation, 0.006f);
        EXPECT_LT(d.logit, 0.05f);
        EXPECT_LT(d.sh0, 0.01f);
        EXPECT_LT(d.sh_rest, 0.02f);
    }
}

// Splats of a chunk share its bounds: a room's must not be quantized with the sky's.
TEST(SplatFormats, ARoomUnderAFarSkyKeepsItsPlacesInCompressedPly) {
    Splats splats = some_splats(3000, 0);
    std::size_t faint = 0;
    for (std::size_t i = 0; i < splats.size(); ++i, splats.log_scale[i - 1] = {-4, -4, -5})
        if (i % 10 == 3) splats.mean_m[i] = normalize(splats.mean_m[i]) * 400.f;
        else if (i % 10 == 7) splats.opacity_logit[i] = -6.f, ++faint;
    save_splats(scratch("far.compressed.ply"), splats);
    const Splats back = load_splats(scratch("far.compressed.ply")).splats;
    ASSERT_EQ(back.size(), splats.size());
    std::size_t lost = 0;
    for (std::size_t i = 0; i < splats.size(); ++i) {
        if (i % 10 == 3) continue;
        float nearest = 1e9f;
        for (const Vec3f p : back.mean_m) nearest = std::min(nearest, length(p - splats.mean_m[i]));
        const bool off = nearest > 0.01f;
        EXPECT_TRUE(!off || i % 10 == 7) << i << " is off by " << nearest;  // only hardly visible ones
        lost += off;
    }
    EXPECT_LT(lost, 256u);
    EXPECT_GT(faint, 256u);
}

// A splat without rotational symmetry, in the frame that each format's readers expect.
TEST(SplatFormats, AxesOfEachFormat) {
    Splats s = some_splats(1, 1);
    s.mean_m[0] = {1, 2, 3};
    s.rotation[0] = {0.5f, 0.1f, 0.7f, -0.5f};
    s.sh_rest = {0.25f, 0.5f, -0.25f, 0, 0, 0, 0, 0, 0};
    const std::string spz = spz_bytes(s, 4), glb = splat_glb_bytes(s);
    EXPECT_EQ(number_at<std::uint32_t>(spz, 0), 0x5053474eu);
    EXPECT_EQ(number_at<std::uint32_t>(spz, 4), 4u);
    // The position in glTF: x left, y up, z forward; the rotation k q with k a half turn about z, as x y z w.
    const std::size_t binary = 12 + 8 + number_at<std::uint32_t>(glb, 12) + 8;
    EXPECT_EQ(number_at<float>(glb, binary), -1.f);
    EXPECT_EQ(number_at<float>(glb, binary + 4), -2.f);
    EXPECT_EQ(number_at<float>(glb, binary + 8), 3.f);
    const std::size_t rotation = binary + 12 + 4;
    EXPECT_NEAR(number_at<float>(glb, rotation), -0.7f, 1e-6f);
    EXPECT_NEAR(number_at<float>(glb, rotation + 4), 0.1f, 1e-6f);
    EXPECT_NEAR(number_at<float>(glb, rotation + 8), 0.5f, 1e-6f);
    EXPECT_NEAR(number_at<float>(glb, rotation + 12), 0.5f, 1e-6f);
    const Json json = Json::parse(glb.substr(20, number_at<std::uint32_t>(glb, 12)));
    EXPECT_EQ(json["extensionsUsed"][0], "KHR_gaussian_splatting");
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["mode"], 0);
    EXPECT_EQ(json["accessors"][0]["max"][2], 3.0);
}

TEST(SplatFormats, SpzRefusesPlacesItCannotHold) {
    Splats s = some_splats(2, 0);
    s.mean_m[1].x = 2050;
    EXPECT_THROW(spz_bytes(s, 3), Error);
    const fs::path far_away = scratch("far.spz");
    try {
        save_splats(far_away, s);
        FAIL() << "expected an error";
    } catch (const Error& e) {
        EXPECT_NE(std::string_view(e.what()).find("far.spz: SPZ holds"), std::string_view::npos) << e.what();
    }
    EXPECT_FALSE(fs::exists(far_away));
}

TEST(SplatFormats, PlyInAnyColumnOrderAndEncoding) {
    // Text, shuffled columns, SH degree 1, two scales (2D Gaussians), doubles, followed by a mesh's faces.
    write_file(scratch("t.ply"),
               std::string_view(
                   "ply\r\nformat ascii 1.0\r\ncomment x\nelement vertex 1\nproperty float opacity\nproperty double "
                   "x\nproperty float rot_3\nproperty float rot_0\n"
                   "property float rot_1\nproperty float rot_2\nproperty float y\nproperty float z\nproperty float "
                   "scale_1\nproperty float scale_0\nproperty float f_dc_2\nproperty float f_dc_1\n"
                   "property float f_dc_0\nproperty float f_rest_8\nproperty float f_rest_0\nproperty float "
                   "f_rest_1\nproperty float f_rest_2\nproperty float f_rest_3\nproperty float f_rest_4\n"
                   "property float f_rest_5\nproperty float f_rest_6\nproperty float f_rest_7\nelement face "
                   "1\nproperty list uchar int vertex_indices\nend_header\n"
                   "0.5 1e0 4 1 2 3\n 2 3 -5 -4 12 11 10 .8 .0 .1 .2 .3 .4 .5 .6 .7\n3 0 1 2\n"));
    const Splats s = load_splats(scratch("t.ply")).splats;
    ASSERT_EQ(s.size(), 1u);
    EXPECT_EQ(s.mean_m[0], (Vec3f{1, 2, 3}));
    EXPECT_EQ(s.rotation[0], (Quatf{1, 2, 3, 4}));
    EXPECT_EQ(s.sh0[0], (Vec3f{10, 11, 12}));
    EXPECT_EQ(s.log_scale[0].x, -4.f);
    EXPECT_LT(s.log_scale[0].z, -9.f);
    EXPECT_EQ(s.sh_degree, 1);
    for (std::size_t k = 0; k < 9; ++k) EXPECT_FLOAT_EQ(s.sh_rest[k], 0.1f * static_cast<float>(k));

    // The other byte order.
    const Splats splats = some_splats(5, 2);
    save_splat_ply(scratch("b.ply"), splats, PlyBands::present);
    std::string bytes = read_file(scratch("b.ply"));
    bytes.replace(bytes.find("little"), 6, "big");
    for (std::size_t at = bytes.find("end_header") + 11; at < bytes.size(); at += 4)
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at) + 4);
    write_file(scratch("b.ply"), bytes);
    EXPECT_EQ(load_splats(scratch("b.ply")).splats, splats);
}

TEST(SplatFormats, NumbersThatCannotBeDrawnAreCounted) {
    Splats s = some_splats(6, 0);
    s.mean_m[1].y = std::numeric_limits<float>::quiet_NaN();
    s.log_scale[2].x = std::numeric_limits<float>::infinity();
    s.opacity_logit[3] = std::numeric_limits<float>::infinity();
    save_splat_ply(scratch("n.ply"), s);
    const LoadedSplats loaded = load_splats(scratch("n.ply"));
    EXPECT_EQ(loaded.splats.size(), 4u);
    EXPECT_EQ(loaded.cleaned.dropped, 2u);
    EXPECT_EQ(loaded.cleaned.repaired, 1u);
}

TEST(SplatFormats, GlbNodesTurnAndScale) {
    const Splats splats = some_splats(3, 1);
    std::string glb = splat_glb_bytes(splats);
    const std::uint32_t size = number_at<std::uint32_t>(glb, 12);
    Json json = Json::parse(glb.substr(20, size));
    const std::string binary = glb.substr(20 + size);
    const auto with_node = [&](const Json& node) {
        json["nodes"] = Json::array({{{"children", {1}}, {"translation", {1, 0, 0}}}, node});
        std::string text = json.dump(), out;
        text.append((4 - text.size() % 4) % 4, ' ');
        for (const std::uint32_t v : {0x46546c67u, 2u, static_cast<std::uint32_t>(20 + text.size() + binary.size()),
                                      static_cast<std::uint32_t>(text.size()), 0x4e4f534au})
            append(out, v);
        write_file(scratch("n.glb"), out + text + binary);
    };
    with_node({{"mesh", 0}, {"scale", {2, 2, 2}}, {"rotation", {0, 0, 0.70710678, 0.70710678}}});
    const Splats s = load_splats(scratch("n.glb")).splats;
    // glTF's (x, y, z) becomes 2 (-y, x, z) + (1, 0, 0); both have the world's -x and -y.
    EXPECT_NEAR(s.mean_m[0].x, -(2 * splats.mean_m[0].y + 1), 1e-5f);
    EXPECT_NEAR(s.mean_m[0].y, 2 * splats.mean_m[0].x, 1e-5f);
    EXPECT_NEAR(s.log_scale[0].x, splats.log_scale[0].x + std::log(2.f), 1e-5f);
    with_node({{"mesh", 0}, {"scale", {2, 1, 2}}});
    EXPECT_THROW(load_splats(scratch("n.glb")), Error);
    with_node({{"mesh", 0}, {"children", {0}}});  // a cycle
    EXPECT_THROW(load_splats(scratch("n.glb")), Error);
}

}  // namespace
}  // namespace fastscene
