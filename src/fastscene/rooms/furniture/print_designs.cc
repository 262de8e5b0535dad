// Designs of what shops sell and shelves hold: bindings, covers, packets, labels.
#include "fastscene/rooms/furniture/print_designs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fastscene::furniture {

Vec3f varied(Random& rng, Vec3f c) {
    const float by = rng.uniform(0.8f, 1.2f);
    return {std::min(0.8f, c.x * by), std::min(0.8f, c.y * by), std::min(0.8f, c.z * by)};
}
Vec3f contrasting(Random& rng, Colors inks, Vec3f ground) {
    Vec3f best = inks[0];
    float most = -1;
    for (int i = 0; i < 3; ++i) {
        const Vec3f c = one_of(rng, inks);
        const float apart = std::abs(std::sqrt(luminance(c)) - std::sqrt(luminance(ground)));
        if (apart > most) most = apart, best = c;
    }
    if (most < 0.25f) return luminance(ground) > 0.25f ? kPrintBlack : kPrintWhite;
    return best;
}

void small_print(Patch& p, Random& rng, Vec2f low, Vec2f high, float line, Vec3f ink) {
    for (float y = high.y - line; y > low.y; y -= 2.f * line)
        p.fill({low.x, y}, {low.x + (high.x - low.x) * rng.uniform(0.6f, 1.f), y + 0.8f * line}, ink, 0.7f);
}

Vec2f spot(const Patch& p, float x, float y) { return {x * p.w, y * p.h}; }

void fade(Patch& p, Vec2f low, Vec2f high, Vec3f below, Vec3f above) {
    for (float y = low.y; y < high.y; y += 1)
        p.fill({low.x, y}, {high.x, y + 1}, lerp(below, above, (y - low.y) / (high.y - low.y)));
}

void person(Patch& p, Vec2f feet, float tall, float stride, Vec3f ink) {
    const float head = 0.07f * tall, limb = 0.075f * tall;
    const Vec2f hip = feet + Vec2f{0, 0.47f * tall}, neck = hip + Vec2f{0.09f * stride * tall, 0.36f * tall},
                knee = hip + Vec2f{0.16f * stride * tall, -0.2f * tall};
    p.disc(neck + Vec2f{0.03f * stride * tall, 0.1f * tall}, {head, 1.2f * head}, ink);
    p.line(neck, hip, 2.1f * limb, ink);
    p.line(hip, knee, 1.2f * limb, ink), p.line(knee, knee + Vec2f{-0.04f * stride * tall, -0.26f * tall}, limb, ink);
    const Vec2f back = hip + Vec2f{(-0.14f * stride - 0.03f) * tall, -0.22f * tall};
    p.line(hip, back, 1.2f * limb, ink), p.line(back, back + Vec2f{-0.12f * stride * tall, -0.24f * tall}, limb, ink);
    for (const float side : {-1.f, 1.f}) {
        const Vec2f elbow = neck + Vec2f{side * (0.13f * std::abs(stride) + 0.09f) * tall, -0.16f * tall};
        p.line(neck, elbow, 0.8f * limb, ink);
        p.line(elbow, elbow + Vec2f{0.14f * stride * tall, (stride == 0.f ? -0.16f : side * 0.08f) * tall}, 0.7f * limb,
               ink);
    }
}

