// Reads torch.save files without Python and without executing anything. A pickle is a program for a small stack
// machine; this one can only build numbers, strings, lists, dictionaries and tensors. Everything else that a file names
// or calls becomes an opaque value that is ignored.
#pragma once

#include <memory>

#include "fastscene/weights/mapped_file.h"
#include "fastscene/weights/weights.h"

namespace fastscene {

// PyTorch 1.6 and later: a zip of data.pkl and data/0, data/1 … (stored uncompressed). Also TorchScript archives
// (torch.jit.save), as far as their data are concerned: modules become dictionaries, "visual.conv1.weight"; their code
// is ignored.
Weights load_torch_zip(std::shared_ptr<const MappedFile> file);
// Before 1.6: three pickles, the values, the list of storages, then the storages' bytes.
Weights load_torch_legacy(std::shared_ptr<const MappedFile> file);

}  // namespace fastscene
