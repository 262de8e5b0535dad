// What belongs into which room, and how the pieces stand to each other.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene::furnishing {
namespace {

constexpr float kBeforeLoft = kInsideBed +
                              0.03f;  // metres from a desk below a bed to who sits at it: clear of the ladder

}  // namespace

void Furnisher::groups() {
    const std::string& room = l_.spec().room;
    if (room == "bedroom" || room == "attic") bedroom();
    else if (room == "kids") kids_room();
    else if (room == "kitchen") kitchen();
    else if (room == "dining") dining();
    else if (room == "bathroom") bathroom();
    else if (room == "study") study();
    else if (room == "hallway") hallway();
    else if (room == "laundry") laundry();
    else if (room == "sunroom") sunroom();
    else if (room == "loft") loft();
    else living();
}

// A long side at the wall, the floor before it free; a desk or a seat below one that is high enough.
void Furnisher::sleeping_place_along(const std::string& klass) {
    const auto found = main_at_wall(klass, {.center_pull = 0.1f, .window_pull = -0.8f});
    if (!found) return;
    const int bed = *found;
    rug(bed, 0.85f, 1.9f, 1.4f, size(bed).z / 2 + 0.8f);
    if (klass == "daybed") {
        above(bed, "picture", 0.75f);
        beside(bed, "side_table", 0.6f, chance(0.5f) ? 1 : -1, 0.06f,
               [this](int table) { top(table, "table_lamp", 0.9f); });
    }
}

void Furnisher::sleeping_place(const std::string& klass) {
    if (has_role(klass, Role::along_wall)) return sleeping_place_along(klass);
    const auto found = main_at_wall(klass, {.center_pull = 1.2f, .window_pull = -0.8f});
    if (!found) return;
    const int bed = *found;
    for (const int side : {-1, 1})
        beside(bed, "nightstand", side < 0 ? 1.f : 0.75f, side, 0.08f, [=, this](int stand) {
            top(stand, "table_lamp", 0.9f);
            later([=, this] {
                const std::string thing = chance(0.5f)               ? "book_stack"
                                          : l_.spec().room == "kids" ? "teddy_bear"
                                                                     : "vase";
                if (chance(clutter_)) top(stand, thing, 1);
            });
        });
    above(bed, "picture", 0.75f);
    rug(bed, 0.75f, size(bed).x + 1.1f, 1.9f, 0.75f);
    before(bed, "bench", 0.35f, 0.06f, false);
    before(bed, "ottoman", 0, 0.1f, false);
}

std::string Furnisher::first_asked(std::initializer_list<const char*> classes) const {
    for (const char* klass : classes)
        if (wishes_.asked(klass)) return klass;
    return *(classes.end() - 1);
}

std::string Furnisher::easy_chair() const {
    for (const std::string& klass : kinds_with(Role::easy_chair))
        if (wishes_.has(klass)) return klass;
    return "armchair";
}

void Furnisher::reading_corner(float probability) {
    const Layout::WallWish at_wall{.window_pull = 1.2f};
    put(
        easy_chair(), probability,
        [=, this](const PieceRequest& r, const PromptObject& o) {
            if (o.relation.empty() || o.relation == "in the corner")
                if (const auto i = l_.angled_towards({0, 0}, r, o)) return i;
            return l_.against_wall(r, at_wall, o);
        },
        [this](int chair) {
            const int side = chance(0.5f) ? 1 : -1;
            beside(chair, "side_table", 0.6f, side, 0.05f,
                   [this](int table) { top(table, chance(0.5f) ? "book_stack" : "vase", 0.9f); });
            beside(chair, "floor_lamp", 0.5f, -side, 0.05f);
        });
}

void Furnisher::bedroom() {
    // A room for one who asked for a single bed has no other.
    sleeping_place(!wishes_.asked("bed") ? first_asked({"canopy_bed", "four_poster_bed", "floor_bed", "bunk_bed",
                                                        "loft_bed", "cabin_bed", "bed_single", "daybed", "bed"})
                                         : "bed");
    wall("wardrobe", 0.85f, {.window_pull = -1});
    wall("dresser", 0.55f, {.window_pull = -0.5f});
    working_place(0.06f);
    reading_corner(0.5f);
    wall("mirror", 0.4f);
}

