#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/pack.h"

// What belongs into which room, and how the pieces stand to each other.
namespace fastscene {
namespace {

using WallWish = Layout::WallWish;

bool is_piece(std::string_view klass) { return std::binary_search(piece_classes().begin(), piece_classes().end(), klass); }
bool is_small(std::string_view klass) {
    static constexpr std::array<std::string_view, 36> kSmall{
        "table_lamp",    "vase",          "vase_small",  "book_stack",  "bowl",        "candle",
        "plant_small",   "picture",       "mirror",      "tv",          "clock",       "rug",
        "cushion",       "guitar",        "cat",         "alarm_clock", "bottles",     "cup",
        "cutting_board", "globe",         "kettle",      "laptop",      "magazines",   "photo_frame",
        "picture_ledge", "place_setting", "pot",         "sculpture",   "storage_box", "teddy_bear",
        "toaster",       "toiletries",    "towel_stack", "toy_blocks",  "tray",        "utensils"};
    return std::find(kSmall.begin(), kSmall.end(), klass) != kSmall.end();
}

// The prompt's wishes by class, taken one by one as the groups use them up.
class Wishes {
  public:
    explicit Wishes(PromptSpec& spec) : spec_(spec), left_(spec.objects.size()) {
        for (std::size_t i = 0; i < spec.objects.size(); ++i) left_[i] = spec.objects[i].forbidden ? 0 : spec.objects[i].count;
    }
    bool forbids(std::string_view klass) const {
        return std::any_of(spec_.objects.begin(), spec_.objects.end(), [&](const PromptObject& o) { return o.forbidden && o.klass == klass; });
    }
    // The next wish of this class that is not yet fulfilled; null: nobody asked.
    // Small things that were asked for at a certain piece ("a lamp on the desk") are only given for that one.
    const PromptObject* next(std::string_view klass, std::string_view at = {}) {
        for (std::size_t i = 0; i < left_.size(); ++i) {
            const PromptObject& o = spec_.objects[i];
            if (left_[i] <= 0 || o.klass != klass) continue;
            if (is_small(klass) && is_piece(o.relation_to) && o.relation_to != at) continue;
            return --left_[i], &o;
        }
        return nullptr;
    }
    bool has_at_window(std::string_view klass) const {
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (left_[i] > 0 && spec_.objects[i].klass == klass && spec_.objects[i].relation_to == "window") return true;
        return false;
    }
    bool has(std::string_view klass) const {
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (left_[i] > 0 && spec_.objects[i].klass == klass) return true;
        return false;
    }
    int count(std::string_view klass) const {
        int n = 0;
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (spec_.objects[i].klass == klass) n += left_[i];
        return n;
    }
    // Gives one back: it could not be placed where the group wanted it.
    void give_back(const PromptObject* wish) {
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (&spec_.objects[i] == wish) ++left_[i];
    }
    template <class F>
    void each_left(F&& f) {
        for (std::size_t i = 0; i < left_.size(); ++i)
            while (left_[i] > 0 && f(spec_.objects[i])) --left_[i];
    }

  private:
    PromptSpec& spec_;
    std::vector<int> left_;
};

// The furnisher: a layout, what is wished, and the usual arrangements.
class Furnisher {
  public:
    explicit Furnisher(Layout& layout) : l_(layout), wishes_(layout.spec()), clutter_(layout.plan().style.clutter) {
        const PromptSpec& spec = l_.spec();
        if (spec.clutter == "cluttered" || spec.mood == "cozy") clutter_ = std::min(1.f, clutter_ + 0.3f);
        if (spec.clutter == "bare") clutter_ = 0.1f;
        if (spec.clutter == "empty") clutter_ = 0.f;
    }

    void run() {
        const std::string& room = l_.spec().room;
        // What must stand at a window comes first, while the windows are free.
        if (wishes_.has_at_window("desk")) working_place(1);
        for (const char* klass : {"armchair", "bench", "piano", "piano", "console_table", "dresser", "plant", "plant_tree"})
            if (wishes_.has_at_window(klass)) wall(klass, 1);
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
        remaining_wishes();
        finish();
    }

