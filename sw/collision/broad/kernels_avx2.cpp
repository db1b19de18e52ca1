// kernels_avx2.cpp - see kernels_avx2.h
//
// Compiled with -mavx2, so nothing here may be linked in place of a function of another file: the
// kernels are templates of lanes::Avx2, and all that they call is inlined.
#include "collision/broad/kernels_avx2.h"

namespace collision {

const Kernels* avx2_kernels() {
#if defined(__AVX2__)
    static constexpr Kernels KERNELS = {"AVX2",
                                        4,
                                        short_rows<lanes::Avx2>,
                                        box_cells<lanes::Avx2>,
                                        fill_rows<lanes::Avx2>,
                                        packed_buckets<lanes::Avx2>,
                                        packed_rows<lanes::Avx2>,
                                        strip_rows<lanes::Avx2>};
    return __builtin_cpu_supports("avx2") ? &KERNELS : nullptr;
#else
    return nullptr;
#endif
}

}  // namespace collision
