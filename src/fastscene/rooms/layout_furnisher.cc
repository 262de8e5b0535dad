// The furnisher's order, and how it places single pieces.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene::furnishing {

std::string_view for_a_child(std::string_view thing) {
    const Thing* row = find_thing(thing);
    return row && !row->for_child.empty() ? std::string_view(row->for_child) : thing;
}

std::string picture_for_a_child(Layout& layout) {
    static constexpr std::array<std::string_view, 16> kMotifs{
        "dinosaur", "rocket", "bear",     "rainbow",   "fox",   "whale", "train",  "rabbit",
        "lion",     "moon",   "elephant", "butterfly", "robot", "bird",  "planet", "star"};
    if (layout.dice().chance(0.2f)) return {};
    // One after the other, so that no two are alike.
    const auto first = static_cast<std::size_t>(hash_name(layout.spec().text) % kMotifs.size());
    return std::string(kMotifs[(first + 5 * static_cast<std::size_t>(layout.count("picture"))) % kMotifs.size()]);
}

Furnisher::Furnisher(Layout& layout) : l_(layout), wishes_(layout.spec()), clutter_(layout.plan().style.clutter) {
    const PromptSpec& spec = l_.spec();
    if (spec.clutter == "cluttered" || spec.mood == "cozy") clutter_ = std::min(1.f, clutter_ + 0.3f);
    if (spec.clutter == "messy") clutter_ = 1.f;
    if (spec.clutter == "bare") clutter_ = 0.1f;
    if (is_left() || !is_furnished() || spec.clutter == "minimal") clutter_ = 0.f;
}

void Furnisher::run() {
    asked_in_the_shell();
    groups();
    remaining_wishes(false);
    adding_ = true;
    for (const auto& add : later_) add();
    remaining_wishes(true);  // small things that may stand anywhere: what came later carries them too
    l_.improve();
    finish();
    reveal();
}

void Furnisher::later(std::function<void()> what) {
    if (adding_) what();
    else later_.push_back(std::move(what));
}

void Furnisher::put(const std::string& klass, float probability, const How& how, const Then& then) {
    if (wishes_.forbids(klass)) return;
    const PromptObject* wish = wishes_.next(klass);
    if (!wish && (!is_furnished() || is_settled(l_.spec(), klass))) return;
    // Who left took the pictures, and the plants have died; who likes few things has half of what others have.
    if (!wish && is_left() && has_role(klass, Role::moves_out)) return;
    if (!wish && l_.spec().clutter == "minimal") probability *= 0.5f;
    if (!wish && !adding_) {
        if (probability > 0) later_.push_back([=, this] { put(klass, probability, how, then); });
        return;
    }
    if (!wish && !chance(probability)) return;
    const auto index = how(l_.request(klass, wish), wish ? *wish : PromptObject{});
    if (!index) return wishes_.give_back(wish);
    attend(*index);
    if (then) then(*index);
}

std::optional<int> Furnisher::main(const std::string& klass, const How& how) {
    if (wishes_.forbids(klass)) return {};
    // Asked for at another piece ("a sofa opposite the fireplace"): that one first.
    for (const Ask& ask : wishes_.asks())
        if (ask.left > 0 && ask.wish->klass == klass && ask.at_piece() && ask.at != klass) {
            summon(std::string(ask.at));
            break;
        }
    for (std::size_t i = 0; i < l_.placed().size(); ++i)
        if (l_.placed()[i].wish.klass == klass) return static_cast<int>(i);
    const PromptObject* wish = wishes_.next(klass);
    if (!wish && !is_furnished()) return {};
    const auto index = how(l_.request(klass, wish), wish ? *wish : PromptObject{});
    if (index) attend(*index);
    else wishes_.give_back(wish);
    return index;
}

std::optional<int> Furnisher::main_at_wall(const std::string& klass, Layout::WallWish wish) {
    return main(klass, [&](const PieceRequest& r, const PromptObject& o) { return at_wall(r, wish, o); });
}

std::optional<int> Furnisher::at_wall(const PieceRequest& r, Layout::WallWish w, const PromptObject& o) {
    w.spare = spare_for(o.klass.empty() ? r.klass : o.klass);
    if (const auto i = l_.against_wall(r, w, o)) return i;
    if (r.pattern == "corner") {
        PieceRequest straight = r;
        straight.pattern.clear();
        if (const auto i = l_.against_wall(straight, w, o)) {
            l_.spec().assumed.push_back("shape of the " + o.words + ": straight, there is no room for its corner");
            return i;
        }
    }
    // Better below a window than not at all, when it was asked for.
    if (o.klass.empty() || !w.clear_of_windows) return {};
    w.clear_of_windows = false;
    return l_.against_wall(r, w, o);
}

void Furnisher::wall(const std::string& klass, float probability, Layout::WallWish w, const Then& then) {
    put(
        klass, probability, [=, this](const PieceRequest& r, const PromptObject& o) { return at_wall(r, w, o); }, then);
}

void Furnisher::beside(int anchor, const std::string& klass, float probability, int side, float gap, const Then& then) {
    put(
        klass, probability,
        [=, this](const PieceRequest& r, const PromptObject& o) { return l_.beside(anchor, r, side, gap, o); }, then);
}

void Furnisher::before(int anchor, const std::string& klass, float probability, float gap, bool facing,
                       const Then& then) {
    put(
        klass, probability,
        [=, this](const PieceRequest& r, const PromptObject& o) { return l_.in_front_of(anchor, r, gap, facing, o); },
        then);
}

void Furnisher::top(int anchor, const std::string& klass, float probability) {
    put(klass, probability,
        [=, this](const PieceRequest& r, const PromptObject& o) { return l_.on_top(anchor, r, o); });
}

