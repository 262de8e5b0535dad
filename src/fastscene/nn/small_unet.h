// For tests: a U-Net of two levels, one of which attends to the text. Private to nn/ (torch).
#pragma once

#include "fastscene/nn/unet.h"

namespace fastscene::nn {

inline UNetConfig small_unet(std::int64_t text_width) {
    UNetConfig config;
    config.channels = {16, 32};
    config.down_attention = {true, false};
    config.up_attention = {false, true};
    config.heads = {4, 4};
    config.layers = 1;
    config.groups = 8;
    config.text_width = text_width;
    return config;
}

}  // namespace fastscene::nn
