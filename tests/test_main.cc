// The main() of all test programs: GoogleTest's, with libraries limited to the instruction set in use (FASTSCENE_ISA),
// as in fastscene itself.
#include <gtest/gtest.h>

#include <exception>
#include <iostream>

#include "fastscene/base/library_settings.h"

int main(int argc, char** argv) {
    try {
        fastscene::begin_within_isa(argv);
    } catch (const std::exception& e) {
        std::cerr << e.what() << '\n';
        return 2;
    }
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
