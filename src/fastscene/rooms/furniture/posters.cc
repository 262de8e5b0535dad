// Designs of posters, by what they are about.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/print_designs.h"

namespace fastscene::furniture {
namespace {

constexpr std::array<Vec3f, 6> kTravelSkies{Vec3f{0.62f, 0.4f, 0.2f}, {0.14f, 0.34f, 0.46f}, {0.56f, 0.5f, 0.36f},
                                            {0.42f, 0.15f, 0.11f},    {0.1f, 0.24f, 0.28f},  {0.5f, 0.3f, 0.3f}};
constexpr std::array<Vec3f, 5> kTravelInks{Vec3f{0.05f, 0.08f, 0.12f},
                                           {0.66f, 0.58f, 0.42f},
                                           {0.3f, 0.08f, 0.05f},
                                           {0.06f, 0.15f, 0.11f},
                                           {0.6f, 0.4f, 0.12f}};
constexpr std::array<Vec3f, 5> kOfferGrounds{Vec3f{0.5f, 0.045f, 0.035f},
                                             {0.66f, 0.46f, 0.04f},
                                             {0.05f, 0.2f, 0.1f},
                                             {0.05f, 0.13f, 0.32f},
                                             {0.62f, 0.25f, 0.03f}};
constexpr std::array<Vec3f, 3> kOfferInks{Vec3f{0.74f, 0.73f, 0.7f}, {0.66f, 0.5f, 0.06f}, {0.04f, 0.04f, 0.04f}};
constexpr std::array<Vec3f, 5> kSportGrounds{Vec3f{0.03f, 0.03f, 0.033f},
                                             {0.46f, 0.05f, 0.03f},
                                             {0.04f, 0.1f, 0.26f},
                                             {0.6f, 0.56f, 0.48f},
                                             {0.55f, 0.3f, 0.03f}};
constexpr std::array<Vec3f, 4> kSportInks{
    Vec3f{0.74f, 0.73f, 0.7f}, {0.62f, 0.44f, 0.04f}, {0.5f, 0.06f, 0.03f}, {0.05f, 0.05f, 0.055f}};
constexpr std::array<Vec3f, 5> kConcerts{Vec3f{0.035f, 0.03f, 0.045f},
                                         {0.6f, 0.42f, 0.08f},
                                         {0.42f, 0.07f, 0.1f},
                                         {0.64f, 0.58f, 0.46f},
                                         {0.06f, 0.18f, 0.2f}};
constexpr std::array<Vec3f, 3> kChartGrounds{Vec3f{0.74f, 0.73f, 0.7f}, {0.68f, 0.64f, 0.52f}, {0.62f, 0.68f, 0.7f}};
constexpr std::array<Vec3f, 5> kChartInks{Vec3f{0.06f, 0.12f, 0.24f},
                                          {0.4f, 0.07f, 0.05f},
                                          {0.07f, 0.22f, 0.12f},
                                          {0.5f, 0.32f, 0.06f},
                                          {0.22f, 0.12f, 0.28f}};
constexpr std::array<Vec3f, 3> kNoticeGrounds{Vec3f{0.74f, 0.74f, 0.72f}, {0.7f, 0.68f, 0.56f}, {0.66f, 0.7f, 0.72f}};
constexpr std::array<Vec3f, 4> kNoticeInks{
    Vec3f{0.42f, 0.04f, 0.035f}, {0.04f, 0.14f, 0.3f}, {0.04f, 0.24f, 0.12f}, {0.05f, 0.05f, 0.05f}};
constexpr std::array<Vec3f, 5> kFashionGrounds{
    Vec3f{0.66f, 0.62f, 0.56f}, {0.5f, 0.42f, 0.36f}, {0.42f, 0.46f, 0.46f}, {0.6f, 0.46f, 0.4f}, {0.1f, 0.1f, 0.105f}};
constexpr std::array<Vec3f, 4> kFashionInks{
    Vec3f{0.05f, 0.05f, 0.052f}, {0.72f, 0.7f, 0.66f}, {0.34f, 0.09f, 0.06f}, {0.1f, 0.16f, 0.22f}};
constexpr std::array<Vec3f, 6> kPosterFilms{Vec3f{0.03f, 0.05f, 0.09f}, {0.3f, 0.12f, 0.05f}, {0.05f, 0.02f, 0.02f},
                                            {0.04f, 0.09f, 0.08f},      {0.4f, 0.28f, 0.14f}, {0.14f, 0.18f, 0.24f}};
constexpr std::array<Vec3f, 5> kPosterFilmInks{
    Vec3f{0.72f, 0.7f, 0.64f}, {0.62f, 0.42f, 0.1f}, {0.52f, 0.07f, 0.04f}, {0.2f, 0.4f, 0.5f}, {0.66f, 0.6f, 0.45f}};

constexpr std::array<std::string_view, 10> kPosterFilmWords{
    "NIGHT TRAIN", "THE COAST", "ORBIT", "DUST", "LAST STOP", "HARBOR", "RED LINE", "MIDNIGHT", "STATIC", "THE VOW"};
constexpr std::array<std::string_view, 10> kPlaces{"LISBON", "KYOTO",  "OSLO",      "NAPLES", "THE ALPS",
                                                   "CUBA",   "ATHENS", "MARSEILLE", "BERGEN", "CAIRO"};
constexpr std::array<std::string_view, 8> kOfferWords{"SALE", "NEW",       "2 FOR 1",  "FRESH",
                                                      "-50",  "THIS WEEK", "BEST BUY", "OPEN LATE"};
constexpr std::array<std::string_view, 8> kSportWords{"NO LIMITS", "RUN",    "STRIKE", "LEAGUE NIGHT",
                                                      "TRAIN",     "FINALS", "POWER",  "OPEN CUP"};
constexpr std::array<std::string_view, 8> kConcertWords{"LIVE", "JAZZ NIGHT", "ON TOUR",  "THE QUARTET",
                                                        "SOUL", "OPERA",      "FESTIVAL", "BLUES"};
constexpr std::array<std::string_view, 8> kChartWords{"ELEMENTS", "PLANTS",  "THE HEART", "NUMBERS",
                                                      "ALPHABET", "PLANETS", "CELLS",     "ROCKS"};
constexpr std::array<std::string_view, 8> kNoticeWords{"NOTICE",     "SAFETY FIRST", "NO SMOKING", "PLEASE QUEUE",
                                                       "WASH HANDS", "HOUSE RULES",  "EXIT",       "TIMETABLE"};
constexpr std::array<std::string_view, 6> kFashionWords{"SUMMER", "NOVA", "ATELIER", "DENIM", "LINEN", "STUDIO"};

void film_poster(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground),
                light = one_of(rng, s.inks);
    scene(p, rng, {0, 0.2f * p.h}, {p.w, p.h}, lerp(ground, light, 0.3f), ground * 0.4f, light);
    fade(p, {0, 0}, {p.w, 0.3f * p.h}, ground * 0.35f, ground * 0.6f);
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.17f * p.h, 0.86f * p.w, 0.13f * p.h, ink);
    small_print(p, rng, spot(p, 0.16f, 0.04f), spot(p, 0.84f, 0.14f), 0.008f * p.h, ink);
    for (const float x : {0.12f, 0.42f, 0.72f})
        small_print(p, rng, spot(p, x, 0.94f), spot(p, x + 0.2f, 0.97f), 0.012f * p.h, kPrintWhite);
}

