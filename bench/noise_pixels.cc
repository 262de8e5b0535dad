#include "bench/noise_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "cpu_clock.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/trace/film.h"

namespace fastscene::bench {
namespace {

constexpr int kSide = 4, kParts = kSide * kSide;

struct Pixel {
    int x, y;
};
std::vector<Pixel> drawn(const Lot& lot) {
    Random random(lot.seed, "lot");
    std::vector<Pixel> pixels;
    for (int i = 0; i < lot.count; ++i) pixels.push_back({random.index(2 * lot.height), random.index(lot.height)});
    return pixels;
}

// A camera that shows one pixel of the panorama.
Pinhole camera_of(Pixel pixel, int height, Mat3f& world_from_camera) {
    const EquirectSize size{2 * height, height};
    const Vec3f forward = direction_of_pixel(pixel.x, pixel.y, size);
    const Vec3f right = normalize(cross(Vec3f{0, 1, 0}, forward)), down = cross(forward, right);
    world_from_camera = Mat3f::from_columns(right, down, forward);
    const float angle = kPi / static_cast<float>(height),
                across = angle * std::sqrt(std::max(1e-8f, 1 - forward.y * forward.y));
    return {kSide, kSide, kSide / across, kSide / angle, 0.5f * kSide, 0.5f * kSide};
}

// Mean squared error and bias of the pixels of one kind.
struct Group {
    double squares = 0, bias = 0, level = 0;
    int count = 0;
    void add(Vec3f ours, Vec3f wanted, double square) {
        squares += square;
        bias += static_cast<double>(luminance(ours) - luminance(wanted));
        level += static_cast<double>(luminance(wanted));
        ++count;
    }
    Json json(double all) const {
        if (count == 0) return nullptr;
        const double db = psnr_of_mse(squares / count);
        return {{"pixels", count},
                {"psnr_db", db},
                {"share_of_error", squares / all},
                {"bias_percent", 100 * bias / level}};
    }
};

float srgb_byte(float v) { return srgb8_from_linear(Vec3f{v, v, v}).r; }
double squared_error(Vec3f a, Vec3f b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double d = static_cast<double>(srgb_byte(a[k]) - srgb_byte(b[k])) / 255;
        sum += d * d / 3;
    }
    return sum;
}

}  // namespace

Json trace_reference(const TracedRoom& room, const Lot& lot, const std::string& path) {
    const double start = cpu_seconds();
    std::vector<Vec3f> radiances;
    fastscene::Run run;
    const ShotParts parts{.color = true,
                          .range = false,
                          .pixel_samples = std::max(1, lot.samples / kParts),
                          .paths = true,
                          .radiance = true};
    for (const Pixel pixel : drawn(lot)) {
        Mat3f turn;
        const Pinhole camera = camera_of(pixel, lot.height, turn);
        run.seed = mix64(lot.seed) ^ (static_cast<std::uint64_t>(pixel.y) << 32 | static_cast<std::uint64_t>(pixel.x));
        const ImageColor part = room.perspective({turn, {}}, camera, parts, run).color;
        radiances.insert(radiances.end(), part.pixels.begin(), part.pixels.end());
    }
    write_file(path,
               std::string_view(reinterpret_cast<const char*>(radiances.data()), radiances.size() * sizeof(Vec3f)));
    return {{"pixels", lot.count}, {"samples", lot.samples}, {"cpu_s", cpu_seconds() - start}};
}

Json compare_with_reference(const TracedRoom& room, const Shot& picture, const Lot& lot, const std::string& path,
                            bool list_all) {
    const std::string bytes = read_file(path);
    std::vector<Vec3f> radiances(static_cast<std::size_t>(lot.count * kParts));
    if (bytes.size() != radiances.size() * sizeof(Vec3f))
        throw Error("{}: expected {} pixels of a reference, found {} bytes", path, lot.count, bytes.size());
    std::memcpy(radiances.data(), bytes.data(), bytes.size());
    Group all, outside, shell, things;
    std::vector<std::pair<double, Json>> worst;
    std::size_t next = 0;
    for (const Pixel pixel : drawn(lot)) {
        Vec3f wanted{};
        for (int k = 0; k < kParts; ++k) wanted += develop(room.room().look, radiances[next++]) * (1.f / kParts);
        const Vec3f ours = picture.color.at(pixel.x, pixel.y);
        const double square = squared_error(ours, wanted);
        const int object = picture.object.at(pixel.x, pixel.y);
        (object == -2 ? outside : object == -1 ? shell : things).add(ours, wanted, square);
        all.add(ours, wanted, square);
        worst.push_back({square,
                         {{"x", pixel.x},
                          {"y", pixel.y},
                          {"object", object},
                          {"ours", {ours.x, ours.y, ours.z}},
                          {"wanted", {wanted.x, wanted.y, wanted.z}}}});
    }
    std::stable_sort(worst.begin(), worst.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    double top = 0;
    Json list = Json::array();
    for (std::size_t i = 0; i < worst.size(); ++i) {
        const bool is_worst = i < worst.size() / 100;
        if (is_worst) top += worst[i].first;
        if (is_worst || list_all) list.push_back(worst[i].second);
    }
    return {{"all", all.json(all.squares)},
            {"outside", outside.json(all.squares)},
            {"shell", shell.json(all.squares)},
            {"things", things.json(all.squares)},
            {"share_of_worst_percent", top / all.squares},
            {"worst", list}};
}

}  // namespace fastscene::bench
