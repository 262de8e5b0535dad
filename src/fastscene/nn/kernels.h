// What a network's step on a graphics card spends too long on in libtorch: a group norm there reads the picture in
// another order than the convolutions around it, with one block of threads for each group. Plain pointers on the card,
// so that its compiler reads no libtorch.
#pragma once

#include <cstddef>

namespace fastscene::nn::kernels {

enum class Number { f32, f16, bf16 };

// A picture [n, positions, channels]: channels last, without gaps.
struct NormShape {
    int n, positions, channels, groups;
};
// Channels are loaded eight at a time, and summed in pairs.
inline bool is_norm_shape(const NormShape& s) {
    return s.n > 0 && s.n < 65536 && s.positions > 0 && s.channels % 8 == 0 && s.channels <= 8192 && s.groups > 0 &&
           s.channels % (2 * s.groups) == 0;
}
// Floats of working memory.
std::size_t group_norm_scratch(const NormShape& shape);
// y = (x - mean) / sqrt(variance + eps) * weight + bias, by groups of channels, through SiLU if `silu`. weight and bias
// [channels]; sums are in single precision and do not depend on the order of threads. `stream`: a cudaStream_t.
void group_norm(Number type, const void* x, const void* weight, const void* bias, void* y, float* scratch,
                const NormShape& shape, float eps, bool silu, void* stream);

// to [rows, width] = left * gelu(right) for x [rows, 2 width]: left and right halves of each row; width % 8 == 0.
void gated_gelu(Number type, const void* x, void* to, std::size_t rows, int width, void* stream);

}  // namespace fastscene::nn::kernels
