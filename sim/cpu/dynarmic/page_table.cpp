#include "sim/cpu/dynarmic/page_table.h"

#include <new>

#include <sys/mman.h>

namespace sim {

// The host allocates it as it is touched: 8 MB, of which a program uses a few KB.
PageTable::PageTable() {
    void* const memory = mmap(nullptr, sizeof(Direct), PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc{};
    direct_.reset(static_cast<Direct*>(memory));
}

void PageTable::Unmap::operator()(Direct* direct) const { munmap(direct, sizeof(Direct)); }

void PageTable::open(std::uint32_t page, std::uint8_t* bytes) {
    if ((*direct_)[page] == nullptr) opened_.push_back(page);
    (*direct_)[page] = bytes;
}

void PageTable::close_bytes(const std::uint8_t* bytes) {
    for (const std::uint32_t page : opened_)
        if ((*direct_)[page] == bytes) (*direct_)[page] = nullptr;
}

void PageTable::close_all() {
    for (const std::uint32_t page : opened_) (*direct_)[page] = nullptr;
    opened_.clear();
    cache_.fill({});
}

}  // namespace sim
