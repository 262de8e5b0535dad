#include "fastscene/splat/engine.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>
#include <numeric>
#include <utility>

#include "fastscene/base/check.h"
#include "fastscene/base/parallel.h"
#include "fastscene/splat/depth_loss.h"
#include "fastscene/splat/depth_sort.h"

namespace fastscene::splat {
namespace {

// Adds the CPU time of all threads during its lifetime to `sum`.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum_ms) : sum_ms_(sum_ms), start_(std::clock()) {}
    ~Stopwatch() { sum_ms_ += static_cast<double>(std::clock() - start_) * (1e3 / CLOCKS_PER_SEC); }

  private:
    double& sum_ms_;
    std::clock_t start_;
};

// Per-thread scratch memory; valid within one piece of work.
float* scratch(std::ptrdiff_t floats) {
    thread_local AlignedFloats memory;
    if (static_cast<std::ptrdiff_t>(memory.size()) < floats) memory.resize(static_cast<std::size_t>(floats));
    return memory.data();
}

template <class T>
void grow(T& v, std::size_t size) {
    if (v.size() < size) {
        v.clear();  // avoids copying old contents that are not needed
        v.resize(size + size / 4);
    }
}

}  // namespace

Lens<float> lens_of(const Pinhole& camera, const Rigid& world_from_camera, CameraModel model,
                    const FootprintFilter& filter) {
    const Rigid c = inverse(world_from_camera);
    const auto w = static_cast<float>(camera.width), h = static_cast<float>(camera.height);
    if (model == CameraModel::equirectangular)
        return {c.rotation, c.translation,    w / (2 * kPi),      h / kPi, w / 2, h / 2, 0, 0, 0, 0,
                model,      filter.antialias, filter.low_pass_px2};
    // margin of 15 % around the picture, as in Kerbl et al.'s implementation
    return {c.rotation,
            c.translation,
            camera.fx,
            camera.fy,
            camera.cx,
            camera.cy,
            (-0.15f * w - camera.cx) / camera.fx,
            (1.15f * w - camera.cx) / camera.fx,
            (-0.15f * h - camera.cy) / camera.fy,
            (1.15f * h - camera.cy) / camera.fy,
            model,
            filter.antialias,
            filter.low_pass_px2};
}

Cloud::Cloud(const Splats& s, bool train, std::int64_t room_for)
    : count(static_cast<std::int64_t>(s.size())),
      degree(s.sh_degree),
      capacity(std::max(count, room_for)),
      filter(s.filter) {
    const auto blocks = static_cast<std::size_t>((capacity + kBlock - 1) / kBlock * kBlock);
    const auto rest_floats = blocks * 3 * static_cast<std::size_t>(rest_functions(degree));
    parameters.resize(blocks * kParameters, 0.f);
    rest.resize(rest_floats, 0.f);
    if (train) {
        first_moment.resize(blocks * kParameters, 0.f);
        second_moment.resize(blocks * kParameters, 0.f);
        seen_weight.resize(blocks, 0.f);
        seen_error.resize(blocks, 0.f);
        rest_first_moment.resize(rest_floats, 0.f);
        rest_second_moment.resize(rest_floats, 0.f);
    }
    const int n = 3 * rest_functions(degree);
    for (std::int64_t i = 0; i < count; ++i)
        for (int k = 0; k < n; ++k) rest[rest_at(i, k)] = s.sh_rest[static_cast<std::size_t>(i * n + k)];
    for (std::int64_t i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const float all[kParameters] = {s.mean_m[k].x,    s.mean_m[k].y,    s.mean_m[k].z,      s.log_scale[k].x,
                                        s.log_scale[k].y, s.log_scale[k].z, s.rotation[k].w,    s.rotation[k].x,
                                        s.rotation[k].y,  s.rotation[k].z,  s.opacity_logit[k], s.sh0[k].x,
                                        s.sh0[k].y,       s.sh0[k].z};
        for (int p = 0; p < kParameters; ++p) parameters[at(i, p)] = all[p];
    }
}

