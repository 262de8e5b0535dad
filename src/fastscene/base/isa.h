// The instruction set in use: the best that the processor has, and at most what the environment's FASTSCENE_ISA names.
// Every kernel of ours that exists for several instruction sets asks here; base/library_settings.h makes libraries
// follow.
//
// Declarations only and no other header: sources that are compiled for wider vectors than the rest include this.
#pragma once

namespace fastscene {

// Each includes the ones before it: x86-64-v2, -v3 (with FMA) and -v4. On other processors there is only the first.
enum class Isa { sse4, avx2, avx512 };

// In use. Asked once; throws UsageError when FASTSCENE_ISA names no instruction set.
Isa isa();
// Of this processor, whatever the environment says.
Isa processor_isa();
// That the compiler could assume everywhere (FASTSCENE_ARCH): code that is no kernel uses it even when isa() is less.
Isa compiled_isa();

const char* isa_name(Isa isa);
// The smaller of `best` and what `text` names; null or empty names nothing. Throws UsageError.
Isa limited_isa(const char* text, Isa best);

}  // namespace fastscene
