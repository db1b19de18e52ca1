#include "sim/debug/debugger.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/text/seconds.h"

namespace sim {

namespace {

constexpr int WAIT_MS = 50;  // between two calls of given_up()
constexpr std::uint32_t PAGE = 4096;

// Bytes of the next access to a register: as many as the alignment and the rest allow.
unsigned access_bytes(std::uint32_t address, std::size_t left) {
    return address % 4 == 0 && left >= 4 ? 4 : address % 2 == 0 && left >= 2 ? 2 : 1;
}

// Bytes of RAM that may be read in one piece.
std::size_t piece(std::uint32_t address, std::size_t left) {
    return std::min<std::size_t>(left, PAGE - address % PAGE);
}

}  // namespace

Debugger::Debugger(ProgramCpu& cpu, GdbConnection& connection, std::function<bool()> given_up)
    : cpu_{cpu},
      connection_{connection},
      given_up_{std::move(given_up)},
      reply_{fmt::format("T{:02x}thread:1;", gdb_signal::TRAP)} {}

// ---- When to stop -------------------------------------------------------------------------------

void Debugger::begin() {
    while (!connection_.connected() && !given_up_()) connection_.accept(WAIT_MS);
    stop(stopped_by(gdb_signal::TRAP));
}

bool Debugger::quantum_begins() {
    stepped_ |= stepping_ && stepping_ == quantum_thread_ && instructions() != quantum_begin_;
    if (hit_)
        stop(reply_);
    else if (stepping_ == running() && stepped_)
        stop(stopped_by(gdb_signal::TRAP));
    else
        idles();
    quantum_begin_ = instructions();
    quantum_thread_ = running();
    return stepping_ == quantum_thread_;
}

void Debugger::idles() {
    if (interrupt_) stop(stopped_by(unread_ ? gdb_signal::TRAP : gdb_signal::INT));
}

// The instruction at which the debugger resumes is not stopped at again.
bool Debugger::reached() {
    if (instructions() == resumed_at_ && running() == resumed_thread_) return false;
    reply_ = stopped_by(gdb_signal::TRAP, names_breaks_ ? "swbreak:;" : "");
    return hit_ = true;
}

bool Debugger::touches_point(std::uint32_t address, unsigned bytes, bool write) {
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
        reply_ = stopped_by(gdb_signal::TRAP, fmt::format("{}:{:x};", name, point.address));
        return hit_ = true;
    }
    return false;
}

bool Debugger::stops_by(unsigned signal) {
    if (!connection_.connected()) return false;
    const std::uint32_t before = pc();
    stop(stopped_by(signal));
    return pc() != before;
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
    show_memory_of(0);
    resumed_at_ = quantum_begin_ = instructions();
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

// The one that runs, or the first one.
std::uint32_t Debugger::shown() {
    const std::uint32_t thread = running();
    return thread ? thread : threads().front().number;
}

std::string Debugger::stopped_by(unsigned signal, const std::string& why) {
    stopped_ = shown();
    return fmt::format("T{:02x}{}thread:{:x};", signal, why, stopped_);
}

void Debugger::choose_thread(std::uint32_t thread) {
    chosen_ = thread ? thread : stopped_;
    show_memory_of(chosen_ == running() ? 0 : chosen_);
}

// ---- What the debugger sees and changes ---------------------------------------------------------

std::size_t Debugger::read(std::uint32_t address, void* data, std::size_t bytes) {
    bytes = std::min<std::uint64_t>(bytes, 0x100000000 - address);
    auto* const to = static_cast<std::uint8_t*>(data);
    for (std::size_t done = 0, now; done < bytes; done += now) {
        const std::uint32_t from = address + static_cast<std::uint32_t>(done);
        now = piece(from, bytes - done);
        if (read_ram(from, to + done, now)) continue;
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
        if (write_ram(to, from + done, now)) continue;
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

void Debugger::points_changed() {
    std::vector<std::uint32_t> breaks;
    for (const GdbPoint& point : points_)
        if (point.kind == GdbPoint::BREAK) breaks.push_back(point.address);
    observe(breaks, breaks.size() < points_.size());
}

std::string Debugger::monitor(std::string_view command) {
    if (command == "time")
        return fmt::format("{:.6f} ms, {} instructions\n", seconds(cpu_.now()) * 1e3,
                           instructions());
    const std::string own = own_monitor(command);
    return own.empty()
               ? "monitor time: the simulated time, and instructions so far\n" + own_monitor_help()
               : own;
}

}  // namespace sim
