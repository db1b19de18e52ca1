#include "sim/hps/uart.h"

#include <algorithm>
#include <utility>

namespace sim {

namespace {

constexpr std::uint32_t THR = 0x00, IER = 0x04, FCR = 0x08, LCR = 0x0C, MCR = 0x10, LSR = 0x14,
                        MSR = 0x18, SCR = 0x1C, USR = 0x7C, TFL = 0x80, RFL = 0x84, CPR = 0xF4,
                        UCV = 0xF8, CTR = 0xFC;
constexpr std::uint32_t DLAB = 0x80, ERBFI = 1, ETBEI = 2, PTIME = 0x80, FIFO_ON = 1,
                        CLEAR_RECEIVED = 2, CLEAR_WAITING = 4, ELSI = 4, EDSSI = 8, BREAKS = 0x40;
constexpr std::uint32_t RECEIVED = 1, OVERRUN = 2, THRE = 0x20, TEMT = 0x40, IN_FIFO = 0x80;  // LSR
constexpr std::uint32_t BUSY = 1, TFNF = 2, TFE = 4, RFNE = 8, RFF = 0x10;                    // USR
constexpr std::uint32_t MODEM = 0, NONE_PENDING = 1, THR_EMPTY = 2, RECEIVED_DATA = 4,
                        LINE_STATUS = 6, FIFOS_ON = 0xC0;  // IIR
constexpr std::size_t FIFO_SIZE = 128;
const sc_core::sc_time typing_time{1, sc_core::SC_MS};
constexpr std::uint32_t PARAMETERS = 0x000373F2, COMPONENT_VERSION = 0x3331312A,
                        COMPONENT_TYPE = 0x44570110;

}  // namespace

bool Uart::fifos() const { return fcr_ & FIFO_ON; }

bool Uart::transmitter_has_room() const { return waiting_.size() < (fifos() ? FIFO_SIZE : 1); }

// As many may wait when the transmitter asks for more.
std::size_t Uart::level() const {
    constexpr std::size_t LEVELS[] = {0, 2, FIFO_SIZE / 4, FIFO_SIZE / 2};
    return fifos() && (ier_ & PTIME) ? LEVELS[fcr_ >> 4 & 3] : 0;
}

// ---- Sending ----

UartFormat Uart::format() const {
    constexpr std::uint64_t CLOCK_PS = 10'000;
    return {lcr_, 16 * divisor_ * CLOCK_PS};
}

void Uart::send(char character, const sc_core::sc_time& now) {
    if (!transmitter_has_room()) {
        overflow_();
        if (fifos()) return;
        waiting_.pop_back();
    }
    waiting_.push_back(character);
    thr_empty_ = false;
    update_interrupt();
    shift(now);
}

void Uart::shift(const sc_core::sc_time& now) {
    if (shifts_ || waiting_.empty() || divisor_ == 0) return;
    shifted_ = waiting_.front();
    waiting_.pop_front();
    shifts_ = true;
    const sc_core::sc_time in = now - sc_core::sc_time_stamp();
    sends_ = format();
    sent_one_.notify(in + sc_core::sc_time::from_value(sends_.frame_ps()));
    if (wires_) {
        frame_ = sends_.frame(static_cast<std::uint8_t>(shifted_));
        bit_ = 0;
        bit_due_.notify(in);
    }
    if (waiting_.size() == level()) thr_empty_ = true;
    update_interrupt();
}

void Uart::sent() {
    shifts_ = false;
    if (!wires_) sent_(shifted_);
    shift(sc_core::sc_time_stamp());
}

// ---- Wires to the FPGA ----

void Uart::connect(FabricWires wires) {
    wires_ = std::move(wires);
    put(sc_core::SC_ZERO_TIME);
}

// The levels up to the next bit that is another.
void Uart::next_bit() {
    const auto level = [this](unsigned bit) { return (frame_ >> bit & 1) != 0; };
    txd_ = level(bit_);
    put(sc_core::sc_time_stamp());
    const unsigned from = bit_;
    while (bit_ < sends_.bits() && level(bit_) == txd_) ++bit_;
    if (bit_ < sends_.bits())
        bit_due_.notify(sc_core::sc_time::from_value((bit_ - from) * sends_.bit_ps));
}

void Uart::put(const sc_core::sc_time& now) {
    const std::uint64_t outputs = ~mcr_ & 0xF;  // dtr, rts, out1, out2
    if (wires_) wires_->drive((txd_ && !(lcr_ & BREAKS) ? 1u : 0u) | outputs << 1, now);
}

void Uart::moved(std::uint64_t levels, std::uint64_t time_ps) {
    receive_until(time_ps);
    receiver_.move(levels & 1, time_ps, format());
    if (receiver_.due_ps(format())) look_.notify(sc_core::SC_ZERO_TIME);
    const std::uint64_t modem = levels >> 1, changes = modem ^ modem_;
    if (changes == 0) return;
    modem_ = modem;
    const auto has_moved = [&](unsigned signal) {
        return static_cast<std::uint32_t>(changes >> signal & 1);
    };
    const bool ring_ends = has_moved(3) && (modem >> 3 & 1);
    modem_deltas_ |= has_moved(0) | has_moved(1) << 1 | (ring_ends ? 4u : 0u) | has_moved(2) << 3;
    update_interrupt();
}

// The character that comes is taken when it is complete, if the design is still behind then.
void Uart::look() {
    const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
    const auto due_ps = receiver_.due_ps(format());
    if (!due_ps) return;
    if (*due_ps > now_ps) return look_.notify(sc_core::sc_time::from_value(*due_ps - now_ps));
    wires_->catch_up(sc_core::sc_time_stamp());
    receive_until(now_ps);
}

void Uart::receive_until(std::uint64_t time_ps) {
    while (const auto came = receiver_.pass_to(time_ps, format())) keep(came->value, came->errors);
}

void Uart::keep(std::uint8_t character, std::uint32_t errors) {
    if (received_.size() < (fifos() ? FIFO_SIZE : 1))
        received_.push_back({character, errors});
    else
        overrun_ = true;
    update_interrupt();
}

// Reading takes the deltas.
std::uint32_t Uart::modem_status() {
    if (!wires_) return 0;
    const auto is_low = [this](unsigned signal) {
        return static_cast<std::uint32_t>(~modem_ >> signal & 1);
    };
    const std::uint32_t status = is_low(0) << 4 | is_low(1) << 5 | is_low(3) << 6 | is_low(2) << 7;
    return status | std::exchange(modem_deltas_, 0);
}

// ---- Registers ----

void Uart::update_interrupt() {
    const bool errs = overrun_ || (!received_.empty() && received_.front().errors);
    line_((thr_empty_ && (ier_ & ETBEI)) || (!received_.empty() && (ier_ & ERBFI)) ||
          (errs && (ier_ & ELSI)) || (modem_deltas_ && (ier_ & EDSSI)));
}

// Reading takes that of the empty transmitter.
std::uint32_t Uart::identify_interrupt() {
    if ((ier_ & ELSI) && (overrun_ || (!received_.empty() && received_.front().errors)))
        return LINE_STATUS;
    if (!received_.empty() && (ier_ & ERBFI)) return RECEIVED_DATA;
    if (thr_empty_ && (ier_ & ETBEI)) {
        thr_empty_ = false;
        return THR_EMPTY;
    }
    return modem_deltas_ && (ier_ & EDSSI) ? MODEM : NONE_PENDING;
}

// Reading takes what is wrong with the next character, and an overrun.
std::uint32_t Uart::line_status() {
    const bool has_no_room = fifos() && (ier_ & PTIME) ? !transmitter_has_room() : waiting_.empty();
    std::uint32_t status = (has_no_room ? THRE : 0) | (waiting_.empty() && !shifts_ ? TEMT : 0) |
                           (std::exchange(overrun_, false) ? OVERRUN : 0);
    if (received_.empty()) return status;
    const auto errs = [](const Received& one) { return one.errors != 0; };
    if (fifos() && std::any_of(received_.begin(), received_.end(), errs)) status |= IN_FIFO;
    return status | RECEIVED | std::exchange(received_.front().errors, 0);
}

void Uart::receive(const std::string& text) {
    if (wires_) return;
    if (typed_.empty() && !text.empty()) arrival_.notify(typing_time);
    typed_.insert(typed_.end(), text.begin(), text.end());
}

void Uart::arrive() {
    keep(static_cast<std::uint8_t>(typed_.front()), 0);
    typed_.pop_front();
    if (!typed_.empty()) arrival_.notify(typing_time);
}

std::uint32_t Uart::read(std::uint32_t offset, const sc_core::sc_time& now) {
    if (wires_) {
        wires_->catch_up(now);
        receive_until(now.value());
    }
    switch (offset) {
        case THR: {
            if (lcr_ & DLAB) return divisor_ & 0xFF;
            if (received_.empty()) return 0;
            const std::uint8_t character = received_.front().character;
            received_.pop_front();
            update_interrupt();
            return character;
        }
        case IER: return lcr_ & DLAB ? divisor_ >> 8 : ier_;
        case FCR: {
            const std::uint32_t pending = identify_interrupt();
            update_interrupt();
            return (fifos() ? FIFOS_ON : 0) | pending;
        }
        case LCR: return lcr_;
        case MCR: return mcr_;
        case LSR: {
            const std::uint32_t status = line_status();
            update_interrupt();
            return status;
        }
        case MSR: {
            const std::uint32_t status = modem_status();
            update_interrupt();
            return status;
        }
        case SCR: return scr_;
        case USR:
            return (shifts_ ? BUSY : 0) | (transmitter_has_room() ? TFNF : 0) |
                   (waiting_.empty() ? TFE : 0) | (received_.empty() ? 0 : RFNE) |
                   (received_.size() == FIFO_SIZE ? RFF : 0);
        case TFL: return static_cast<std::uint32_t>(waiting_.size());
        case RFL: return static_cast<std::uint32_t>(received_.size());
        case CPR: return PARAMETERS;
        case UCV: return COMPONENT_VERSION;
        case CTR: return COMPONENT_TYPE;
        default: return 0;
    }
}

void Uart::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    value &= 0xFF;
    if (wires_) {  // with the format up to now
        wires_->catch_up(now);
        receive_until(now.value());
    }
    switch (offset) {
        case THR:
            if (lcr_ & DLAB) {
                divisor_ = (divisor_ & 0xFF00) | value;
                shift(now);
            } else {
                send(static_cast<char>(value), now);
            }
            break;
        case IER:
            if (lcr_ & DLAB) {
                divisor_ = (divisor_ & 0xFF) | value << 8;
                shift(now);
            } else {
                const bool asks = (value & ETBEI) && !(ier_ & ETBEI);
                ier_ = value;
                thr_empty_ |= asks && waiting_.size() <= level();
                update_interrupt();
            }
            break;
        case FCR:
            // The FIFOs are emptied, too, when they are switched on or off.
            if ((value & CLEAR_RECEIVED) || ((value ^ fcr_) & FIFO_ON)) received_.clear();
            if ((value & CLEAR_WAITING) || ((value ^ fcr_) & FIFO_ON)) waiting_.clear();
            fcr_ = value;
            update_interrupt();
            break;
        case LCR: lcr_ = value; return put(now);
        case MCR: mcr_ = value; return put(now);
        case SCR: scr_ = value; break;
        default: break;
    }
}

}  // namespace sim
