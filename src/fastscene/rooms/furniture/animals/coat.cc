// Fur.
#include "fastscene/rooms/furniture/animals/coat.h"

namespace fastscene::furniture {

Material coat_of(Vec3f color) {
    Material m = plain("fur", color, 0.95f);
    m.pattern = Pattern::carpet;
    m.color_b = color * 0.62f;
    return m;
}

}  // namespace fastscene::furniture
