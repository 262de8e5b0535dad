#include "fastscene/splat/train_state.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"

namespace fastscene::splat {
namespace {

constexpr std::string_view kMagic = "fastscene splat checkpoint 2\n";
constexpr std::size_t kHashChars = 32;

// Serialization described once for both directions: Out writes, In reads. Streamed, since a second copy of the state
// may not fit in memory. All bytes are hashed; a checkpoint ends with the hash.
struct Out {
    std::ofstream file;
    Hash hash;
    void raw(void* data, std::size_t size) {
        hash.add_bytes(data, size);
        file.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
    }
    std::uint64_t size_of(std::uint64_t n, std::size_t) { return raw(&n, sizeof n), n; }
};
struct In {
    std::ifstream file;
    const std::string& name;
    std::uint64_t left;  // bytes before the hash
    Hash hash;
    void raw(void* data, std::size_t size) {
        if (size > left || !file.read(static_cast<char*>(data), static_cast<std::streamsize>(size)))
            throw Error("{}: expected {} more bytes of a checkpoint, found {}", name, size, left);
        left -= size;
        hash.add_bytes(data, size);
    }
    std::uint64_t size_of(std::uint64_t, std::size_t item) {
        std::uint64_t n = 0;
        raw(&n, sizeof n);
        if (n > left / item) throw Error("{}: expected {} numbers of a checkpoint, found {} bytes", name, n, left);
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
    for (AlignedFloats* v : {&c.parameters, &c.first_moment, &c.second_moment, &c.seen_weight, &c.seen_error,
                             &c.seen_move, &c.seen_steps, &c.rest, &c.rest_first_moment, &c.rest_second_moment})
        list(s, *v);
}

}  // namespace

void save_checkpoint(const std::string& file, TrainState& state, std::string_view key) {
    write_renamed(file, [&](const std::filesystem::path& temporary) {
        errno = 0;
        Out out{std::ofstream(temporary, std::ios::binary), {}};
        out.file << kMagic << key << '\n';
        everything(out, state);
        out.file << out.hash.hex();
        out.file.close();
        if (!out.file)
            throw Error("{}: cannot be written: {}", file, errno ? std::strerror(errno) : "the disk may be full");
    });
}

bool has_checkpoint_key(const std::string& file, std::string_view key) {
    const std::string wanted = fmt::format("{}{}\n", kMagic, key);
    std::string found(wanted.size(), '\0');
    std::ifstream in(file, std::ios::binary);
    return in.read(found.data(), static_cast<std::streamsize>(found.size())) && found == wanted;
}

TrainState load_checkpoint(const std::string& file, std::string_view key) {
    In in{std::ifstream(file, std::ios::binary), file, 0, {}};
    std::string magic(kMagic.size(), '\0'), found;
    if (!in.file.read(magic.data(), static_cast<std::streamsize>(magic.size())) || magic != kMagic)
        throw Error("{}: expected a checkpoint of fastscene splat, found another file", file);
    found.resize(key.size() + 1);
    in.file.read(found.data(), static_cast<std::streamsize>(found.size()));
    if (!in.file || found.back() != '\n')
        throw Error("{}: the checkpoint is damaged: it ends in its first lines", file);
    found.pop_back();
    if (found != key)
        throw Error("{}: expected a checkpoint of the same views and settings (key {}), found key {}", file, key,
                    found);
    const std::uint64_t size = std::filesystem::file_size(file), head = kMagic.size() + key.size() + 1;
    if (size < head + kHashChars) throw Error("{}: the checkpoint is damaged: it ends after {} bytes", file, size);
    in.left = size - head - kHashChars;
    TrainState state{0, Cloud(Splats{}, true), 0, 0, 0, {}, {}};
    everything(in, state);
    std::string seal(kHashChars, '\0');
    in.file.read(seal.data(), static_cast<std::streamsize>(seal.size()));
    if (in.left != 0 || !in.file || seal != in.hash.hex())
        throw Error("{}: the checkpoint is damaged (its {} bytes do not match their hash)", file, size);
    return state;
}

}  // namespace fastscene::splat
