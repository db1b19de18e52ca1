// board_memory.cpp - see board_memory.h
#include "board_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "hal/system_id.h"

namespace linux_target {

namespace {

constexpr std::uint32_t FPGA_STATUS = 0xFF706000, MODE = 7, USER_MODE = 4;
constexpr std::uint32_t BRIDGE_RESET = 0xFFD0501C, H2F = 1, LWH2F = 2;

std::string hex(std::uint32_t value) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%08lX", static_cast<unsigned long>(value));
    return text;
}

}  // namespace

std::string BoardMemory::map(int memory, Window& window) {
    void* const found = mmap(nullptr, window.size, PROT_READ | PROT_WRITE, MAP_SHARED, memory,
                             static_cast<off_t>(window.base));
    if (found == MAP_FAILED)
        return "/dev/mem: cannot map " + hex(window.base) + ": " + std::strerror(errno);
    window.words = static_cast<volatile std::uint32_t*>(found);
    return "";
}

std::string BoardMemory::open() {
    const int memory = ::open("/dev/mem", O_RDWR | O_SYNC);
    if (memory < 0)
        return std::string{"/dev/mem: cannot open: "} + std::strerror(errno) + " (run as root)";
    std::string problem;
    for (Window& window : managers_)
        if (problem.empty()) problem = map(memory, window);
    if (problem.empty()) {
        const std::uint32_t mode = read(FPGA_STATUS) & MODE, reset = read(BRIDGE_RESET);
        if (mode != USER_MODE)
            problem = "the FPGA is not configured (FPGA manager: mode " + std::to_string(mode) +
                      ", not 4): load the bitstream first";
        else if (reset & (H2F | LWH2F))
            problem = std::string{"the bridge "} + (reset & LWH2F ? "lwhps2fpga" : "hps2fpga") +
                      " is off (brgmodrst " + hex(reset) + "): enable the bridges first";
    }
    for (Window& window : fabric_)
        if (problem.empty()) problem = map(memory, window);
    close(memory);
    if (problem.empty() && !hal::system_id_matches(*this))
        problem = "system ID " + hex(read(regmap::SYSID_ID)) + ", register map " +
                  hex(read(regmap::SYSID_HASH)) + ": expected " + hex(regmap::SYSID_ID_RESET) +
                  ", " + hex(regmap::REGMAP_HASH) + ": program and bitstream are not of one build";
    return problem;
}

volatile std::uint32_t* BoardMemory::at(std::uint32_t address) {
    for (const Window& window : fabric_)
        if (address - window.base < window.size) return window.words + (address - window.base) / 4;
    for (const Window& window : managers_)
        if (address - window.base < window.size) return window.words + (address - window.base) / 4;
    return nullptr;
}

std::uint32_t BoardMemory::read(std::uint32_t address) { return *at(address); }

void BoardMemory::write(std::uint32_t address, std::uint32_t value) { *at(address) = value; }

void BoardMemory::write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) {
    volatile std::uint32_t* to = at(address);
    for (unsigned i = 0; i < count; ++i) to[i] = words[i];
}

}  // namespace linux_target