Splats Cloud::splats() const {
    Splats s;
    s.sh_degree = degree, s.filter = filter;
    s.resize(static_cast<std::size_t>(count));
    const int n = 3 * rest_functions(degree);
    for (std::int64_t i = 0; i < count; ++i)
        for (int k = 0; k < n; ++k) s.sh_rest[static_cast<std::size_t>(i * n + k)] = rest[rest_at(i, k)];
    for (std::int64_t i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const auto get = [&](int p) { return parameters[at(i, p)]; };
        s.mean_m[k] = {get(0), get(1), get(2)};
        s.log_scale[k] = {get(3), get(4), get(5)};
        s.rotation[k] = {get(6), get(7), get(8), get(9)};
        s.opacity_logit[k] = get(10);
        s.sh0[k] = {get(11), get(12), get(13)};
    }
    return s;
}

void Engine::set_size(int width, int height) {
    if (width == width_ && height == height_) return;
    FASTSCENE_CHECK(width > 0 && height > 0 && width < 65536 && height < 65536);
    width_ = width, height_ = height;
    tiles_x_ = (width + kTile - 1) / kTile, tiles_y_ = (height + kTile - 1) / kTile;
    // One vector of padding: with a power-of-two stride, all rows would map to the same cache sets.
    stride_ = static_cast<std::ptrdiff_t>(tiles_x_) * kTile + 16;
    const std::size_t size = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(tiles_y_ * kTile);
    transmittance_.assign(size, 0.f);
    depth_.clear(), v_depth_.clear();
    for (auto* planes : {color_, v_, error_})
        for (int c = 0; c < 3; ++c) planes[c].clear();
    for (int c = 0; c < 3; ++c) color_[c].assign(size, 0.f);
    tile_begin_.assign(static_cast<std::size_t>(tiles_x_ * tiles_y_) + 1, 0);
}

void Engine::render(const Cloud& cloud, const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                    bool depth, CameraModel model) {
    set_size(camera.width, camera.height);
    lens_ = lens_of(camera, world_from_camera, model, cloud.filter);
    background_ = background;
    depth_counts_ = transmittance_counts_ = false;
    if (depth) depth_.resize(transmittance_.size());
    project(cloud);
    sort();
    bin();
    const Stopwatch watch(times.forward);
    const Frame f = frame(depth);
    parallel_for(tiles_x_ * tiles_y_, 4, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) kernel_.forward(f, static_cast<int>(t));
    });
}

void Engine::project(const Cloud& cloud) {
    const Stopwatch watch(times.project);
    const auto room = static_cast<std::size_t>(cloud.padded() * records_a_splat(lens_.model));
    grow(records_, room), grow(piece_keys_, room), grow(piece_boxes_, room);
    const ProjectJob job{cloud.parameters.data(),
                         cloud.count,
                         lens_,
                         width_,
                         height_,
                         records_.data(),
                         piece_keys_.data(),
                         piece_boxes_.data(),
                         cloud.degree ? cloud.rest.data() : nullptr,
                         cloud.degree};
    pieces_.assign(static_cast<std::size_t>((cloud.count + kPiece - 1) / kPiece), {});
    parallel_for(cloud.count, kPiece, [&](std::int64_t begin, std::int64_t end) {
        pieces_[static_cast<std::size_t>(begin / kPiece)] = kernel_.project(job, begin, end);
    });
    piece_slot_.clear();
    visible_ = 0;
    std::size_t slots = 0;
    for (const PieceCount& piece : pieces_) {
        piece_slot_.push_back(static_cast<std::uint32_t>(slots));
        visible_ += piece.records, slots += piece.slots;
    }
    slots_used_ = static_cast<std::int64_t>(slots);
}

// Front to back; equal depths stay in splat order.
void Engine::sort() {
    const Stopwatch watch(times.sort);
    keys_.clear();
    keys_.reserve(static_cast<std::size_t>(visible_));
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
        const auto first = piece_keys_.begin() + static_cast<std::ptrdiff_t>(piece) * records_a_piece();
        keys_.insert(keys_.end(), first, first + pieces_[piece].records);
    }
    sort_by_depth(keys_, keys_other_);
}

