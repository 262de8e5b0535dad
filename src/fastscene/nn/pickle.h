// What torch.save writes, read without Python and without executing anything. A pickle is a program for a small stack
// machine; here it can build numbers, texts, lists, dictionaries and tensors, and nothing else: whatever else a file
// names or calls becomes an opaque thing that is carried along and ignored.
#pragma once

#include <memory>

#include "fastscene/nn/mapped_file.h"
#include "fastscene/nn/weights.h"

namespace fastscene {

// PyTorch 1.6 and later: a zip of data.pkl and data/0, data/1 … (stored, not packed). Also a TorchScript archive
// (torch.jit.save), as far as its data goes: modules become dictionaries of what they hold, "visual.conv1.weight"; its
// code is not looked at.
Weights load_torch_zip(std::shared_ptr<const MappedFile> file);
// Before: three pickles, the values, the list of storages, then the storages' bytes.
Weights load_torch_legacy(std::shared_ptr<const MappedFile> file);

}  // namespace fastscene
