// The instruction set in use: the best one supported by the processor, limited by the environment variable
// FASTSCENE_ISA. Every kernel that exists for several instruction sets is selected by it; base/library_settings.h
// applies it to libraries.
//
// Contains declarations only and includes no other header, since sources compiled for wider vectors include it.
#pragma once

namespace fastscene {

// Each includes the previous ones: x86-64-v2, -v3 (with FMA) and -v4. Other processors only have the first.
enum class Isa { sse4, avx2, avx512 };

// The one in use. Evaluated once; throws UsageError if FASTSCENE_ISA is invalid.
Isa isa();
// This processor's, regardless of the environment.
Isa processor_isa();
// The one that the compiler assumes everywhere (FASTSCENE_ARCH): code outside kernels uses it even if isa() is less.
Isa compiled_isa();

const char* isa_name(Isa isa);
// The smaller of `best` and `text`; null or empty means no limit. Throws UsageError.
Isa limited_isa(const char* text, Isa best);

}  // namespace fastscene