void scene(Patch& p, Random& rng, Vec2f low, Vec2f high, Vec3f sky, Vec3f ink, Vec3f light) {
    const float w = high.x - low.x, h = high.y - low.y;
    Vec2f middle = (low + high) * 0.5f;
    p.fill(low, high, sky);
    switch (rng.index(5)) {
        case 0: {  // a landscape
            p.disc(low + Vec2f{rng.uniform(0.25f, 0.75f) * w, 0.66f * h}, {0.14f * w, 0.14f * w}, light);
            for (float x = low.x; x < high.x; x += 1) {
                const float t = (x - low.x) / w * 6.f + rng.uniform(0, 0.02f);
                p.fill({x, low.y}, {x + 1, low.y + h * (0.36f + 0.08f * std::sin(t))}, lerp(sky, ink, 0.5f));
                p.fill({x, low.y}, {x + 1, low.y + h * (0.22f + 0.07f * std::sin(1.7f * t + 2.f))}, ink);
            }
            break;
        }
        case 1:  // a figure
            p.disc(middle + Vec2f{0, 0.12f * h}, {0.11f * w, 0.13f * w}, ink);
            p.disc({middle.x, low.y}, {0.28f * w, 0.46f * h}, ink);
            p.fill({low.x, low.y}, {high.x, low.y + 1}, ink);
            break;
        case 2:  // discs
            for (int i = 0; i < 4; ++i)
                p.disc(middle, Vec2f{0.4f * w, 0.4f * w} * (1.f - 0.24f * static_cast<float>(i)),
                       i % 2 == 0 ? ink : light);
            break;
        case 3:  // a town at night
            for (int i = 0; i < 7; ++i) {
                const float x = low.x + w * static_cast<float>(i) / 7, up = low.y + h * rng.uniform(0.25f, 0.7f);
                p.fill({x, low.y}, {x + w / 7, up}, lerp(ink, sky, rng.uniform(0, 0.4f)));
                for (float y = low.y + 4; y < up - 6; y += 8)
                    if (rng.chance(0.6f)) p.fill({x + 2, y}, {x + 5, y + 4}, light);
            }
            break;
        default:  // bands
            for (int i = 0; i < 6; ++i)
                p.line({low.x, low.y + h * (0.1f + 0.16f * static_cast<float>(i))},
                       {high.x, low.y + h * (0.16f * static_cast<float>(i) + 0.05f)}, rng.uniform(2, 0.1f * h),
                       i % 2 == 0 ? ink : light);
            break;
    }
}

