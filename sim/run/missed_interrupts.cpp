// missed_interrupts.cpp - see missed_interrupts.h
#include "sim/run/missed_interrupts.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "regmap.h"
#include "sim/text/seconds.h"

namespace sim {

namespace {

constexpr unsigned FIRST_PRIVATE = 16, FIRST_OF_FPGA = 72, STORM = 100;
constexpr unsigned PS2_1_IN_THE_MANUAL = 89;

struct Register {
    const char* name;
    std::uint32_t address;
};

// What a device has to say, and the bits of the same number that let it; or all of `enable_bits`.
struct Device {
    unsigned id;
    const char* name;
    Register event;
    std::uint32_t event_bits;
    Register enable;
    std::uint32_t enable_bits = 0;  // 0: a bit for each of the events'
    bool keeps_back = false;        // 1 in `enable`
};

#define REGISTER(name) \
    { #name, regmap::name }
#define BITS(field) regmap::field##_MASK
constexpr std::uint32_t ALL = 0xFFFFFFFF;
constexpr Device DEVICES[] = {
    {27, "the global timer", {"its status", 0xFFFEC20C}, 1, {"its control", 0xFFFEC208}, 4},
    {29, "the private timer", {"its status", 0xFFFEC60C}, 1, {"its control", 0xFFFEC608}, 4},
    {30, "the watchdog", {"its status", 0xFFFEC62C}, 1, {"its control", 0xFFFEC628}, 4},
    {regmap::TIMER0_IRQ_ID, "TIMER0", REGISTER(TIMER0_STATUS), BITS(TIMER0_STATUS_TO),
     REGISTER(TIMER0_CONTROL), BITS(TIMER0_CONTROL_ITO)},
    {regmap::KEY_IRQ_ID, "KEY", REGISTER(KEY_EDGE), ALL, REGISTER(KEY_MASK)},
    {regmap::TIMER1_IRQ_ID, "TIMER1", REGISTER(TIMER1_STATUS), BITS(TIMER1_STATUS_TO),
     REGISTER(TIMER1_CONTROL), BITS(TIMER1_CONTROL_ITO)},
    {regmap::AUDIO_IRQ_ID, "AUDIO", REGISTER(AUDIO_CONTROL),
     BITS(AUDIO_CONTROL_RI) | BITS(AUDIO_CONTROL_WI), REGISTER(AUDIO_CONTROL),
     BITS(AUDIO_CONTROL_RE) | BITS(AUDIO_CONTROL_WE)},
    {regmap::PS2_0_IRQ_ID, "PS2_0", REGISTER(PS2_0_CONTROL), BITS(PS2_0_CONTROL_RI),
     REGISTER(PS2_0_CONTROL), BITS(PS2_0_CONTROL_RE)},
    {regmap::PS2_1_IRQ_ID, "PS2_1", REGISTER(PS2_1_CONTROL), BITS(PS2_1_CONTROL_RI),
     REGISTER(PS2_1_CONTROL), BITS(PS2_1_CONTROL_RE)},
    {regmap::JTAG_UART0_IRQ_ID, "JTAG_UART0", REGISTER(JTAG_UART0_DATA),
     BITS(JTAG_UART0_DATA_RVALID), REGISTER(JTAG_UART0_CONTROL), BITS(JTAG_UART0_CONTROL_RE)},
    {regmap::JTAG_UART1_IRQ_ID, "JTAG_UART1", REGISTER(JTAG_UART1_DATA),
     BITS(JTAG_UART1_DATA_RVALID), REGISTER(JTAG_UART1_CONTROL), BITS(JTAG_UART1_CONTROL_RE)},
    {regmap::IRDA_IRQ_ID, "IRDA", {}, 0, {}},
    {regmap::JP1_IRQ_ID, "JP1", REGISTER(JP1_EDGE), ALL, REGISTER(JP1_MASK)},
    {regmap::JP2_IRQ_ID, "JP2", REGISTER(JP2_EDGE), ALL, REGISTER(JP2_MASK)},
    {regmap::KEYPAD_IRQ_ID, "KEYPAD", REGISTER(KEYPAD_STATUS), 7, REGISTER(KEYPAD_MASK)},
    {194, "UART0", {"its LSR", 0xFFC02014}, 1, {"its IER", 0xFFC02004}, 1},
    {197, "GPIO1", {"gpio_raw_intstatus", 0xFF709044}, ALL, {"gpio_intmask", 0xFF709034}, 0, true},
    {199, "HPS timer 0", {"its raw status", 0xFFC080A8}, 1, {"its control", 0xFFC08008}, 4, true},
    {200, "HPS timer 1", {"its raw status", 0xFFC090A8}, 1, {"its control", 0xFFC09008}, 4, true},
    {201, "HPS timer 2", {"its raw status", 0xFFD000A8}, 1, {"its control", 0xFFD00008}, 4, true},
    {202, "HPS timer 3", {"its raw status", 0xFFD010A8}, 1, {"its control", 0xFFD01008}, 4, true},
};
#undef REGISTER
#undef BITS

std::string describe(const Register& place, std::uint32_t value) {
    return fmt::format("{} (0x{:08X}) is 0x{:X}", place.name, place.address, value);
}

// What keeps a device from raising its interrupt though it has something to say: "KEY_EDGE (...) is
// 0x1, but KEY_MASK (...) is 0x0"; or "".  `read`: a register, if it can be read.
template <class Read>
std::string silence(const Device& device, const Read& read) {
    const auto status = read(device.event), let = read(device.enable);
    if (!status || !let || !(*status & device.event_bits)) return "";
    const std::uint32_t on = device.keeps_back ? ~*let : *let;
    if (device.enable_bits ? on & device.enable_bits : on & *status & device.event_bits) return "";
    std::string line = describe(device.event, *status);
    if (device.enable.address != device.event.address)
        line += ", but " + describe(device.enable, *let);
    if (device.enable_bits)
        line += fmt::format(", where 0x{:X} has to be {}", device.enable_bits,
                            device.keeps_back ? 0 : 1);
    return line;
}

class Examination {
public:
    Examination(ProcessorSystem& system, Computer* computer)
        : system_{system}, computer_{computer}, arm_{*system.arm} {}

    std::vector<std::string> lines() {
        if (!uses_interrupts()) return {};
        for (unsigned id = 0; id < GicState::IDS; ++id)
            if (state().pending(id)) look_at_pending(id);
        for (const Device& device : DEVICES)
            if (is_known(device) && device.event.name && state().enabled[device.id] &&
                !state().pending(device.id))
                look_at_silent(device);
        return std::move(lines_);
    }

private:
    const GicState& state() const { return system_.hps.gic.state(); }

    bool is_known(const Device& device) const { return computer_ || !is_of_fpga(device.id); }
    static bool is_of_fpga(unsigned id) { return id - FIRST_OF_FPGA < 64; }

    const Device* device_of(unsigned id) const {
        const auto* const found =
            std::find_if(std::begin(DEVICES), std::end(DEVICES),
                         [&](const Device& d) { return d.id == id && is_known(d); });
        return found == std::end(DEVICES) ? nullptr : found;
    }

    std::string name_of(unsigned id) const {
        const Device* device = device_of(id);
        if (device) return fmt::format("interrupt {} ({})", id, device->name);
        if (!is_of_fpga(id)) return fmt::format("interrupt {}", id);
        return fmt::format("interrupt {} (f2h_irq_p{}[{}])", id, (id - FIRST_OF_FPGA) / 32,
                           (id - FIRST_OF_FPGA) % 32);
    }

    bool uses_interrupts() const {
        if (!(arm_.core().cpsr() & arm_cpsr::I)) return true;
        for (unsigned id = FIRST_PRIVATE; id < GicState::IDS; ++id)
            if (state().enabled[id]) return true;
        return false;
    }

    void look_at_pending(unsigned id) {
        const sc_core::sc_time since = system_.hps.gic.raised_at(id);
        const sc_core::sc_time moment{1, sc_core::SC_MS};
        if (sc_core::sc_time_stamp() < since + moment) return;
        std::vector<std::string> reasons = state().obstacles(id);
        if (state().enabled[id] && state().taken(id) >= STORM) {  // perhaps in its handler just now
            lines_.push_back(
                fmt::format("{} was taken {} times since its line went up at {:.3f} "
                            "ms: its handler does not take the cause away{}",
                            name_of(id), state().taken(id), seconds(since) * 1e3, cause(id)));
            return;
        }
        const std::uint64_t entered = arm_.counts().interrupts;
        if (reasons.empty() && state().taken(id) == 0 && entered >= STORM) {
            lines_.push_back(
                fmt::format("{} is pending since {:.3f} ms, and its handler does not "
                            "read ICCIAR (0xFFFEC10C): it was entered {} times",
                            name_of(id), seconds(since) * 1e3, entered));
            return;
        }
        if (computer_ && id == regmap::PS2_1_IRQ_ID && state().enabled[PS2_1_IN_THE_MANUAL])
            reasons.push_back(
                fmt::format("{}, by which the board's manual calls it, is connected to "
                            "nothing",
                            PS2_1_IN_THE_MANUAL));
        if (const std::string masked = masked_in_cpsr(); !masked.empty()) reasons.push_back(masked);
        if (!reasons.empty())
            lines_.push_back(fmt::format("{} is pending since {:.3f} ms and not taken: {}",
                                         name_of(id), seconds(since) * 1e3,
                                         fmt::join(reasons, "; ")));
    }

    std::string masked_in_cpsr() const {
        const std::uint32_t cpsr = arm_.core().cpsr(), mode = cpsr & arm_cpsr::MODE;
        if (!(cpsr & arm_cpsr::I)) return "";
        if (mode == arm_mode::IRQ || mode == arm_mode::FIQ)
            return "the program is still in an interrupt's handler";
        if (mode == arm_mode::ABT || mode == arm_mode::UND)
            return "the program is in the handler of an abort or undefined instruction";
        return "CPSR.I is 1: the program has masked interrupts (cpsie i lets them in)";
    }

    // ": KEY_EDGE (0xFF20005C) is 0x1", of a device that still has something to say.
    std::string cause(unsigned id) {
        const Device* device = device_of(id);
        const auto event = device && device->event.name ? read(device->event) : std::nullopt;
        return event && (*event & device->event_bits) ? ": " + describe(device->event, *event) : "";
    }

    void look_at_silent(const Device& device) {
        const std::string why =
            silence(device, [this](const Register& place) { return read(place); });
        if (!why.empty())
            lines_.push_back(fmt::format("{} is enabled in the distributor, and not raised: {}",
                                         name_of(device.id), why));
    }

    std::optional<std::uint32_t> read(const Register& place) {
        if (computer_ && place.address - regmap::LW_BASE < regmap::LW_SIZE)
            return computer_->bridges.peek(place.address - regmap::LW_BASE);
        std::uint32_t value = 0;
        if (!arm_.read_memory(place.address, &value, sizeof value)) return std::nullopt;
        return value;
    }

    ProcessorSystem& system_;
    Computer* const computer_;
    ArmCpu& arm_;
    std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> missed_interrupts(ProcessorSystem& system, Computer* computer) {
    if (!system.arm) return {};
    return Examination{system, computer}.lines();
}

// Nios V has no controller: mie and mstatus alone keep a line back.
std::vector<std::string> missed_interrupts(NiosVComputer& computer) {
    const RiscvCore& core = computer.cpu.core();
    const std::uint32_t enabled = core.csr(riscv_csr::MIE).value();
    const bool masked = !(core.csr(riscv_csr::MSTATUS).value() & riscv_mstatus::MIE);
    if (masked && enabled == 0) return {};
    const auto read = [&](const Register& place) {
        return computer.bridges.peek(place.address - regmap::LW_BASE);
    };
    std::vector<std::string> lines;
    const auto look = [&](unsigned number, const char* name, const Device* device) {
        const std::string title = fmt::format("interrupt {} ({})", number, name);
        const bool pending = computer.cpu.lines() >> number & 1, on = enabled >> number & 1;
        std::vector<std::string> reasons;
        if (!on) reasons.push_back(fmt::format("bit {} of mie is 0", number));
        if (masked)
            reasons.push_back(
                "MIE in mstatus is 0: the program has masked interrupts, or is in "
                "a trap's handler");
        if (pending && !reasons.empty())
            lines.push_back(title + " is pending and not taken: " +
                            fmt::format("{}", fmt::join(reasons, "; ")));
        if (pending || !on || !device || !device->event.name) return;
        if (const std::string why = silence(*device, read); !why.empty())
            lines.push_back(title + " is enabled in mie, and not raised: " + why);
    };
    look(MachineTimer::SOFTWARE, "software", nullptr);
    look(MachineTimer::TIMER, "machine timer", nullptr);
    for (const Device& device : DEVICES)
        if (const unsigned number = nios_v_interrupt(device.id)) look(number, device.name, &device);
    return lines;
}

}  // namespace sim
