#include "fastscene/splat/train.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>
#include <span>

#include "fastscene/base/file.h"
#include "fastscene/base/forced_exit.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/memory.h"
#include "fastscene/base/random.h"
#include "fastscene/gpu/device.h"
#include "fastscene/image/color.h"
#include "fastscene/splat/classic.h"
#include "fastscene/splat/coarse.h"
#include "fastscene/splat/depth_target.h"
#include "fastscene/splat/relocate.h"
#include "fastscene/splat/backend.h"
#include "fastscene/splat/train_state.h"

namespace fastscene::splat {
namespace {

// The view of each step (from 1): all views in random order, reshuffled each epoch.
class ViewOrder {
  public:
    ViewOrder(std::size_t count, std::uint64_t seed) : order_(count), seed_(seed) {}
    std::size_t at(int step) {
        const auto n = order_.size(), k = static_cast<std::size_t>(step - 1);
        if (k / n != round_) {
            round_ = k / n;
            std::iota(order_.begin(), order_.end(), std::size_t{0});
            Random random(seed_, "splat.views", round_);
            for (std::size_t i = n - 1; i > 0; --i)
                std::swap(order_[i], order_[static_cast<std::size_t>(random.index(static_cast<int>(i) + 1))]);
        }
        return order_[k % n];
    }