namespace {

// ---- colors: linear albedo. Printed and bound things are duller than one thinks: few exceed 0.6 in one channel.

constexpr Vec3f kGilt{0.5f, 0.36f, 0.13f}, kCream{0.62f, 0.56f, 0.43f};
constexpr std::array<Vec3f, 16> kBindings{
    Vec3f{0.115f, 0.018f, 0.018f}, {0.07f, 0.013f, 0.016f}, {0.022f, 0.05f, 0.03f}, {0.035f, 0.06f, 0.028f},
    {0.018f, 0.03f, 0.065f},       {0.03f, 0.045f, 0.08f},  {0.24f, 0.13f, 0.055f}, {0.16f, 0.075f, 0.03f},
    {0.09f, 0.042f, 0.02f},        {0.06f, 0.032f, 0.018f}, {0.42f, 0.34f, 0.21f},  {0.5f, 0.43f, 0.31f},
    {0.028f, 0.026f, 0.025f},      {0.13f, 0.125f, 0.115f}, {0.2f, 0.07f, 0.03f},   {0.12f, 0.105f, 0.05f}};
constexpr std::array<Vec3f, 16> kJackets{
    Vec3f{0.66f, 0.64f, 0.59f}, {0.72f, 0.71f, 0.68f}, {0.55f, 0.5f, 0.4f},   {0.035f, 0.034f, 0.036f},
    {0.05f, 0.09f, 0.16f},      {0.17f, 0.26f, 0.33f}, {0.36f, 0.06f, 0.04f}, {0.45f, 0.18f, 0.09f},
    {0.5f, 0.34f, 0.1f},        {0.09f, 0.16f, 0.11f}, {0.26f, 0.32f, 0.24f}, {0.07f, 0.2f, 0.21f},
    {0.46f, 0.32f, 0.28f},      {0.22f, 0.21f, 0.2f},  {0.5f, 0.46f, 0.42f},  {0.13f, 0.06f, 0.09f}};
constexpr std::array<Vec3f, 6> kJacketInks{Vec3f{0.72f, 0.7f, 0.66f}, {0.03f, 0.03f, 0.03f}, {0.48f, 0.08f, 0.05f},
                                           {0.55f, 0.4f, 0.14f},      {0.06f, 0.13f, 0.24f}, {0.7f, 0.66f, 0.55f}};
constexpr std::array<Vec3f, 8> kFilms{Vec3f{0.02f, 0.025f, 0.035f}, {0.05f, 0.02f, 0.02f}, {0.03f, 0.05f, 0.09f},
                                      {0.3f, 0.13f, 0.05f},         {0.04f, 0.08f, 0.07f}, {0.4f, 0.3f, 0.18f},
                                      {0.16f, 0.2f, 0.24f},         {0.1f, 0.03f, 0.05f}};
constexpr std::array<Vec3f, 6> kFilmInks{Vec3f{0.72f, 0.7f, 0.64f}, {0.6f, 0.4f, 0.1f},  {0.5f, 0.07f, 0.04f},
                                         {0.2f, 0.4f, 0.5f},        {0.6f, 0.3f, 0.12f}, {0.66f, 0.6f, 0.45f}};
constexpr std::array<Vec3f, 12> kSleeves{Vec3f{0.66f, 0.63f, 0.55f}, {0.04f, 0.04f, 0.045f}, {0.45f, 0.2f, 0.08f},
                                         {0.12f, 0.2f, 0.24f},       {0.32f, 0.07f, 0.05f},  {0.52f, 0.38f, 0.15f},
                                         {0.1f, 0.07f, 0.14f},       {0.2f, 0.28f, 0.2f},    {0.06f, 0.1f, 0.17f},
                                         {0.5f, 0.36f, 0.32f},       {0.24f, 0.22f, 0.2f},   {0.6f, 0.58f, 0.54f}};
constexpr std::array<Vec3f, 10> kGroceries{Vec3f{0.64f, 0.57f, 0.42f}, {0.4f, 0.075f, 0.045f}, {0.15f, 0.25f, 0.09f},
                                           {0.56f, 0.38f, 0.1f},       {0.06f, 0.1f, 0.2f},    {0.4f, 0.27f, 0.15f},
                                           {0.7f, 0.68f, 0.62f},       {0.16f, 0.29f, 0.32f},  {0.5f, 0.22f, 0.07f},
                                           {0.2f, 0.07f, 0.05f}};
constexpr std::array<Vec3f, 5> kGroceryInks{Vec3f{0.72f, 0.69f, 0.6f},
                                            {0.36f, 0.05f, 0.035f},
                                            {0.05f, 0.08f, 0.16f},
                                            {0.1f, 0.2f, 0.06f},
                                            {0.55f, 0.36f, 0.08f}};
constexpr std::array<Vec3f, 6> kPapers{Vec3f{0.66f, 0.6f, 0.47f}, {0.7f, 0.67f, 0.58f}, {0.6f, 0.5f, 0.34f},
                                       {0.7f, 0.69f, 0.66f},      {0.5f, 0.52f, 0.42f}, {0.58f, 0.47f, 0.4f}};
constexpr std::array<Vec3f, 5> kDarkInks{Vec3f{0.05f, 0.04f, 0.035f},
                                         {0.22f, 0.04f, 0.03f},
                                         {0.06f, 0.11f, 0.05f},
                                         {0.05f, 0.07f, 0.14f},
                                         {0.2f, 0.11f, 0.04f}};
constexpr std::array<Vec3f, 6> kDrinks{Vec3f{0.72f, 0.71f, 0.69f}, {0.66f, 0.68f, 0.7f}, {0.6f, 0.36f, 0.1f},
                                       {0.3f, 0.38f, 0.16f},       {0.66f, 0.62f, 0.5f}, {0.5f, 0.16f, 0.1f}};
constexpr std::array<Vec3f, 6> kCoffees{Vec3f{0.36f, 0.24f, 0.13f}, {0.03f, 0.028f, 0.027f}, {0.66f, 0.61f, 0.5f},
                                        {0.09f, 0.13f, 0.12f},      {0.3f, 0.09f, 0.05f},    {0.42f, 0.3f, 0.18f}};
constexpr std::array<Vec3f, 6> kMedicines{Vec3f{0.76f, 0.76f, 0.75f}, {0.74f, 0.75f, 0.76f}, {0.72f, 0.74f, 0.74f},
                                          {0.76f, 0.75f, 0.72f},      {0.75f, 0.76f, 0.74f}, {0.6f, 0.68f, 0.7f}};
constexpr std::array<Vec3f, 6> kMedicineInks{Vec3f{0.04f, 0.2f, 0.36f}, {0.05f, 0.32f, 0.2f}, {0.42f, 0.06f, 0.06f},
                                             {0.1f, 0.34f, 0.4f},       {0.5f, 0.25f, 0.06f}, {0.2f, 0.12f, 0.32f}};
constexpr std::array<Vec3f, 7> kCosmetics{Vec3f{0.7f, 0.67f, 0.64f}, {0.56f, 0.4f, 0.37f}, {0.42f, 0.5f, 0.46f},
                                          {0.03f, 0.03f, 0.032f},    {0.6f, 0.5f, 0.36f},  {0.48f, 0.52f, 0.58f},
                                          {0.72f, 0.71f, 0.7f}};
constexpr std::array<Vec3f, 8> kToys{Vec3f{0.5f, 0.09f, 0.06f}, {0.08f, 0.2f, 0.4f},   {0.6f, 0.43f, 0.1f},
                                     {0.14f, 0.32f, 0.16f},     {0.66f, 0.62f, 0.54f}, {0.42f, 0.2f, 0.3f},
                                     {0.2f, 0.38f, 0.42f},      {0.55f, 0.26f, 0.1f}};
constexpr std::array<Vec3f, 6> kHardware{Vec3f{0.06f, 0.09f, 0.14f}, {0.46f, 0.3f, 0.05f},  {0.3f, 0.05f, 0.035f},
                                         {0.6f, 0.58f, 0.54f},       {0.36f, 0.25f, 0.14f}, {0.06f, 0.13f, 0.09f}};
constexpr std::array<Vec3f, 4> kCartons{
    Vec3f{0.36f, 0.23f, 0.12f}, {0.42f, 0.28f, 0.15f}, {0.31f, 0.2f, 0.11f}, {0.46f, 0.34f, 0.21f}};

// ---- words

constexpr std::array<std::string_view, 24> kTitles{"HISTORY", "POEMS",  "ATLAS",    "VOYAGES", "ESSAYS",  "LETTERS",
                                                   "NATURE",  "OPERA",  "TALES",    "BOTANY",  "ALGEBRA", "CHESS",
                                                   "GARDENS", "RIVERS", "NIGHT",    "WINTER",  "STARS",   "THE SEA",
                                                   "MAPS",    "ROME",   "PAINTING", "BIRDS",   "LOGIC",   "STORMS"};
constexpr std::array<std::string_view, 12> kFilmTitles{"NIGHT TRAIN", "THE COAST", "ORBIT",  "DUST",
                                                       "LAST STOP",   "HARBOR",    "ECHO",   "RED LINE",
                                                       "THE VOW",     "MIDNIGHT",  "STATIC", "WILD"};
constexpr std::array<std::string_view, 10> kRecordTitles{"BLUE", "SOUL",   "LIVE",   "SUNDAY", "WAVES",
                                                         "JAZZ", "GROOVE", "VOL. 2", "TRIO",   "ECHOES"};
constexpr std::array<std::string_view, 14> kFoods{"PASTA", "OATS",  "RICE",   "TEA",     "FLAKES", "FLOUR",   "COCOA",
                                                  "BEANS", "SUGAR", "MUESLI", "COOKIES", "CRISPS", "LENTILS", "NUTS"};
constexpr std::array<std::string_view, 9> kTinned{"TOMATO", "BEANS", "CORN",   "PEAS", "TUNA",
                                                  "SOUP",   "PEACH", "OLIVES", "MILK"};
constexpr std::array<std::string_view, 8> kPreserves{"JAM",   "HONEY",    "PLUM",   "CHERRY",
                                                     "PESTO", "GHERKINS", "QUINCE", "CHUTNEY"};
constexpr std::array<std::string_view, 6> kDrinkWords{"MILK", "ORANGE", "APPLE", "OAT", "JUICE", "CREAM"};
constexpr std::array<std::string_view, 7> kWineWords{"RESERVE", "ROUGE", "1998", "BLANC", "GIN", "ESTATE", "OAK"};
constexpr std::array<std::string_view, 6> kCoffeeWords{"COFFEE", "ESPRESSO", "ROAST", "BEANS", "DECAF", "HOUSE"};
constexpr std::array<std::string_view, 8> kMedicineWords{"VITAMIN C", "COLD+FLU", "COUGH",  "ZINC",
                                                         "IRON",      "ALLERGY",  "400 MG", "DROPS"};
constexpr std::array<std::string_view, 6> kCosmeticWords{"CREAM", "SOAP", "SERUM", "LOTION", "SHAMPOO", "ROSE"};
constexpr std::array<std::string_view, 7> kToyWords{"BLOCKS", "PUZZLE", "TRAINS", "GAME", "FARM", "ROBOT", "CARS"};
constexpr std::array<std::string_view, 7> kHardwareWords{"SCREWS", "NAILS",   "HOOKS", "PAINT",
                                                         "GLUE",   "M8 X 40", "TAPE"};
constexpr std::array<std::string_view, 3> kParcelWords{"THIS SIDE UP", "FRAGILE", "NO. 214"};

// ---- designs

// A word set along the spine, reading downwards.
void down_title(Patch& p, std::string_view text, float from, float to, float height, Vec3f ink) {
    // one line of letters as high as the spine is wide allows
    float fits = height;
    const float unit = static_cast<float>(text.size()) * 0.93f;
    fits = std::min(fits, (from - to) / std::max(1.f, unit));
    p.letters(text, {0.5f * p.w - 0.5f * fits, from}, {0, -1}, fits, 0.16f * fits, ink);
}
void cloth_spine(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds));
    const bool pale = luminance(ground) > 0.25f;
    const Vec3f gilt = pale ? Vec3f{0.1f, 0.05f, 0.03f} : varied(rng, kGilt);
    p.fill(ground);
    // worn at head, foot and hinges
    p.fill({0, 0}, {p.w, 0.03f * p.h}, ground * 1.35f, 0.5f);
    p.fill({0, 0.97f * p.h}, {p.w, p.h}, ground * 1.4f, 0.5f);
    for (int i = 0; i < 14; ++i)
        p.disc({rng.uniform(0, p.w), rng.uniform(0, p.h)}, {rng.uniform(1, 5), rng.uniform(3, 16)},
               ground * rng.uniform(0.7f, 1.4f), 0.25f);
    const int design = rng.index(4);
    const std::string_view title = one_of(rng, s.words);
    if (design < 2) {  // raised bands, a label between them
        const int bands = 4 + rng.index(2);
        for (int i = 1; i < bands; ++i) {
            const float y = p.h * static_cast<float>(i) / static_cast<float>(bands);
            p.fill({0, y - 2}, {p.w, y + 2}, ground * 1.5f, 0.8f);
            p.fill({0, y - 4}, {p.w, y - 2}, ground * 0.4f, 0.8f);
            if (rng.chance(0.7f))
                p.fill({0, y + 2}, {p.w, y + 3}, gilt, 0.8f), p.fill({0, y - 4}, {p.w, y - 3}, gilt, 0.8f);
        }
        const float low = p.h * static_cast<float>(bands - 2) / static_cast<float>(bands) + 5,
                    high = p.h * static_cast<float>(bands - 1) / static_cast<float>(bands) - 5;
        const Vec3f label = design == 0 ? (rng.chance(0.5f) ? Vec3f{0.1f, 0.012f, 0.012f} : kPrintBlack) : ground;
        p.fill({1, low}, {p.w - 1, high}, label);
        p.title(title, 0.5f * p.w, 0.5f * (low + high) + 1, p.w - 5, 9, gilt);
        p.fill({5, 0.5f * (low + high) - 5}, {p.w - 5, 0.5f * (low + high) - 3.5f}, gilt);
        if (rng.chance(0.5f))
            p.disc({0.5f * p.w, 0.36f * p.h}, {4, 4}, gilt), p.disc({0.5f * p.w, 0.14f * p.h}, {4, 4}, gilt);
    } else {
        for (const float y : {0.05f, 0.08f, 0.9f, 0.93f}) p.fill({0, y * p.h}, {p.w, y * p.h + 1.5f}, gilt, 0.9f);
        const float top = rng.uniform(0.78f, 0.86f) * p.h;
        if (design == 2 && rng.chance(0.6f))
            p.fill({2, 0.3f * p.h}, {p.w - 2, top + 4}, pale ? Vec3f{0.12f, 0.03f, 0.02f} : ground * 0.5f);
        down_title(p, title, top, 0.34f * p.h, 0.5f * p.w, design == 2 || !pale ? (pale ? kCream : gilt) : gilt);
        if (rng.chance(0.6f)) p.disc({0.5f * p.w, 0.17f * p.h}, {0.22f * p.w, 0.22f * p.w}, gilt);
    }
}

