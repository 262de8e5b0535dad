#include "fastscene/inpaint/train.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/image/color.h"
#include "fastscene/inpaint/harmonic.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr int kTries = 200;  // attempts after which an example must have been found
constexpr int kCropTries = 10;
constexpr double kLeastOpen = 0.002;  // minimum share of hole pixels in a crop

struct Square {
    ImageRgb8 truth;
    ImageMask hole;
};

double share_of(const ImageMask& hole) {
    return static_cast<double>(
               std::count_if(hole.pixels.begin(), hole.pixels.end(), [](std::uint8_t v) { return v != 0; })) /
           static_cast<double>(hole.size());
}

Square cut(const ImageRgb8& image, const ImageMask& mask, int left, int top, int size, bool flip) {
    Square out{ImageRgb8(size, size), ImageMask(size, size)};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const int from = left + (flip ? size - 1 - x : x);
            out.truth.at(x, y) = image.at(from, top + y);
            out.hole.at(x, y) = mask.at(from, top + y);
        }
    return out;
}

// Downsamples by 2: mean colors; a hole wherever there was one.
void shrink(ImageRgb8& image, ImageMask& mask) {
    const ImageRgb8 large = std::move(image);
    const ImageMask torn = std::move(mask);
    image = ImageRgb8(large.width / 2, large.height / 2);
    mask = ImageMask(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            int r = 2, g = 2, b = 2;  // rounds to nearest
            for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
                const Rgb8 c = large.at(2 * x + i, 2 * y + j);
                r += c.r, g += c.g, b += c.b;
                mask.at(x, y) |= torn.at(2 * x + i, 2 * y + j);
            }
            image.at(x, y) = {static_cast<std::uint8_t>(r / 4), static_cast<std::uint8_t>(g / 4),
                              static_cast<std::uint8_t>(b / 4)};
        }
}

// A crop that contains holes, but not only. For training: the one with the most hole pixels of several, since most of a
// face is known.
std::optional<Square> crop_with_hole(const ImageRgb8& image, const ImageMask& mask, const InpaintTrainParams& params,
                                     bool still, Random& rng) {
    std::optional<Square> best;
    double most = 0;
    for (int i = 0; i < kCropTries; ++i) {
        const int left = rng.index(image.width - params.size + 1), top = rng.index(image.height - params.size + 1);
        Square square = cut(image, mask, left, top, params.size, !still && rng.chance(0.5f));
        const double open = share_of(square.hole);
        if (open < std::max(most, kLeastOpen) || open > params.most_open) continue;
        most = open;
        best = std::move(square);
        if (still) break;
    }
    return best;
}

// Color jitter: simulates another camera.
void jitter_colors(ImageRgb8& image, float strength, Random& rng) {
    const float bright = 1 + strength * rng.uniform(-1, 1), contrast = 1 + strength * rng.uniform(-1, 1);
    const Vec3f balance{1 + strength * rng.uniform(-1, 1), 1 + strength * rng.uniform(-1, 1),
                        1 + strength * rng.uniform(-1, 1)};
    std::array<std::array<std::uint8_t, 256>, 3> table{};
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t v = 0; v < 256; ++v)
            table[c][v] = byte_from_unit(((static_cast<float>(v) / 255.f - 0.5f) * contrast + 0.5f) * bright *
                                         balance[c]);
    for (Rgb8& p : image.pixels) p = {table[0][p.r], table[1][p.g], table[2][p.b]};
}

InpaintExample with_fill(Square square, bool harmonic) {
    InpaintExample out{std::move(square.truth), std::move(square.hole), {}};
    if (!harmonic) return out;
    out.filled = ImageColor(out.truth.width, out.truth.height);
    for (std::size_t i = 0; i < out.truth.size(); ++i) {
        const Rgb8 c = out.truth.pixels[i];
        out.filled.pixels[i] = Vec3f{static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)} *
                               (1 / 255.f);
    }
    out.filled = HarmonicInpainter{}.fill(out.filled, out.hole, {});
    return out;
}

const fs::path& one_of(const std::vector<fs::path>& paths, Random& rng) {
    return paths[static_cast<std::size_t>(rng.index(static_cast<int>(paths.size())))];
}

void add_holes(ImageMask& mask, const fs::path& path) {
    const ImageMask more = load_mask_png(path);
    if (!more.same_size(mask))
        throw Error("{}: expected the size of its picture, {} x {}, found {} x {}", path.string(), mask.width,
                    mask.height, more.width, more.height);
    for (std::size_t i = 0; i < mask.size(); ++i) mask.pixels[i] = mask.pixels[i] || more.pixels[i] ? 255 : 0;
}

