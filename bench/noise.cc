// Noise: error of our pictures of a room relative to the converged light transport.
// bench_noise measure …: cached pictures at default settings, and path tracing at equal CPU time, against many paths
// bench_noise reference …: many paths each for random pixels of a large picture
// bench_noise standard …: the default picture against them, and two seeds of it against each other
// bench_noise export …: the room as plain triangles for another renderer (bench/peers/cycles.sh)
// bench_noise paths …: a path traced radiance picture, raw floats
// bench_noise compare …: raw pictures against a reference
// One JSON line on stdout.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstring>
#include <iostream>

#include "bench/noise_pixels.h"
#include "cpu_clock.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/base/parallel.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/trace/outdoors.h"
#include "fastscene/trace/texture.h"

using namespace fastscene;

namespace {

struct Flags {
    std::string prompt = "a modern living room with a gray sofa", out, reference;
    std::vector<std::string> pictures;
    std::uint64_t seed = 1;
    int height = 64, samples = 16, reference_samples = 1024, threads = 1, count = 2000;
    std::uint64_t second_seed = 0;
    bool plain = false, list_all = false;
    TraceParams trace{.cell_m = 0.03f, .cell_samples = 160, .pixel_samples = 16};  // as in `standard`
};

// Flat triangles and matt colors: features that any two renderers share.
void make_plain(Room& room) {
    room.sky.seen = 1;
    for (Material& m : room.materials) {
        const Vec3f albedo = mean_albedo(m), emission = m.emission;
        m = {};
        m.color_a = m.color_b = m.color_c = albedo;
        m.emission = emission;
        m.specular = 0;
        m.roughness = 1;
    }
    for (Mesh& mesh : room.meshes) {
        Mesh flat;
        flat.material = mesh.material;
        flat.object = mesh.object;
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const Vec3f a = mesh.positions[mesh.triangles[t]], b = mesh.positions[mesh.triangles[t + 1]],
                        c = mesh.positions[mesh.triangles[t + 2]];
            const Vec3f across = cross(b - a, c - a);
            if (!(length(across) > 1e-12f)) continue;
            for (const Vec3f p : {a, b, c}) {
                flat.triangles.push_back(static_cast<std::uint32_t>(flat.positions.size()));
                flat.positions.push_back(p);
                flat.normals.push_back(normalize(across));
                flat.coords.push_back(p);
            }
        }
        mesh = std::move(flat);
    }
}

Room room_of(const Flags& flags) {
    PromptSpec spec = understand_prompt(flags.prompt, false);
    fastscene::Run run;
    run.seed = flags.seed;
    Room room = make_room(spec, run);
    room.sky.sun_limit = room.sky.ground_least = 0;  // plain radiance: references know no exposure
    if (flags.plain) make_plain(room);
    return room;
}

void save_raw(const std::string& path, const ImageColor& image) {
    write_file(path,
               std::string_view(reinterpret_cast<const char*>(image.pixels.data()), image.size() * sizeof(Vec3f)));
}
ImageColor load_raw(const std::string& path, int height) {
    const std::string bytes = read_file(path);
    ImageColor image(2 * height, height);
    if (bytes.size() != image.size() * sizeof(Vec3f))
        throw Error("{}: expected {} bytes, found {}", path, image.size() * sizeof(Vec3f), bytes.size());
    std::memcpy(image.pixels.data(), bytes.data(), bytes.size());
    return image;
}

// Averages 4 x 4 pixels, linear.
ImageColor quarter(const ImageColor& image) {
    ImageColor out(image.width / 4, image.height / 4);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) out.at(x / 4, y / 4) += image.at(x, y) * (1.f / 16);
    return out;
}

double summed_luminance(const ImageColor& image) {
    double sum = 0;
    for (const Vec3f c : image.pixels) sum += static_cast<double>(luminance(c));
    return sum;
}