void paper_spine(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground);
    p.fill(ground);
    if (rng.chance(0.35f)) {
        const float y = rng.uniform(0.2f, 0.8f) * p.h;
        p.fill({0, rng.chance(0.5f) ? 0.f : y}, {p.w, rng.chance(0.5f) ? y + 20 : y + 40},
               varied(rng, one_of(rng, s.grounds)));
    }
    const float top = rng.uniform(0.84f, 0.94f) * p.h;
    down_title(p, one_of(rng, s.words), top, rng.uniform(0.3f, 0.45f) * p.h, rng.uniform(0.36f, 0.58f) * p.w, ink);
    if (rng.chance(0.7f)) p.fill({0.32f * p.w, 0.05f * p.h}, {0.68f * p.w, 0.05f * p.h + 0.36f * p.w}, ink);
    if (rng.chance(0.6f)) {
        const float y = 0.16f * p.h;
        p.fill({0.4f * p.w, y}, {0.6f * p.w, y + 0.12f * p.h}, ink, 0.7f);
    }
}

void book_cover(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground),
                other = varied(rng, one_of(rng, s.grounds));
    p.fill(ground);
    const bool high = rng.chance(0.5f);
    const float from = high ? 0.62f : 0.08f;
    if (rng.chance(0.75f))
        scene(p, rng, {rng.chance(0.5f) ? 0.f : 0.14f * p.w, high ? 0.08f * p.h : 0.36f * p.h},
              {rng.chance(0.5f) ? p.w : 0.86f * p.w, high ? 0.56f * p.h : 0.94f * p.h}, other, ink,
              one_of(rng, s.inks));
    const float got = p.title(one_of(rng, s.words), 0.5f * p.w, (from + 0.13f) * p.h, 0.8f * p.w, 0.12f * p.h, ink);
    p.title(one_of(rng, s.words), 0.5f * p.w, (from + 0.13f) * p.h - 0.9f * got, 0.5f * p.w, 0.05f * p.h, ink);
    p.fill({0.3f * p.w, 0.05f * p.h}, {0.7f * p.w, 0.065f * p.h}, ink, 0.8f);
}

