#include "sim/hps/uart.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint32_t THR = 0x00, IER = 0x04, FCR = 0x08, LCR = 0x0C, MCR = 0x10, LSR = 0x14,
                        SCR = 0x1C, USR = 0x7C, TFL = 0x80, RFL = 0x84, CPR = 0xF4, UCV = 0xF8,
                        CTR = 0xFC;
constexpr std::uint32_t DLAB = 0x80, ERBFI = 1, ETBEI = 2, PTIME = 0x80, FIFO_ON = 1,
                        CLEAR_RECEIVED = 2, CLEAR_WAITING = 4;
constexpr std::uint32_t RECEIVED = 1, OVERRUN = 2, THRE = 0x20, TEMT = 0x40;  // LSR
constexpr std::uint32_t BUSY = 1, TFNF = 2, TFE = 4, RFNE = 8, RFF = 0x10;    // USR
constexpr std::uint32_t NONE_PENDING = 1, THR_EMPTY = 2, RECEIVED_DATA = 4, FIFOS_ON = 0xC0;
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

sc_core::sc_time Uart::character_time() const {
    constexpr std::uint64_t CLOCK_PS = 10'000;
    const std::uint64_t data = 5 + (lcr_ & 3), parity = lcr_ >> 3 & 1, stops = lcr_ & 4 ? 2 : 1;
    return sc_core::sc_time::from_value((1 + data + parity + stops) * 16 * divisor_ * CLOCK_PS);
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
    sent_one_.notify(now - sc_core::sc_time_stamp() + character_time());
    if (waiting_.size() == level()) thr_empty_ = true;
    update_interrupt();
}

void Uart::sent() {
    shifts_ = false;
    sent_(shifted_);
    shift(sc_core::sc_time_stamp());
}

// ---- Registers ----

void Uart::update_interrupt() {
    line_((thr_empty_ && (ier_ & ETBEI)) || (!received_.empty() && (ier_ & ERBFI)));
}

void Uart::receive(const std::string& text) {
    if (typed_.empty() && !text.empty()) arrival_.notify(typing_time);
    typed_.insert(typed_.end(), text.begin(), text.end());
}

void Uart::arrive() {
    if (received_.size() < (fifos() ? FIFO_SIZE : 1))
        received_.push_back(typed_.front());
    else
        overrun_ = true;
    typed_.pop_front();
    if (!typed_.empty()) arrival_.notify(typing_time);
    update_interrupt();
}

std::uint32_t Uart::read(std::uint32_t offset, const sc_core::sc_time&) {
    switch (offset) {
        case THR: {
            if (lcr_ & DLAB) return divisor_ & 0xFF;
            if (received_.empty()) return 0;
            const auto character = static_cast<std::uint8_t>(received_.front());
            received_.pop_front();
            update_interrupt();
            return character;
        }
        case IER: return lcr_ & DLAB ? divisor_ >> 8 : ier_;
        case FCR: {
            const bool came = !received_.empty() && (ier_ & ERBFI);
            const bool is_empty = !came && thr_empty_ && (ier_ & ETBEI);
            if (is_empty) {
                thr_empty_ = false;
                update_interrupt();
            }
            return (fifos() ? FIFOS_ON : 0) | (came       ? RECEIVED_DATA
                                               : is_empty ? THR_EMPTY
                                                          : NONE_PENDING);
        }
        case LCR: return lcr_;
        case MCR: return mcr_;
        case LSR:
            return ((fifos() && (ier_ & PTIME) ? !transmitter_has_room() : waiting_.empty()) ? THRE
                                                                                             : 0) |
                   (waiting_.empty() && !shifts_ ? TEMT : 0) | (received_.empty() ? 0 : RECEIVED) |
                   (std::exchange(overrun_, false) ? OVERRUN : 0);
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
        case LCR: lcr_ = value; break;
        case MCR: mcr_ = value; break;
        case SCR: scr_ = value; break;
        default: break;
    }
}

}  // namespace sim
