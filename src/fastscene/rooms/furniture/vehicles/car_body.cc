// A car: a smooth body from its lines as seen from the side and from above, on wheels with rims.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// Metres; z runs to the front.
constexpr float kCarEnd_m = 2.1f, kAxle_m = 1.29f, kHub_m = 0.31f, kTyre_m = 0.31f, kArch_m = 0.365f,
                kCarHalf_m = 0.86f,
                kNose_m = 0.06f;  // how far nose and tail stand out in the middle
constexpr float kCowl_m = 0.88f, kScreenTop_m = 0.1f, kRoofEnd_m = -1.3f, kHatch_m = -1.9f;

// A line of the car: y by z.
class CarLine {
  public:
    explicit CarLine(std::span<const Vec2f> through) : points_(shapes::curve(through, 8)) {}
    float operator()(float z) const {
        const auto after = std::find_if(points_.begin() + 1, points_.end() - 1, [&](Vec2f p) { return p.x >= z; });
        const Vec2f a = *(after - 1), b = *after;
        return std::lerp(a.y, b.y, std::clamp((z - a.x) / std::max(1e-5f, b.x - a.x), 0.f, 1.f));
    }

  private:
    std::vector<Vec2f> points_;
};

struct CarBody {
    CarLine crown{std::array<Vec2f, 12>{Vec2f{-2.1f, 0.84f},
                                        {-2.03f, 0.93f},
                                        {-1.88f, 1.03f},
                                        {-1.6f, 1.22f},
                                        {-1.3f, 1.385f},
                                        {-0.7f, 1.455f},
                                        {-0.2f, 1.44f},
                                        {0.12f, 1.37f},
                                        {0.88f, 0.985f},
                                        {1.4f, 0.9f},
                                        {1.95f, 0.76f},
                                        {2.1f, 0.62f}}};  // along the middle
    CarLine belt{std::array<Vec2f, 8>{Vec2f{-2.1f, 0.84f},
                                      {-1.95f, 0.95f},
                                      {-1.5f, 0.985f},
                                      {-0.6f, 0.955f},
                                      {0.4f, 0.93f},
                                      {1.0f, 0.9f},
                                      {1.9f, 0.73f},
                                      {2.1f, 0.62f}}};  // the lower edge of the windows

    static float half(float z) {
        const float in = std::max(0.f, (std::fabs(z) - 1.25f) / (kCarEnd_m - 1.25f));
        return kCarHalf_m - 0.2f * std::pow(in, 2.3f);
    }
    // The body's lower edge, over the wheels too.
    static float hem(float z) {
        float y = 0.2f + 0.09f * std::pow(std::fabs(z) / kCarEnd_m, 3.f);
        for (const float axle : {-kAxle_m, kAxle_m})
            if (const float off = std::fabs(z - axle); off < kArch_m)
                y = std::max(y, kHub_m + std::sqrt(kArch_m * kArch_m - off * off));
        return y;
    }
    // From the hem (t = 0) to the belt (1); sx: its side.
    Vec3f side(float sx, float z, float t, float out = 0) const {
        const float y = std::lerp(hem(z), belt(z), t), low = 0.2f, up = (y - low) / std::max(0.1f, belt(z) - low);
        // It swells to a shoulder, with a light fold above the wheels.
        const float swell = 1.f - 0.075f * std::pow(std::fabs(up - 0.62f) / 0.62f, 2.f) -
                            0.012f * std::exp(-80.f * (up - 0.74f) * (up - 0.74f));
        return {sx * (half(z) * swell + out), y, z};
    }
    float edge_y(float z) const { return std::max(belt(z), crown(z) - 0.045f); }
    float edge_x(float z) const {
        const float high = edge_y(z) - belt(z);
        return side(1, z, 1).x * (1.f - 0.29f * high / 0.45f);
    }
    // The side windows, from the belt to the roof's edge.
    Vec3f window(float sx, float z, float t, float out = 0) const {
        const Vec3f foot = side(1, z, 1);
        return {sx * (std::lerp(foot.x, edge_x(z), t) + 0.014f * std::sin(kPi * t) + out),
                std::lerp(foot.y, edge_y(z), t), z};
    }
    // Hood, panes and roof; s from -1 to 1 across.
    Vec3f top(float z, float s, float out = 0) const {
        const float y = edge_y(z),
                    nose = kNose_m * (1 - s * s) * std::copysign(std::pow(std::fabs(z) / kCarEnd_m, 10.f), z);
        return {s * edge_x(z), y + (crown(z) - y) * (1 - s * s * std::fabs(s)) + out, z + nose};
    }
    // Nose (end = 1) and tail (-1).
    Vec3f cap(float end, float s, float t, float out = 0) const {
        const Vec3f at = side(1, end * kCarEnd_m, t);
        const float bulge = (1 - s * s) * (kNose_m + 0.05f * std::sin(kPi * t));
        return {s * at.x, at.y, end * (kCarEnd_m + bulge + out)};
    }
};