// A sky, a sun, hills or a town before the sea, in a white border.
void travel_poster(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f sky = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, sky);
    p.fill({0.68f, 0.65f, 0.57f});
    const Vec2f low = spot(p, 0.06f, 0.2f), high = spot(p, 0.94f, 0.955f);
    const float w = high.x - low.x, h = high.y - low.y;
    fade(p, low, high, lerp(sky, kPrintWhite, 0.55f), sky);
    p.disc(low + Vec2f{rng.uniform(0.25f, 0.75f) * w, rng.uniform(0.6f, 0.75f) * h}, {0.1f * w, 0.1f * w},
           {0.7f, 0.55f, 0.25f});
    const float horizon = rng.uniform(0.26f, 0.36f) * h, phase = rng.uniform(0, 6.f);
    for (int layer = 0; layer < 3; ++layer) {
        const auto depth = static_cast<float>(layer);
        const Vec3f color = lerp(lerp(sky, kPrintWhite, 0.3f), ink, 0.35f + 0.3f * depth);
        const float base = horizon + (0.2f - 0.13f * depth) * h;
        for (float x = 0; x < w; x += 1) {
            const float t = x / w * (4.f + 2.f * depth) + phase + 2.f * depth,
                        y = base + h * (0.07f * std::sin(t) + 0.035f * std::sin(2.7f * t));
            p.fill(low + Vec2f{x, 0}, low + Vec2f{x + 1, std::max(1.f, y)}, color);
        }
    }
    const Vec3f sea = lerp(sky, {0.05f, 0.16f, 0.22f}, 0.7f);
    fade(p, low, {high.x, low.y + 0.2f * h}, sea * 0.6f, sea);
    if (rng.chance(0.6f)) {  // a sail
        const Vec2f o = low + Vec2f{rng.uniform(0.3f, 0.7f) * w, 0.13f * h};
        for (float y = 0; y < 0.2f * h; y += 1)
            p.fill(o + Vec2f{-0.12f * w * (1 - y / (0.2f * h)), y}, o + Vec2f{0, y + 1}, kPrintWhite);
        p.fill(o + Vec2f{-0.13f * w, -0.03f * h}, o + Vec2f{0.07f * w, -0.006f * h}, ink * 0.5f);
    }
    const std::string_view place = one_of(rng, s.words);
    p.title(place, 0.5f * p.w, 0.085f * p.h, 0.84f * p.w, 0.085f * p.h, ink);
    small_print(p, rng, spot(p, 0.3f, 0.035f), spot(p, 0.7f, 0.065f), 0.011f * p.h, ink);
}

