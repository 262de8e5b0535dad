// Gathers the inner loops of one instruction set into a Kernel. Included by isa_*.cc.
#pragma once

#include "fastscene/splat/isa_backward.h"
#include "fastscene/splat/isa_loss.h"
#include "fastscene/splat/isa_update.h"

#define FASTSCENE_STRING_(x) #x
#define FASTSCENE_STRING(x) FASTSCENE_STRING_(x)

namespace fastscene::splat::FASTSCENE_ISA {

const Kernel& kernel() {
    static constexpr Kernel it{FASTSCENE_STRING(FASTSCENE_ISA),
                               project_piece,
                               forward_any,
                               backward_any,
                               loss_scratch,
                               loss_band,
                               update_piece};
    return it;
}

}  // namespace fastscene::splat::FASTSCENE_ISA
