#include "fastscene/nn/panorama_loops.h"

#include <algorithm>

#include "fastscene/base/check.h"
#include "fastscene/nn/circular.h"

namespace fastscene::nn {

using at::Tensor;

namespace {

// The conditional output alone, or classifier-free guidance.
Tensor guided(const Tensor& both, double guidance) {
    if (both.size(0) == 1) return both;
    const std::vector<Tensor> halves = both.chunk(2, 0);
    return halves[0] + guidance * (halves[1] - halves[0]);
}

Tensor replayed(Replay* replay, const std::vector<Tensor>& inputs, const Replay::Net& net) {
    return replay ? (*replay)(inputs, net) : net(inputs);
}

// One tile of the refinement: its position and its latents after the step.
using TileRow = std::vector<Tensor>;

// Joins overlapping tiles: each is blended with its upper and left neighbor, and the last of a row with the first,
// closing the circle.
Tensor joined(std::vector<TileRow>& rows, std::int64_t half) {
    std::vector<Tensor> bands;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        TileRow& row = rows[i];
        std::vector<Tensor> parts;
        for (std::size_t j = 0; j < row.size(); ++j) {
            if (i > 0) blend_rows(rows[i - 1][j], row[j], half);
            blend_columns(j > 0 ? row[j - 1] : row.back(), row[j], half);
            const std::int64_t height = i + 1 < rows.size() ? half : row[j].size(2),
                               width = j + 1 < row.size() ? half : row[j].size(3);
            parts.push_back(
                row[j].narrow(2, 0, std::min(height, row[j].size(2))).narrow(3, 0, std::min(width, row[j].size(3))));
        }
        bands.push_back(at::cat(parts, 3));
    }
    return at::cat(bands, 2);
}

}  // namespace

PromptEmbedding embed_prompt(const Scope& s, const ClipTower& tower, const WeightedTokens& tokens) {
    const std::int64_t chunk = ClipTokenizer::kContext;
    const Tensor all = at::tensor(std::vector<std::int64_t>(tokens.tokens.begin(), tokens.tokens.end()), at::kLong)
                           .unsqueeze(0);
    std::vector<Tensor> parts;
    for (std::int64_t i = 0; i < tokens.chunks; ++i) {
        Tensor ids = all.narrow(1, i * kChunkTokens, chunk).clone();
        ids.select(1, 0).fill_(ClipTokenizer::kBegin);
        ids.select(1, chunk - 1).fill_(ClipTokenizer::kEnd);
        parts.push_back(clip_text(s, tower, ids).states);
    }
    PromptEmbedding out;
    out.plain = at::cat(parts, 1);
    const Tensor weights = at::tensor(std::vector<double>(tokens.weights.begin(), tokens.weights.end()),
                                      out.plain.options())
                               .reshape({1, -1, 1});
    const Tensor weighted = out.plain * weights;
    const double before = out.plain.to(at::kFloat).mean().item<double>(),
                 after = weighted.to(at::kFloat).mean().item<double>();
    out.rescale = after != 0 ? before / after : 1;
    out.states = weighted * out.rescale;
    return out;
}

Tensor text_to_panorama(const Scope& s, const UNetConfig& config, Scheduler& scheduler, Tensor latents,
                        const Tensor& prompts, const TextToPanorama& how) {
    const std::int64_t width = latents.size(3);
    const Tensor text = how.guidance == 1 ? prompts.narrow(0, 1, 1) : prompts;
    const auto repeated = [&](const Tensor& x) { return text.size(0) == 1 ? x : at::cat({x, x}, 0); };
    const at::Device there = text.device();
    latents = latents.to(there);
    if (!how.noised) latents = latents * scheduler.init_noise_sigma();
    Tensor held;
    if (how.control) held = how.control->picture.to(text.options());
    if (how.seam == Seam::closed) {
        if (held.defined()) held = extended(held, how.blend_columns * (held.size(3) / width));
        latents = extended(latents, how.blend_columns);
    }
    if (held.defined()) held = repeated(held);
    for (int i = 0; i < scheduler.steps(); ++i) {
        const bool heard = i == 0 && how.first_outputs;
        // Latents, timestep and text; for a ControlNet its timestep and picture.
        const auto networks = [&](const std::vector<Tensor>& in) {
            std::optional<Residuals> hold;
            if (in.size() > 3)
                hold = controlnet(how.control->scope, how.control->config, in[0], in[3], in[2], in[4],
                                  how.control->strength);
            if (heard && hold) how.first_outputs("control", hold->middle);
            return unet(s, config, in[0], in[1], in[2], hold ? &*hold : nullptr);
        };
        const Tensor input = repeated(scheduler.scaled_input(latents, i).to(text.options()));
        const double t = scheduler.timestep(i);
        std::vector<Tensor> inputs{input, waves_of_time(t, config, input), text};
        if (held.defined()) {
            inputs.push_back(waves_of_time(t, how.control->config, input));
            inputs.push_back(held);
        }
        const Tensor output = guided(replayed(how.replay, inputs, networks).to(at::kFloat), how.guidance);
        if (heard) how.first_outputs("unet", output);
        if (how.preview) how.preview(i, t, scheduler.clean(output, i, latents).narrow(3, 0, width));
        Tensor noise;
        if (scheduler.wants_noise()) noise = how.noise(i, latents).to(there, at::kFloat, /*non_blocking=*/true);
        latents = scheduler.step(output, i, latents, noise).contiguous();
        if (how.listener) how.listener(i, scheduler.timestep(i), latents);
        latents = blend_columns(latents, latents.clone(), how.blend_columns);
    }
    return blend_columns(latents, latents.clone(), how.blend_columns).narrow(3, 0, width);
}

