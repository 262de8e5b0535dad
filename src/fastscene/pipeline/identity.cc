#include "fastscene/pipeline/identity.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/panorama/diffusion360.h"
#include "fastscene/panorama/more_panoramas.h"
#include "fastscene/panorama/picture_check.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/resolve.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> words_of(const PromptSpec& prompt, PromptWord::Fate fate) {
    std::vector<std::string> out;
    for (const PromptWord& word : prompt.words_with(fate)) out.push_back(word.words);
    return out;
}

void tell_what_was_understood(const PromptSpec& prompt, const Run& run) {
    const auto unknown = words_of(prompt, PromptWord::Fate::not_understood);
    if (!prompt.names_a_room())
        run.warn(
            "the prompt names nothing that belongs to a room: a plausible room is made instead (panorama/prompt.json "
            "says which)");
    if (!prompt.unread.empty())
        run.warn(
            fmt::format("the prompt is in {}, which is not read: expected English, German, French, Spanish or Italian",
                        prompt.unread));
    if (!unknown.empty()) run.warn(fmt::format("not understood in the prompt: {}", fmt::join(unknown, ", ")));
    for (const PromptWord& word : prompt.words_with(PromptWord::Fate::approximated))
        run.note(word.words + ": " + word.meaning);
}

void add_more(const fs::path& list, Hash& hash) {
    hash.add("more").add(read_file(list));
    for (const MorePanorama& more : read_more_panoramas(list))
        hash.add(read_file(more.color)).add(more.range.empty() ? std::string() : read_file(more.range));
}

// Hashes of the files that a run is made from, by their names in run.json.
Json contents_of(const SceneSource& source) {
    Json out = Json::object();
    if (source.is_painted()) out["weights"] = diffusion360_identity(source.weights, !source.photo.empty());
    const std::pair<const char*, fs::path> files[] = {
        {"picture", source.picture}, {"range_map", source.range_map}, {"photo", source.photo}};
    for (const auto& [name, file] : files)
        if (!file.empty()) out[name] = Hash().add(read_file(file)).hex();
    if (!source.more.empty()) {
        Hash hash;
        add_more(source.more, hash);
        out["more"] = hash.hex();
    }
    return out;
}

// For people: prompt or picture, seed, and which of the files are others than those of `other`.
std::string describe(const Json& run, const Json& other) {
    const std::string picture = run.value("picture", "");
    std::string text = picture.empty() ? "the prompt \"" + run.value("prompt", "") + "\"" : "the picture " + picture;
    text += fmt::format(", seed {}", run.value("seed", std::uint64_t{0}));
    const auto content = [](const Json& json, const char* name) {
        return json.value("contents", Json::object()).value(name, "");
    };
    for (const auto& [name, called] : {std::pair{"picture", "picture"},
                                       {"range_map", "range map"},
                                       {"weights", "weights"},
                                       {"photo", "photo"},
                                       {"more", "further panoramas"}}) {
        const std::string own = content(run, name);
        if (own == content(other, name)) continue;
        const std::string path = run.value(name, "");
        if (path.empty()) text += fmt::format(", no {}", called);
        else
            text += fmt::format(", {} {} ({})", called, path,
                                own.empty() ? "contents not recorded" : "contents " + own.substr(0, 8));
    }
    return text;
}

