// Files of code. A network exported as TorchScript is a program: it can read files of this machine. It runs only if its
// user has said so, for this very file; every other kind of weights is data and never executed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fastscene {

// `trusted`: paths, and SHA-256 hashes of contents (64 hexadecimal digits), that the user gave with --trust.
// Returns the file's hash. Throws UsageError with the words to trust it, if it is not among them.
std::string check_trusted(const std::filesystem::path& file, const std::vector<std::string>& trusted);

}  // namespace fastscene
