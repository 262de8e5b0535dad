#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/film/encode.h"
#include "fastscene/film/plan.h"
#include "fastscene/film/route.h"
#include "fastscene/film/stereo.h"
#include "fastscene/film/subjects.h"

namespace fastscene {
namespace {

std::vector<Vec2f> box(float x0, float y0, float x1, float y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// A room of 6 x 5 m with a table in the middle, and a narrow arm behind a corner.
WalkableArea furnished_floor() {
    WalkableArea area{
        {box(-3, -2.5f, 3, 2.5f), box(-0.8f, -0.6f, 0.8f, 0.6f), box(-3, 1.2f, 1.5f, 1.6f)}, -0.3f, 0.3f, 1.6f};
    // The first panorama stands beside the table.
    for (auto& ring : area.rings_m)
        for (Vec2f& p : ring) p = p + Vec2f{1.4f, 0};
    return area;
}

std::vector<FilmSubject> things() {
    return {{"table", {1.4f, 0.9f, 0}, 0.9f, {}, false},
            {"shelf", {4.3f, 0.6f, 1}, 0.8f, {-1, 0, 0}, false},
            {"sofa", {-1.4f, 1, -1}, 1.1f, {1, 0, 0}, false},
            {"door", {1.4f, 0.6f, -2.6f}, 1, {}, true}};
}

// The laws of every planned path, frame by frame.
void expect_lawful(const CameraPath& path, const WalkableArea& area) {
    const FilmPace pace;
    const float dt = 1 / path.fps;
    Vec3f last_step{};
    float last_turn = 0;
    for (int i = 0; i < path.frames(); ++i) {
        const CameraKey here = path.at(path.time_of(i)), next = path.at(path.time_of(i + 1));
        ASSERT_TRUE(contains(area, here.position_m)) << "frame " << i;
        EXPECT_GT(clearance(area, {here.position_m.x, here.position_m.z}), 0.02f) << "frame " << i;
        EXPECT_EQ(here.roll_deg, 0);
        const Vec3f step = next.position_m - here.position_m;
        const float turn = next.yaw_deg - here.yaw_deg;
        EXPECT_LT(length(step), pace.metres_per_s * dt * 1.02f) << "frame " << i;
        EXPECT_LT(std::fabs(turn), pace.degrees_per_s * dt * 1.02f) << "frame " << i;
        EXPECT_LT(std::fabs(next.pitch_deg - here.pitch_deg), pace.tilt_degrees_per_s * dt * 1.02f) << "frame " << i;
        // No jerk: speed changes by at most the full speed in about the time that easing takes.
        if (i > 0) {
            EXPECT_LT(length(step - last_step), 1.6f * dt * dt) << "frame " << i;
            EXPECT_LT(std::fabs(turn - last_turn), 75 * dt * dt) << "frame " << i;
        }
        last_step = step, last_turn = turn;
    }
    const CameraKey first = path.at(path.time_of(0)), second = path.at(path.time_of(1));
    EXPECT_LT(length(second.position_m - first.position_m), 0.002f) << "starts from rest";
}

TEST(Film, EveryPathObeysItsLaws) {
    const WalkableArea area = furnished_floor();
    for (const std::string_view kind : kPathKinds) {
        SCOPED_TRACE(kind);
        FilmWish wish;
        wish.kind = kind;
        const CameraPath path = plan_film(area, things(), wish);
        EXPECT_GT(path.keys.back().time_s, 5);
        expect_lawful(path, area);
    }
}

// Behind the table the floor rises in three steps of 0.18 m.
TEST(Film, OnStepsTheEyeRisesEvenly) {
    WalkableArea area = furnished_floor();
    area.low_y = -0.3f, area.high_y = 1.f;
    area.levels = {{{box(-1.6f, -2.5f, 4.4f, -1)}, 1.6f},
                   {{box(-1.6f, -1, 4.4f, -0.5f)}, 1.42f},
                   {{box(-1.6f, -0.5f, 4.4f, 0)}, 1.24f},
                   {{box(-1.6f, 0, 4.4f, 2.5f)}, 1.06f}};
    for (const std::string_view kind : kPathKinds) {
        SCOPED_TRACE(std::string(kind));
        FilmWish wish;
        wish.kind = kind;
        const CameraPath path = plan_film(area, things(), wish, {});
        float lowest = 9, highest = -9;
        for (int i = 0; i < path.frames(); ++i) {
            const Vec3f here = path.at(path.time_of(i)).position_m, next = path.at(path.time_of(i + 1)).position_m;
            ASSERT_TRUE(contains(area, here)) << "frame " << i;
            EXPECT_LT(std::fabs(next.y - here.y), 0.45f / path.fps) << "frame " << i;
            lowest = std::min(lowest, here.y), highest = std::max(highest, here.y);
        }
        EXPECT_GT(highest - lowest, 0.15f);
    }
}

TEST(Film, PathsExistWithoutSubjectsAndOnASmallFloor) {
    WalkableArea small{{box(-0.3f, -0.2f, 0.3f, 0.2f)}, -0.1f, 0.1f, 1.6f};
    for (const WalkableArea& area : {furnished_floor(), small})
        for (const std::string_view kind : kPathKinds) {
            SCOPED_TRACE(kind);
            FilmWish wish;
            wish.kind = kind;
            expect_lawful(plan_film(area, {}, wish), area);
        }
}

TEST(Film, ATourEndsAtTheMainSubjectAndAnOrbitLooksAtOneAlways) {
    const auto off = [](const CameraKey& key, Vec3f target) {
        const Vec3f way = normalize(target - key.position_m),
                    look = world_from_camera(key) * Vec3f{0, 0, 1} - key.position_m;
        return std::fabs(std::remainder(std::atan2(way.x, way.z) - std::atan2(look.x, look.z), 2 * kPi)) * 180 / kPi;
    };
    const CameraPath tour = plan_film(furnished_floor(), things(), {});
    EXPECT_LT(off(tour.keys.back(), things()[0].center_m), 1);
    FilmWish wish;
    wish.kind = "orbit";
    const CameraPath orbit = plan_film(furnished_floor(), things(), wish);
    for (const CameraKey& key : orbit.keys) EXPECT_LT(off(key, things()[0].center_m), 4) << key.time_s;
}

TEST(Film, AWalkthroughComesInByTheDoor) {
    FilmWish wish;
    wish.kind = "walkthrough";
    const CameraPath path = plan_film(furnished_floor(), things(), wish);
    EXPECT_LT(length(path.keys.front().position_m - Vec3f{1.4f, 0, -2.5f}), 0.3f);
}

TEST(Film, WhatIsHiddenIsNotLookedAtFromThere) {
    // A wall from x = 2.6 on hides the shelf from the left.
    const FilmSight wall = [](Vec3f from, Vec3f direction) {
        const float t = (2.6f - from.x) / direction.x;
        return t > 0 ? t : 1e9f;
    };
    WalkableArea area = furnished_floor();
    const std::vector<FilmSubject> shelf{things()[1]};
    const CameraPath path = plan_film(area, shelf, {}, wall);
    EXPECT_GT(path.keys.back().position_m.x, 2.6f);
}

TEST(Film, SecondsAreKeptOrRefused) {
    FilmWish wish;
    wish.seconds = 60;
    EXPECT_NEAR(plan_film(furnished_floor(), things(), wish).keys.back().time_s, 60, 1e-3);
    const float natural = plan_film(furnished_floor(), things(), {}).keys.back().time_s;
    wish.seconds = natural - 1;  // a stop fewer
    EXPECT_NEAR(plan_film(furnished_floor(), things(), wish).keys.back().time_s, natural - 1, 1e-3);
    wish.seconds = 0.5f;
    EXPECT_THROW(plan_film(furnished_floor(), things(), wish), UsageError);
    wish.kind = "dance";
    EXPECT_THROW(plan_film(furnished_floor(), things(), wish), UsageError);
}

TEST(Film, SubjectsAreWhatTheSentenceNamed) {
    const Json pose = {{1, 0, 0, 0}, {0, -1, 0, 1.6}, {0, 0, -1, 2}, {0, 0, 0, 1}};
    const auto object = [&](const char* name, std::vector<double> size, bool requested, int pixels) {
        return Json{{"class", name},  {"name", name},          {"visible_pixels", pixels}, {"world_from_object", pose},
                    {"size_m", size}, {"requested", requested}};
    };
    const Json room{{"objects",
                     {object("bed", {2, 0.6, 1.6}, false, 9000), object("window", {2, 2, 0.2}, true, 8000),
                      object("armchair", {0.8, 0.9, 0.8}, true, 900), object("door", {0.9, 2, 0.05}, false, 500),
                      object("book", {0.1, 0.02, 0.2}, false, 40), object("lamp", {0.3, 1, 0.3}, true, 0)}}};
    const std::vector<FilmSubject> found = film_subjects(room, 5, "room.json");
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[0].name, "armchair");
    EXPECT_EQ(found[1].name, "window");
    EXPECT_EQ(found[2].name, "bed");
    EXPECT_TRUE(found[3].door);
    EXPECT_NEAR(found[0].center_m.y, 1.6 - 0.45, 1e-5);
    EXPECT_NEAR(found[0].front.z, -1, 1e-5);
    EXPECT_THROW(film_subjects({{"objects", {{{"name", "bed"}}}}}, 5, "room.json"), Error);
}

TEST(Film, RatesAreFractions) {
    EXPECT_EQ(rate_text(30), "30");
    EXPECT_EQ(rate_text(29.97f), "30000/1001");
    EXPECT_EQ(rate_text(23.976f), "24000/1001");
    EXPECT_EQ(rate_text(12.5f), "25/2");
}

TEST(Film, EyesAreOffsetAcrossTheirLookAndNotAtThePoles) {
    EXPECT_NEAR(length(eye_offset({512, 256}, {1024, 512}, 0.03f) - Vec3f{0.03f, 0, 0}), 0, 1e-6);
    EXPECT_NEAR(length(eye_offset({768, 256}, {1024, 512}, 0.03f) - Vec3f{0, 0, -0.03f}), 0, 1e-6);
    EXPECT_EQ(length(eye_offset({100, 10}, {1024, 512}, 0.03f)), 0);
}

// A small white dot at an azimuth, on black.
Splats dot_at(float azimuth, float distance_m) {
    Splats splats;
    splats.resize(1);
    splats.mean_m[0] = Vec3f{std::sin(azimuth), 0, std::cos(azimuth)} * distance_m;
    splats.log_scale[0] = Vec3f{1, 1, 1} * std::log(0.02f);
    splats.opacity_logit[0] = 6;
    splats.sh0[0] = Vec3f{1, 1, 1} * (0.5f / kSh0);
    return splats;
}

// Its column: the mean of the brightness, counted from the column where it should be.
double column_of(const ImageRgb8& picture, double expected) {
    double sum = 0, moment = 0;
    for (int x = 0; x < picture.width; ++x)
        for (int y = 0; y < picture.height; ++y) {
            const double off = std::remainder(x + 0.5 - expected, picture.width);
            sum += picture.at(x, y).g, moment += off * picture.at(x, y).g;
        }
    return moment / sum;
}

// The geometry of omnidirectional stereo: the eye that looks at a point at distance d sees it asin(e / d) aside, in
// every direction alike, also between two slices.
TEST(Film, SplatsOfBothEyesAreApartByTheSameAngleAllAround) {
    constexpr int kWidth = 512;
    constexpr float kEye_m = kPupils_m / 2;
    for (const float degrees : {3.f, 91.5f, 179.f}) {
        const Splats splats = dot_at(degrees * kPi / 180, 1.2f);
        const double plain = (static_cast<double>(degrees) / 360 + 0.5) * kWidth,
                     aside = std::asin(static_cast<double>(kEye_m) / 1.2) / (2 * std::numbers::pi) * kWidth;
        EXPECT_NEAR(column_of(eye_sphere_of(splats, kWidth, {}, kEye_m), plain - aside), 0, 0.2) << degrees;
        EXPECT_NEAR(column_of(eye_sphere_of(splats, kWidth, {}, -kEye_m), plain + aside), 0, 0.2) << degrees;
    }
}

TEST(Film, PicturesAreJoined) {
    ImageRgb8 a(4, 2), b(4, 2);
    a.at(0, 0) = {1, 2, 3}, b.at(3, 1) = {4, 5, 6};
    EXPECT_EQ(stacked(a, b).height, 4);
    EXPECT_EQ(stacked(a, b).at(3, 3), b.at(3, 1));
    EXPECT_EQ(beside(a, b).at(7, 1), b.at(3, 1));
    EXPECT_EQ(beside(a, b).at(0, 0), a.at(0, 0));
    ImageRgb8 sphere(8, 4);
    sphere.at(2, 0) = {9, 9, 9};
    EXPECT_EQ(front_half(sphere).width, 4);
    EXPECT_EQ(front_half(sphere).at(0, 0), sphere.at(2, 0));
}

}  // namespace
}  // namespace fastscene
