// Grand piano. It is built with its keyboard at +z, and then turned as it stands on a stage: the open lid to the front,
// the player at the left, the straight side at the wall.
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/scene/box.h"

namespace fastscene::furniture {
namespace {

// A baby grand, metres.
constexpr float kPianoHalfWidth = 0.74f, kPianoLength = 1.7f, kKeyboardFront = kPianoLength / 2;
constexpr float kKeyBedDepth = 0.28f;  // of the key bed before the case
constexpr float kCaseFoot = 0.62f, kCaseTop = 0.98f, kSoundboardTop = 0.9f;
constexpr float kCaseRim = 0.035f;  // thickness of the case
constexpr float kLidAngle_deg = 34;

// The case from above, from the right end of its front around the bent side and the tail to the left end: the straight
// side of the bass strings. `inset` metres inside it.
std::vector<Vec2f> case_outline(float inset) {
    const float z = kKeyboardFront - kKeyBedDepth, tail = -kKeyboardFront + inset, right = kPianoHalfWidth - inset,
                left = -kPianoHalfWidth + inset;
    const std::vector<Vec2f> bent{{right, z},
                                  {right, z - 0.2f},
                                  {0.69f - inset, z - 0.42f},
                                  {0.47f - inset, z - 0.7f},
                                  {0.2f - inset, z - 0.92f},
                                  {0.03f - inset, z - 1.14f},
                                  {-0.12f - inset, tail + 0.13f},
                                  {-0.32f - inset / 2, tail + 0.02f},
                                  {-0.5f, tail},
                                  {-0.68f + inset / 2, tail + 0.03f},
                                  {left, tail + 0.17f}};
    std::vector<Vec2f> out = shapes::curve(bent, 6);
    out.push_back({left, z});
    return out;
}

// The rim, a board bent along the outline; it is open at the front, where the keys are.
Mesh piano_rim() {
    const std::vector<Vec2f> line = case_outline(0);
    const auto last = static_cast<float>(line.size() - 1);
    return shapes::slab(static_cast<int>(line.size()) - 1, 1, kCaseRim, [&](float u, float v) {
        const auto i = static_cast<std::size_t>(std::lround(u * last));
        return Vec3f{line[i].x, kCaseFoot + (kCaseTop - kCaseFoot) * v, line[i].y};
    });
}

void add_keyboard(Kit& k, int body) {
    const int ivory = k.material(plain("ivory keys", {0.75f, 0.73f, 0.66f}, 0.3f)),
              black = k.material(plain("black keys", {0.032f, 0.032f, 0.033f}, 0.3f));
    constexpr int kWhiteKeys = 52;
    constexpr float kPitch = 0.0235f, kMiddle = kKeyboardFront - kKeyBedDepth / 2;
    k.board(body, {0, kCaseFoot, kMiddle}, {2 * kPianoHalfWidth, 0.07f, kKeyBedDepth}, 0.006f);
    for (const float side : {-1.f, 1.f})
        k.board(body, {side * (kPianoHalfWidth - 0.055f), 0.69f, kMiddle}, {0.11f, 0.15f, kKeyBedDepth}, 0.02f);
    // Without bevels: nobody sees them, and 88 boards would have 9,500 triangles.
    const auto key = [&](int material, Vec3f base, Vec3f size) {
        const Vec3f half{size.x / 2, 0, size.z / 2};
        k.add(box_mesh(base - half, base + half + Vec3f{0, size.y, 0}, material, -1), material);
    };
    for (int i = 0; i < kWhiteKeys; ++i) {
        const float x = (static_cast<float>(i) - 0.5f * (kWhiteKeys - 1)) * kPitch;
        key(ivory, {x, 0.7f, kMiddle + 0.05f}, {kPitch - 0.0012f, 0.02f, 0.15f});
        const int note = i % 7;
        if (i + 1 < kWhiteKeys && note != 1 && note != 4)  // the lowest key is an A
            key(black, {x + kPitch / 2, 0.715f, kMiddle + 0.02f}, {0.011f, 0.017f, 0.095f});
    }
    Mesh fall = shapes::box({1.24f, 0.16f, 0.02f}, 0.005f);
    shapes::turn(fall, {1, 0, 0}, -14);
    k.add(std::move(fall), body, {0, 0.79f, kKeyboardFront - kKeyBedDepth + 0.03f});
}

// The iron frame and the strings across it.
void add_strings(Kit& k, int brass) {
    const int frame = k.material(plain("gilded frame", {0.5f, 0.33f, 0.11f}, 0.45f)),
              steel_string = k.material(plain("strings", {0.55f, 0.52f, 0.48f}, 0.3f));
    k.add(shapes::prism(case_outline(0.03f), kSoundboardTop, kSoundboardTop + 0.01f, 0.003f), frame);
    constexpr int kStrings = 26;
    for (int i = 0; i < kStrings; ++i) {
        const float t = static_cast<float>(i) / (kStrings - 1);
        const float x0 = -0.62f + 1.2f * t, from = kKeyboardFront - kKeyBedDepth - 0.2f;
        // Treble strings are short, and all run a little to the left.
        const float long_m = 1.05f - 0.82f * t;
        k.rod(i < kStrings / 3 ? brass : steel_string, {x0, kSoundboardTop + 0.03f, from},
              {x0 - 0.1f * (1 - t), kSoundboardTop + 0.03f, from - long_m}, 0.0016f, -1, 5);
    }
    for (const float x : {-0.35f, 0.02f, 0.36f})
        k.board(frame, {x, kSoundboardTop + 0.01f, kKeyboardFront - kKeyBedDepth - 0.4f}, {0.03f, 0.035f, 0.45f},
                0.008f);
}

void add_legs_and_lyre(Kit& k, int body, int brass) {
    for (const Vec2f at : {Vec2f{-0.6f, kKeyboardFront - 0.2f}, Vec2f{0.6f, kKeyboardFront - 0.2f},
                           Vec2f{-0.46f, -kKeyboardFront + 0.24f}}) {
        const std::vector<Vec2f> leg{
            {0.03f, 0.07f}, {0.034f, 0.12f}, {0.055f, 0.5f}, {0.068f, 0.54f}, {0.068f, kCaseFoot}};
        k.add(shapes::lathe(leg, 20), body, {at.x, 0, at.y});
        k.add(shapes::ball({at.x, 0.035f, at.y}, {0.02f, 0.035f, 0.035f}, 12), brass);
        k.rod(brass, {at.x, 0.05f, at.y}, {at.x, 0.09f, at.y}, 0.03f);
    }
    const float z = kKeyboardFront - 0.42f;
    for (const float x : {-0.07f, 0.07f}) k.rod(body, {x, 0.14f, z}, {x * 1.5f, kCaseFoot, z}, 0.013f);
    k.board(body, {0, 0.08f, z}, {0.3f, 0.07f, 0.12f}, 0.012f);
    for (const float x : {-0.09f, 0.f, 0.09f}) k.board(brass, {x, 0.09f, z + 0.1f}, {0.026f, 0.012f, 0.12f}, 0.005f);
}

void add_open_lid(Kit& k, int body) {
    constexpr float kThick = 0.02f;
    // From the hinges at the straight side.
    Mesh lid = shapes::prism(case_outline(-0.012f), 0, kThick, 0.006f);
    shapes::move(lid, {kPianoHalfWidth, 0, 0});
    shapes::turn(lid, {0, 0, 1}, kLidAngle_deg);
    k.add(std::move(lid), body, {-kPianoHalfWidth, kCaseTop + 0.012f, 0});
    constexpr float kProp = 1.12f;  // where the stick meets the lid, from the hinges
    const float a = kLidAngle_deg * kPi / 180, z = kKeyboardFront - kKeyBedDepth - 0.14f;
    k.rod(body, {kPianoHalfWidth - 0.05f, kCaseTop - 0.01f, z},
          {-kPianoHalfWidth + kProp * std::cos(a), kCaseTop + kProp * std::sin(a), z}, 0.009f);
    // The desk for the music, and music on it.
    Mesh desk = shapes::box({0.74f, 0.24f, 0.012f}, 0.004f), sheet = shapes::box({0.44f, 0.3f, 0.002f}, 0.0005f);
    for (Mesh* m : {&desk, &sheet}) shapes::turn(*m, {1, 0, 0}, -16);
    k.add(std::move(desk), body, {0, kCaseTop + 0.11f, kKeyboardFront - kKeyBedDepth - 0.06f});
    k.add(std::move(sheet), k.material(plain("sheet music", {0.75f, 0.73f, 0.68f}, 0.8f)),
          {0, kCaseTop + 0.14f, kKeyboardFront - kKeyBedDepth - 0.048f});
}

void add_piano_bench(Kit& k, int body) {
    constexpr float kWide = 0.74f, kDeep = 0.34f, kSeat = 0.42f, kLeg = 0.05f;
    const float z = kKeyboardFront + 0.04f + kDeep / 2;
    k.board(body, {0, kSeat - 0.08f, z}, {kWide, 0.08f, kDeep}, 0.008f);
    k.soft(k.material(plain("bench leather", {0.02f, 0.02f, 0.02f}, 0.4f)), {0, kSeat, z}, {kWide, 0.07f, kDeep},
           {.round_m = 0.025f, .puff_m = 0.015f, .wrinkle_m = 0.001f});
    for (const float x : {-1.f, 1.f})
        for (const float side : {-1.f, 1.f})
            k.board(body, {x * (kWide - kLeg) / 2, 0, z + side * (kDeep - kLeg) / 2}, {kLeg, kSeat - 0.08f, kLeg},
                    0.006f);
}

}  // namespace

void build_grand_piano(Kit& k) {
    const int body = k.main(plain("piano lacquer", {0.018f, 0.018f, 0.019f}, 0.08f)),
              brass = k.material(*material_named("brass"));
    k.add(piano_rim(), body);
    k.add(shapes::prism(case_outline(0.01f), kCaseFoot, kSoundboardTop, 0.004f), body);
    k.board(body, {0, kCaseFoot, kKeyboardFront - kKeyBedDepth - 0.01f},
            {2 * kPianoHalfWidth - 0.02f, kCaseTop - kCaseFoot, 0.03f}, 0.006f);
    add_keyboard(k, body);
    add_strings(k, brass);
    add_legs_and_lyre(k, body, brass);
    add_open_lid(k, body);
    add_piano_bench(k, body);
    for (Mesh& mesh : k.piece.meshes) shapes::turn(mesh, {0, 1, 0}, -90);
    k.piece.clearance_front_m = 0.5f;
    k.piece.clearance_side_m = 0.4f;  // the player
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
