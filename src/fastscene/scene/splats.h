// Splats: 3D Gaussians (Kerbl et al. 2023), in the training parametrization.
#pragma once

#include <cstddef>
#include <vector>

#include "fastscene/math/rigid.h"
#include "fastscene/math/vec.h"

namespace fastscene {

// Degree-0 basis function of real spherical harmonics: color = 0.5 + kSh0 * sh0.
inline constexpr float kSh0 = 0.28209479177387814f;

// Bounds of the low-pass. With less, the renderer's exponents within a block of pixels would leave the range of single
// precision.
inline constexpr double kLeastLowPassPx2 = 0.1, kMostLowPassPx2 = 1;

// How footprints are filtered when splats are drawn: as when they were trained.
struct FootprintFilter {
    // Low-pass: variance, in square pixels, that is added to every footprint. 0.3 as in Kerbl et al.'s program and in
    // viewers; a pixel that averages its area has 1/12, to which Mip-Splatting's 0.1 comes close.
    float low_pass_px2 = 0.3f;
    // Antialiasing: splats smaller than a pixel are dimmed (Mip-Splatting's 2D filter, Yu et al. 2024).
    bool antialias = false;
    friend bool operator==(const FootprintFilter&, const FootprintFilter&) = default;
};

struct Splats {
    std::vector<Vec3f> mean_m;         // world
    std::vector<Vec3f> log_scale;      // natural log of the standard deviations in metres, along the local axes
    std::vector<Quatf> rotation;       // world_from_local, w first, not necessarily normalized
    std::vector<float> opacity_logit;  // opacity = 1 / (1 + exp(-x))
    std::vector<Vec3f> sh0;            // degree-0 coefficients per channel, for sRGB-encoded color
    int sh_degree = 0;                 // 0..3
    std::vector<float>
        sh_rest;  // per splat 3 * K floats, channel-major (K reds, K greens, K blues), K = (degree+1)^2 - 1
    FootprintFilter filter;

    std::size_t size() const { return mean_m.size(); }
    int rest_coefficients() const { return (sh_degree + 1) * (sh_degree + 1) - 1; }
    void resize(std::size_t count) {
        mean_m.resize(count);
        log_scale.resize(count);
        rotation.resize(count);
        opacity_logit.resize(count);
        sh0.resize(count);
        sh_rest.resize(count * 3 * static_cast<std::size_t>(rest_coefficients()));
    }
    friend bool operator==(const Splats&, const Splats&) = default;
};

}  // namespace fastscene
