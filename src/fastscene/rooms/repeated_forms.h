// Things of one room that look alike.
#pragma once

#include <string>
#include <vector>

#include "fastscene/rooms/layout.h"

namespace fastscene {

// What there should be one of in a room, as keys: the piece's triangles and materials; its form; of whatever kind, the
// pictures that it shows, each a design in its colors, and the body of a vase or a lamp (whatever its size, and what
// stands in it). Grain and weave run at random and make no difference.
std::vector<std::string> looks_of(const Piece& piece);

// Whether two pieces are a set, which people buy or set up together:
// - what the sentence asks for in a number, or in the plural ("two lamps", "chairs");
// - what was placed by one another or by the same piece, or by two that are themselves a set: chairs at tables,
//   nightstands at a bed, a row, a pattern;
// - what stands on two pieces that are a set: lamps on two nightstands, screens on desks; on one piece: settings of a
//   table, heaps, and kinds that come in groups (candles, jars);
// - what a house is fitted with: curtains and blinds, lamps at the ceiling, radiators, parts of the building; and kinds
//   that are bought alike (the catalogue's role "alike": lamps on walls, seats of waiting rooms, barrels).
bool is_set(const std::vector<Placed>& placed, int i, int k);

// Pairs by index into `placed`: what has a look in common with earlier pieces and is a set with none of them, and the
// first of those.
struct RepeatedForm {
    int piece, first;
};
std::vector<RepeatedForm> repeated_forms(const std::vector<Placed>& placed);

}  // namespace fastscene