  private:
    std::vector<std::size_t> order_;
    std::uint64_t seed_, round_ = ~std::uint64_t{0};
};

std::array<float, kParameters> rates_at(float done, const SplatParams& params, const TrainTuning& t) {
    const float other = std::pow(t.other_end, done);
    const float mean = params.learning_rate_mean_m * std::pow(t.mean_end, done);
    const float scale = t.scale * other, rotation = t.rotation * other, logit = params.learning_rate_logit * other,
                sh0 = t.sh0 * other;
    return {mean, mean, mean, scale, scale, scale, rotation, rotation, rotation, rotation, logit, sh0, sh0, sh0};
}

void check_views(const ViewSet& set) {
    if (set.views.empty()) throw Error("splat: no views to train on");
    for (const View& v : set.views) {
        if (v.color.empty() || v.color.width != v.camera.width || v.color.height != v.camera.height)
            throw Error("splat: view {}: camera is {}x{}, picture is {}x{}", v.name, v.camera.width, v.camera.height,
                        v.color.width, v.color.height);
        if (!v.weight.empty() && !v.weight.same_size(v.color))
            throw Error("splat: view {}: weights are {}x{}, picture is {}x{}", v.name, v.weight.width, v.weight.height,
                        v.color.width, v.color.height);
    }
}

// Training views and held-out views.
struct Split {
    std::vector<const View*> train, held_out;
};
Split split_views(const ViewSet& set, const SplatParams& params) {
    Split out;
    for (std::size_t i = 0; i < set.views.size(); ++i) {
        // The first view is always trained on: with a single view there is nothing to hold out.
        const bool held = params.eval_every > 0 &&
                          i % static_cast<std::size_t>(params.holdout) == static_cast<std::size_t>(params.holdout) - 1;
        (held ? out.held_out : out.train).push_back(&set.views[i]);
    }
    if (params.eval_every > 0 && out.held_out.empty())
        throw Error("splat: expected at least {} views to hold one out (holdout {}), found {}", params.holdout,
                    params.holdout, set.views.size());
    return out;
}

// Everything that determines a run's numbers, except its length and evaluation settings.
std::string key_of(const ViewSet& set, SplatParams params, std::uint64_t seed, const Splats* begin) {
    Hash hash;
    params.until = 0, params.checkpoint.clear(), params.checkpoint_every = 500, params.patience = 0;
    if (params.eval_every > 0) params.eval_every = 1;
    params.sh_degree = std::max(0, params.sh_degree);
    hash.add(fields_json(params).dump()).add(seed).add(set.points.size());
    for (const View& v : set.views) {
        hash.add(v.name)
            .add(static_cast<int>(v.model))
            .add_bytes(v.color.pixels.data(), v.color.pixels.size() * sizeof(Rgb8))
            .add_bytes(v.weight.pixels.data(), v.weight.pixels.size());
        hash.add_bytes(&v.camera, sizeof v.camera).add_bytes(&v.world_from_camera, sizeof v.world_from_camera);
    }
    for (const SurfacePoint& p : set.points) hash.add_bytes(&p.position_m, sizeof p.position_m);
    if (begin) {
        hash.add(params.begun);
        for (const auto* parameters : {&begin->mean_m, &begin->log_scale, &begin->sh0})
            hash.add(std::span<const Vec3f>(*parameters));
        hash.add(std::span<const Quatf>(begin->rotation));
        hash.add(std::span<const float>(begin->sh_rest)).add(std::span<const float>(begin->opacity_logit));
    }
    return hash.hex();
}

// Per splat: parameters with two moments each, density control statistics, a record with its key and tiles, and the
// final splat.
std::int64_t memory_of_one(const SplatParams& params) {
    const auto rest = static_cast<std::int64_t>(3 * rest_functions(std::max(0, params.sh_degree)));
    return 4 * (3 * (kParameters + rest) + 2) + 4 * (kParameters + rest) +
           static_cast<std::int64_t>(sizeof(Record) + sizeof(std::uint64_t) + sizeof(TileBox));
}

float psnr_of(double mse) { return static_cast<float>(-10 * std::log10(std::max(mse, 1e-10))); }

EvalPoint evaluate(const TrainState& state, const std::vector<const View*>& views, const Run& run) {
    Engine engine(choose_kernel());
    double psnr = 0, ssim = 0;
    for (const View* v : views) {
        run.check_stop();
        engine.render(state.cloud, v->camera, v->world_from_camera, {}, false, v->model);
        const LossSums sums = engine.differentiate(*v, 1.f);  // loss = D-SSIM only
        psnr += psnr_of(sums.squared_error), ssim += 1 - sums.loss;
    }
    const double n = static_cast<double>(views.size());
    return {state.step, static_cast<float>(psnr / n), static_cast<float>(ssim / n)};
}

std::vector<EvalPicture> eval_pictures(const Splats& splats, const std::vector<const View*>& views) {
    constexpr std::size_t kMost = 6;
    std::vector<EvalPicture> out;
    const SplatRenderer renderer(splats);
    for (std::size_t i = 0; i < std::min(views.size(), kMost); ++i) {
        const View& v = *views[i * views.size() / std::min(views.size(), kMost)];
        const SplatPicture p = renderer.picture(v.camera, v.world_from_camera, {}, v.model);
        out.push_back({v.name, srgb8_from_unit(p.color), v.color});
    }
    return out;
}

// Memory of the half-size views for the first steps.
std::int64_t memory_of_half_views(const ViewSet& set, const SplatParams& params) {
    std::int64_t pixels = 0;
    for (const View& v : set.views) pixels += static_cast<std::int64_t>(3 * v.color.size() + v.weight.size()) / 4;
    return params.coarse > 0 ? pixels : 0;
}

// A training run: its state and its constants.
class Training {
  public:
    Training(const ViewSet& set, const SplatParams& params, const TrainTuning& tuning, const Run& run,
             const StepListener& on_step, const Splats* begin)
        : params_(params),
          tuning_(tuning),
          run_(run),
          on_step_(on_step),
          views_(split_views(set, params)),
          order_(views_.train.size(), run.seed),
          stepper_(make_stepper(params.backend)),
          extent_(scene_extent(set)),
          state_(start(set, begin)),
          summed_(state_.step) {
        last_ = params.until > 0 ? params.until : params.steps;
        coarse_steps_ = static_cast<int>(params.coarse * static_cast<float>(params.steps));
        if (params.depth > 0) depth_.emplace(set, params.count, run);
        show_views(state_.step < coarse_steps_);
        stepper_->load(state_.cloud);
        // Whether a splat is useless is known only after every view has been seen.
        density_every_ = std::max(tuning.relocate_every, static_cast<int>(views_.train.size()));
    }

