// Robustness of readers: files truncated at every length, with flipped bits and huge numbers. The result must be an
// Error naming the file, or valid data; never a crash, nor memory allocated for data that do not exist (the sanitizer
// builds run this too).
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/gzip.h"
#include "fastscene/io/ply.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/test_scratch.h"
#include "fastscene/io/view_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

Splats nine_splats(int degree) {
    Random random(2, "splats");
    Splats s;
    s.sh_degree = degree;
    s.resize(9);
    for (std::size_t i = 0; i < s.size(); ++i)
        s.mean_m[i] = {random.normal(), random.normal(), random.normal()}, s.rotation[i].x = random.normal();
    for (float& f : s.sh_rest) f = random.normal();
    return s;
}

// A damaged copy of `whole`; `n` selects the kind of damage.
std::string damaged(const std::string& whole, int n, Random& random) {
    std::string bytes = whole;
    const auto at = [&] { return static_cast<std::size_t>(random.index(static_cast<int>(bytes.size()))); };
    switch (n % 5) {
        case 0: bytes[at()] ^= static_cast<char>(1 << random.index(8)); break;
        case 1: bytes[at()] = static_cast<char>(random.index(256)); break;
        case 2: bytes.resize(at()); break;
        case 3:  // a huge or negative number
            for (std::size_t i = at(), k = 0; k < (n % 2 ? 4u : 8u) && i < bytes.size(); ++i, ++k)
                bytes[i] = static_cast<char>(n % 3 ? 0xff : 0x7f);
            break;
        default: bytes.insert(at(), bytes.substr(at(), static_cast<std::size_t>(random.index(40)))); break;
    }
    return bytes;
}

// `pack` is applied after the damage, so that damage inside a compressed stream passes its checksum. Errors must name
// the file, or a file in its folder that no longer matches.
void damage(const fs::path& file, const std::string& whole, const std::function<void()>& load,
            const std::function<std::string(const std::string&)>& pack = {}, bool neighbours = false) {
    const auto try_one = [&](const std::string& bytes) {
        write_file(file, pack ? pack(bytes) : bytes);
        try {
            load();
            return false;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find((neighbours ? file.parent_path() : file).string()), std::string::npos)
                << e.what();
            return true;
        }
    };
    ASSERT_FALSE(try_one(whole)) << file << ": the whole file is refused";
    int refused = 0;
    for (std::size_t keep = 0; keep < whole.size(); keep += 1 + whole.size() / 80)
        refused += try_one(whole.substr(0, keep));
    EXPECT_GT(refused, 40) << file;
    Random random(11, file.filename().string());
    for (int n = 0; n < 500; ++n) try_one(damaged(whole, n, random));
    write_file(file, whole);
}

TEST(Damage, Spz) {
    for (const int degree : {0, 3}) {
        for (const int version : {2, 3, 4}) {
            const fs::path file = scratch(fmt::format("s{}{}.spz", version, degree));
            const std::string whole = spz_bytes(nine_splats(degree), version);
            damage(file, whole, [&] { (void)load_splats(file); });
            if (version < 4)
                damage(
                    file, inflated(whole, "bytes"), [&] { (void)load_splats(file); }, gzipped);
        }
    }
}

TEST(Damage, RecordsOfSpzAndKsplat) {
    const fs::path spz = scratch("r.spz"), ksplat = scratch("k.ksplat");
    std::string records = inflated(spz_bytes(nine_splats(1), 3), "bytes");
    records[14] = static_cast<char>(records[14] | 2);  // has records
    for (const std::uint32_t v : {0xadbe0003u, 4u, 6u, 0xadbe0002u, 4u, 0u}) append(records, v);
    damage(
        spz, records, [&] { (void)load_splats(spz); }, gzipped);
    save_splats(ksplat, nine_splats(2));
    damage(ksplat, read_file(ksplat), [&] { (void)load_splats(ksplat); });
}

// A few bytes that claim ten million splats must be refused before memory is allocated.
TEST(Damage, PromisesOfSpzAreNotBelieved) {
    std::string header;
    for (const std::uint32_t v : {0x5053474eu, 3u, 4000000000u, 0x0c03u}) append(header, v);
    write_file(scratch("p.spz"), gzipped(header));
    EXPECT_THROW(load_splats(scratch("p.spz")), Error);
    std::string four;
    for (const std::uint32_t v : {0x5053474eu, 4u, 4000000000u, 0x06000c03u, 32u, 0u, 0u, 0u}) append(four, v);
    for (const std::uint64_t bytes : {9u, 1u, 3u, 3u, 4u, 45u})
        append(four, std::uint64_t{10}), append(four, bytes * 4000000000u);
    four.append(60, '\0');
    write_file(scratch("q.spz"), four);
    EXPECT_THROW(load_splats(scratch("q.spz")), Error);
}

