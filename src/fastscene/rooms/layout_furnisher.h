// The furnisher: fills a room, as the prompt asks and its type has it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fastscene/rooms/layout_place.h"

namespace fastscene::furnishing {

// The furnisher. Its one order: what was asked to stand somewhere in the shell, while that is free; the room's main
// pieces, each at once with all that was asked for at it; what else was asked for; then what a room of its type has
// besides; then clutter.
class Furnisher final : public Placement {
  public:
    explicit Furnisher(Layout& layout) : Placement(layout) {}
    void run();
    void place_asked();

    // ---- layout_asked.cc: what was asked for
    void attend(int index) override;
    void summon(const std::string& kind) override;
    Spare spare_for(const std::string& kind) override;

  private:
    // ---- layout_furnisher.cc
    void picture(float probability);
    void finish();
    // ---- layout_reveal.cc: what was asked for is seen
    void reveal();
    void uncover(Vec3f eye);

    // ---- layout_asked.cc: what was asked for
    Spare spare_for(const PromptObject& wish, const Piece& piece);
    void asked_in_the_shell();
    void remaining_wishes(bool small);
    std::optional<int> at_piece(int anchor, const Ask& ask);
    std::optional<int> on_piece(int anchor, const Ask& ask, const PieceRequest& r);
    std::optional<int> at_the_foot(int anchor, const PieceRequest& r, const PromptObject& wish);
    std::optional<int> above_piece(int anchor, const Ask& ask, const PieceRequest& r, const Piece& piece);
    std::optional<int> under_piece(int anchor, const Ask& ask, const PieceRequest& r, const Piece& piece);
    std::optional<int> before_piece(int anchor, const Ask& ask, const PieceRequest& r);
    std::optional<int> next_to_piece(int anchor, const Ask& ask, const PieceRequest& r);
    std::optional<int> rug_at(int anchor, const Ask& ask, const PieceRequest& r);
    std::optional<int> in_shell(const Ask& ask);
    // Where the words say, searched for everywhere.
    std::optional<int> where_asked(const PromptObject& wish, const PieceRequest& r, const Piece& piece);
    std::optional<int> on_a_top_there(const PromptObject& wish, const PieceRequest& r, std::optional<int> anchor);
    std::optional<int> next_in_row(const PromptObject& wish, const PieceRequest& r);
    std::optional<int> on_a_table_of_its_own(const PieceRequest& r, const PromptObject& wish);
    std::optional<int> anywhere(const PromptObject& wish);
    std::optional<int> strewn(const PieceRequest& r, const PromptObject& wish);
    std::optional<int> television(const PieceRequest& r, const PromptObject& wish);
    bool stands_on_others(const PromptObject& wish) const;
    // A lamp on the wall beside a bed, a mirror, a picture, a fire: the emptier side of the first that has not two.
    std::optional<int> wall_lamp(const PieceRequest& r, const PromptObject& wish);
    std::optional<int> wall_lamp_at(int anchor, const PieceRequest& r, const PromptObject& wish);
    // Where nobody's head is: beside windows, in corners.
    std::optional<int> hung_aside(const PieceRequest& r, const PromptObject& wish);
    bool on_a_seat(const PromptObject& wish);

    std::vector<std::string> summoned_;  // classes that another piece waited for
};

}  // namespace fastscene::furnishing
