// The processor's random numbers for gathering (base/random.h, irradiance_cells.h), by a key.
struct Random {
    uvec2 state;
};
Random random_of(uvec2 key) { return Random(mix64(key)); }
float uniform_of(inout Random r) {
    r.state = add64(r.state, word64(0x9e3779b9u, 0x7f4a7c15u));
    return unit_of_bits(high_half(mix64(r.state)));
}
vec2 r2_point(uint i, vec2 shift) {
    const vec2 p = shift + vec2(unit_of_bits(i * 3242174889u), unit_of_bits(i * 2447445414u));
    return p - floor(p);
}
