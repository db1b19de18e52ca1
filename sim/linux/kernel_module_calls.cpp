// kernel_module_calls.cpp - LinuxKernel's answers to modules: interrupts, messages, bugs
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"
#include "sim/process/run_command.h"

namespace sim {

namespace {

// Of the processor's interrupt controller (gic.h).
namespace gic {
constexpr std::uint32_t ICCICR = 0xFFFEC100, ICCPMR = 0xFFFEC104, ICCIAR = 0xFFFEC10C,
                        ICCEOIR = 0xFFFEC110, ICDDCR = 0xFFFED000, ICDISER = 0xFFFED100,
                        ICDICER = 0xFFFED180, ICDIPTR = 0xFFFED800, ICDICFR = 0xFFFEDC00;
constexpr unsigned FIRST_SHARED = 32, IDS = 256, ID = 0x3FF, NONE = 1022;
}  // namespace gic

// Memory that modules allocate for the bus: the top of the board's, which Linux leaves to it.
constexpr std::uint32_t DMA_BEGIN = 0x3E000000, DMA_END = 0x40000000;

}  // namespace

// ---- What a module calls ------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::call_of_module(const Arguments& a) {
    KernelModule& module = *process_->module;
    switch (static_cast<kmod_call>(a[0])) {
        case KMOD_NEXT: return module_next(module, a[1]);
        case KMOD_COPY: return module_copy(a[1], a[2], a[3], a[4]);
        case KMOD_MAP: {
            LinuxProcess* const below = const_cast<LinuxProcess*>(process_below(*running_));
            if (!below || a[1] % AddressSpace::PAGE || a[3] == 0 ||
                !below->memory->is_mapped(a[1], a[3]))
                return -EINVAL;
            return below->memory->map_bus(a[1], a[3], arm_access::READ | arm_access::WRITE, a[2])
                       ? 0
                       : -ENOMEM;
        }
        case KMOD_OFFER: {
            const auto path = memory().string(a[1]);
            if (!path) return -EFAULT;
            if (!path->empty() && module_node(*path)) return -EEXIST;
            module.files[a[4]] = {*path, a[2], a[3]};
            return 0;
        }
        case KMOD_WITHDRAW: module.files.erase(a[1]); return 0;
        case KMOD_INTERRUPT_ENABLE: return enable_interrupt(module, a[1], a[2], a[3]);
        case KMOD_INTERRUPT_DISABLE: {
            const auto found = interrupts_.find(a[1]);
            if (found == interrupts_.end() || !found->second.module) return -EINVAL;
            mask_interrupt(a[1]);
            found->second.enabled = false;
            if (!a[2]) return 0;
            if (found->second.waiting) resume(*found->second.waiting, -ENODEV);
            interrupts_.erase(found);
            return 0;
        }
        case KMOD_INTERRUPT_WAIT: return wait_for_interrupt(a[1]);
        case KMOD_SLEEP: return module_sleep(module, a);
        case KMOD_WAKE: return futex_wake(futex_key(a[1]), ~0u, ~0u);
        case KMOD_POLLED:
            poll_again();
            changed_ = true;
            return 0;
        case KMOD_LOG: {
            const std::uint8_t* const text = memory().bytes(a[1], a[2], arm_access::READ);
            if (!text) return -EFAULT;
            print_message({reinterpret_cast<const char*>(text), a[2]}, static_cast<int>(a[3]));
            return 0;
        }
        case KMOD_STOP: {
            const auto text = memory().string(a[1]);
            stop_by_bug(text.value_or("BUG"), (a[2] & ~1u) - 2);  // the call, not its return
            return std::nullopt;
        }
        case KMOD_SIGNAL: {
            int owner = ModuleFile::NOBODY;
            for (const auto& process : processes_)
                process->files.for_each_device([&](LinuxDevice& device) {
                    auto* const file = dynamic_cast<ModuleFile*>(&device);
                    if (file && &file->module == &module && file->id == a[1]) owner = file->owner;
                });
            if (LinuxProcess* const process = process_of(owner))
                send(*process, {a[2], arm_signal_code::KERNEL, {}, "a module sent it"});
            return 0;
        }
        case KMOD_ALLOCATE: {
            const std::uint64_t bytes =
                (std::uint64_t{a[1]} + AddressSpace::PAGE - 1) & ~(AddressSpace::PAGE - 1ull);
            const std::uint32_t at = dma_end_ ? dma_end_ : DMA_BEGIN;
            if (bytes == 0 || at + bytes > DMA_END) return -ENOMEM;
            if (!memory().write(a[2], &at, sizeof at)) return -EFAULT;
            dma_end_ = at + static_cast<std::uint32_t>(bytes);
            return 0;
        }
    }
    return -ENOSYS;
}