Json measure(const Flags& flags) {
    const EquirectSize size{2 * flags.height, flags.height}, fine{8 * flags.height, 4 * flags.height};
    const double start = cpu_seconds();
    TracedRoom room(room_of(flags)), other(room_of(flags));
    Run a, b;
    a.seed = 11;
    b.seed = 12;
    room.gather_light(flags.trace, a);
    const double gathered = cpu_seconds();
    const ImageColor cached = room.panorama({}, size, panorama_parts(flags.trace), a).color;
    const double shot = cpu_seconds();
    other.gather_light(flags.trace, b);
    // The same exposure for both; otherwise PSNR would measure its difference.
    TracedRoom second = std::move(other);
    const ImageColor again = second.panorama({}, size, panorama_parts(flags.trace), b).color;
    ShotParts paths{
        .color = true, .range = false, .pixel_samples = std::max(1, flags.reference_samples / 16), .paths = true};
    const double before = cpu_seconds();
    const ImageColor reference = quarter(room.panorama({}, fine, paths, a).color);
    const double reference_cost = cpu_seconds() - before;
    // Path tracing in the picture's share of the cached picture's time; the cache serves all views of the room.
    paths.pixel_samples = std::max(1, static_cast<int>(flags.reference_samples * (shot - start) / reference_cost));
    const ImageColor raw = room.panorama({}, size, paths, b).color;
    const auto bytes = [](const ImageColor& c) { return srgb8_from_linear(c); };
    if (!flags.out.empty()) {
        save_png(flags.out + ".cached.png", bytes(cached));
        save_png(flags.out + ".reference.png", bytes(reference));
        save_png(flags.out + ".raw.png", bytes(raw));
    }
    const double level = summed_luminance(reference), bias = summed_luminance(cached) - level;
    return {{"prompt", flags.prompt},
            {"cached_db", psnr(bytes(cached), bytes(reference))},
            {"two_seeds_db", psnr(bytes(cached), bytes(again))},
            {"raw_db", psnr(bytes(raw), bytes(reference))},
            {"raw_samples", paths.pixel_samples},
            {"mean_bias_percent", 100 * bias / level},
            {"gather_cpu_s", gathered - start},
            {"picture_cpu_s", shot - gathered},
            {"reference_cpu_s", reference_cost}};
}

bench::Lot lot_of(const Flags& flags) { return {flags.seed, flags.height, flags.count, flags.reference_samples}; }

Json reference(const Flags& flags) {
    return bench::trace_reference(TracedRoom(room_of(flags)), lot_of(flags), flags.reference);
}

Json standard(const Flags& flags) {
    const auto shot_of = [&](TracedRoom& room, std::uint64_t seed, Json& cost) {
        fastscene::Run run;
        run.seed = seed;
        const double start = cpu_seconds();
        room.gather_light(flags.trace, run);
        const double gathered = cpu_seconds();
        Shot shot = room.panorama({}, {2 * flags.height, flags.height}, panorama_parts(flags.trace), run);
        cost = {{"light_cpu_s", gathered - start}, {"picture_cpu_s", cpu_seconds() - gathered}};
        return shot;
    };
    TracedRoom room(room_of(flags));
    Json cost;
    const Shot shot = shot_of(room, 11, cost);
    Json out = bench::compare_with_reference(room, shot, lot_of(flags), flags.reference, flags.list_all);
    out["cost"] = cost;
    const ImageRgb8 shown = srgb8_from_linear(shot.color);
    if (!flags.out.empty()) save_png(flags.out, shown);
    if (flags.second_seed) {
        TracedRoom other(room_of(flags));
        out["two_seeds_db"] = psnr(shown, srgb8_from_linear(shot_of(other, flags.second_seed, cost).color));
    }
    return out;
}

// Blender's axes: x right, y forward, z up.
Vec3f blender_from_world(Vec3f p) { return {p.x, p.z, -p.y}; }

Json export_room(const Flags& flags) {
    const Room room = room_of(flags);
    std::vector<float> corners;
    Json meshes = Json::array();
    for (const Mesh& mesh : room.meshes) {
        const Material& m = room.materials[static_cast<std::size_t>(mesh.material)];
        meshes.push_back({{"first", corners.size() / 9},
                          {"triangles", mesh.triangles.size() / 3},
                          {"albedo", {m.color_a.x, m.color_a.y, m.color_a.z}},
                          {"emission", {m.emission.x, m.emission.y, m.emission.z}}});
        for (const std::uint32_t i : mesh.triangles) {
            const Vec3f p = blender_from_world(mesh.positions[i]);
            corners.insert(corners.end(), {p.x, p.y, p.z});
        }
    }
    // The sky in Cycles' mapping: u against the azimuth, v up from the nadir.
    constexpr int kSkyHeight = 1024;
    const Outdoors outdoors(room, 0);
    std::vector<float> sky;
    for (int y = 0; y < kSkyHeight; ++y)
        for (int x = 0; x < 2 * kSkyHeight; ++x) {
            const float a = -((static_cast<float>(x) + 0.5f) / (2 * kSkyHeight) - 0.5f) * 2 * kPi;
            const float t = ((static_cast<float>(y) + 0.5f) / kSkyHeight - 0.5f) * kPi;
            const Vec3f d{std::cos(a) * std::cos(t), std::sin(a) * std::cos(t), std::sin(t)};
            const Vec3f c = outdoors.light({d.x, -d.z, d.y});
            sky.insert(sky.end(), {c.x, c.y, c.z, 1.f});
        }
    Json portals = Json::array();
    const auto vec = [](Vec3f v) { return Json{v.x, v.y, v.z}; };
    for (const Portal& p : room.portals)
        portals.push_back({{"corner", vec(blender_from_world(p.corner))},
                           {"u", vec(blender_from_world(p.edge_u))},
                           {"v", vec(blender_from_world(p.edge_v))}});
    make_directories(flags.out);
    const auto raw = [](const std::vector<float>& v) {
        return std::string_view(reinterpret_cast<const char*>(v.data()), v.size() * sizeof(float));
    };
    write_file(flags.out + "/triangles.f32", raw(corners));
    write_file(flags.out + "/sky.f32", raw(sky));
    write_json(flags.out + "/room.json", {{"meshes", meshes},
                                          {"portals", portals},
                                          {"sky_height", kSkyHeight},
                                          {"sun_direction", vec(blender_from_world(room.sky.sun_dir))},
                                          {"sun_irradiance", vec(room.sky.sun_irradiance)}});
    return {{"triangles", corners.size() / 9}};
}

