#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "fastscene/export/identities.h"
#include "fastscene/export/labels.h"
#include "fastscene/export/object_boxes.h"
#include "fastscene/export/shell.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/scene/raised_floor.h"

namespace fastscene {
namespace {

constexpr float kScale = 100;        // SVG units per metre
constexpr float kMargin_m = 0.6f;    // for the dimension lines
constexpr float kCut_m = 1.3f;       // height of the cut: through windows, as architects draw it
constexpr float kOverhead_m = 1.9f;  // higher things are drawn without their names
constexpr float kNamed_m2 = 0.08f;   // smaller things carry no name: it would not fit

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else out += c;
    return out;
}

class Page {
  public:
    explicit Page(const Room& room) : plan_from_world_(plan_from_world(room)) {
        low_ = {1e9f, 1e9f}, high_ = {-1e9f, -1e9f};
        for (const Mesh& mesh : room.meshes)
            if (mesh.object < 0 && shell_of(room, mesh) == Shell::walls) reach_walls(room, mesh);
        if (low_.x > high_.x || low_.y > high_.y) low_ = high_ = {};
    }

    // From above: the plan's x to the right, its z up the page.
    Vec2f on_page(Vec3f world) const {
        const Vec3f p = plan_from_world_ * world;
        return {(p.x - low_.x + kMargin_m) * kScale, (high_.y - p.z + kMargin_m) * kScale};
    }
    void floor() {
        body_ += fmt::format(
            "<rect x=\"{0:.1f}\" y=\"{0:.1f}\" width=\"{1:.1f}\" height=\"{2:.1f}\" fill=\"#f3efe6\"/>\n",
            kMargin_m * kScale, (high_.x - low_.x) * kScale, (high_.y - low_.y) * kScale);
    }
    void polygon(const std::vector<Vec3f>& corners, const char* style) {
        body_ += "<polygon points=\"";
        for (const Vec3f p : corners) {
            const Vec2f q = on_page(p);
            body_ += fmt::format("{:.1f},{:.1f} ", q.x, q.y);
        }
        body_ += fmt::format("\" {}/>\n", style);
    }
    void wall(Vec3f a, Vec3f b) {
        const Vec2f p = on_page(a), q = on_page(b);
        body_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#222\" stroke-width=\"3\"/>\n", p.x,
                             p.y, q.x, q.y);
    }
    void text(Vec2f at, const std::string& words, float size, const char* more = "") {
        body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" {}>{}</text>\n", at.x, at.y, size,
                             more, escaped(words));
    }
    void dimensions() {
        const Vec2f a{kMargin_m * kScale, kMargin_m * kScale};
        const Vec2f b = a + Vec2f{high_.x - low_.x, high_.y - low_.y} * kScale;
        const float off = 0.3f * kScale;
        line({a.x, a.y - off}, {b.x, a.y - off});
        line({a.x - off, a.y}, {a.x - off, b.y});
        text({0.5f * (a.x + b.x), a.y - off - 6}, fmt::format("{:.2f} m", high_.x - low_.x), 16);
        const float x = a.x - off - 6, y = 0.5f * (a.y + b.y);
        text({x, y}, fmt::format("{:.2f} m", high_.y - low_.y), 16,
             fmt::format("transform=\"rotate(-90 {:.1f} {:.1f})\"", x, y).c_str());
    }
    std::string svg(const std::string& title) const {
        const float width = (high_.x - low_.x + 2 * kMargin_m) * kScale,
                    height = (high_.y - low_.y + 2 * kMargin_m) * kScale;
        return fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
            "height=\"{1:.0f}\" font-family=\"sans-serif\" text-anchor=\"middle\">\n<title>{2}</title>\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{3}</svg>\n",
            width, height, escaped(title), body_);
    }

  private:
    void line(Vec2f a, Vec2f b) {
        const Vec2f tick = a.y == b.y ? Vec2f{0, 6} : Vec2f{6, 0};
        for (const auto& [p, q] : {std::pair{a, b}, {a - tick, a + tick}, {b - tick, b + tick}})
            body_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#333\"/>\n", p.x, p.y, q.x, q.y);
    }
    // Walls that face into the room bound it: the farthest ones, niches included.
    void reach_walls(const Room& room, const Mesh& mesh) {
        constexpr float kFacing = 0.99f, kSlack_m = 0.05f;
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const Vec3f a = mesh.positions[mesh.triangles[t]], b = mesh.positions[mesh.triangles[t + 1]],
                        c = mesh.positions[mesh.triangles[t + 2]], middle = (a + b + c) / 3;
            const Vec3f low = room.min_corner, high = room.max_corner;
            if (middle.x < low.x - kSlack_m || middle.x > high.x + kSlack_m || middle.z < low.z - kSlack_m ||
                middle.z > high.z + kSlack_m)
                continue;
            const Vec3f n = plan_from_world_ * mesh.normals[mesh.triangles[t]], p = plan_from_world_ * a;
            if (n.x < -kFacing) high_.x = std::max(high_.x, p.x);
            if (n.x > kFacing) low_.x = std::min(low_.x, p.x);
            if (n.z < -kFacing) high_.y = std::max(high_.y, p.z);
            if (n.z > kFacing) low_.y = std::min(low_.y, p.z);
        }
    }
    Mat3f plan_from_world_;
    Vec2f low_, high_;  // x, z of the room's interior, in the plan's frame
    std::string body_;
};

