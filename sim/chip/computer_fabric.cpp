#include "sim/chip/computer_fabric.h"

#include <algorithm>
#include <iterator>

#include "regmap.h"
#include "sim/hps/bridge_windows.h"
#include "sim/hps/peripherals.h"

namespace sim {

namespace {

bool is_jp2(std::uint32_t address) { return address - regmap::JP2_BASE < regmap::JP2_SIZE; }

// The registers of the register map, by address.
std::map<std::uint32_t, std::string> fpga_registers(bool has_jp2) {
    std::map<std::uint32_t, std::string> names;
    for (const regmap::Reg& reg : regmap::REGS)
        if (has_jp2 || !is_jp2(reg.addr)) names.emplace(reg.addr, reg.name);
    return names;
}

// Its blocks and memories from `base` on, within `size` bytes, as the processor sees them `below`.
std::vector<Bus::Place> fpga_places(std::uint32_t base, std::uint32_t size, std::uint32_t below,
                                    bool has_jp2 = true) {
    std::vector<Bus::Place> places;
    for (const regmap::Block& block : regmap::BLOCKS) {
        if (block.base - base >= size || (!has_jp2 && is_jp2(block.base))) continue;
        const bool registers =
            std::any_of(std::begin(regmap::REGS), std::end(regmap::REGS),
                        [&](const regmap::Reg& reg) { return reg.addr - block.base < block.size; });
        places.push_back({block.name, block.base - below, block.size, !registers});
    }
    return places;
}

}  // namespace

bool is_plain_output(std::uint32_t address, std::uint32_t value) {
    using namespace regmap;
    constexpr std::uint32_t PORTS[] = {LEDR_BASE, HEX3_0_BASE, HEX5_4_BASE, SW_BASE,
                                       KEY_BASE,  JP1_BASE,    JP2_BASE};
    constexpr std::uint32_t PORT_SIZE = JP1_SIZE, EDGE = JP1_EDGE - JP1_BASE;
    constexpr std::uint32_t GPIO_OUTPUTS = 8;  // bytes: data and directions
    if (address - Peripherals::GPIO1_BASE < GPIO_OUTPUTS) return true;
    const std::uint32_t* port =
        std::find(std::begin(PORTS), std::end(PORTS), address & ~(PORT_SIZE - 1));
    return port != std::end(PORTS) && (address % PORT_SIZE < EDGE || value == 0);
}

bool is_plain_input(std::uint32_t address, std::uint32_t value) {
    using namespace regmap;
    constexpr std::uint32_t FIFOS[] = {PS2_0_DATA, PS2_1_DATA, JTAG_UART0_DATA, JTAG_UART1_DATA,
                                       IRDA_DATA};
    constexpr std::uint32_t VALID = 1 << PS2_0_DATA_RVALID_LSB, NEW = 1 << ADC_CH_0_NEW_LSB;
    static_assert(PS2_0_DATA_RVALID_LSB == JTAG_UART0_DATA_RVALID_LSB &&
                  PS2_0_DATA_RVALID_LSB == IRDA_DATA_RVALID_LSB);
    constexpr std::uint32_t HPS[] = {
        0xFFFEC600,
        0xFFFEC608,
        0xFFFEC60C,  // private timer: load, control, status
        0xFFFEC20C,  // global timer: status
        Peripherals::GPIO1_BASE + 0x00,
        Peripherals::GPIO1_BASE + 0x04,
        Peripherals::GPIO1_BASE + 0x50,  // its data, directions, pins
        0xFFC08010,
        0xFFC09010,
        0xFFD00010,
        0xFFD01010,  // timers: status
    };
    constexpr std::uint32_t UART_STATUS = 0xFFC02014, OVERRUN = 2,  // which reading clears
        UART_FIFOS = 0xFFC0207C;
    if (address == UART_FIFOS) return true;
    if (address == UART_STATUS) return !(value & OVERRUN);
    if (address - LW_BASE >= LW_SIZE)
        return std::find(std::begin(HPS), std::end(HPS), address) != std::end(HPS);
    if (address - ADC_BASE < ADC_SIZE) return !(value & NEW);
    if (address == AUDIO_LEFTDATA || address == AUDIO_RIGHTDATA) return false;
    const bool fifo =
        std::find(std::begin(FIFOS), std::end(FIFOS), address & ~3u) != std::end(FIFOS);
    return !fifo || (address % 4 == 0 && !(value & VALID));
}

ComputerFabric::ComputerFabric(PinListener& pins, ChipObserver& observer, std::uint8_t* sdram,
                               const Settings& settings, std::uint32_t memory_base)
    : lost_accesses_{memory_base, settings.has_jp2},
      fabric{pins, settings.trace, settings.audio_rate},
      fpga{"fpga", pins, fabric, ClockPhases{FABRIC_PERIOD_PS, settings.seed}},
      bridges{"bridges", fpga, FpgaBridges::Bursts::LONG},
      jtag_host{"jtag_host", fpga, fabric,
                [&observer](unsigned number, char character) {
                    observer.console(character, number ? SerialLine::JTAG_1 : SerialLine::JTAG_0);
                }},
      memory_base_{memory_base},
      has_jp2_{settings.has_jp2} {
    fabric.set_memory(settings.memory, sdram);
}

void ComputerFabric::describe(const char* memories, const char* registers, Bus& bus,
                              const Processor& cpu, ChipObserver& observer,
                              const std::vector<Bus::Place>& others) {
    bus.name_registers(fpga_registers(has_jp2_));
    bus.describe(memories, "the full bridge",
                 fpga_places(H2F_BASE, H2F_SIZE, regmap::SDRAM_BASE - memory_base_));
    std::vector<Bus::Place> places = fpga_places(LW_BASE, LW_SIZE, 0, has_jp2_);
    places.insert(places.end(), others.begin(), others.end());
    bus.describe(registers, "the lightweight bridge", std::move(places));
    if (!has_jp2_) {  // the default slave of the interconnect answers
        constexpr const regmap::Block& OTHER = regmap::lw_default();
        constexpr std::uint32_t TO = OTHER.base + regmap::JP2_BASE % OTHER.size;
        bus.divert(registers, {regmap::JP2_BASE, regmap::JP2_SIZE, regmap::LW_DECODED, TO});
    }
    const auto is_other = [others](std::uint32_t address) {
        return std::any_of(others.begin(), others.end(), [address](const Bus::Place& place) {
            return address - place.base < place.size;
        });
    };
    for (const char* window : {memories, registers})
        bus.on_answered(window,
                        [=, &cpu, &observer](std::uint32_t address, unsigned bytes, bool write) {
                            if (is_other(address) || cpu.is_inspected()) return;
                            if (const auto lost = lost_accesses_.look(address, bytes, write))
                                observer.log(*lost + cpu.accessed());
                        });
}

std::vector<std::string> ComputerFabric::characters() {
    constexpr unsigned ROWS = 60, COLUMNS = 80, BURST = 40;
    std::vector<std::string> rows;
    for (unsigned y = 0; y < ROWS; ++y) {
        std::string row(COLUMNS, ' ');
        for (unsigned x = 0; x < COLUMNS; x += BURST)
            bridges.peek(true, regmap::CHARACTERS_BASE - H2F_BASE + (y << 7) + x,
                         reinterpret_cast<std::uint8_t*>(&row[x]), BURST);
        std::replace(row.begin(), row.end(), '\0', ' ');  // both show nothing
        rows.push_back(row);
    }
    return rows;
}

}  // namespace sim
