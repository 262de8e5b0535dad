// Where the files of a zip lie. Nothing is unpacked: torch.save stores what it writes, and a TorchScript archive packs
// only its code.
#pragma once

#include <map>
#include <string>

#include "fastscene/nn/mapped_file.h"

namespace fastscene {

struct ZipRecord {
    std::size_t begin = 0, size = 0;  // of the contents, in the file; 0 bytes when they are packed
    bool packed = false;
};
// Reads the central directory (zip64 too) and holds every entry against the file. Throws Error naming the file and the
// entry.
std::map<std::string, ZipRecord> zip_records(const MappedFile& file);

}  // namespace fastscene