// Builds a list of splats per tile. Each piece holds splats that are consecutive in depth.
void Engine::bin() {
    const Stopwatch watch(times.bin);
    const int pieces = depth_pieces(keys_.size());
    const auto columns = static_cast<std::size_t>(tiles_x_), rows = static_cast<std::size_t>(tiles_y_),
               tiles = columns * rows;
    boxes_.resize(keys_.size());
    piece_tiles_.resize(static_cast<std::size_t>(pieces) * tiles);
    const auto each_piece = [&](auto&& work) {
        parallel_for(pieces, 1, [&](std::int64_t piece, std::int64_t) {
            const int p = static_cast<int>(piece);
            work(piece_tiles_.data() + static_cast<std::size_t>(piece) * tiles, piece_begin(keys_.size(), p, pieces),
                 piece_begin(keys_.size(), p + 1, pieces));
        });
    };
    // Counts a piece's boxes per tile as a 2D difference array: +1 and -1 at the corners, then prefix sums along rows
    // and columns.
    each_piece([&](std::uint32_t* count, std::size_t begin, std::size_t end) {
        const std::size_t width = columns + 1;
        std::vector<std::uint32_t> steps(width * (rows + 1));
        for (std::size_t i = begin; i < end; ++i) {
            const TileBox box = boxes_[i] = piece_boxes_[static_cast<std::uint32_t>(keys_[i])];
            std::uint32_t* const top = steps.data() + box.y * width + box.x;
            std::uint32_t* const below = top + box.high * width;
            ++top[0], --top[box.wide], --below[0], ++below[box.wide];
        }
        for (std::size_t y = 0; y < rows; ++y)
            for (std::size_t x = 0, sum = 0; x < columns; ++x) {
                sum += steps[y * width + x];
                count[y * columns + x] = static_cast<std::uint32_t>(sum) + (y ? count[(y - 1) * columns + x] : 0);
            }
    });
    std::uint32_t sum = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        tile_begin_[tile] = sum;
        for (std::size_t piece = 0; piece < static_cast<std::size_t>(pieces); ++piece) {
            std::uint32_t& count = piece_tiles_[piece * tiles + tile];
            count = std::exchange(sum, sum + count);
        }
    }
    tile_begin_[tiles] = sum;
    list_.resize(sum);
    masks_.resize(sum);
    each_piece([&](std::uint32_t* next, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const TileBox box = boxes_[i];
            const auto record = static_cast<std::uint32_t>(keys_[i]);
            std::uint32_t* row = next + box.y * columns + box.x;
            // A single loop over the box instead of two nested ones avoids branch mispredictions.
            for (std::uint32_t x = 0, left = std::uint32_t{box.wide} * box.high; left; --left) {
                list_[row[x]++] = record;
                const bool last = ++x == box.wide;
                row += last ? columns : 0;
                x = last ? 0 : x;
            }
        }
    });
}

Frame Engine::frame(bool depth) {
    Frame f{};
    f.width = width_, f.height = height_, f.tiles_x = tiles_x_, f.tiles_y = tiles_y_, f.stride = stride_;
    for (int c = 0; c < 3; ++c)
        f.color[c] = color_[c].data(), f.v[c] = v_[c].data(), f.error[c] = judges_ ? error_[c].data() : nullptr;
    f.transmittance = transmittance_.data();
    f.depth = depth ? depth_.data() : nullptr;
    f.background[0] = background_.x, f.background[1] = background_.y, f.background[2] = background_.z;
    f.records = records_.data(), f.list = list_.data(), f.tile_begin = tile_begin_.data();
    f.piece_slot = piece_slot_.data(), f.piece_shift = std::countr_zero(static_cast<unsigned>(records_a_piece()));
    f.masks = masks_.data(), f.slots = slots_.data();
    return f;
}

