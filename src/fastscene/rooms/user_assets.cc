#include "fastscene/rooms/user_assets.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/io/toml_table.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostFiles = 20000;
constexpr double kSmallest_m = 0.005, kLargest_m = 20;  // of what a row may say

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}
std::string ending_of(const fs::path& file) { return lower(file.extension().string()); }
bool is_model(const fs::path& file) {
    const std::string e = ending_of(file);
    return e == ".glb" || e == ".gltf" || e == ".obj";
}
bool is_sky(const fs::path& file) { return ending_of(file) == ".hdr" || ending_of(file) == ".exr"; }
bool is_picture_file(const fs::path& file) {
    static const std::set<std::string> kEndings{".png", ".jpg", ".jpeg", ".webp", ".tif", ".tiff"};
    return kEndings.contains(ending_of(file));
}

// The parts of file names by which libraries of textures tell their maps apart.
enum class Map : std::uint8_t { color, normals, normals_down, roughness, metal, height };
constexpr std::array<std::pair<std::string_view, Map>, 22> kMapNames{
    {{"albedo", Map::color},        {"basecolor", Map::color},     {"base color", Map::color},
     {"diffuse", Map::color},       {"diff", Map::color},          {"color", Map::color},
     {"colour", Map::color},        {"col", Map::color},           {"normaldx", Map::normals_down},
     {"nor dx", Map::normals_down}, {"normalgl", Map::normals},    {"nor gl", Map::normals},
     {"normal", Map::normals},      {"nor", Map::normals},         {"nrm", Map::normals},
     {"roughness", Map::roughness}, {"rough", Map::roughness},     {"metalness", Map::metal},
     {"metallic", Map::metal},      {"displacement", Map::height}, {"disp", Map::height},
     {"height", Map::height}}};

// "_", "-" and "." part words.
std::string file_words(std::string_view stem) {
    std::string out = " ";
    for (const char c : stem) out += c == '_' || c == '-' || c == '.' ? ' ' : c;
    return lower(out) + " ";
}
std::optional<Map> map_of(const fs::path& file) {
    const std::string words = file_words(file.stem().string());
    for (const auto& [name, map] : kMapNames)
        if (words.find(" " + std::string(name) + " ") != std::string::npos) return map;
    return {};
}

Attribution attribution_of(const TomlTable& row) {
    return {row.text("title"), row.text("author"), row.text("licence"), row.text("source")};
}

// The kind of furniture that a name ends with: "vintage leather armchair" is an armchair.
std::optional<std::string> known_kind(const std::string& name) {
    std::vector<std::string> words;
    for (const std::string& t : tokens_of(name)) words.push_back(t);
    for (std::size_t n = std::min(words.size(), kLongestTerm); n > 0; --n)
        for (std::size_t begin = words.size() - n + 1; begin-- > 0;) {
            std::string term = words[begin];
            for (std::size_t i = 1; i < n; ++i) term += " " + words[begin + i];
            const auto word = look_up(term);
            if (word && word->exact && (word->kind == WordKind::object || word->kind == WordKind::structure))
                return word->meaning;
        }
    return {};
}

// Parts of the room itself are built with it; what hangs in its windows is cut to them.
bool may_be_replaced(const std::string& kind) {
    return !has_role(kind, Role::shell) && !has_role(kind, Role::opening) && !has_role(kind, Role::blind) &&
           !is_curtain(kind);
}

// "Scene" and "model" name nothing: the folder around them does.
std::string name_of_file(const fs::path& file) {
    static const std::set<std::string> kNothing{"scene", "model", "source", "untitled", "mesh", "object", "output", ""};
    const std::string name = spoken_name(file.stem().string());
    return kNothing.contains(name) && file.has_parent_path() ? spoken_name(file.parent_path().filename().string())
                                                             : name;
}

// A proper rotation that takes the file's up and front to ours.
Mat3f axes_turned(Vec3f up, Vec3f front) { return transpose(Mat3f::from_columns(cross(up, front), up, front)); }

class FolderReader {
  public:
    explicit FolderReader(fs::path folder) : folder_(std::move(folder)) {}

    UserAssets read() {
        std::error_code code;
        if (!fs::is_directory(folder_, code))
            throw UsageError("--assets: expected none, cc0, all or a folder, found \"{}\"", folder_.string());
        if (fs::exists(folder_ / kAssetsFile, code)) read_rows();
        scan();
        loose_files();
        return std::move(out_);
    }