void film_cover(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground);
    scene(p, rng, {0, 0.14f * p.h}, {p.w, p.h}, lerp(ground, one_of(rng, s.inks), 0.25f), ground * 0.4f,
          one_of(rng, s.inks));
    p.fill({0, 0}, {p.w, 0.3f * p.h}, ground * 0.6f, 0.85f);
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.17f * p.h, 0.88f * p.w, 0.15f * p.h, ink);
    small_print(p, rng, {0.15f * p.w, 0.04f * p.h}, {0.85f * p.w, 0.13f * p.h}, 2, ink);
}

void sleeve(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground);
    p.fill(ground);
    const float inset = rng.chance(0.5f) ? 0.f : 0.12f;
    scene(p, rng, {inset * p.w, inset * p.h}, {(1 - inset) * p.w, (inset > 0 ? 0.76f : 0.82f) * p.h},
          varied(rng, one_of(rng, s.grounds)), ink, one_of(rng, s.grounds));
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.85f * p.h, 0.8f * p.w, 0.1f * p.h, ink);
}

// Of packets, bags and boxes: a panel, a word, a picture of what is in them.
void label(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), second = one_of(rng, s.grounds),
                ink = contrasting(rng, s.inks, ground);
    p.fill(ground);
    const bool panel = rng.chance(0.6f);
    const float y = rng.uniform(0.56f, 0.68f) * p.h;
    Vec3f on = ground;
    if (panel) {
        on = luminance(ground) > 0.3f ? one_of(rng, s.inks) : kCream;
        p.fill({0, y}, {p.w, y + 0.22f * p.h}, on);
    }
    p.title(one_of(rng, s.words), 0.5f * p.w, y + 0.06f * p.h, 0.84f * p.w, 0.12f * p.h,
            panel ? contrasting(rng, s.inks, on) : ink);
    const Vec2f middle{0.5f * p.w, 0.34f * p.h};
    const float r = 0.24f * std::min(p.w, p.h);
    switch (rng.index(4)) {
        case 0:  // a bowl, heaped
            p.disc(middle + Vec2f{0, 0.12f * r}, {1.1f * r, 0.7f * r}, lerp(ink, second, 0.5f));
            p.fill(middle + Vec2f{-1.3f * r, -0.1f * r}, middle + Vec2f{1.3f * r, 0.1f * r}, kPrintWhite);
            p.disc(middle + Vec2f{0, -0.3f * r}, {0.9f * r, 0.6f * r}, kPrintWhite);
            break;
        case 1:  // fruit
            for (const float x : {-0.6f, 0.6f, 0.f})
                p.disc(middle + Vec2f{x * r, x == 0.f ? 0.5f * r : -0.2f * r}, {0.6f * r, 0.6f * r},
                       lerp(second, ink, 0.35f));
            break;
        case 2:  // stripes
            for (int i = 0; i < 5; ++i)
                p.fill({0, middle.y - r + 0.5f * r * static_cast<float>(i)},
                       {p.w, middle.y - r + 0.5f * r * static_cast<float>(i) + 0.2f * r}, ink, 0.8f);
            break;
        default:  // a roundel
            p.disc(middle, {1.2f * r, 1.2f * r}, second);
            p.disc(middle, {0.95f * r, 0.95f * r}, ink);
            p.disc(middle, {0.6f * r, 0.6f * r}, second);
            break;
    }
    p.fill({0, 0}, {p.w, 0.05f * p.h}, ink, 0.85f);
    p.title("500 G", 0.8f * p.w, 0.08f * p.h, 0.3f * p.w, 0.05f * p.h, ink);
}

