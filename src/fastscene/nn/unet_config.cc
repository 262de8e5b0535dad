#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/nn/config_fields.h"
#include "fastscene/nn/unet.h"

namespace fastscene::nn {
namespace {

void refuse_other_models(const ConfigFields& f) {
    if (const Json* v = f.find("addition_embed_type"))
        throw f.wrong("addition_embed_type", "absent (Stable Diffusion 1 or 2; Stable Diffusion XL is not read)", *v);
    for (const char* key : {"class_embed_type", "encoder_hid_dim", "time_cond_proj_dim"})
        if (const Json* v = f.find(key)) throw f.wrong(key, "absent (Stable Diffusion 1 or 2)", *v);
    if (const Json* v = f.find("transformer_layers_per_block"); v && *v != 1)
        throw f.wrong("transformer_layers_per_block", "1 (Stable Diffusion 1 or 2)", *v);
    if (const Json* act = f.find("act_fn"); act && *act != "silu" && *act != "swish")
        throw f.wrong("act_fn", "\"silu\"", *act);
    // Options that change the computation without changing any parameter's name or shape; only these values are
    // supported.
    const Json usual = {{"mid_block_type", {"UNetMidBlock2DCrossAttn"}},
                        {"resnet_time_scale_shift", {"default"}},
                        {"attention_type", {"default"}},
                        {"time_embedding_type", {"positional"}},
                        {"mid_block_scale_factor", {1}},
                        {"resnet_out_scale_factor", {1}},
                        {"conv_in_kernel", {3}},
                        {"conv_out_kernel", {3}},
                        {"class_embeddings_concat", {false}},
                        {"center_input_sample", {false}},
                        {"only_cross_attention", {false}},
                        {"dual_cross_attention", {false}},
                        {"resnet_skip_time_act", {false}},
                        {"mid_block_only_cross_attention", {false}},
                        {"global_pool_conditions", {false}}};
    for (const auto& [key, value] : usual.items())
        if (const Json* v = f.find(key.c_str());
            v && *v != value[0] &&
            !(v->is_array() && std::all_of(v->begin(), v->end(), [&](const Json& one) { return one == value[0]; })))
            throw f.wrong(key.c_str(), value[0].dump() + " (Stable Diffusion 1 or 2)", *v);
    for (const char* key : {"num_class_embeds", "time_embedding_act_fn", "timestep_post_act", "cross_attention_norm",
                            "time_embedding_dim"})
        if (const Json* v = f.find(key)) throw f.wrong(key, "absent (Stable Diffusion 1 or 2)", *v);
}

UNetConfig config_of(const Json& json, const std::string& where, bool has_up) {
    const ConfigFields f(json, where);
    refuse_other_models(f);
    UNetConfig c;
    c.in_channels = f.whole("in_channels", 4);
    c.out_channels = f.whole("out_channels", 4);
    c.channels = f.list("block_out_channels");
    c.down_attention = f.kinds("down_block_types", "CrossAttnDownBlock2D", "DownBlock2D");
    if (has_up) c.up_attention = f.kinds("up_block_types", "CrossAttnUpBlock2D", "UpBlock2D");
    if (c.down_attention.size() != c.channels.size() || (has_up && c.up_attention.size() != c.channels.size()))
        throw Error("{}: expected as many blocks as \"block_out_channels\" has entries ({}), found {} down and {} up",
                    where, c.channels.size(), c.down_attention.size(), c.up_attention.size());
    const char* heads = f.find("num_attention_heads") ? "num_attention_heads" : "attention_head_dim";
    c.heads = f.find(heads) && f.find(heads)->is_array() ? f.list(heads)
                                                         : std::vector(c.channels.size(), f.whole(heads, 8));
    if (c.heads.size() != c.channels.size())
        throw Error("{}: expected {} entries in \"{}\", found {}", where, c.channels.size(), heads, c.heads.size());
    for (std::size_t i = 0; i < c.heads.size(); ++i)
        if (c.heads[i] < 1 || c.channels[i] % c.heads[i])
            throw Error("{}: expected channels that divide among the heads, found {} among {}", where, c.channels[i],
                        c.heads[i]);
    c.layers = f.whole("layers_per_block", 2);
    c.groups = f.find("norm_num_groups") ? f.whole("norm_num_groups", 32) : 32;
    if (c.groups < 1 ||
        std::any_of(c.channels.begin(), c.channels.end(), [&](std::int64_t n) { return n % c.groups != 0; }))
        throw Error("{}: expected \"block_out_channels\" to be multiples of \"norm_num_groups\" = {}", where, c.groups);
    if (c.channels[0] % 2)
        throw Error(
            "{}: expected \"block_out_channels\" to begin with an even number (time's sines and cosines), found {}",
            where, c.channels[0]);
    c.eps = f.number("norm_eps", 1e-5);
    c.text_width = f.whole("cross_attention_dim", 1280);
    c.down_pad = f.whole("downsample_padding", 1);
    c.frequency_shift = f.number("freq_shift", 0);
    c.cos_first = f.flag("flip_sin_to_cos", true);
    c.linear_projection = f.flag("use_linear_projection", false);
    c.attention_in_float = f.flag("upcast_attention", false);
    c.picture_channels = f.whole("conditioning_channels", 3);
    const std::string order = f.text("controlnet_conditioning_channel_order", "rgb");
    if (order != "rgb" && order != "bgr")
        throw f.wrong("controlnet_conditioning_channel_order", "\"rgb\" or \"bgr\"", order);
    c.picture_reversed = order == "bgr";
    if (f.find("conditioning_embedding_out_channels")) c.picture_widths = f.list("conditioning_embedding_out_channels");
    return c;
}

}  // namespace

UNetConfig unet_config(const Json& json, const std::string& where) { return config_of(json, where, true); }
UNetConfig controlnet_config(const Json& json, const std::string& where) { return config_of(json, where, false); }

}  // namespace fastscene::nn