Json paths(const Flags& flags) {
    const TracedRoom room(room_of(flags));
    fastscene::Run run;
    run.seed = flags.seed + 100;
    const double start = cpu_seconds();
    const ShotParts parts{
        .color = true, .range = false, .pixel_samples = flags.samples, .paths = true, .radiance = true};
    save_raw(flags.out, room.panorama({}, {2 * flags.height, flags.height}, parts, run).color);
    return {{"samples", flags.samples}, {"cpu_s", cpu_seconds() - start}};
}

// In sRGB, after an exposure that maps the reference's median to a third: as pictures are viewed.
Json compare(const Flags& flags) {
    const ImageColor reference = load_raw(flags.reference, flags.height);
    std::vector<float> values;
    for (const Vec3f c : reference.pixels) values.push_back(luminance(c));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    const float gain = 0.33f / std::max(1e-6f, values[values.size() / 2]);
    const auto shown = [&](ImageColor image) {
        for (Vec3f& c : image.pixels) c = c * gain;
        return srgb8_from_linear(image);
    };
    Json out = Json::array();
    for (const std::string& path : flags.pictures) {
        const ImageColor picture = load_raw(path, flags.height);
        const double mse = mean_squared_error(shown(picture), shown(reference));
        out.push_back({{"picture", path},
                       {"mse", mse},
                       {"psnr", psnr_of_mse(mse)},
                       {"mean_ratio", summed_luminance(picture) / summed_luminance(reference)}});
        save_png(path + ".png", shown(picture));
    }
    return out;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How far our pictures of a room are from the light's true average.", "bench_noise");
    app.require_subcommand(1);
    Flags flags;
    std::vector<std::pair<CLI::App*, Json (*)(const Flags&)>> verbs;
    const auto add = [&](const char* name, Json (*act)(const Flags&)) {
        verbs.push_back({app.add_subcommand(name), act});
    };
    add("measure", measure);
    add("reference", reference);
    add("standard", standard);
    add("export", export_room);
    add("paths", paths);
    add("compare", compare);
    for (auto& [verb, act] : verbs) {
        verb->add_option("--prompt", flags.prompt);
        verb->add_option("--seed", flags.seed);
        verb->add_option("--height", flags.height, "Of the panorama, in pixels.");
        verb->add_option("--samples", flags.samples, "Paths a pixel.");
        verb->add_option("--reference-samples", flags.reference_samples, "Paths a pixel of the reference.");
        verb->add_option("--threads", flags.threads);
        verb->add_flag("--plain", flags.plain, "Flat triangles, matt colors.");
        verb->add_option("--cell", flags.trace.cell_m);
        verb->add_option("--cell-samples", flags.trace.cell_samples);
        verb->add_flag("--keep-noise", flags.trace.keep_noise, "No denoiser.");
        verb->add_option("--count", flags.count, "Pixels of the lot.");
        verb->add_flag("--list-all", flags.list_all, "Names all pixels of the lot, not the worst hundredth.");
        verb->add_option("--second-seed", flags.second_seed, "Makes the picture once more, with this seed.");
        verb->add_option("--reference", flags.reference);
        verb->add_option("--pictures", flags.pictures);
        verb->add_option("-o,--out", flags.out);
    }
    CLI11_PARSE(app, argc, argv);
    try {
        set_threads(flags.threads);
        for (auto& [verb, act] : verbs)
            if (verb->parsed()) std::cout << act(flags).dump() << std::endl;
    } catch (const std::exception& e) {
        std::cerr << "bench_noise: " << e.what() << std::endl;
        return 1;
    }
}