// Where the body is cut across: every few centimetres, and closer where a wheel arch rises.
std::vector<float> car_stations() {
    std::vector<float> at;
    constexpr int kEven = 56, kOfArch = 22;
    for (int i = 0; i <= kEven; ++i) at.push_back(kCarEnd_m * (2.f * static_cast<float>(i) / kEven - 1.f));
    for (const float axle : {-kAxle_m, kAxle_m})
        for (int i = 0; i <= kOfArch; ++i) {
            const float c = std::cos(kPi * static_cast<float>(i) / kOfArch);
            at.push_back(axle + kArch_m * c);
        }
    for (const float axle : {-kAxle_m, kAxle_m})
        for (const float side : {-1.f, 1.f}) at.push_back(axle + side * (kArch_m + 0.002f));
    std::sort(at.begin(), at.end());
    return at;
}

// A patch of the body: point(z, t) over these stations or from z0 to z1.
template <class Point>
void car_skin(Kit& k, int material, float sx, std::span<const float> stations, int rows, float t0, float t1,
              const Point& point) {
    const int last = static_cast<int>(stations.size()) - 1;
    k.add(shapes::sheet(rows, last,
                        [&](float u, float v) {
                            const auto i = static_cast<std::size_t>(
                                std::lround((sx > 0 ? v : 1 - v) * static_cast<float>(last)));
                            return point(stations[i], std::lerp(t0, t1, u));
                        }),
          material);
}
std::vector<float> car_steps(float z0, float z1, int steps) {
    std::vector<float> at;
    for (int i = 0; i <= steps; ++i) at.push_back(std::lerp(z0, z1, static_cast<float>(i) / static_cast<float>(steps)));
    return at;
}

void car_wheel(Kit& k, int tire, int metal, float sx, Vec3f at) {
    constexpr float r = kTyre_m, w = 0.2f, rim = 0.7f * r;
    // The tire, and the dark inside of the wheel that its spokes stand before.
    const std::array<Vec2f, 9> rubber{Vec2f{rim, -0.44f * w}, {0.8f * r, -0.5f * w}, {0.95f * r, -0.47f * w},
                                      {r, -0.33f * w},        {r, 0.33f * w},        {0.95f * r, 0.47f * w},
                                      {0.8f * r, 0.5f * w},   {rim, 0.44f * w},      {0.98f * rim, 0.05f * w}};
    const std::array<Vec2f, 4> ring{
        Vec2f{0.9f * rim, 0.1f * w}, {0.93f * rim, 0.4f * w}, {1.02f * rim, 0.46f * w}, {1.03f * rim, 0.3f * w}};
    const std::array<Vec2f, 3> cap{Vec2f{0.2f * rim, 0.1f * w}, {0.2f * rim, 0.4f * w}, {0.12f * rim, 0.45f * w}};
    const auto put = [&](std::span<const Vec2f> profile, int sides, int material) {
        Mesh m = shapes::lathe(profile, sides);
        k.add(std::move(shapes::turn(m, {0, 0, 1}, sx > 0 ? -90.f : 90.f)), material, at);
    };
    put(rubber, 36, tire), put(ring, 32, metal), put(cap, 16, metal);
    const float x = at.x + sx * 0.3f * w;
    for (int i = 0; i < 5; ++i)
        for (const float split : {-0.11f, 0.11f}) {  // double spokes
            const float a = kTau * static_cast<float>(i) / 5 + 0.3f, b = a + 1.6f * split;
            const Vec3f from{x, at.y + 0.16f * rim * std::cos(a), at.z + 0.16f * rim * std::sin(a)},
                to{x + sx * 0.012f, at.y + 0.95f * rim * std::cos(b), at.z + 0.95f * rim * std::sin(b)};
            k.rod(metal, from, to, 0.017f, 0.013f, 6);
        }
}

}  // namespace

