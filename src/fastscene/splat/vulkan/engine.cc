#include "fastscene/splat/vulkan/engine.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "fastscene/base/check.h"
#include "fastscene/splat/vulkan/kernels.h"

namespace fastscene::splat::vulkan {
namespace {

constexpr std::size_t kBatches = 3;     // being recorded, waiting, running
constexpr std::size_t kMostSteps = 32;  // of a batch
constexpr double kBatchSeconds = 0.2;   // drivers reset a card that is busy for seconds, and people stop runs
constexpr std::uint32_t kGroup = 256;   // invocations of most kernels
constexpr std::uint32_t kBins = 256;    // of a radix pass
constexpr std::uint32_t kMostSortGroups = 128;
constexpr std::int64_t kKeysAGroup = 2048;  // fewer groups leave the card idle, more sum more histograms
constexpr float kPairsASplat = 3;           // reserved at first; most splats of a room are not in the picture
constexpr std::int64_t kLeastPairs = 1 << 16;
constexpr std::int64_t kViewBytes = 256 << 20;  // of one buffer of views
constexpr double kViewShare = 0.5;              // of the free memory that views may take

std::uint32_t groups_of(std::int64_t items, std::int64_t size = kGroup) {
    return static_cast<std::uint32_t>(std::max<std::int64_t>(1, (items + size - 1) / size));
}
std::uint32_t sort_groups(std::int64_t items) { return std::clamp(groups_of(items, kKeysAGroup), 8u, kMostSortGroups); }
double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Between the kernels' blocks of 16 splats and planes of `capacity` floats, one a parameter.
void to_planes(const AlignedFloats& blocks, std::int64_t count, int values, std::int64_t capacity,
               std::vector<float>& planes) {
    planes.assign(static_cast<std::size_t>(capacity * values), 0.f);
    for (std::int64_t i = 0; i < count; i += kBlock)
        for (int p = 0; p < values; ++p)
            std::copy_n(blocks.data() + i * values + p * kBlock, std::min<std::int64_t>(kBlock, count - i),
                        planes.data() + p * capacity + i);
}
void to_blocks(const std::vector<float>& planes, std::int64_t count, int values, std::int64_t capacity,
               AlignedFloats& blocks) {
    for (std::int64_t i = 0; i < count; i += kBlock)
        for (int p = 0; p < values; ++p)
            std::copy_n(planes.data() + p * capacity + i, std::min<std::int64_t>(kBlock, count - i),
                        blocks.data() + i * values + p * kBlock);
}

// Colors and weight, a byte each.
std::vector<std::uint32_t> packed(const View& view) {
    std::vector<std::uint32_t> out(view.color.pixels.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Rgb8 c = view.color.pixels[i];
        const std::uint32_t weight = view.weight.empty() ? 255 : view.weight.pixels[i];
        out[i] = c.r | std::uint32_t{c.g} << 8 | std::uint32_t{c.b} << 16 | weight << 24;
    }
    return out;
}

Vec4 row_of(Vec3f rotation, float translation) { return {rotation.x, rotation.y, rotation.z, translation}; }

}  // namespace

VulkanEngine::VulkanEngine(const std::string& device, const std::string& flag)
    : device_(gpu::choose_device(device, flag)), kernels_(std::make_unique<Kernels>(device_)) {
    tables_buffer_ = gpu::Buffer(device_, sizeof(Tables), gpu::Memory::device, "tables");
    counters_ = gpu::Buffer(device_, sizeof(Counters), gpu::Memory::device, "counters");
    histogram_ = gpu::Buffer(device_, kMostSortGroups * kBins * 4, gpu::Memory::device, "histograms");
    block_pairs_ = gpu::Buffer(device_, kMostSortGroups * 4, gpu::Memory::device, "counts");
    outcomes_ = gpu::Buffer(device_, static_cast<std::int64_t>(kBatches * kMostSteps * sizeof(Outcome)),
                            gpu::Memory::readback, "losses");
    for (std::size_t i = 0; i < kBatches; ++i) {
        auto batch = std::make_unique<Batch>(device_);
        constexpr std::int64_t kPlans = static_cast<std::int64_t>(kMostSteps * sizeof(Plan));
        batch->mapped_plans = gpu::Buffer(device_, kPlans, gpu::Memory::upload, "steps");
        batch->plans = gpu::Buffer(device_, kPlans, gpu::Memory::device, "steps");
        batch->first_outcome = static_cast<std::uint32_t>(i * kMostSteps);
        batches_.push_back(std::move(batch));
    }
}
VulkanEngine::~VulkanEngine() = default;

void VulkanEngine::allocate_splats(std::int64_t capacity, int degree, bool train) {
    if (capacity <= capacity_ && degree == degree_ && (trains_ || !train)) return;
    capacity_ = (capacity + kBlock - 1) / kBlock * kBlock, degree_ = degree, trains_ = train;
    const auto floats = [&](std::int64_t values, const char* what) {
        return values ? gpu::Buffer(device_, values * capacity_ * 4, gpu::Memory::device, what) : gpu::Buffer();
    };
    const std::int64_t rest = 3 * rest_functions(degree);
    parameters_ = floats(kParameters, "splats"), rest_ = floats(rest, "spherical harmonics");
    first_moment_ = floats(train ? kParameters : 0, "moments");
    second_moment_ = floats(train ? kParameters : 0, "moments");
    rest_first_ = floats(train ? rest : 0, "moments"), rest_second_ = floats(train ? rest : 0, "moments");
    seen_ = floats(train ? 4 : 0, "statistics");
    gradients_ = {}, rest_gradients_ = {};
    if (train) {
        const auto make = [&](std::int64_t bytes) {
            return gpu::Buffer(device_, bytes, gpu::Memory::device, "density control");
        };
        const std::int64_t groups = groups_of(capacity_);
        density_ = make(16), density_errors_ = make(groups * 4), density_dead_ = make(groups * 4);
        density_claims_ = make(capacity_ * 4), density_choices_ = make(capacity_ * 4);
        density_ranks_ = make(capacity_ * 4), density_free_ = make(capacity_ * 4);
    }
    records_ = 0;
    reserve_pairs(std::max<std::int64_t>({kLeastPairs, static_cast<std::int64_t>(pair_capacity_),
                                          static_cast<std::int64_t>(kPairsASplat * static_cast<float>(capacity_))}));
}

// A splat has two records in an equirectangular picture.
void VulkanEngine::reserve_pairs(std::int64_t pairs) {
    if (records_ < 2 * capacity_) {
        records_ = 2 * capacity_;
        const auto make = [&](std::int64_t bytes) {
            return gpu::Buffer(device_, records_ * bytes, gpu::Memory::device, "projected splats");
        };
        records_buffer_ = make(48), boxes_ = make(8), first_pair_ = make(4);
        for (auto* list : {depth_keys_, depth_records_}) list[0] = make(4), list[1] = make(4);
    }
    if (pairs != static_cast<std::int64_t>(pair_capacity_)) {
        FASTSCENE_CHECK(pairs > 0 && pairs < std::int64_t{1} << 28);
        pair_capacity_ = static_cast<std::uint32_t>(pairs);
        const auto make = [&](std::int64_t bytes) {
            return gpu::Buffer(device_, pairs * bytes, gpu::Memory::device, "pairs of splats and tiles");
        };
        for (auto* list : {pair_tiles_, pair_records_}) list[0] = {}, list[1] = {};  // before the new ones
        slots_ = {};
        for (auto* list : {pair_tiles_, pair_records_}) list[0] = make(4), list[1] = make(4);
        slots_ = make(kSlotFloats * 4);
    }
    write_tables();
}

void VulkanEngine::reserve_pixels(int width, int height) {
    const std::int64_t pixels = std::int64_t{width} * height,
                       tiles = std::int64_t{(width + kTile - 1) / kTile} * ((height + kTile - 1) / kTile);
    if (pixels <= pixels_ && tiles <= tiles_) return;
    drain();
    pixels_ = std::max(pixels, pixels_), tiles_ = std::max(tiles, tiles_);
    const auto make = [&](std::int64_t bytes) {
        return gpu::Buffer(device_, bytes, gpu::Memory::device, "the picture");
    };
    color_ = make(pixels_ * 16), depth_ = make(pixels_ * 4), maps_ = make(pixels_ * 36), v_ = make(pixels_ * 16);
    v_more_ = make(pixels_ * 8), tile_begin_ = make((tiles_ + 1) * 4);
    stops_ = make(tiles_ * kGroup / device_.subgroup_size() * 4);
    dssim_ = make(tiles_ * 12), sums_ = make(tiles_ * 16);
    write_tables();
}

void VulkanEngine::write_tables() {
    Tables& t = tables_;
    t.parameters = parameters_.address(), t.first_moment = first_moment_.address();
    t.second_moment = second_moment_.address(), t.rest = rest_.address();
    t.rest_first_moment = rest_first_.address(), t.rest_second_moment = rest_second_.address();
    const auto plane = static_cast<std::uint64_t>(capacity_) * 4;
    t.seen_weight = seen_.address(), t.seen_error = t.seen_weight + plane, t.seen_move = t.seen_error + plane;
    t.seen_steps = t.seen_move + plane;
    t.gradients = gradients_.address(), t.rest_gradients = rest_gradients_.address();
    t.records = records_buffer_.address(), t.boxes = boxes_.address(), t.first_pair = first_pair_.address();
    for (int i = 0; i < 2; ++i)
        t.depth_keys[i] = depth_keys_[i].address(), t.depth_records[i] = depth_records_[i].address(),
        t.pair_tiles[i] = pair_tiles_[i].address(), t.pair_records[i] = pair_records_[i].address();
    t.histogram = histogram_.address(), t.block_pairs = block_pairs_.address(), t.tile_begin = tile_begin_.address();
    t.stops = stops_.address(), t.color = color_.address(), t.depth = depth_.address(), t.maps = maps_.address();
    t.v = v_.address(), t.v_more = v_more_.address(), t.slots = t.slot_floats = slots_.address(),
    t.dssim = dssim_.address();
    t.sums = sums_.address(), t.counters = counters_.address(), t.outcomes = outcomes_.address();
    t.density = density_.address(), t.density_errors = density_errors_.address();
    t.density_dead = density_dead_.address(), t.density_claims = density_claims_.address();
    t.density_choices = density_choices_.address(), t.density_ranks = density_ranks_.address();
    t.density_free = density_free_.address();
    t.capacity = static_cast<std::uint32_t>(capacity_), t.most_splats = static_cast<std::uint32_t>(most_);
    t.pair_capacity = pair_capacity_;
    gpu::upload(device_, tables_buffer_, 0, &t, sizeof t);
}

void VulkanEngine::set_counters(std::uint32_t count) {
    const Counters c{count, 0, 0, 0};
    gpu::upload(device_, counters_, 0, &c, sizeof c);
}

void VulkanEngine::load(const Cloud& cloud) {
    drain();
    const bool train = !cloud.first_moment.empty();
    allocate_splats(std::max(cloud.capacity, cloud.count), cloud.degree, train);
    count_ = cloud.count, most_ = std::max(cloud.capacity, cloud.count), filter_ = cloud.filter;
    std::vector<float> planes;
    const auto send = [&](const AlignedFloats& from, const gpu::Buffer& to, int values) {
        if (!to || from.empty()) return;
        to_planes(from, count_, values, capacity_, planes);
        gpu::upload(device_, to, 0, planes.data(), static_cast<std::int64_t>(planes.size() * 4));
    };
    const int rest = 3 * rest_functions(degree_);
    send(cloud.parameters, parameters_, kParameters), send(cloud.rest, rest_, rest);
    if (train) {
        send(cloud.first_moment, first_moment_, kParameters), send(cloud.second_moment, second_moment_, kParameters);
        send(cloud.rest_first_moment, rest_first_, rest), send(cloud.rest_second_moment, rest_second_, rest);
        planes.assign(static_cast<std::size_t>(4 * capacity_), 0.f);
        const AlignedFloats* const seen[] = {&cloud.seen_weight, &cloud.seen_error, &cloud.seen_move,
                                             &cloud.seen_steps};
        for (int k = 0; k < 4; ++k)
            if (!seen[k]->empty()) std::copy_n(seen[k]->data(), count_, planes.data() + k * capacity_);
        gpu::upload(device_, seen_, 0, planes.data(), static_cast<std::int64_t>(planes.size() * 4));
    }
    set_counters(static_cast<std::uint32_t>(count_));
    write_tables();
}

std::uint32_t VulkanEngine::device_count() {
    Counters c;
    gpu::download(device_, counters_, 0, &c, sizeof c);
    return c.count;
}

void VulkanEngine::store(Cloud& cloud) {
    drain();
    FASTSCENE_CHECK(cloud.capacity <= capacity_ && cloud.degree == degree_);
    count_ = device_count();
    cloud.count = count_;
    std::vector<float> planes(static_cast<std::size_t>(capacity_ * std::max(kParameters, 3 * rest_functions(degree_))));
    const auto fetch = [&](const gpu::Buffer& from, AlignedFloats& to, int values) {
        if (!from || to.empty()) return;
        gpu::download(device_, from, 0, planes.data(), capacity_ * values * 4);
        to_blocks(planes, count_, values, capacity_, to);
    };
    const int rest = 3 * rest_functions(degree_);
    fetch(parameters_, cloud.parameters, kParameters), fetch(rest_, cloud.rest, rest);
    fetch(first_moment_, cloud.first_moment, kParameters), fetch(second_moment_, cloud.second_moment, kParameters);
    fetch(rest_first_, cloud.rest_first_moment, rest), fetch(rest_second_, cloud.rest_second_moment, rest);
    if (!seen_) return;
    gpu::download(device_, seen_, 0, planes.data(), 4 * capacity_ * 4);
    AlignedFloats* const seen[] = {&cloud.seen_weight, &cloud.seen_error, &cloud.seen_move, &cloud.seen_steps};
    for (int k = 0; k < 4; ++k)
        if (!seen[k]->empty()) std::copy_n(planes.data() + k * capacity_, count_, seen[k]->data());
}

void VulkanEngine::set_views(const std::vector<const View*>& views, const DepthOf& depth_of) {
    drain();
    pictures_.clear(), view_memory_.clear();
    std::int64_t bytes = 0;
    for (const View* v : views) {
        bytes += static_cast<std::int64_t>(v->color.size()) * (depth_of ? 8 : 4);
        reserve_pixels(v->color.width, v->color.height);
    }
    const gpu::Memory place = static_cast<double>(bytes) < kViewShare * static_cast<double>(device_.free_memory())
                                  ? gpu::Memory::device
                                  : gpu::Memory::upload;
    std::vector<std::uint32_t> words;
    std::size_t first = 0;
    const auto flush = [&] {
        if (words.empty()) return;
        const auto size = static_cast<std::int64_t>(words.size() * 4);
        gpu::Buffer buffer(device_, size, place, "views");
        gpu::upload(device_, buffer, 0, words.data(), size);
        for (std::size_t i = first; i < pictures_.size(); ++i) {
            pictures_[i].target += buffer.address();
            if (pictures_[i].depth) pictures_[i].depth += buffer.address();
        }
        first = pictures_.size();
        view_memory_.push_back(std::move(buffer));
        words.clear();
    };
    const auto align = [&] { words.resize((words.size() + 3) / 4 * 4); };
    for (const View* v : views) {
        const std::size_t more = v->color.size() * (depth_of ? 8 : 4);
        if (static_cast<std::int64_t>(words.size() * 4 + more) > kViewBytes) flush();
        Picture p{v->camera, v->world_from_camera, v->model, words.size() * 4, 0};
        const std::vector<std::uint32_t> colors = packed(*v);
        words.insert(words.end(), colors.begin(), colors.end());
        align();
        if (depth_of) {
            p.depth = words.size() * 4;
            for (const float d : depth_of(*v).pixels) words.push_back(std::bit_cast<std::uint32_t>(d));
            align();
        }
        pictures_.push_back(p);
    }
    flush();
}

Plan VulkanEngine::plan_of(const Pinhole& camera, const Rigid& world_from_camera, CameraModel model,
                           Vec3f background) const {
    const Lens<float> lens = lens_of(camera, world_from_camera, model, filter_);
    const Vec3f center = lens.camera_center();
    Plan p;
    p.row_x = row_of(lens.rotation.row0, lens.translation.x), p.row_y = row_of(lens.rotation.row1, lens.translation.y);
    p.row_z = row_of(lens.rotation.row2, lens.translation.z);
    p.lens = {lens.fx, lens.fy, lens.cx, lens.cy};
    p.slopes = {lens.min_u, lens.max_u, lens.min_v, lens.max_v};
    p.center = {center.x, center.y, center.z, std::numeric_limits<float>::infinity()};
    p.background = {background.x, background.y, background.z, 0};
    p.weights.w = lens.low_pass_px2;
    p.width = static_cast<std::uint32_t>(camera.width), p.height = static_cast<std::uint32_t>(camera.height);
    p.tiles_x = groups_of(camera.width, kTile), p.tiles_y = groups_of(camera.height, kTile);
    p.flags = (lens.equirect() ? kEquirect : 0u) | (filter_.antialias ? kAntialias : 0u);
    p.degree = static_cast<std::uint32_t>(degree_);
    return p;
}

Plan VulkanEngine::plan_of(const Picture& picture, const StepPlan& step) const {
    Plan p = plan_of(picture.camera, picture.world_from_camera, picture.model, step.background);
    const StepRates& r = step.rates;
    const auto bias = [](double beta, int n) { return 1 - std::pow(beta, n); };
    for (std::size_t i = 0; i < kParameters; ++i) p.rates[i] = static_cast<float>(r.rates[i] / bias(0.9, r.adam_step));
    p.rates[14] = static_cast<float>(r.rest_rate / bias(0.9, r.rest_adam_step));
    p.background.w = step.lambda_dssim, p.center.w = step.outside_m;
    p.middle = {r.middle.x, r.middle.y, r.middle.z, 1 / r.reach_m};
    p.adam = {static_cast<float>(1 / std::sqrt(bias(0.999, r.adam_step))),
              static_cast<float>(1 / std::sqrt(bias(0.999, r.rest_adam_step))), r.opacity_reg, r.scale_reg};
    const float area = static_cast<float>(p.width) * static_cast<float>(p.height);
    p.weights = {picture.depth ? step.depth_strength / area : 0, step.alpha_strength / area,
                 0.5f * static_cast<float>(std::max(p.width, p.height)), p.weights.w};
    p.target = picture.target, p.depth = picture.depth;
    p.flags |= (picture.depth ? kDepth : 0u) | (step.alpha_strength > 0 ? kOpen : 0u) | (step.judge ? kJudge : 0u) |
               (step.judge && step.moves ? kMoves : 0u);
    return p;
}

void VulkanEngine::step(std::size_t view, const StepPlan& plan) { enqueue(plan_of(pictures_.at(view), plan)); }

void VulkanEngine::relocate(float growth, std::uint32_t seed) {
    Plan p;
    p.flags = kDensity | static_cast<std::uint32_t>(degree_) << 16;
    p.rates[0] = growth, p.degree = seed;
    enqueue(p);
    count_ = std::min(most_, count_ + static_cast<std::int64_t>(growth * static_cast<float>(count_)));
}

void VulkanEngine::record_density(Batch& batch, std::uint64_t address) {
    const Kernels& k = *kernels_;
    const std::uint32_t groups = groups_of(capacity_);
    Push push{tables_buffer_.address(), address, 0, 0, 0, 0};
    for (push.first = 0; push.first < 2; ++push.first) {  // growth, relocation
        batch.commands.run(k.density_sum, {groups}, push);
        batch.commands.run(k.density_scan, {1}, push);
        batch.commands.run(k.density_sample, {groups}, push);
        batch.commands.run(k.density_rank, {1}, push);
        batch.commands.run(k.density_split, {groups}, push);
        batch.commands.run(k.density_finish, {groups}, push);
    }
}

void VulkanEngine::enqueue(const Plan& plan) {
    while (!current().is_recording && current().is_running) collect_oldest();
    Batch& batch = current();
    if (!batch.is_recording) {
        batch.steps.clear();
        batch.commands.begin();
        batch.commands.copy(batch.mapped_plans, 0, batch.plans, 0, batch.plans.bytes());
        batch.is_recording = true;
    }
    Plan p = plan;
    const std::size_t place = batch.steps.size();
    p.number = ++number_, p.outcome = batch.first_outcome + static_cast<std::uint32_t>(place);
    std::memcpy(static_cast<char*>(batch.mapped_plans.mapped()) + place * sizeof p, &p, sizeof p);
    const std::uint64_t address = batch.plans.address() + place * sizeof p;
    if (p.flags & kDensity) record_density(batch, address);
    else record(batch, p, address);
    batch.steps.push_back(p);
    if (batch.steps.size() >= batch_limit_) submit();
}

void VulkanEngine::record(Batch& batch, const Plan& plan, std::uint64_t address) {
    const Kernels& k = *kernels_;
    gpu::Commands& commands = batch.commands;
    Push push{tables_buffer_.address(), address, 0, 0, 0, 0};
    const bool equirect = plan.flags & kEquirect;
    const std::int64_t records = count_ * (equirect ? 2 : 1), tiles = std::int64_t{plan.tiles_x} * plan.tiles_y;
    commands.run(k.project, {groups_of(count_)}, push);
    // Any number of groups sorts alike; how many are best is known from earlier steps.
    const auto sort = [&](int bits, std::uint32_t first, std::int64_t items, std::int64_t later_items) {
        const int passes = std::max(1, (bits + 7) / 8), each = (bits + passes - 1) / passes;
        for (int pass = 0; pass < passes; ++pass) {
            push.shift = static_cast<std::uint32_t>(pass * each), push.bits = static_cast<std::uint32_t>(each);
            push.side = pass % 2, push.first = pass == 0 || first == 2 ? first : 0;
            const std::uint32_t groups = sort_groups(pass == 0 ? items : later_items);
            commands.run(k.radix_count, {groups}, push), commands.run(k.radix_scatter, {groups}, push);
        }
        push.side = passes % 2;
    };
    sort(32, 1, records, visible_ ? visible_ : records / 4);
    const std::int64_t pairs = pairs_ ? pairs_ : pair_capacity_ / 4;
    const std::uint32_t pieces = std::min(kMostSortGroups, groups_of(count_, kGroup));
    commands.run(k.pairs_count, {pieces}, push), commands.run(k.pairs_write, {pieces}, push);
    sort(std::bit_width(static_cast<std::uint64_t>(tiles - 1)), 2, pairs, pairs);
    commands.run(k.tiles, {kMostSortGroups}, push);
    const auto picture = static_cast<std::uint32_t>(tiles);
    commands.run(k.forward, {picture}, push);
    if (!(plan.flags & kNoLoss))
        commands.run(k.ssim, {picture, 1, 3}, push), commands.run(k.loss_grad, {picture}, push);
    if (!(plan.flags & kRenderOnly)) commands.run(k.backward, {picture}, push);
    commands.run(k.update, {plan.flags & kRenderOnly ? 1u : groups_of(count_)}, push);
}

void VulkanEngine::submit() {
    Batch& batch = current();
    batch.is_recording = false, batch.is_running = true;
    batch.started_s = seconds();
    batch.commands.submit();
    running_.push_back(&batch);
    batch_ = (batch_ + 1) % batches_.size();
}

void VulkanEngine::collect_oldest() {
    Batch& batch = *running_.front();
    running_.pop_front();
    batch.commands.wait();
    batch.is_running = false;
    const double now = seconds(),
                 each = (now - std::max(batch.started_s, last_done_s_)) / static_cast<double>(batch.steps.size());
    last_done_s_ = now;
    batch_limit_ = std::clamp(static_cast<std::size_t>(kBatchSeconds / std::max(each, 1e-6)), std::size_t{1},
                              std::min(kMostSteps, 2 * batch_limit_));
    const Outcome* const outcomes = static_cast<const Outcome*>(outcomes_.mapped()) + batch.first_outcome;
    for (std::size_t i = 0; i < batch.steps.size(); ++i) {
        if (batch.steps[i].flags & kDensity) continue;
        if (const Outcome& o = outcomes[i]; o.failed)
            return repeat({batch.steps.begin() + static_cast<std::ptrdiff_t>(i), batch.steps.end()}, o.pairs);
        visible_ = outcomes[i].visible, pairs_ = outcomes[i].pairs;
        losses_.push_back({static_cast<double>(outcomes[i].loss), static_cast<double>(outcomes[i].squared_error)});
    }
}

// A step whose pairs did not fit changed nothing, nor did any after it: they are made again, with room for more.
void VulkanEngine::repeat(std::vector<Plan> steps, std::uint32_t pairs) {
    for (; !running_.empty(); running_.pop_front()) {
        Batch& later = *running_.front();
        later.commands.wait();
        later.is_running = false;
        steps.insert(steps.end(), later.steps.begin(), later.steps.end());
    }
    if (current().is_recording) steps.insert(steps.end(), current().steps.begin(), current().steps.end());
    current().is_recording = false;
    set_counters(device_count());
    reserve_pairs(std::int64_t{pairs} + pairs / 4);
    number_ = steps.front().number - 1;
    for (const Plan& p : steps) enqueue(p);
}

void VulkanEngine::drain() {
    while (current().is_recording || !running_.empty()) {
        if (current().is_recording) submit();
        collect_oldest();
    }
}

std::vector<LossSums> VulkanEngine::losses() { return std::exchange(losses_, {}); }

std::vector<LossSums> VulkanEngine::finish() {
    drain();
    return losses();
}

SplatPicture VulkanEngine::render(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                                  CameraModel model) {
    drain();
    std::vector<LossSums> kept = losses();
    reserve_pixels(camera.width, camera.height);
    Plan plan = plan_of(camera, world_from_camera, model, background);
    plan.flags |= kRenderOnly | kNoLoss | kDepth;
    enqueue(plan);
    drain();
    losses_ = std::move(kept);  // a picture has none
    const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    std::vector<Vec4> color(pixels);
    std::vector<float> depth(pixels);
    gpu::download(device_, color_, 0, color.data(), static_cast<std::int64_t>(pixels * sizeof(Vec4)));
    gpu::download(device_, depth_, 0, depth.data(), static_cast<std::int64_t>(pixels * sizeof(float)));
    SplatPicture out{ImageColor(camera.width, camera.height), ImageF(camera.width, camera.height),
                     ImageF(camera.width, camera.height)};
    for (std::size_t i = 0; i < pixels; ++i) {
        const float alpha = 1 - color[i].w;
        out.color.pixels[i] = {color[i].x, color[i].y, color[i].z};
        out.alpha.pixels[i] = alpha;
        out.depth_z.pixels[i] = alpha > 0 ? depth[i] / alpha : 0;
    }
    return out;
}

VulkanEngine::Gradients VulkanEngine::gradients(const Cloud& cloud, const View& view, const ImageF* depth,
                                                const StepPlan& step, const std::vector<Vec3f>* v) {
    load(cloud);
    const std::int64_t rest = 3 * rest_functions(degree_);
    gradients_ = gpu::Buffer(device_, kParameters * capacity_ * 4, gpu::Memory::device, "gradients");
    rest_gradients_ = gpu::Buffer(device_, rest * capacity_ * 4, gpu::Memory::device, "gradients");
    for (const gpu::Buffer* b : {&gradients_, &rest_gradients_}) {
        gpu::Commands clear(device_);
        clear.begin(), clear.fill(*b, 0), clear.submit(), clear.wait();
    }
    set_views({&view}, depth ? DepthOf([depth](const View&) -> const ImageF& { return *depth; }) : DepthOf());
    write_tables();
    Plan plan = plan_of(pictures_.front(), step);
    plan.flags |= kGradientsOnly;
    if (v) {
        std::vector<Vec4> all;
        for (const Vec3f x : *v) all.push_back({x.x, x.y, x.z, 0});
        gpu::upload(device_, v_, 0, all.data(), static_cast<std::int64_t>(all.size() * sizeof(Vec4)));
        plan.flags = (plan.flags | kNoLoss) & ~(kDepth | kOpen | kJudge);
    }
    enqueue(plan);
    const std::vector<LossSums> losses = finish();
    Gradients out;
    out.loss = losses.back();
    std::vector<float> planes(static_cast<std::size_t>(capacity_ * std::max<std::int64_t>(kParameters, rest)));
    gpu::download(device_, gradients_, 0, planes.data(), kParameters * capacity_ * 4);
    out.parameters.resize(cloud.parameters.size(), 0.f), out.rest.resize(cloud.rest.size(), 0.f);
    to_blocks(planes, count_, kParameters, capacity_, out.parameters);
    if (rest) {
        gpu::download(device_, rest_gradients_, 0, planes.data(), rest * capacity_ * 4);
        to_blocks(planes, count_, static_cast<int>(rest), capacity_, out.rest);
    }
    return out;
}

}  // namespace fastscene::splat::vulkan