std::optional<InpaintExample> try_example(const HoleSet& set, const InpaintTrainParams& params, bool still,
                                          Random& rng) {
    const auto any_face = [&]() -> const HoleSet::Face& {
        return set.faces[static_cast<std::size_t>(rng.index(static_cast<int>(set.faces.size())))];
    };
    const HoleSet::Face& face = any_face();
    ImageRgb8 image = load_rgb8(face.image);
    ImageMask mask(image.width, image.height);
    add_holes(mask, one_of(face.masks, rng));
    if (!still && rng.chance(static_cast<float>(params.strange_masks))) add_holes(mask, one_of(any_face().masks, rng));
    if (!still && std::min(image.width, image.height) >= 2 * params.size &&
        rng.chance(static_cast<float>(params.shrunk)))
        shrink(image, mask);
    if (image.width < params.size || image.height < params.size)
        throw UsageError("--size: expected at most the side of {}, {}, found {}", face.image.string(),
                         std::min(image.width, image.height), params.size);
    std::optional<Square> square = crop_with_hole(image, mask, params, still, rng);
    if (!square) return {};
    if (!still) jitter_colors(square->truth, static_cast<float>(params.jitter), rng);
    return with_fill(std::move(*square), params.network.holes == "harmonic");
}

// With a handful of panoramas none may be held out: then metrics are computed on training pictures, with a warning.
HoleSet held_out_of(const fs::path& data, const HoleSet& train, const Run& run) {
    if (fs::exists(data / "held-out")) return find_holes(data / "held-out");
    run.warn(
        fmt::format("{}: expected held-out faces, found none (inpaint dataset --held-out PERCENT, of more places): the "
                    "figures are of faces that are "
                    "trained on",
                    (data / "held-out").string()));
    return train;
}

}  // namespace

HoleSet find_holes(const fs::path& part) {
    if (!fs::is_directory(part / "images") || !fs::is_directory(part / "masks"))
        throw UsageError(
            "{}: expected a folder with images/ and masks/, as `fastscene inpaint dataset` makes it, found none",
            part.string());
    std::map<std::string, HoleSet::Face> by_name;  // "shard-00000/00000042-front"
    const auto name_in = [](const fs::path& path, const fs::path& root) {
        return (fs::relative(path.parent_path(), root) / path.stem()).string();
    };
    for (const auto& entry : fs::recursive_directory_iterator(part / "images"))
        if (entry.is_regular_file()) by_name[name_in(entry.path(), part / "images")].image = entry.path();
    for (const auto& entry : fs::recursive_directory_iterator(part / "masks")) {
        const std::string name = name_in(entry.path(), part / "masks");
        const auto face = by_name.find(name.substr(0, name.rfind('-')));
        if (entry.is_regular_file() && face != by_name.end()) face->second.masks.push_back(entry.path());
    }
    HoleSet set;
    for (auto& [name, face] : by_name) {
        std::sort(face.masks.begin(), face.masks.end());
        if (!face.masks.empty()) set.faces.push_back(std::move(face));
    }
    if (set.faces.empty())
        throw UsageError("{}: expected faces (images/NAME.png) with masks (masks/NAME-00.png), found none",
                         part.string());
    return set;
}

InpaintExample draw_example(const HoleSet& set, const InpaintTrainParams& params, bool still, Random& rng,
                            std::atomic<std::int64_t>& broken) {
    std::string last;
    for (int i = 0; i < kTries; ++i) {
        try {
            if (auto example = try_example(set, params, still, rng)) return std::move(*example);
        } catch (const UsageError&) {
            throw;
        } catch (const Error& e) {
            ++broken;
            last = e.what();
        }
    }
    throw Error("inpaint train: expected faces of which {:.1f} to {:.0f} % is holes, found none in {} tries{}",
                100 * kLeastOpen, 100 * params.most_open, kTries, last.empty() ? "" : "; the last trouble: " + last);
}

std::vector<std::pair<std::string, double>> train_inpainter(const fs::path& data, const InpaintTrainParams& params,
                                                            const fs::path& folder, const Run& run) {
    if (params.size % 8 != 0) throw UsageError("--size: expected a multiple of 8, found {}", params.size);
    if (fs::exists(data / "held-out") && !fs::exists(data / "train"))
        throw UsageError(
            "{}: expected faces to train on, found held-out ones only: `fastscene inpaint dataset` with more places, "
            "or less --held-out",
            data.string());
    const HoleSet train = find_holes(data / "train"), held_out = held_out_of(data, train, run);
    std::atomic<std::int64_t> broken{0};
    InpaintExamples examples;
    examples.draw = [&](Random& rng) { return draw_example(train, params, false, rng, broken); };
    for (int i = 0; i < params.held_out; ++i) {
        Random rng(0, "held-out example", static_cast<std::uint64_t>(i));
        examples.held_out.push_back(draw_example(held_out, params, true, rng, broken));
    }

    examples.about = {{"size", params.size},
                      {"strange-masks", params.strange_masks},
                      {"shrunk", params.shrunk},
                      {"most-open", params.most_open},
                      {"jitter", params.jitter}};
    const auto figures = train_aotgan(params.network, examples, folder, run);
    if (broken > 0) run.warn(fmt::format("{} reads of broken pictures or masks were passed over", broken.load()));
    return figures;
}

}  // namespace fastscene
