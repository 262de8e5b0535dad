// A digest of each room that a list of prompts makes, to find out whether and which rooms a code change affects.
//
// room_digest [--seeds 2] FILE… > before; …; room_digest FILE…
// diff before -
//
// One line per room: digest, seed, prompt. The digest covers every vertex, material, object and light, how the prompt
// was understood, and what was placed. Empty lines of FILE and those starting with # are skipped.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "fastscene/base/hash.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene {
namespace {

void add(Hash& h, Vec3f v) { h.add(v.x).add(v.y).add(v.z); }
template <class T>
void add_all(Hash& h, const std::vector<T>& values) {
    h.add_bytes(values.data(), values.size() * sizeof(T));
}

void add(Hash& h, const Material& m) {
    h.add(m.name).add(static_cast<int>(m.pattern));
    for (const Vec3f& color : {m.color_a, m.color_b, m.color_c, m.emission}) add(h, color);
    for (const float value :
         {m.scale_m, m.bump_m, m.roughness, m.specular, m.metal, m.transmission, m.mirror, m.crease_m, m.sheen})
        h.add(value);
    h.add(m.burns).add(m.seed).add(static_cast<int>(m.variant));
    if (m.image)
        for (const ImageRgb8& level : m.image->levels) add_all(h, level.pixels);
}

std::string digest(const std::string& prompt, std::uint64_t seed) {
    Hash h;
    PromptSpec spec = understand_prompt(prompt, false);
    Run run;
    run.seed = seed;
    const Room room = make_room(spec, run);
    h.add(to_json(spec).dump()).add(room_json(room, {}).dump());
    for (const Material& m : room.materials) add(h, m);
    for (const Mesh& m : room.meshes) {
        add_all(h, m.positions);
        add_all(h, m.normals);
        add_all(h, m.coords);
        add_all(h, m.triangles);
        h.add(m.material).add(m.object);
    }
    for (const Portal& p : room.portals) {
        add(h, p.corner);
        add(h, p.edge_u);
        add(h, p.edge_v);
    }
    const Sky& sky = room.sky;
    for (const Vec3f& v : {sky.sun_dir, sky.sun_irradiance, sky.zenith, sky.horizon, sky.ground}) add(h, v);
    h.add(static_cast<int>(sky.time)).add(static_cast<int>(sky.view)).add(sky.snow).add(sky.seed);
    for (const float value : {sky.clouds, sky.seen, sky.sun_limit, sky.ground_least}) h.add(value);
    const Look& look = room.look;
    add(h, look.white);
    for (const float value : {look.exposure_ev, look.contrast, look.saturation, look.outside_seen, look.sun_seen})
        h.add(value);
    return h.hex();
}

int digest_all(const std::vector<std::string>& files, int seeds) {
    for (const std::string& file : files) {
        std::ifstream in(file);
        if (!in) {
            std::fprintf(stderr, "room_digest: cannot read %s\n", file.c_str());
            return 1;
        }
        for (std::string line; std::getline(in, line);) {
            if (line.empty() || line[0] == '#') continue;
            line = line.substr(0, line.find('\t'));
            for (int seed = 0; seed < seeds; ++seed) {
                std::string said;
                try {
                    said = digest(line, static_cast<std::uint64_t>(seed));
                } catch (const std::exception& error) {
                    said = std::string("refused: ") + error.what();
                }
                std::printf("%s %d %s\n", said.c_str(), seed, line.c_str());
                std::fflush(stdout);
            }
        }
    }
    return 0;
}

}  // namespace
}  // namespace fastscene

int main(int argc, char** argv) {
    CLI::App app{"A digest of each room that a list of prompts makes"};
    std::vector<std::string> files;
    int seeds = 1;
    app.add_option("FILE", files, "prompts, one a line")->required();
    app.add_option("--seeds", seeds, "rooms a prompt: seeds 0, 1, ...")->check(CLI::Range(1, 1000));
    CLI11_PARSE(app, argc, argv);
    return fastscene::digest_all(files, seeds);
}
