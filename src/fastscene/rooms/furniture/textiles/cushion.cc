// Cushion.
#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_cushion(Kit& k) {
    const int cloth = k.main(tinted(k.style.fabric2, k.accent()));
    put_pillow(k, cloth, {0, 0, 0}, {0.45f, 0.45f, 0.17f}, 12);
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
