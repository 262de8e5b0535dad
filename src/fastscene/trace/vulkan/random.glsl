// The processor's random numbers (base/random.h, trace/sampler.h). 64-bit words are pairs, the low half first: not all
// cards have them.
uvec2 add64(uvec2 a, uvec2 b) {
    uint carry;
    const uint low = uaddCarry(a.x, b.x, carry);
    return uvec2(low, a.y + b.y + carry);
}
uvec2 mul64(uvec2 a, uvec2 b) {
    uint high, low;
    umulExtended(a.x, b.x, high, low);
    return uvec2(low, high + a.x * b.y + a.y * b.x);
}
uvec2 shift_right64(uvec2 a, uint by) { return uvec2(a.x >> by | a.y << (32 - by), a.y >> by); }
uvec2 mix64(uvec2 x) {
    x = add64(x, uvec2(0x7f4a7c15u, 0x9e3779b9u));
    x = mul64(x ^ shift_right64(x, 30), uvec2(0x1ce4e5b9u, 0xbf58476du));
    x = mul64(x ^ shift_right64(x, 27), uvec2(0x133111ebu, 0x94d049bbu));
    return x ^ shift_right64(x, 31);
}

// Random of base/random.h, by a key.
struct Random {
    uvec2 state;
};
Random random_of(uvec2 key) { return Random(mix64(key)); }
float uniform_of(inout Random r) {
    r.state = add64(r.state, uvec2(0x7f4a7c15u, 0x9e3779b9u));
    return float(mix64(r.state).y >> 8) * 5.9604644775390625e-8;
}

struct Sampler {
    uvec2 key;
    uint index, dimension;
};
uint scrambled(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    return x ^ x * 0x53a22864u;
}
uint scrambled_value(uint x, uint seed) { return bitfieldReverse(scrambled(bitfieldReverse(x), seed)); }
uint sobol_second(uint n) {
    uint value = 0;
    for (uint column = 0x80000000u; n != 0; n >>= 1, column ^= column >> 1)
        if ((n & 1u) != 0) value ^= column;
    return value;
}
float unit_of(uint x) { return float(x >> 8) * 5.9604644775390625e-8; }
vec2 next2(inout Sampler s) {
    ++s.dimension;
    const uvec2 h = mix64(add64(s.key, mul64(uvec2(0xd9b4e019u, 0x632be59bu), uvec2(s.dimension, 0))));
    const uint i = scrambled(bitfieldReverse(s.index), h.x), n = bitfieldReverse(i);
    return vec2(unit_of(scrambled_value(bitfieldReverse(n), h.y)),
                unit_of(scrambled_value(sobol_second(n), mix64(h).x)));
}
float next(inout Sampler s) { return next2(s).x; }

// irradiance_cells.h
vec2 r2_point(uint i, vec2 shift) {
    const vec2 p = shift + vec2(float((i * 3242174889u) >> 8), float((i * 2447445414u) >> 8)) * 5.9604644775390625e-8;
    return p - floor(p);
}
float power_heuristic(float mine, float other) { return mine * mine / max(1e-20, mine * mine + other * other); }
