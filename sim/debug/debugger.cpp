#include "sim/debug/debugger.h"

#include <algorithm>
#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "sim/text/seconds.h"

namespace sim {

namespace {

constexpr int WAIT_MS = 50;  // between two calls of given_up()
constexpr std::uint32_t PAGE = 4096;

// GDB's numbers of signals (include/gdb/signals.def).
constexpr unsigned SIGNAL_INT = 2, SIGNAL_ILL = 4, SIGNAL_TRAP = 5, SIGNAL_BUS = 10,
                   SIGNAL_SEGV = 11, SIGNAL_SYS = 12, SIGNAL_USR1 = 30, SIGNAL_USR2 = 31,
                   SIGNAL_UNKNOWN = 143;

unsigned signal_of(ArmException exception) {
    switch (exception) {
        case ArmException::UNDEFINED: return SIGNAL_ILL;
        case ArmException::SVC: return SIGNAL_SYS;
        default: return SIGNAL_SEGV;
    }
}

unsigned signal_of_linux(unsigned signal) {
    switch (signal) {
        case SIGBUS: return SIGNAL_BUS;
        case SIGUSR1: return SIGNAL_USR1;
        case SIGUSR2: return SIGNAL_USR2;
        case SIGSYS: return SIGNAL_SYS;
        default: return signal <= SIGTERM ? signal : SIGNAL_UNKNOWN;
    }
}

bool is_breakpoint_instruction(const ArmCore& core) {
    std::uint32_t word = 0;
    const bool thumb = core.cpsr() & arm_cpsr::T;
    if (!core.read_ram(core.pc(), &word, thumb ? 2 : 4)) return false;
    return thumb ? (word & 0xff00) == 0xbe00 : (word & 0x0ff000f0) == 0x01200070;
}

// Bytes of the next access to a register: as many as the alignment and the rest allow.
unsigned access_bytes(std::uint32_t address, std::size_t left) {
    return address % 4 == 0 && left >= 4 ? 4 : address % 2 == 0 && left >= 2 ? 2 : 1;
}

// A word of a GDB command.
std::string quoted(const std::string& file) {
    std::string word;
    for (const char c : file) word += (std::strchr(" \t'\"\\", c) ? "\\" : "") + std::string{c};
    return word;
}

// Bytes of RAM that may be read in one piece.
std::size_t piece(std::uint32_t address, std::size_t left) {
    return std::min<std::size_t>(left, PAGE - address % PAGE);
}

}  // namespace

Debugger::Debugger(ArmCpu& cpu, GdbConnection& connection, std::function<bool()> given_up)
    : cpu_{cpu},
      core_{cpu.core()},
      connection_{connection},
      given_up_{std::move(given_up)},
      reply_{fmt::format("T{:02x}thread:1;", SIGNAL_TRAP)} {
    cpu_.attach(this);
}

Debugger::~Debugger() { cpu_.attach(static_cast<ArmInspector*>(nullptr)); }

// ---- When to stop -------------------------------------------------------------------------------

void Debugger::on_start(ArmCore&) {
    while (!connection_.connected() && !given_up_()) connection_.accept(WAIT_MS);
    stop(stopped_by(SIGNAL_TRAP));
}

std::uint64_t Debugger::on_quantum(ArmCore& core, std::uint64_t limit) {
    stepped_ |= stepping_ && stepping_ == quantum_thread_ && core.instructions() != quantum_begin_;
    if (hit_)
        stop(reply_);
    else if (stepping_ == running() && stepped_)
        stop(stopped_by(SIGNAL_TRAP));
    else if (interrupt_)
        stop(stopped_by(unread_ ? SIGNAL_TRAP : SIGNAL_INT));
    quantum_begin_ = core.instructions();
    quantum_thread_ = running();
    return stepping_ == quantum_thread_ ? 1 : limit;
}

void Debugger::on_idle(ArmCore&) {
    if (interrupt_) stop(stopped_by(unread_ ? SIGNAL_TRAP : SIGNAL_INT));
}

// The instruction at which the debugger resumes is not stopped at again.
bool Debugger::before(std::uint32_t) {
    if (core_.instructions() == resumed_at_ && running() == resumed_thread_) return false;
    reply_ = stopped_by(SIGNAL_TRAP, names_breaks_ ? "swbreak:;" : "");
    return hit_ = true;
}

bool Debugger::touched(std::uint32_t address, unsigned bytes, bool write) {
    for (const GdbPoint& point : points_) {
        if (point.kind == GdbPoint::BREAK ||
            point.kind == (write ? GdbPoint::READ : GdbPoint::WRITE))
            continue;
        const bool overlap =
            address - point.address < point.bytes || point.address - address < bytes;
        if (!overlap) continue;
        const char* const name = point.kind == GdbPoint::WRITE  ? "watch"
                                 : point.kind == GdbPoint::READ ? "rwatch"
                                                                : "awatch";
        reply_ = stopped_by(SIGNAL_TRAP, fmt::format("{}:{:x};", name, point.address));
        return hit_ = true;
    }
    return false;
}

bool Debugger::on_exception(ArmCore& core, ArmException exception, const ArmFault&) {
    if (exception != ArmException::PREFETCH_ABORT || !connection_.connected() ||
        !is_breakpoint_instruction(core))
        return false;
    const std::uint32_t pc = core.pc();
    stop(stopped_by(SIGNAL_TRAP));
    return core.pc() != pc;
}

bool Debugger::on_failure(ArmCore& core, ArmException exception) {
    if (!connection_.connected()) return false;
    const std::uint32_t pc = core.pc();
    stop(stopped_by(signal_of(exception)));
    return core.pc() != pc;
}

void Debugger::on_end(ArmCore&, unsigned signal) {
    if (connection_.connected()) stop(stopped_by(signal_of_linux(signal)));
}

// The core may be within an instruction here, so it must not be changed.
void Debugger::poll() {
    if (!connection_.connected()) {
        interrupt_ = connection_.accept(0) || !points_.empty();
    } else if (const auto event = connection_.receive(0)) {
        unread_ = event == GdbEvent::PACKET;
        interrupt_ = true;
    }
    if (interrupt_) cpu_.wake();
}

void Debugger::ended(unsigned exit_code) {
    if (resumed_ == Resumed::BY_CLIENT) connection_.send(fmt::format("W{:02x}", exit_code & 0xff));
    connection_.drop();
}

// ---- While it stands ----------------------------------------------------------------------------

// `reply`: of stopped_by().
void Debugger::stop(const std::string& reply) {
    reply_ = reply;
    interrupt_ = stepped_ = hit_ = false;
    stepping_ = 0;
    choose_thread(stopped_);
    if (resumed_ == Resumed::BY_CLIENT) connection_.send(reply_);
    resumed_ = Resumed::BY_ITSELF;
    serve();
    if (ArmKernel* const kernel = cpu_.kernel()) kernel->show_memory_of(0);
    resumed_at_ = quantum_begin_ = core_.instructions();
    resumed_thread_ = quantum_thread_ = running();
}

void Debugger::serve() {
    while (connection_.connected() && !given_up_()) {
        if (!unread_) {
            const auto event = connection_.receive(WAIT_MS);
            if (event != GdbEvent::PACKET) continue;
        }
        unread_ = false;
        const std::string packet = connection_.text();
        const GdbAnswer answer = gdb_answer(*this, packet);
        const bool resumes = answer.next == GdbNext::CONTINUE || answer.next == GdbNext::STEP;
        if (!resumes && packet != "k") connection_.send(answer.text);
        if (packet == "QStartNoAckMode") connection_.no_acks();
        if (packet.rfind("qSupported", 0) == 0)
            names_breaks_ = packet.find("swbreak+") != packet.npos;
        if (obey(answer)) return;
    }
    forget();
}

// True when the program is to go on.
bool Debugger::obey(const GdbAnswer& answer) {
    switch (answer.next) {
        case GdbNext::STAY: return false;
        case GdbNext::STEP: stepping_ = answer.thread ? answer.thread : stopped_; [[fallthrough]];
        case GdbNext::CONTINUE: resumed_ = Resumed::BY_CLIENT; return true;
        case GdbNext::KILL: killed_ = true; [[fallthrough]];
        case GdbNext::DETACH: break;
    }
    connection_.drop();
    forget();
    if (killed_) sc_core::sc_pause();
    return true;
}

void Debugger::forget() {
    points_.clear();
    points_changed();
    stepping_ = 0;
    hit_ = unread_ = false;
    resumed_ = Resumed::BY_ITSELF;
}

// ---- Threads ------------------------------------------------------------------------------------

// 0: all wait.
std::uint32_t Debugger::running() const {
    const ArmKernel* const kernel = cpu_.kernel();
    return kernel ? kernel->running_thread() : 1;
}

// The one that runs, or the first one.
std::uint32_t Debugger::shown() const {
    if (const std::uint32_t thread = running()) return thread;
    const auto all = cpu_.kernel()->thread_list();
    return all.empty() ? 1 : all.front().number;
}

std::string Debugger::stopped_by(unsigned signal, const std::string& why) {
    stopped_ = shown();
    return fmt::format("T{:02x}{}thread:{:x};", signal, why, stopped_);
}

std::vector<GdbThread> Debugger::threads() {
    std::vector<GdbThread> list;
    if (const ArmKernel* const kernel = cpu_.kernel())
        for (const ArmThread& thread : kernel->thread_list())
            list.push_back({thread.number, thread.name, thread.state});
    if (list.empty()) list.push_back({1, "", ""});
    return list;
}

void Debugger::choose_thread(std::uint32_t thread) {
    chosen_ = thread ? thread : stopped_;
    if (ArmKernel* const kernel = cpu_.kernel())
        kernel->show_memory_of(chosen_ == running() ? 0 : chosen_);
}

// The chosen thread's registers, unless the core has them.
ArmRegisters* Debugger::saved() {
    ArmKernel* const kernel = cpu_.kernel();
    return kernel ? kernel->saved_registers(chosen_) : nullptr;
}

// ---- What the debugger sees and changes ---------------------------------------------------------

std::uint64_t Debugger::reg(unsigned number) {
    using namespace gdb_register;
    if (const ArmRegisters* const registers = saved()) {
        if (number == CPSR) return registers->cpsr;
        if (number == FPSCR) return registers->fpscr;
        return number < CPSR ? registers->r[number] : registers->vfp[number - D0];
    }
    if (number == CPSR) return core_.cpsr();
    if (number == FPSCR) return core_.fpscr();
    return number < CPSR ? core_.reg(number) : core_.vfp(number - D0);
}

void Debugger::set_reg(unsigned number, std::uint64_t value) {
    using namespace gdb_register;
    const auto word = static_cast<std::uint32_t>(value);
    if (ArmRegisters* const registers = saved()) {
        if (number == CPSR)
            registers->cpsr = word;
        else if (number == FPSCR)
            registers->fpscr = word;
        else if (number < CPSR)
            registers->r[number] = word;
        else
            registers->vfp[number - D0] = value;
        return;
    }
    if (number == CPSR)
        core_.set_cpsr(word);
    else if (number == FPSCR)
        core_.set_fpscr(word);
    else if (number < CPSR)
        core_.set_reg(number, word);
    else
        core_.set_vfp(number - D0, value);
}

std::size_t Debugger::read(std::uint32_t address, void* data, std::size_t bytes) {
    bytes = std::min<std::uint64_t>(bytes, 0x100000000 - address);
    auto* const to = static_cast<std::uint8_t*>(data);
    for (std::size_t done = 0, now; done < bytes; done += now) {
        const std::uint32_t from = address + static_cast<std::uint32_t>(done);
        now = piece(from, bytes - done);
        if (core_.read_ram(from, to + done, now)) continue;
        now = access_bytes(from, bytes - done);
        if (!cpu_.read_memory(from, to + done, static_cast<unsigned>(now))) return done;
    }
    return bytes;
}

std::size_t Debugger::write(std::uint32_t address, const void* data, std::size_t bytes) {
    bytes = std::min<std::uint64_t>(bytes, 0x100000000 - address);
    const auto* const from = static_cast<const std::uint8_t*>(data);
    for (std::size_t done = 0, now; done < bytes; done += now) {
        const std::uint32_t to = address + static_cast<std::uint32_t>(done);
        now = piece(to, bytes - done);
        if (core_.write_ram(to, from + done, now)) continue;
        now = access_bytes(to, bytes - done);
        if (!cpu_.write_memory(to, from + done, static_cast<unsigned>(now))) return done;
    }
    return bytes;
}

void Debugger::insert(const GdbPoint& point) {
    if (std::find(points_.begin(), points_.end(), point) == points_.end()) points_.push_back(point);
    points_changed();
}

void Debugger::remove(const GdbPoint& point) {
    points_.erase(std::remove(points_.begin(), points_.end(), point), points_.end());
    points_changed();
}

// The core is only observed while there are points.
void Debugger::points_changed() {
    std::vector<std::uint32_t> breaks;
    for (const GdbPoint& point : points_)
        if (point.kind == GdbPoint::BREAK) breaks.push_back(point.address);
    core_.attach(breaks.empty() ? nullptr : static_cast<ArmProbe*>(this), breaks);
    core_.watch(breaks.size() < points_.size() ? this : nullptr);
}

std::uint32_t Debugger::displacement() {
    return cpu_.program().elf.movable ? POSITION_INDEPENDENT_BASE : 0;
}

std::string Debugger::monitor(std::string_view command) {
    if (command == "time")
        return fmt::format("{:.6f} ms, {} instructions\n", seconds(cpu_.now()) * 1e3,
                           core_.instructions());
    if (command == "modules") return modules();
    return "monitor time: the simulated time, and instructions so far\n"
           "monitor modules: GDB's commands for the names of the kernel modules\n";
}

std::string Debugger::modules() const {
    std::string text;
    if (const ArmKernel* const kernel = cpu_.kernel())
        for (const ArmModule& module : kernel->module_list())
            text +=
                module.file.empty()
                    ? fmt::format("# {}: the program has it in memory, from no file\n", module.name)
                    : fmt::format("add-symbol-file {}\n", quoted(module.file.string()));
    return text.empty() ? "# no kernel module is loaded\n" : text;
}

}  // namespace sim
