// answers.h - what a program's last accesses to the bus have given, and which of them would give it
// again.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace sim {

class Answers {
public:
    // An access was made.  `plain`: it has no further effect; then it gives the same again as long
    // as `epoch` is the same.  After another one, such as a read that takes a sample out of a FIFO,
    // no register is sure to give what it gave before.
    void made(std::uint32_t address, unsigned bytes, bool write, std::uint32_t value, bool plain,
              std::uint64_t epoch) {
        Answer* known = find(address, bytes, write);
        if (!plain || (write && !(known && known->value == value)))
            for (Answer& other : answers_) other.epoch = NEVER;
        if (!known) known = &answers_[next_++ % answers_.size()];
        *known = {address, bytes, write, value, plain ? epoch : NEVER};
    }

    struct Known {
        std::uint32_t value;
        bool sure;
    };
    // The last answer; for a write, what was written.
    std::optional<Known> last(std::uint32_t address, unsigned bytes, bool write,
                              std::uint64_t epoch) {
        const Answer* known = find(address, bytes, write);
        if (!known) return std::nullopt;
        return Known{known->value, known->epoch == epoch};
    }

private:
    static constexpr std::uint64_t NEVER = ~std::uint64_t{0};
    struct Answer {
        std::uint32_t address = 0;
        unsigned bytes = 0;  // 0: none
        bool write = false;
        std::uint32_t value = 0;
        std::uint64_t epoch = NEVER;
    };
    Answer* find(std::uint32_t address, unsigned bytes, bool write) {
        const auto found = std::find_if(answers_.begin(), answers_.end(), [=](const Answer& a) {
            return a.address == address && a.bytes == bytes && a.write == write;
        });
        return found == answers_.end() ? nullptr : &*found;
    }

    std::array<Answer, 16> answers_;
    unsigned next_ = 0;
};

}  // namespace sim