    FittedSplats go() try {
        Progress progress(run_, "splat", last_);
        progress.advance(std::min(state_.step, last_));
        evaluate_if_due();  // a training that was stopped within an evaluation does it again
        while (state_.step < last_ && !stalled()) {
            if (run_.stop.stop_requested()) {
                save();
                run_.check_stop();
            }
            step();
            evaluate_if_due();
            progress.advance();
        }
        bring_back();
        save();
        FittedSplats out;
        out.splats = params_.strategy == "classic" ? alive(state_.cloud.splats(), Classic{}.faint)
                                                   : state_.cloud.splats();
        out.curve = state_.curve, out.evals = state_.evals, out.steps = state_.step;
        out.device = stepper_->device();
        close_curve(out.curve, state_.step);
        if (!views_.held_out.empty()) {
            if (out.evals.empty() || out.evals.back().step != state_.step)
                out.evals.push_back(evaluate(state_, views_.held_out, run_));
            out.eval_pictures = eval_pictures(out.splats, views_.held_out);
        }
        return out;
    } catch (const gpu::DeviceLost& e) {
        if (saved_ <= 0) throw;
        throw Error("{}; the same command continues from step {}", e.what(), saved_);
    }

  private:
    TrainState start(const ViewSet& set, const Splats* begin) {
        if (!params_.checkpoint.empty()) {
            key_ = key_of(set, params_, run_.seed, begin);
            if (std::filesystem::exists(params_.checkpoint)) {
                TrainState found = load_checkpoint(params_.checkpoint, key_);
                found.cloud.filter = params_.filter();  // settings are covered by the key
                run_.note(fmt::format("splat: resuming from step {} of {}", found.step, params_.checkpoint));
                return found;
            }
            write_file(params_.checkpoint,
                       std::string_view());  // fail now rather than hours later if it cannot be written
            std::filesystem::remove(params_.checkpoint);
        }
        check_splat_memory(params_, set.points.size(), memory_of_half_views(set, params_));
        Splats splats = begin ? *begin : initial_splats(set.points, params_, run_);
        if (splats.size() == 0) throw Error("splat: no usable initial points among {}", set.points.size());
        splats.sh_degree = params_.sh_degree, splats.filter = params_.filter();
        splats.resize(splats.size());
        TrainState state{0, Cloud(splats, true, params_.strategy == "none" ? 0 : params_.count), 0, 0, 0, {}, {}};
        if (params_.strategy == "classic")
            state.cloud.seen_move = state.cloud.seen_steps = AlignedFloats(state.cloud.seen_weight.size(), 0.f);
        return state;
    }

    void step() {
        const ExitHold hold;  // half a step is no state to go on from
        const int now = state_.step + 1;
        const float share = static_cast<float>(now - 1) / static_cast<float>(std::max(params_.steps, 1));
        const float done = std::min(1.f, params_.begun + (1 - params_.begun) * share);
        StepPlan plan;
        plan.lambda_dssim = params_.lambda_dssim;
        plan.rates.rates = rates_at(done, params_, tuning_);
        plan.rates.adam_step = now;
        constexpr float kReach = 4.f;  // times the scene's radius
        plan.rates.middle = extent_.middle, plan.rates.reach_m = kReach * extent_.radius_m;
        plan.rates.opacity_reg = params_.opacity_reg, plan.rates.scale_reg = params_.scale_reg;
        if (params_.sh_degree > 0 && now % tuning_.rest_every == 0)
            plan.rates.rest_rate = tuning_.rest * std::pow(tuning_.other_end, done),
            plan.rates.rest_adam_step = now / tuning_.rest_every;
        if (params_.random_background) {
            Random random(run_.seed, "splat.background", static_cast<std::uint64_t>(now));
            plan.background = {random.uniform(), random.uniform(), random.uniform()};
        }
        const std::size_t view = view_of(now);
        plan.judge = (params_.strategy == "mcmc" && done < tuning_.relocate_until) ||
                     (params_.strategy == "classic" && done < Classic{}.until);
        plan.moves = params_.strategy == "classic";
        plan.depth_strength = params_.depth;
        plan.alpha_strength = params_.opaque;
        if (params_.outside_m > 0) plan.outside_m = params_.outside_m;
        stepper_->step(state_.cloud, view, plan);
        state_.step = now;
        sum_losses();
        if (params_.strategy == "mcmc") move_splats(now, done, plan.rates.rates[0]);
        if (params_.strategy == "classic") densify_splats(now, done);
        if (now % params_.checkpoint_every == 0) save();
    }

