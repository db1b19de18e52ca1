#include "sim/chip/nios_v_computer.h"

#include <utility>

#include "regmap.h"
#include "sim/hps/bridge_windows.h"

namespace sim {

namespace {

constexpr std::uint32_t MEMORY_SIZE = 0x10000000;
constexpr std::uint32_t TIMER_BASE = 0xFF202100;
constexpr unsigned FIRST_OF_FABRIC = 72;

struct Interrupt {
    unsigned id, number;
};
constexpr Interrupt INTERRUPTS[] = {{regmap::TIMER0_IRQ_ID, 16},     {regmap::TIMER1_IRQ_ID, 17},
                                    {regmap::KEY_IRQ_ID, 18},        {regmap::AUDIO_IRQ_ID, 21},
                                    {regmap::PS2_0_IRQ_ID, 22},      {regmap::PS2_1_IRQ_ID, 23},
                                    {regmap::JTAG_UART0_IRQ_ID, 24}, {regmap::IRDA_IRQ_ID, 25},
                                    {regmap::JP1_IRQ_ID, 27},        {regmap::JP2_IRQ_ID, 28}};

}  // namespace

const std::vector<MemoryRange>& nios_v_memory() {
    static const std::vector<MemoryRange> memory{{0, regmap::SDRAM_SIZE}};
    return memory;
}

unsigned nios_v_interrupt(unsigned id) {
    for (const Interrupt& interrupt : INTERRUPTS)
        if (interrupt.id == id) return interrupt.number;
    return 0;
}

NiosVComputer::NiosVComputer(const sc_core::sc_module_name& name, PinListener& pins,
                             ChipObserver& observer, std::uint8_t* sdram, NiosVProgram program,
                             const Settings& settings, NoMap)
    : sc_module{name},
      ComputerFabric{pins, observer, sdram, settings, 0},
      bus{"bus"},
      window{"window"},
      timer{"timer",
            [this](std::uint32_t lines) {
                of_timer_ = lines;
                hand_on_lines();
            }},
      cpu{"cpu", std::move(program), [&observer](const std::string& line) { observer.log(line); }} {
    cpu.socket.bind(bus.socket);
    window.fpga.bind(bridges.lw);
    window.timer.bind(timer.socket);
    cpu.explain_by([this](auto... access) { return bus.refusal(access...); });
    if (settings.shortcuts) cpu.set_steady_bus(this);
    fpga.on_processor_wires({[this](std::uint64_t levels) { fabric_interrupts(levels); }, {}});
}

NiosVComputer::NiosVComputer(const sc_core::sc_module_name& name, PinListener& pins,
                             ChipObserver& observer, std::uint8_t* sdram, NiosVProgram program,
                             const Settings& settings)
    : NiosVComputer{name, pins, observer, sdram, std::move(program), settings, NoMap{}} {
    bus.window("memory", 0, MEMORY_SIZE).bind(bridges.h2f);
    bus.window("registers", LW_BASE, LW_SIZE).bind(window.socket);
    describe("memory", "registers", bus, cpu, observer,
             {{"the machine timer", TIMER_BASE, MachineTimer::SIZE}});
}

void NiosVComputer::fabric_interrupts(std::uint64_t levels) {
    of_fabric_ = 0;
    for (const Interrupt& interrupt : INTERRUPTS)
        if (levels >> (interrupt.id - FIRST_OF_FABRIC) & 1) of_fabric_ |= 1u << interrupt.number;
    hand_on_lines();
}

void NiosVComputer::set_line(unsigned number, bool up) {
    of_others_ = (of_others_ & ~(1u << number)) | std::uint32_t{up} << number;
    hand_on_lines();
}

// The timer counts, and the memories have no answers that are kept.
bool NiosVComputer::is_plain(std::uint32_t address, bool write, std::uint32_t value) const {
    return !bus.is_watched() && !bus.is_diverted(address) && address - LW_BASE < LW_SIZE &&
           address - TIMER_BASE >= MachineTimer::SIZE &&
           (write ? is_plain_output(address, value) : is_plain_input(address, value));
}

void NiosVComputer::type(const std::string& text, SerialLine to) {
    if (to == SerialLine::JTAG_0) jtag_host.type(0, text);
}

}  // namespace sim
