#include "fastscene/pipeline/sfm.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>

#include "fastscene/base/file.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/program.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/view_io.h"
#include "fastscene/views/spacing.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

Mat3d to_double(const Mat3f& m) {
    const auto row = [](Vec3f v) { return Vec3d{v.x, v.y, v.z}; };
    return {row(m.row0), row(m.row1), row(m.row2)};
}
Vec3d to_double(Vec3f v) { return {v.x, v.y, v.z}; }
Vec3f to_float(Vec3d v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

struct Pair {
    const View* known;
    const Photo* found;
};
std::vector<Pair> pairs_of(const std::vector<View>& known, const std::vector<Photo>& found) {
    std::map<std::string, const Photo*> by_name;
    for (const Photo& p : found) by_name[p.name] = &p;
    std::vector<Pair> out;
    for (const View& v : known)
        if (const auto at = by_name.find(v.name); at != by_name.end()) out.push_back({&v, at->second});
    return out;
}

// Mean of nearly equal rotations: normalized sum of quaternions with consistent signs.
Quatd mean_turn(const std::vector<Pair>& pairs) {
    Quatd sum{0, 0, 0, 0}, first;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Quatd q = quaternion_of(to_double(pairs[i].known->world_from_camera.rotation) *
                                      transpose(pairs[i].found->world_from_camera.rotation));
        if (i == 0) first = q;
        const double sign = q.w * first.w + q.x * first.x + q.y * first.y + q.z * first.z < 0 ? -1 : 1;
        sum = {sum.w + sign * q.w, sum.x + sign * q.x, sum.y + sign * q.y, sum.z + sign * q.z};
    }
    return sum;
}