void Furnisher::kids_room() {
    sleeping_place(first_asked({"crib", "bunk_bed", "loft_bed", "cabin_bed", "bed", "canopy_bed", "four_poster_bed",
                                "daybed", "floor_bed", "bed_single"}));
    if (wishes_.asked("crib") && wishes_.has("bed")) sleeping_place("bed");
    wall("toy_box", 0.9f, {.center_pull = 0});
    wall("bookshelf", 0.8f, {.window_pull = -1});
    working_place(0.6f);
    put("play_table", 0.55f, [this](const PieceRequest& r, const PromptObject& o) { return l_.free_standing(r, o); });
    wall("wardrobe", 0.4f, {.window_pull = -1});
    wall("rocking_horse", 0.35f, {.center_pull = 0, .corner = true});
    wall("basket", 0.7f, {.corner = true});
}

// A desk with its chair and lamp; without a wish, with this probability.
void Furnisher::working_place(float probability) {
    const auto furnish_desk = [this](int desk) {
        const bool plain = wishes_.has("chair") && !wishes_.has("office_chair");
        for (int left = wishes_.count("monitor"); left > 0; --left)
            put("monitor", 0,
                [=, this](const PieceRequest& r, const PromptObject& o) { return next_screen(desk, r, o); });
        const bool sheltered = at(desk).below >= 0;  // by a bed: one sits before that
        before(desk, plain ? "chair" : "office_chair", 1, sheltered ? kBeforeLoft : plain ? 0.05f : -0.2f, true);
        top(desk, "table_lamp", 0.85f);
    };
    const auto place = [this](const PieceRequest& r, const PromptObject& o) -> std::optional<int> {
        if (const auto bed = l_.find("loft_bed"); bed && o.relation.empty())
            if (const auto desk = l_.below(*bed, r, o)) return desk;
        return at_wall(r, {.center_pull = 0.5f, .window_pull = 0.8f}, o);
    };
    if (probability >= 1 || wishes_.asked("desk") || wishes_.asked("monitor")) {
        if (const auto desk = main("desk", place)) furnish_desk(*desk);
        return;
    }
    later([=, this] {
        // Who sleeps above a free space works there.
        if (!l_.find("desk") && chance(l_.find("loft_bed") ? 1.f : probability)) put("desk", 1, place, furnish_desk);
    });
}

void Furnisher::seating_group() {
    const bool small = !wishes_.asked("sofa") && wishes_.asked("loveseat");
    const auto found = main_at_wall(small ? "loveseat" : "sofa", {.center_pull = 1.f, .window_pull = -0.3f});
    if (!found) return;
    const int sofa = *found;
    rug(sofa, 0.9f, size(sofa).x + 0.5f, 1.9f, size(sofa).z / 2 + 0.55f);
    before(sofa, "coffee_table", 0.95f, 0.42f, false, [this](int table) {
        top(table, "book_stack", 0.7f);
        top(table, chance(0.5f) ? "vase" : "bowl", 0.7f);
        top(table, "candle", clutter_ * 0.6f);
        put("ottoman", 0.3f, [=, this](const PieceRequest& r, const PromptObject& o) {
            return l_.beside(table, r, chance(0.5f) ? 1 : -1, 0.2f, o);
        });
    });
    above(sofa, "picture", 0.85f);
    const int side = chance(0.5f) ? 1 : -1;
    beside(sofa, "side_table", 0.6f, side, 0.06f, [this](int end) { top(end, "table_lamp", 0.8f); });
    beside(sofa, "floor_lamp", 0.65f, -side, 0.06f);
    focus_of(sofa);
    const Vec2f focus = front_point(sofa, 0.6f);
    const auto chair = [=, this](const PieceRequest& r, const PromptObject& o) {
        // High and closed behind, it would hide what is behind it.
        if (r.klass == "hanging_chair")
            if (const auto index = l_.against_wall(r, {.center_pull = 0, .window_pull = -0.3f, .corner = true}, o))
                return index;
        if (const auto index = l_.angled_towards(focus, r, o)) return index;
        return l_.against_wall(r, {}, o);
    };
    const int chairs = wishes_.count("armchair");
    for (const std::string& klass : kinds_with(Role::easy_chair))
        for (int i = wishes_.count(klass); i > 0; --i) put(klass, 0, chair);
    for (int i = 0; i < (chairs > 0 ? chairs : 2); ++i) put("armchair", i == 0 ? 0.8f : 0.5f, chair);
    if (!small && wishes_.has("loveseat")) wall("loveseat", 1);
}

