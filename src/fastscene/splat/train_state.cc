#include "fastscene/splat/train_state.h"

#include <cstring>

#include "fastscene/base/error.h"
#include "fastscene/base/hash.h"

namespace fastscene::splat {
namespace {

constexpr std::string_view kMagic = "fastscene splat checkpoint 1\n";
constexpr std::size_t kHashChars = 32;

// One description for both directions: Out appends, In takes.
struct Out {
    std::string bytes;
    void raw(void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }
    std::uint64_t size_of(std::uint64_t n, std::size_t) { return raw(&n, sizeof n), n; }
};
struct In {
    std::string_view bytes;
    const std::string& file;
    void raw(void* data, std::size_t size) {
        if (size > bytes.size()) throw Error("{}: expected {} more bytes of a checkpoint, found {}", file, size, bytes.size());
        std::memcpy(data, bytes.data(), size);
        bytes.remove_prefix(size);
    }
    std::uint64_t size_of(std::uint64_t, std::size_t item) {
        std::uint64_t n = 0;
        raw(&n, sizeof n);
        if (n > bytes.size() / item) throw Error("{}: expected {} numbers of a checkpoint, found {} bytes", file, n, bytes.size());
        return n;
    }
};
template <class Stream, class T>
void value(Stream& s, T& x) {
    s.raw(&x, sizeof x);
}
template <class Stream, class V>
void list(Stream& s, V& v) {
    v.resize(s.size_of(v.size(), sizeof v[0]));
    if (!v.empty()) s.raw(v.data(), v.size() * sizeof v[0]);
}
template <class Stream>
void everything(Stream& s, TrainState& t) {
    value(s, t.step), value(s, t.loss_sum), value(s, t.squared_error_sum), value(s, t.sum_steps);
    list(s, t.curve), list(s, t.evals);
    Cloud& c = t.cloud;
    value(s, c.count), value(s, c.capacity), value(s, c.degree);
    for (AlignedFloats* v : {&c.parameters, &c.first_moment, &c.second_moment, &c.seen_weight, &c.seen_error, &c.seen_move, &c.seen_steps, &c.rest,
                             &c.rest_first_moment, &c.rest_second_moment})
        list(s, *v);
}

}  // namespace

std::string checkpoint_bytes(TrainState& state, std::string_view key) {
    Out out;
    out.bytes = fmt::format("{}{}\n", kMagic, key);
    everything(out, state);
    out.bytes += Hash().add(out.bytes).hex();
    return std::move(out.bytes);
}

TrainState checkpoint_from(std::string_view bytes, std::string_view key, const std::string& file) {
    if (!bytes.starts_with(kMagic)) throw Error("{}: expected a checkpoint of fastscene splat, found another file", file);
    if (bytes.size() < kMagic.size() + kHashChars ||
        Hash().add(bytes.substr(0, bytes.size() - kHashChars)).hex() != bytes.substr(bytes.size() - kHashChars))
        throw Error("{}: the checkpoint is damaged (its {} bytes do not match their hash)", file, bytes.size());
    bytes.remove_suffix(kHashChars);
    bytes.remove_prefix(kMagic.size());
    const std::string_view found = bytes.substr(0, bytes.find('\n'));
    if (found != key) throw Error("{}: expected a checkpoint of the same views and settings (key {}), found key {}", file, key, found);
    bytes.remove_prefix(found.size() + 1);
    In in{bytes, file};
    TrainState state{0, Cloud(Splats{}, true), 0, 0, 0, {}, {}};
    everything(in, state);
    return state;
}

}  // namespace fastscene::splat
