// triggers.h - Verilator 5.006's flags of what has moved, as bits of words
//
// A model looks at them several times in each evaluation.  Verilator's own are an array of bool,
// with a loop for each look; later releases have words themselves.  To be included before
// everything else.
#pragma once

#include "verilated_config.h"
#if VERILATOR_VERSION_INTEGER == 5006000
#define VlTriggerVec VlTriggerVecOfBool
#endif
#include "verilated.h"
#ifdef VlTriggerVec
#undef VlTriggerVec

#include <cstddef>
#include <cstdint>

template <std::size_t COUNT>
class VlTriggerVec final {
    static constexpr std::size_t WORDS = (COUNT + 63) / 64;

public:
    // Some of the flags in a word: whether any of them is set.
    class Flags {
    public:
        Flags(std::uint64_t& word, std::uint64_t bits) : word_{word}, bits_{bits} {}
        operator bool() const { return (word_ & bits_) != 0; }
        void operator=(std::uint64_t value) { word_ = (word_ & ~bits_) | (value != 0 ? bits_ : 0); }
        // One look at the word, where the flags are in the same.
        auto operator|(const Flags& o) const {
            if constexpr (WORDS == 1)
                return Flags{word_, bits_ | o.bits_};
            else
                return bool{*this} | bool{o};
        }

    private:
        std::uint64_t& word_;
        const std::uint64_t bits_;
    };

    void clear() {
        for (std::uint64_t& word : words_) word = 0;
    }
    Flags at(std::size_t n) { return {words_[n / 64], std::uint64_t{1} << n % 64}; }
    bool any() const {
        std::uint64_t all = 0;
        for (const std::uint64_t word : words_) all |= word;
        return all != 0;
    }
    void set(const VlTriggerVec& other) {
        for (std::size_t n = 0; n < WORDS; ++n) words_[n] |= other.words_[n];
    }
    void andNot(const VlTriggerVec& a, const VlTriggerVec& b) {
        for (std::size_t n = 0; n < WORDS; ++n) words_[n] = a.words_[n] & ~b.words_[n];
    }

private:
    std::uint64_t words_[WORDS] = {};
};
#endif