Tensor refine_panorama(const Scope& unet_scope, const UNetConfig& unet_config, const Scope& control_scope,
                       const UNetConfig& control_config, const Scheduler& scheduler, Tensor latents,
                       const Tensor& picture, const Tensor& text, const RefinePanorama& how) {
    const std::int64_t width = latents.size(3), half = how.tile / 2, factor = picture.size(2) / latents.size(2);
    FASTSCENE_CHECK(how.tile >= 2 && how.tile % 2 == 0 && latents.size(2) > half);
    const at::Device there = text.device();
    latents = extended(latents.to(there), half);
    const Tensor held = extended(picture.to(there), half * factor);
    for (int step = how.first_step; step < scheduler.steps(); ++step) {
        std::vector<TileRow> rows;
        for (std::int64_t y = 0; y < latents.size(2) - half; y += half) {
            TileRow tiles, controls;
            for (std::int64_t x = 0; x < latents.size(3) - half; x += half) {
                const std::int64_t h = std::min(how.tile, latents.size(2) - y),
                                   w = std::min(how.tile, latents.size(3) - x);
                tiles.push_back(latents.narrow(2, y, h).narrow(3, x, w));
                controls.push_back(held.narrow(2, y * factor, h * factor).narrow(3, x * factor, w * factor));
            }
            TileRow done;
            const auto at_once = how.batch > 0 ? static_cast<std::size_t>(how.batch) : tiles.size();
            for (std::size_t from = 0; from < tiles.size(); from += at_once) {
                const auto count = std::min(at_once, tiles.size() - from);
                const auto some = [&](const TileRow& all) {
                    return at::cat(std::vector<Tensor>(all.begin() + static_cast<std::ptrdiff_t>(from),
                                                       all.begin() + static_cast<std::ptrdiff_t>(from + count)),
                                   0);
                };
                const auto n = static_cast<std::int64_t>(count);
                const Tensor x = some(tiles), c = some(controls).to(text.options());
                const Tensor prompts = at::cat(
                    {text.narrow(0, 0, 1).expand({n, -1, -1}), text.narrow(0, 1, 1).expand({n, -1, -1})}, 0);
                const Tensor input = scheduler.scaled_input(x, step).to(text.options()),
                             twice = at::cat({input, input}, 0);
                const double t = scheduler.timestep(step);
                const bool is_first = step == how.first_step && rows.empty() && from == 0 && how.first_outputs;
                const auto networks = [&](const std::vector<Tensor>& in) {
                    const Residuals hold = controlnet(control_scope, control_config, in[0], in[3], in[2], in[4],
                                                      how.control);
                    if (is_first) how.first_outputs("control", hold.middle);
                    return unet(unet_scope, unet_config, in[0], in[1], in[2], &hold);
                };
                const Tensor both = replayed(how.replay,
                                             {twice, waves_of_time(t, unet_config, twice), prompts,
                                              waves_of_time(t, control_config, twice), at::cat({c, c}, 0)},
                                             networks);
                const Tensor output = guided(both.to(at::kFloat), how.guidance);
                if (is_first) how.first_outputs("unet", output);
                // A fresh sampler per tile and step: as published, every step is first order.
                for (const Tensor& tile : scheduler.clone()->step(output, step, x, {}).split(1, 0))
                    done.push_back(tile.clone());
            }
            rows.push_back(std::move(done));
        }
        latents = joined(rows, half);
        if (how.listener) how.listener(step, scheduler.timestep(step), latents);
    }
    return latents.narrow(3, 0, width);
}

}  // namespace fastscene::nn