std::int64_t LinuxKernel::module_copy(std::uint32_t to, std::uint32_t from, std::uint32_t bytes,
                                      bool to_program) {
    const LinuxProcess* const below = process_below(*running_);
    if (!below || !below->memory) return bytes;
    AddressSpace& program = *below->memory;
    std::uint8_t* const target =
        (to_program ? program : memory()).bytes(to, bytes, arm_access::WRITE);
    const std::uint8_t* const source =
        (to_program ? memory() : program).bytes(from, bytes, arm_access::READ);
    if (!target || !source) return bytes;
    std::memcpy(target, source, bytes);
    return 0;
}

LinuxKernel::Result LinuxKernel::module_sleep(KernelModule& module, const Arguments& a) {
    const std::uint64_t span = std::uint64_t{a[4]} << 32 | a[3];
    const bool interruptible = a[5] != 0;
    const auto served = module.served.find(running_);
    if (interruptible && served != module.served.end() && served->second->thread &&
        wakes(*served->second->thread))
        return -EINTR;
    std::uint32_t word;
    if (!memory().read(a[1], &word, sizeof word)) return -EFAULT;
    if (word != a[2]) return 0;
    const std::uint64_t end = span == ~std::uint64_t{0} ? LinuxWait::NEVER : later_ns(span);
    const Result result = futex_wait(a[1], a[2], ~0u, end);
    if (!result) {
        running_->wait->uninterrupted = true;
        running_->wait->by_signal = interruptible;
        running_->wait->idle = served == module.served.end();
    }
    return result;
}

// As the board's console shows it, and `dmesg`; level -1 continues a line.
void LinuxKernel::print_message(const std::string& text, int level) {
    constexpr int SHOWN = 7;  // below this, as Linux' default
    const std::uint64_t us = now_ns() / 1000;
    std::string line;
    if (level >= 0 || messages_.empty() || messages_.back() == '\n')
        line = fmt::format("[{:5}.{:06}] ", us / 1'000'000, us % 1'000'000);
    if (level >= 0 && !messages_.empty() && messages_.back() != '\n') line = "\n" + line;
    line += text;
    messages_ += line;
    if (level >= SHOWN) return;
    for (const char c : line) outside_.console(c);
}

// ---- Interrupts ---------------------------------------------------------------------------------

// What it was before.
std::uint32_t LinuxKernel::change_register(std::uint32_t address, std::uint32_t clear,
                                           std::uint32_t set) {
    std::uint32_t value = 0;
    outside_.access(false, address, value);
    const std::uint32_t was = value;
    value = (value & ~clear) | set;
    if (value != was) outside_.access(true, address, value);
    return was;
}

void LinuxKernel::mask_interrupt(unsigned number) {
    std::uint32_t bit = 1u << number % 32;
    outside_.access(true, gic::ICDICER + number / 32 * 4, bit);
}

