// Where a network runs, as the user chose it. Free of libtorch.
#pragma once

#include <string>

namespace fastscene {

struct DeviceChoice {
    std::string name = "auto";      // auto, cpu or cuda; auto: a graphics card if there is one and libtorch supports it
    std::string flag = "--device";  // that it was chosen with, for messages
};

}  // namespace fastscene
