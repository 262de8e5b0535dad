// What a pixel's rays found: the host's PixelSum (pixel_sum.h), which stays in memory while rays are added. A pixel
// takes kPixelRows vectors: three of its own, and of two surfaces nine each.
const uint kSurfaceRows = 9, kPixelRows = 21;
vec4 row_of(InOutVec4s sums, uint i) { return sums.at[i]; }

struct Shaded {
    vec3 radiance, albedo, light, sun, mirrored, diffuse, specular, position, normal;
};
float ratio(float a, float b) { return b > 1e-6f ? a / b : 0; }

// pixel_sum.h's another_surface.
bool another_surface(vec3 position, vec3 normal, vec3 other, vec3 other_normal) {
    const bool outside = dot(normal, normal) < 0.5f, there = dot(other_normal, other_normal) < 0.5f;
    if (outside || there) return outside != there;
    const vec3 to = other - position;
    const float aside = dot(to, normal);
    return !(dot(other_normal, normal) > 0.9f && aside * aside < 0.04f * dot(to, to) + 1e-6f);
}

// A surface's rows: color, count; radiance, texture's sum; diffuse, its squares; specular, -; position, -; normal, -;
// for diffuse light, sun and specular light each the light seen, and sums of what arrives: row 6, 7 and 8 hold the
// light, w the sums; the squares are w of specular, position and normal.
bool takes_surface(InOutVec4s sums, uint at, Shaded s) {
    if (row_of(sums, at).w == 0) return true;
    return !another_surface(row_of(sums, at + 4).xyz, row_of(sums, at + 5).xyz, s.position, s.normal);
}
void add_to_surface(InOutVec4s sums, uint at, Shaded s, vec3 developed) {
    vec4 row = sums.at[at];
    const bool is_first = row.w == 0;
    sums.at[at] = row + vec4(developed, 1);
    const float texture = luminance(s.diffuse + s.specular);
    const float diffuse = luminance(s.diffuse), specular = luminance(s.specular);
    const vec3 arriving = vec3(ratio(luminance(s.light), diffuse), ratio(luminance(s.sun), diffuse),
                               ratio(luminance(s.mirrored), specular));
    sums.at[at + 1] = sums.at[at + 1] + vec4(s.radiance, texture);
    sums.at[at + 2] = sums.at[at + 2] + vec4(s.diffuse, texture * texture);
    sums.at[at + 3] = sums.at[at + 3] + vec4(s.specular, arriving.x * arriving.x);
    row = sums.at[at + 4];
    sums.at[at + 4] = vec4(is_first ? s.position : row.xyz, row.w + arriving.y * arriving.y);
    row = sums.at[at + 5];
    sums.at[at + 5] = vec4(is_first ? s.normal : row.xyz, row.w + arriving.z * arriving.z);
    sums.at[at + 6] = sums.at[at + 6] + vec4(s.light, arriving.x);
    sums.at[at + 7] = sums.at[at + 7] + vec4(s.sun, arriving.y);
    sums.at[at + 8] = sums.at[at + 8] + vec4(s.mirrored, arriving.z);
}
// A pixel's own rows: rest color, rays taken; albedo, sum of what is shown; its squares, -.
void add_to_pixel(InOutVec4s sums, uint pixel, Shaded s, vec3 developed) {
    const uint at = pixel * kPixelRows, own = at + 3, second = own + kSurfaceRows;
    const float shown = luminance(developed);
    vec3 rest = vec3(0);
    if (takes_surface(sums, own, s)) add_to_surface(sums, own, s, developed);
    else if (takes_surface(sums, second, s)) add_to_surface(sums, second, s, developed);
    else rest = developed;
    sums.at[at] = sums.at[at] + vec4(rest, 1);
    sums.at[at + 1] = sums.at[at + 1] + vec4(s.albedo, shown);
    sums.at[at + 2] = sums.at[at + 2] + vec4(shown * shown, 0, 0, 0);
}

// MeanError.
float variance_of(float count, float sum, float squares) {
    const float mean = sum / count;
    return max(0, squares / count - mean * mean) / count;
}
float srgb_error_of(float count, float sum, float squares) {
    return sqrt(variance_of(count, sum, squares)) * 0.5f / sqrt(max(0.003f, sum / count));
}
// SurfaceSum::noisy.
bool is_noisy(InOutVec4s sums, uint at, float tolerated) {
    const float count = row_of(sums, at).w;
    const vec4 diffuse = sums.at[at + 2], specular = sums.at[at + 3], position = sums.at[at + 4],
               normal = sums.at[at + 5];
    const vec3 squares = vec3(specular.w, position.w, normal.w);
    float error = 0, level = 0;
    for (uint k = 0; k < 3; ++k) {
        const vec4 light = sums.at[at + 6 + k];
        const float by = luminance((k < 2 ? diffuse.xyz : specular.xyz) / count);
        error += variance_of(count, light.w, k == 0 ? squares.x : k == 1 ? squares.y : squares.z) * by * by;
        level += luminance(light.xyz) / count;
    }
    return error > tolerated * tolerated * level * level;
}
// pixel_sum.h's needs_more.
bool needs_more(InOutVec4s sums, uint pixel, bool denoise, float noise, float samples) {
    const uint at = pixel * kPixelRows, own = at + 3;
    const float taken = row_of(sums, at).w;
    if (taken >= samples) return false;
    const float error = srgb_error_of(taken, row_of(sums, at + 1).w, row_of(sums, at + 2).x);
    if (!denoise) return error > noise;
    if (!(error > noise)) return false;
    if (is_noisy(sums, own, 0.03f)) return taken < floor(samples / 2);
    const float count = row_of(sums, own).w;
    if (count < taken) return taken < floor(samples / 4) || (taken < floor(samples / 2) && error > 2 * noise);
    return taken < floor(samples / 4) && srgb_error_of(count, row_of(sums, own + 1).w, row_of(sums, own + 2).w) > noise;
}
