#include "fastscene/evaluate/suite.h"

#include <algorithm>
#include <set>
#include <type_traits>

#include "fastscene/base/file.h"
#include "fastscene/evaluate/columns.h"
#include "fastscene/io/toml_table.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
// suites/*.toml, by cmake/embed.cmake.
extern const std::pair<std::string_view, std::string_view> kSuiteTexts[];
extern const std::size_t kSuiteCount;

namespace {
namespace fs = std::filesystem;

// Settings of `make` by flag name, without dashes: walk, walk-viewpoints, splat-steps …
template <class Visit>
void visit_settings(SceneParams& params, const Visit& visit) {
    visit_sections(params, [&](std::string_view section, auto& fields) {
        visit_fields(fields, [&](std::string_view field, auto& value, const auto&...) {
            visit(field == "kind" ? std::string(section) : fmt::format("{}-{}", section, field), value);
        });
    });
}

std::vector<std::string> setting_names() {
    std::vector<std::string> names;
    SceneParams params;
    visit_settings(params, [&](const std::string& name, auto&) { names.push_back(name); });
    return names;
}

fs::path below(const fs::path& folder, const std::string& path) {
    return path.empty() || fs::path(path).is_absolute() ? fs::path(path) : folder / path;
}

// A setting that names a file.
std::string weights_file(const TomlTable& table, const std::string& name, const fs::path& folder) {
    const std::string text = table.text(name), file = below(folder, text).string();
    if (!text.empty() && !fs::is_regular_file(file))
        table.fail(name, fmt::format("expected a file, found none at {}", file));
    return file;
}

// Relative paths start at `folder`.
void apply_settings(const TomlTable& table, const fs::path& folder, SceneParams& params) {
    visit_settings(params, [&](const std::string& name, auto& value) {
        using T = std::decay_t<decltype(value)>;
        if (!table.has(name)) return;
        if constexpr (std::is_same_v<T, bool>) value = table.flag(name, value);
        else if constexpr (std::is_same_v<T, std::string>)
            value = name.ends_with("weights") ? weights_file(table, name, folder) : table.text(name);
        else if constexpr (std::is_integral_v<T>)
            value = static_cast<T>(table.whole(name, 0, -2'000'000'000, 2'000'000'000));
        else value = static_cast<T>(table.number(name, 0, -1e30, 1e30));
    });
    if (table.has("splat-count") && !table.has("splat-per-m2"))
        params.splat.per_m2 = 0;  // an explicit number of Gaussians overrides the density
    try {
        check_params(params);
    } catch (const UsageError& e) {  // "--walk-steps: expected …": the table uses the same name
        const std::string text = e.what(), name = text.starts_with("--") ? text.substr(2, text.find(':') - 2) : "";
        throw Error("{}: {}", table.place(name), text.substr(std::min(text.size(), text.find(':') + 2)));
    }
}

std::vector<std::string> with(std::vector<std::string> list, std::initializer_list<std::string> more) {
    list.insert(list.begin(), more);
    return list;
}

class Reader {
  public:
    Reader(const toml::table& document, std::string name, fs::path file, std::string quality)
        : top_(document, file.string(), "",
               {"title", "about", "measures", "columns", "notes", "quality", "diffusion360", "settings", "stills",
                "held-out", "scene", "variant", "published", "peer"}),
          name_(std::move(name)),
          file_(std::move(file)),
          forced_quality_(std::move(quality)) {}

    Suite read() {
        suite_.name = name_;
        suite_.title = top_.text("title", name_);
        suite_.about = top_.text("about");
        suite_.notes = top_.texts("notes");
        suite_.measures = chosen("measures", measure_names());
        if (suite_.measures.empty())
            top_.fail_missing("measures", fmt::format("a list of {}", fmt::join(measure_names(), ", ")));
        suite_.columns = chosen("columns", column_keys());
        if (suite_.columns.empty())
            for (const Column& column : columns())
                if (column.measure == "cost" || suite_.has(column.measure)) suite_.columns.push_back(column.key);
        check_columns();
        read_stills();
        read_held_out();
        const fs::path painter = path_of(top_.text("diffusion360"));
        if (!painter.empty() && !fs::is_directory(painter))
            top_.fail("diffusion360", fmt::format("expected a folder, found none at {}", painter.string()));
        for (const toml::table* variant : top_.tables("variant")) read_variant(*variant);
        if (suite_.variants.empty())
            suite_.variants.push_back({"ours", quality_of(top_), params_of(top_, nullptr), suite_.held_out.bounds});
        for (const SuiteVariant& variant : suite_.variants) row_names_.push_back(variant.name);
        settle_forced_quality();
        for (const toml::table* scene : top_.tables("scene")) read_scene(*scene);
        if (suite_.scenes.empty())
            top_.fail_missing("scene", "at least one [[scene]] with a prompt, a panorama or a run");
        check_rooms();
        for (const toml::table* row : top_.tables("published")) read_published(*row);
        for (const toml::table* peer : top_.tables("peer")) read_peer(*peer);
        return std::move(suite_);
    }