std::int64_t LinuxKernel::enable_interrupt(KernelModule& module, unsigned number,
                                           std::uint32_t trigger, std::uint32_t name) {
    constexpr std::uint32_t EDGE = 1, AGAIN = 2;
    if (number < gic::FIRST_SHARED || number >= gic::IDS) return -EINVAL;
    if (trigger == AGAIN) {
        const auto found = interrupts_.find(number);
        if (found == interrupts_.end() || !found->second.module) return -EINVAL;
        found->second.enabled = true;
        if (found->second.waiting) unmask_interrupt(number);
        return 0;
    }
    if (interrupts_.count(number)) return -EBUSY;
    interrupts_[number] = {&module, memory().string(name).value_or("")};
    route_interrupt(number, trigger & EDGE);
    return 0;
}

// To the processor, if it is unmasked.
void LinuxKernel::route_interrupt(unsigned number, bool by_edge) {
    const unsigned byte = number % 4 * 8, pair = number % 16 * 2;
    change_register(gic::ICDIPTR + number / 4 * 4, 0xFFu << byte, 1u << byte);
    change_register(gic::ICDICFR + number / 16 * 4, 3u << pair, (by_edge ? 3u : 1u) << pair);
    std::uint32_t on = 1, lowest = 0xF0;
    outside_.access(true, gic::ICDDCR, on);
    outside_.access(true, gic::ICCPMR, lowest);
    outside_.access(true, gic::ICCICR, on);
}

// An interrupt of GPIO's, which the kernel handles itself.
int LinuxKernel::listen_to(unsigned number) {
    const auto [found, is_new] =
        interrupts_.try_emplace(number, ModuleInterrupt{nullptr, "gpiolib"});
    if (!is_new) return found->second.module ? -EBUSY : 0;
    route_interrupt(number, false);
    unmask_interrupt(number);
    return 0;
}

void LinuxKernel::unmask_interrupt(unsigned number) {
    std::uint32_t bit = 1u << number % 32;
    outside_.access(true, gic::ICDISER + number / 32 * 4, bit);
}

LinuxKernel::Result LinuxKernel::wait_for_interrupt(unsigned number) {
    const auto found = interrupts_.find(number);
    if (found == interrupts_.end()) return -ENODEV;
    ModuleInterrupt& interrupt = found->second;
    if (interrupt.enabled && std::exchange(interrupt.pending, false)) {
        interrupt.since_ns = now_ns();
        return 0;
    }
    interrupt.running = nullptr;
    interrupt.waiting = running_;
    LinuxWait wait;
    wait.what = fmt::format("interrupt {}", number);
    wait.uninterrupted = wait.idle = true;
    const Result result = this->wait(std::move(wait));
    if (interrupt.enabled) unmask_interrupt(number);
    return result;
}

// The controller signals: acknowledges all, each masked until its handler has run.
void LinuxKernel::take_interrupts() {
    while (cpu_.irq()) {
        std::uint32_t acknowledged = 0;
        if (!outside_.access(false, gic::ICCIAR, acknowledged)) return;
        const unsigned number = acknowledged & gic::ID;
        if (number >= gic::NONE) return;
        mask_interrupt(number);
        outside_.access(true, gic::ICCEOIR, acknowledged);
        const auto found = interrupts_.find(number);
        if (found == interrupts_.end()) continue;
        ModuleInterrupt& interrupt = found->second;
        ++interrupt.count;
        if (!interrupt.module) {
            gpio_.interrupt(number);
            unmask_interrupt(number);
            changed_ = true;
            continue;
        }
        if (LinuxThread* const thread = std::exchange(interrupt.waiting, nullptr)) {
            interrupt.running = thread;
            interrupt.since_ns = now_ns();
            resume(*thread, 0);
        } else {
            interrupt.pending = true;
        }
    }
}

// The one whose handler runs.
std::map<unsigned, ModuleInterrupt>::const_iterator LinuxKernel::handled_interrupt() const {
    return std::find_if(interrupts_.begin(), interrupts_.end(), [this](const auto& entry) {
        return running_ && entry.second.running == running_;
    });
}

// When its handler has run too long: the board's kernel finds that, too, and nothing else happens
// there any more.
std::uint64_t LinuxKernel::lockup_ns() const {
    constexpr std::uint64_t LONGEST_HANDLER_NS = NS;
    const auto handled = handled_interrupt();
    return handled == interrupts_.end() ? LinuxWait::NEVER
                                        : handled->second.since_ns + LONGEST_HANDLER_NS;
}