Json run_json_of(const SceneRequest& request, std::uint64_t seed, const std::optional<GoneSource>& gone) {
    Json json;
    json["prompt"] = request.source.prompt;
    if (!request.source.picture.empty()) {
        json["picture"] = fs::absolute(request.source.picture).string();
        if (!request.source.range_map.empty()) json["range_map"] = fs::absolute(request.source.range_map).string();
    }
    if (!request.source.more.empty()) json["more"] = fs::absolute(request.source.more).string();
    if (!request.source.weights.empty()) json["weights"] = fs::absolute(request.source.weights).string();
    if (!request.source.photo.empty()) json["photo"] = fs::absolute(request.source.photo).string();
    json["identity"] = gone ? gone->record.at("identity") : Json(identity_of(request.source));
    json["contents"] = gone ? gone->record.at("contents") : contents_of(request.source);
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

void tell_doubts(const fs::path& picture, const ImageColor& color, const Run& run) {
    for (const std::string& remark : remarks_on_file(picture))
        run.note(fmt::format("{}: {}", picture.string(), remark));
    for (const std::string& doubt : doubts_about_panorama(color))
        run.warn(fmt::format("{}: {}", picture.string(), doubt));
}

void check_more(const SceneSource& source, const SceneParams& params, const Run& run) {
    if (source.picture.empty()) throw UsageError("--more: expected together with --panorama FILE, found alone");
    if (const WalkParams walk = walk_of(source, params.depth, params.walk); walk.kind != "ours")
        throw UsageError("--walk {}: expected ours together with --more, the published walks know one panorama",
                         walk.kind);
    for (const MorePanorama& more : read_more_panoramas(source.more)) {
        const Panorama one = panorama_from_image(more.color);
        tell_doubts(more.color, one.color, run);
        if (!more.range.empty()) {
            range_from_file(more.range, one.size());
            continue;
        }
        const float down = more.world_from_pano.translation.y;
        const DepthParams depth = depth_of_further(params.depth, more.world_from_pano.translation);
        make_depth_estimator(depth);  // its weights may be missing, even where the first panorama needs none
        if (params.depth.camera_height_m - down < kLeastCameraHeight)
            run.warn(
                fmt::format("{}: expected a place over the floor, which lies {} m below the first camera, found {} m "
                            "below it (y points down)",
                            more.color.string(), params.depth.camera_height_m, down));
        run.note(fmt::format("depth: {}: no range: estimated from the picture, the camera {} m above the floor",
                             more.color.string(), depth.camera_height_m));
    }
}

}  // namespace

void check_source(const SceneSource& source, const SceneParams& params, const std::string& last_stage, const Run& run) {
    depth_backend(source, params.depth);
    if (!source.more.empty()) check_more(source, params, run);
    if (!source.weights.empty() && !source.range_map.empty())
        throw UsageError("--range: expected together with --panorama FILE as it is, found with {}",
                         source.is_painted() ? "--panorama diffusion360" : "--panorama-upscale");
    if (source.is_painted()) {
        check_diffusion360({source.prompt, source.weights, source.photo}, params.panorama, run);
        if (last_stage != "panorama") make_depth_estimator(params.depth);
        return;
    }
    if (source.picture.empty()) {
        if (!source.range_map.empty()) throw UsageError("--range: expected together with --panorama FILE, found alone");
        std::vector<std::string> complaints;
        tell_what_was_understood(read_prompt(source.prompt, params.panorama, &complaints), run);
        // The pack is optional: that it is absent is news only to those who asked for it.
        for (const std::string& complaint : complaints)
            if (complaint.starts_with("no furniture pack") && params.panorama.assets != "all") run.note(complaint);
            else run.warn(complaint);
        return;
    }
    const Panorama panorama = panorama_from_image(source.picture);
    tell_doubts(source.picture, panorama.color, run);
    if (!source.weights.empty() && params.panorama.diffusion.upscale != "none")
        check_enlarging({source.prompt, source.weights, {}}, params.panorama,
                        std::min(panorama.size().width, params.panorama.width), run);
    if (!source.range_map.empty()) {
        range_from_file(source.range_map, panorama.size());
        return;
    }
    make_depth_estimator(params.depth);  // its weights may be missing: better known now
    run.note(fmt::format("depth: no --range: estimated from the picture, the camera {} m above the floor",
                         params.depth.camera_height_m));
}

std::string identity_of(const SceneSource& source) {
    Hash hash;
    if (source.is_painted())
        hash.add("diffusion360")
            .add(source.prompt)
            .add(diffusion360_identity(source.weights, !source.photo.empty()))
            .add(source.photo.empty() ? std::string() : read_file(source.photo));
    else if (source.picture.empty()) hash.add("prompt").add(source.prompt);
    else
        hash.add("picture")
            .add(read_file(source.picture))
            .add(source.range_map.empty() ? std::string() : read_file(source.range_map));
    if (!source.more.empty()) add_more(source.more, hash);
    return hash.hex();
}

