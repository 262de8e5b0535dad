// The published walk: warp, cubemap, inpainting of faces, and one whole step.
#include <algorithm>
#include <bit>
#include <memory>
#include <optional>
#include <regex>

#include "fastscene/base/file.h"
#include "fastscene/geometry/published_cube.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/nn/aotgan_net.h"
#include "fastscene/nn/egformer_net.h"
#include "fastscene/walk/published_inpaint.h"
#include "fastscene/walk/published_warp.h"
#include "golden.h"

namespace fastscene::golden {
namespace {

constexpr double kDepthUnit = 60000;  // of the 16-bit depth maps among the inputs
constexpr int kFace = 512;

// Many tolerances are sentences: "1, <=0.5 % of samples more", "<=0.2 % (step 2: 1 %) of bits differ", "5e-3 max, 5e-4
// mean". An absolute limit applies to all samples; a share allows that many outliers.
struct Sentence {
    double each = 0, share = 0, mean = 1e300;
};
Sentence sentence_of(const Json& tol, bool second_step) {
    if (tol.is_number()) return {tol.get<double>(), 0, 1e300};
    const std::string text = tol.get<std::string>();
    Sentence out;
    std::smatch m;
    static const std::regex leading(R"(^\s*([0-9.]+(?:e-?[0-9]+)?)(?!\s*%))"), levels(R"(at most ([0-9]+) level)"),
        percent(R"(([0-9.]+)\s*%)"), step_two(R"(step 2: ([0-9.]+)\s*%)"), mean(R"(([0-9.]+(?:e-?[0-9]+)?) mean)");
    if (std::regex_search(text, m, levels) || std::regex_search(text, m, leading)) out.each = std::stod(m[1]);
    if (std::regex_search(text, m, percent)) out.share = std::stod(m[1]) / 100;
    if (second_step && std::regex_search(text, m, step_two)) out.share = std::stod(m[1]) / 100;
    if (std::regex_search(text, m, mean)) out.mean = std::stod(m[1]);
    return out;
}

// Compares every tensor of that name; packed ones bit by bit.
void compare(Case& c, const std::string& name, const std::vector<double>& ours) {
    for (const Json& t : c.json().at("tensors")) {
        if (t.at("name") != name) continue;
        const at::Tensor stored = c.network().stored(t).to(at::kDouble);
        const auto stride = t.at("stride").get<std::size_t>(), count = static_cast<std::size_t>(stored.numel());
        if (ours.size() < (count - 1) * stride + 1) {
            c.put({name, std::nan(""), std::nan(""), 0, false,
                   fmt::format("expected shape {}, found {} numbers", t.at("shape").dump(), ours.size())});
            continue;
        }
        const bool bits = name.find("pack") != std::string::npos;
        const Sentence tol = sentence_of(t.at("tol"), c.name() == "step2");
        // Integers must be equal; floats computed in another order may differ in their last digits.
        const double each = std::max(tol.each, t.at("dtype") == "uint8" ? 0.0 : 1e-6);
        double worst = 0, sum = 0, square = 0, norm = 0, beyond = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double r = stored.data_ptr<double>()[i], v = ours[i * stride], d = std::abs(r - v);
            worst = std::isnan(d) ? d : std::max(worst, d);
            sum += d;
            square += d * d;
            norm += r * r;
            if (bits) beyond += std::popcount(static_cast<unsigned>(r) ^ static_cast<unsigned>(v));
            else beyond += !(d <= each);
        }
        const double share = beyond / (static_cast<double>(count) * (bits ? 8 : 1));
        const bool good = share <= tol.share && sum / static_cast<double>(count) <= tol.mean;
        c.put({name, worst, std::sqrt(square / std::max(norm, 1e-30)), each, good,
               fmt::format("{:.4f} % beyond, {:.4f} % allowed", 100 * share, 100 * tol.share)});
    }
}
// "1e-3 relative" or a number.
void compare_value(Case& c, const std::string& name, const std::vector<double>& ours) {
    if (!c.json().contains("values")) return;
    for (const Json& entry : c.json().at("values")) {
        if (entry.at("name") != name) continue;
        const Json& value = entry.at("value");
        const auto theirs = value.is_array() ? value.get<std::vector<double>>()
                                             : std::vector<double>{value.get<double>()};
        double worst = theirs.size() == ours.size() ? 0 : std::nan(""), largest = 0;
        for (std::size_t i = 0; i < std::min(theirs.size(), ours.size()); ++i) {
            worst = std::max(worst, std::abs(theirs[i] - ours[i]));
            largest = std::max(largest, std::abs(theirs[i]));
        }
        double allowed = 1e-6 * std::max(1.0, largest);
        if (entry.contains("tol")) {
            const Json& tol = entry.at("tol");
            allowed = tol.is_number() ? tol.get<double>() : std::stod(tol.get<std::string>()) * largest;
        } else if (name == "mean_abs_error_vs_input") {
            allowed = 1e-4;  // has no tolerance of its own; its tensor has 5e-4
        }
        c.put({name, worst, largest > 0 ? worst / largest : worst, allowed, worst <= allowed, ""});
    }
}

std::vector<double> numbers_of(const ImageRgb8& image) {
    std::vector<double> out;
    for (const Rgb8 p : image.pixels) out.insert(out.end(), {double(p.r), double(p.g), double(p.b)});
    return out;
}
template <class T>
std::vector<double> numbers_of(const Image<T>& image) {
    return {image.pixels.begin(), image.pixels.end()};
}
std::vector<double> packed(const ImageMask& mask) {  // first pixel in the highest bit
    std::vector<double> out((mask.size() + 7) / 8);
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask.pixels[i]) out[i / 8] += 128 >> (i % 8);
    return out;
}
void append_planes(const ImageColor& image, std::vector<double>& out) {  // channel by channel
    for (std::size_t k = 0; k < 3; ++k)
        for (const Vec3f& p : image.pixels) out.push_back(p[k]);
}
ImageColor unit_of(const ImageRgb8& image) {
    ImageColor out(image.width, image.height);
    for (std::size_t i = 0; i < out.size(); ++i) out.pixels[i] = unit_from_srgb8(image.pixels[i]);
    return out;
}

