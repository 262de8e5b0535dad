// The lexicon as read from lexicon.tsv, for the lexicon's own files.
#pragma once

#include <map>
#include <string>

#include "fastscene/rooms/lexicon.h"

namespace fastscene {

struct LexiconTable {
    std::map<std::string, Word, std::less<>> words;            // "armchair", "de:sessel"
    std::map<std::string, std::uint32_t, std::less<>> colors;  // English names
    std::map<std::string, std::string, std::less<>>
        letters;  // "bedsidelamp" -> "bedside lamp", "de:…" likewise; furniture and rooms only
};

const LexiconTable& lexicon_table();
// "armchair" in English, "de:sessel" in German.
std::string lexicon_key(std::string_view term, Language language);

}  // namespace fastscene
