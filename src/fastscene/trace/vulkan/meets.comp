// Whether further rays of a pixel meet another surface than its first ones did (picture.cc's meets_another).
#version 460
#include "tables.glsl"
#include "traverse.glsl"
#include "surface.glsl"
#include "camera.glsl"
#include "pixels.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push {
    World w;
    Camera camera;
    Words pixels;    // x | y << 16
    Vec4s surfaces;  // two a pixel: position and normal of what its first rays met
    InOutWords found;
    uint count, first, end;
};

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    const uint place = pixels.at[i];
    const uvec2 pixel = uvec2(place & 0xffff, place >> 16);
    const vec3 position = surfaces.at[2 * i].xyz, normal = surfaces.at[2 * i + 1].xyz;
    const Lens lens = lens_of(camera);
    uint another = 0;
    for (uint s = first; s < end && another == 0; ++s) {
        Sampler random = Sampler(key_of_pixel(lens, pixel), s, 0);
        Ray ray = camera_ray(lens, vec2(pixel) + next2(random));
        for (int panes = 16;; --panes) {
            const Hit hit = trace_ray(w, ray.origin, ray.direction, kFar, 0);
            vec3 there = vec3(0), there_normal = vec3(0);
            if (hit.place != kNone) {
                there = ray.origin + ray.direction * hit.distance;
                const vec4 r2 = w.triangles.at[3 * hit.place + 2];
                if (panes > 0 && floatBitsToUint(r2.w) != 0) {  // clear
                    ray.origin = there + ray.direction * 1e-3f;
                    continue;
                }
                const HitSurface on = hit_surface(w, hit, ray.direction);
                there_normal = shading_normal(w, corner_of(w, hit, on.triangle), on.normal);
                if (on.back) there_normal = -there_normal;
            }
            if (another_surface(position, normal, there, there_normal)) another = 1;
            break;
        }
    }
    found.at[i] = another;
}
