#include <cmath>
#include <map>
#include <optional>

#include "fastscene/base/writable.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/flags.h"
#include "fastscene/cli/verb.h"
#include "fastscene/pipeline/splat_files.h"

namespace fastscene::cli {
namespace {

namespace fs = std::filesystem;

struct Flags {
    std::string from, to, up, from_up, handed = "right";
    std::vector<float> crop, translate{0, 0, 0};
    std::optional<std::int64_t> max_splats;
    int sh_degree = 3, spz_version = 3;
    float scale = 1, min_opacity = 0;
    bool compact = false, local = false;
};

// Axes whose `up` axis points up and, if that is level, whose other axes are customary for it: y: x right, z back
// (OpenGL); left-handed z forward (Unity). z: x right, y forward (Blender); left-handed x forward, y right (Unreal).
Mat3d numbers_from_world(const std::string& up, bool left_handed) {
    if (up == "y") return {{1, 0, 0}, {0, -1, 0}, {0, 0, left_handed ? 1.0 : -1.0}};
    if (up == "z")
        return left_handed ? Mat3d{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}} : Mat3d{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    return {{1, 0, 0}, {0, 1, 0}, {0, 0, left_handed ? -1.0 : 1.0}};
}

// Which axis of a format's numbers points up, as --up says it: "y in .glb or .spz".
std::string own_up_axes() {
    std::map<std::string, std::vector<std::string>> formats;
    for (const SplatFormat& format : registered<SplatFormat>()) {
        const Vec3d up = format.file_from_world * Vec3d{0, -1, 0};
        for (std::size_t a = 0; a < 3; ++a)
            if (up[a] != 0) formats[fmt::format("{}{}", up[a] < 0 ? "-" : "", "xyz"[a])].push_back(format.ending);
    }
    std::string text;
    for (const auto& [axis, endings] : formats)
        text += fmt::format("{}{} in {}", text.empty() ? "" : "; ", axis, any_of(endings));
    return text;
}

// Warns of what the format cannot store.
void warn_of_losses(const std::string& to, const Splats& splats, const Run& run) {
    const SplatFormat& format = *splat_format_of_name(to);
    if (splats.sh_degree > format.sh_degree)
        run.warn(fmt::format("{}: {} stores spherical harmonics up to degree {}: those of degree {} are left out", to,
                             format.ending, format.sh_degree, splats.sh_degree));
    if (splats.filter.antialias && !format.antialias)
        run.warn(fmt::format("{}: {} cannot store that these splats are antialiased: small ones will look too bright",
                             to, format.ending));
    const float usual = FootprintFilter{}.low_pass_px2;
    if (splats.filter.low_pass_px2 != usual && !format.low_pass)
        run.warn(fmt::format(
            "{}: {} cannot store the low-pass of {} square pixels that these splats were trained with: render and "
            "metrics will draw them with {}, blurred",
            to, format.ending, splats.filter.low_pass_px2, usual));
}

// What georeferenced splats lie around, if the file can hold it.
Vec3d offset_to_write(const Flags& flags, Vec3d offset, const Run& run) {
    if (offset == Vec3d{} || flags.local) return {};
    const SplatFormat& format = *splat_format_of_name(flags.to);
    if (format.offset) return offset;
    run.warn(
        fmt::format("{}: {} cannot hold positions far from the origin: they are relative to ({:.0f}, {:.0f}, {:.0f})",
                    flags.to, format.ending, offset.x, offset.y, offset.z));
    return {};
}

// The transform of the world that makes the file's coordinates as requested.
Similarity world_for(const fs::path& file, const std::string& up, bool left_handed) {
    if (up.empty()) return {};
    const SplatFormat* format = splat_format_of_name(file);
    return {transpose(format ? format->file_from_world : Mat3d{}) * numbers_from_world(up, left_handed), 1, {}};
}

void check(const Flags& flags) {
    if (!splat_format_of_name(flags.to))
        throw UsageError("{}: expected a name that ends in {}", flags.to, splat_endings());
    if (!(flags.scale > 0 && flags.scale < 1e6f))
        throw UsageError("--scale: expected a number above 0 and below a million, found {}", flags.scale);
    if (!(flags.min_opacity >= 0 && flags.min_opacity <= 1))
        throw UsageError("--min-opacity: expected 0 to 1, found {}", flags.min_opacity);
    if (flags.max_splats && *flags.max_splats < 1)
        throw UsageError("--max-splats: expected 1 or more, found {}", *flags.max_splats);
    for (const float v : flags.translate)
        if (!(std::abs(v) < 1e6f))
            throw UsageError("--translate: expected three numbers within a million metres, found {}", v);
    if (flags.handed == "left" && flags.up.empty())
        throw UsageError("--handed left: expected together with --up y, z or -y");
    for (std::size_t a = 0; a < 3 && !flags.crop.empty(); ++a)
        if (!(flags.crop[a] < flags.crop[a + 3]))
            throw UsageError("--crop: expected the low corner, then the high one, found {} and {}", flags.crop[a],
                             flags.crop[a + 3]);
}

// Refuses to overwrite the splats of a run, which its other files and its resuming depend on, and the source file.
void check_target(const Flags& flags) {
    const fs::path from = scene_file(flags.from), to = flags.to;
    std::error_code absent;
    if (fs::equivalent(from, to, absent))
        throw UsageError("{}: expected an output file different from the input, found the same", flags.to);
    if (fs::exists(to) && fs::exists(to.parent_path() / "stage.json"))
        throw UsageError("{}: expected a file of your own, found one that belongs to a run; choose another name",
                         flags.to);
    check_writable(to);
}

void convert(const Flags& flags, const Session& session) {
    check(flags);
    check_target(flags);
    const Run run = session.run(0);
    Progress progress(run, "convert", 3);
    LoadedSplats loaded = load_scene(flags.from, run);
    Splats splats = std::move(loaded.splats);
    const std::size_t found = splats.size() + loaded.cleaned.dropped;
    progress.advance();
    const Similarity as_read = inverse(world_for(scene_file(flags.from), flags.from_up, false));
    transform(splats, as_read);
    if (flags.min_opacity > 0) splats = opaque(splats, flags.min_opacity);
    if (!flags.crop.empty())
        splats = cropped(splats, {flags.crop[0], flags.crop[1], flags.crop[2]},
                         {flags.crop[3], flags.crop[4], flags.crop[5]});
    if (flags.max_splats) splats = strongest(splats, static_cast<std::size_t>(*flags.max_splats));
    reduce_sh(splats, flags.sh_degree);
    if (splats.size() == 0 && found > 0)
        throw Error("{}: none of {} splats remain; nothing was written", flags.from, found);
    if (found == 0) run.warn(fmt::format("{}: has no splats", flags.from));
    const Vec3d move{flags.translate[0], flags.translate[1], flags.translate[2]};
    const Similarity as_written = compose(world_for(flags.to, flags.up, flags.handed == "left"),
                                          {{}, flags.scale, move});
    transform(splats, as_written);
    const Similarity both = compose(as_written, as_read);
    const Vec3d offset = offset_to_write(flags, (both.new_from_old * loaded.offset_m) * both.scale, run);
    progress.advance();
    run.check_stop();
    warn_of_losses(flags.to, splats, run);
    save_splats(flags.to, splats, {flags.compact ? PlyBands::present : PlyBands::all, flags.spz_version, offset});
    progress.advance();
    const auto bytes = fs::file_size(flags.to);
    run.note(fmt::format("{} of {} splats, spherical harmonics of degree {}, {:.2f} MB", splats.size(), found,
                         splats.sh_degree, static_cast<double>(bytes) / 1e6));
    session.print(flags.to, {{"file", flags.to},
                             {"splats", splats.size()},
                             {"splats_read", found},
                             {"sh_degree", splats.sh_degree},
                             {"bytes", bytes}});
}

}  // namespace

Verb add_convert(CLI::App& app) {
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand("convert",
                                        fmt::format("Converts splats between file formats: {}.", splat_endings()));
    verb->add_option("from", flags->from, "Splat file, or folder of a run.")->type_name("FILE|DIR")->required();
    verb->add_option("to", flags->to, "File to write; its extension selects the format.")
        ->type_name("FILE")
        ->required();
    const auto axes = one_of({"y", "z", "-y"});
    verb->add_option("--up", flags->up,
                     fmt::format("Up axis of the output coordinates; default: the format's own ({}).", own_up_axes()))
        ->type_name("y|z|-y")
        ->check(axes);
    verb->add_option("--from-up", flags->from_up,
                     "Up axis of the input coordinates, if the file deviates from its format's own.")
        ->type_name("y|z|-y")
        ->check(axes);
    verb->add_option("--handed", flags->handed,
                     "With --up: right-handed or left-handed coordinates (left: Unity with y, Unreal with z).")
        ->type_name("right|left")
        ->check(one_of({"right", "left"}))
        ->capture_default_str();
    verb->add_option("--scale", flags->scale, "Scale by this factor (100: centimetres).")
        ->type_name("X")
        ->capture_default_str();
    verb->add_option("--translate", flags->translate, "Translate, after --scale: right, down, forward.")
        ->type_name("X Y Z")
        ->expected(3)
        ->default_str("0 0 0");
    verb->add_option("--crop", flags->crop,
                     "Keep splats inside a box: its minimum corner (right, down, forward), then its maximum corner.")
        ->type_name("X Y Z X Y Z")
        ->expected(6);
    verb->add_option("--max-splats", flags->max_splats, "Keep the N splats with the largest coverage.")->type_name("N");
    verb->add_option("--min-opacity", flags->min_opacity, "Drop splats with a lower opacity.")
        ->type_name("X")
        ->capture_default_str();
    verb->add_option("--sh-degree", flags->sh_degree, "Drop spherical harmonics above this degree.")
        ->type_name("N")
        ->check(whole_number_within(0, 3))
        ->capture_default_str();
    verb->add_option("--spz-version", flags->spz_version, "2 for old readers, 3, or 4 (smaller, newest readers).")
        ->type_name("N")
        ->check(whole_number_within(2, 4))
        ->capture_default_str();
    verb->add_flag("--compact", flags->compact,
                   "PLY: only the existing SH degrees, instead of always 62 floats per splat.");
    verb->add_flag("--local", flags->local,
                   "Georeferenced splats: omit the offset that was subtracted from their positions, instead of "
                   "adding it back (PLY: as doubles; GLB: in the node).");
    verb->footer("Example:\n  fastscene convert out/bedroom bedroom.spz --max-splats 100000");
    return {verb, [flags](const Session& session) { convert(*flags, session); }};
}

}  // namespace fastscene::cli