// A word as large as it fits, a round price, stripes.
void offer(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground),
                other = one_of(rng, s.grounds);
    p.fill(ground);
    if (rng.chance(0.5f))
        for (int i = 0; i < 7; ++i)
            p.line(spot(p, -0.1f, 0.16f * static_cast<float>(i)), spot(p, 1.1f, 0.16f * static_cast<float>(i) + 0.25f),
                   0.04f * p.h, lerp(ground, ink, 0.12f));
    const bool above = rng.chance(0.5f);
    p.title(one_of(rng, s.words), 0.5f * p.w, (above ? 0.7f : 0.14f) * p.h, 0.84f * p.w, 0.2f * p.h, ink);
    const Vec2f c = spot(p, 0.5f, above ? 0.38f : 0.62f);
    const float r = 0.3f * p.w;
    for (int i = 0; i < 12; ++i) {
        const float a = 0.5236f * static_cast<float>(i);
        p.line(c, c + Vec2f{std::cos(a), std::sin(a)} * (1.16f * r), 0.3f * r, ink);
    }
    p.disc(c, {r, r}, ink);
    static constexpr std::array<std::string_view, 6> kPrices{"-50", "1.99", "-30", "4.50", "9.90", "2+1"};
    p.title(one_of(rng, Words(kPrices)), c.x, c.y - 0.24f * r, 1.5f * r, 0.48f * r,
            contrasting(rng, s.grounds, ink) == ground ? ground : other);
    small_print(p, rng, spot(p, 0.12f, 0.04f), spot(p, 0.88f, 0.08f), 0.01f * p.h, ink);
}

void sport_poster(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground),
                stripe = one_of(rng, s.inks);
    p.fill(ground);
    for (int i = 0; i < 3; ++i)
        p.line(spot(p, -0.1f, 0.2f + 0.16f * static_cast<float>(i)),
               spot(p, 1.1f, 0.5f + 0.16f * static_cast<float>(i)), 0.06f * p.h, lerp(ground, stripe, 0.35f));
    person(p, spot(p, 0.46f, 0.24f), 0.62f * p.h, rng.chance(0.7f) ? rng.uniform(0.6f, 1.f) : 0.f, ink);
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.08f * p.h, 0.88f * p.w, 0.12f * p.h, ink);
    small_print(p, rng, spot(p, 0.1f, 0.93f), spot(p, 0.5f, 0.97f), 0.012f * p.h, ink);
}