// Paper stuck on: a frame, a word, small print.
void paper_label(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground);
    p.fill(ground);
    const float d = 0.07f * std::min(p.w, p.h);
    for (const float y : {d, p.h - 1.4f * d}) p.fill({d, y}, {p.w - d, y + 0.4f * d}, ink);
    for (const float x : {d, p.w - 1.4f * d}) p.fill({x, d}, {x + 0.4f * d, p.h - d}, ink);
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.52f * p.h, 0.76f * p.w, 0.24f * p.h, ink);
    if (rng.chance(0.5f)) p.disc({0.5f * p.w, 0.28f * p.h}, {0.12f * p.h, 0.12f * p.h}, lerp(ink, ground, 0.3f));
    else small_print(p, rng, {0.25f * p.w, 0.16f * p.h}, {0.75f * p.w, 0.42f * p.h}, 2, ink);
}

// White boxes with a stripe, a cross and a name.
void medicine(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = one_of(rng, s.grounds), ink = one_of(rng, s.inks);
    p.fill(ground);
    const float y = rng.uniform(0.1f, 0.25f) * p.h;
    if (rng.chance(0.5f)) p.fill({0, y}, {p.w, y + 0.2f * p.h}, ink);
    else p.fill({0, 0}, {rng.uniform(0.14f, 0.28f) * p.w, p.h}, ink);
    p.title(one_of(rng, s.words), 0.56f * p.w, 0.58f * p.h, 0.64f * p.w, 0.22f * p.h, ink);
    small_print(p, rng, {0.34f * p.w, 0.4f * p.h}, {0.8f * p.w, 0.54f * p.h}, 2, {0.2f, 0.2f, 0.2f});
    if (rng.chance(0.5f)) {
        const Vec2f c{0.84f * p.w, 0.82f * p.h};
        const float a = 0.04f * p.w, b = 0.11f * p.w;
        p.fill(c - Vec2f{a, b}, c + Vec2f{a, b}, ink), p.fill(c - Vec2f{b, a}, c + Vec2f{b, a}, ink);
    }
}

