// kernels.cpp - see kernels.h
#include "collision/broad/kernels.h"

#include "collision/broad/kernels_avx2.h"
#include "collision/broad/kernels_avx512.h"

namespace collision {
namespace {

template <class Lanes>
constexpr Kernels kernels_of(const char* name) {
    return {name,
            4,
            short_rows<Lanes>,
            box_cells<Lanes>,
            fill_rows<Lanes>,
            packed_buckets<Lanes>,
            packed_rows<Lanes>,
            strip_rows<Lanes>};
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

KernelList available_kernels() {
    KernelList list = {};
    if (const Kernels* avx512 = avx512_kernels()) list.kernels[list.count++] = avx512;
    if (const Kernels* avx2 = avx2_kernels()) list.kernels[list.count++] = avx2;
    for (const Kernels& kernels : BASELINE) list.kernels[list.count++] = &kernels;
    return list;
}

const Kernels& fastest_kernels() { return *available_kernels().kernels[0]; }

}  // namespace collision
