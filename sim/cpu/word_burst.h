// word_burst.h - the words of one instruction that go over the bus together
//
// Of a load all come with the first, and are then taken one by one; a store collects its words
// until the last.
#pragma once

#include <array>
#include <cstdint>

namespace sim {

class WordBurst {
public:
    // `instruction`: a number that is its own; `later`: words of it that are no part of this burst.
    void begin(std::uint64_t instruction, std::uint32_t address, unsigned words, unsigned later) {
        instruction_ = instruction;
        address_ = address;
        words_ = words;
        later_ = later;
        next_ = 0;
    }
    void drop() { next_ = words_; }

    bool is_of(std::uint64_t instruction) const { return instruction == instruction_; }
    bool continues(std::uint64_t instruction, std::uint32_t address) const {
        return is_of(instruction) && next_ < words_ && address == address_ + 4 * next_;
    }
    unsigned later() const { return later_; }
    bool is_whole() const { return next_ == words_; }

    void add(std::uint32_t value) { data_[next_++] = value; }
    std::uint32_t take() { return data_[next_++]; }

    std::uint32_t address() const { return address_; }
    unsigned bytes() const { return 4 * words_; }
    std::uint32_t* data() { return data_.data(); }

private:
    static constexpr std::uint64_t NONE = ~std::uint64_t{0};
    std::uint64_t instruction_ = NONE;
    std::uint32_t address_ = 0;
    unsigned words_ = 0, later_ = 0, next_ = 0;
    std::array<std::uint32_t, 256> data_{};  // as many as VLDM's count can say
};

}  // namespace sim