  private:
    std::vector<std::string> chosen(std::string_view key, const std::vector<std::string>& known) const {
        const std::vector<std::string> names = top_.texts(key);
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (std::find(known.begin(), known.end(), names[i]) == known.end())
                top_.fail_item(key, i, fmt::format("unknown \"{}\"{}", names[i], meant(names[i], known)));
            if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
                names.begin() + static_cast<std::ptrdiff_t>(i))
                top_.fail_item(key, i, fmt::format("expected each once, found \"{}\" twice", names[i]));
        }
        return names;
    }
    void check_columns() const {
        for (std::size_t i = 0; i < suite_.columns.size(); ++i)
            if (const Column& column = column_of(suite_.columns[i]);
                column.measure != "cost" && !suite_.has(column.measure))
                top_.fail_item("columns", i,
                               fmt::format("\"{}\" is filled by the measure \"{}\": expected it in measures, found {}",
                                           column.key, column.measure, fmt::join(suite_.measures, ", ")));
    }

    // Held-out poses need a known room: a suite that measures nothing else and has no such scene would give an empty
    // table.
    void check_rooms() const {
        const bool any = std::any_of(suite_.scenes.begin(), suite_.scenes.end(),
                                     [](const SuiteScene& s) { return has_room(s.source); });
        if (!any && suite_.measures == std::vector<std::string>{"held-out"})
            top_.fail_item("measures", 0,
                           "\"held-out\" needs a room behind a scene: expected a scene from a prompt, found only "
                           "pictures and paintings");
    }

    void read_stills() {
        const toml::table* found = top_.table("stills");
        if (!found) return;
        const TomlTable table(*found, file_.string(), "[stills]", {"count", "size", "fov", "radius"});
        StillsParams& s = suite_.stills;
        s.count = table.whole("count", s.count, 1, 1000);
        s.size_px = table.whole("size", s.size_px, 0, 4096);
        s.fov_deg = table.number("fov", s.fov_deg, 10, 140);
        s.radius_m = table.number("radius", s.radius_m, 0, 10);
    }
    void read_held_out() {
        const toml::table* found = top_.table("held-out");
        if (!found) return;
        const TomlTable table(*found, file_.string(), "[held-out]", {"views", "size", "radii", "room", "bounds"});
        HeldOutParams& h = suite_.held_out;
        h.views = table.whole("views", h.views, 1, 1000);
        h.size_px = table.whole("size", h.size_px, 64, 4096);
        h.bounds = table.flag("bounds", h.bounds);
        h.room = table.flag("room", h.room);
        if (table.has("radii")) h.radii_m = table.numbers("radii");
        if (h.radii_m.empty() && !h.room)
            table.fail("radii", "expected at least one radius in metres, or room = true, found neither");
        for (const double r : h.radii_m)
            if (!(r >= 0.01 && r <= 10))
                table.fail("radii", fmt::format("expected metres from 0.01 to 10, found {}", r));
            else if (std::count(h.radii_m.begin(), h.radii_m.end(), r) > 1)
                table.fail("radii", fmt::format("expected each once, found {} twice", r));
    }

    void read_scene(const toml::table& found) {
        const TomlTable table(found, file_.string(), "[[scene]]",
                              {"name", "prompt", "panorama", "range", "seeds", "run", "variant"});
        SuiteScene scene;
        if (table.has("run")) read_run(table, scene);
        else read_source(table, scene);
        const fs::path file = scene.run.empty() ? picture_of(scene.source).stem() : scene.run.filename();
        scene.name = folder_name_of(table.text("name", file.empty() ? prompt_of(scene.source) : file.string()));
        if (!names_.insert(scene.name).second)
            table.fail("name", fmt::format("expected a name of its own, found \"{}\" twice", scene.name));
        suite_.scenes.push_back(std::move(scene));
    }
    void read_source(const TomlTable& table, SuiteScene& scene) {
        const std::string prompt = table.text("prompt");
        const fs::path picture = path_of(table.text("panorama")), weights = path_of(top_.text("diffusion360")),
                       range = path_of(table.text("range"));
        if (prompt.empty() && picture.empty()) table.fail_missing("prompt", "a prompt, a panorama or a run");
        if (picture.empty() && !range.empty()) table.fail("range", "expected together with panorama, found alone");
        if (!picture.empty()) scene.source = PictureSource{prompt, picture, range, {}, {}};
        else if (!weights.empty()) scene.source = PaintingSource{prompt, weights, {}};
        else scene.source = PromptSource{prompt};
        if (table.has("variant"))
            table.fail("variant", "expected together with run, found alone: what is made is made for every row");
        for (const char* key : {"panorama", "range"})
            if (const std::string path = table.text(key); !path.empty() && !fs::exists(path_of(path)))
                table.fail(key, fmt::format("expected a file, found none at {}", path_of(path).string()));
        if (table.has("seeds")) scene.seeds = seeds_of(table);
    }
    static std::vector<std::uint64_t> seeds_of(const TomlTable& table) {
        std::vector<std::uint64_t> seeds;
        for (const double seed : table.numbers("seeds")) {
            if (!(seed >= 0 && seed < 9e15 && seed == static_cast<double>(static_cast<std::uint64_t>(seed))))
                table.fail("seeds", fmt::format("expected whole numbers from 0, found {}", seed));
            if (std::find(seeds.begin(), seeds.end(), static_cast<std::uint64_t>(seed)) != seeds.end())
                table.fail("seeds", fmt::format("expected each once, found {} twice", seed));
            seeds.push_back(static_cast<std::uint64_t>(seed));
        }
        if (seeds.empty()) table.fail("seeds", "expected at least one, found none");
        return seeds;
    }
    void read_run(const TomlTable& table, SuiteScene& scene) {
        for (const char* key : {"panorama", "range", "seeds"})
            if (table.has(key)) table.fail(key, "expected without run, which has its own");
        scene.run = path_of(table.text("run"));
        if (scene.run.filename().empty()) scene.run = scene.run.parent_path();
        try {
            const RecordedRun recorded = recorded_run({scene.run});
            scene.source = recorded.request.source;
            scene.seeds = {recorded.seed};
        } catch (const std::exception& e) {
            table.fail("run", e.what());
        }
        if (const std::string last = last_stage_of(suite_); !finished_stage(scene.run, last))
            table.fail("run", fmt::format("expected a run finished as far as {}, found one that is not: {}", last,
                                          scene.run.string()));
        if (table.has("prompt")) set_prompt(scene.source, table.text("prompt"));
        scene.variant = table.text("variant", row_names_.size() == 1 ? row_names_[0] : "");
        if (scene.variant.empty())
            table.fail_missing("variant",
                               fmt::format("the row that the run belongs to, one of {}", fmt::join(row_names_, ", ")));
        if (std::find(row_names_.begin(), row_names_.end(), scene.variant) == row_names_.end())
            table.fail("variant", fmt::format("unknown \"{}\"{}", scene.variant, meant(scene.variant, row_names_)));
    }

    std::string quality_of(const TomlTable& table) const {
        const TomlTable& where = table.has("quality") ? table : top_;  // the table whose line is wrong
        const std::string quality = where.text("quality", "standard");
        const std::vector<std::string> known = qualities();
        if (std::find(known.begin(), known.end(), quality) == known.end())
            where.fail("quality", fmt::format("unknown \"{}\"{}", quality, meant(quality, known)));
        return forced_quality_.empty() ? quality : forced_quality_;
    }
    // With --quality, rows that name their own presets lose their distinction. Those that become duplicates are
    // dropped; for the others the table notes it.
    void settle_forced_quality() {
        std::vector<std::string> left_out, changed;
        for (const std::string& name : replaced_) {
            const auto row = std::find_if(suite_.variants.begin(), suite_.variants.end(),
                                          [&](const SuiteVariant& v) { return v.name == name; });
            const bool again = std::any_of(suite_.variants.begin(), suite_.variants.end(), [&](const SuiteVariant& v) {
                return &v != &*row && v.bounds == row->bounds &&
                       json_of_params(v.params) == json_of_params(row->params) &&
                       std::find(replaced_.begin(), replaced_.end(), v.name) == replaced_.end();
            });
            (again ? left_out : changed).push_back(name);
            if (again) suite_.variants.erase(row);
        }
        if (!left_out.empty())
            suite_.notes.push_back(fmt::format("Made with --quality {}, so without the rows of other presets: {}.",
                                               forced_quality_, fmt::join(left_out, "; ")));
        if (!changed.empty())
            suite_.notes.push_back(
                fmt::format("Made with --quality {}, which is not the preset that these rows name: {}.",
                            forced_quality_, fmt::join(changed, "; ")));
    }
    SceneParams params_of(const TomlTable& table, const toml::table* own) const {
        SceneParams params = params_of_quality(quality_of(table));
        if (top_.has("diffusion360")) params.panorama.width = 1024;  // the model's training resolution
        if (const toml::table* common = top_.table("settings"))
            apply_settings({*common, file_.string(), "[settings]", setting_names()}, file_.parent_path(), params);
        if (own) apply_settings({*own, file_.string(), "settings", setting_names()}, file_.parent_path(), params);
        return params;
    }
    void read_variant(const toml::table& found) {
        const TomlTable table(found, file_.string(), "[[variant]]", {"name", "quality", "settings", "bounds"});
        if (table.text("name").empty()) table.fail_missing("name", "the row's name");
        if (!rows_.insert(folder_name_of(table.text("name"))).second)
            table.fail("name", fmt::format("expected a name of its own, found \"{}\" twice", table.text("name")));
        if (table.has("quality") && quality_of(table) != table.text("quality")) replaced_.push_back(table.text("name"));
        suite_.variants.push_back({table.text("name"), quality_of(table), params_of(table, table.table("settings")),
                                   table.flag("bounds", suite_.held_out.bounds)});
    }

    void read_published(const toml::table& found) {
        const TomlTable table(found, file_.string(), "[[published]]", with(column_keys(), {"name", "ours"}));
        PublishedRow row{table.text("name"), {}, table.flag("ours", false)};
        if (row.name.empty()) table.fail_missing("name", "the row's name");
        for (const std::string& key : column_keys())
            if (table.has(key)) row.values[key] = table.number(key, 0, -1e9, 1e9);
        suite_.published.push_back(std::move(row));
    }
    void read_peer(const toml::table& found) {
        const TomlTable table(found, file_.string(), "[[peer]]", {"name", "folder"});
        if (table.text("name").empty()) table.fail_missing("name", "the row's name");
        if (table.text("folder").empty()) table.fail_missing("folder", "the folder of its pictures or splats");
        if (!rows_.insert(folder_name_of(table.text("name"))).second)
            table.fail("name", fmt::format("expected a name of its own, found \"{}\" twice", table.text("name")));
        suite_.peers.push_back({table.text("name"), path_of(table.text("folder"))});
    }

    fs::path path_of(const std::string& text) const { return below(file_.parent_path(), text); }

    TomlTable top_;
    std::string name_;
    fs::path file_;
    std::string forced_quality_;
    std::set<std::string> names_, rows_;
    std::vector<std::string> row_names_;  // of the file's variants
    std::vector<std::string> replaced_;   // rows whose own preset is overridden by --quality
    Suite suite_;
};

}  // namespace

