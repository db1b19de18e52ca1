// kernels_avx2.h - the kernels for AVX2, where compiler and processor have it.
#pragma once

#include "collision/broad/kernels.h"

namespace collision {

const Kernels* avx2_kernels();  // null where there is no AVX2

}  // namespace collision
