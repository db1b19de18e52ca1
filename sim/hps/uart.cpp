#include "sim/hps/uart.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint32_t THR = 0x00, IER = 0x04, FCR = 0x08, LCR = 0x0C, MCR = 0x10, LSR = 0x14,
                        SCR = 0x1C, USR = 0x7C, CPR = 0xF4, UCV = 0xF8, CTR = 0xFC;
constexpr std::uint32_t DLAB = 0x80, ERBFI = 1, ETBEI = 2, FIFO_ON = 1, CLEAR_RECEIVED = 2;
constexpr std::uint32_t TRANSMITTER_EMPTY = 0x60, FIFO_EMPTY_NOT_FULL = 0x06, RECEIVED = 1,
                        OVERRUN = 2, FIFO_HOLDS_RECEIVED = 8;
constexpr std::uint32_t NONE_PENDING = 1, THR_EMPTY = 2, CAME = 4, FIFOS_ON = 0xC0;
constexpr std::size_t FIFO_SIZE = 128;
const sc_core::sc_time character_time{1, sc_core::SC_MS};
constexpr std::uint32_t PARAMETERS = 0x000373F2, COMPONENT_VERSION = 0x3331312A,
                        COMPONENT_TYPE = 0x44570110;

}  // namespace

void Uart::empty(bool is_new) {
    thr_empty_ = is_new;
    tell();
}

void Uart::tell() {
    line_((thr_empty_ && (ier_ & ETBEI)) || (!received_.empty() && (ier_ & ERBFI)));
}

void Uart::receive(const std::string& text) {
    if (typed_.empty() && !text.empty()) arrival_.notify(character_time);
    typed_.insert(typed_.end(), text.begin(), text.end());
}

void Uart::arrive() {
    if (received_.size() < (fcr_ & FIFO_ON ? FIFO_SIZE : 1))
        received_.push_back(typed_.front());
    else
        overrun_ = true;
    typed_.pop_front();
    if (!typed_.empty()) arrival_.notify(character_time);
    tell();
}

std::uint32_t Uart::read(std::uint32_t offset, const sc_core::sc_time&) {
    switch (offset) {
        case THR: {
            if (lcr_ & DLAB) return divisor_ & 0xFF;
            if (received_.empty()) return 0;
            const auto character = static_cast<std::uint8_t>(received_.front());
            received_.pop_front();
            tell();
            return character;
        }
        case IER: return lcr_ & DLAB ? divisor_ >> 8 : ier_;
        case FCR: {
            const bool came = !received_.empty() && (ier_ & ERBFI);
            const bool tells = !came && thr_empty_ && (ier_ & ETBEI);
            if (tells) empty(false);
            return (fcr_ & 1 ? FIFOS_ON : 0) | (came ? CAME : tells ? THR_EMPTY : NONE_PENDING);
        }
        case LCR: return lcr_;
        case MCR: return mcr_;
        case LSR:
            return TRANSMITTER_EMPTY | (received_.empty() ? 0 : RECEIVED) |
                   (std::exchange(overrun_, false) ? OVERRUN : 0);
        case SCR: return scr_;
        case USR: return FIFO_EMPTY_NOT_FULL | (received_.empty() ? 0 : FIFO_HOLDS_RECEIVED);
        case CPR: return PARAMETERS;
        case UCV: return COMPONENT_VERSION;
        case CTR: return COMPONENT_TYPE;
        default: return 0;
    }
}

void Uart::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time&) {
    value &= 0xFF;
    switch (offset) {
        case THR:
            if (lcr_ & DLAB) {
                divisor_ = (divisor_ & 0xFF00) | value;
            } else {
                sent_(static_cast<char>(value));
                empty(true);
            }
            break;
        case IER:
            if (lcr_ & DLAB) {
                divisor_ = (divisor_ & 0xFF) | value << 8;
            } else {
                const bool asks = (value & ETBEI) && !(ier_ & ETBEI);
                ier_ = value;
                empty(asks || thr_empty_);
            }
            break;
        case FCR:
            // The FIFO is emptied, too, when it is switched on or off.
            if ((value & CLEAR_RECEIVED) || ((value ^ fcr_) & FIFO_ON)) received_.clear();
            fcr_ = value;
            tell();
            break;
        case LCR: lcr_ = value; break;
        case MCR: mcr_ = value; break;
        case SCR: scr_ = value; break;
        default: break;
    }
}

}  // namespace sim