// Large words one below the other over discs or bars, a list of dates.
void concert_poster(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)),
                ink = luminance(ground) > 0.25f ? kPrintBlack : kPrintWhite, other = one_of(rng, s.grounds);
    p.fill(ground);
    if (rng.chance(0.5f)) {
        for (int i = 0; i < 5; ++i)
            p.disc(spot(p, 0.5f, 0.62f), Vec2f{0.42f, 0.42f} * (p.w * (1.f - 0.2f * static_cast<float>(i))),
                   i % 2 == 0 ? other : ground);
    } else {
        for (int i = 0; i < 11; ++i) {
            const float x = 0.08f + 0.08f * static_cast<float>(i), up = rng.uniform(0.08f, 0.4f);
            p.fill(spot(p, x, 0.62f - 0.5f * up), spot(p, x + 0.05f, 0.62f + 0.5f * up), other);
        }
    }
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.84f * p.h, 0.88f * p.w, 0.11f * p.h, ink);
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.28f * p.h, 0.7f * p.w, 0.07f * p.h, ink);
    small_print(p, rng, spot(p, 0.2f, 0.05f), spot(p, 0.8f, 0.24f), 0.012f * p.h, ink);
}

// A heading over a table of cells, or over a figure whose parts are named.
void chart(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = one_of(rng, s.grounds), ink = one_of(rng, s.inks);
    p.fill(ground);
    p.fill(spot(p, 0, 0.87f), spot(p, 1, 1), ink);
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.905f * p.h, 0.8f * p.w, 0.06f * p.h, kPrintWhite);
    if (rng.chance(0.6f)) {
        const int columns = 5 + rng.index(3), rows = 6 + rng.index(3);
        const float w = 0.88f / static_cast<float>(columns), h = 0.76f / static_cast<float>(rows);
        const Vec3f second = one_of(rng, s.inks);
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const float x = 0.06f + w * static_cast<float>(i), y = 0.06f + h * static_cast<float>(j);
                const Vec3f cell = lerp(ground, (i + j / 2) % 3 == 0 ? second : ink, rng.uniform(0.15f, 0.5f));
                p.fill(spot(p, x + 0.008f, y + 0.006f), spot(p, x + w - 0.008f, y + h - 0.006f), cell);
                const char letter[] = {static_cast<char>('A' + rng.index(26)), '\0'};
                p.title(letter, (x + 0.5f * w) * p.w, (y + 0.3f * h) * p.h, 0.5f * w * p.w, 0.4f * h * p.h,
                        kPrintBlack);
            }
        return;
    }
    if (rng.chance(0.5f)) person(p, spot(p, 0.5f, 0.08f), 0.74f * p.h, 0, lerp(ground, ink, 0.7f));
    else
        for (int i = 0; i < 6; ++i) {
            const float r = rng.uniform(0.05f, 0.13f) * p.w;
            p.disc(spot(p, 0.24f + 0.26f * static_cast<float>(i % 3), i < 3 ? 0.62f : 0.26f), {r, r},
                   lerp(ground, one_of(rng, s.inks), 0.8f));
        }
    for (int i = 0; i < 5; ++i) {
        const float y = 0.14f + 0.15f * static_cast<float>(i), side = i % 2 == 0 ? 0.04f : 0.74f;
        p.line(spot(p, 0.5f, y + 0.02f), spot(p, side + 0.1f, y), 1.2f, ink);
        small_print(p, rng, spot(p, side, y - 0.03f), spot(p, side + 0.22f, y), 0.01f * p.h, ink);
    }
}

