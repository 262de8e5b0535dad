#include "fastscene/pipeline/identity.h"

#include <fmt/ranges.h>

#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/pipeline/build_info.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kHowToGetARange =
    "a panorama needs the range of each of its pixels: add --range FILE, an .exr, .pfm or 16-bit .png (millimetres) of the same size, "
    "as 360-degree depth estimators, LiDAR scanners and renderers write it (distance along the ray, in metres)";

void tell_what_was_understood(const PromptSpec& prompt, const Run& run) {
    if (prompt.understood.empty())
        run.warn("no word of the prompt was understood: a plausible room is made instead (panorama/prompt.json says which)");
    else if (!prompt.not_understood.empty())
        run.warn(fmt::format("not understood in the prompt: {}", fmt::join(prompt.not_understood, ", ")));
    for (const std::string& text : prompt.approximated) run.note("taken for something near: " + text);
}

std::string describe(const Json& recorded) {
    const std::string picture = recorded.value("picture", "");
    const std::string what = picture.empty() ? "the prompt \"" + recorded.value("prompt", "") + "\"" : "the picture " + picture;
    return fmt::format("{}, seed {}", what, recorded.value("seed", std::uint64_t{0}));
}

Json run_json_of(const SceneRequest& request, std::uint64_t seed) {
    Json json;
    json["prompt"] = request.source.prompt;
    if (!request.source.picture.empty()) {
        json["picture"] = fs::absolute(request.source.picture).string();
        json["range_map"] = fs::absolute(request.source.range_map).string();
    }
    json["identity"] = identity_of(request.source);
    json["seed"] = seed;
    json["quality"] = request.quality;
    json["params"] = json_of_params(request.params);
    json["versions"] = build_json();
    return json;
}

void remove_owned(const RunFolder& folder) {
    for (const std::string& name : RunFolder::owned()) {
        std::error_code code;
        fs::remove_all(folder.root / name, code);
        if (code) throw Error("{}: cannot be removed: {}", (folder.root / name).string(), code.message());
    }
}

}  // namespace

void check_source(const SceneSource& source, const PanoramaParams& params, const Run& run) {
    if (source.picture.empty()) {
        if (!source.range_map.empty()) throw UsageError("--range: expected together with --panorama FILE, found alone");
        tell_what_was_understood(understand_prompt(source.prompt, params.strict), run);
        return;
    }
    const Panorama panorama = panorama_from_image(source.picture);
    if (source.range_map.empty()) throw UsageError("{}: {}", source.picture.string(), kHowToGetARange);
    range_from_file(source.range_map, panorama.size());
}

std::string identity_of(const SceneSource& source) {
    Hash hash;
    if (source.picture.empty())
        hash.add("prompt").add(source.prompt);
    else
        hash.add("picture").add(read_file(source.picture)).add(read_file(source.range_map));
    return hash.hex();
}

std::string title_of(const SceneSource& source) {
    return source.picture.empty() || !source.prompt.empty() ? source.prompt : source.picture.stem().string();
}

void claim_folder(const RunFolder& folder, const SceneRequest& request, std::uint64_t seed) {
    const Json wanted = run_json_of(request, seed);
    if (request.start_over) {
        remove_owned(folder);
    } else if (fs::exists(folder.run_json())) {
        const Json recorded = read_json(folder.run_json());
        if (recorded.value("identity", "") != wanted.at("identity") || recorded.value("seed", std::uint64_t{0}) != seed)
            throw UsageError("{}: expected a new folder or a run of {}, found a run of {}; choose another folder with -o, or --force to "
                             "throw that run away",
                             folder.root.string(), describe(wanted), describe(recorded));
    } else {
        for (const std::string& name : RunFolder::owned())
            if (fs::exists(folder.root / name))
                throw UsageError("{}: expected a new folder or a run, found {} but no run.json; choose another folder with -o, or --force to "
                                 "replace what is there",
                                 folder.root.string(), name);
    }
    write_json(folder.run_json(), wanted);
}

RecordedRun recorded_run(const RunFolder& folder) {
    if (!fs::exists(folder.run_json()))
        throw UsageError("{}: expected the folder of a run, found no run.json; make one with `fastscene make \"…\" -o {}`",
                         folder.root.string(), folder.root.string());
    const Json json = read_json(folder.run_json());
    try {
        RecordedRun recorded;
        recorded.request.source = {json.at("prompt"), json.value("picture", ""), json.value("range_map", "")};
        recorded.request.quality = json.at("quality");
        recorded.request.params = params_from_json(json.at("params"), params_of_quality(recorded.request.quality));
        recorded.seed = json.at("seed");
        return recorded;
    } catch (const Json::exception& e) {
        throw Error("{}: expected prompt, quality, params and seed: {}", folder.run_json().string(), e.what());
    }
}

}  // namespace fastscene