  private:
    void complain(const std::string& what) { out_.complaints.push_back(what); }

    // A row that is wrong is left out: the others go on.
    template <class Rows, class Read>
    void each(const Rows& rows, const Read& read) {
        for (const toml::table* row : rows) try {
                read(*row);
            } catch (const Error& error) {
                complain(error.what());
            }
    }
    void read_rows() {
        const std::string file = (folder_ / kAssetsFile).string();
        const toml::table parsed = parse_toml(read_file(folder_ / kAssetsFile), file);
        const TomlTable top(parsed, file, "", {"model", "texture", "sky"});
        each(top.tables("model"), [&](const toml::table& row) { model_row(row, file); });
        each(top.tables("texture"), [&](const toml::table& row) { texture_row(row, file); });
        each(top.tables("sky"), [&](const toml::table& row) { sky_row(row, file); });
    }

    // A path below the folder.
    fs::path path_in(const TomlTable& row, const char* key) {
        const fs::path path = fs::path(row.needed_text(key, "a path below the folder")).lexically_normal();
        if (path.is_absolute() || path.empty() || *path.begin() == "..")
            row.fail(key, fmt::format("expected a path below the folder, found \"{}\"", path.string()));
        if (!fs::exists(folder_ / path)) row.fail(key, fmt::format("\"{}\" is not there", path.string()));
        named_.insert(path);
        return path;
    }
    static std::vector<std::string> names_in(const TomlTable& row) {
        std::vector<std::string> names;
        for (const std::string& name : row.texts("names")) names.push_back(folded(name));
        return names;
    }

    void model_row(const toml::table& parsed, const std::string& file) {
        const TomlTable row(parsed, file, "[[model]]",
                            {"file", "class", "names", "width_m", "height_m", "depth_m", "up", "front", "mount",
                             "hang_height_m", "title", "author", "licence", "source"});
        UserModel m;
        m.file = path_in(row, "file");
        if (!is_model(m.file)) row.fail("file", "expected .glb, .gltf or .obj, found " + m.file.string());
        name(m, name_of_file(m.file));
        m.attribution = attribution_of(row);
        for (std::string& one : names_in(row)) m.names.insert(m.names.begin(), std::move(one));
        if (row.has("class")) m.kind = class_in(row);
        else if (row.has("names")) m.kind = known_kind(m.names.front()).value_or(kind_of_name(m.names.front()));
        constexpr std::array<const char*, 3> kExtents{"width_m", "height_m", "depth_m"};
        for (std::size_t a = 0; a < 3; ++a)
            if (row.has(kExtents[a]))
                m.size_m[a] = static_cast<float>(row.needed_number(kExtents[a], kSmallest_m, kLargest_m));
        m.ours_from_file = axes_turned(direction(row, "up", {0, 1, 0}), direction(row, "front", {0, 0, 1}));
        if (dot(m.ours_from_file.row1, m.ours_from_file.row2) != 0)
            row.fail("front", "expected a direction at right angles to up");
        constexpr std::array<std::string_view, 4> kMounts{"floor", "wall", "ceiling", "top"};
        if (row.has("mount")) m.mount = static_cast<Mount>(row.needed_choice("mount", kMounts));
        if (row.has("hang_height_m")) m.hang_height_m = static_cast<float>(row.needed_number("hang_height_m", 0, 10));
        out_.models.push_back(std::move(m));
    }
    static std::string class_in(const TomlTable& row) {
        const std::string said = row.needed_text("class"), name = spoken_name(said);
        const std::string kind = find_thing(kind_of_name(name)) ? kind_of_name(name)
                                                                : known_kind(name).value_or(kind_of_name(name));
        if (!may_be_replaced(kind))
            row.fail("class", fmt::format("expected furniture, found \"{}\", which belongs to the room itself", said));
        return kind;
    }
    static Vec3f direction(const TomlTable& row, const char* key, Vec3f otherwise) {
        static constexpr std::array<std::string_view, 6> kNames{"+x", "-x", "+y", "-y", "+z", "-z"};
        if (!row.has(key)) {
            // With another up, the front of most modelling programs: -y.
            if (std::string_view(key) == "front" && row.has("up") && row.text("up").ends_with("z")) return {0, -1, 0};
            return otherwise;
        }
        std::string word = row.text(key);
        if (word.size() == 1) word = "+" + word;
        const std::size_t i = row.choice_of(key, word, kNames);
        Vec3f d{};
        d[i / 2] = i % 2 == 0 ? 1.f : -1.f;
        return d;
    }

