// Toy blocks.
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_toy_blocks(Kit& k) {
    for (int i = 0; i < 6; ++i) {
        const int mat = i == 0 ? k.main(plain("toy block", k.accent(), 0.5f))
                               : k.material(plain("toy block", k.accent(), 0.5f));
        const int row = i < 3 ? 0 : i < 5 ? 1 : 2;
        Mesh m = shapes::box({0.07f, 0.07f, 0.07f}, 0.006f);
        shapes::turn(m, {0, 1, 0}, k.rng.uniform(-20, 20));
        k.add(std::move(m), mat,
              {0.085f * (static_cast<float>(row == 0   ? i
                                            : row == 1 ? i - 3
                                                       : 0) +
                         0.5f * static_cast<float>(row)),
               0.035f + 0.07f * static_cast<float>(row), 0});
    }
    on_surface(k);
}

}  // namespace fastscene::furniture