double median(std::vector<double> v) {
    if (v.empty()) return 0;
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

// Runs colmap's subcommands in sequence on one database.
class Colmap {
  public:
    Colmap(const fs::path& dir, const Run& run) : dir_(dir), run_(run) {
        const auto found = find_program("colmap");
        if (!found)
            throw Error(
                "--views-sfm: COLMAP is not on PATH: `apt-get install --no-install-recommends colmap`, or leave the "
                "flag away (the poses are known)");
        program_ = *found;
        make_directories(dir);
    }
    void run(const std::string& command, std::vector<std::string> arguments) {
        run_.check_stop();
        arguments.insert(arguments.begin(), command);
        const fs::path log = dir_ / (command + ".log");
        const int code = run_program(program_, arguments, {log, {"QT_QPA_PLATFORM=offscreen"}, run_.stop});
        if (code == 0) return;
        std::string said = fs::exists(log) ? read_file(log) : "";
        if (said.size() > 600) said = said.substr(said.size() - 600);
        throw Error("colmap {} failed with exit code {}: {}", command, code, said);
    }

  private:
    fs::path dir_, program_;
    const Run& run_;
};

// Only views whose directions are within this angle can overlap; exhaustive matching would take most of an hour.
constexpr double kMatchDeg = 75;

std::string match_list(const std::vector<View>& views) {
    std::string out;
    const double least = std::cos(kMatchDeg * std::numbers::pi / 180);
    for (std::size_t i = 0; i < views.size(); ++i)
        for (std::size_t j = i + 1; j < views.size(); ++j)
            if (static_cast<double>(dot(views[i].world_from_camera.rotation.column(2),
                                        views[j].world_from_camera.rotation.column(2))) >= least)
                out += views[i].name + " " + views[j].name + "\n";
    return out;
}

void match(Colmap& colmap, const fs::path& dir, const fs::path& work, const std::vector<View>& views,
           const std::string& mode) {
    const Pinhole& c = views.front().camera;
    // Triangulation relies on image numbers matching our file order, which a single thread guarantees.
    const std::string threads = std::to_string(mode == "triangulate" ? 1 : thread_count());
    colmap.run("feature_extractor", {"--database_path", work / "database.db", "--image_path", dir / "images",
                                     "--ImageReader.camera_model", "PINHOLE", "--ImageReader.single_camera", "1",
                                     "--ImageReader.camera_params", fmt::format("{},{},{},{}", c.fx, c.fy, c.cx, c.cy),
                                     "--SiftExtraction.use_gpu", "0", "--SiftExtraction.num_threads", threads});
    write_file(work / "pairs.txt", match_list(views));
    colmap.run("matches_importer",
               {"--database_path", work / "database.db", "--match_list_path", work / "pairs.txt", "--match_type",
                "pairs", "--SiftMatching.use_gpu", "0", "--SiftMatching.num_threads", std::to_string(thread_count())});
}

// The mapper may produce several models; uses the one with the most images.
Capture largest_model(const fs::path& dir) {
    Capture best;
    std::vector<fs::path> models;
    if (fs::is_directory(dir))
        for (const auto& entry : fs::directory_iterator(dir)) models.push_back(entry.path());
    std::sort(models.begin(), models.end());
    for (const fs::path& path : models)
        if (is_colmap_model(path))
            if (Capture model = load_colmap_model(path); model.photos.size() > best.photos.size())
                best = std::move(model);
    return best;
}

Capture mapped(Colmap& colmap, const fs::path& dir, const fs::path& work) {
    make_directories(work / "models");
    colmap.run("mapper", {"--database_path", work / "database.db", "--image_path", dir / "images", "--output_path",
                          work / "models", "--Mapper.ba_refine_focal_length", "0", "--Mapper.ba_refine_principal_point",
                          "0", "--Mapper.ba_refine_extra_params", "0"});
    Capture best = largest_model(work / "models");
    if (best.photos.empty())
        throw Error(
            "colmap mapper: expected a model, found none: the views share too little; leave --views-sfm away (the "
            "poses are known)");
    return best;
}

Capture triangulated(Colmap& colmap, const fs::path& dir, const fs::path& work, const ViewSet& known) {
    make_directories(work / "known");
    make_directories(work / "points");
    save_views_model(work / "known", {known.views, {}});
    colmap.run("point_triangulator",
               {"--database_path", work / "database.db", "--image_path", dir / "images", "--input_path", work / "known",
                "--output_path", work / "points", "--Mapper.ba_refine_focal_length", "0",
                "--Mapper.ba_refine_principal_point", "0", "--Mapper.ba_refine_extra_params", "0"});
    return load_colmap_model(work / "points");
}

Rigid moved(const Similarity& s, const Rigidd& world_from_camera) {
    const Mat3d r = s.new_from_old * world_from_camera.rotation;
    const Vec3d t = (s.new_from_old * world_from_camera.translation) * s.scale + s.translation;
    return {{to_float(r.row0), to_float(r.row1), to_float(r.row2)}, to_float(t)};
}

void measure(const ViewSet& known, SfmResult& result) {
    std::map<std::string, const View*> found;
    for (const View& v : result.set.views) found[v.name] = &v;
    std::vector<double> positions, rotations;
    for (const View& v : known.views) {
        PoseError error{v.name, false, 0, 0};
        if (const auto at = found.find(v.name); at != found.end()) {
            const Rigid &a = v.world_from_camera, &b = at->second->world_from_camera;
            error.registered = true;
            error.position_m = static_cast<double>(length(a.translation - b.translation));
            // From the sine: the cosine is inaccurate for small angles.
            const Mat3f turn = transpose(a.rotation) * b.rotation;
            const Vec3f axis{turn.row2.y - turn.row1.z, turn.row0.z - turn.row2.x, turn.row1.x - turn.row0.y};
            error.rotation_deg = std::atan2(static_cast<double>(length(axis)) / 2,
                                            (static_cast<double>(turn.row0.x + turn.row1.y + turn.row2.z) - 1) / 2) *
                                 180 / std::numbers::pi;
            positions.push_back(error.position_m);
            rotations.push_back(error.rotation_deg);
        }
        result.report.errors.push_back(error);
    }
    SfmReport& r = result.report;
    r.views = known.views.size(), r.registered = positions.size(), r.points = result.set.points.size();
    r.position_median_m = median(positions), r.rotation_median_deg = median(rotations);
    for (const double p : positions) r.position_max_m = std::max(r.position_max_m, p);
    for (const double p : rotations) r.rotation_max_deg = std::max(r.rotation_max_deg, p);
}

}  // namespace

