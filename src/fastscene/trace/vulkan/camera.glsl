// The camera rays of a picture (trace/picture.h's RayCamera).
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Camera {
    vec4 row_x, row_y, row_z;  // world from camera: a row of the rotation, and the translation's component
    vec4 lens;                 // pinhole: fx, fy, cx, cy; panorama: its width and height, metres to the eye
    uvec4 more;                // 1: a panorama; unused; the picture's seed, mixed
};
struct Lens {
    vec4 row_x, row_y, row_z, lens;
    uvec4 more;
};
Lens lens_of(Camera c) { return Lens(c.row_x, c.row_y, c.row_z, c.lens, c.more); }
uvec2 key_of_pixel(Lens c, uvec2 pixel) { return c.more.zw ^ pixel; }

struct Ray {
    vec3 origin, direction;
};
Ray camera_ray(Lens c, vec2 p) {
    vec3 way, start = vec3(0);
    if (c.more.x != 0) {
        const float lon = (p.x / c.lens.x - 0.5f) * 2 * kPi, lat = (0.5f - p.y / c.lens.y) * kPi;
        way = vec3(cos(lat) * sin(lon), -sin(lat), cos(lat) * cos(lon));
        if (c.lens.z != 0) {  // geometry/eyes.h
            const float t = clamp((abs(lat) * 180 / kPi - 60) / 15, 0.0, 1.0);
            const float aside = c.lens.z * (1 - t * t * (3 - 2 * t));
            start = vec3(cos(lon) * aside, 0, -sin(lon) * aside);
        }
    } else way = vec3((p.x - c.lens.z) / c.lens.x, (p.y - c.lens.w) / c.lens.y, 1);
    return Ray(vec3(dot(c.row_x.xyz, start), dot(c.row_y.xyz, start), dot(c.row_z.xyz, start)) +
                   vec3(c.row_x.w, c.row_y.w, c.row_z.w),
               normalize(vec3(dot(c.row_x.xyz, way), dot(c.row_y.xyz, way), dot(c.row_z.xyz, way))));
}
