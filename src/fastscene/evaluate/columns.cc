#include "fastscene/evaluate/columns.h"

#include <algorithm>

#include "fastscene/base/check.h"

namespace fastscene {

const std::vector<Column>& columns() {
    constexpr auto up = Better::higher, down = Better::lower, none = Better::neither;
    static const std::vector<Column> list{
        {"clip_l14", "CLIP", "", up, 1, "stills", "clip_l14",
         "100 cos between picture and prompt, ViT-L/14 (the paper's scale; its network is not named)"},
        {"clip_b32", "CLIP B/32", "", up, 1, "stills", "clip_b32", "100 cos between picture and prompt, ViT-B/32"},
        {"clip_s", "CLIPScore", "", up, 3, "stills", "clip_s",
         "2.5 max(cos, 0) between picture and \"A photo depicts \" + prompt, ViT-B/32 (Hessel et al. 2021)"},
        {"niqe", "NIQE", "", down, 2, "stills", "niqe",
         "distance of the picture's statistics from undistorted photographs', authors' parameters (Mittal et al. "
         "2013)"},
        {"brisque", "BRISQUE", "", down, 1, "stills", "brisque",
         "authors' features and regression (Mittal et al. 2012), 0 best"},
        {"brisque_opencv", "BRISQUE (OpenCV)", "", down, 1, "stills", "brisque_opencv",
         "OpenCV's features and its own regression, 0 best"},
        {"source_psnr", "PSNR, source view", "dB", up, 2, "source", "psnr",
         "a panorama rendered from the splats at panorama 0's position, against panorama 0"},
        {"source_ssim", "SSIM, source view", "", up, 3, "source", "ssim_3dgs",
         "the same, SSIM per channel, 11 x 11 Gaussian window, zero padding (as in 3DGS)"},
        {"source_ssim_wang", "SSIM (Wang), source view", "", up, 3, "source", "ssim_wang",
         "the same, SSIM on gray, windows inside the picture only (Wang et al. 2004)"},
        {"source_lpips_alex", "LPIPS (alex), source view", "", down, 3, "source", "lpips_alex",
         "the same, LPIPS v0.1 on AlexNet"},
        {"source_lpips_vgg", "LPIPS (vgg), source view", "", down, 3, "source", "lpips_vgg",
         "the same, LPIPS v0.1 on VGG-16"},
        {"psnr", "PSNR, held out", "dB", up, 2, "held-out", "",
         "the splats at poses never trained on, against the traced room there"},
        {"ssim", "SSIM, held out", "", up, 3, "held-out", "", "the same, SSIM as 3DGS measures it"},
        {"lpips_alex", "LPIPS (alex), held out", "", down, 3, "held-out", "lpips_alex",
         "the same, LPIPS v0.1 on AlexNet"},
        {"lpips_vgg", "LPIPS (vgg), held out", "", down, 3, "held-out", "lpips_vgg", "the same, LPIPS v0.1 on VGG-16"},
        {"psnr_seen", "PSNR, seen", "dB", up, 2, "held-out", "", "of the pixels whose surface panorama 0 saw"},
        {"psnr_unseen", "PSNR, unseen", "dB", up, 2, "held-out", "",
         "of the pixels whose surface panorama 0 did not see"},
        {"psnr_worst", "PSNR, worst view", "dB", up, 2, "held-out", "", "of the worst pose"},
        {"psnr_worst5", "PSNR, worst 5 %", "dB", up, 2, "held-out", "", "mean of the worst twentieth of the poses"},
        {"low_alpha", "Open pixels", "%", down, 3, "held-out", "",
         "share of pixels that the splats leave more than 2 % transparent"},
        {"psnr_a", "A: true panoramas", "dB", none, 2, "held-out", "",
         "the same trainer on true panoramas at the walked poses: an upper bound for walks"},
        {"psnr_b", "B: panorama 0 alone", "dB", none, 2, "held-out", "",
         "the same trainer on panorama 0 alone: a lower bound"},
        {"gap_a", "gap to A", "dB", down, 2, "held-out", "", "A - ours, at the same poses"},
        {"closed", "closed", "%", up, 0, "held-out", "", "(ours - B) / (A - B)"},
        {"walked", "walk's panoramas", "dB", none, 2, "held-out", "",
         "the walk's pictures against true panoramas at the same poses"},
        {"splat_loss", "splat stage loses", "dB", down, 2, "held-out", "",
         "PSNR lost by the splats, rendered as panoramas at the walked poses, relative to the walk's pictures"},
        {"floor", "floor", "dB", none, 2, "held-out", "",
         "two renderings of a true view with different camera rays: noise of the ground truth"},
        {"holes_paper", "holes, paper's scenes", "%", none, 1, "holes", "",
         "holes in % of the picture, from the paper's Table 1 for its own scenes", true},
        {"holes_published", "holes, as published", "%", down, 1, "holes", "",
         "holes in % of the picture that the published warp leaves in this suite's scenes"},
        {"holes", "holes, ours", "%", down, 1, "holes", "", "holes in % of the picture that our warp leaves"},
        {"holes_true", "truly disoccluded", "%", none, 1, "holes", "",
         "share of the picture whose surface is hidden from the first viewpoint"},
        {"minutes", "minutes", "min", down, 1, "cost", "", "wall time of all stages of a scene on this machine"},
        {"cpu_minutes", "CPU minutes", "min", down, 1, "cost", "", "user + system time of all stages of a scene"},
        {"memory_gb", "memory", "GB", down, 2, "cost", "", "peak memory of any stage"},
    };
    return list;
}

const Column& column_of(std::string_view key) {
    const auto found = std::find_if(columns().begin(), columns().end(), [&](const Column& c) { return c.key == key; });
    FASTSCENE_CHECK(found != columns().end());
    return *found;
}

std::vector<std::string> column_keys() {
    std::vector<std::string> keys;
    for (const Column& column : columns()) keys.push_back(column.key);
    return keys;
}

}  // namespace fastscene
