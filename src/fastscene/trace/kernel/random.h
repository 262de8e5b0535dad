// 64-bit words and how base/random.h mixes them. Not all cards have such words: in GLSL they are pairs of 32 bits, the
// low half first.
#ifndef FASTSCENE_TRACE_KERNEL_RANDOM_H
#define FASTSCENE_TRACE_KERNEL_RANDOM_H

#include "fastscene/trace/kernel/language.h"

#ifdef __cplusplus
#include "fastscene/base/random.h"

namespace fastscene::kernel {

using uint64 = std::uint64_t;
inline uint64 word64(uint high, uint low) { return static_cast<uint64>(high) << 32 | low; }
inline uint high_half(uint64 a) { return static_cast<uint>(a >> 32); }
inline uint low_half(uint64 a) { return static_cast<uint>(a); }
inline uint64 add64(uint64 a, uint64 b) { return a + b; }
inline uint64 mul64(uint64 a, uint64 b) { return a * b; }

}  // namespace fastscene::kernel
#else
#define uint64 uvec2
uvec2 word64(uint high, uint low) { return uvec2(low, high); }
uint high_half(uvec2 a) { return a.y; }
uint low_half(uvec2 a) { return a.x; }
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
uvec2 shift_right64(uvec2 a, uint by) { return uvec2(a.x >> by | a.y << (32 - by), a.y >> by); }  // by less than 32
uvec2 mix64(uvec2 x) {
    x = add64(x, word64(0x9e3779b9u, 0x7f4a7c15u));
    x = mul64(x ^ shift_right64(x, 30), word64(0xbf58476du, 0x1ce4e5b9u));
    x = mul64(x ^ shift_right64(x, 27), word64(0x94d049bbu, 0x133111ebu));
    return x ^ shift_right64(x, 31);
}
#endif

#endif
