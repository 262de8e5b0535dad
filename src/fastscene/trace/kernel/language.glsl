// The names of math/vec.h and of the C++ library that the shared files use; see language.h.
#ifndef FASTSCENE_TRACE_KERNEL_LANGUAGE_GLSL
#define FASTSCENE_TRACE_KERNEL_LANGUAGE_GLSL

#extension GL_EXT_control_flow_attributes : require

#define KERNEL_BEGIN
#define KERNEL_END
#define IN(Type) in Type
#define INOUT(Type) inout Type
#define OUT(Type) out Type
#define inline
#define static
#define Vec2f vec2
#define Vec3f vec3
#define lerp mix
#define KEEP_LOOP [[dont_unroll]]

const float kPi = 3.14159265358979f;

float atan2(float y, float x) { return x == 0 && y == 0 ? 0 : atan(y, x); }
float copysign(float size, float sign_of) { return (floatBitsToUint(sign_of) >> 31) != 0 ? -abs(size) : abs(size); }
float hypot(float a, float b) { return length(vec2(a, b)); }
float max_component(vec3 a) { return max(a.x, max(a.y, a.z)); }
float luminance(vec3 c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }
// As math/vec.h's, but right-handed frames only of unit vectors.
void make_frame(vec3 n, out vec3 s, out vec3 t) {
    const float side = copysign(1, n.z), a = -1 / (side + n.z), b = n.x * n.y * a;
    s = vec3(1 + side * n.x * n.x * a, side * b, -side * n.x);
    t = vec3(b, side + n.y * n.y * a, -n.y);
}

#endif
