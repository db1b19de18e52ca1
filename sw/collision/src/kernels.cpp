// kernels.cpp - see kernels.h
#include "collision/detail/kernels.h"

#include "grid_kernels.h"
#include "short_kernel.h"
#include "sweep_kernel.h"

namespace collision::detail {

const Kernels* avx2_kernels();  // kernels_avx2.cpp; null where there is no AVX2

namespace {

// Vectors of 16 bytes.
template <class Lanes>
constexpr Kernels kernels_of(const char* name) {
    return {name, 80, locate<Lanes>, gather<Lanes>, sweep<Lanes>, compare_all<Lanes>};
}

constexpr Kernels BASELINE[] = {
#if defined(__SSE2__)
    kernels_of<lanes::Sse2>("SSE2"),
#elif defined(__ARM_NEON)
    kernels_of<lanes::Neon>("NEON"),
#endif
    kernels_of<lanes::Plain>("plain"),
};

}  // namespace

std::vector<const Kernels*> available_kernels() {
    std::vector<const Kernels*> list;
    if (const Kernels* avx2 = avx2_kernels()) list.push_back(avx2);
    for (const Kernels& kernels : BASELINE) list.push_back(&kernels);
    return list;
}

const Kernels& fastest_kernels() {
    const Kernels* avx2 = avx2_kernels();
    return avx2 ? *avx2 : BASELINE[0];
}

}  // namespace collision::detail
