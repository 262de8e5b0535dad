// Diffusion360's way to close a panorama's seam (Feng et al. 2023): the right end is continued by the left one, made
// together, and blended. Private to nn/ (torch).
#pragma once

#include <functional>

#include "fastscene/nn/vae.h"

namespace fastscene::nn {

// b with its first `count` columns (rows) a mix of a's last and b's first: b[x] = a[W - count + x] (1 - x / count) +
// b[x] x / count. Changes b and returns it; a may be b.
at::Tensor blend_columns(const at::Tensor& a, at::Tensor b, std::int64_t count);
at::Tensor blend_rows(const at::Tensor& a, at::Tensor b, std::int64_t count);

// x continued by its own first `count` columns, which belong there when columns close to a circle.
at::Tensor extended(const at::Tensor& x, std::int64_t count);

// Decodes in bands of rows that overlap by a quarter and are blended, so that memory is bounded, and, made a quarter
// wider by wrapped columns, without a seam. `tile` in latent rows (config.sample_size / 8). When neither side is
// larger, decodes at once as published, which leaves a seam; not with `always_closed`.
at::Tensor circular_decode(const Scope& s, const VaeConfig& config, const at::Tensor& z, std::int64_t tile,
                           bool always_closed = false);

}  // namespace fastscene::nn
