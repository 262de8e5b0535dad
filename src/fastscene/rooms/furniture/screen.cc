#include "fastscene/rooms/furniture/screen.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "fastscene/image/color.h"
#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/texture_image.h"

namespace fastscene::furniture {
namespace {

constexpr Vec3f kScreenGlass{0.03f, 0.03f, 0.032f};
constexpr float kScreenRoughness = 0.15f;
constexpr float kDarkest = 0.004f;  // of what is shown: black pixels of a display let some light through

std::shared_ptr<const TextureImage> shown_picture(ImageColor image) {
    for (Vec3f& c : image.pixels)
        for (std::size_t a = 0; a < 3; ++a) c[a] = std::clamp(c[a], kDarkest, 1.f);
    return texture_image(srgb8_from_linear(image));
}

// Each is drawn once.
std::shared_ptr<const TextureImage> shown_picture(Shown shown, int variant) {
    static std::mutex mutex;
    static std::map<std::pair<Shown, int>, std::shared_ptr<const TextureImage>> known;
    const std::lock_guard lock(mutex);
    std::shared_ptr<const TextureImage>& picture = known[{shown, variant}];
    if (picture) return picture;
    const ScreenStyle& s = screens::screen_styles()[static_cast<std::size_t>(shown)];
    ImageColor image(s.width, s.height);
    Patch patch(image, 0, 0, s.width, s.height);
    Random rng(static_cast<std::uint64_t>(variant), s.name);
    s.draw(patch, rng, variant);
    return picture = shown_picture(std::move(image));
}

int screen_material(Kit& k, const char* name, std::shared_ptr<const TextureImage> picture, Vec3f white, float width_m) {
    Material m = plain(name, kScreenGlass, kScreenRoughness);
    m.pattern = Pattern::screen;
    m.emission = white;
    m.image = std::move(picture);
    m.scale_m = width_m;
    return k.material(std::move(m));
}

}  // namespace

int lit_screen(Kit& k, Shown shown, Vec3f white, float width_m) {
    const ScreenStyle& s = screens::screen_styles()[static_cast<std::size_t>(shown)];
    return screen_material(k, s.name, shown_picture(shown, k.rng.index(s.variants)), white, width_m);
}

int lit_picture(Kit& k, const ImageColor& picture, Vec3f white, float width_m) {
    return screen_material(k, "lit picture", shown_picture(picture), white, width_m);
}

Mesh screen_box(Vec3f size) {
    constexpr float kInset = 0.001f;  // pictures repeat: not quite to the edge, where the other one would shine through
    return printed_box({{kInset, kInset}, {1 - kInset, 1 - kInset}}, size);
}

}  // namespace fastscene::furniture
