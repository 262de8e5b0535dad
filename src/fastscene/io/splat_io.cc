#include "fastscene/io/splat_io.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/ply.h"

namespace fastscene {
namespace fs = std::filesystem;

float low_pass_px2_from(double recorded) {
    const bool sensible = recorded >= kLeastLowPassPx2 && recorded <= kMostLowPassPx2;
    return sensible ? static_cast<float>(recorded) : FootprintFilter{}.low_pass_px2;
}

const SplatFormat* splat_format_of_name(const fs::path& path) {
    std::string name = path.filename().string();
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const SplatFormat* found = nullptr;
    for (const SplatFormat& format : registered<SplatFormat>())
        if (name.ends_with(format.ending) && (!found || format.ending.size() > found->ending.size())) found = &format;
    return found;
}

std::string splat_endings() {
    std::vector<std::string> endings;
    for (const SplatFormat& format : registered<SplatFormat>()) endings.push_back(format.ending);
    return any_of(endings);
}

std::string axes_in_words(const Mat3d& file_from_world) {
    // The world's axes point right, down and forward.
    constexpr const char* kWays[3][2] = {{"right", "left"}, {"down", "up"}, {"forward", "back"}};
    std::string text;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t way = 0; way < 3; ++way)
            if (const double v = file_from_world.column(way)[axis]; v != 0)
                text += fmt::format("{}{} {}", axis ? ", " : "", "xyz"[axis], kWays[way][v < 0]);
    return text;
}

Vec3d offset_for(Vec3d middle_m) {
    if (!(length(middle_m) > kFarFromOrigin_m)) return {};
    constexpr double kKilometre = 1000;
    const auto whole = [](double v) { return std::round(v / kKilometre) * kKilometre; };
    return {whole(middle_m.x), whole(middle_m.y), whole(middle_m.z)};
}

namespace {

// The first format that knows the bytes as its own; else the one of the name, if it has no signature.
const SplatFormat& format_of_file(const fs::path& path, std::string_view bytes) {
    for (const SplatFormat& format : registered<SplatFormat>())
        if (format.recognizes && format.recognizes(bytes)) return format;
    const SplatFormat* named = splat_format_of_name(path);
    if (named && !named->recognizes) return *named;
    const std::string expected = named ? named->about : "splats as " + any_of(registered_names<SplatFormat>());
    throw Error("{}: expected {}, found {}", path.string(), expected,
                bytes.empty() ? "an empty file" : "something else");
}

bool is_finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_finite(const fs::path& path, const Splats& s) {
    const auto rest = static_cast<std::size_t>(3 * s.rest_coefficients());
    for (std::size_t i = 0; i < s.size(); ++i) {
        const Quatf q = s.rotation[i];
        const auto* first = s.sh_rest.data() + i * rest;
        if (!is_finite(s.mean_m[i]) || !is_finite(s.log_scale[i]) || !is_finite(s.sh0[i]) ||
            !is_finite({q.x, q.y, q.z}) || !std::isfinite(q.w) || !std::isfinite(s.opacity_logit[i]) ||
            !std::all_of(first, first + rest, [](float v) { return std::isfinite(v); }))
            throw Error("{}: expected finite numbers to write, found NaN or infinity in splat {} of {}", path.string(),
                        i, s.size());
    }
}

std::string bytes_of(const SplatFormat& format, const Splats& splats, const SplatWriting& writing) {
    if (splats.sh_degree <= format.sh_degree) return format.write(splats, writing);
    Splats fewer = splats;
    reduce_sh(fewer, format.sh_degree);
    return format.write(fewer, writing);
}

}  // namespace

LoadedSplats load_splats(const fs::path& path) {
    LoadedSplats loaded;
    const std::string bytes = read_file(path);
    loaded.format = &format_of_file(path, bytes);
    ReadSplats read = loaded.format->read(path, bytes);
    loaded.splats = std::move(read.splats);
    loaded.warnings = std::move(read.warnings);
    loaded.offset_m = read.offset_m;
    loaded.cleaned = clean(loaded.splats);
    trim_sh(loaded.splats);
    return loaded;
}

Splats load_splat_ply(const fs::path& path) {
    const Ply ply(path);
    Splats splats = is_compressed_ply(ply) ? splats_of_compressed_ply(ply) : splats_of_ply(ply).splats;
    clean(splats);
    trim_sh(splats);
    return splats;
}

void save_splats(const fs::path& path, const Splats& splats, const SplatWriting& writing) {
    const SplatFormat* format = splat_format_of_name(path);
    if (!format) throw UsageError("{}: expected a name that ends in {}", path.string(), splat_endings());
    if (splats.size() == 0 && !format->empty)
        throw Error("{}: expected splats to write, found none, which {} cannot hold", path.string(), format->ending);
    check_finite(path, splats);
    std::string bytes;
    try {
        bytes = bytes_of(*format, splats, writing);
    } catch (const Error& e) {  // writers do not know the file
        throw Error("{}: {}", path.string(), e.what());
    }
    write_file(path, bytes);
}

}  // namespace fastscene
