#include "fastscene/io/obj.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/io/smooth_normals.h"

namespace fastscene {
namespace {

struct Corner {
    int position = -1, uv = -1, normal = -1;
};
struct Face {
    std::array<Corner, 3> corners;
    std::size_t material;
};

// The words of a line.
class Words {
  public:
    explicit Words(std::string_view line) : rest_(line) {}
    std::string_view next() {
        const auto begin = rest_.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) return rest_ = {};
        const auto end = rest_.find_first_of(" \t\r", begin);
        const std::string_view word = rest_.substr(begin, end == std::string_view::npos ? end : end - begin);
        rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end);
        return word;
    }
    // Names may contain spaces.
    std::string_view all() const {
        const auto begin = rest_.find_first_not_of(" \t\r"), end = rest_.find_last_not_of(" \t\r");
        return begin == std::string_view::npos ? std::string_view{} : rest_.substr(begin, end - begin + 1);
    }

  private:
    std::string_view rest_;
};

std::optional<float> number(std::string_view word) {
    float value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || !std::isfinite(value)) return {};
    return value;
}

template <class F>
void each_line(std::string_view text, F&& f) {
    for (std::size_t line = 1; !text.empty(); ++line) {
        const auto end = text.find('\n');
        f(text.substr(0, end), line);
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    }
}

class Reader {
  public:
    Reader(const std::string& where, const std::function<std::optional<std::string>(const std::string&)>& read_sibling)
        : where_(where), read_sibling_(read_sibling) {
        model_.materials.push_back({});
    }

    ObjModel read(std::string_view text) {
        each_line(text, [&](std::string_view line, std::size_t at) { read_line(line, at); });
        if (faces_.empty()) throw Error("{}: expected faces, found none", where_);
        build();
        return std::move(model_);
    }

  private:
    float need(Words& words, std::size_t line) {
        const std::string_view word = words.next();
        if (const auto value = number(word)) return *value;
        throw Error("{}: line {}: expected a number, found '{}'", where_, line, word);
    }

    void read_line(std::string_view line, std::size_t at) {
        Words words(line);
        const std::string_view key = words.next();
        if (key == "v") {
            const float x = need(words, at), y = need(words, at), z = need(words, at);
            positions_.push_back({x, y, z});
        } else if (key == "vn") {
            const float x = need(words, at), y = need(words, at), z = need(words, at);
            normals_.push_back({x, y, z});
        } else if (key == "vt") {
            const float u = need(words, at);
            uvs_.push_back({u, number(words.next()).value_or(0.f)});
        } else if (key == "f") {
            read_face(words, at);
        } else if (key == "usemtl") {
            use(std::string(words.all()));
        } else if (key == "mtllib") {
            if (const auto text = read_sibling_(std::string(words.all()))) read_materials(*text);
        }
    }

    int index(std::string_view word, std::size_t count, std::size_t line) const {
        int value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        const auto n = static_cast<int>(count);
        const int i = value < 0 ? n + value : value - 1;
        if (error != std::errc() || i < 0 || i >= n)
            throw Error("{}: line {}: expected an index from 1 to {}, found '{}'", where_, line, count, word);
        return i;
    }

