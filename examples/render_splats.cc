// Pictures of a scene of splats: a still and one all around.     render_splats SCENE STILL.png SPHERE.png [YAW_DEG]
#include <fastscene/splat.h>

#include <iostream>

using namespace fastscene;

int main(int argc, char** argv) try {
    if (argc < 4) throw UsageError("usage: render_splats SCENE STILL.png SPHERE.png [YAW_DEG]");
    const float yaw_deg = argc > 4 ? std::stof(argv[4]) : 0.f;
    const Splats splats = load_splats(argv[1]).splats;

    // Where the camera stands: at the origin, turned right by the yaw. y points down, so a positive angle about it
    // turns to the right.
    const Rigid world_from_camera{rotation_about(Vec3f{0, 1, 0}, yaw_deg * kPi / 180), {}};
    const Pinhole camera = Pinhole::with_fov(640, 480, 75);  // pixels, pixels, horizontal degrees

    const Still still = still_of(splats, camera, world_from_camera);
    save_png(argv[2], still.color);
    std::cout << "in the middle: " << still.distance.at(320, 240) << " m\n";  // along the optical axis

    const Still sphere = sphere_of(splats, 512, world_from_camera);  // equirectangular, 512 x 256
    save_png(argv[3], sphere.color);
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
