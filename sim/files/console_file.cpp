// console_file.cpp - see console_file.h
#include "sim/files/console_file.h"

#include <utility>

namespace sim {

namespace {

constexpr std::size_t BLOCK = 4096;  // written at once

}  // namespace

void ConsoleFile::print(char character) {
    const std::uint64_t at = printed_++;
    if (at < FIRST) {
        first_ += character;
        if (first_.size() < BLOCK) return;
        file_.write(first_.data(), first_.size());
        first_.clear();
    } else if (last_.size() < LAST) {
        last_ += character;
    } else {
        last_[(at - FIRST) % LAST] = character;
    }
}

void ConsoleFile::commit() {
    std::string text = std::exchange(first_, {});
    if (printed_ > FIRST + LAST) {
        text += "\n[de1sim: " + std::to_string(printed_ - FIRST - LAST) + " bytes left out]\n";
        const std::size_t oldest = (printed_ - FIRST) % LAST;
        last_ = last_.substr(oldest) + last_.substr(0, oldest);
    }
    text += last_;
    file_.write(text.data(), text.size());
    file_.commit();
}

}  // namespace sim
