// Tone mapping (trace/film.cc).
float bent(float v, float limit, float power) { return v / pow(1 + pow(v / limit, power), 1 / power); }
float film_value(float slope, float x) {
    if (!(x > 0)) return 0;
    if (slope == 0) return min(1, x);
    const float up = slope * log2(x / 0.18f);
    const float value = up > 0 ? 0.4587f + bent(up, 1 - 0.4587f, 2.6f) : 0.4587f - bent(max(-up, 0), 0.4587f, 2.f);
    return pow(clamp(value, 0.f, 1.f), 2.2f);
}
vec3 develop(World w, vec3 radiance) {
    const vec4 look = world_look(w);
    const float slope = world_curve(w).x;
    vec3 c = radiance * exp2(world_ground(w).w) / look.xyz;
    const float l = luminance(c);
    const vec3 kept = l > 0 ? c * (film_value(slope, l) / l) : c;
    c = 0.65f * vec3(film_value(slope, c.x), film_value(slope, c.y), film_value(slope, c.z)) + 0.35f * kept;
    const float gray = luminance(c);
    return clamp(gray + (c - gray) * look.w, 0.f, 1.f);
}
