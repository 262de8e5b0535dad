// The outside (trace/outdoors.cc, sky.cc).
const vec2 kTableSize = vec2(512, 256);
const float kBandTop = 0.96;

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
vec3 dome_at(World w, vec3 direction) { return dome_air(w, direction); }
vec3 bare_outside(World w, vec3 direction) { return direction.y > 0 ? world_ground(w).xyz : dome_at(w, direction); }

// For illumination: Outdoors::light.
vec3 outside_light(World w, vec3 direction) {
    if (w.has_table == 0) return bare_outside(w, direction);
    const ivec2 p = clamp(ivec2(table_position(direction)), ivec2(0), ivec2(kTableSize) - 1);
    return w.outside_table.at[p.y * 512 + p.x].xyz;
}

// For cameras: Outdoors::seen.
vec3 outside_seen(World w, vec3 direction) {
    if (w.has_table == 0) return bare_outside(w, direction);
    const vec4 band = world_band(w);
    const int width = int(band.x), height = int(band.y);
    if (width > 0) {
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
                return mix(mix(w.band_pixels.at[row + left].xyz, w.band_pixels.at[row + right].xyz, a),
                           mix(w.band_pixels.at[row + w.band_pitch + left].xyz,
                               w.band_pixels.at[row + w.band_pitch + right].xyz, a), b);
            }
        }
    }
    if (-direction.y > sin(kBandTop)) return dome_at(w, direction);
    const vec2 p = table_position(direction) - 0.5f;
    const int x = int(floor(p.x)), y = clamp(int(floor(p.y)), 0, 254);
    const float a = p.x - float(x), b = unit_clamp(p.y - float(y));
    const int left = y * 512 + wrapped_column(x, 512), right = y * 512 + wrapped_column(x + 1, 512);
    return mix(mix(w.outside_table.at[left].xyz, w.outside_table.at[right].xyz, a),
               mix(w.outside_table.at[left + 512].xyz, w.outside_table.at[right + 512].xyz, a), b);
}
vec3 outside_of_camera(World w, vec3 direction) { return outside_seen(w, direction) * world_zenith(w).w; }

vec3 lamp_seen(World w, vec3 emission) { return lamp_as_seen(world_ground(w).w, emission); }
