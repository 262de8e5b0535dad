// Piano.
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_piano(Kit& k) {
    const int body = k.main(plain("piano lacquer", {0.032f, 0.032f, 0.033f}, 0.1f)),
              ivory = k.material(plain("ivory keys", {0.75f, 0.73f, 0.66f}, 0.3f)),
              black = k.material(plain("black keys", {0.032f, 0.032f, 0.033f}, 0.3f)),
              gold = k.material(*material_named("brass"));
    k.board(body, {0, 0.0f, -0.12f}, {1.48f, 1.22f, 0.32f}, 0.008f);
    k.board(body, {0, 1.22f, -0.1f}, {1.52f, 0.03f, 0.38f}, 0.008f);
    k.board(body, {0, 0.6f, 0.16f}, {1.48f, 0.07f, 0.3f}, 0.008f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(body, {sx * 0.72f, 0.0f, 0.27f}, {0.06f, 0.62f, 0.06f}, 0.01f);
        k.board(body, {sx * 0.71f, 0.66f, 0.16f}, {0.07f, 0.1f, 0.3f}, 0.012f);
    }
    for (int i = 0; i < 52; ++i) {
        const float x = -0.6248f + 0.0245f * static_cast<float>(i);
        k.board(ivory, {x, 0.67f, 0.21f}, {0.0232f, 0.018f, 0.16f}, 0.002f);
        const int note = i % 7;
        if (i < 51 && note != 2 && note != 6)
            k.board(black, {x + 0.0122f, 0.685f, 0.18f}, {0.012f, 0.014f, 0.1f}, 0.002f);
    }
    Mesh desk_board = shapes::box({0.9f, 0.26f, 0.015f}, 0.004f);
    shapes::turn(desk_board, {1, 0, 0}, -12);
    k.add(std::move(desk_board), body, {0, 0.98f, 0.085f});
    Mesh sheet_music = shapes::box({0.4f, 0.28f, 0.002f}, 0.0005f);
    shapes::turn(sheet_music, {1, 0, 0}, -12);
    k.add(std::move(sheet_music), ivory, {0, 0.985f, 0.098f});
    for (int i = -1; i <= 1; ++i)
        k.board(gold, {0.08f * static_cast<float>(i), 0.05f, 0.07f}, {0.03f, 0.015f, 0.1f}, 0.005f);
    k.top(1.25f, 0, -0.1f, 0.7f, 0.15f);
    k.piece.clearance_front_m = 0.9f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