    void texture_row(const toml::table& parsed, const std::string& file) {
        const TomlTable row(parsed, file, "[[texture]]",
                            {"folder", "names", "width_m", "title", "author", "licence", "source"});
        const fs::path folder = path_in(row, "folder");
        UserTexture t = texture_in(folder);
        if (t.color.empty())
            row.fail("folder", fmt::format("expected a picture named albedo, basecolor, diffuse or color in \"{}\", "
                                           "found none",
                                           folder.string()));
        if (row.has("width_m")) t.width_m = static_cast<float>(row.needed_number("width_m", 0.01, kLargest_m));
        for (std::string& one : names_in(row)) t.names.insert(t.names.begin(), std::move(one));
        t.attribution = attribution_of(row);
        out_.textures.push_back(std::move(t));
    }
    UserTexture texture_in(const fs::path& folder) const {
        constexpr float kUsualWidth_m = 1;
        UserTexture t;
        t.folder = folder;
        t.names.push_back(spoken_name(folder.filename().string()));
        t.width_m = kUsualWidth_m;
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder_ / folder)) files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        for (const fs::path& file : files) {
            const auto map = is_picture_file(file) ? map_of(file) : std::nullopt;
            if (!map) continue;
            // OpenGL's normals come before DirectX's, where there are both.
            if (*map == Map::normals_down && !t.normals.empty()) continue;
            if (*map == Map::normals && t.normals_down) t.normals.clear();
            fs::path& slot = *map == Map::color       ? t.color
                             : *map == Map::roughness ? t.roughness
                             : *map == Map::metal     ? t.metal
                             : *map == Map::height    ? t.height
                                                      : t.normals;
            if (!slot.empty()) continue;
            slot = folder / file.filename();
            if (*map == Map::normals || *map == Map::normals_down) t.normals_down = *map == Map::normals_down;
        }
        return t;
    }

    void sky_row(const toml::table& parsed, const std::string& file) {
        const TomlTable row(
            parsed, file, "[[sky]]",
            {"file", "names", "time", "turn_deg", "brightness", "title", "author", "licence", "source"});
        UserSky s;
        s.file = path_in(row, "file");
        if (!is_sky(s.file)) row.fail("file", "expected .hdr or .exr, found " + s.file.string());
        s.names = names_in(row);
        s.names.push_back(name_of_file(s.file));
        constexpr std::array<std::string_view, 5> kTimes{"morning", "day", "evening", "dusk", "night"};
        if (row.has("time")) s.time = kTimes[row.needed_choice("time", kTimes)];
        s.turn_deg = static_cast<float>(row.number("turn_deg", 0, -360, 360));
        s.brightness = static_cast<float>(row.number("brightness", 1, 0.01, 100));
        s.attribution = attribution_of(row);
        out_.skies.push_back(std::move(s));
    }

    static void name(UserModel& m, const std::string& spoken) {
        m.names = {spoken};
        m.kind = known_kind(spoken).value_or(kind_of_name(spoken));
    }

    // Hidden files and folders are left alone.
    void scan() {
        std::error_code code;
        fs::recursive_directory_iterator at(folder_, fs::directory_options::skip_permission_denied, code), end;
        for (; !code && at != end; at.increment(code)) {
            if (at->path().filename().string().starts_with(".")) {
                at.disable_recursion_pending();
                continue;
            }
            if (!at->is_regular_file(code)) continue;
            if (files_.size() == kMostFiles) {
                complain(fmt::format("{}: expected at most {} files, found more: the rest is not looked at",
                                     folder_.string(), kMostFiles));
                break;
            }
            files_.push_back(at->path().lexically_relative(folder_));
        }
        std::sort(files_.begin(), files_.end());
    }

    void loose_files() {
        std::set<fs::path> of_models, with_textures;  // folders
        for (const fs::path& file : files_)
            if (is_model(file) && file.has_parent_path()) of_models.insert(file.parent_path());
        for (const fs::path& file : files_) {
            if (is_picture_file(file) && file.has_parent_path() && map_of(file) == Map::color)
                with_textures.insert(file.parent_path());
            if (named_.contains(file)) continue;
            if (is_model(file)) loose_model(file);
            if (is_sky(file)) out_.skies.push_back({file, {name_of_file(file)}, {}, 0, 1, {}});
        }
        for (const fs::path& folder : with_textures) {
            bool is_a_models = named_.contains(folder);
            for (fs::path up = folder; !up.empty(); up = up.parent_path()) is_a_models |= of_models.contains(up);
            if (!is_a_models) out_.textures.push_back(texture_in(folder));
        }
    }
    void loose_model(const fs::path& file) {
        UserModel m;
        m.file = file;
        name(m, name_of_file(file));
        if (m.names.front().empty())
            return complain(
                fmt::format("{}: expected a name that says what it is, found none", (folder_ / file).string()));
        if (!may_be_replaced(m.kind))
            return complain(fmt::format("{}: a {} belongs to the room itself and is not taken from a file",
                                        (folder_ / file).string(), m.kind));
        out_.models.push_back(std::move(m));
    }

    fs::path folder_;
    UserAssets out_;
    std::set<fs::path> named_;     // by rows
    std::vector<fs::path> files_;  // all, relative to the folder
};

}  // namespace

