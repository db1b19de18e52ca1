#include "sim/chip/project_code.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/hps/bridge_windows.h"

namespace sim {

namespace {

constexpr std::uint32_t PAGE_BYTES = 0x1000, WORD = 4;

bool is_on_a_bridge(std::uint32_t address) {
    return address - H2F_BASE < H2F_SIZE || address - LW_BASE < LW_SIZE;
}

std::uint32_t word_of(const ElfSegment& segment, std::uint32_t offset) {
    std::uint32_t word = 0;
    if (offset < segment.data.size())
        std::memcpy(&word, &segment.data[offset],
                    std::min<std::size_t>(WORD, segment.data.size() - offset));
    return word;
}

}  // namespace

ProjectCode::ProjectCode(const ElfProgram& program,
                         const std::function<bool(std::uint32_t)>& has_place) {
    for (const ElfSegment& segment : program.segments)
        if (is_on_a_bridge(segment.physical)) segments_.push_back(segment);
    std::sort(segments_.begin(), segments_.end(),
              [](const auto& a, const auto& b) { return a.physical < b.physical; });
    for (const ElfSegment& segment : segments_) {
        const std::uint32_t last = segment.physical + segment.size - 1;
        if (!has_place(segment.physical) || !has_place(last))
            throw std::runtime_error{fmt::format(
                "the program's part at 0x{:08X} to 0x{:08X} is linked to the FPGA, where the "
                "design has no memory of that size: expected addresses of its memory (see "
                "`de1sim check --map`), of the DDR3, from 0, or of the on-chip RAM, 0xFFFF0000",
                segment.physical, last)};
        const std::uint32_t base = segment.physical / PAGE_BYTES * PAGE_BYTES,
                            bytes = last / PAGE_BYTES * PAGE_BYTES + PAGE_BYTES - base;
        if (pages_.empty() || pages_.back().base + pages_.back().bytes.size() < base)
            pages_.push_back({base, {}});
        pages_.back().bytes.resize(base + bytes - pages_.back().base);
    }
}

std::string ProjectCode::load(Bus& bus) const {
    const auto transfer = [&bus](bool write, std::uint32_t address, std::uint32_t& word) {
        sc_core::sc_time delay;
        const bool done =
            bus.transfer(write, address, reinterpret_cast<unsigned char*>(&word), WORD, delay);
        wait(delay);
        return done;
    };
    for (const bool writes : {true, false})
        for (const ElfSegment& segment : segments_)
            for (std::uint32_t offset = 0; offset < segment.size; offset += WORD) {
                const std::uint32_t expected = word_of(segment, offset),
                                    address = segment.physical + offset;
                std::uint32_t word = expected;
                if (!transfer(writes, address, word))
                    return fmt::format(
                        "the program cannot be loaded into the design: a {} of 0x{:08X} is "
                        "refused or not answered",
                        writes ? "write" : "read", address);
                if (word != expected)
                    return fmt::format(
                        "the program cannot be loaded into the design: at 0x{:08X} 0x{:08X} was "
                        "written, and 0x{:08X} is read; expected a memory that can be written",
                        address, expected, word);
            }
    return {};
}

bool ProjectCode::direct(std::uint32_t window, const tlm::tlm_generic_payload& tx,
                         tlm::tlm_dmi& dmi) {
    const std::uint32_t address = window + static_cast<std::uint32_t>(tx.get_address());
    for (Pages& pages : pages_) {
        const auto size = static_cast<std::uint32_t>(pages.bytes.size());
        if (pages.base > address && pages.base >= window) {
            dmi.set_end_address(
                std::min<sc_dt::uint64>(dmi.get_end_address(), pages.base - 1 - window));
            return false;
        }
        if (address - pages.base >= size) continue;
        dmi.set_dmi_ptr(pages.bytes.data());
        dmi.set_start_address(pages.base - window);
        dmi.set_end_address(pages.base - window + (size - 1));
        dmi.allow_read();
        return true;
    }
    return false;
}

bool ProjectCode::written(std::uint32_t address, const std::uint8_t* data, unsigned bytes) {
    for (Pages& pages : pages_)
        if (address >= pages.base && address - pages.base + bytes <= pages.bytes.size()) {
            std::memcpy(&pages.bytes[address - pages.base], data, bytes);
            return true;
        }
    return false;
}

}  // namespace sim