Similarity known_from_found(const std::vector<View>& known, const std::vector<Photo>& found) {
    const std::vector<Pair> pairs = pairs_of(known, found);
    if (pairs.empty()) throw Error("structure from motion: expected a camera of ours among those found, found none");
    const Mat3d turn = matrix_of(mean_turn(pairs));
    Vec3d known_middle, found_middle;
    for (const Pair& p : pairs) {
        known_middle += to_double(p.known->world_from_camera.translation) * (1.0 / static_cast<double>(pairs.size()));
        found_middle += (turn * p.found->world_from_camera.translation) * (1.0 / static_cast<double>(pairs.size()));
    }
    double both = 0, square = 0;
    for (const Pair& p : pairs) {
        const Vec3d a = to_double(p.known->world_from_camera.translation) - known_middle,
                    b = turn * p.found->world_from_camera.translation - found_middle;
        both += dot(a, b), square += dot(b, b);
    }
    const double scale = both > 1e-12 && square > 1e-12 ? both / square : 1;
    return {turn, scale, known_middle - found_middle * scale};
}

SfmResult structure_from_motion(const fs::path& dir, const ViewSet& known, const std::string& mode, const Run& run) {
    if (known.views.empty()) throw Error("structure from motion: expected views, found none");
    const auto begin = std::chrono::steady_clock::now();
    const fs::path work = dir / "sfm";
    Colmap colmap(work, run);
    Progress progress(run, "colmap", 3);
    match(colmap, dir, work, known.views, mode);
    progress.advance(2);
    const Capture model = mode == "triangulate" ? triangulated(colmap, dir, work, known) : mapped(colmap, dir, work);
    progress.advance();
    const Similarity ours = mode == "triangulate" ? Similarity{} : known_from_found(known.views, model.photos);
    SfmResult result;
    result.report.mode = mode;
    result.report.scale = ours.scale;
    for (const Pair& p : pairs_of(known.views, model.photos)) {
        View view = *p.known;
        if (mode != "triangulate") view.world_from_camera = moved(ours, p.found->world_from_camera);
        result.set.views.push_back(std::move(view));
    }
    std::vector<Vec3f> places;
    for (const CapturePoint& p : model.points)
        places.push_back(to_float((ours.new_from_old * p.position) * ours.scale + ours.translation));
    const std::vector<float> sizes = spacings(places);
    for (std::size_t i = 0; i < places.size(); ++i)
        result.set.points.push_back({places[i], {}, model.points[i].color, sizes[i]});
    measure(known, result);
    result.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    fs::remove_all(work);
    return result;
}

Json to_json(const SfmReport& r) {
    Json views = Json::array();
    for (const PoseError& e : r.errors)
        views.push_back(e.registered ? Json{{"view", e.view},
                                            {"registered", true},
                                            {"position_m", e.position_m},
                                            {"rotation_deg", e.rotation_deg}}
                                     : Json{{"view", e.view}, {"registered", false}});
    return {{"mode", r.mode},
            {"views", r.views},
            {"registered", r.registered},
            {"points", r.points},
            {"metres_a_unit", r.scale},
            {"position_median_m", r.position_median_m},
            {"position_max_m", r.position_max_m},
            {"rotation_median_deg", r.rotation_median_deg},
            {"rotation_max_deg", r.rotation_max_deg},
            {"errors", views}};
}

std::string table_of(const SfmReport& r) {
    std::string out = fmt::format("{:<12} {:>12} {:>14}\n", "view", "position (m)", "rotation (deg)");
    for (const PoseError& e : r.errors)
        out += e.registered ? fmt::format("{:<12} {:>12.4f} {:>14.3f}\n", e.view, e.position_m, e.rotation_deg)
                            : fmt::format("{:<12} {:>12} {:>14}\n", e.view, "-", "-");
    out += fmt::format(
        "\nregistered {} of {} views, {} points\nposition: median {:.4f} m, most {:.4f} m\nrotation: median {:.3f} "
        "deg, most {:.3f} deg\n",
        r.registered, r.views, r.points, r.position_median_m, r.position_max_m, r.rotation_median_deg,
        r.rotation_max_deg);
    return out;
}

}  // namespace fastscene
