// The outside (trace/outdoors.cc, sky.cc).
const vec2 kTableSize = vec2(512, 256);
const float kBandTop = 0.96;
const uint kPictured = 2;  // has_table: the outside is a photograph

float azimuth_of(vec3 d) { return d.x == 0 && d.z == 0 ? 0 : atan(d.x, d.z); }
vec2 table_position(vec3 d) {
    const float level = length(d.xz), rise = level == 0 && d.y == 0 ? 0 : atan(-d.y, level);
    return vec2(azimuth_of(d) / (2 * kPi) + 0.5f, 0.5f - rise / kPi) * kTableSize;
}
int wrapped_column(int x, int width) { return x < 0 ? x + width : x >= width ? x - width : x; }

vec3 dome_air(World w, vec3 direction) {
    const float up = clamp(-direction.y, 0.f, 1.f);
    const vec3 even = mix(world_horizon(w).xyz, world_zenith(w).xyz, pow(up, 0.45f));
    const vec3 sunward = world_sunward(w).xyz;
    const float level = length(direction.xz);
    const float cosine = level > 1e-5f ? dot(direction.xz, sunward.xz) / level : 1;
    const vec2 p = vec2(acos(clamp(cosine, -1.f, 1.f)) / kPi, up) * 32;
    const ivec2 i = ivec2(min(p, vec2(31)));
    const vec2 f = p - vec2(i);
    const int row = i.y * 33 + i.x;
    return even * mix(mix(w.dome.at[row].xyz, w.dome.at[row + 1].xyz, f.x),
                      mix(w.dome.at[row + 33].xyz, w.dome.at[row + 34].xyz, f.x), f.y);
}
float cloud_density(float clouds, float footprint, uint seed, vec2 p) {
    const vec2 q = p * 1.25f;
    const vec2 warp = vec2(noise2(q * 2.f, seed + 7), noise2(q * 2.f + vec2(9, 4), seed + 8)) - 0.5f;
    return fbm2(q + warp * 0.35f, 7, footprint, seed) - (0.66f - 0.3f * clouds);
}
vec3 dome_clouded(World w, vec3 direction, vec3 behind) {
    const vec4 sun_and_clouds = world_sun_light(w);
    const float up = -direction.y, clouds = sun_and_clouds.w;
    if (!(up > 0.015f) || !(clouds > 0)) return behind;
    const uint seed = w.sky_seed + 11;
    const vec2 plane = direction.xz / (up + 0.12f);
    const float footprint = 0.006f / (up + 0.12f);
    if (clouds > 0.9f) {
        const vec2 p = plane * 0.9f;
        const vec2 warp = vec2(fbm2(p + vec2(5, 1), 3, footprint, seed + 5),
                               fbm2(p + vec2(2, 8), 3, footprint, seed + 6));
        const float fold = fbm2(p + warp * 1.1f, 6, footprint, seed);
        return behind * mix(1, 0.72f + 0.56f * fold, smooth_step(0.02f, 0.25f, up));
    }
    // Here, and on the way to the sun, which darkens it.
    const vec3 to_sun = world_sun(w).xyz;
    const vec4 ways = vec4(0, 0.05f, 0.13f, 0.26f);
    float here = 0, between = 0;
    for (int k = 0; k < 4; ++k) {
        const float density = cloud_density(clouds, footprint, seed, plane + to_sun.xz * ways[k]);
        if (k == 0) here = density;
        else between += max(0, density);
        if (!(here > 0)) return behind;
    }
    const float thick = min(1, here * 6), cover = (1 - exp(-9 * here)) * smooth_step(0.015f, 0.16f, up);
    const float lit = exp(-3.2f * between), towards = max(0, dot(direction, to_sun));
    const float shine = pow(towards, 12.f) * (1 - thick);
    const vec3 horizon = world_horizon(w).xyz, zenith = world_zenith(w).xyz;
    const vec3 white = vec3(0.85f * luminance(horizon) + 0.5f * luminance(zenith));
    const vec3 shaded = mix(horizon, zenith, 0.5f) * 0.72f;
    const float sun = luminance(sun_and_clouds.xyz);
    vec3 hue = vec3(1);
    if (sun > 0) hue = mix(vec3(1), sun_and_clouds.xyz / sun, 0.8f);
    return mix(behind, mix(shaded, white * hue * (1.02f + 0.5f * shine), 0.3f + 0.7f * lit) * (1.05f - 0.2f * thick),
               0.9f * cover);
}
vec3 dome_at(World w, vec3 direction) {
    const float up = -direction.y;
    vec3 color = dome_air(w, direction);
    if (world_horizon(w).w != 0 && up > 0.05f && world_sun_light(w).w < 0.8f) {  // stars
        const vec2 grid = vec2(azimuth_of(direction), asin(clamp(up, -1, 1))) * 560;
        if (lattice_unit(floor_int(grid.x), floor_int(grid.y), 4, w.sky_seed) > 0.9988f)
            color += vec3(0.1f, 0.104f, 0.12f);
    }
    return dome_clouded(w, direction, color);
}
// For illumination where there are windows: Outdoors::light.
vec3 outside_light(World w, vec3 direction) {
    const ivec2 p = clamp(ivec2(table_position(direction)), ivec2(0), ivec2(kTableSize) - 1);
    return w.outside_table.at[p.y * 512 + p.x].xyz;
}

