#include "sim/hps/uart.h"

namespace sim {

namespace {

constexpr std::uint32_t THR = 0x00, IER = 0x04, FCR = 0x08, LCR = 0x0C, MCR = 0x10, LSR = 0x14,
                        SCR = 0x1C, USR = 0x7C, CPR = 0xF4, UCV = 0xF8, CTR = 0xFC;
constexpr std::uint32_t DLAB = 0x80, ETBEI = 2;
constexpr std::uint32_t TRANSMITTER_EMPTY = 0x60, FIFO_EMPTY_NOT_FULL = 0x06;
constexpr std::uint32_t NONE_PENDING = 1, THR_EMPTY = 2, FIFOS_ON = 0xC0;
constexpr std::uint32_t PARAMETERS = 0x000373F2, COMPONENT_VERSION = 0x3331312A,
                        COMPONENT_TYPE = 0x44570110;

}  // namespace

void Uart::empty(bool is_new) {
    thr_empty_ = is_new;
    line_(thr_empty_ && (ier_ & ETBEI));
}

std::uint32_t Uart::read(std::uint32_t offset, const sc_core::sc_time&) {
    switch (offset) {
        case THR: return lcr_ & DLAB ? divisor_ & 0xFF : 0;
        case IER: return lcr_ & DLAB ? divisor_ >> 8 : ier_;
        case FCR: {
            const bool tells = thr_empty_ && (ier_ & ETBEI);
            if (tells) empty(false);
            return (fcr_ & 1 ? FIFOS_ON : 0) | (tells ? THR_EMPTY : NONE_PENDING);
        }
        case LCR: return lcr_;
        case MCR: return mcr_;
        case LSR: return TRANSMITTER_EMPTY;
        case SCR: return scr_;
        case USR: return FIFO_EMPTY_NOT_FULL;
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
        case FCR: fcr_ = value; break;
        case LCR: lcr_ = value; break;
        case MCR: mcr_ = value; break;
        case SCR: scr_ = value; break;
        default: break;
    }
}

}  // namespace sim
