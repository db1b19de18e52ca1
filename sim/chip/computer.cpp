#include "sim/chip/computer.h"

#include "regmap.h"

namespace sim {

namespace {

// Cyclone V HPS memory map.
constexpr std::uint32_t ON_CHIP_RAM_BASE = 0xFFFF0000, ON_CHIP_RAM_SIZE = 0x10000;

}  // namespace

const std::vector<MemoryRange>& program_memory() {
    static const std::vector<MemoryRange> memory{
        {ProcessorSystem::DDR3_BASE, ProcessorSystem::DDR3_SIZE},
        {ON_CHIP_RAM_BASE, ON_CHIP_RAM_SIZE},
        {regmap::SDRAM_BASE, regmap::SDRAM_SIZE}};
    return memory;
}

std::uint64_t Computer::fixed_ps(std::uint32_t address) const {
    constexpr std::uint64_t HPS_PS = 10'000;  // sim/hps/registers.h
    return address - LW_BASE < LW_SIZE ? 0 : HPS_PS;
}

Computer::Computer(const sc_core::sc_module_name& name, PinListener& pins, ChipObserver& observer,
                   std::uint8_t* sdram, Software software, const Settings& settings)
    : ProcessorSystem{name, pins, observer, std::move(software)},
      ComputerFabric{pins, observer, sdram, settings, regmap::SDRAM_BASE} {
    full_window.bind(bridges.h2f);
    lightweight_window.bind(bridges.lw);
    describe("h2f", "lw", bus, cpu, observer);
    if (arm) arm->set_steady_bus(this);
    if (arm && !settings.shortcuts) arm->leave_no_rounds_out();
    fpga.on_processor_wires({[this](std::uint64_t levels) { hps.fpga_interrupts(levels); }, {}});
}

// Of the University Program's pixel buffer, as the DE1-SoC Computer has it.
std::optional<PixelBuffer> Computer::pixel_buffer() const {
    return PixelBuffer{regmap::ONCHIP_BASE, 320, 240, 16, 1024, regmap::ONCHIP_SIZE};
}

void Computer::type(const std::string& text, SerialLine to) {
    if (to == SerialLine::UART)
        hps.uart0.receive(text);
    else
        jtag_host.type(to == SerialLine::JTAG_1, text);
}

}  // namespace sim
