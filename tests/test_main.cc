// Of every test program: GoogleTest's own, but libraries keep to the instruction set in use (FASTSCENE_ISA) as they do
// in fastscene itself.
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
