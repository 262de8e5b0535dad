// Picture ledge.
#include <set>
#include <string>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A narrow board with frames that lean on it.
void build_picture_ledge(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 0.f, 0.11f});
    const int wood = k.main(k.style.wood);
    k.board(wood, {0, 0, 0.5f * s.z}, {s.x, 0.02f, s.z}, 0.003f);
    k.board(wood, {0, 0.02f, s.z - 0.008f}, {s.x, 0.025f, 0.014f}, 0.003f);
    float x = -0.5f * s.x + 0.06f;
    std::set<std::string> hung;
    while (true) {
        PieceRequest r;
        r.kind = "picture";
        r.style = &k.style;
        r.seed = k.rng.next_u64();
        const float w = k.rng.uniform(0.22f, 0.42f);
        if (x + w > 0.5f * s.x - 0.04f) break;
        r.size_m = {w, w * k.rng.uniform(0.9f, 1.4f), 0};
        // No two alike on one ledge.
        Piece picture = make_piece(r);
        for (int tries = 0; tries < 8 && hung.contains(picture.form); ++tries) {
            r.seed = k.rng.next_u64();
            picture = make_piece(r);
        }
        hung.insert(picture.form);
        k.merge(picture, {x + 0.5f * w, 0.02f, 0.012f + k.rng.uniform(0.f, 0.012f)});
        x += w + k.rng.uniform(0.02f, 0.08f);
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.2f;
}

}  // namespace fastscene::furniture