    void evaluate_if_due() {
        if (params_.eval_every == 0 || state_.step == 0 || state_.step % params_.eval_every != 0) return;
        if (!state_.evals.empty() && state_.evals.back().step == state_.step) return;
        bring_back();
        try {
            state_.evals.push_back(evaluate(state_, views_.held_out, run_));
        } catch (const Stopped&) {
            save();
            throw;
        }
    }

    // The curve grows as losses become known: a backend may run behind.
    void sum_losses() {
        constexpr int kCurveSteps = 50;
        for (const LossSums& sums : stepper_->losses()) {
            state_.loss_sum += sums.loss, state_.squared_error_sum += sums.squared_error, ++state_.sum_steps;
            if (++summed_ % kCurveSteps == 0) close_curve(state_.curve, summed_);
            if (on_step_)
                on_step_({summed_, last_, static_cast<float>(sums.loss), psnr_of(sums.squared_error),
                          [this] { return splats_now(); }});
        }
    }
    Splats splats_now() {
        stepper_->store(state_.cloud);
        return state_.cloud.splats();
    }
    // All of the state on the host.
    void bring_back() {
        stepper_->store(state_.cloud);
        sum_losses();
    }

    // The view of a step; the first ones use half-size views.
    std::size_t view_of(int now) {
        if (now > coarse_steps_ && !half_views_.empty()) show_views(false);
        return order_.at(now);
    }
    void show_views(bool half) {
        std::vector<View> halves;
        if (half)
            for (const View* v : views_.train) halves.push_back(half_view(*v));
        std::vector<const View*> views;
        for (std::size_t i = 0; i < views_.train.size(); ++i) views.push_back(half ? &halves[i] : views_.train[i]);
        DepthOf depth_of;
        if (depth_) depth_of = [this](const View& v) -> const ImageF& { return depth_->of(v); };
        stepper_->set_views(std::move(views), std::move(depth_of));
        half_views_ = std::move(halves);
    }

    void move_splats(int now, float done, float rate_m) {
        const bool relocates = now % density_every_ == 0 && done < tuning_.relocate_until;
        const Relocation how{tuning_.relocate_fraction};
        if (tuning_.noise <= 0 && (!relocates || stepper_->relocate(tuning_.growth, how, run_.seed, now))) return;
        bring_back();
        Cloud& cloud = state_.cloud;
        if (tuning_.noise > 0) add_noise(cloud, tuning_.noise * rate_m, run_.seed, now);
        if (relocates) {
            grow(cloud, static_cast<std::int64_t>(tuning_.growth * static_cast<float>(cloud.count)), run_.seed, now);
            relocate(cloud, how, run_.seed, now);
        }
        stepper_->load(cloud);
    }
    void densify_splats(int now, float done) {
        const Classic classic;
        const bool densifies = now % density_every_ == 0 && done >= classic.from && done < classic.until,
                   resets = now % classic.reset_every == 0 && done < classic.until;
        if (!densifies && !resets) return;
        bring_back();
        if (densifies) densify(state_.cloud, classic, extent_.radius_m, run_.seed, now);
        if (resets) reset_opacities(state_.cloud);
        stepper_->load(state_.cloud);
    }

    void close_curve(std::vector<CurvePoint>& curve, int step) {
        if (state_.sum_steps == 0) return;
        const double n = state_.sum_steps;
        curve.push_back({step, static_cast<float>(state_.loss_sum / n), psnr_of(state_.squared_error_sum / n)});
        state_.loss_sum = state_.squared_error_sum = 0, state_.sum_steps = 0;
    }

