#include "fastscene/pipeline/source_json.h"

#include <set>

#include "fastscene/base/hash.h"
#include "fastscene/panorama/diffusion360.h"
#include "fastscene/panorama/more_panoramas.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

std::string whole_path(const fs::path& file) { return file.empty() ? "" : fs::absolute(file).string(); }

// Always writes the prompt; file names only if set.
struct WriteFields {
    Json& out;
    void operator()(std::string_view name, const std::string& text, const SourceFlag&, std::string_view) const {
        out[std::string(name)] = text;
    }
    void operator()(std::string_view name, const fs::path& file, const SourceFlag&, std::string_view) const {
        if (!file.empty()) out[std::string(name)] = whole_path(file);
    }
};
struct ReadFields {
    const Json& run;
    void operator()(std::string_view name, std::string& text, const SourceFlag&, std::string_view) const {
        text = run.at(std::string(name)).get<std::string>();
    }
    void operator()(std::string_view name, fs::path& file, const SourceFlag&, std::string_view) const {
        file = run.value(std::string(name), std::string());
    }
};
DocumentSource read_room(const Json& run) {
    DocumentSource out{run.at("prompt"), run.at("room").get<std::string>(), run.at("document").dump()};
    if (const auto from = run.find("edited_from"); from != run.end())
        out.edited_from = from->at("run").get<std::string>(), out.edited_from_hash = from->at("hash");
    return out;
}
template <class Source>
Source read_fields(const Json& run) {
    Source source;
    visit_fields(source, ReadFields{run});
    return source;
}

// Calls v(name, file) for each file that identifies a picture source; weights are handled by Stream (pipeline.cc).
template <class V>
void visit_files(PictureSource source, V&& v) {
    v("picture", source.picture), v("range_map", source.range_map), v("more", source.more);
}

void add_file(const fs::path& file, SourceFiles& files, Hash& hash) {
    hash.add(file.empty() ? std::string_view() : std::string_view(files.bytes(file)));
}
void add_more(const fs::path& list, SourceFiles& files, Hash& hash) {
    hash.add("more").add(files.bytes(list));
    for (const MorePanorama& more : read_more_panoramas(list)) {
        add_file(more.color, files, hash);
        add_file(more.range, files, hash);
    }
}
std::string content_of(const fs::path& file, SourceFiles& files) { return Hash().add(files.bytes(file)).hex(); }

void add_identity(const PromptSource& source, SourceFiles&, Hash& hash) { hash.add("prompt").add(source.prompt); }
void add_identity(const DocumentSource& source, SourceFiles&, Hash& hash) {
    hash.add("room").add(source.document);
    if (!source.edited_from_hash.empty()) hash.add(source.edited_from_hash);
}
void add_identity(const PictureSource& source, SourceFiles& files, Hash& hash) {
    hash.add("picture");
    add_file(source.picture, files, hash);
    add_file(source.range_map, files, hash);
    if (!source.more.empty()) add_more(source.more, files, hash);
}
void add_identity(const PaintingSource& source, SourceFiles& files, Hash& hash) {
    hash.add("diffusion360").add(source.prompt).add(diffusion360_identity(source.weights, !source.photo.empty()));
    add_file(source.photo, files, hash);
}
// Captures are identified by their cameras (capture_run.cc).
void add_identity(const CaptureSource& source, SourceFiles&, Hash& hash) {
    hash.add("capture").add(whole_path(source.source));
}

Json contents(const PictureSource& source, SourceFiles& files) {
    Json out = Json::object();
    for (const auto& [name, file] : {std::pair{"picture", source.picture}, {"range_map", source.range_map}})
        if (!file.empty()) out[name] = content_of(file, files);
    if (source.more.empty()) return out;
    Hash hash;
    add_more(source.more, files, hash);
    out["more"] = hash.hex();
    return out;
}
Json contents(const PaintingSource& source, SourceFiles& files) {
    Json out{{"weights", diffusion360_identity(source.weights, !source.photo.empty())}};
    if (!source.photo.empty()) out["photo"] = content_of(source.photo, files);
    return out;
}
Json contents(const PromptSource&, SourceFiles&) { return Json::object(); }
Json contents(const DocumentSource& source, SourceFiles&) { return {{"room", Hash().add(source.document).hex()}}; }
Json contents(const CaptureSource&, SourceFiles&) { return Json::object(); }