void LinuxKernel::find_lockup() {
    if (now_ns() < lockup_ns()) return;
    const auto& [number, interrupt] = *handled_interrupt();
    stop_by_bug(
        fmt::format("soft lockup: the handler of interrupt {} ({}) has not returned for 1 s",
                    number, interrupt.name),
        cpu_.core().pc());
}

// The line to the processor has risen, perhaps within an access of a program.
void LinuxKernel::interrupt_raised() { feel(); }

// ---- Bugs ---------------------------------------------------------------------------------------

// "dial_write+0x24/0x80 [dial]".
std::string LinuxKernel::place_in_module(std::uint32_t pc) const {
    const std::string function = cpu_.program().elf.function(pc);
    if (function.empty()) return fmt::format("0x{:08x}", pc);
    const std::size_t of = function.find(" of ");
    const std::string place = function.substr(0, of);
    return place + (place.find('+') == std::string::npos ? "+0x0" : "") +
           (of == std::string::npos ? "" : fmt::format(" [{}]", function.substr(of + 4)));
}

// "dial.c:12", as the cross compiler's addr2line says; "" without it.
std::string LinuxKernel::line_in_module(std::uint32_t pc) const {
    constexpr unsigned LIMIT_S = 20;
    const Outcome outcome = run_command({"arm-linux-gnueabihf-addr2line", "-s", "-e",
                                         process_->module->elf.string(), fmt::format("0x{:x}", pc)},
                                        "/", LIMIT_S);
    const std::string line = outcome.output.substr(0, outcome.output.find_first_of(" \n"));
    return outcome.code == 0 && line.find('?') == std::string::npos ? line : "";
}

// A fault in a module: as the kernel prints it; the run ends.
void LinuxKernel::stop_by_fault(unsigned signal, std::uint32_t address, const std::string& why) {
    constexpr std::uint32_t NULL_PAGE = AddressSpace::PAGE;
    const std::string what =
        signal == SIGILL
            ? "undefined instruction"
            : fmt::format("Unable to handle kernel {} at virtual address {:08x}",
                          address < NULL_PAGE ? "NULL pointer dereference" : "paging request",
                          address);
    stop_by_bug(fmt::format("{} ({})", what, why), cpu_.core().pc());
}

void LinuxKernel::stop_by_bug(const std::string& what, std::uint32_t pc) {
    const ArmCore& core = cpu_.core();
    const std::string name = process_->module->name;
    const auto served = process_->module->served.find(running_);
    const LinuxThread* const caller =
        served == process_->module->served.end() ? nullptr : served->second->thread;
    std::string command = running_->name;
    if (caller) command = caller->process.command.substr(caller->process.command.rfind('/') + 1);
    constexpr int EMERGENCY = 0;
    const auto line = [this](const std::string& text) { print_message(text + "\n", EMERGENCY); };
    line(what);
    line("Internal error: Oops [#1] SMP ARM");
    std::string linked;
    for (const auto& module : modules_) linked += " " + module->name;
    line("Modules linked in:" + linked);
    line(fmt::format("CPU: 0 PID: {} Comm: {}", caller ? caller->number : running_->number,
                     command.empty() ? name : command));
    const std::string source = line_in_module(pc);
    const std::string place =
        place_in_module(pc) + (source.empty() ? "" : fmt::format(" ({})", source));
    line("PC is at " + place);
    line(fmt::format("LR is at {}", place_in_module(core.reg(14) & ~1u)));
    line(fmt::format("pc : [<{:08x}>]    lr : [<{:08x}>]    psr: {:08x}", pc, core.reg(14),
                     core.cpsr()));
    cpu_.show_end(SIGSEGV);
    over_ = true;
    cpu_.end(fmt::format("kernel oops in {}, at {:.6f} ms: {}", place,
                         static_cast<double>(now_ns()) / 1e6, what));
}

}  // namespace sim
