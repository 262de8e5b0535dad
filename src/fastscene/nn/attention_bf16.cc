// Compiled for processors with these instructions and used only there (attention.cmake). Contains nothing but
// intrinsics: an inline function from a header, compiled here, could be merged by the linker into code that runs on
// other processors.
#include "fastscene/nn/attention_bf16.h"

#include "fastscene/base/isa.h"

#if defined(__linux__) && defined(__AMX_BF16__) && defined(__AVX512BF16__)

#include <immintrin.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace fastscene::nn::bf16 {
namespace {

constexpr std::int64_t kTile = 16;  // rows of a tile, and columns of an accumulator tile
constexpr std::int64_t kDeep = 32;  // bfloat16 numbers in a tile row
constexpr std::int64_t kTileSize = kTile * kDeep;
constexpr std::int64_t kKeys = 256;  // keys whose weights are in memory at once: 32 KB of scores
constexpr float kLowest = -1e37f;    // still finite after scaling

std::int64_t rounded_up(std::int64_t x, std::int64_t to) { return (x + to - 1) / to * to; }

struct Sizes {
    // d padded for products over it, d padded for sums of it, m padded: multiples of the tile size
    std::int64_t deep, wide, keys;
    Sizes(std::int64_t m, std::int64_t d)
        : deep(rounded_up(d, kDeep)), wide(rounded_up(d, kTile)), keys(rounded_up(m, kDeep)) {}
};

bool has_matrix_unit() {
    static const bool there = [] {
        constexpr long kAskForState = 0x1023,
                       // arch_prctl(ARCH_REQ_XCOMP_PERM, …): the kernel grants tile state on request only
            kTileData = 18;
        return __builtin_cpu_supports("amx-bf16") && syscall(SYS_arch_prctl, kAskForState, kTileData) == 0;
    }();
    return there;
}

// Configures all eight tiles at full size during its lifetime; does nothing without AMX.
class Tiles {
  public:
    Tiles() {
        if (!has_matrix_unit()) return;
        alignas(64) std::uint8_t config[64] = {1};
        for (int t = 0; t < 8; ++t) {
            config[16 + 2 * t] = 64;  // bytes a row
            config[48 + t] = 16;      // rows
        }
        // GCC 12 believes that the instruction reads only eight bytes, and may drop the other stores.
        asm volatile("" : : "r"(config) : "memory");
        _tile_loadconfig(config);
    }
    ~Tiles() {
        if (has_matrix_unit()) _tile_release();
    }
    Tiles(const Tiles&) = delete;
    Tiles& operator=(const Tiles&) = delete;
};

// A thread's scratch memory.
struct Work {
    Bf16 *q, *weights;    // [kRows, deep], [kRows, kKeys]
    float *scores, *sum;  // [kRows, kKeys], [kRows, wide]
    float greatest[kRows], total[kRows];
    Work(std::byte* memory, const Sizes& s)
        : q(reinterpret_cast<Bf16*>(memory)),
          weights(q + kRows * s.deep),
          scores(reinterpret_cast<float*>(weights + kRows * kKeys)),
          sum(scores + kRows * kKeys) {}
};

// scores [kRows, keys] = q keys'
void score(const Work& w, const Bf16* keys, std::int64_t count, const Sizes& s) {
    const std::int64_t chunks = s.deep / kDeep, q_row = s.deep * 2, score_row = kKeys * 4;
    for (std::int64_t j = 0; j < count; j += 2 * kTile) {
        const Bf16 *left = keys + j / kTile * chunks * kTileSize, *right = left + chunks * kTileSize;
        _tile_zero(0);
        _tile_zero(1);
        _tile_zero(2);
        _tile_zero(3);
        for (std::int64_t c = 0; c < chunks; ++c) {
            _tile_loadd(4, w.q + c * kDeep, q_row);
            _tile_loadd(6, left + c * kTileSize, 64);
            _tile_dpbf16ps(0, 4, 6);
            _tile_loadd(7, right + c * kTileSize, 64);
            _tile_dpbf16ps(1, 4, 7);
            _tile_loadd(5, w.q + kTile * s.deep + c * kDeep, q_row);
            _tile_dpbf16ps(2, 5, 6);
            _tile_dpbf16ps(3, 5, 7);
        }
        _tile_stored(0, w.scores + j, score_row);
        _tile_stored(1, w.scores + j + kTile, score_row);
        _tile_stored(2, w.scores + kTile * kKeys + j, score_row);
        _tile_stored(3, w.scores + kTile * kKeys + j + kTile, score_row);
    }
}

// Two consecutive numbers of a row, to be multiplied by a pair of rows.
__m512bh pair_of(const Bf16* at) {
    int both;
    __builtin_memcpy(&both, at, sizeof both);
    return reinterpret_cast<__m512bh>(_mm512_set1_epi32(both));
}
__m512bh pairs_of(const Bf16* at) { return reinterpret_cast<__m512bh>(_mm512_loadu_si512(at)); }

// sum[kTall][kWide vectors] += left [kTall rows with stride `left_row`] * the tiles at `right`: `deep` tiles in
// sequence, `right_step` numbers apart; kWide tiles side by side, `right_beside` numbers apart. Does with vector
// registers what AMX does in one instruction.
constexpr int kTall = 8;
template <int kWide>
void multiply_by_vectors(const Bf16* left, std::int64_t left_row, const Bf16* right, std::int64_t right_step,
                         std::int64_t right_beside, std::int64_t deep, float* sum, std::int64_t sum_row,
                         bool from_zero) {
    __m512 sums[kTall][kWide];
    for (int r = 0; r < kTall; ++r)
        for (int c = 0; c < kWide; ++c)
            sums[r][c] = from_zero ? _mm512_setzero_ps() : _mm512_load_ps(sum + r * sum_row + c * kTile);
    for (std::int64_t chunk = 0; chunk < deep; ++chunk, left += kDeep, right += right_step)
        for (int pair = 0; pair < kDeep / 2; ++pair) {
            __m512bh columns[kWide];
#pragma GCC unroll 2
            for (int c = 0; c < kWide; ++c) columns[c] = pairs_of(right + c * right_beside + pair * 2 * kTile);
#pragma GCC unroll 8
            for (int r = 0; r < kTall; ++r) {
                const __m512bh row = pair_of(left + r * left_row + 2 * pair);
#pragma GCC unroll 2
                for (int c = 0; c < kWide; ++c) sums[r][c] = _mm512_dpbf16_ps(sums[r][c], row, columns[c]);
            }
        }
    for (int r = 0; r < kTall; ++r)
        for (int c = 0; c < kWide; ++c) _mm512_store_ps(sum + r * sum_row + c * kTile, sums[r][c]);
}

// score() and add_values() without AMX.
void score_by_vectors(const Work& w, const Bf16* keys, std::int64_t count, const Sizes& s) {
    const std::int64_t chunks = s.deep / kDeep;
    for (std::int64_t j = 0; j < count; j += 2 * kTile)
        for (std::int64_t r = 0; r < kRows; r += kTall)
            multiply_by_vectors<2>(w.q + r * s.deep, s.deep, keys + j / kTile * chunks * kTileSize, kTileSize,
                                   chunks * kTileSize, chunks, w.scores + r * kKeys + j, kKeys, true);
}
void add_values_by_vectors(const Work& w, const Bf16* values, std::int64_t keys, const Sizes& s) {
    const std::int64_t columns = s.wide / kTile, step = columns * kTileSize;
    for (std::int64_t r = 0; r < kRows; r += kTall) {
        const Bf16* weights = w.weights + r * kKeys;
        float* sum = w.sum + r * s.wide;
        std::int64_t c = 0;
        for (; c + 2 <= columns; c += 2)
            multiply_by_vectors<2>(weights, kKeys, values + c * kTileSize, step, kTileSize, keys / kDeep,
                                   sum + c * kTile, s.wide, false);
        if (c < columns)
            multiply_by_vectors<1>(weights, kKeys, values + c * kTileSize, step, kTileSize, keys / kDeep,
                                   sum + c * kTile, s.wide, false);
    }
}

// 2^x for x <= 0, relative error 5e-5: below the rounding of the weights (4e-3).
__m512 power_of_two(__m512 x) {
    const __m512 whole = _mm512_roundscale_ps(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC),
                 rest = _mm512_sub_ps(x, whole);
    __m512 p = _mm512_set1_ps(9.6181291e-3f);
    p = _mm512_fmadd_ps(p, rest, _mm512_set1_ps(5.5504109e-2f));
    p = _mm512_fmadd_ps(p, rest, _mm512_set1_ps(2.4022651e-1f));
    p = _mm512_fmadd_ps(p, rest, _mm512_set1_ps(6.9314718e-1f));
    p = _mm512_fmadd_ps(p, rest, _mm512_set1_ps(1.f));
    return _mm512_scalef_ps(p, whole);
}

// Online softmax: turns a row of scores into weights relative to the running maximum, and rescales earlier sums when
// the maximum grows.
void weigh(Work& w, std::int64_t row, std::int64_t count, std::int64_t padded, float scale, const Sizes& s) {
    float* scores = w.scores + row * kKeys;
    for (std::int64_t j = count; j < padded; ++j) scores[j] = kLowest;
    __m512 most = _mm512_set1_ps(w.greatest[row]);
    for (std::int64_t j = 0; j < padded; j += kTile) most = _mm512_max_ps(most, _mm512_load_ps(scores + j));
    const float greatest = _mm512_reduce_max_ps(most);
    if (greatest > w.greatest[row]) {
        const __m512 shrink = power_of_two(_mm512_set1_ps((w.greatest[row] - greatest) * scale));
        float* sum = w.sum + row * s.wide;
        for (std::int64_t i = 0; i < s.wide; i += kTile)
            _mm512_store_ps(sum + i, _mm512_mul_ps(_mm512_load_ps(sum + i), shrink));
        w.total[row] *= _mm512_cvtss_f32(shrink);
        w.greatest[row] = greatest;
    }
    const __m512 factor = _mm512_set1_ps(scale), offset = _mm512_set1_ps(greatest * scale);
    __m512 total = _mm512_setzero_ps();
    for (std::int64_t j = 0; j < padded; j += 2 * kTile) {
        const __m512 a = power_of_two(_mm512_fmsub_ps(_mm512_load_ps(scores + j), factor, offset));
        const __m512 b = power_of_two(_mm512_fmsub_ps(_mm512_load_ps(scores + j + kTile), factor, offset));
        total = _mm512_add_ps(total, _mm512_add_ps(a, b));
        _mm512_store_si512(w.weights + row * kKeys + j, reinterpret_cast<__m512i>(_mm512_cvtne2ps_pbh(b, a)));
    }
    w.total[row] += _mm512_reduce_add_ps(total);
}

// sum [kRows, wide] += weights values
void add_values(const Work& w, const Bf16* values, std::int64_t keys, const Sizes& s) {
    const std::int64_t columns = s.wide / kTile, sum_row = s.wide * 4, weight_row = kKeys * 2;
    std::int64_t c = 0;
    for (; c + 2 <= columns; c += 2) {
        float *upper = w.sum + c * kTile, *lower = upper + kTile * s.wide;
        _tile_loadd(0, upper, sum_row);
        _tile_loadd(1, upper + kTile, sum_row);
        _tile_loadd(2, lower, sum_row);
        _tile_loadd(3, lower + kTile, sum_row);
        for (std::int64_t j = 0; j < keys; j += kDeep) {
            const Bf16* at = values + (j / kDeep * columns + c) * kTileSize;
            _tile_loadd(4, w.weights + j, weight_row);
            _tile_loadd(6, at, 64);
            _tile_dpbf16ps(0, 4, 6);
            _tile_loadd(7, at + kTileSize, 64);
            _tile_dpbf16ps(1, 4, 7);
            _tile_loadd(5, w.weights + kTile * kKeys + j, weight_row);
            _tile_dpbf16ps(2, 5, 6);
            _tile_dpbf16ps(3, 5, 7);
        }
        _tile_stored(0, upper, sum_row);
        _tile_stored(1, upper + kTile, sum_row);
        _tile_stored(2, lower, sum_row);
        _tile_stored(3, lower + kTile, sum_row);
    }
    if (c == columns) return;
    float *upper = w.sum + c * kTile, *lower = upper + kTile * s.wide;
    _tile_loadd(0, upper, sum_row);
    _tile_loadd(2, lower, sum_row);
    for (std::int64_t j = 0; j < keys; j += kDeep) {
        _tile_loadd(4, w.weights + j, weight_row);
        _tile_loadd(5, w.weights + kTile * kKeys + j, weight_row);
        _tile_loadd(6, values + (j / kDeep * columns + c) * kTileSize, 64);
        _tile_dpbf16ps(0, 4, 6);
        _tile_dpbf16ps(2, 5, 6);
    }
    _tile_stored(0, upper, sum_row);
    _tile_stored(2, lower, sum_row);
}

}  // namespace