    // Whether the held-out views have stopped improving.
    bool stalled() const {
        constexpr float kImprovementDb = 0.01f;
        if (params_.patience == 0) return false;
        float best = -1e9f;
        int since = 0;
        for (const EvalPoint& e : state_.evals) {
            since = e.psnr > best + kImprovementDb ? 0 : since + 1;
            best = std::max(best, e.psnr);
        }
        return since >= params_.patience;
    }

    // A full disk must not end the training, which is worth more than its checkpoint.
    void save() {
        if (params_.checkpoint.empty() || saved_ == state_.step) return;
        const ExitHold hold;
        saved_ = state_.step;
        bring_back();
        try {
            save_checkpoint(params_.checkpoint, state_, key_);
        } catch (const Error& e) {
            run_.warn(fmt::format("{}; training continues, an older checkpoint is kept", e.what()));
        }
    }

    const SplatParams& params_;
    const TrainTuning& tuning_;
    const Run& run_;
    const StepListener& on_step_;
    Split views_;
    ViewOrder order_;
    std::unique_ptr<Stepper> stepper_;
    SceneExtent extent_;
    std::optional<DepthTarget> depth_;
    std::vector<View> half_views_;
    int coarse_steps_ = 0;
    std::string key_;
    TrainState state_;
    int last_ = 0, density_every_ = 0, saved_ = -1;
    int summed_ = 0;  // steps whose losses are in the curve
};

}  // namespace

FittedSplats fit(const ViewSet& set, const SplatParams& asked, const TrainTuning& tuning, const Run& run,
                 const StepListener& on_step, const Splats* begin) {
    check_views(set);
    SplatParams params = asked;
    params.sh_degree = std::max(0, params.sh_degree);
    return Training(set, params, tuning, run, on_step, begin).go();
}

}  // namespace fastscene::splat

namespace fastscene {

void check_splat_params(const SplatParams& params) {
    check_fields("splat", params);
    if (params.patience > 0 && params.eval_every == 0)
        throw UsageError("--splat-patience: expected together with --splat-eval-every; found 0");
}

std::int64_t splat_memory(const SplatParams& params, std::size_t points) {
    const std::int64_t count = params.strategy == "none"
                                   ? std::min<std::int64_t>(params.count, static_cast<std::int64_t>(points))
                                   : params.count;
    return count * splat::memory_of_one(params);
}

int most_that_fit(const SplatParams& params) {
    constexpr double kShare = 0.8;  // the rest is left for views and pictures
    const std::int64_t found = available_memory();
    if (found <= 0) return params.count;
    return static_cast<int>(
        std::min<double>(2e9, kShare * static_cast<double>(found) / static_cast<double>(splat::memory_of_one(params))));
}

void check_splat_memory(const SplatParams& params, std::size_t points, std::int64_t beside_bytes) {
    const std::int64_t wanted = splat_memory(params, points), found = available_memory(),
                       have = std::max<std::int64_t>(found - beside_bytes, 0);
    if (found <= 0 || wanted <= have) return;
    constexpr double kGiB = 1 << 30;
    throw Error(
        "--splat-count: {} Gaussians with SH degree {} take {:.1f} GiB during training, found {:.1f} GiB free: enough "
        "for {}",
        params.count, params.sh_degree, static_cast<double>(wanted) / kGiB, static_cast<double>(have) / kGiB,
        have / splat::memory_of_one(params));
}

bool is_checkpoint_of(const std::string& file, const ViewSet& views, const SplatParams& params, std::uint64_t seed,
                      const Splats* begin) {
    return splat::has_checkpoint_key(file, splat::key_of(views, params, seed, begin));
}

FittedSplats fit_splats(const ViewSet& views, const SplatParams& params, const Run& run, const StepListener& on_step,
                        const Splats* begin) {
    check_splat_params(params);
    return splat::fit(views, params, {}, run, on_step, begin);
}

}  // namespace fastscene
