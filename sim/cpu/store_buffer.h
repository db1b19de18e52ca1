// store_buffer.h - stores that wait in the processor to become one burst
//
// Stores to memory on the HPS-to-FPGA bridge that the translation tables call Normal are merged as
// in the A9's store buffer: consecutive stores at rising addresses become one burst, up to the next
// multiple of 64 bytes.  The burst is sent before the next other access, which keeps the program's
// order, or at the quantum's end.  The first store into a page of 4 KB is not merged, so that a
// store without a target aborts at its own instruction.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace sim {

class StoreBuffer {
public:
    static constexpr unsigned BYTES = 64;

    // A store into this page, which has answered, may wait from now on.
    void answered(std::uint32_t address) { page_ = page_of(address); }
    // An access that is no such store: the next one of any page is not merged.
    void forget_page() { page_ = NONE; }
    bool knows_page(std::uint32_t address) const { return page_of(address) == page_; }

    // Continues what waits, or nothing waits.
    bool continues(std::uint32_t address) const {
        return bytes_ == 0 || address == begin_ + bytes_;
    }
    // One that continues it.
    void add(std::uint32_t address, unsigned bytes, std::uint32_t value) {
        if (bytes_ == 0) begin_ = address;
        std::memcpy(data_.data() + bytes_, &value, bytes);
        bytes_ += bytes;
    }
    // At a multiple of 64 bytes: to be sent.
    bool is_full() const { return bytes_ > 0 && (begin_ + bytes_) % BYTES == 0; }
    bool is_empty() const { return bytes_ == 0; }

    // What waits, which is then gone.
    struct Burst {
        std::uint32_t address;
        unsigned bytes;
        std::array<std::uint8_t, BYTES>& data;
    };
    Burst remove() { return {begin_, std::exchange(bytes_, 0), data_}; }

private:
    static constexpr std::uint32_t NONE = 1;  // no page's address
    static std::uint32_t page_of(std::uint32_t address) { return address & ~0xFFFu; }

    std::uint32_t begin_ = 0, page_ = NONE;
    unsigned bytes_ = 0;
    std::array<std::uint8_t, BYTES> data_{};
};

}  // namespace sim
