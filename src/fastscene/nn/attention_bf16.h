// Attention products in bfloat16, with AMX or AVX512-BF16; sums and softmax in single precision. Private to
// nn/attention.cc.
//
// An AMX tile has 16 rows of 64 bytes; one instruction multiplies 16 x 32 by 32 x 16, where the second operand
// interleaves pairs of rows. An AVX512-BF16 vector multiplies two numbers of a row by such a pair of rows.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fastscene::nn::bf16 {

using Bf16 = std::uint16_t;

// Whether the program was compiled for such processors and runs on one. Evaluated once.
bool available();

inline constexpr std::int64_t kRows = 32;  // rows of q processed together

// Sizes of what pack() writes: the m keys and values of one head, of d numbers each.
std::int64_t packed_keys(std::int64_t m, std::int64_t d);
std::int64_t packed_values(std::int64_t m, std::int64_t d);
void pack(const Bf16* k, const Bf16* v, std::int64_t m, std::int64_t d, Bf16* keys, Bf16* values);

// Bytes of scratch memory for attend(), aligned to 64.
std::size_t workspace(std::int64_t d);
// out [count, d] = softmax(q k' / sqrt(d)) v for q [count, d], any count.
void attend(const Bf16* q, std::int64_t count, const Bf16* keys, const Bf16* values, std::int64_t m, std::int64_t d,
            std::byte* work, Bf16* out);

}  // namespace fastscene::nn::bf16