bool available() {
    static const bool there = isa() >= Isa::avx512 && __builtin_cpu_supports("avx512bf16");
    return there;
}

std::int64_t packed_keys(std::int64_t m, std::int64_t d) { return Sizes(m, d).keys * Sizes(m, d).deep; }
std::int64_t packed_values(std::int64_t m, std::int64_t d) { return Sizes(m, d).keys * Sizes(m, d).wide; }

void pack(const Bf16* k, const Bf16* v, std::int64_t m, std::int64_t d, Bf16* keys, Bf16* values) {
    const Sizes s(m, d);
    __builtin_memset(keys, 0, static_cast<std::size_t>(s.keys * s.deep) * sizeof(Bf16));
    __builtin_memset(values, 0, static_cast<std::size_t>(s.keys * s.wide) * sizeof(Bf16));
    for (std::int64_t j = 0; j < m; ++j)
        for (std::int64_t i = 0; i < d; ++i) {
            // Keys: tiles of 16 keys by 32 numbers, the depth of AMX's product. Values: tiles of 32 keys by 16 numbers.
            keys[(j / kTile * (s.deep / kDeep) + i / kDeep) * kTileSize + i % kDeep / 2 * 32 + j % kTile * 2 + i % 2] =
                k[j * d + i];
            values[(j / kDeep * (s.wide / kTile) + i / kTile) * kTileSize + j % kDeep / 2 * 32 + i % kTile * 2 +
                   j % 2] = v[j * d + i];
        }
}