// What the sofa looks at: a fire or a screen.
void Furnisher::focus_of(int sofa) {
    const int opposite = wall_opposite(sofa);
    const Layout::WallWish for_fire{.wall = opposite, .center_pull = 1.5f, .clear_of_windows = true};
    const Layout::WallWish for_screen{
        .wall = opposite, .center_pull = 1.5f, .window_pull = -2, .clear_of_windows = true};
    const auto above_fire = [this](int fire) { above(fire, chance(0.5f) ? "mirror" : "picture", 0.7f); };
    if (wishes_.asked("fireplace")) {
        if (const auto fire = main_at_wall("fireplace", for_fire)) above_fire(*fire);
        return;
    }
    const auto screen = [=, this](int stand) {
        put("tv", 0.9f, [=, this](const PieceRequest& r, const PromptObject& o) {
            if (is_hung_screen(o))
                if (const auto i = screen_above(stand, r, o)) return i;
            if (const auto i = l_.on_top(stand, r, o)) return i;
            return l_.on_wall(r, stand, o);
        });
        later([=, this] {
            if (chance(clutter_)) top(stand, "book_stack", 0.6f);
        });
    };
    if (wishes_.has("tv")) {
        if (const auto stand = main_at_wall("tv_stand", for_screen)) screen(*stand);
        return;
    }
    later([=, this] {
        if (wishes_.asked("tv")) return;
        if (chance(0.18f)) wall("fireplace", 1, for_fire, above_fire);
        else if (!wishes_.forbids("tv")) wall("tv_stand", 0.9f, for_screen, screen);
        // No seat looks at a bare wall.
        if (!l_.find("tv_stand") && !l_.find("fireplace"))
            wall("sideboard", 0.9f, {.wall = opposite, .center_pull = 1.2f, .window_pull = -0.5f},
                 [this](int side) { above(side, "picture", 0.9f); });
    });
}

void Furnisher::living() {
    seating_group();
    if (is_eaten_here()) eating_place(4);
    if (wishes_.asked("desk") || wishes_.asked("monitor")) working_place(1);
    wall("bookshelf", 0.75f, {.window_pull = -1});
    wall("sideboard", 0.5f, {.window_pull = -0.5f});
}

// Whether a table to eat at was asked for.
bool Furnisher::is_eaten_here() const { return wishes_.asked("dining_table") || wishes_.asked("dining_table_round"); }

void Furnisher::eating_place(int seats) {
    const char* klass = !wishes_.asked("dining_table") && wishes_.asked("dining_table_round") ? "dining_table_round"
                                                                                              : "dining_table";
    const auto found = main(klass, [this](const PieceRequest& r, const PromptObject& o) {
        auto i = l_.free_standing(r, o, spare_for(r.klass));
        // One that was asked for and finds no room is smaller.
        for (float size = 0.85f; !i && !o.klass.empty() && size > 0.6f; size -= 0.15f) {
            PieceRequest smaller = r;
            const Vec3f usual = make_piece(r).size_m;
            smaller.size_factor = 1.f, smaller.size_m = {usual.x * size, 0, usual.z * size};
            i = l_.free_standing(smaller, o, spare_for(r.klass));
        }
        return i;
    });
    if (!found) return;
    const int table = *found;
    const auto chairs_there = [this, table] {
        return static_cast<int>(std::count_if(l_.placed().begin(), l_.placed().end(), [&](const Placed& p) {
            return p.with == table && p.piece.klass == "chair";
        }));
    };
    // Chairs of one table are alike, and there are as many as were asked for.
    const int wished = wishes_.count("chair");
    if (const PromptObject* wish = wished > 0 ? wishes_.next("chair") : nullptr) {
        const int placed = l_.around(table, l_.request("chair", wish), wished, *wish);
        for (int i = 1; i < std::min(placed, wished); ++i) wishes_.next("chair");
        if (placed == 0) wishes_.give_back(wish);
    } else if (is_furnished() && !wishes_.asked("chair") && !wishes_.forbids("chair") && chairs_there() == 0) {
        l_.around(table, l_.request("chair"), seats);
    }
    const bool flowers = wishes_.asked("bouquet");  // they stand there
    top(table, !flowers && chance(0.6f) ? "vase" : "bowl", 0.9f);
    later([=, this] {
        if (chance(clutter_)) top(table, "candle", 0.7f);
    });
    const auto over_it = [=, this](const PieceRequest& r, const PromptObject& o) {
        const auto i = l_.hanging(r, flat(at(table).position), o);
        if (i) l_.join(*i, table);
        return i;
    };
    const char* over = "pendant_lamp";
    for (const char* lamp : {"chandelier", "bulb_pendant", "paper_lantern", "track_light", "ceiling_fan"})
        if (wishes_.asked(lamp)) over = lamp;
    put(over, std::string_view(over) == "pendant_lamp" ? 0.8f : 0.f, over_it);
    rug(table, 0.5f, size(table).x + 1.3f, size(table).z + 1.3f, 0);
}