// Where a ray leaves: as cameras see it (`sharp`: Outdoors::seen, outside_as_seen), or Outdoors::light.
vec3 outside_of(World w, vec3 direction, bool sharp) {
    const float share = sharp ? world_zenith(w).w : 1;
    const bool bare = w.has_table == 0;
    if (bare && direction.y > 0) return world_ground(w).xyz * share;
    if (!bare && !sharp) return outside_light(w, direction);
    const vec4 band = world_band(w);
    const int width = int(band.x), height = int(band.y);
    if (!bare && width > 0) {
        const float level = length(direction.xz), rise = atan(-direction.y, level);
        const vec2 p = vec2((azimuth_of(direction) / (2 * kPi) + 0.5f) * band.x,
                            (0.5f - 0.5f * asinh(rise / band.z) / asinh(band.w / band.z)) * band.y);
        if (p.y >= 0.5f && p.y < band.y - 0.5f) {
            const float u = p.x - 0.5f, v = p.y - 0.5f;
            const int x = int(floor(u)), y = clamp(int(floor(v)), 0, height - 2);
            const uint left = w.band_columns.at[wrapped_column(x, width)],
                       right = w.band_columns.at[wrapped_column(x + 1, width)];
            if (int(left) >= 0 && int(right) >= 0) {
                const float a = u - float(x), b = unit_clamp(v - float(y));
                const uint row = uint(y) * w.band_pitch;
                return share * mix(mix(w.band_pixels.at[row + left].xyz, w.band_pixels.at[row + right].xyz, a),
                                   mix(w.band_pixels.at[row + w.band_pitch + left].xyz,
                                       w.band_pixels.at[row + w.band_pitch + right].xyz, a), b);
            }
        }
    }
    if (!bare && (w.has_table == kPictured || !(-direction.y > sin(kBandTop)))) {
        const vec2 p = table_position(direction) - 0.5f;
        const int x = int(floor(p.x)), y = clamp(int(floor(p.y)), 0, 254);
        const float a = p.x - float(x), b = unit_clamp(p.y - float(y));
        const int left = y * 512 + wrapped_column(x, 512), right = y * 512 + wrapped_column(x + 1, 512);
        return share * mix(mix(w.outside_table.at[left].xyz, w.outside_table.at[right].xyz, a),
                           mix(w.outside_table.at[left + 512].xyz, w.outside_table.at[right + 512].xyz, a), b);
    }
    return dome_at(w, direction) * share;
}
vec3 lamp_seen(World w, vec3 emission) { return lamp_as_seen(world_ground(w).w, emission); }
