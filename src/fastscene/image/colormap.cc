#include "fastscene/image/colormap.h"

#include <algorithm>
#include <cmath>

#include "fastscene/image/color.h"

namespace fastscene {

Rgb8 turbo(float t) {
    t = std::clamp(t, 0.f, 1.f);
    const auto polynomial = [t](float a, float b, float c, float d, float e, float f) {
        return a + t * (b + t * (c + t * (d + t * (e + t * f))));
    };
    return {byte_from_unit(
                polynomial(0.13572138f, 4.61539260f, -42.66032258f, 132.13108234f, -152.94239396f, 59.28637943f)),
            byte_from_unit(polynomial(0.09140261f, 2.19418839f, 4.84296658f, -14.18503333f, 4.27729857f, 2.82956604f)),
            byte_from_unit(
                polynomial(0.10667330f, 12.64194608f, -60.58204836f, 110.36276771f, -89.90310912f, 27.34824973f))};
}

ImageRgb8 colored(const ImageF& values, float low, float high) {
    FASTSCENE_CHECK(low < high);
    ImageRgb8 out(values.width, values.height);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float v = values.pixels[i];
        if (std::isfinite(v) && v != 0.f) out.pixels[i] = turbo((v - low) / (high - low));
    }
    return out;
}

}  // namespace fastscene