    void read_face(Words& words, std::size_t line) {
        std::vector<Corner> corners;
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            Corner corner;
            const auto first = word.find('/');
            corner.position = index(word.substr(0, first), positions_.size(), line);
            if (first != std::string_view::npos) {
                const auto second = word.find('/', first + 1);
                const std::string_view uv = word.substr(first + 1,
                                                        second == std::string_view::npos ? second : second - first - 1);
                if (!uv.empty()) corner.uv = index(uv, uvs_.size(), line);
                if (second != std::string_view::npos && second + 1 < word.size())
                    corner.normal = index(word.substr(second + 1), normals_.size(), line);
            }
            corners.push_back(corner);
        }
        for (std::size_t i = 2; i < corners.size(); ++i)
            faces_.push_back({{corners[0], corners[i - 1], corners[i]}, current_});
    }

    void use(const std::string& name) {
        for (std::size_t i = 0; i < model_.materials.size(); ++i)
            if (model_.materials[i].name == name) {
                current_ = i;
                return;
            }
        current_ = model_.materials.size();
        model_.materials.emplace_back().name = name;
    }

    void read_materials(std::string_view text) {
        ObjMaterial* material = nullptr;
        each_line(text, [&](std::string_view line, std::size_t) {
            Words words(line);
            const std::string_view key = words.next();
            if (key == "newmtl") {
                use(std::string(words.all()));
                material = &model_.materials[current_];
                return;
            }
            if (!material) return;
            const auto color = [&](Vec3f& c) {
                const auto x = number(words.next()), y = number(words.next()), z = number(words.next());
                if (x && y && z) c = {*x, *y, *z};
                else if (x) c = {*x, *x, *x};
            };
            if (key == "Kd") color(material->diffuse);
            if (key == "Ks") color(material->specular);
            if (key == "Ke") color(material->emission);
            if (key == "Ns") material->shininess = number(words.next()).value_or(0.f);
            if (key == "d") material->opacity = number(words.next()).value_or(1.f);
            if (key == "map_Kd") material->diffuse_map = std::string(words.all());
        });
        current_ = 0;
    }

    Vec3f face_normal(const Face& f) const {
        const Vec3f a = positions_[static_cast<std::size_t>(f.corners[0].position)];
        return cross(positions_[static_cast<std::size_t>(f.corners[1].position)] - a,
                     positions_[static_cast<std::size_t>(f.corners[2].position)] - a);
    }

    void build() {
        SmoothNormals smooth(positions_.size());
        for (const Face& face : faces_) {
            const auto corner = [&](std::size_t i) { return static_cast<std::size_t>(face.corners[i].position); };
            smooth.add({corner(0), corner(1), corner(2)}, face_normal(face));
        }
        std::vector<ObjGroup> groups(model_.materials.size());
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            Face& face = faces_[i];
            Vec3f own = face_normal(face);
            if (!(length(own) > 0)) continue;  // zero area
            // Some exporters' winding contradicts their normals.
            Vec3f told{};
            for (const Corner& c : face.corners)
                if (c.normal >= 0) told += normals_[static_cast<std::size_t>(c.normal)];
            const bool turned = dot(told, own) < 0;
            if (turned) std::swap(face.corners[1], face.corners[2]), own = -own, smooth.turn(i);
            ObjGroup& group = groups[face.material];
            for (const Corner& c : face.corners) {
                Vec3f n = c.normal >= 0 ? normals_[static_cast<std::size_t>(c.normal)] : Vec3f{};
                if (!(length(n) > 1e-6f)) n = smooth.at(static_cast<std::size_t>(c.position), own);
                group.triangles.push_back(static_cast<std::uint32_t>(group.positions.size()));
                group.positions.push_back(positions_[static_cast<std::size_t>(c.position)]);
                group.normals.push_back(normalize(n));
                group.uvs.push_back(c.uv >= 0 ? uvs_[static_cast<std::size_t>(c.uv)] : Vec2f{});
            }
        }
        for (std::size_t i = 0; i < groups.size(); ++i)
            if (!groups[i].triangles.empty()) {
                groups[i].material = i;
                model_.groups.push_back(std::move(groups[i]));
            }
    }

    const std::string& where_;
    const std::function<std::optional<std::string>(const std::string&)>& read_sibling_;
    ObjModel model_;
    std::vector<Vec3f> positions_, normals_;
    std::vector<Vec2f> uvs_;
    std::vector<Face> faces_;
    std::size_t current_ = 0;
};

}  // namespace

ObjModel parse_obj(std::string_view text, const std::string& where,
                   const std::function<std::optional<std::string>(const std::string&)>& read_sibling) {
    return Reader(where, read_sibling).read(text);
}

}  // namespace fastscene
