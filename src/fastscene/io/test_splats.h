// Random splats for the tests of file formats.
#pragma once

#include "fastscene/base/random.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

// All fields are set. Deterministic in count and degree.
inline Splats some_splats(std::size_t count, int degree) {
    Random random(2, "splats");
    Splats s;
    s.sh_degree = degree;
    s.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        s.mean_m[i] = {random.uniform(-3, 3), random.uniform(-1, 2), random.uniform(-3, 3)};
        s.log_scale[i] = {random.uniform(-6, -2), random.uniform(-6, -2), random.uniform(-6, -2)};
        s.rotation[i] = {random.normal(), random.normal(), random.normal(), random.normal()};
        s.opacity_logit[i] = random.uniform(-3, 3);
        s.sh0[i] = {random.uniform(-1.5f, 1.5f), random.uniform(-1.5f, 1.5f), random.uniform(-1.5f, 1.5f)};
    }
    for (float& f : s.sh_rest) f = random.uniform(-0.5f, 0.5f);
    return s;
}

}  // namespace fastscene
