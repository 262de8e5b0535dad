#include "fastscene/evaluate/peers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "fastscene/base/file.h"
#include "fastscene/evaluate/measures.h"
#include "fastscene/evaluate/stills.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// What the peer has of a scene: a folder of pictures or a splat file; empty: nothing.
fs::path contribution(const SuitePeer& peer, const std::string& scene) {
    if (fs::is_directory(peer.folder / scene)) return peer.folder / scene;
    for (const char* end : {".ply", ".compressed.ply", ".spz", ".glb"})
        if (const fs::path file = peer.folder / (scene + end); fs::exists(file)) return file;
    return {};
}

double minutes_of(const SuitePeer& peer) {
    const fs::path file = peer.folder / "minutes.txt";
    const std::string text = read_file(file);
    char* end = nullptr;
    const double minutes = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || !(minutes >= 0) || !std::isfinite(minutes)) throw Error("{}: expected a number of minutes, found \"{}\"", file.string(), text.substr(0, 40));
    return minutes;
}

// Its splats through the suite's cameras.
fs::path drawn(const fs::path& splats, const fs::path& work, const StillsParams& p, const Run& run) {
    constexpr int kPanoramaWidth = 2048;  // a peer has none: pictures as fine as those of a standard scene
    make_directories(work);
    const Json params{{"count", p.count}, {"size", p.size_px}, {"fov", p.fov_deg}, {"radius", p.radius_m}, {"file", splats.string()}, {"bytes", fs::file_size(splats)},
                      {"time", fs::last_write_time(splats).time_since_epoch().count()}};
    run_stage(work, "stills", stage_key("metrics", params, {}, 0), run, [&](const fs::path& to) {
        save_walked_stills(to / "walked", load_splats(splats).splats, p, still_camera(p, kPanoramaWidth), {}, run);
    });
    return work / "stills" / "walked";
}

}  // namespace

void check_peer(const SuitePeer& peer, const Suite& suite) {
    if (!fs::is_directory(peer.folder)) throw UsageError("--peer {}: expected a folder, found none at {}", peer.name, peer.folder.string());
    if (!suite.has("stills")) throw UsageError("--peer {}: expected a suite that measures stills, found {}", peer.name, suite.name);
    std::string names;
    for (const SuiteScene& scene : suite.scenes) {
        if (!contribution(peer, scene.name).empty()) return;
        names += (names.empty() ? "" : ", ") + scene.name;
    }
    throw UsageError("--peer {}: expected pictures in {}/SCENE/ or splats in {}/SCENE.ply for a SCENE of {}, found none", peer.name, peer.folder.string(), peer.folder.string(), names);
}

std::vector<Json> peer_records(const SuitePeer& peer, const Suite& suite, const fs::path& out, const fs::path& weights, const Run& run) {
    std::vector<Json> records;
    for (const SuiteScene& scene : suite.scenes) {
        const fs::path given = contribution(peer, scene.name);
        if (given.empty()) continue;
        Json record{{"variant", peer.name}, {"kind", "peer"}, {"scene", scene.name}, {"seed", 0}, {"prompt", scene.source.prompt}, {"folder", given.string()}};
        try {
            const fs::path work = out / "measured" / "peers" / slug_of(peer.name) / scene.name;
            const fs::path pictures = fs::is_directory(given) ? given : drawn(given, work, suite.stills, run);
            Measured measured = measure_pictures({&suite, out, work, {}, false, weights, scene.source.prompt}, pictures, run);
            if (fs::exists(peer.folder / "minutes.txt")) measured.samples.push_back({"", "", {}, {{"minutes", minutes_of(peer)}}, {}});
            record.update(json_of(measured));
        } catch (const Error& e) {
            record["failed"] = e.what();
            run.warn(fmt::format("{}, {}: {}", peer.name, scene.name, e.what()));
        }
        records.push_back(std::move(record));
    }
    return records;
}

}  // namespace fastscene