ImageMask holes_of(const PublishedWarp& warp) {
    ImageMask out(warp.color.width, warp.color.height);
    for (std::size_t i = 0; i < out.size(); ++i) out.pixels[i] = warp.source.pixels[i] == kNoSource ? 255 : 0;
    return out;
}

// "inputs/pano_a.png + inputs/depth_a.png/60000.0 (float64)"
struct Input {
    ImageRgb8 color;
    Image<double> range;
};
Input input_of(const Case& c, const std::string& text) {
    static const std::regex file(R"(inputs/[A-Za-z0-9_.-]+\.png)");
    std::vector<std::string> files;
    for (std::sregex_iterator i(text.begin(), text.end(), file), end; i != end; ++i) files.push_back(i->str());
    if (files.size() != 2) throw Error("expected a picture and a depth map, found \"{}\"", text);
    Input out{load_rgb8(c.network().set() / files[0]), {}};
    const ImageF depth = load_float(c.network().set() / files[1], 1.f);  // 16-bit numbers are exact as floats
    out.range = Image<double>(depth.width, depth.height);
    for (std::size_t i = 0; i < depth.size(); ++i)
        out.range.pixels[i] = static_cast<double>(depth.pixels[i]) / kDepthUnit;
    return out;
}

Vec3d move_of(const std::string& direction, double mov, double flag) {
    const double m = mov * flag;
    if (direction == "x") return {m, 0, 0};
    if (direction == "y") return {0, m, 0};
    if (direction == "z") return {0, 0, m};
    if (direction == "xz") return {m, 0, m};
    if (direction == "-xz") return {m, 0, -m};
    throw Error("direction \"{}\" is not known", direction);
}