void Furnisher::above(int anchor, const std::string& klass, float probability) {
    put(klass, probability,
        [=, this](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, anchor, o); });
}

void Furnisher::on_wall(const std::string& klass, float probability) {
    put(klass, probability, [=, this](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, {}, o); });
}

void Furnisher::picture(float probability) {
    put("picture", probability, [this](PieceRequest r, const PromptObject& o) {
        // Of many sizes; over a bare wall a large one first.
        const float w = l_.dice().uniform(0.4f, 1.25f);
        if (o.size.empty() && o.size_m == Vec3f{})
            r.size_m = {w, w * l_.dice().uniform(0.62f, w < 0.7f ? 1.35f : 0.95f), 0};
        if (l_.spec().room == "kids" && o.klass.empty()) r.pattern = picture_for_a_child(l_);
        return l_.on_wall(r, {}, o);
    });
}

std::optional<int> Furnisher::laid_under(int anchor, PieceRequest r, Vec2f wanted, float shift, const PromptObject& o) {
    const float k = o.size == "large" ? 1.2f : o.size == "small" ? 0.75f : 1.f;
    for (const float shrink : {1.f, 0.8f, 0.6f}) {
        if (!(o.size_m.x > 0)) r.size_m = {wanted.x * k * shrink, 0, wanted.y * k * shrink};
        if (const auto i = l_.under(anchor, r, shift, o)) return i;
    }
    return {};
}

void Furnisher::rug(int anchor, float probability, float width, float depth, float shift) {
    put("rug", probability, [=, this](const PieceRequest& r, const PromptObject& o) {
        return laid_under(anchor, r, {width, depth}, shift, o);
    });
}

Vec2f Furnisher::front_point(int anchor, float far) const {
    return flat(at(anchor).position + front_of(at(anchor).yaw) * (size(anchor).z / 2 + far));
}

// The wall that a piece with this back faces: 0..3.
int Furnisher::wall_opposite(int anchor) const {
    const Vec3f front = front_of(at(anchor).yaw);
    int best = 0;
    for (int w = 1; w < 4; ++w)
        if (dot(l_.plan().wall(w).inward, front) < dot(l_.plan().wall(best).inward, front)) best = w;
    return best;
}

// What makes a room lived in: curtains, plants, pictures, light, small things.
void Furnisher::finish() {
    const PromptSpec& spec = l_.spec();
    const std::string& room = l_.spec().room;
    const bool wet = room == "bathroom" || room == "kitchen" || room == "laundry" || room == "loft" ||
                     room == "sunroom";
    const bool blinds = std::any_of(wishes_.asks().begin(), wishes_.asks().end(),
                                    [](const Ask& a) { return is_blind(a.wish->klass); });
    if (!wishes_.forbids("curtain") && !wishes_.asked("curtain") && !blinds && !wet && is_furnished() && !is_left())
        l_.at_windows(l_.request("curtain"));
    if (!l_.plan().asked("recessed_lights") &&
        std::none_of(l_.placed().begin(), l_.placed().end(),
                     [](const Placed& p) { return lights_from_above(p.piece.klass); })) {
        const bool grand = l_.plan().style.mouldings == Mouldings::rich && l_.plan().height > 2.7f && !wet;
        put(grand && !wishes_.forbids("chandelier") ? "chandelier" : "ceiling_lamp", 0.9f,
            [&](const PieceRequest& r, const PromptObject& o) {
                return l_.hanging(r, {0, 0.2f}, o);
            });
    }
    const int plants = is_left() ? 0
                                 : std::min(spec.clutter == "minimal" ? 1 : 9,
                                            static_cast<int>(std::lround(l_.plan().style.plants * 3.f)));
    for (int i = 0; i < plants && l_.count("plant") < 4; ++i)
        wall("plant", 0.8f, {.center_pull = 0, .window_pull = 0.8f, .corner = true});
    const int pictures = is_left() ? 0 : 1 + static_cast<int>(std::lround(clutter_ * 3.f));
    for (int i = 0; i < pictures && l_.count("picture") < 5; ++i) picture(wet && room != "loft" ? 0.4f : 0.8f);
    on_wall("shelf", 0.4f * clutter_);
    wall("basket", 0.5f * clutter_, {.center_pull = 0, .corner = true});
    // After sunset a room wants light from more than its ceiling.
    const bool dark = spec.time == "night" || spec.time == "dusk" || spec.light == "lamps on";
    const bool damp = room == "bathroom" || room == "kitchen" || room == "laundry";
    wall("floor_lamp",
         l_.count("floor_lamp") > (dark ? 1 : 0) || damp ? 0.f
         : dark                                          ? 1.f
         : wet                                           ? 0.f
                                                         : 0.5f,
         {.center_pull = 0, .corner = true});
    static constexpr std::array<const char*, 5> kSmall{"book_stack", "vase", "bowl", "candle", "book_stack"};
    const int small = is_left() ? 0 : static_cast<int>(std::lround((spec.clutter == "minimal" ? 1 : 3) + 7 * clutter_));
    for (int i = 0; i < small; ++i) {
        std::string klass = kSmall[static_cast<std::size_t>(l_.dice().index(static_cast<int>(kSmall.size())))];
        if (room == "kids") klass = for_a_child(klass);
        put(klass, 1, [&](const PieceRequest& r, const PromptObject& o) { return l_.on_any_top(r, o); });
    }
    if (is_furnished() && !is_left()) add_touches(l_, clutter_);
}

}  // namespace fastscene::furnishing

namespace fastscene {

void furnish(Layout& layout) { furnishing::Furnisher(layout).run(); }

}  // namespace fastscene