LossSums Engine::differentiate(const View& view, float lambda, bool judge) {
    const Stopwatch watch(times.loss);
    FASTSCENE_CHECK(view.color.width == width_ && view.color.height == height_);
    judges_ = judge;
    for (int c = 0; c < 3; ++c) {
        if (v_[c].size() != transmittance_.size()) v_[c].assign(transmittance_.size(), 0.f);
        if (judge && error_[c].size() != transmittance_.size()) error_[c].assign(transmittance_.size(), 0.f);
    }
    LossJob job{};
    job.width = width_, job.height = height_, job.stride = stride_, job.lambda = lambda;
    job.target = &view.color.pixels[0].r;
    job.weight = view.weight.empty() ? nullptr : view.weight.pixels.data();
    std::vector<float> row_weight;
    if (view.model == CameraModel::equirectangular) {
        for (int y = 0; y < height_; ++y) row_weight.push_back(latitude_weight(y, height_));
        job.row_weight = row_weight.data();
    }
    for (int c = 0; c < 3; ++c)
        job.color[c] = color_[c].data(), job.v[c] = v_[c].data(), job.error[c] = judge ? error_[c].data() : nullptr;
    const std::ptrdiff_t floats = kernel_.loss_scratch(stride_);
    std::vector<LossSums> sums(static_cast<std::size_t>(3 * height_));
    for (int c = 0; c < 3; ++c) job.row_sums[c] = sums.data() + c * height_;
    // Each thread handles a band of rows of each channel. Sums are kept per row, so the result does not depend on the
    // bands.
    const int bands = std::clamp(height_ / kLossRows, 1, thread_count());
    parallel_for(3 * bands, 1, [&](std::int64_t piece, std::int64_t) {
        const int band = static_cast<int>(piece) % bands;
        kernel_.loss(job, static_cast<int>(piece) / bands, height_ * band / bands, height_ * (band + 1) / bands,
                     scratch(floats));
    });
    LossSums total;
    for (const LossSums& s : sums) total.loss += s.loss, total.squared_error += s.squared_error;
    return total;
}

double Engine::differentiate_depth(const View& view, const ImageF& depth, float strength) {
    const Stopwatch watch(times.loss);
    FASTSCENE_CHECK(depth.width == width_ && depth.height == height_ && depth_.size() == transmittance_.size());
    v_depth_.resize(depth_.size(), 0.f);
    depth_counts_ = true;
    const float scale = strength / (static_cast<float>(width_) * static_cast<float>(height_));
    std::vector<double> row_loss(static_cast<std::size_t>(height_));
    parallel_for(height_, 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            const float row = view.model == CameraModel::equirectangular ? latitude_weight(y, height_) : 1.f;
            for (int x = 0; x < width_; ++x) {
                const std::size_t i = index(x, y);
                const float weight = scale * row *
                                     (view.weight.empty() ? 1.f : static_cast<float>(view.weight.at(x, y)) / 255.f);
                const DepthLoss<float> l = depth_loss(depth_[i], transmittance_[i], depth.at(x, y));
                depth_[i] = l.total, v_depth_[i] = weight * l.v,
                row_loss[static_cast<std::size_t>(y)] += static_cast<double>(weight * l.loss);
            }
        }
    });
    return std::accumulate(row_loss.begin(), row_loss.end(), 0.0);
}

double Engine::differentiate_transmittance(const View& view, float strength) {
    const Stopwatch watch(times.loss);
    transmittance_counts_ = true;
    v_transmittance_.assign(transmittance_.size(), 0.f);
    const float scale = strength / (static_cast<float>(width_) * static_cast<float>(height_));
    double loss = 0;
    for (int y = 0; y < height_; ++y) {
        const float row = scale * (view.model == CameraModel::equirectangular ? latitude_weight(y, height_) : 1.f);
        float sum = 0;
        for (int x = 0; x < width_; ++x) {
            const std::size_t i = index(x, y);
            const float weight = row * (view.weight.empty() ? 1.f : static_cast<float>(view.weight.at(x, y)) / 255.f);
            v_transmittance_[i] = weight;
            sum += weight * transmittance_[i];
        }
        loss += static_cast<double>(sum);
    }
    return loss;
}

void Engine::set_color_gradient(const std::vector<Vec3f>& v) {
    judges_ = false;
    FASTSCENE_CHECK(v.size() == static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    for (int c = 0; c < 3; ++c) {
        v_[c].assign(transmittance_.size(), 0.f);
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x)
                v_[c][index(x, y)] = v[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                       static_cast<std::size_t>(x)][static_cast<std::size_t>(c)];
    }
}

