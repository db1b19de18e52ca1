// kernels_avx2.cpp - the kernels for AVX2, where compiler and processor have it.
//
// Compiled with -mavx2, so the linker must not take a function from here for one of another file.
// The kernels are therefore templates of lanes::Avx2, and all that they call is inlined.
#include "collision/detail/kernels.h"

#include "grid_kernels.h"
#include "short_kernel.h"
#include "sweep_kernel.h"

namespace collision::detail {

const Kernels* avx2_kernels() {
#if defined(__AVX2__)
    static constexpr Kernels KERNELS = {"AVX2",
                                        256,
                                        locate<lanes::Avx2>,
                                        gather<lanes::Avx2>,
                                        sweep<lanes::Avx2>,
                                        compare_all<lanes::Avx2>};
    return __builtin_cpu_supports("avx2") ? &KERNELS : nullptr;
#else
    return nullptr;
#endif
}

}  // namespace collision::detail