std::string title_of(const SceneSource& source) {
    return source.picture.empty() || !source.prompt.empty() ? source.prompt : source.picture.stem().string();
}

std::optional<GoneSource> gone_source(const RunFolder& folder, const SceneSource& source) {
    if (source.picture.empty() || !source.weights.empty() || !fs::exists(folder.run_json())) return {};
    std::vector<std::pair<const char*, fs::path>> files{
        {"picture", source.picture}, {"range_map", source.range_map}, {"more", source.more}};
    GoneSource gone{read_json(folder.run_json()), {}};
    if (!gone.record.is_object() || !gone.record.contains("identity") || !gone.record.contains("contents")) return {};
    for (const auto& [name, file] : files) {
        const std::string recorded = gone.record.value(name, "");
        if (file.empty() != recorded.empty() || (!file.empty() && fs::absolute(file).string() != recorded)) return {};
        if (file.empty()) continue;
        if (!fs::exists(file)) gone.file = gone.file.empty() ? file : gone.file;
        else if (std::string_view(name) == "more") {
            for (const MorePanorama& more : read_more_panoramas(file))
                for (const fs::path& one : {more.color, more.range})
                    if (!one.empty() && !fs::exists(one) && gone.file.empty()) gone.file = one;
        } else if (Hash().add(read_file(file)).hex() != gone.record["contents"].value(name, "")) {
            return {};  // there, but another
        }
    }
    return gone.file.empty() ? std::nullopt : std::optional(std::move(gone));
}

void claim_folder(const RunFolder& folder, const SceneRequest& request, std::uint64_t seed,
                  const std::optional<GoneSource>& gone) {
    const Json wanted = run_json_of(request, seed, gone);
    if (request.start_over) {
        remove_owned(folder);
    } else if (fs::exists(folder.run_json())) {
        const Json recorded = read_json(folder.run_json());
        if (recorded.value("identity", "") != wanted.at("identity") || recorded.value("seed", std::uint64_t{0}) != seed)
            throw UsageError(
                "{}: expected a new folder or a run of {}, found a run of {}; choose another folder with -o, or "
                "--force to "
                "throw that run away",
                folder.root.string(), describe(wanted, recorded), describe(recorded, wanted));
    } else {
        for (const std::string& name : RunFolder::owned())
            if (fs::exists(folder.root / name))
                throw UsageError(
                    "{}: expected a new folder or a run, found {} but no run.json; choose another folder with -o, or "
                    "--force to "
                    "replace what is there",
                    folder.root.string(), name);
    }
    write_json(folder.run_json(), wanted);
}

RecordedRun recorded_run(const RunFolder& folder) {
    if (!fs::exists(folder.run_json()))
        throw UsageError(
            "{}: expected the folder of a run, found no run.json; make one with `fastscene make \"…\" -o {}`",
            folder.root.string(), folder.root.string());
    const Json json = read_json(folder.run_json());
    if (json.contains("capture"))
        throw UsageError(
            "{}: expected a run from a prompt or a panorama, found splats of photographs: only splat, render and view "
            "go on with those",
            folder.root.string());
    try {
        RecordedRun recorded;
        recorded.request.source = {json.at("prompt"),         json.value("picture", ""), json.value("range_map", ""),
                                   json.value("weights", ""), json.value("photo", ""),   json.value("more", "")};
        recorded.request.quality = json.at("quality");
        recorded.request.params = params_from_json(json.at("params"), params_of_quality(recorded.request.quality));
        recorded.seed = json.at("seed");
        return recorded;
    } catch (const Json::exception& e) {
        throw Error("{}: expected prompt, quality, params and seed: {}", folder.run_json().string(), e.what());
    } catch (const Error& e) {  // "run.json: params: width: …", of whichever run
        if (!std::string_view(e.what()).starts_with("run.json: ")) throw;
        throw Error("{}", (folder.root / e.what()).string());
    }
}

}  // namespace fastscene