void Engine::backward() {
    const Stopwatch watch(times.backward);
    grow(slots_, static_cast<std::size_t>(slots_used_) * kSlotFloats + 2 * kBlock);
    Frame f = frame(depth_counts_);
    f.outside_m = outside_m_;
    f.v_depth = depth_counts_ ? v_depth_.data() : nullptr;
    f.v_transmittance = transmittance_counts_ ? v_transmittance_.data() : nullptr;
    parallel_for(tiles_x_ * tiles_y_, 4, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) kernel_.backward(f, static_cast<int>(t));
    });
}

void Engine::update(Cloud& cloud, UpdateJob& job) {
    const Stopwatch watch(times.update);
    job.parameters = cloud.parameters.data();
    job.first_moment = cloud.first_moment.data();
    job.second_moment = cloud.second_moment.data();
    if (judges_ && !cloud.seen_weight.empty())
        job.seen_weight = cloud.seen_weight.data(), job.seen_error = cloud.seen_error.data();
    job.records = records_.data();
    job.lens = lens_;
    if (cloud.degree) {
        job.degree = cloud.degree, job.rest = cloud.rest.data();
        job.rest_first_moment = cloud.rest_first_moment.data(),
        job.rest_second_moment = cloud.rest_second_moment.data();
    }
    if (judges_ && !cloud.seen_move.empty()) {
        job.seen_move = cloud.seen_move.data(), job.seen_steps = cloud.seen_steps.data();
        job.half_picture = 0.5f * static_cast<float>(std::max(width_, height_));
    }
    parallel_for(cloud.count, kPiece, [&](std::int64_t begin, std::int64_t end) {
        const std::int64_t record = begin * records_a_splat(lens_.model);
        const auto piece = static_cast<std::size_t>(begin / kPiece);
        const float* const slots = slots_.data() + std::size_t{piece_slot_[piece]} * kSlotFloats;
        kernel_.update(job, begin, end, record, record + pieces_[piece].records, slots);
    });
}

void Engine::step(Cloud& cloud, const StepRates& r) {
    FASTSCENE_CHECK(r.adam_step >= 1 && !cloud.first_moment.empty());
    backward();
    UpdateJob job{};
    const auto bias = [](double beta, int step) { return 1 - std::pow(beta, step); };
    for (int p = 0; p < kParameters; ++p)
        job.rate[p] = static_cast<float>(r.rates[static_cast<std::size_t>(p)] / bias(0.9, r.adam_step));
    job.inv_sqrt_bias2 = static_cast<float>(1 / std::sqrt(bias(0.999, r.adam_step)));
    job.rest_rate = static_cast<float>(r.rest_rate / bias(0.9, r.rest_adam_step));
    job.rest_inv_sqrt_bias2 = static_cast<float>(1 / std::sqrt(bias(0.999, r.rest_adam_step)));
    const auto count = static_cast<float>(cloud.count);
    job.opacity_reg = r.opacity_reg / count, job.scale_reg = r.scale_reg / (3 * count);
    job.middle = r.middle, job.reach_m = r.reach_m;
    update(cloud, job);
}

AlignedFloats Engine::gradients(Cloud& cloud, AlignedFloats* rest) {
    backward();
    AlignedFloats out(cloud.parameters.size(), 0.f);
    UpdateJob job{};
    job.gradients = out.data();
    if (rest) rest->assign(cloud.rest.size(), 0.f), job.rest_gradients = rest->data();
    update(cloud, job);
    return out;
}

std::int64_t Engine::block_visits() const {
    std::int64_t visits = 0;
    for (const std::uint16_t mask : masks_) visits += std::popcount(mask);
    return visits;
}

Vec3f Engine::color(int x, int y) const {
    const std::size_t i = index(x, y);
    return {color_[0][i], color_[1][i], color_[2][i]};
}

Vec3f Engine::color_gradient(int x, int y) const {
    const std::size_t i = index(x, y);
    return {v_[0][i], v_[1][i], v_[2][i]};
}

}  // namespace fastscene::splat
