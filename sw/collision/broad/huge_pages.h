// huge_pages.h - large arrays in pages of 2 MB, where the system has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace collision {

// For an array that is still empty.  Where many places of an array are written to by turns, a
// processor cannot keep in mind where as many small pages are.  It only asks: elsewhere than on
// Linux, or where the system has no such pages left, this is reserve().
template <class Element>
void reserve_in_huge_pages(std::vector<Element>& array, std::size_t size) {
    array.reserve(size);
#if defined(__linux__)
    constexpr std::uintptr_t PAGE = 2 << 20;
    const auto start = reinterpret_cast<std::uintptr_t>(array.data());
    const auto first = (start + PAGE - 1) & ~(PAGE - 1);
    const auto last = (start + array.capacity() * sizeof(Element)) & ~(PAGE - 1);
    if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

}  // namespace collision