std::size_t workspace(std::int64_t d) {
    const Sizes s(0, d);
    return static_cast<std::size_t>(kRows * (2 * s.deep + 2 * kKeys + 4 * kKeys + 4 * s.wide));
}

void attend(const Bf16* q, std::int64_t count, const Bf16* keys, const Bf16* values, std::int64_t m, std::int64_t d,
            std::byte* work, Bf16* out) {
    const Sizes s(m, d);
    const float scale = 1.44269504088896341f / __builtin_sqrtf(static_cast<float>(d));
    const Tiles tiles;
    Work w(work, s);
    for (std::int64_t first = 0; first < count; first += kRows) {
        const std::int64_t rows = count - first < kRows ? count - first : kRows;
        __builtin_memset(w.q, 0, static_cast<std::size_t>(kRows * s.deep) * sizeof(Bf16));
        __builtin_memset(w.sum, 0, static_cast<std::size_t>(kRows * s.wide) * sizeof(float));
        for (std::int64_t r = 0; r < kRows; ++r) {
            w.greatest[r] = kLowest;
            w.total[r] = 0;
            if (r < rows)
                __builtin_memcpy(w.q + r * s.deep, q + (first + r) * d, static_cast<std::size_t>(d) * sizeof(Bf16));
        }
        for (std::int64_t from = 0; from < m; from += kKeys) {
            const std::int64_t some = m - from < kKeys ? m - from : kKeys, padded = rounded_up(some, kDeep);
            (has_matrix_unit() ? score : score_by_vectors)(w, keys + from * s.deep, padded, s);
            for (std::int64_t r = 0; r < kRows; ++r) weigh(w, r, some, padded, scale, s);
            (has_matrix_unit() ? add_values : add_values_by_vectors)(w, values + from * s.wide, padded, s);
        }
        for (std::int64_t r = 0; r < rows; ++r) {
            const __m512 share = _mm512_set1_ps(1 / w.total[r]);
            alignas(32) Bf16 rounded[kTile];
            for (std::int64_t i = 0; i < d; i += kTile) {
                const __m512 mean = _mm512_mul_ps(_mm512_load_ps(w.sum + r * s.wide + i), share);
                _mm256_store_si256(reinterpret_cast<__m256i*>(rounded),
                                   reinterpret_cast<__m256i>(_mm512_cvtneps_pbh(mean)));
                const std::int64_t left = d - i < kTile ? d - i : kTile;
                __builtin_memcpy(out + (first + r) * d + i, rounded, static_cast<std::size_t>(left) * sizeof(Bf16));
            }
        }
    }
}

}  // namespace fastscene::nn::bf16

#else

namespace fastscene::nn::bf16 {

bool available() { return false; }
std::int64_t packed_keys(std::int64_t, std::int64_t) { return 0; }
std::int64_t packed_values(std::int64_t, std::int64_t) { return 0; }
void pack(const Bf16*, const Bf16*, std::int64_t, std::int64_t, Bf16*, Bf16*) {}
std::size_t workspace(std::int64_t) { return 0; }
void attend(const Bf16*, std::int64_t, const Bf16*, const Bf16*, std::int64_t, std::int64_t, std::byte*, Bf16*) {}

}  // namespace fastscene::nn::bf16

#endif