// A compact car with a hatch; its front looks along +z.
void build_car(Kit& k) {
    const int paint = k.main(plain("car paint", k.accent(), 0.12f)),
              pane = color(k, "car window", {0.012f, 0.015f, 0.018f}, 0.04f),
              tire = color(k, "tire", {0.02f, 0.02f, 0.02f}, 0.8f), metal = k.material(steel()),
              dark = color(k, "trim", {0.016f, 0.016f, 0.017f}, 0.5f),
              lamp = color(k, "headlight", {0.75f, 0.76f, 0.78f}, 0.06f),
              red = color(k, "tail light", {0.42f, 0.012f, 0.012f}, 0.1f),
              amber = color(k, "indicator", {0.6f, 0.22f, 0.02f}, 0.12f),
              plate = color(k, "number plate", {0.72f, 0.72f, 0.7f}, 0.4f);
    const CarBody body;
    const std::vector<float> whole = car_stations();
    constexpr float kPillar_m = 0.055f, kDoor_m = -0.2f, kRear_m = -1.12f, kSeam_m = 0.004f;
    for (const float sx : {-1.f, 1.f}) {
        const auto side = [&](float z, float t) { return body.side(sx, z, t); };
        const auto over_side = [&](float z, float t) { return body.side(sx, z, t, kSeam_m); };
        const auto window = [&](float z, float t) { return body.window(sx, z, t); };
        const auto over_window = [&](float z, float t) { return body.window(sx, z, t, kSeam_m); };
        car_skin(k, paint, sx, whole, 14, 0, 1, side);
        car_skin(k, pane, sx, car_steps(kHatch_m, kCowl_m, 44), 6, 0, 1, window);
        // The edges of hood and tail.
        car_skin(k, paint, sx, car_steps(kCowl_m, kCarEnd_m, 24), 2, 0, 1, window);
        car_skin(k, paint, sx, car_steps(-kCarEnd_m, kHatch_m, 8), 2, 0, 1, window);
        // Pillars, the frame along the roof and the belt; seams of the doors.
        car_skin(k, paint, sx, car_steps(kHatch_m, kRear_m - 0.22f, 10), 6, 0, 1, over_window);
        for (const float z : {kDoor_m, kRear_m + 0.02f})
            car_skin(k, dark, sx, car_steps(z - kPillar_m, z + kPillar_m, 2), 6, 0, 1, over_window);
        car_skin(k, paint, sx, car_steps(kRoofEnd_m, kCowl_m - 0.03f, 30), 2, 0.87f, 1, over_window);
        car_skin(k, dark, sx, car_steps(kRear_m - 0.22f, kCowl_m - 0.05f, 30), 1, -0.012f, 0.012f, over_window);
        for (const float z : {kCowl_m - 0.06f, kDoor_m, kRear_m + 0.2f})
            car_skin(k, dark, sx, car_steps(z - 0.004f, z + 0.004f, 1), 10, z < -1.f ? 0.55f : 0.06f, 0.995f,
                     over_side);
        for (const float z : {-0.06f, -0.77f}) {
            const Vec3f at = body.side(sx, z, 0.8f);
            k.board(dark, at + Vec3f{0, -0.02f, 0}, {0.022f, 0.045f, 0.15f}, 0.006f);
            k.board(paint, at + Vec3f{sx * 0.016f, 0.002f, 0}, {0.018f, 0.022f, 0.17f}, 0.006f);
        }
        car_skin(k, dark, sx, car_steps(-kAxle_m + kArch_m + 0.03f, kAxle_m - kArch_m - 0.03f, 8), 2, -0.02f, 0.12f,
                 over_side);
        // Lamps wrap about the corners.
        car_skin(k, lamp, sx, car_steps(1.74f, kCarEnd_m, 8), 4, 0.62f, 0.92f, over_side);
        car_skin(k, amber, sx, car_steps(1.66f, 1.73f, 2), 3, 0.66f, 0.86f, over_side);
        car_skin(k, red, sx, car_steps(-kCarEnd_m, -1.84f, 8), 4, 0.6f, 0.95f, over_side);
        for (const float axle : {-kAxle_m, kAxle_m}) {
            // The well behind the wheel, and the lip about its arch.
            k.add(shapes::sheet(16, 2,
                                [&](float u, float v) {
                                    const float a = kPi * (sx > 0 ? u : 1 - u);
                                    return Vec3f{sx * (kCarHalf_m - 0.02f - 0.36f * v), kHub_m + kArch_m * std::sin(a),
                                                 axle + kArch_m * std::cos(a)};
                                }),
                  dark);
            std::vector<Vec3f> lip;
            for (int i = 0; i <= 24; ++i) {
                const float a = kPi * (0.02f + 0.96f * static_cast<float>(i) / 24), z = axle + kArch_m * std::cos(a);
                lip.push_back(body.side(sx, z, 0, 0.003f));
            }
            k.add(shapes::tube(lip, 0.012f, 6), paint);
            k.board(dark, {sx * 0.42f, 0.2f, axle}, {0.12f, 0.4f, 0.62f}, 0.01f);
            car_wheel(k, tire, metal, sx, {sx * (kCarHalf_m - 0.12f), kHub_m, axle});
        }
        // Mirrors.
        k.rod(dark, {sx * 0.76f, 0.95f, 0.66f}, {sx * 0.9f, 0.99f, 0.64f}, 0.018f, -1, 8);
        Mesh shell = shapes::soft_box({0.2f, 0.13f, 0.1f}, {0.045f, 0.01f, 0, 8}),
             glass_face = shapes::box({0.16f, 0.1f, 0.004f}, 0.001f);
        k.add(std::move(shell), paint, {sx * 0.95f, 1.02f, 0.64f}),
            k.add(std::move(glass_face), metal, {sx * 0.95f, 1.02f, 0.588f});
    }
    // From the hood over the roof to the hatch.
    const auto top = [&](float z0, float z1, int steps, float s0, float s1, int across, float out, int material) {
        k.add(
            shapes::sheet(steps, across,
                          [&](float u, float v) { return body.top(std::lerp(z0, z1, u), std::lerp(s0, s1, v), out); }),
            material);
    };
    top(kCowl_m, kCarEnd_m, 26, -1, 1, 16, 0, paint), top(kScreenTop_m, kCowl_m, 14, -1, 1, 14, 0, pane);
    top(kRoofEnd_m, kScreenTop_m, 22, -1, 1, 14, 0, paint), top(kHatch_m, kRoofEnd_m, 12, -1, 1, 14, 0, pane);
    top(-kCarEnd_m, kHatch_m, 8, -1, 1, 14, 0, paint);
    for (const float s : {-1.f, 1.f}) {
        top(kScreenTop_m, kCowl_m, 12, s > 0 ? 0.92f : -1.f, s > 0 ? 1.f : -0.92f, 2, kSeam_m, paint);
        top(kHatch_m, kRoofEnd_m, 10, s > 0 ? 0.86f : -1.f, s > 0 ? 1.f : -0.86f, 2, kSeam_m, paint);
        top(kCowl_m, 1.98f, 22, s * 0.8f - 0.006f, s * 0.8f + 0.006f, 1, 0.5f * kSeam_m, dark);
        k.rod(dark, {s * 0.32f, 1.0f, kCowl_m - 0.02f}, {s * 0.32f - 0.42f, 1.07f, kCowl_m - 0.2f}, 0.009f, 0.006f,
              6);  // a wiper
    }
    top(kCowl_m - 0.05f, kCowl_m + 0.02f, 2, -0.97f, 0.97f, 14, kSeam_m, dark);
    // Nose and tail.
    const auto cap = [&](float end, float s0, float s1, float t0, float t1, int across, float out, int material) {
        k.add(shapes::sheet(across, 8,
                            [&](float u, float v) {
                                return body.cap(end, end * std::lerp(s0, s1, u), std::lerp(t0, t1, v), out);
                            }),
              material);
    };
    for (const float end : {-1.f, 1.f}) cap(end, -1, 1, 0, 1, 18, 0, paint);
    cap(1, -0.62f, 0.62f, 0.56f, 0.8f, 14, kSeam_m, dark), cap(1, -0.7f, 0.7f, 0.06f, 0.34f, 14, kSeam_m, dark);
    for (const float t : {0.62f, 0.72f}) cap(1, -0.6f, 0.6f, t, t + 0.025f, 14, 2 * kSeam_m, metal);
    cap(-1, -0.8f, 0.8f, 0.04f, 0.26f, 14, kSeam_m, dark);
    for (const float s : {-1.f, 1.f}) {
        const auto corner = [&](float in) { return std::pair{s > 0 ? in : -0.995f, s > 0 ? 0.995f : -in}; };
        const auto [a, b] = corner(0.68f);
        cap(1, a, b, 0.62f, 0.92f, 6, kSeam_m, lamp), cap(-1, a, b, 0.6f, 0.95f, 6, kSeam_m, red);
    }
    const Vec3f front = body.cap(1, 0, 0.42f, 0.01f), rear = body.cap(-1, 0, 0.56f, -0.01f);
    k.board(plate, front, {0.5f, 0.11f, 0.016f}, 0.003f),
        k.board(plate, rear + Vec3f{0, 0, -0.02f}, {0.5f, 0.11f, 0.016f}, 0.003f);
    for (int i = 0; i < 7; ++i) {  // its figures
        const float x = -0.18f + 0.06f * static_cast<float>(i);
        block(k, dark, {x, front.y + 0.03f, front.z + 0.0085f}, {0.032f, 0.055f, 0.002f});
        block(k, dark, {x, rear.y + 0.03f, rear.z - 0.0285f}, {0.032f, 0.055f, 0.002f});
    }
    k.board(dark, {0, 0.19f, 0}, {1.5f, 0.08f, 3.9f}, 0.01f);
    k.piece.clearance_front_m = 0.6f, k.piece.clearance_side_m = 0.5f;
}

}  // namespace fastscene::furniture
