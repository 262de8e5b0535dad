// For tests: a network in TorchScript, from its source, in a file that goes with the object. Needs libtorch.
#pragma once

#include <torch/script.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace fastscene {

struct MadeScript {
    std::filesystem::path file;
    // `source`: "def forward(self, x):\n    return x\n".
    explicit MadeScript(const std::string& source) {
        static int number = 0;
        file = std::filesystem::temp_directory_path() /
               ("fastscene-script-" + std::to_string(::getpid()) + "-" + std::to_string(number++) + ".pt");
        torch::jit::Module module("network");
        module.define(source);
        module.save(file.string());
    }
    ~MadeScript() { std::filesystem::remove(file); }
    MadeScript(const MadeScript&) = delete;
    MadeScript& operator=(const MadeScript&) = delete;
};

}  // namespace fastscene