void Furnisher::dining() {
    eating_place(6);
    wall("sideboard", 0.95f, {.center_pull = 1.2f, .window_pull = -0.5f}, [this](int side) {
        top(side, "vase", 0.8f);
        top(side, "table_lamp", 0.6f);
        top(side, "bowl", clutter_);
        above(side, chance(0.4f) ? "mirror" : "picture", 0.9f);
    });
    wall("bookshelf", 0.3f, {.window_pull = -1});
    reading_corner(0.2f);
}

void Furnisher::kitchen() {
    main("kitchen_counter", [this](const PieceRequest& r, const PromptObject& o) { return kitchen_units(r, o); });
    if (wishes_.asked("kitchen_island"))
        if (const auto island = main("kitchen_island", [this](const PieceRequest& r, const PromptObject& o) {
                return l_.free_standing(r, o);
            }))
            seats_at(*island);
    if (!l_.find("kitchen_island") || is_eaten_here()) eating_place(4);
    wall("fridge", 0.95f, {.center_pull = -0.5f, .window_pull = -1, .corner = true});
    wall("sideboard", 0.4f, {.window_pull = -0.5f});
    on_wall("shelf", 0.6f);
    on_wall("clock", 0.5f);
}

// Stools along an island, at most as many as fit.
void Furnisher::seats_at(int island) {
    const std::string klass = wishes_.asked("stool") ? "stool" : "bar_stool";
    const int wished = wishes_.count(klass);
    if (const PromptObject* wish = wished > 0 ? wishes_.next(klass) : nullptr) {
        const int placed = l_.around(island, l_.request(klass, wish), wished, *wish);
        for (int i = 1; i < std::min(placed, wished); ++i) wishes_.next(klass);
        if (placed == 0) wishes_.give_back(wish);
    } else if (is_furnished() && !wishes_.asked(klass) && !wishes_.forbids(klass)) {
        later([=, this] {
            if (chance(0.7f)) l_.around(island, l_.request(klass), 2);
        });
    }
}

void Furnisher::bathroom() {
    // The largest first: small rooms have one place for it.
    const bool shower = wishes_.asked("shower");
    const Layout::WallWish for_shower{.window_pull = -1, .corner = true};
    if (shower) main_at_wall("shower", for_shower);
    if (wishes_.asked("bathtub") || (!shower && chance(0.85f)))
        if (const auto tub = main_at_wall("bathtub", {.center_pull = 0, .window_pull = 0.5f, .corner = true}))
            rug(*tub, 0.8f, 0.9f, 0.55f, size(*tub).z / 2 + 0.35f);
    if (!l_.find("bathtub") && !shower) main_at_wall("shower", for_shower);
    if (const auto basin = main_at_wall("washbasin", {.center_pull = 0.6f, .window_pull = -1}))
        above(*basin, "mirror", 1);
    main_at_wall("toilet", {.center_pull = 0});
    wall("towel_rail", 0.9f, {.window_pull = -0.5f});
    wall("stool", 0.6f, {.center_pull = 0}, [this](int stool) { top(stool, "towel_stack", 0.8f); });
    wall("ladder_shelf", 0.6f, {.window_pull = -1});
    wall("basket", 0.7f, {.corner = true});
    on_wall("shelf", 0.7f);
}

