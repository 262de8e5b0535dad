// Trains 3D Gaussians on pictures that are arrays in memory.     train_splats OUT.ply
//
// The trainer wants pictures, where each was taken from, and some points on the surfaces to start from. Here all three
// are computed: a painted box, 4 m wide, seen from twelve cameras in its middle.
#include <fastscene/splat.h>

#include <cmath>
#include <iostream>

using namespace fastscene;

// What the ray from `origin` along `direction` hits on the inside of the box: |x|, |y|, |z| <= 2 m.
struct Hit {
    Vec3f point, normal;
    Rgb8 color;
};
Hit hit_box(Vec3f origin, Vec3f direction) {
    float nearest = 1e9f;
    Vec3f normal;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float wall = direction[axis] > 0 ? 2.f : -2.f, distance = (wall - origin[axis]) / direction[axis];
        if (!(distance < nearest)) continue;
        nearest = distance;
        normal = {};
        normal[axis] = direction[axis] > 0 ? -1.f : 1.f;  // inward
    }
    const Vec3f p = origin + direction * nearest;
    const auto wave = [](float v) { return static_cast<std::uint8_t>(128.f + 100.f * std::sin(3.f * v)); };
    return {p, normal, {wave(p.x + p.y), wave(p.y - p.z), wave(p.z + p.x)}};
}

int main(int argc, char** argv) try {
    if (argc != 2) throw UsageError("usage: train_splats OUT.ply");
    ViewSet set;
    for (int i = 0; i < 12; ++i) {
        View view;
        view.camera = Pinhole::with_fov(128, 128, 90);  // pixels, pixels, degrees
        // Camera and world: x right, y down, z forward, metres. The camera turns right in steps of 30 degrees.
        view.world_from_camera = {rotation_about(Vec3f{0, 1, 0}, static_cast<float>(i) * kPi / 6), {0.1f, 0, 0}};
        view.color = ImageRgb8(128, 128);
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                const Vec3f d = view.camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
                const Hit hit = hit_box(view.world_from_camera.translation, view.world_from_camera.rotation * d);
                view.color.at(x, y) = hit.color;
                if (x % 4 == 0 && y % 4 == 0) set.points.push_back({hit.point, hit.normal, hit.color, 0.1f});
            }
        set.views.push_back(view);
    }

    SplatParams params;  // each knob is told in fastscene/splat/splat.h
    params.count = 5000;
    params.steps = 200;
    Run run;
    run.seed = 7;  // the same seed gives the same splats, for any number of threads
    const FittedSplats fitted = fit_splats(set, params, run);
    save_splats(argv[1], fitted.splats);
    std::cout << fitted.splats.size() << " splats, PSNR " << fitted.curve.back().psnr << " dB\n";
} catch (const std::exception& e) {  // fastscene throws; it never prints and never exits
    std::cerr << e.what() << '\n';
    return 1;
}
