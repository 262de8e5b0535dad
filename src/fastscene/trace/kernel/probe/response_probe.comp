// For kernel_test.cc: the reflection model of many materials, for directions drawn by the sampler.
#version 460
#include "fastscene/trace/kernel/response.h"
#include "fastscene/trace/kernel/sampler.h"

layout(local_size_x = 64) in;

struct Answer {
    float number[48];
};
layout(buffer_reference, std430, buffer_reference_align = 16) writeonly buffer Answers { Answer at[]; };
layout(push_constant) uniform Push {
    Materials materials;
    Answers answers;
    uint count, key_high;
};

vec3 direction_of(vec2 a, vec2 b) { return normalize(vec3(2 * a.x - 1, 2 * a.y - 1, 2 * b.x - 1)); }

Answer answer;
int filled = 0;
void put(float x) { answer.number[filled++] = x; }
void put(vec3 c) {
    put(c.x);
    put(c.y);
    put(c.z);
}

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    Material m = materials.at[i];
    Sampler s;
    s.key = word64(key_high, i);
    s.index = i & 31;
    s.dimension = 0;
    const vec2 a = next2(s), b = next2(s), c = next2(s), d = next2(s), e = next2(s), f = next2(s), u = next2(s);
    put(vec3(a, b.x));
    put(vec3(b.y, u));
    const vec3 normal = direction_of(a, b), direction = direction_of(c, d), sun = direction_of(e, f);
    TextureValue texture = texture_value(m.color_b, m.roughness, 0);
    texture.metal = m.metal;
    const Response r = response_of(m, texture, normal, direction);
    put(r.diffuse);
    put(r.behind);
    put(r.specular);
    put(r.alpha);
    put(flame_as_seen(f.y, m.emission, normal, direction));
    const Pane pane = pane_of(m.color_b, normal, direction);
    put(pane.through);
    put(pane.mirrored);
    put(mean_reflectance(m, m.color_a, m.metal));
    const vec3 halfway = ggx_half(normal, r.alpha, u);
    put(halfway);
    put(ggx_pdf(normal, r.alpha, direction, sun));
    put(sun_glint(sun, normal, r, direction, vec3(3, 2, 1), kSharpestSun));
    put(sun_reflected(sun, m.color_a, coat_of(m, m.color_a, m.roughness, m.metal), m.transmission, normal, direction,
                      f.y > 0.5f));
    put(cosine_direction(normal, u));
    put(outside_as_seen(0.2f, 3, m.emission));
    put(is_clear(m) ? 1 : 0);
    put(is_flame(m) ? 1 : 0);
    put(power_heuristic(u.x, u.y));
    answers.at[i] = answer;
}