TEST(Damage, Glb) {
    for (const int degree : {0, 1}) {
        const fs::path file = scratch(fmt::format("g{}.glb", degree));
        damage(file, splat_glb_bytes(nine_splats(degree)), [&] { (void)load_splats(file); });
    }
}

TEST(Damage, Ply) {
    const fs::path file = scratch("p.ply");
    save_compressed_ply(file, nine_splats(2));
    damage(file, read_file(file), [&] { (void)load_splats(file); });
    save_splat_ply(file, nine_splats(1), PlyBands::present);
    damage(file, read_file(file), [&] { (void)load_splats(file); });
    std::string text = "ply\nformat ascii 1.0\nelement vertex 3\n";
    for (const char* name : {"x", "y", "z", "f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "scale_1", "scale_2",
                             "rot_0", "rot_1", "rot_2", "rot_3"})
        text += fmt::format("property float {}\n", name);
    text += "end_header\n";
    for (int row = 0; row < 3; ++row) text += "1 2 3 0.1 0.2 0.3 1 -3 -3 -4 1 0 0 0\n";
    damage(file, text, [&] { (void)load_splats(file); });
    // More rows than a file of that size could hold.
    write_file(file, std::string_view(
                         "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n1 2 3\n"));
    EXPECT_THROW(load_splats(file), Error);
}

TEST(Damage, PlyHeadersAsProgramsWriteThem) {
    const fs::path file = scratch("h.ply");
    save_splat_ply(file, nine_splats(1), PlyBands::present);
    const std::string whole = read_file(file);
    const auto with = [&](const std::string& old_text, const std::string& new_text) {
        std::string text = whole;
        text.replace(text.find(old_text), old_text.size(), new_text);
        write_file(file, text);
        return load_splats(file).splats.size();
    };
    const std::string count = fmt::format("element vertex {}\n", nine_splats(1).size());
    EXPECT_EQ(with("ply\n", "ply\ncomment before the format\n"), nine_splats(1).size());
    EXPECT_EQ(with(count, "comment " + std::string(5000, 'x') + "\n" + count), nine_splats(1).size());
    for (const char* number : {"-1", "2.5", "0x10", "1e3", ""})
        EXPECT_THROW(with(count, fmt::format("element vertex {}\n", number)), Error) << number;
    write_file(file, std::string_view("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n+-1\n"));
    EXPECT_THROW(Ply{file}, Error);
    write_file(file, std::string_view("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n+1.5\n"));
    const Ply plus(file);
    EXPECT_EQ(plus.value(plus.element("vertex"), 0, 0), 1.5);
}

TEST(Damage, ColmapTextAndBinary) {
    ViewSet set;
    for (int i = 0; i < 3; ++i) {
        View view;
        view.name = fmt::format("{}.png", i);
        view.camera = Pinhole::with_fov(4, 4, 90);
        view.color = ImageRgb8(4, 4);
        set.views.push_back(view);
    }
    set.points = {{{1, 2, 3}, {0, 1, 0}, {1, 2, 3}, 0.1f}, {{1, 2, 4}, {0, 1, 0}, {1, 2, 3}, 0.1f}};
    const fs::path dir = scratch("views");
    fs::remove_all(dir);
    save_views(dir, set);
    const fs::path model = dir / "sparse" / "0";
    for (const char* ending : {".bin", ".txt"}) {
        for (const char* part : {"cameras", "images", "points3D"}) {
            const fs::path file = model / (std::string(part) + ending);
            const std::string whole = read_file(file);
            // A truncated text may still be complete, unless cut within a line; so texts are damaged, not counted.
            if (std::string(ending) == ".txt") {
                Random random(12, part);
                for (int n = 0; n < 400; ++n) {
                    write_file(file, damaged(whole, n, random));
                    try {
                        (void)load_colmap_capture(dir, {});
                    } catch (const Error& e) {
                        EXPECT_NE(std::string(e.what()).find(model.string()), std::string::npos) << e.what();
                    }
                }
                write_file(file, whole);
            } else {
                damage(
                    file, whole, [&] { (void)load_colmap_capture(dir, {}); }, {}, true);
            }
        }
        for (const char* part : {"cameras", "images", "points3D"}) fs::remove(model / (std::string(part) + ".bin"));
    }
}