void compare_warp_values(Case& c, const PublishedWarp& warp) {
    double holes_inside = 0, depth = 0, valid = 0;
    Vec3d color{};
    const int w = warp.color.width, h = warp.color.height;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const bool hole = warp.source.at(x, y) == kNoSource;
            if (hole) {
                holes_inside += x > 0 && y > 0;
                continue;
            }
            depth += warp.range.at(x, y);
            const Rgb8 p = warp.color.at(x, y);
            color += Vec3d{double(p.r), double(p.g), double(p.b)};
            ++valid;
        }
    compare_value(c, "hole_ratio", {warp.hole_ratio()});
    compare_value(c, "hole_ratio_without_row0_col0", {holes_inside / (double(w - 1) * (h - 1))});
    compare_value(c, "sum_of_valid_depth", {depth});
    compare_value(c, "mean_valid_rgb", {color.x / valid, color.y / valid, color.z / valid});
}

void check_warp(Case& c) {
    const Input input = input_of(c, c.input());
    const PublishedWarp warp = published_warp(
        input.color, published_units(input.range),
        move_of(c.json().at("dir"), c.json().at("mov"), c.json().value("flag", 1)));
    compare(c, "mask_packed_rowmajor_msb_first", packed(holes_of(warp)));
    compare(c, "img", numbers_of(warp.color));
    compare(c, "depth", numbers_of(warp.range));
    compare_warp_values(c, warp);
}

// Of hashed numbers: one color per pixel, depth in blocks of a 4 x 8 grid.
void check_small_warp(Case& c) {
    std::int64_t h = 32, w = 64;
    for (const Json& t : c.json().at("tensors"))
        if (t.at("name") == "img") h = t.at("shape")[0], w = t.at("shape")[1];
    const at::Tensor rgb = (unit(c.input() + "/rgb", {h, w, 3}) * 256).floor().to(at::kByte).contiguous();
    const at::Tensor blocks = (unit(c.input() + "/depth", {4, 8}).to(at::kDouble) * 0.4 + 0.6).contiguous();
    ImageRgb8 color(static_cast<int>(w), static_cast<int>(h));
    std::copy_n(reinterpret_cast<const Rgb8*>(rgb.data_ptr<std::uint8_t>()), color.size(), color.pixels.data());
    Image<double> range(color.width, color.height);
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x)
            range.at(x, y) = blocks.data_ptr<double>()[(y * 4 / range.height) * 8 + x * 8 / range.width];
    const auto cam = c.json().at("cam").get<std::vector<double>>();
    const Image<double> units = published_units(range);
    PublishedWarp warp = published_warp(color, units, {cam[0], cam[1], cam[2]});
    ImageMask valid(color.width, color.height);
    for (std::size_t i = 0; i < valid.size(); ++i) {
        valid.pixels[i] = warp.source.pixels[i] != kNoSource;
        if (!valid.pixels[i]) warp.color.pixels[i] = {0, 0, 0};  // the official program fills holes with white later
    }
    compare(c, "img", numbers_of(warp.color));
    compare(c, "depth", numbers_of(warp.range));
    compare(c, "mask(1=valid)", numbers_of(valid));
    std::vector<double> points;
    const Image<Vec3d> directions = published_directions(color.width, color.height);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vec3d p = directions.pixels[i] * units.pixels[i];
        points.insert(points.end(), {p.x, p.y, p.z});
    }
    compare(c, "coord", points);
    compare_warp_values(c, warp);
}

ImageColor hashed_picture(const at::Tensor& planes) {  // [3, h, w]
    const at::Tensor p = planes.permute({1, 2, 0}).contiguous();
    ImageColor out(static_cast<int>(p.size(1)), static_cast<int>(p.size(0)));
    std::copy_n(reinterpret_cast<const Vec3f*>(p.data_ptr<float>()), out.size(), out.pixels.data());
    return out;
}
ImageColor picture_of(const Case& c) {
    if (c.input().starts_with("inputs/")) return unit_of(load_rgb8(c.network().set() / c.input()));
    return hashed_picture(unit(c.input(), c.shape())[0]);
}

