#include "fastscene/evaluate/peers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "fastscene/base/file.h"
#include "fastscene/base/leading_number.h"
#include "fastscene/evaluate/failure.h"
#include "fastscene/evaluate/measures.h"
#include "fastscene/io/splat_format.h"
#include "fastscene/metrics/images.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

bool is_source(const fs::path& file) { return file.stem() == "source"; }

// The peer's files for a scene; `pictures` may also contain source.png.
OtherScene contribution(const SuitePeer& peer, const std::string& scene) {
    OtherScene other;
    const fs::path folder = peer.folder / scene;
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder)) {
            const std::string end = slug_of(entry.path().extension().string());
            if (end != "png" && end != "jpg" && end != "jpeg") continue;
            if (is_source(entry.path())) other.sphere = entry.path();
            else other.pictures = folder;
        }
    for (const SplatFormat& format : registered<SplatFormat>())
        if (const fs::path file = peer.folder / (scene + format.ending); fs::exists(file)) {
            other.splats = file;
            break;
        }
    return other;
}

bool is_empty(const OtherScene& other) {
    return other.pictures.empty() && other.sphere.empty() && other.splats.empty();
}

// The stills, without the panorama in the same folder.
fs::path stills_alone(const OtherScene& other, const fs::path& work) {
    if (other.pictures.empty() || other.sphere.empty()) return other.pictures;
    const fs::path alone = work / "given";
    fs::remove_all(alone);
    make_directories(alone);
    for (const fs::path& file : pictures_in(other.pictures, "stills"))
        if (!is_source(file)) fs::copy_file(file, alone / file.filename());
    return alone;
}

double minutes_in(const fs::path& file) {
    const std::string text = read_file(file);
    const double minutes = number_in(text).value_or(-1);
    if (!(minutes >= 0) || !std::isfinite(minutes))
        throw Error("{}: expected a number of minutes, found \"{}\"", file.string(), text.substr(0, 40));
    return minutes;
}

// The peer's duration: for this scene, or one figure for all.
void add_minutes(const SuitePeer& peer, const std::string& scene, Measured& measured) {
    const fs::path own = peer.folder / scene / "minutes.txt", all = peer.folder / "minutes.txt";
    if (!fs::exists(own) && !fs::exists(all)) return;
    Sample sample;
    sample.shared = !fs::exists(own);
    sample.values["minutes"] = minutes_in(sample.shared ? all : own);
    if (sample.shared) sample.notes["minutes"] = {"one figure for all its scenes"};
    measured.samples.push_back(std::move(sample));
}

Json record_of(const SuitePeer& peer, const SuiteScene& scene, const OtherScene& other, const PeerInputs& inputs,
               const Run& run) {
    const fs::path given = other.splats.empty() ? peer.folder / scene.name : other.splats;
    Json record{{"variant", peer.name},
                {"kind", "peer"},
                {"scene", scene.name},
                {"seed", 0},
                {"prompt", prompt_of(scene.source)},
                {"folder", given.string()}};
    try {
        const fs::path work = inputs.out / "measured" / "peers" / folder_name_of(peer.name) / scene.name;
        const std::optional<OwnRun> own = inputs.own_run(scene);
        if (own) record["cameras"] = own->folder.root.generic_string();
        const MeasureInputs measure{.suite = &inputs.suite,
                                    .out = inputs.out,
                                    .work = work,
                                    .truth = own ? own->truth : fs::path(),
                                    .weights = inputs.weights,
                                    .prompt = prompt_of(scene.source)};
        const OtherScene judged{stills_alone(other, work), other.sphere, other.splats};
        const int width = inputs.suite.variants.front().params.panorama.width;
        Measured measured = measure_other(measure, judged, own ? std::optional(own->folder) : std::nullopt, width, run);
        add_minutes(peer, scene.name, measured);
        record.update(json_of(measured));
    } catch (const Stopped&) {
        throw;
    } catch (const std::exception& e) {
        record["failed"] = failure_text(e);
        run.warn(fmt::format("{}, {}: {}", peer.name, scene.name, failure_text(e)));
    }
    return record;
}

void check_peer(const SuitePeer& peer, const Suite& suite) {
    if (!fs::is_directory(peer.folder))
        throw UsageError("--peer {}: expected a folder, found none at {}", peer.name, peer.folder.string());
    if (!suite.has("stills") && !suite.has("source") && !suite.has("held-out"))
        throw UsageError("--peer {}: expected a suite that measures stills, source or held-out, found {}", peer.name,
                         suite.name);
    std::string names;
    for (const SuiteScene& scene : suite.scenes) {
        if (!is_empty(contribution(peer, scene.name))) return;
        names += (names.empty() ? "" : ", ") + scene.name;
    }
    throw UsageError(
        "--peer {}: expected pictures in {}/SCENE/ or splats in {}/SCENE.ply for a SCENE of {}, found none", peer.name,
        peer.folder.string(), peer.folder.string(), names);
}

}  // namespace

void check_peers(const std::vector<SuitePeer>& peers, const Suite& suite) {
    std::set<std::string> rows;
    for (const SuiteVariant& variant : suite.variants) rows.insert(folder_name_of(variant.name));
    for (const SuitePeer& peer : peers) {
        if (!rows.insert(folder_name_of(peer.name)).second)
            throw UsageError("--peer {}: expected a name of its own, found another row of this name", peer.name);
        check_peer(peer, suite);
    }
}

std::vector<Json> peer_records(const SuitePeer& peer, const PeerInputs& inputs, const Run& run) {
    std::vector<Json> records;
    for (const SuiteScene& scene : inputs.suite.scenes)
        if (const OtherScene other = contribution(peer, scene.name); !is_empty(other))
            records.push_back(record_of(peer, scene, other, inputs, run));
    return records;
}

}  // namespace fastscene
