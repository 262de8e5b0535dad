// The names of math/vec.h and of the C++ library that the shared files use; see language.h.
#ifndef FASTSCENE_TRACE_KERNEL_LANGUAGE_GLSL
#define FASTSCENE_TRACE_KERNEL_LANGUAGE_GLSL

#extension GL_EXT_control_flow_attributes : require

#define KERNEL_BEGIN
#define KERNEL_END
#define IN(Type) in Type
#define INOUT(Type) inout Type
#define REF(Type) Type
#define inline
#define static
#define Vec2f vec2
#define Vec3f vec3
#define lerp mix
#define KEEP_LOOP [[dont_unroll]]  // kernels of patterns are long enough
#define round round_away

const float kPi = 3.14159265358979f;

float atan2(float y, float x) { return x == 0 && y == 0 ? 0 : atan(y, x); }
float copysign(float size, float sign_of) { return (floatBitsToUint(sign_of) >> 31) != 0 ? -abs(size) : abs(size); }
// Halves away from zero. A quotient that ought to be a half may be a few units in the last place short of it.
float round_away(float x) { return sign(x) * floor(abs(x) * (1 + 4e-7f) + 0.5f); }
float hypot(float a, float b) { return length(vec2(a, b)); }
float max_component(vec3 a) { return max(a.x, max(a.y, a.z)); }
float luminance(vec3 c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }
void make_frame(vec3 n, out vec3 s, out vec3 t) {
    const float side = copysign(1, n.z), a = -1 / (side + n.z), b = n.x * n.y * a;
    s = vec3(1 + side * n.x * n.x * a, side * b, -side * n.x);
    t = vec3(b, side + n.y * n.y * a, -n.y);
}

#endif
