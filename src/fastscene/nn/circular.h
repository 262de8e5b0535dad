// Seam closing of Diffusion360 (Feng et al. 2023): the picture is extended beyond its right end by its left end, and
// the two are blended. Private to nn/ (torch).
#pragma once

#include <functional>

#include "fastscene/nn/vae.h"

namespace fastscene::nn {

// Blends the first `count` columns (rows) of b with the last ones of a: b[x] = a[W - count + x] (1 - x / count) + b[x]
// x / count. Modifies and returns b; a may be b.
at::Tensor blend_columns(const at::Tensor& a, at::Tensor b, std::int64_t count);
at::Tensor blend_rows(const at::Tensor& a, at::Tensor b, std::int64_t count);

// x with its first `count` columns appended on the right (circular padding).
at::Tensor extended(const at::Tensor& x, std::int64_t count);

// Decodes in overlapping bands of rows (a quarter of their height) that are blended, which bounds memory, and with
// circular padding, which avoids a seam. `tile` in latent rows (config.sample_size / 8). If neither side is larger than
// that, decodes in one piece as published, which leaves a seam, unless `always_closed`.
at::Tensor circular_decode(const Scope& s, const VaeConfig& config, const at::Tensor& z, std::int64_t tile,
                           bool always_closed = false);

}  // namespace fastscene::nn
