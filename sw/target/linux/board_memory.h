// board_memory.h - the board's registers and pictures in a Linux process, through /dev/mem.
#pragma once

#include <cstdint>
#include <string>

#include "hal/mmio.h"

namespace linux_target {

// Maps what the program touches and nothing else.  An access outside ends the process by SIGSEGV.
class BoardMemory : public hal::Mmio {
public:
    // Checks the FPGA before the first access, because an access without an answer can hang the
    // board: is it configured, are both bridges out of reset, is its register map the one of this
    // program?  Returns "" if all is well, otherwise what is wrong and what to do.
    std::string open();

    std::uint32_t read(std::uint32_t address) override;
    void write(std::uint32_t address, std::uint32_t value) override;
    void write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) override;

private:
    struct Window {
        std::uint32_t base, size;
        volatile std::uint32_t* words = nullptr;
    };

    std::string map(int memory, Window& window);
    volatile std::uint32_t* at(std::uint32_t address);

    // Cyclone V HPS TRM: FPGA manager, reset manager.
    Window managers_[2] = {{0xFF706000, 0x1000}, {0xFFD05000, 0x1000}};
    Window fabric_[3] = {{0xFF200000, 0x6000}, {0xC0000000, 0x40000}, {0xC8000000, 0x40000}};
};

}  // namespace linux_target