// Where the walls cross a plane at that height above the floor.
void draw_walls(Page& page, const Room& room) {
    const float y = room.max_corner.y - kCut_m;
    for (const Mesh& mesh : room.meshes) {
        if (mesh.object >= 0 || shell_of(room, mesh) != Shell::walls) continue;
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            std::vector<Vec3f> ends;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3f a = mesh.positions[mesh.triangles[t + k]],
                            b = mesh.positions[mesh.triangles[t + (k + 1) % 3]];
                if ((a.y < y) != (b.y < y)) ends.push_back(lerp(a, b, (y - a.y) / (b.y - a.y)));
            }
            if (ends.size() == 2) page.wall(ends[0], ends[1]);
        }
    }
}

}  // namespace

std::string plan_svg(const TracedRoom& traced) {
    const Room& room = traced.room();
    Page page(room);
    page.floor();
    draw_walls(page, room);
    // Lower things are drawn first.
    const std::vector<ObjectBox> boxes = object_boxes(room);
    const auto top = [&](std::size_t i) { return (room.objects[i].world_from_object * boxes[i].high).y; };
    const auto is_opening = [&](std::size_t i) { return has_role(room.objects[i].kind, Role::opening); };
    std::vector<std::size_t> order(room.objects.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return top(a) > top(b); });
    for (const std::size_t i : order) {
        const RoomObject& object = room.objects[i];
        if (boxes[i].empty || (has_role(object.kind, Role::shell) && !is_opening(i) && !is_raised_floor(object)))
            continue;
        const Vec3f a = boxes[i].low, b = boxes[i].high;
        const bool door = object.kind.find("door") != std::string::npos, window = is_opening(i) && !door;
        page.polygon({object.world_from_object * Vec3f{a.x, a.y, a.z}, object.world_from_object * Vec3f{b.x, a.y, a.z},
                      object.world_from_object * Vec3f{b.x, a.y, b.z}, object.world_from_object * Vec3f{a.x, a.y, b.z}},
                     is_raised_floor(object) ? "fill=\"#e9e3d3\" stroke=\"#b5ab93\""
                     : window                ? "fill=\"#9cc9e8\" stroke=\"#2f6f9f\""
                     : door                  ? "fill=\"#d8b48a\" stroke=\"#7a5230\""
                                             : "fill=\"#c9ccd6\" fill-opacity=\"0.55\" stroke=\"#555\"");
    }
    for (const std::size_t i : order) {
        const RoomObject& object = room.objects[i];
        if (boxes[i].empty || (has_role(object.kind, Role::shell) && !is_opening(i))) continue;
        const Vec3f low = object.world_from_object * boxes[i].low;
        const float above_floor = floor_at(room, {low.x, low.z}) - low.y;
        if (const Vec3f size = boxes[i].size(); size.x * size.z > kNamed_m2 && above_floor < kOverhead_m)
            page.text(page.on_page(object.world_from_object * boxes[i].center()), object.name, 11);
    }
    page.dimensions();
    return page.svg(fmt::format("{}, {}", room.type, room.style));
}

}  // namespace fastscene
