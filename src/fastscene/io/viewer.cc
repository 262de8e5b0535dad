#include "fastscene/io/viewer.h"

#include <cmath>
#include <string>

#include "fastscene/base/base64.h"
#include "fastscene/base/check.h"
#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/io/camera_path_parts.h"
#include "fastscene/io/splat_io.h"

namespace fastscene {

extern const std::string_view kWalkBoundsScript;  // web/walk_bounds.mjs

namespace {

namespace fs = std::filesystem;

// Replaces the only occurrence of `what`. The viewer's version is pinned; a page without the pattern is another
// version.
void replace_once(std::string& page, std::string_view what, std::string_view by, const fs::path& file) {
    const std::size_t at = page.find(what);
    if (at == std::string::npos)
        throw Error("{}: expected \"{}\" in this page of @playcanvas/supersplat-viewer 1.36.2, found another version",
                    file.string(), what);
    page.replace(at, what.size(), by);
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

std::string html_escaped(std::string text) {
    replace_all(text, "&", "&amp;");
    replace_all(text, "<", "&lt;");
    return text;
}

// The licences of the package and of its engine, included in the page.
std::string notices(const fs::path& viewer_dir) {
    std::string text = "Made by fastscene. Shown by @playcanvas/supersplat-viewer and the PlayCanvas engine (MIT):\n";
    for (const fs::path& file : {viewer_dir / "LICENSE", viewer_dir.parent_path() / "LICENSE"})
        if (fs::exists(file)) {
            text += read_file(file);
            break;
        }
    // Two consecutive dashes would end the comment.
    for (std::size_t i = 1; i < text.size(); ++i)
        if (text[i] == '-' && text[i - 1] == '-') text.insert(i, " ");
    return text;
}

Json viewer_point(Vec3f world) { return {-world.x, -world.y, world.z}; }

double tenth_of_millimetre(float metres) { return std::round(metres * 1e4) / 1e4; }

// The script's WalkBounds parameters, in the viewer's frame (y up).
Json viewer_rings(const std::vector<std::vector<Vec2f>>& rings_m) {
    Json rings = Json::array();
    for (const auto& ring : rings_m) {
        Json points = Json::array();
        for (const Vec2f p : ring) points.push_back({tenth_of_millimetre(-p.x), tenth_of_millimetre(p.y)});
        rings.push_back(points);
    }
    return rings;
}
Json viewer_bounds(const WalkableArea& area) {
    Json out{{"rings", viewer_rings(area.rings_m)},
             {"low", tenth_of_millimetre(-area.high_y)},
             {"high", tenth_of_millimetre(-area.low_y)},
             {"ground", tenth_of_millimetre(-area.floor_y)}};
    for (const WalkableArea::Level& level : area.levels)
        out["levels"].push_back(
            {{"rings", viewer_rings(level.rings_m)}, {"raised", tenth_of_millimetre(area.floor_y - level.floor_y)}});
    return out;
}

void remove_export(std::string& script, std::string_view exported, const fs::path& file) {
    const std::size_t at = script.rfind(exported);
    if (at == std::string::npos)
        throw Error("{}: expected \"{}\", found another version of the viewer", file.string(), exported);
    script.erase(at, exported.size());
}

// Connects walk_bounds.mjs to the viewer's cameras; docs/decisions/0011-our-own-walk-bounds.md explains why the
// viewer's own collisions do not serve.
void hold_camera(std::string& script, const WalkableArea& area, const fs::path& file) {
    FASTSCENE_CHECK(!area.rings_m.empty());
    // Constrains each controller step, and then the displayed pose, which may be a blend of two.
    const std::string step = "controller.update(dt, frame, target);";
    const std::string shown = "lastPosition.copy(this.camera.position);";
    replace_once(script, step, step + " walkBounds.hold(state.cameraMode, controller, target, dt);", file);
    replace_once(script, shown, "walkBounds.holdBlend(this.camera); " + shown, file);
    const std::string made = "this.update = (deltaTime, frame) => {";
    replace_once(script, made, "walkBounds.listen(events); " + made, file);
    // Forward motion is always level; up and down have separate keys.
    replace_once(script, "setCameraBasis(this._angles, forward$2, right$2, up$1);",
                 "setYawBasis(this._angles.y, forward$2, right$2); up$1.copy(Vec3.UP);", file);
    replace_once(script, "source.navigateTo(position, speedMul);",
                 "source.navigateTo(walkBounds.walkTarget(position), speedMul);", file);
    // In virtual reality the world's floor is the room's.
    replace_once(script, "parent.script.create(XrNavigation);",
                 "parent.script.create(XrNavigation, { properties: { groundHeight: walkBounds.ground } });\n"
                 "    app.on('update', () => { if (xr.active) walkBounds.holdRig(parent, camera); });",
                 file);
    replace_once(script, "parent.setPosition(cameraPosition.x, 0, cameraPosition.z);",
                 "parent.setPosition(cameraPosition.x, walkBounds.ground, cameraPosition.z);", file);
    std::string bounds(kWalkBoundsScript);
    remove_export(bounds, "export { WalkBounds, WalkableFloor };", "web/walk_bounds.mjs");
    bounds += "return new WalkBounds(" + viewer_bounds(area).dump() + ");\n";
    script.insert(0, "const walkBounds = (() => {\n" + bounds + "})();\n");
}

}  // namespace

std::string viewer_settings(const ViewerScene& scene) {
    const Json off = {{"enabled", false}};
    Json effects = {{"sharpness", off}, {"bloom", off}, {"grading", off}, {"vignette", off}, {"fringing", off}};
    effects["sharpness"]["amount"] = 0;
    effects["bloom"].update(Json{{"intensity", 1}, {"blurLevel", 2}});
    effects["grading"].update(Json{{"brightness", 0}, {"contrast", 1}, {"saturation", 1}, {"tint", {1, 1, 1}}});
    effects["vignette"].update(Json{{"intensity", 0.5}, {"inner", 0.3}, {"outer", 0.75}, {"curvature", 1}});
    effects["fringing"]["intensity"] = 0.5;
    const Json camera = {{"position", viewer_point(scene.camera_position_m)},
                         {"target", viewer_point(scene.camera_target_m)},
                         {"fov", scene.fov_deg}};
    const Json settings = {{"version", 2},
                           {"tonemapping", "none"},
                           {"highPrecisionRendering", false},
                           {"background", {{"color", {0, 0, 0}}}},
                           {"postEffectSettings", effects},
                           {"animTracks", scene.tour ? Json::array({supersplat_track(*scene.tour)}) : Json::array()},
                           {"cameras", Json::array({Json{{"initial", camera}}})},
                           {"annotations", Json::array()},
                           {"startMode", scene.tour ? "animTrack" : "default"}};
    return settings.dump();
}

void save_viewer_html(const fs::path& path, const Splats& splats, const ViewerScene& scene,
                      const fs::path& viewer_dir) {
    const fs::path index = viewer_dir / "index.html";
    std::string page = read_file(index), css = read_file(viewer_dir / "index.css"),
                script = read_file(viewer_dir / "index.js");

    // A module embedded in the page must not have exports.
    remove_export(script, "export { createViewer };", viewer_dir / "index.js");
    // Source maps are not included.
    if (const std::size_t map = script.rfind("//# sourceMappingURL="); map != std::string::npos) script.erase(map);
    if (scene.walkable) hold_camera(script, *scene.walkable, viewer_dir / "index.js");
    replace_all(script, "</script", "<\\/script");

    Json bootstrap = {{"settings", Json::parse(viewer_settings(scene))},
                      {"contentUrl", "data:application/octet-stream;base64," + base64(compressed_ply_bytes(splats))},
                      {"contentFilename", "scene.compressed.ply"}};
    std::string boot = bootstrap.dump();
    replace_all(boot, "</", "<\\/");

    // The longest text is inserted last, so that no pattern matches inside it.
    replace_once(page, "<link rel=\"stylesheet\" href=\"./index.css\" />", "<style>" + css + "</style>", index);
    replace_once(page, "<title>SuperSplat Viewer</title>",
                 "<title>" + html_escaped(scene.title) + "</title>\n<!--\n" + notices(viewer_dir) + "-->", index);
    // Visitors start at rest and free to walk; a tour waits for its button.
    replace_once(page, "noanim: url.searchParams.has('noanim')", "noanim: !url.searchParams.has('anim')", index);
    replace_once(script, "state.cameraMode = state.hasAnimation ? 'anim' :",
                 "state.cameraMode = state.hasAnimation && !global.config.noanim ? 'anim' :", viewer_dir / "index.js");
    // Splats are blended in the order that they were trained in: by depth. The view through a window is a thin shell,
    // all of it equally far from the room; sorted by distance it smears.
    replace_once(script, "gsplat.radialSorting = true;", "gsplat.radialSorting = false;", viewer_dir / "index.js");
    if (splats.filter.antialias) replace_once(page, "aa: url.searchParams.has('aa')", "aa: true", index);
    const std::size_t import_at = page.find("import { createViewer } from './index.js';");
    if (import_at == std::string::npos) replace_once(page, "import { createViewer } from './index.js';", "", index);
    const std::size_t boot_at = page.find("id=\"sse-bootstrap\"");
    if (boot_at == std::string::npos)
        throw Error("{}: expected id=\"sse-bootstrap\", found another version of the viewer", index.string());
    const std::size_t begin = page.find('>', boot_at) + 1, end = page.find("</script>", begin);
    if (end == std::string::npos) throw Error("{}: expected </script> after sse-bootstrap, found none", index.string());
    page.replace(begin, end - begin, boot);
    replace_once(page, "import { createViewer } from './index.js';", script, index);
    write_file(path, page);
}

}  // namespace fastscene
