// kernels_avx512.h - the kernels for AVX-512, where compiler and processor have it.
#pragma once

#include "collision/broad/kernels.h"

namespace collision {

// Those for AVX2 but for strip_rows; null where there is no AVX-512 with F, VL, BW and VBMI2: Ice
// Lake, Zen 4 and later.
const Kernels* avx512_kernels();

}  // namespace collision