void check_to_faces(Case& c) {
    const ImageColor picture = picture_of(c);
    const int size = c.json().at("cube_dim");
    std::vector<double> faces, nearest;
    for (std::size_t f = 0; f < kPublishedFaces.size(); ++f) {
        append_planes(published_face(picture, kPublishedFaces[f], size), faces);
        append_planes(published_face(picture, kPublishedFaces[f], size, PublishedSampling::nearest), nearest);
        std::vector<double> grid;
        for (const Vec2f& p : published_face_grid(kPublishedFaces[f], size).pixels) grid.insert(grid.end(), {p.x, p.y});
        compare(c, fmt::format("grid_{}", f), grid);
    }
    compare(c, "faces", faces);
    compare(c, "faces_nearest", nearest);
}

void check_from_faces(Case& c) {
    const at::Tensor hashed = unit(c.input(), c.shape());
    std::array<ImageColor, 6> faces;
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = hashed_picture(hashed[static_cast<std::int64_t>(f)]);
    const int height = c.json().at("equ_h");
    std::vector<double> equi;
    append_planes(published_equirect(faces, c.json().at("cube_length"), height), equi);
    compare(c, "equi", equi);
    compare(c, "face_index", numbers_of(published_face_index(height)));
}

void check_round_trip(Case& c) {
    const ImageColor picture = picture_of(c);
    std::array<ImageColor, 6> faces;
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = published_face(picture, kPublishedFaces[f], kFace);
    const ImageColor back = published_equirect(faces, 2 * kFace, picture.height);
    std::vector<double> equi;
    append_planes(back, equi);
    compare(c, "equi", equi);
    double error = 0;
    for (std::size_t i = 0; i < back.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) error += std::abs(back.pixels[i][k] - picture.pixels[i][k]);
    compare_value(c, "mean_abs_error_vs_input", {error / (3.0 * static_cast<double>(back.size()))});
}

// The pictures of the warps in the same set.
Input input_of_warps(const Case& c) {
    const Json manifest = read_json(c.network().set() / "cvs_warp" / "manifest.json");
    for (const auto& [name, json] : manifest.at("cases").items())
        if (json.contains("mov")) return input_of(c, json.at("input"));
    throw Error("expected a case of cvs_warp in the same set, found none");
}

// "output of cvs_warp generate(+x, 0.02)"; the network is replaced by 255 - face.
void check_faces(Case& c) {
    static const std::regex call(R"(generate\(([+-])(-?[xyz]+), ([0-9.]+)\))");
    std::smatch m;
    const std::string text = c.input();
    if (!std::regex_search(text, m, call))
        throw Error("expected \"generate(+x, 0.02)\" or the like, found \"{}\"", text);
    const Input input = input_of_warps(c);
    const PublishedWarp warp = published_warp(input.color, published_units(input.range),
                                              move_of(m[2], std::stod(m[3]), m[1] == "-" ? -1 : 1));
    const auto faces = published_faces(warp.color, holes_of(warp), kFace);
    std::array<ImageRgb8, 6> painted;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        compare(c, fmt::format("face_mask_{} packbits", f), packed(faces[f].hole));
        compare(c, fmt::format("face_img_{}", f), numbers_of(faces[f].color));
        const auto masked = std::count(faces[f].hole.pixels.begin(), faces[f].hole.pixels.end(), 255);
        compare_value(c, fmt::format("face_mask_ratio_{}", f),
                      {static_cast<double>(masked) / static_cast<double>(faces[f].hole.size())});
        painted[f] = faces[f].color;
        for (Rgb8& p : painted[f].pixels)
            p = {static_cast<std::uint8_t>(255 - p.r), static_cast<std::uint8_t>(255 - p.g),
                 static_cast<std::uint8_t>(255 - p.b)};
    }
    compare(c, "merged", numbers_of(published_merge(warp.color, holes_of(warp), painted)));
}

