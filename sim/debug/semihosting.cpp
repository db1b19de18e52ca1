#include "sim/debug/semihosting.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

namespace sim {

using sc_core::sc_time;

namespace {

constexpr std::uint32_t SYS_OPEN = 0x01, FAILED = 0xFFFFFFFF;
constexpr std::uint32_t APPLICATION_EXIT = 0x20026;  // the reason of a program that just ends
constexpr std::uint32_t TICKS_PER_SECOND = 1'000'000'000;

// Handles of open files; 0 is none.
constexpr std::uint32_t INPUT = 1, OUTPUT = 2, ERRORS = 3, FEATURES = 4;
constexpr std::uint32_t WRITING = 4, APPENDING = 8;  // the first modes of SYS_OPEN that do

// ":semihosting-features": exit codes by SYS_EXIT_EXTENDED, and a handle for standard error.
constexpr std::array<std::uint8_t, 5> FEATURE_BYTES{'S', 'H', 'F', 'B', 3};

bool is_console(std::uint32_t handle) { return handle >= INPUT && handle <= ERRORS; }

struct NoMemory {};  // where the program said that its arguments are

}  // namespace

const std::vector<Semihosting::Operation>& Semihosting::operations() {
    using S = Semihosting;
    static const std::vector<Operation> operations{
        {SYS_OPEN, "SYS_OPEN", &S::sys_open},
        {0x02, "SYS_CLOSE", &S::sys_close},
        {0x03, "SYS_WRITEC", &S::sys_writec},
        {0x04, "SYS_WRITE0", &S::sys_write0},
        {0x05, "SYS_WRITE", &S::sys_write},
        {0x06, "SYS_READ", &S::sys_read},
        {0x07, "SYS_READC", &S::sys_readc},
        {0x08, "SYS_ISERROR", &S::sys_iserror},
        {0x09, "SYS_ISTTY", &S::sys_istty},
        {0x0A, "SYS_SEEK", &S::sys_seek},
        {0x0C, "SYS_FLEN", &S::sys_flen},
        {0x0D, "SYS_TMPNAM", nullptr},
        {0x0E, "SYS_REMOVE", nullptr},
        {0x0F, "SYS_RENAME", nullptr},
        {0x10, "SYS_CLOCK", &S::sys_clock},
        {0x11, "SYS_TIME", &S::sys_time},
        {0x12, "SYS_SYSTEM", nullptr},
        {0x13, "SYS_ERRNO", &S::sys_errno},
        {0x15, "SYS_GET_CMDLINE", &S::sys_get_cmdline},
        {0x16, "SYS_HEAPINFO", &S::sys_heapinfo},
        {0x18, "SYS_EXIT", &S::sys_exit},
        {0x20, "SYS_EXIT_EXTENDED", &S::sys_exit_extended},
        {0x30, "SYS_ELAPSED", &S::sys_elapsed},
        {0x31, "SYS_TICKFREQ", &S::sys_tickfreq},
    };
    return operations;
}

Semihosting::Semihosting(ArmCpu& cpu, Outside outside)
    : cpu_{cpu},
      outside_{std::move(outside)},
      terminal_{{[&cpu] { return cpu.now(); }, [&cpu](const sc_time& time) { cpu.pause(time); },
                 [&cpu](const sc_core::sc_event& until, const sc_time& at_most) {
                     cpu.pause(until, at_most);
                 },
                 outside_.print}} {
    cpu.set_semihosting([this](ArmCore& core) { answer(core); });
}

void Semihosting::answer(ArmCore& core) {
    if (!asked_)
        log("answered as by a debugger; on the board the program goes no further without one");
    asked_ = true;
    core.set_reg(0, answer(core.reg(0), core.reg(1)));
}

std::uint32_t Semihosting::answer(std::uint32_t number, std::uint32_t argument) {
    const auto found =
        std::find_if(operations().begin(), operations().end(),
                     [number](const Operation& operation) { return operation.number == number; });
    const bool named = found != operations().end();
    if (!named || !found->answer) {
        log_once(number, fmt::format("operation 0x{:02X}{} is not answered", number,
                                     named ? std::string{", "} + found->name + "," : ""));
        return fail(EINVAL);
    }
    try {
        return (this->*found->answer)(argument);
    } catch (const NoMemory&) {
        return fail(EFAULT);
    }
}

std::uint32_t Semihosting::fail(int error) {
    error_ = error;
    return FAILED;
}

void Semihosting::log_once(std::uint32_t operation, const std::string& what) {
    if (logged_.insert(operation).second) log(what);
}

void Semihosting::log(const std::string& what) const {
    outside_.log("semihosting: " + what + ", " + cpu_.where());
}

// ---- The program's memory -----------------------------------------------------------------------

std::uint32_t Semihosting::word(std::uint32_t address) const {
    std::uint32_t value = 0;
    if (!cpu_.read_memory(address, &value, sizeof value)) throw NoMemory{};
    return value;
}

std::uint8_t Semihosting::byte(std::uint32_t address) const {
    std::uint8_t value = 0;
    if (!cpu_.read_memory(address, &value, sizeof value)) throw NoMemory{};
    return value;
}

void Semihosting::put(std::uint32_t address, const void* data, std::size_t bytes) {
    if (!cpu_.write_memory(address, data, static_cast<unsigned>(bytes))) throw NoMemory{};
}

// ---- Files --------------------------------------------------------------------------------------

std::uint32_t Semihosting::sys_open(std::uint32_t block) {
    constexpr std::uint32_t LONGEST = 4096;
    const std::uint32_t from = word(block), mode = word(block + 4);
    const std::uint32_t bytes = std::min(word(block + 8), LONGEST);
    std::string name;
    for (std::uint32_t i = 0; i < bytes; ++i) name += static_cast<char>(byte(from + i));
    if (name == ":tt") return mode < WRITING ? INPUT : mode < APPENDING ? OUTPUT : ERRORS;
    if (name == ":semihosting-features") {
        features_place_ = 0;
        return FEATURES;
    }
    log_once(SYS_OPEN, fmt::format("\"{}\" is not opened: there is only the console", name));
    return fail(ENOENT);
}

std::uint32_t Semihosting::sys_close(std::uint32_t block) {
    return is_console(word(block)) || word(block) == FEATURES ? 0 : fail(EBADF);
}

std::uint32_t Semihosting::sys_istty(std::uint32_t block) { return is_console(word(block)); }

std::uint32_t Semihosting::sys_iserror(std::uint32_t block) { return word(block) >> 31; }

std::uint32_t Semihosting::sys_seek(std::uint32_t block) {
    if (word(block) != FEATURES || word(block + 4) > FEATURE_BYTES.size()) return fail(EINVAL);
    features_place_ = word(block + 4);
    return 0;
}

std::uint32_t Semihosting::sys_flen(std::uint32_t block) {
    if (is_console(word(block))) return 0;
    return word(block) == FEATURES ? std::uint32_t{FEATURE_BYTES.size()} : fail(EBADF);
}

// ---- The console --------------------------------------------------------------------------------

void Semihosting::print(std::uint8_t c) {
    constexpr unsigned BUFFER = 4096;
    const sc_time character{10. / 115'200, sc_core::SC_SEC};
    line_free_ = std::max(line_free_, cpu_.now()) + character;
    if (line_free_ - cpu_.now() > BUFFER * character)
        cpu_.pause(line_free_ - cpu_.now() - BUFFER * character);
    outside_.print(static_cast<char>(c));
}

std::uint32_t Semihosting::sys_writec(std::uint32_t address) {
    print(byte(address));
    return 0;
}

std::uint32_t Semihosting::sys_write0(std::uint32_t address) {
    while (const std::uint8_t c = byte(address++)) print(c);
    return 0;
}

// The result is how many bytes were not written.
std::uint32_t Semihosting::sys_write(std::uint32_t block) {
    const std::uint32_t handle = word(block), from = word(block + 4), bytes = word(block + 8);
    if (handle != OUTPUT && handle != ERRORS) {
        fail(EBADF);
        return bytes;
    }
    for (std::uint32_t i = 0; i < bytes; ++i) print(byte(from + i));
    return 0;
}

// The result is how many bytes were not read: all, at the end.
std::uint32_t Semihosting::sys_read(std::uint32_t block) {
    const std::uint32_t handle = word(block), to = word(block + 4), bytes = word(block + 8);
    std::array<char, 4096> read;
    std::size_t count = std::min<std::size_t>(bytes, read.size());
    if (handle == INPUT) {
        count = static_cast<std::size_t>(terminal_.read(read.data(), count));
    } else if (handle == FEATURES) {
        count = std::min(count, FEATURE_BYTES.size() - features_place_);
        std::memcpy(read.data(), FEATURE_BYTES.data() + features_place_, count);
        features_place_ += static_cast<std::uint32_t>(count);
    } else {
        fail(EBADF);
        return bytes;
    }
    put(to, read.data(), count);
    return bytes - static_cast<std::uint32_t>(count);
}

std::uint32_t Semihosting::sys_readc(std::uint32_t) {
    char c = 0;
    return terminal_.read(&c, 1) == 1 ? static_cast<std::uint8_t>(c) : FAILED;
}

// ---- Time ---------------------------------------------------------------------------------------

std::uint64_t Semihosting::parts_of_a_second(std::uint32_t parts) const {
    return cpu_.now().value() / (1'000'000'000'000 / parts);  // of picoseconds
}

std::uint32_t Semihosting::sys_clock(std::uint32_t) {
    return static_cast<std::uint32_t>(parts_of_a_second(100));
}

std::uint32_t Semihosting::sys_time(std::uint32_t) {
    return static_cast<std::uint32_t>(parts_of_a_second(1));
}

std::uint32_t Semihosting::sys_elapsed(std::uint32_t to) {
    const std::uint64_t ticks = parts_of_a_second(TICKS_PER_SECOND);
    put(to, &ticks, sizeof ticks);
    return 0;
}

std::uint32_t Semihosting::sys_tickfreq(std::uint32_t) { return TICKS_PER_SECOND; }

// ---- The program --------------------------------------------------------------------------------

std::uint32_t Semihosting::sys_errno(std::uint32_t) { return static_cast<std::uint32_t>(error_); }

std::uint32_t Semihosting::sys_get_cmdline(std::uint32_t block) {
    const std::string name = cpu_.program().elf.file.filename().string();
    const auto length = static_cast<std::uint32_t>(name.size());
    if (word(block + 4) <= length) return fail(E2BIG);
    put(word(block), name.c_str(), length + 1);
    put(block + 4, &length, sizeof length);
    return 0;
}

// Heap from, to; stack from, to.  0: as the program's linker has it.
std::uint32_t Semihosting::sys_heapinfo(std::uint32_t block) {
    const std::uint32_t info[4] = {0, 0, ArmCpu::STACK, 0};
    put(word(block), info, sizeof info);
    return 0;
}

void Semihosting::end(std::uint32_t reason, std::uint32_t code) {
    exit_code_ = reason == APPLICATION_EXIT ? static_cast<int>(code) : 1;
    cpu_.end(*exit_code_ == 0 ? ""
                              : fmt::format("the program ended with exit code {} {}", *exit_code_,
                                            cpu_.where()));
}

std::uint32_t Semihosting::sys_exit(std::uint32_t reason) {
    end(reason, 0);
    return 0;
}

std::uint32_t Semihosting::sys_exit_extended(std::uint32_t block) {
    end(word(block), word(block + 4));
    return 0;
}

}  // namespace sim