  private:
    bool chance(float p) { return l_.dice().chance(p); }

    // Places through `how`, with the prompt's wish of this class if there is one. Unwished pieces need `probability`.
    template <class How>
    std::optional<int> put(const char* klass, float probability, How&& how, std::string_view at = {}) {
        if (wishes_.forbids(klass)) return {};
        const PromptObject* wish = wishes_.next(klass, at);
        if (!wish && (!is_furnished() || !chance(probability))) return {};
        const auto index = how(l_.request(klass, wish), wish ? *wish : PromptObject{});
        if (!index && wish) wishes_.give_back(wish);
        return index;
    }
    std::optional<int> wall(const char* klass, float probability, WallWish w = {}) {
        return put(klass, probability, [&](const PieceRequest& r, const PromptObject& o) {
            if (o.relation == "in the corner") w.corner = true;
            if (o.relation_to == "window") w.window_pull = 4.f, w.center_pull = 0.2f;
            if (const auto anchor = l_.find(o.relation_to)) w.near = front_point(*anchor, 0.f);
            if (const auto i = l_.against_wall(r, w, o)) return i;
            // Better below a window than not at all, when it was asked for.
            if (o.klass.empty() || !w.clear_of_windows) return std::optional<int>{};
            w.clear_of_windows = false;
            return l_.against_wall(r, w, o);
        });
    }
    std::optional<int> beside(int anchor, const char* klass, float probability, int side, float gap) {
        return put(klass, probability, [&](const PieceRequest& r, const PromptObject& o) { return l_.beside(anchor, r, side, gap, o); });
    }
    std::optional<int> before(int anchor, const char* klass, float probability, float gap, bool facing) {
        return put(klass, probability, [&](const PieceRequest& r, const PromptObject& o) { return l_.in_front_of(anchor, r, gap, facing, o); });
    }
    std::optional<int> top(int anchor, const char* klass, float probability) {
        return put(klass, probability, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_top(anchor, r, o); }, klass_of(anchor));
    }
    std::optional<int> above(int anchor, const char* klass, float probability) {
        return put(klass, probability, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, anchor, o); }, klass_of(anchor));
    }
    std::string klass_of(int i) const { return l_.placed()[static_cast<std::size_t>(i)].piece.klass; }
    std::optional<int> picture(float probability) {
        return put("picture", probability, [&](PieceRequest r, const PromptObject& o) {
            // Of many sizes; over a bare wall a large one first.
            const float w = l_.dice().uniform(0.4f, 1.25f);
            if (o.size.empty() && o.size_m == Vec3f{}) r.size_m = {w, w * l_.dice().uniform(0.62f, w < 0.7f ? 1.35f : 0.95f), 0};
            return l_.on_wall(r, {}, o);
        });
    }
    void rug(int anchor, float probability, float width, float depth, float shift) {
        put("rug", probability, [&](PieceRequest r, const PromptObject& o) {
            const float k = o.size == "large" ? 1.2f : o.size == "small" ? 0.75f : 1.f;
            const bool said = o.size_m.x > 0;
            for (const float shrink : {1.f, 0.8f, 0.6f}) {
                if (!said) r.size_m = {width * k * shrink, 0, depth * k * shrink};
                if (const auto i = l_.under(anchor, r, shift, o)) return i;
            }
            return std::optional<int>{};
        }, klass_of(anchor));
    }
    Vec2f front_point(int anchor, float far) const {
        const Placed& a = l_.placed()[static_cast<std::size_t>(anchor)];
        return flat(a.position + Vec3f{std::sin(a.yaw), 0, std::cos(a.yaw)} * (a.piece.size_m.z / 2 + far));
    }
    const Vec3f& size(int i) const { return l_.placed()[static_cast<std::size_t>(i)].piece.size_m; }
    float yaw(int i) const { return l_.placed()[static_cast<std::size_t>(i)].yaw; }
    // The wall that a piece with this back faces: 0..3.
    int wall_opposite(int anchor) const {
        const Placed& a = l_.placed()[static_cast<std::size_t>(anchor)];
        const Vec3f front{std::sin(a.yaw), 0, std::cos(a.yaw)};
        int best = 0;
        for (int w = 1; w < 4; ++w)
            if (dot(l_.plan().wall(w).inward, front) < dot(l_.plan().wall(best).inward, front)) best = w;
        return best;
    }

    void sleeping_place(const char* klass) {
        const auto bed = wall(klass, 1, {.center_pull = 1.2f, .window_pull = -0.8f});
        if (!bed) return;
        for (const int side : {-1, 1})
            if (const auto stand = beside(*bed, "nightstand", side < 0 ? 1.f : 0.75f, side, 0.08f)) {
                top(*stand, "table_lamp", 0.9f);
                if (chance(clutter_)) top(*stand, chance(0.5f) ? "book_stack" : "vase", 1);
            }
        above(*bed, "picture", 0.75f);
        rug(*bed, 0.75f, size(*bed).x + 1.1f, 1.9f, 0.75f);
        if (wishes_.has("bench") || chance(0.35f)) before(*bed, "bench", 1, 0.06f, false);
        if (wishes_.has("ottoman")) before(*bed, "ottoman", 1, 0.1f, false);
    }
    void reading_corner(float probability) {
        if (!wishes_.has("armchair") && !chance(probability)) return;
        const Vec2f middle{0, 0};
        const auto chair = put("armchair", 1, [&](const PieceRequest& r, const PromptObject& o) {
            if (o.relation.empty() || o.relation == "in the corner") {
                if (const auto i = l_.angled_towards(middle, r, o)) return i;
            }
            return l_.against_wall(r, {.window_pull = 1.2f, .corner = o.relation == "in the corner"}, o);
        });
        if (!chair) return;
        const int side = chance(0.5f) ? 1 : -1;
        if (const auto table = beside(*chair, "side_table", 0.6f, side, 0.05f)) top(*table, chance(0.5f) ? "book_stack" : "vase", 0.9f);
        beside(*chair, "floor_lamp", 0.5f, -side, 0.05f);
    }
    void bedroom() {
        sleeping_place("bed");
        wall("wardrobe", 0.85f, {.window_pull = -1});
        wall("dresser", 0.55f, {.window_pull = -0.5f});
        if (wishes_.has("desk") || chance(0.2f)) working_place(0.3f);
        reading_corner(0.5f);
        wall("mirror", 0.4f);
    }
    void kids_room() {
        if (wishes_.has("crib")) sleeping_place("crib");
        else sleeping_place(wishes_.has("bed") ? "bed" : "bed_single");
        wall("toy_box", 0.9f, {.center_pull = 0});
        wall("bookshelf", 0.8f, {.window_pull = -1});
        working_place(0.6f);
        wall("wardrobe", 0.4f, {.window_pull = -1});
        wall("rocking_horse", 0.35f, {.center_pull = 0, .corner = true});
        wall("basket", 0.7f, {.corner = true});
    }
    std::optional<int> working_place(float probability) {
        if (!wishes_.has("desk") && (l_.find("desk") || !chance(probability))) return l_.find("desk");
        const auto desk = wall("desk", 1, {.center_pull = 0.5f, .window_pull = 0.8f});
        if (!desk) return {};
        before(*desk, wishes_.has("chair") && !wishes_.has("office_chair") ? "chair" : "office_chair", 1, -0.2f, true) ||
            before(*desk, "chair", 1, 0.05f, true);
        top(*desk, "table_lamp", 0.85f);
        return desk;
    }
    void seating_group() {
        const char* main = !wishes_.has("sofa") && wishes_.has("loveseat") ? "loveseat" : "sofa";
        const auto sofa = wall(main, 1, {.center_pull = 1.f, .window_pull = -0.3f});
        if (!sofa) return;
        rug(*sofa, 0.9f, size(*sofa).x + 0.5f, 1.9f, size(*sofa).z / 2 + 0.55f);
        const auto table = before(*sofa, "coffee_table", 0.95f, 0.42f, false);
        if (table) {
            top(*table, "book_stack", 0.7f);
            top(*table, chance(0.5f) ? "vase" : "bowl", 0.7f);
            top(*table, "candle", clutter_ * 0.6f);
        }
        above(*sofa, "picture", 0.85f);
        const int side = chance(0.5f) ? 1 : -1;
        if (const auto end = beside(*sofa, "side_table", 0.6f, side, 0.06f)) top(*end, "table_lamp", 0.8f);
        beside(*sofa, "floor_lamp", 0.65f, -side, 0.06f);
        // What the sofa looks at.
        const int opposite = wall_opposite(*sofa);
        if (wishes_.has("fireplace") || (!wishes_.has("tv") && chance(0.18f))) {
            if (const auto fire = wall("fireplace", 1, {.wall = opposite, .center_pull = 1.5f, .clear_of_windows = true}))
                above(*fire, chance(0.5f) ? "mirror" : "picture", 0.7f);
        } else if (!wishes_.forbids("tv")) {
            if (const auto stand = wall("tv_stand", 0.85f, {.wall = opposite, .center_pull = 1.5f, .window_pull = -2, .clear_of_windows = true})) {
                if (!top(*stand, "tv", 0.9f)) above(*stand, "tv", 0.8f);
                if (chance(clutter_)) top(*stand, "book_stack", 0.6f);
            }
        }
        const Vec2f focus = front_point(*sofa, 0.6f);
        const int chairs = std::max(wishes_.count("armchair"), chance(0.65f) ? 1 : 0);
        for (int i = 0; i < chairs; ++i)
            put("armchair", 1, [&](const PieceRequest& r, const PromptObject& o) {
                if (const auto index = l_.angled_towards(focus, r, o)) return index;
                return l_.against_wall(r, {}, o);
            });
        if (table)
            put("ottoman", 0.3f, [&](const PieceRequest& r, const PromptObject& o) { return l_.beside(*table, r, chance(0.5f) ? 1 : -1, 0.2f, o); });
        if (main[0] == 's' && wishes_.has("loveseat")) wall("loveseat", 1);
    }
    void living() {
        seating_group();
        wall("bookshelf", 0.75f, {.window_pull = -1});
        wall("sideboard", 0.5f, {.window_pull = -0.5f});
        if (wishes_.has("dining_table")) eating_place(4);
        if (wishes_.has("desk")) working_place(1);
    }
    void eating_place(int seats) {
        const auto table = put("dining_table", 1, [&](const PieceRequest& r, const PromptObject& o) { return l_.free_standing(r, o); });
        if (!table) return;
        const int wished = wishes_.count("chair");
        const PromptObject* wish = wishes_.next("chair");
        if (wish && wish->counted) seats = 0;  // "four chairs" are four
        if (!wish && (!is_furnished() || wishes_.forbids("chair"))) seats = 0;
        const int placed = l_.around(*table, l_.request("chair", wish), std::max(wished, seats), wish ? *wish : PromptObject{});
        for (int i = 1; i < std::min(placed, wished); ++i) wishes_.next("chair");
        if (placed == 0 && wish) wishes_.give_back(wish);
        top(*table, chance(0.6f) ? "vase" : "bowl", 0.9f);
        if (chance(clutter_)) top(*table, "candle", 0.7f);
        const Placed& t = l_.placed()[static_cast<std::size_t>(*table)];
        const Vec2f at = flat(t.position);
        if (!wishes_.has("chandelier"))
            put("pendant_lamp", 0.8f, [&](const PieceRequest& r, const PromptObject& o) { return l_.hanging(r, at, o); });
        else
            put("chandelier", 1, [&](const PieceRequest& r, const PromptObject& o) { return l_.hanging(r, at, o); });
        rug(*table, 0.5f, size(*table).x + 1.3f, size(*table).z + 1.3f, 0);
    }
    void dining() {
        eating_place(6);
        if (const auto side = wall("sideboard", 0.95f, {.center_pull = 1.2f, .window_pull = -0.5f})) {
            top(*side, "vase", 0.8f);
            top(*side, "table_lamp", 0.6f);
            top(*side, "bowl", clutter_);
            above(*side, chance(0.4f) ? "mirror" : "picture", 0.9f);
        }
        wall("bookshelf", 0.3f, {.window_pull = -1});
        reading_corner(0.2f);
    }
    void kitchen() {
        // The run of units fills a wall, as far as windows and the door leave it; a short one is better than none.
        for (const int w : {0, 1, 3, 2}) {
            const float length = l_.plan().wall(w).length;
            const auto counter = put("kitchen_counter", 1, [&](PieceRequest r, const PromptObject& o) -> std::optional<int> {
                for (const float width : {length - 0.1f, length - 0.8f, length * 0.6f, 2.2f, 1.8f}) {
                    r.size_m = {width, 0, 0};
                    if (const auto i = l_.against_wall(r, {.wall = w}, o)) return i;
                }
                return {};
            });
            if (counter) break;
        }
        wall("fridge", 0.95f, {.center_pull = -0.5f, .window_pull = -1, .corner = true});
        if (wishes_.has("kitchen_island"))
            if (const auto island = put("kitchen_island", 1, [&](const PieceRequest& r, const PromptObject& o) { return l_.free_standing(r, o); }))
                seats_at(*island);
        if (!l_.find("kitchen_island") || wishes_.has("dining_table")) eating_place(4);
        wall("sideboard", 0.4f, {.window_pull = -0.5f});
        put("shelf", 0.6f, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, {}, o); });
        put("clock", 0.5f, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, {}, o); });
    }
    // Stools along an island.
    void seats_at(int island) {
        const char* klass = wishes_.has("stool") ? "stool" : "bar_stool";
        if (wishes_.forbids(klass) || (!wishes_.has(klass) && (!is_furnished() || !chance(0.7f)))) return;
        const int wished = wishes_.count(klass);
        const PromptObject* wish = wishes_.next(klass);
        const int placed = l_.around(island, l_.request(klass, wish), std::max(wished, wish ? 1 : 2), wish ? *wish : PromptObject{});
        for (int i = 1; i < std::min(placed, wished); ++i) wishes_.next(klass);
        if (placed == 0 && wish) wishes_.give_back(wish);
    }
    void bathroom() {
        wall("bathtub", wishes_.has("shower") ? 0.f : 0.85f, {.center_pull = 0, .window_pull = 0.5f, .corner = true});
        if (!l_.find("bathtub") || wishes_.has("shower")) wall("shower", 1, {.window_pull = -1, .corner = true});
        if (const auto basin = wall("washbasin", 1, {.center_pull = 0.6f, .window_pull = -1})) above(*basin, "mirror", 1);
        wall("toilet", 1, {.center_pull = 0});
        wall("towel_rail", 0.9f, {.window_pull = -0.5f});
        if (const auto stool = wall("stool", 0.6f, {.center_pull = 0})) top(*stool, "towel_stack", 0.8f);
        wall("ladder_shelf", 0.6f, {.window_pull = -1});
        wall("basket", 0.7f, {.corner = true});
        put("shelf", 0.7f, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, {}, o); });
        if (const auto tub = l_.find("bathtub")) rug(*tub, 0.8f, 0.9f, 0.55f, size(*tub).z / 2 + 0.35f);
    }
    void study() {
        working_place(1);
        wall("bookshelf", 1, {.window_pull = -1});
        wall("bookshelf", 0.8f, {.window_pull = -1});
        wall("sideboard", 0.4f, {.window_pull = -0.5f});
        reading_corner(0.9f);
        if (const auto chair = l_.find("armchair")) rug(*chair, 0.5f, 1.8f, 1.3f, 0.5f);
        if (const auto desk = l_.find("desk")) rug(*desk, 0.8f, 2.4f, 1.7f, 0.7f);
        put("clock", 0.4f, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, {}, o); });
    }
    void hallway() {
        if (const auto side = wall("sideboard", 0.7f)) {
            top(*side, "vase", 0.8f);
            top(*side, "bowl", 0.5f);
            above(*side, "mirror", 0.9f);
        }
        wall("coat_rack", 0.9f, {.corner = true});
        wall("shoe_rack", 0.9f, {.center_pull = 0});
        wall("bench", 0.6f);
        const auto anchor = l_.find("sideboard") ? l_.find("sideboard") : l_.find("bench");
        if (anchor) rug(*anchor, 0.8f, 2.2f, 0.8f, 0.9f);
    }
    void laundry() {
        wall("washing_machine", 1, {.window_pull = 0.3f});
        if (const auto first = l_.find("washing_machine")) {
            beside(*first, "washing_machine", 0.85f, 1, 0.02f);
            above(*first, "shelf", 0.9f);
        }
        wall("washbasin", 0.5f, {.window_pull = -0.5f});
        wall("basket", 1, {.corner = true});
        wall("basket", 0.7f, {.corner = true});
        wall("sideboard", 0.7f);
        wall("ladder_shelf", 0.6f, {.window_pull = -1});
        put("shelf", 0.9f, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, {}, o); });
        wall("bench", 0.3f);
    }
    void sunroom() {
        seating_group();
        // Glass on three sides often leaves no wall for a sofa: then chairs about a low table.
        if (!l_.find("sofa") && !l_.find("loveseat")) {
            const auto table = put("coffee_table", 1, [&](const PieceRequest& r, const PromptObject& o) { return l_.free_standing(r, o); });
            const Vec2f middle = table ? flat(l_.placed()[static_cast<std::size_t>(*table)].position) : Vec2f{0, 0};
            for (int i = 0; i < 3; ++i)
                put("armchair", i < 2 ? 1.f : 0.5f, [&](const PieceRequest& r, const PromptObject& o) { return l_.angled_towards(middle, r, o); });
            if (table) {
                rug(*table, 0.9f, 2.4f, 1.7f, 0);
                top(*table, "book_stack", 0.8f);
                top(*table, "plant_small", 0.9f);
            }
        }
        // What is lower than the sills stands below them.
        if (const auto bench = wall("bench", 0.9f, {.window_pull = 1})) top(*bench, "plant_small", 0.9f);
        for (const char* klass : {"pouf", "basket"}) wall(klass, 0.8f, {.center_pull = 0, .window_pull = 0.5f});
        for (int i = 0; i < 4; ++i) wall("plant", 0.9f, {.center_pull = 0, .window_pull = 1, .corner = i < 2});
        reading_corner(0.7f);
    }
    void loft() {
        seating_group();
        eating_place(4);
        if (wishes_.has("bed")) sleeping_place("bed");
        working_place(0.6f);
        wall("bookshelf", 0.8f, {.window_pull = -1});
        wall("sideboard", 0.5f);
        wall("plant", 0.8f, {.corner = true});
    }

    // On a low piece, else on a wall, else it gets a stand of its own.
    std::optional<int> television(const PieceRequest& r, const PromptObject& wish) {
        for (const char* klass : {"tv_stand", "sideboard", "dresser", "console_table"})
            if (const auto anchor = l_.find(klass))
                if (const auto i = l_.on_top(*anchor, r, wish)) return i;
        if (const auto stand = l_.against_wall(l_.request("tv_stand"), {.window_pull = -2, .clear_of_windows = true}))
            if (const auto i = l_.on_top(*stand, r, wish)) return i;
        return l_.on_wall(r, {}, wish);
    }

    // Along a wall or free, but only where the wish says.
    std::optional<int> where_asked(const PromptObject& wish, const PieceRequest& r, const Piece& piece) {
        if (wish.relation.empty() || piece.mount != Mount::floor || wish.klass == "rug") return {};
        l_.insist(true);
        auto i = wish.relation == "in the middle" ? std::optional<int>{} : l_.against_wall(r, {}, wish);
        if (!i) i = l_.free_standing(r, wish);
        l_.insist(false);
        return i;
    }

    // A wish that no group has used: placed by what kind of piece it is.
    std::optional<int> anywhere(const PromptObject& wish) {
        const PieceRequest r = l_.request(wish.klass, &wish);
        const Piece piece = make_piece(r);
        if (!wish.relation_to.empty())
            if (const auto anchor = l_.find(wish.relation_to)) {
                if (wish.relation == "on")
                    if (const auto i = l_.on_top(*anchor, r, wish)) return i;
                if (wish.relation == "above" && piece.mount == Mount::wall)
                    if (const auto i = l_.on_wall(r, *anchor, wish)) return i;
                if (wish.relation == "in front of" && piece.mount == Mount::floor)
                    if (const auto i = l_.in_front_of(*anchor, r, 0.4f, false, wish)) return i;
                if (piece.mount == Mount::floor)
                    for (const int side : {1, -1})
                        if (const auto i = l_.beside(*anchor, r, side, 0.08f, wish)) return i;
            }
        if (wish.klass == "tv") return television(r, wish);
        if (const auto i = where_asked(wish, r, piece)) return i;
        switch (piece.mount) {
            case Mount::surface: {
                auto i = l_.on_any_top(r, wish);
                // Where nothing else stands ("only a mattress and a candle") small things stand on the floor.
                if (!i && !is_furnished()) i = l_.on_floor_near({0, 0}, r, wish);
                return i;
            }
            case Mount::wall: return l_.on_wall(r, {}, wish);
            case Mount::ceiling:
                for (const Vec2f at : {Vec2f{0, 0}, Vec2f{0.7f, 0.5f}, Vec2f{-0.8f, -0.5f}, Vec2f{0, 1.2f}, Vec2f{0, -1.2f}})
                    if (const auto i = l_.hanging(r, at, wish)) return i;
                return {};
            case Mount::floor: break;
        }
        if (wish.klass == "rug") {
            PieceRequest sized = r;
            sized.size_m = {1.6f, 0, 1.1f};
            for (std::size_t i = 0; i < l_.placed().size(); ++i)
                if (const auto k = l_.under(static_cast<int>(i), sized, 0.9f, wish)) return k;
            return {};
        }
        WallWish w;
        w.corner = wish.relation == "in the corner" || wish.klass == "plant";
        w.window_pull = wish.relation_to == "window" ? 2.f : piece.size_m.y > 1.2f ? -1.f : 0.f;
        w.center_pull = 0.4f;
        w.clear_of_windows = wish.klass == "fireplace" || wish.klass == "tv_stand";
        if (const auto i = l_.against_wall(r, w, wish)) return i;
        w.clear_of_windows = w.corner = false;
        if (const auto i = l_.against_wall(r, w, wish)) return i;
        return l_.free_standing(r, wish);
    }
    // Our own small pieces by their class, those of the pack by how they are mounted.
    bool stands_on_others(const PromptObject& wish) {
        if (is_small(wish.klass)) return true;
        const PackModel* model = l_.spec().pack ? l_.spec().pack->choose(wish.klass, 0) : nullptr;
        return (model && model->elevation_m + model->size_m.y < 0.8f && model->size_m.x < 0.55f) || is_small(stand_in(wish.klass).value_or(""));
    }
    bool on_a_seat(const PromptObject& wish) {
        const PieceRequest r = l_.request(wish.klass, &wish);
        for (const char* klass : {"sofa", "loveseat", "bed", "bed_single", "armchair", "bench"})
            for (std::size_t i = 0; i < l_.placed().size(); ++i)
                if (klass_of(static_cast<int>(i)) == klass && l_.on_top(static_cast<int>(i), r, wish)) return true;
        return false;
    }
    // The large pieces first: the small ones stand on them.
    void remaining_wishes() {
        for (const bool small : {false, true}) {
            wishes_.each_left([&](const PromptObject& wish) {
                if (is_shell(wish.klass) || wish.klass == "curtain") return true;
                if (stands_on_others(wish) != small) return false;
                if (wish.klass == "cushion" && on_a_seat(wish)) return true;
                if (const std::string why = l_.why_not(wish.klass); !why.empty()) l_.spec().not_placed.push_back(wish.words + ": " + why);
                else if (!anywhere(wish) && !l_.give_way([&] { return anywhere(wish).has_value(); }))
                    l_.spec().not_placed.push_back(wish.words + ": no free place for it");
                return true;
            });
        }
    }

    // What makes a room lived in: curtains, plants, pictures, light, small things.
    void finish() {
        const PromptObject* curtain = nullptr;
        for (const PromptObject& o : l_.spec().objects)
            if (o.klass == "curtain" && !o.forbidden) curtain = &o;
        const std::string& room = l_.spec().room;
        const bool wet = room == "bathroom" || room == "kitchen" || room == "laundry" || room == "loft" || room == "sunroom";
        if (!wishes_.forbids("curtain") && (curtain || (!wet && is_furnished()))) {
            const int hung = l_.at_windows(l_.request("curtain", curtain), curtain ? *curtain : PromptObject{});
            if (curtain && hung == 0) l_.spec().not_placed.push_back(curtain->words + ": no window has room for them");
        }

        if (!l_.find("pendant_lamp") && !l_.find("chandelier") && !wishes_.forbids("ceiling_lamp")) {
            const bool grand = l_.plan().style.mouldings == Mouldings::rich && l_.plan().height > 2.7f && !wet;
            const auto lamp = put(grand ? "chandelier" : "ceiling_lamp", 0.9f, [&](const PieceRequest& r, const PromptObject& o) {
                return l_.hanging(r, {0, 0.2f}, o);
            });
            (void)lamp;
        }
        const int plants = static_cast<int>(std::lround(l_.plan().style.plants * 3.f));
        for (int i = 0; i < plants && l_.count("plant") < 4; ++i) wall("plant", 0.8f, {.center_pull = 0, .window_pull = 0.8f, .corner = true});
        const int pictures = 1 + static_cast<int>(std::lround(clutter_ * 3.f));
        for (int i = 0; i < pictures && l_.count("picture") < 5; ++i) picture(wet && room != "loft" ? 0.4f : 0.8f);
        put("shelf", 0.4f * clutter_, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, {}, o); });
        wall("basket", 0.5f * clutter_, {.center_pull = 0, .corner = true});
        // After sunset a room wants light from more than its ceiling.
        const PromptSpec& spec = l_.spec();
        const bool dark = spec.time == "night" || spec.time == "dusk" || spec.light == "lamps on";
        const bool damp = room == "bathroom" || room == "kitchen" || room == "laundry";
        wall("floor_lamp", l_.count("floor_lamp") > (dark ? 1 : 0) || damp ? 0.f : dark ? 1.f : wet ? 0.f : 0.5f, {.center_pull = 0, .corner = true});
        static constexpr std::array<const char*, 5> kSmall{"book_stack", "vase", "bowl", "candle", "book_stack"};
        const int small = static_cast<int>(std::lround(3 + 7 * clutter_));
        for (int i = 0; i < small; ++i) {
            const char* klass = kSmall[static_cast<std::size_t>(l_.dice().index(static_cast<int>(kSmall.size())))];
            put(klass, 1, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_any_top(r, o); });
        }
        if (is_furnished()) add_touches(l_, clutter_);
    }
    // "only a bed": nothing stands that nobody asked for.
    bool is_furnished() const { return l_.spec().clutter != "empty"; }

    Layout& l_;
    Wishes wishes_;
    float clutter_;
};

}  // namespace

void furnish(Layout& layout) { Furnisher(layout).run(); }

}  // namespace fastscene
