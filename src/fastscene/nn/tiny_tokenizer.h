// A synthetic vocabulary for tests, with as many merges as CLIP's.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/file.h"

namespace fastscene {

// Writes FOLDER/merges.txt. The 68 unprintable bytes are mapped to U+0100 and up; each line merges a longer run of one
// of them after a printable byte.
inline void write_tiny_tokenizer(const std::filesystem::path& folder) {
    std::string lines = "#version: 0.2\n";
    int count = 0;
    for (char a = '!'; a <= '~'; ++a)
        for (int b = 0; b < 600 && count < 48894; ++b, ++count) {
            const int stand_in = 0x100 + b % 68;
            const std::string other{static_cast<char>(0xc0 | stand_in >> 6), static_cast<char>(0x80 | (stand_in & 63))};
            std::string left(1, a);
            for (int i = 0; i < b / 68; ++i) left += other;
            lines += left + " " + other + "\n";
        }
    make_directories(folder);
    write_file(folder / "merges.txt", lines);
}

}  // namespace fastscene