// A heading, a sign, lines of text.
void notice(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = one_of(rng, s.grounds), ink = one_of(rng, s.inks);
    p.fill(ground);
    p.fill(spot(p, 0.05f, 0.82f), spot(p, 0.95f, 0.96f), ink);
    p.title(one_of(rng, s.words), 0.5f * p.w, 0.865f * p.h, 0.8f * p.w, 0.055f * p.h, kPrintWhite);
    float text = 0.78f;
    if (rng.chance(0.6f)) {
        const Vec2f c = spot(p, 0.5f, 0.64f);
        const float r = 0.18f * p.w;
        p.disc(c, {r, r}, ink), p.disc(c, {0.8f * r, 0.8f * r}, ground);
        p.line(c + Vec2f{-0.6f, 0.6f} * r, c + Vec2f{0.6f, -0.6f} * r, 0.2f * r, ink);
        p.line(c + Vec2f{-0.5f, -0.1f} * r, c + Vec2f{0.5f, -0.1f} * r, 0.22f * r, kPrintBlack);
        text = 0.48f;
    }
    const Vec3f dark{0.12f, 0.12f, 0.12f};
    small_print(p, rng, spot(p, 0.1f, 0.1f), spot(p, 0.9f, text), 0.016f * p.h, dark);
    p.fill(spot(p, 0.05f, 0.04f), spot(p, 0.95f, 0.055f), ink);
}

// A tall figure in a coat or dress before a plain ground, one word in thin letters.
void fashion_poster(Patch& p, Random& rng, const PrintStyle& s) {
    const Vec3f ground = varied(rng, one_of(rng, s.grounds)), ink = contrasting(rng, s.inks, ground);
    fade(p, {0, 0}, {p.w, p.h}, ground * 0.8f, lerp(ground, kPrintWhite, 0.25f));
    const Vec3f cloth = varied(rng, one_of(rng, s.inks)), skin = lerp({0.45f, 0.28f, 0.18f}, ground, 0.3f);
    const Vec2f feet = spot(p, rng.uniform(0.35f, 0.65f), 0.02f);
    const float tall = 0.86f * p.h;
    person(p, feet, tall, 0, skin);
    for (float y = 0.3f * tall; y < 0.84f * tall; y += 1) {  // from the shoulders down it widens
        const float t = (0.84f * tall - y) / (0.54f * tall);
        p.fill(feet + Vec2f{-(0.1f + 0.09f * t) * tall, y}, feet + Vec2f{(0.1f + 0.09f * t) * tall, y + 1}, cloth);
    }
    const std::string_view word = one_of(rng, s.words);
    p.title(word, 0.5f * p.w, 0.07f * p.h, 0.8f * p.w, 0.1f * p.h, ink);
}

}  // namespace

// In the order of Print, from the first poster.
std::span<const PrintStyle> poster_styles() {
    constexpr int kWide = 224, kHigh = 320;  // pixels of one: 3 mm each on a poster a metre high
    constexpr Vec2f kPaper{0.594f, 0.841f};  // A1
    static const std::array<PrintStyle,
                            static_cast<std::size_t>(Print::count) - static_cast<std::size_t>(Print::film_posters)>
        all{{
            {"film posters", 5, 2, kWide, kHigh, kPaper, 0.3f, film_poster, kPosterFilms, kPosterFilmInks,
             kPosterFilmWords},
            {"travel posters", 5, 2, kWide, kHigh, kPaper, 0.35f, travel_poster, kTravelSkies, kTravelInks, kPlaces},
            {"offers", 5, 2, kWide, kHigh, kPaper, 0.35f, offer, kOfferGrounds, kOfferInks, kOfferWords},
            {"food posters", 4, 2, kWide, kHigh, kPaper, 0.35f, food_poster, {}, {}, {}},
            {"sport posters", 4, 2, kWide, kHigh, kPaper, 0.35f, sport_poster, kSportGrounds, kSportInks, kSportWords},
            {"concert posters", 4, 2, kWide, kHigh, kPaper, 0.4f, concert_poster, kConcerts, kConcerts, kConcertWords},
            {"charts", 4, 2, kWide, kHigh, kPaper, 0.4f, chart, kChartGrounds, kChartInks, kChartWords},
            {"notices", 4, 2, kWide, kHigh, kPaper, 0.5f, notice, kNoticeGrounds, kNoticeInks, kNoticeWords},
            {"fashion posters", 4, 2, kWide, kHigh, kPaper, 0.3f, fashion_poster, kFashionGrounds, kFashionInks,
             kFashionWords},
            {"bakery posters", 4, 2, kWide, kHigh, kPaper, 0.35f, bakery_poster, {}, {}, {}},
        }};
    return all;
}

}  // namespace fastscene::furniture
