#include "fastscene/io/splat_io.h"

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/glb.h"
#include "fastscene/io/ply.h"
#include "fastscene/io/splat_frames.h"
#include "fastscene/io/spz.h"

namespace fastscene {
namespace fs = std::filesystem;

std::optional<SplatFormat> splat_format_of_name(const fs::path& path) {
    std::string name = path.filename().string();
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (name.ends_with(".compressed.ply")) return SplatFormat::compressed_ply;
    if (name.ends_with(".ply")) return SplatFormat::ply;
    if (name.ends_with(".spz")) return SplatFormat::spz;
    if (name.ends_with(".glb")) return SplatFormat::glb;
    return {};
}

Mat3d file_from_world(SplatFormat format) {
    return format == SplatFormat::spz ? kSpzFromWorld : format == SplatFormat::glb ? kGltfFromWorld : Mat3d{};
}

namespace {

// Adds the file's name to the error about positions beyond SPZ's range.
std::string spz_bytes_for(const fs::path& path, const Splats& splats, int version) {
    try {
        return spz_bytes(splats, version);
    } catch (const Error& e) {
        throw Error("{}: {}", path.string(), e.what());
    }
}

Splats read_any(const fs::path& path, SplatFormat& format) {
    const std::string bytes = read_file(path);
    if (is_glb(bytes)) return format = SplatFormat::glb, splats_of_glb(path, bytes);
    if (is_spz(bytes)) return format = SplatFormat::spz, splats_of_spz(path, bytes);
    if (!bytes.starts_with("ply"))
        throw Error("{}: expected splats as PLY, compressed PLY, SPZ or GLB, found {}", path.string(),
                    bytes.empty() ? "an empty file" : "something else");
    const Ply ply(path);
    if (is_compressed_ply(ply)) return format = SplatFormat::compressed_ply, splats_of_compressed_ply(ply);
    return format = SplatFormat::ply, splats_of_ply(ply);
}

}  // namespace

LoadedSplats load_splats(const fs::path& path) {
    LoadedSplats loaded;
    loaded.splats = read_any(path, loaded.format);
    loaded.cleaned = clean(loaded.splats);
    trim_sh(loaded.splats);
    return loaded;
}

Splats load_splat_ply(const fs::path& path) {
    const Ply ply(path);
    Splats splats = is_compressed_ply(ply) ? splats_of_compressed_ply(ply) : splats_of_ply(ply);
    clean(splats);
    trim_sh(splats);
    return splats;
}

void save_splats(const fs::path& path, const Splats& splats, SplatFormat format, const SplatWriting& writing) {
    switch (format) {
        case SplatFormat::ply: return save_splat_ply(path, splats, writing.ply_bands);
        case SplatFormat::compressed_ply: return save_compressed_ply(path, splats);
        case SplatFormat::spz: return write_file(path, spz_bytes_for(path, splats, writing.spz_version));
        case SplatFormat::glb:
            if (splats.size() == 0)
                throw Error("{}: expected splats to write, found none: glTF cannot hold zero", path.string());
            return write_file(path, splat_glb_bytes(splats));
    }
}

}  // namespace fastscene