// Calls the two networks like the official program, with hashed weights.
ImageRgb8 painted_by_aotgan(const ImageRgb8& color, const ImageMask& hole) {
    const at::Tensor mask = at::from_blob(const_cast<std::uint8_t*>(hole.pixels.data()),
                                          {1, 1, hole.height, hole.width}, at::kByte)
                                .gt(0)
                                .to(at::kFloat);
    const at::Tensor picture = bytes_of(color).to(at::kFloat).div(255).mul(2).sub(1).permute({2, 0, 1}).unsqueeze(0);
    nn::HashedWeights weights;
    const at::Tensor made = nn::aotgan_generator(nn::Scope(weights), {}, picture * (1 - mask) + mask, mask);
    const at::Tensor bytes = ((made.clamp(-1, 1) + 1) / 2 * 255).to(at::kByte)[0].permute({1, 2, 0}).contiguous();
    ImageRgb8 out(color.width, color.height);
    std::copy_n(reinterpret_cast<const Rgb8*>(bytes.data_ptr<std::uint8_t>()), out.size(), out.pixels.data());
    return out;
}
Image<double> depth_by_egformer(const ImageRgb8& color) {
    const at::Tensor picture = bytes_of(color).to(at::kFloat).div(255).permute({2, 0, 1}).unsqueeze(0).contiguous();
    nn::HashedWeights weights;
    const nn::EgformerConstants constants({color.height, color.width, 32});
    const at::Tensor depth = nn::egformer(nn::Scope(weights), constants, picture).to(at::kDouble).contiguous();
    Image<double> out(color.width, color.height);
    std::copy_n(depth.data_ptr<double>(), out.size(), out.pixels.data());
    return out;
}
std::vector<double> mean_std_min_max(const Image<double>& image) {
    double sum = 0, square = 0;
    for (const double v : image.pixels) sum += v, square += v * v;
    const auto [low, high] = std::minmax_element(image.pixels.begin(), image.pixels.end());
    const double mean = sum / static_cast<double>(image.size());
    return {mean, std::sqrt(square / static_cast<double>(image.size()) - mean * mean), *low, *high};
}

// Whole steps of the published walk. The second starts where the first ended, which `last` stores.
void check_step(Case& c, std::optional<Input>& last) {
    if (c.input().starts_with("inputs/")) last = input_of(c, c.input());
    if (!last) throw Error("expected the step before this one in the same run, found none");
    const PublishedWarp warp = published_warp(last->color, published_units(last->range),
                                              move_of("x", c.json().at("mov"), 1));
    const ImageMask holes = holes_of(warp);
    last->color = published_inpaint(warp.color, holes, kFace, painted_by_aotgan);
    last->range = depth_by_egformer(last->color);
    compare(c, "mask packbits", packed(holes));
    compare(c, "warped img", numbers_of(warp.color));
    compare(c, "inpainted rgb", numbers_of(last->color));
    compare(c, "depth (EGformer of inpainted rgb)", numbers_of(last->range));
    compare_value(c, "hole_ratio", {warp.hole_ratio()});
    Vec3d sum{};
    for (const Rgb8 p : last->color.pixels) sum += Vec3d{double(p.r), double(p.g), double(p.b)};
    const auto count = static_cast<double>(last->color.size());
    compare_value(c, "mean_inpainted_rgb", {sum.x / count, sum.y / count, sum.z / count});
    compare_value(c, "depth_mean_std_min_max", mean_std_min_max(last->range));
}

}  // namespace

void add_geometry_checkers(Checkers& checkers) {
    checkers.emplace_back("cvs_warp", [](Case& c) { c.json().contains("mov") ? check_warp(c) : check_small_warp(c); });
    checkers.emplace_back("e2c_c2e", [](Case& c) {
        if (c.json().contains("cube_dim")) check_to_faces(c);
        else if (c.json().contains("cube_length")) check_from_faces(c);
        else check_round_trip(c);
    });
    checkers.emplace_back("inpaint_faces", check_faces);
    checkers.emplace_back("pnvi_step",
                          [last = std::make_shared<std::optional<Input>>()](Case& c) { check_step(c, *last); });
}

}  // namespace fastscene::golden