// The COLMAP (binary, text) and nerfstudio files written by save_views describe the same cameras, to float precision.
TEST(Captures, ColmapAndNerfstudioSayTheSameCameras) {
    ViewSet set;
    for (int i = 0; i < 6; ++i) {
        View view;
        view.name = fmt::format("{}.png", i);
        view.camera = Pinhole::with_fov(8, 6, 60.f + 5.f * static_cast<float>(i));
        view.world_from_camera = {
            rotation_about(normalize(Vec3f{1, 2, static_cast<float>(i)}), 0.9f * static_cast<float>(i)),
            {0.3f, -0.2f * static_cast<float>(i), 1}};
        view.color = ImageRgb8(8, 6);
        set.views.push_back(view);
    }
    set.points = {{{1, 2, 3}, {0, 1, 0}, {10, 20, 30}, 0.1f}, {{4, 5, 6}, {0, 1, 0}, {40, 50, 60}, 0.1f}};
    const fs::path dir = scratch("same");
    fs::remove_all(dir);
    save_views(dir, set);
    const Capture binary = load_colmap_capture(dir, {}), nerf = load_nerfstudio_capture(dir, {});
    for (const char* part : {"cameras", "images", "points3D"})
        fs::remove(dir / "sparse" / "0" / (std::string(part) + ".bin"));
    const Capture text = load_colmap_capture(dir, {});
    for (const Capture* other : {&nerf, &text}) {
        ASSERT_EQ(other->photos.size(), 6u);
        ASSERT_EQ(other->points.size(), 2u);
        EXPECT_NEAR(length(other->points[1].position - Vec3d{4, 5, 6}), 0, 1e-6);
        EXPECT_EQ(other->points[1].color, (Rgb8{40, 50, 60}));
        for (std::size_t i = 0; i < 6; ++i) {
            const Photo &a = binary.photos[i], &b = other->photos[i];
            EXPECT_EQ(a.file, b.file);
            EXPECT_NEAR(a.lens.fx, b.lens.fx, 1e-5);
            EXPECT_NEAR(length(a.world_from_camera.translation - b.world_from_camera.translation), 0, 1e-6);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(length(a.world_from_camera.rotation.column(c) - b.world_from_camera.rotation.column(c)), 0,
                            1e-6);
            const Mat3f& truth = set.views[i].world_from_camera.rotation;
            EXPECT_NEAR(
                length(a.world_from_camera.rotation.column(2) - Vec3d{truth.row0.z, truth.row1.z, truth.row2.z}), 0,
                1e-6);
        }
    }
}

TEST(Damage, TransformsJson) {
    const fs::path dir = scratch("nerf"), file = dir / "transforms.json";
    fs::create_directories(dir);
    std::string whole =
        R"({"camera_model": "OPENCV", "fl_x": 20, "fl_y": 21, "cx": 4, "cy": 3, "w": 8, "h": 6, "k1": 0.1,)"
        R"( "frames": [)";
    for (int i = 0; i < 3; ++i)
        whole += fmt::format(
            R"({}{{"file_path": "i/{}.png", "transform_matrix": [[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]]}})",
            i ? "," : "", i);
    whole += "]}";
    damage(file, whole, [&] { (void)load_nerfstudio_capture(file, {}); });
    for (const char* odd :
         {"[]", "{}", "null", "3", "{\"frames\": 3}", "{\"frames\": [3]}", "{\"frames\": [{\"file_path\": 3}]}",
          "{\"frames\": [{\"file_path\": \"a\", \"transform_matrix\": [[1]]}]}"}) {
        write_file(file, std::string_view(odd));
        EXPECT_THROW(load_nerfstudio_capture(file, {}), Error) << odd;
    }
    write_file(file, std::string(1000000, '['));  // deeper than any stack
    EXPECT_THROW(load_nerfstudio_capture(file, {}), Error);
}

TEST(Damage, Photogrammetry) {
    const fs::path dir = scratch("photogrammetry"), csv = dir / "c.csv", xml = dir / "c.xml";
    fs::create_directories(dir / "images");
    std::string table = "#name,x,y,alt,heading,pitch,roll,f,px,py,k1,k2,k3,k4,t1,t2\n";
    for (int i = 0; i < 4; ++i) table += fmt::format("{}.png,1,2,3,10,80,5,28,0.01,0,0.1,0,0,0,0,0\n", i);
    const auto survives = [](const std::string& whole, const fs::path& file, auto load) {
        Random random(7, file.string());
        for (int n = 0; n < 400; ++n) {
            write_file(file, damaged(whole, n, random));
            try {
                (void)load(file, CaptureFolders{});
            } catch (const Error& e) {
                EXPECT_NE(std::string(e.what()).find(file.string()), std::string::npos) << e.what();
            }
        }
    };
    survives(table, csv, load_realityscan_capture);
    std::string cameras = R"(<document><chunk><sensors><sensor id="0" type="frame"><resolution width="64" height="48"/>
<calibration class="adjusted"><f>50</f><k1>0.1</k1></calibration></sensor></sensors><components><component id="0">
<transform><rotation>1 0 0 0 1 0 0 0 1</rotation><translation>1 2 3</translation><scale>2</scale></transform></component>
</components><cameras>)";
    for (int i = 0; i < 4; ++i)
        cameras += fmt::format(
            "<camera id=\"{0}\" sensor_id=\"0\" component_id=\"0\" label=\"{0}\">"
            "<transform>1 0 0 "
            "{0} 0 1 0 0 0 0 1 0 0 0 0 1</transform></camera>",
            i);
    survives(cameras + "</cameras></chunk></document>", xml, load_metashape_capture);
}

}  // namespace
}  // namespace fastscene