std::string content(const Json& run, const std::string& name) {
    return run.value("contents", Json::object()).value(name, "");
}

// The first missing file of a list, if any.
fs::path gone_of_list(const fs::path& list) {
    for (const MorePanorama& more : read_more_panoramas(list))
        for (const fs::path& file : {more.color, more.range})
            if (!file.empty() && !fs::exists(file)) return file;
    return {};
}

}  // namespace

Json json_of_source(const SceneSource& source) {
    Json out = Json::object();
    std::visit(
        [&](auto one) {
            Json fields = Json::object();
            visit_fields(one, WriteFields{fields});
            if constexpr (std::is_same_v<decltype(one), CaptureSource>) {
                one.source = fs::absolute(one.source).lexically_normal();
                out = {{"prompt", ""}, {"capture", Json::object()}};
                out["capture"] = {{"kind", one.kind},
                                  {"source", one.source.string()},
                                  {"images", whole_path(one.images)},
                                  {"masks", whole_path(one.masks)}};
                if (!one.points.empty()) out["capture"]["points"] = whole_path(one.points);
            } else if constexpr (std::is_same_v<decltype(one), DocumentSource>) {
                out = {{"prompt", one.prompt}, {"room", whole_path(one.room)}, {"document", Json::parse(one.document)}};
                if (!one.edited_from.empty())
                    out["edited_from"] = {{"run", whole_path(one.edited_from)}, {"hash", one.edited_from_hash}};
            } else {
                out = std::move(fields);
            }
        },
        source);
    return out;
}

SceneSource source_from_json(const Json& run) {
    if (run.contains("capture")) return read_fields<CaptureSource>(run.at("capture"));
    if (run.contains("document")) return read_room(run);
    if (!run.value("picture", "").empty()) return read_fields<PictureSource>(run);
    if (!run.value("weights", "").empty()) return read_fields<PaintingSource>(run);
    return read_fields<PromptSource>(run);
}

std::string identity_of(const SceneSource& source, SourceFiles& files) {
    Hash hash;
    std::visit([&](const auto& one) { add_identity(one, files, hash); }, source);
    return hash.hex();
}

Json contents_of(const SceneSource& source, SourceFiles& files) {
    return std::visit([&](const auto& one) { return contents(one, files); }, source);
}

std::string describe(const Json& run, const Json& other) {
    const std::string picture = run.value("picture", "");
    std::string text = picture.empty() ? "the prompt \"" + run.value("prompt", "") + "\"" : "the picture " + picture;
    text += fmt::format(", seed {}", run.value("seed", std::uint64_t{0}));
    std::set<std::string, std::less<>> told;
    const auto tell = [&](std::string_view field, const auto&, const SourceFlag& flag, std::string_view) {
        const std::string name(field), own = content(run, name), path = run.value(name, "");
        if (name == "prompt" || !told.insert(name).second || own == content(other, name)) return;
        if (path.empty()) text += fmt::format(", no {}", flag.called);
        else
            text += fmt::format(", {} {} ({})", flag.called, path,
                                own.empty() ? "contents not recorded" : "contents " + own.substr(0, 8));
    };
    visit_starting_sources([&](auto source, std::string_view) { visit_fields(source, tell); });
    return text;
}

std::optional<GoneSource> gone_source(const RunFolder& folder, const SceneSource& source, SourceFiles& files) {
    const auto* picture = std::get_if<PictureSource>(&source);
    if (!picture || !picture->weights.empty() || !fs::exists(folder.run_json())) return {};
    GoneSource gone{read_json(folder.run_json()), {}};
    if (!gone.record.is_object() || !gone.record.contains("identity") || !gone.record.contains("contents")) return {};
    bool same = true;
    visit_files(*picture, [&](const char* name, const fs::path& file) {
        const std::string recorded = gone.record.value(name, "");
        same = same && whole_path(file) == recorded;
        if (!same || file.empty()) return;
        fs::path missing;
        if (!fs::exists(file)) missing = file;
        else if (std::string_view(name) == "more") missing = gone_of_list(file);
        else same = content_of(file, files) == content(gone.record, name);  // exists, but has changed
        if (gone.file.empty()) gone.file = missing;
    });
    return same && !gone.file.empty() ? std::optional(std::move(gone)) : std::nullopt;
}

}  // namespace fastscene