std::string folder_name_of(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    std::string out;
    for (const char c : text) {
        const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if (!is_ascii(c) || (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9')) out += lower;
        else if (!out.empty() && out.back() != '-') out += '-';
    }
    if (out.size() > kLongest) {
        std::size_t end = kLongest;
        // never cuts a UTF-8 character in two
        while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xc0) == 0x80) --end;
        out.resize(end);
    }
    while (out.ends_with('-')) out.pop_back();
    return out.empty() ? "scene" : out;
}

bool Suite::has(std::string_view measure) const {
    return std::find(measures.begin(), measures.end(), measure) != measures.end();
}

std::string last_stage_of(const Suite& suite) {
    return suite.measures == std::vector<std::string>{"holes"} ? "depth" : "splat";
}

const std::vector<std::string>& measure_names() {
    static const std::vector<std::string> names{"stills", "source", "held-out", "holes"};
    return names;
}

Suite read_suite(std::string_view text, const std::string& name, const fs::path& file, const std::string& quality) {
    const toml::table document = parse_toml(text, file.string());
    return Reader(document, name, file, quality).read();
}

std::vector<std::pair<std::string, std::string>> shipped_suites() {
    std::vector<std::pair<std::string, std::string>> out;
    for (std::size_t i = 0; i < kSuiteCount; ++i) {
        const std::string name(kSuiteTexts[i].first);
        out.emplace_back(name, read_suite(kSuiteTexts[i].second, name, "suites/" + name + ".toml").title);
    }
    return out;
}

SuiteText find_suite(const std::string& name_or_file) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kSuiteCount; ++i) {
        names.emplace_back(kSuiteTexts[i].first);
        if (names.back() == name_or_file)
            return {names.back(), std::string(kSuiteTexts[i].second), "suites/" + names.back() + ".toml"};
    }
    if (fs::is_regular_file(name_or_file))
        return {fs::path(name_or_file).stem().string(), read_file(name_or_file), name_or_file};
    throw UsageError("evaluate: expected a suite file or the name of a suite that ships, found \"{}\"{}", name_or_file,
                     meant(name_or_file, names));
}

}  // namespace fastscene
