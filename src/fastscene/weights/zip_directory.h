// Locates the files inside a zip. Compression is not supported: torch.save stores its files, and TorchScript archives
// compress only their code.
#pragma once

#include <map>
#include <string>

#include "fastscene/weights/mapped_file.h"

namespace fastscene {

struct ZipRecord {
    std::size_t begin = 0, size = 0;  // of the contents, in the file; size 0 if compressed
    bool packed = false;
};
// Reads the central directory (including zip64) and validates every entry against the file. Throws Error naming the
// file and the entry.
std::map<std::string, ZipRecord> zip_records(const MappedFile& file);

}  // namespace fastscene
