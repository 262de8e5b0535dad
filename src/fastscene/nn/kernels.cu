#include <cuda_bf16.h>
#include <cuda_fp16.h>
#include <cuda_runtime.h>

#include <algorithm>

#include "fastscene/nn/kernels.h"

namespace fastscene::nn::kernels {
namespace {

constexpr int kAtOnce = 8, kPairs = kAtOnce / 2;  // channels of a thread: 16 bytes of halves
constexpr int kThreads = 256;
// Blocks of a picture that keep the largest cards busy, and rows of a thread that pay for its start and its partial
// sums.
constexpr int kBlocks = 512, kLeastRows = 8, kMostRows = 64;
constexpr int kMomentThreads = 128;

__device__ float as_float(float x) { return x; }
__device__ float as_float(__half x) { return __half2float(x); }
__device__ float as_float(__nv_bfloat16 x) { return __bfloat162float(x); }
template <class T>
__device__ T as(float x);
template <>
__device__ float as<float>(float x) {
    return x;
}
template <>
__device__ __half as<__half>(float x) {
    return __float2half_rn(x);
}
template <>
__device__ __nv_bfloat16 as<__nv_bfloat16>(float x) {
    return __float2bfloat16_rn(x);
}

template <class T>
struct alignas(sizeof(T) * kAtOnce < 16 ? sizeof(T) * kAtOnce : 16) Channels {
    T of[kAtOnce];
};

template <class T>
__device__ Channels<T> load(const T* from) {
    return *reinterpret_cast<const Channels<T>*>(from);
}

// How a picture is cut: a thread takes eight channels of every height-th row of its block's rows.
struct Cut {
    dim3 threads, blocks;
    int rows;      // of a block
    int partials;  // of a picture: threads that share its channels
};
Cut cut_of(const NormShape& s) {
    const int across = s.channels / kAtOnce, down = std::max(1, kThreads / across);
    const int each = std::clamp(s.positions / (down * std::max(1, kBlocks / s.n)), kLeastRows, kMostRows);
    Cut cut;
    cut.rows = each * down;
    cut.threads = dim3(static_cast<unsigned>(across), static_cast<unsigned>(down));
    cut.blocks = dim3(static_cast<unsigned>((s.positions + cut.rows - 1) / cut.rows), static_cast<unsigned>(s.n));
    cut.partials = static_cast<int>(cut.blocks.x) * down;
    return cut;
}

// Sums of each pair of channels, and of their squares, over each thread's rows: [n, partials, channels / 2].
template <class T>
__global__ void sums_kernel(const T* x, float2* partial, int positions, int channels, int rows) {
    const int channel = static_cast<int>(threadIdx.x) * kAtOnce, from = static_cast<int>(blockIdx.x) * rows,
              to = min(from + rows, positions);
    const T* picture = x + static_cast<std::size_t>(blockIdx.y) * positions * channels + channel;
    float sum[kPairs] = {}, squares[kPairs] = {};
#pragma unroll 4
    for (int row = from + static_cast<int>(threadIdx.y); row < to; row += static_cast<int>(blockDim.y)) {
        const Channels<T> v = load(picture + static_cast<std::size_t>(row) * channels);
#pragma unroll
        for (int i = 0; i < kAtOnce; ++i) {
            const float a = as_float(v.of[i]);
            sum[i / 2] += a;
            squares[i / 2] += a * a;
        }
    }
    const std::size_t mine = (static_cast<std::size_t>(blockIdx.y) * gridDim.x + blockIdx.x) * blockDim.y + threadIdx.y;
    float2* out = partial + mine * (channels / 2) + channel / 2;
#pragma unroll
    for (int i = 0; i < kPairs; ++i) out[i] = make_float2(sum[i], squares[i]);
}

// Mean and 1 / deviation of each group: [n, groups].
__global__ void moments_kernel(const float2* partial, float2* moments, int partials, int pairs, int of_group,
                               double count, float eps) {
    __shared__ double sums[kMomentThreads], squares[kMomentThreads];
    const int group = static_cast<int>(blockIdx.x), me = static_cast<int>(threadIdx.x);
    const float2* picture = partial + static_cast<std::size_t>(blockIdx.y) * partials * pairs + group * of_group;
    double sum = 0, square = 0;
    for (int i = me; i < partials * of_group; i += kMomentThreads) {
        const float2 p = picture[static_cast<std::size_t>(i / of_group) * pairs + i % of_group];
        sum += p.x;
        square += p.y;
    }
    sums[me] = sum;
    squares[me] = square;
    __syncthreads();
    for (int half = kMomentThreads / 2; half > 0; half /= 2) {
        if (me < half) {
            sums[me] += sums[me + half];
            squares[me] += squares[me + half];
        }
        __syncthreads();
    }
    if (me == 0) {
        const double mean = sums[0] / count, variance = fmax(squares[0] / count - mean * mean, 0.0);
        moments[blockIdx.y * gridDim.x + blockIdx.x] = make_float2(static_cast<float>(mean),
                                                                   rsqrtf(static_cast<float>(variance) + eps));
    }
}

template <class T, bool kSilu>
__global__ void apply_kernel(const T* x, const T* weight, const T* bias, const float2* moments, T* y, int positions,
                             int channels, int groups, int rows) {
    const int channel = static_cast<int>(threadIdx.x) * kAtOnce, from = static_cast<int>(blockIdx.x) * rows,
              to = min(from + rows, positions), of_group = channels / groups;
    float scale[kAtOnce], shift[kAtOnce];
#pragma unroll
    for (int i = 0; i < kAtOnce; ++i) {
        const float2 m = moments[blockIdx.y * groups + (channel + i) / of_group];
        scale[i] = m.y * as_float(weight[channel + i]);
        shift[i] = as_float(bias[channel + i]) - m.x * scale[i];
    }
    const std::size_t first = static_cast<std::size_t>(blockIdx.y) * positions * channels + channel;
#pragma unroll 4
    for (int row = from + static_cast<int>(threadIdx.y); row < to; row += static_cast<int>(blockDim.y)) {
        const std::size_t at = first + static_cast<std::size_t>(row) * channels;
        Channels<T> v = load(x + at);
#pragma unroll
        for (int i = 0; i < kAtOnce; ++i) {
            const float a = as_float(v.of[i]) * scale[i] + shift[i];
            v.of[i] = as<T>(kSilu ? a / (1.f + __expf(-a)) : a);
        }
        *reinterpret_cast<Channels<T>*>(y + at) = v;
    }
}

template <class T>
__global__ void gated_gelu_kernel(const T* x, T* to, std::size_t eighths, int across) {
    const std::size_t i = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x;
    if (i >= eighths) return;
    const std::size_t row = i / across, column = i % across;
    const Channels<T> left = load(x + (2 * row * across + column) * kAtOnce),
                      right = load(x + ((2 * row + 1) * across + column) * kAtOnce);
    Channels<T> out;
#pragma unroll
    for (int k = 0; k < kAtOnce; ++k) {
        const float b = as_float(right.of[k]);
        out.of[k] = as<T>(as_float(left.of[k]) * (0.5f * b * (1.f + erff(b * 0.70710678f))));
    }
    *reinterpret_cast<Channels<T>*>(to + i * kAtOnce) = out;
}

template <class T>
void norm(const void* x, const void* weight, const void* bias, void* y, float* scratch, const NormShape& s, float eps,
          bool silu, cudaStream_t stream) {
    const Cut cut = cut_of(s);
    const int pairs = s.channels / 2;
    float2* const partial = reinterpret_cast<float2*>(scratch);
    float2* const moments = partial + static_cast<std::size_t>(s.n) * cut.partials * pairs;
    const auto *from = static_cast<const T*>(x), *w = static_cast<const T*>(weight), *b = static_cast<const T*>(bias);
    sums_kernel<T><<<cut.blocks, cut.threads, 0, stream>>>(from, partial, s.positions, s.channels, cut.rows);
    const double count = static_cast<double>(s.positions) * (s.channels / s.groups);
    moments_kernel<<<dim3(static_cast<unsigned>(s.groups), static_cast<unsigned>(s.n)), kMomentThreads, 0, stream>>>(
        partial, moments, cut.partials, pairs, pairs / s.groups, count, eps);
    const auto apply = silu ? apply_kernel<T, true> : apply_kernel<T, false>;
    apply<<<cut.blocks, cut.threads, 0, stream>>>(from, w, b, moments, static_cast<T*>(y), s.positions, s.channels,
                                                  s.groups, cut.rows);
}

template <class T>
void gated(const void* x, void* to, std::size_t rows, int width, cudaStream_t stream) {
    const int across = width / kAtOnce;
    const std::size_t eighths = rows * static_cast<std::size_t>(across);
    if (eighths == 0) return;
    const auto blocks = static_cast<unsigned>((eighths + kThreads - 1) / kThreads);
    gated_gelu_kernel<T>
        <<<blocks, kThreads, 0, stream>>>(static_cast<const T*>(x), static_cast<T*>(to), eighths, across);
}

}  // namespace

std::size_t group_norm_scratch(const NormShape& s) {
    return 2 * (static_cast<std::size_t>(s.n) * cut_of(s).partials * (s.channels / 2) +
                static_cast<std::size_t>(s.n) * s.groups);
}

void group_norm(Number type, const void* x, const void* weight, const void* bias, void* y, float* scratch,
                const NormShape& shape, float eps, bool silu, void* stream) {
    const auto on = static_cast<cudaStream_t>(stream);
    switch (type) {
        case Number::f32: return norm<float>(x, weight, bias, y, scratch, shape, eps, silu, on);
        case Number::f16: return norm<__half>(x, weight, bias, y, scratch, shape, eps, silu, on);
        case Number::bf16: return norm<__nv_bfloat16>(x, weight, bias, y, scratch, shape, eps, silu, on);
    }
}

void gated_gelu(Number type, const void* x, void* to, std::size_t rows, int width, void* stream) {
    const auto on = static_cast<cudaStream_t>(stream);
    switch (type) {
        case Number::f32: return gated<float>(x, to, rows, width, on);
        case Number::f16: return gated<__half>(x, to, rows, width, on);
        case Number::bf16: return gated<__nv_bfloat16>(x, to, rows, width, on);
    }
}

}  // namespace fastscene::nn::kernels