std::vector<fs::path> files_of_model(const fs::path& file) {
    std::vector<fs::path> files{file};
    const fs::path folder = file.parent_path();
    const auto add = [&](const std::string& name) {
        const fs::path path = fs::path(name).lexically_normal();
        std::error_code code;
        if (name.empty() || path.is_absolute() || *path.begin() == ".." || !fs::is_regular_file(folder / path, code))
            return;
        if (std::find(files.begin(), files.end(), folder / path) == files.end()) files.push_back(folder / path);
    };
    if (ending_of(file) == ".gltf") {
        const Json gltf = Json::parse(read_file(file), nullptr, false);
        for (const char* list : {"buffers", "images"})
            if (gltf.is_object() && gltf.contains(list) && gltf.at(list).is_array())
                for (const Json& item : gltf.at(list))
                    if (item.is_object() && item.contains("uri") && item.at("uri").is_string())
                        add(item.at("uri").get<std::string>());
    }
    if (ending_of(file) == ".obj") {
        // "mtllib chair.mtl", "map_Kd textures/cloth.jpg": the last word of the line.
        const auto names_after = [&](const std::string& text, const std::vector<std::string>& keys) {
            std::istringstream lines(text);
            for (std::string line; std::getline(lines, line);) {
                std::istringstream words(line);
                std::string key, word, last;
                words >> key;
                while (words >> word) last = word;
                if (std::find(keys.begin(), keys.end(), key) != keys.end()) add(last);
            }
        };
        names_after(read_file(file), {"mtllib"});
        const std::vector<fs::path> materials(files.begin() + 1, files.end());
        for (const fs::path& one : materials)
            names_after(read_file(one), {"map_Kd", "map_Ks", "map_Ke", "map_d", "bump", "map_Bump", "map_bump"});
    }
    return files;
}

std::string spoken_name(std::string_view stem) {
    // "GreenChair" is two words.
    std::string spaced;
    for (std::size_t i = 0; i < stem.size(); ++i) {
        const auto c = static_cast<unsigned char>(stem[i]);
        if (i > 0 && std::isupper(c) && std::islower(static_cast<unsigned char>(stem[i - 1]))) spaced += ' ';
        spaced += stem[i] == '_' || stem[i] == '-' || stem[i] == '.' ? ' ' : stem[i];
    }
    static const std::set<std::string> kOfFiles{"lowpoly", "highpoly", "lod", "lod0", "final", "pbr", "gltf", "glb",
                                                "obj",     "asset",    "1k",  "2k",   "4k",    "8k",  "baked"};
    std::string name;
    for (const std::string& token : tokens_of(spaced)) {
        if (token == "," || kOfFiles.contains(token)) continue;
        const bool numbered = std::any_of(token.begin(), token.end(), [](unsigned char c) { return std::isdigit(c); });
        const bool named = std::count_if(token.begin(), token.end(),
                                         [](unsigned char c) { return c >= 'a' || c > 127; }) > 1;
        if (numbered && !named) continue;
        name += (name.empty() ? "" : " ") + token;
    }
    return name;
}

std::string kind_of_name(std::string_view name) {
    std::string kind(name);
    for (char& c : kind)
        if (!std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 128) c = '_';
    return kind;
}

UserAssets read_user_assets(const fs::path& folder) { return FolderReader(folder).read(); }

}  // namespace fastscene