void parcel(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), dark = ground * 0.5f;
    p.fill(ground);
    p.fill({0, 0.9f * p.h}, {p.w, p.h}, {0.45f, 0.34f, 0.2f}, 0.6f);  // tape over the lid
    p.fill({0.43f * p.w, 0.7f * p.h}, {0.57f * p.w, p.h}, {0.5f, 0.38f, 0.23f}, 0.8f);
    if (rng.chance(0.7f)) {
        const Vec2f low{rng.uniform(0.1f, 0.5f) * p.w, rng.uniform(0.2f, 0.4f) * p.h};
        p.fill(low, low + Vec2f{0.36f * p.w, 0.28f * p.h}, kPrintWhite);
        small_print(p, rng, low + Vec2f{3, 3}, low + Vec2f{0.32f * p.w, 0.26f * p.h}, 2, {0.1f, 0.1f, 0.1f});
    }
    if (rng.chance(0.6f)) p.title(one_of(rng, s.words), 0.5f * p.w, 0.08f * p.h, 0.7f * p.w, 0.1f * p.h, dark);
}

}  // namespace

// In the order of Print.
std::span<const PrintStyle> goods_styles() {
    static const std::array<PrintStyle, static_cast<std::size_t>(Print::film_posters)> all{{
        {"cloth spines", 20, 4, 34, 192, {0.036f, 0.24f}, 0.62f, cloth_spine, kBindings, kJacketInks, kTitles},
        {"paper spines", 20, 4, 34, 192, {0.034f, 0.22f}, 0.42f, paper_spine, kJackets, kJacketInks, kTitles},
        {"book covers", 8, 4, 96, 136, {0.15f, 0.21f}, 0.38f, book_cover, kJackets, kJacketInks, kTitles},
        {"film covers", 10, 4, 80, 112, {0.135f, 0.19f}, 0.3f, film_cover, kFilms, kFilmInks, kFilmTitles},
        {"record sleeves", 8, 5, 112, 112, {0.31f, 0.31f}, 0.4f, sleeve, kSleeves, kJacketInks, kRecordTitles},
        {"packets", 10, 4, 64, 96, {0.14f, 0.2f}, 0.45f, label, kGroceries, kGroceryInks, kFoods},
        {"tins", 10, 3, 80, 72, {0.11f, 0.1f}, 0.4f, label, kGroceries, kGroceryInks, kTinned},
        {"jar labels", 8, 4, 72, 48, {0.07f, 0.06f}, 0.7f, paper_label, kPapers, kDarkInks, kPreserves},
        {"drink cartons", 8, 3, 56, 112, {0.08f, 0.2f}, 0.35f, label, kDrinks, kGroceryInks, kDrinkWords},
        {"bottle labels", 8, 4, 56, 72, {0.07f, 0.09f}, 0.65f, paper_label, kPapers, kDarkInks, kWineWords},
        {"coffee bags", 6, 4, 72, 112, {0.11f, 0.2f}, 0.55f, label, kCoffees, kPapers, kCoffeeWords},
        {"medicines", 10, 5, 72, 56, {0.1f, 0.08f}, 0.35f, medicine, kMedicines, kMedicineInks, kMedicineWords},
        {"cosmetics", 8, 4, 48, 80, {0.06f, 0.12f}, 0.3f, paper_label, kCosmetics, kDarkInks, kCosmeticWords},
        {"toy boxes", 6, 4, 96, 96, {0.24f, 0.24f}, 0.35f, label, kToys, kGroceryInks, kToyWords},
        {"hardware", 8, 4, 72, 64, {0.12f, 0.1f}, 0.5f, label, kHardware, kPapers, kHardwareWords},
        {"cartons", 6, 3, 112, 96, {0.4f, 0.35f}, 0.85f, parcel, kCartons, kCartons, kParcelWords},
    }};
    return all;
}

bool is_old_book(const Style& style, Random& rng) {
    return rng.chance(style.mouldings == Mouldings::none ? 0.3f : 0.85f);
}

Vec3f cover_color(Random& rng, bool old) {
    const Colors colors = old ? Colors(kBindings) : Colors(kJackets);
    return varied(rng, one_of(rng, colors));
}

}  // namespace fastscene::furniture
