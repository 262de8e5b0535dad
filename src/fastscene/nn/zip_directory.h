// Where the files of a zip lie. Only stored ones: torch.save never packs.
#pragma once

#include <map>
#include <string>

#include "fastscene/nn/mapped_file.h"

namespace fastscene {

struct ZipRecord {
    std::size_t begin = 0, size = 0;  // of the contents, in the file
};
// Reads the central directory (zip64 too) and holds every entry against the file. Throws Error naming the file and the entry.
std::map<std::string, ZipRecord> zip_records(const MappedFile& file);

}  // namespace fastscene