void Furnisher::study() {
    working_place(1);
    wall("bookshelf", 1, {.window_pull = -1});
    wall("bookshelf", 0.8f, {.window_pull = -1});
    wall("sideboard", 0.4f, {.window_pull = -0.5f});
    reading_corner(0.9f);
    later([this] {
        if (const auto chair = l_.find("armchair")) rug(*chair, 0.5f, 1.8f, 1.3f, 0.5f);
        if (const auto desk = l_.find("desk")) rug(*desk, 0.8f, 2.4f, 1.7f, 0.7f);
    });
    on_wall("clock", 0.4f);
}

void Furnisher::hallway() {
    wall("sideboard", 0.7f, {}, [this](int side) {
        top(side, "vase", 0.8f);
        top(side, "bowl", 0.5f);
        above(side, "mirror", 0.9f);
    });
    wall("coat_rack", 0.9f, {.corner = true});
    wall("shoe_rack", 0.9f, {.center_pull = 0});
    wall("bench", 0.6f);
    later([this] {
        const auto anchor = l_.find("sideboard") ? l_.find("sideboard") : l_.find("bench");
        if (anchor) rug(*anchor, 0.8f, 2.2f, 0.8f, 0.9f);
    });
}

void Furnisher::laundry() {
    if (wishes_.asked("kitchen_counter"))
        main("kitchen_counter", [this](const PieceRequest& r, const PromptObject& o) { return kitchen_units(r, o); });
    if (const auto first = main_at_wall("washing_machine", {.window_pull = 0.3f})) {
        beside(*first, "washing_machine", 0.85f, 1, 0.02f);
        above(*first, "shelf", 0.9f);
    }
    wall("washbasin", 0.5f, {.window_pull = -0.5f});
    wall("basket", 1, {.corner = true});
    wall("basket", 0.7f, {.corner = true});
    wall("sideboard", 0.7f);
    wall("ladder_shelf", 0.6f, {.window_pull = -1});
    on_wall("shelf", 0.9f);
    wall("bench", 0.3f);
}

void Furnisher::sunroom() {
    // Who asks for a table with chairs sits there, and needs no sofa.
    const bool eats = is_eaten_here(),
               lounges = wishes_.asked("sofa") || wishes_.asked("loveseat") || wishes_.asked("coffee_table");
    if (eats) eating_place(2);
    if (!eats || lounges) seating_group();
    // Glass on three sides often leaves no wall for a sofa: then chairs about a low table.
    if (!eats && !l_.find("sofa") && !l_.find("loveseat")) {
        const auto table = main(
            "coffee_table", [this](const PieceRequest& r, const PromptObject& o) { return l_.free_standing(r, o); });
        const Vec2f middle = table ? flat(at(*table).position) : Vec2f{0, 0};
        for (int i = 0; i < 3; ++i)
            put("armchair", i < 2 ? 1.f : 0.5f,
                [=, this](const PieceRequest& r, const PromptObject& o) { return l_.angled_towards(middle, r, o); });
        if (table) {
            rug(*table, 0.9f, 2.4f, 1.7f, 0);
            top(*table, "book_stack", 0.8f);
            top(*table, "plant_small", 0.9f);
        }
    }
    // What is lower than the sills stands below them.
    wall("bench", 0.9f, {.window_pull = 1}, [this](int bench) { top(bench, "plant_small", 0.9f); });
    for (const char* klass : {"pouf", "basket"}) wall(klass, 0.8f, {.center_pull = 0, .window_pull = 0.5f});
    for (int i = 0; i < 4; ++i) wall("plant", 0.9f, {.center_pull = 0, .window_pull = 1, .corner = i < 2});
    reading_corner(0.7f);
}

void Furnisher::loft() {
    seating_group();
    eating_place(4);
    if (wishes_.asked("bed")) sleeping_place("bed");
    working_place(0.6f);
    wall("bookshelf", 0.8f, {.window_pull = -1});
    wall("sideboard", 0.5f);
    wall("plant", 0.8f, {.corner = true});
}

}  // namespace fastscene::furnishing
