// fabric_memory.cpp - the fabric's memories without their ports, and the counts of its audio core
#include <algorithm>
#include <cstring>

#include "regmap.h"
#include "sim/fpga/fabric.h"
#include "sim/fpga/fabric_model.h"
#include "sim/hps/bridge_windows.h"

namespace sim {

namespace {

constexpr std::uint32_t SDRAM = regmap::SDRAM_BASE - H2F_BASE,
                        ONCHIP = regmap::ONCHIP_BASE - H2F_BASE;

}  // namespace

#ifdef DE1SIM_PORTS_ALONE
bool Fabric::has_memory() const { return false; }
void Fabric::read_onchip(std::uint32_t, std::uint8_t*, unsigned) const {}
void Fabric::write_onchip(std::uint32_t, const std::uint8_t*, unsigned) {}
std::optional<Fabric::Audio> Fabric::audio() const { return {}; }
#else
#define LANE(n) &top.rootp->fpga__DOT__video_block__DOT__onchip__DOT__memory__DOT__lane##n[0]
#define LANES \
    { LANE(0), LANE(1), LANE(2), LANE(3) }

bool Fabric::has_memory() const { return true; }

void Fabric::read_onchip(std::uint32_t offset, std::uint8_t* data, unsigned bytes) const {
    Vfpga& top = model_->top;
    const CData* const lanes[] = LANES;
    for (unsigned i = 0; i < bytes; ++i, ++offset) data[i] = lanes[offset % 4][offset / 4];
}

void Fabric::write_onchip(std::uint32_t offset, const std::uint8_t* data, unsigned bytes) {
    Vfpga& top = model_->top;
    CData* const lanes[] = LANES;
    for (unsigned i = 0; i < bytes; ++i, ++offset) lanes[offset % 4][offset / 4] = data[i];
}

#define AUDIO(signal) top.rootp->fpga__DOT__audio_block__DOT__##signal

std::optional<Fabric::Audio> Fabric::audio() const {
    const Vfpga& top = model_->top;
    return Audio{{AUDIO(left_out_count), AUDIO(right_out_count)},
                 {AUDIO(left_in_count), AUDIO(right_in_count)},
                 AUDIO(underruns_q)};
}
#endif

void Fabric::set_memory(Memory memory, std::uint8_t* sdram) {
    memory_ = has_memory() ? memory : Memory::BRIDGED;
    chip_ = sdram;
}

std::optional<FpgaModel::DirectMemory> Fabric::direct_memory(bool full,
                                                             std::uint32_t address) const {
    if (!full || !chip_ || address - SDRAM >= regmap::SDRAM_SIZE) return {};
    return DirectMemory{chip_, SDRAM, SDRAM + regmap::SDRAM_SIZE - 1, memory_ == Memory::MAPPED};
}

// The time is that in which neither the screen nor a refresh is in the bridge's way.
std::optional<std::uint64_t> Fabric::access_memory(bool full, bool write, std::uint32_t address,
                                                   std::uint8_t* data, unsigned bytes,
                                                   std::uint64_t begin_ps) {
    if (!full || memory_ != Memory::MAPPED) return {};
    const std::uint64_t words = (address + bytes - 1) / 4 - address / 4 + 1;
    std::uint64_t clocks = std::max(begin_ps / FABRIC_PERIOD_PS, clocks_);
    if (address - ONCHIP < regmap::ONCHIP_SIZE) {
        if (write)
            write_onchip(address - ONCHIP, data, bytes);
        else
            read_onchip(address - ONCHIP, data, bytes);
        clocks += write ? 4 + words : 1 + 4 * words;
    } else if (chip_ && address - SDRAM < regmap::SDRAM_SIZE) {
        if (write)
            std::memcpy(chip_ + (address - SDRAM), data, bytes);
        else
            std::memcpy(data, chip_ + (address - SDRAM), bytes);
        clocks += write ? std::max<std::uint64_t>(5, 2 + 2 * words) : 1 + 6 * words;
    } else {
        return {};
    }
    return clocks * FABRIC_PERIOD_PS;
}

}  // namespace sim
