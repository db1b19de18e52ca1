#include "sim/hps/i2c_controller.h"

#include <algorithm>
#include <utility>

namespace sim {

namespace {

constexpr std::uint64_t I2C_CLOCK_PS = 10'000;  // L4_SP, 100 MHz
constexpr std::size_t I2C_FIFO = 64;
// con
constexpr std::uint32_t CON_AFTER_RESET = 0x7D, CON_BITS = 0x7F, STANDARD = 1;
// data_cmd
constexpr std::uint32_t READS = 1 << 8, STOP = 1 << 9, START_AGAIN = 1 << 10;
// Interrupts
constexpr std::uint32_t RX_UNDER = 1 << 0, RX_OVER = 1 << 1, RX_FULL = 1 << 2, TX_OVER = 1 << 3,
                        TX_EMPTY = 1 << 4, RD_REQ = 1 << 5, TX_ABRT = 1 << 6, RX_DONE = 1 << 7,
                        ACTIVITY = 1 << 8, STOP_DET = 1 << 9, START_DET = 1 << 10,
                        GEN_CALL = 1 << 11, MASK_AFTER_RESET = 0x8FF;
// tx_abrt_source
constexpr std::uint32_t NO_ADDRESS = 1 << 0, NO_DATA = 1 << 3, LOST = 1 << 12, BY_USER = 1 << 16;
constexpr std::uint32_t I2C_PARAMETERS = 0x003F3FEA, I2C_VERSION = 0x3132302A,
                        I2C_TYPE = 0x44570140;

}  // namespace

enum I2cController::Offset : std::uint32_t {
    CON = 0x00,
    TAR = 0x04,
    SAR = 0x08,
    DATA_CMD = 0x10,
    SS_HCNT = 0x14,
    SS_LCNT = 0x18,
    FS_HCNT = 0x1C,
    FS_LCNT = 0x20,
    INTR_STAT = 0x2C,
    INTR_MASK = 0x30,
    RAW_INTR_STAT = 0x34,
    RX_TL = 0x38,
    TX_TL = 0x3C,
    CLR_INTR = 0x40,
    CLR_RX_UNDER = 0x44,
    CLR_RX_OVER = 0x48,
    CLR_TX_OVER = 0x4C,
    CLR_RD_REQ = 0x50,
    CLR_TX_ABRT = 0x54,
    CLR_RX_DONE = 0x58,
    CLR_ACTIVITY = 0x5C,
    CLR_STOP_DET = 0x60,
    CLR_START_DET = 0x64,
    CLR_GEN_CALL = 0x68,
    EN = 0x6C,
    STAT = 0x70,
    TXFLR = 0x74,
    RXFLR = 0x78,
    SDA_HOLD = 0x7C,
    TX_ABRT_SOURCE = 0x80,
    DMA_CR = 0x88,
    DMA_TDLR = 0x8C,
    DMA_RDLR = 0x90,
    SDA_SETUP = 0x94,
    ACK_GENERAL_CALL = 0x98,
    EN_STAT = 0x9C,
    FS_SPKLEN = 0xA0,
    COMP_PARAM = 0xF4,
    COMP_VERSION = 0xF8,
    COMP_TYPE = 0xFC
};

I2cController::I2cController(const sc_core::sc_module_name& module_name,
                             std::function<void(bool)> line)
    : Registers{module_name}, line_{std::move(line)} {
    reset();
    SC_HAS_PROCESS(I2cController);
    SC_METHOD(serve);
    sensitive << step_;
    dont_initialize();
}

void I2cController::reset() {
    con_ = CON_AFTER_RESET;
    tar_ = 0x1055;
    sar_ = 0x55;
    ss_high_ = 0x190;
    ss_low_ = 0x1D6;
    fs_high_ = 0x3C;
    fs_low_ = 0x82;
    mask_ = MASK_AFTER_RESET;
    rx_threshold_ = tx_threshold_ = dma_ = dma_tx_ = dma_rx_ = 0;
    hold_ = 1;
    setup_ = 0x64;
    spike_ = 2;
    general_call_ = 1;
    raised_ = abort_source_ = 0;
    enabled_ = busy_ = stops_ = aborted_ = false;
    commands_.clear();
    received_.clear();
    if (fabric_)
        fabric_->release();
    else if (active_)
        stop();
    active_ = addressed_ = ends_ = false;
    raised_ = 0;
    step_.cancel();
    update();
}

// ---- The bus ----

I2cWires::Times I2cController::times() const {
    const bool standard = (con_ >> 1 & 3) == STANDARD;
    const std::uint64_t high = (standard ? ss_high_ : fs_high_) + spike_ + 7,
                        low = (standard ? ss_low_ : fs_low_) + 1;
    return {high * I2C_CLOCK_PS, low * I2C_CLOCK_PS,
            std::min<std::uint64_t>(hold_, low - 1) * I2C_CLOCK_PS};
}

sc_core::sc_time I2cController::bits(unsigned count) const {
    const I2cWires::Times clock = times();
    return sc_core::sc_time::from_value(count * (clock.high_ps + clock.low_ps));
}

void I2cController::serve() {
    if (std::exchange(busy_, false)) std::exchange(ends_, false) ? stopped() : finish_byte();
    if (std::exchange(stops_, false) && active_ && !ends_) stop();
    if (!commands_.empty() && enabled_ && !busy_) {
        current_ = commands_.front();
        const bool reads = current_ & READS;
        if (!addressed_ && (!active_ || reads != reads_ || (current_ & START_AGAIN))) {
            addresses_ = active_ = true;
            reads_ = reads;
            raised_ |= START_DET | ACTIVITY;
        } else {
            addressed_ = false;
            commands_.pop_front();
        }
        busy_ = true;
        if (fabric_)
            send_byte();
        else
            step_.notify(bits(9 + (addresses_ || (current_ & STOP))));
    }
    update();
}

void I2cController::connect(FabricWires wires) {
    fabric_ = std::make_unique<I2cWires>(sc_core::sc_gen_unique_name("i2c_wires"), std::move(wires),
                                         [this] { serve(); });
    devices_ = fabric_.get();
}

void I2cController::send_byte() {
    const auto address = static_cast<std::uint8_t>(tar_ << 1 | (reads_ ? 1u : 0u));
    // The next byte is read, too, or will be as soon as the program asks for it.
    const auto goes_on = [this] {
        if (current_ & STOP) return false;
        return commands_.empty() ||
               ((commands_.front() & READS) && !(commands_.front() & START_AGAIN));
    };
    sent_stop_ = !addresses_ && (current_ & STOP);
    fabric_->send({addresses_, reads_ && !addresses_,
                   addresses_ ? address : static_cast<std::uint8_t>(current_), sent_stop_, goes_on},
                  times());
}

// Nine bits have passed: the address, or a byte of data.
void I2cController::finish_byte() {
    const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
    if (fabric_ && fabric_->is_lost()) {
        addresses_ = active_ = addressed_ = false;
        return drop(LOST);
    }
    if (std::exchange(addresses_, false)) {
        addressed_ = devices_ && !(tar_ & 0x1000) &&
                     devices_->begin(static_cast<std::uint8_t>(tar_ & 0x7F), reads_,
                                     bits(1).value(), now_ps);
        if (!addressed_) abort(NO_ADDRESS);
        return;
    }
    if (reads_) {
        const std::uint8_t byte = devices_->read(now_ps);
        if (received_.size() < I2C_FIFO)
            received_.push_back(byte);
        else
            raised_ |= RX_OVER;
    } else if (!devices_->write(static_cast<std::uint8_t>(current_), now_ps)) {
        return abort(NO_DATA);
    }
    if (current_ & STOP) stop();
}

void I2cController::stop() {
    if (!fabric_ || sent_stop_) return stopped();
    busy_ = ends_ = true;
    fabric_->send_stop(times());
}

void I2cController::stopped() {
    if (devices_) devices_->end(sc_core::sc_time_stamp().value());
    active_ = addressed_ = false;
    raised_ |= STOP_DET;
}

// What waits is dropped, and what comes until the program has seen it.
void I2cController::abort(std::uint32_t source) {
    drop(source);
    stop();
}

void I2cController::drop(std::uint32_t source) {
    abort_source_ |= source;
    raised_ |= TX_ABRT;
    aborted_ = true;
    commands_.clear();
}

// ---- Registers ----

std::uint32_t I2cController::raw() const {
    return raised_ | (received_.size() > rx_threshold_ ? RX_FULL : 0) |
           (enabled_ && commands_.size() <= tx_threshold_ ? TX_EMPTY : 0);
}

void I2cController::update() {
    const bool up = raw() & mask_;
    if (std::exchange(up_, up) != up) line_(up);
}

std::uint32_t I2cController::clear(std::uint32_t interrupts) {
    const std::uint32_t was = raised_ & interrupts;
    raised_ &= ~interrupts;
    if (interrupts & TX_ABRT) {
        abort_source_ = 0;
        aborted_ = false;
    }
    return was != 0;
}

std::uint32_t I2cController::read(std::uint32_t offset, const sc_core::sc_time&) {
    std::uint32_t value = 0;
    switch (offset) {
        case CON: return con_;
        case TAR: return tar_;
        case SAR: return sar_;
        case DATA_CMD:
            if (received_.empty()) {
                raised_ |= RX_UNDER;
            } else {
                value = received_.front();
                received_.pop_front();
            }
            break;
        case SS_HCNT: return ss_high_;
        case SS_LCNT: return ss_low_;
        case FS_HCNT: return fs_high_;
        case FS_LCNT: return fs_low_;
        case INTR_STAT: return raw() & mask_;
        case INTR_MASK: return mask_;
        case RAW_INTR_STAT: return raw();
        case RX_TL: return rx_threshold_;
        case TX_TL: return tx_threshold_;
        case CLR_INTR: value = clear(0xFFF); break;
        case CLR_RX_UNDER: value = clear(RX_UNDER); break;
        case CLR_RX_OVER: value = clear(RX_OVER); break;
        case CLR_TX_OVER: value = clear(TX_OVER); break;
        case CLR_RD_REQ: value = clear(RD_REQ); break;
        case CLR_TX_ABRT: value = clear(TX_ABRT); break;
        case CLR_RX_DONE: value = clear(RX_DONE); break;
        case CLR_ACTIVITY: value = clear(active_ ? 0 : ACTIVITY); break;
        case CLR_STOP_DET: value = clear(STOP_DET); break;
        case CLR_START_DET: value = clear(START_DET); break;
        case CLR_GEN_CALL: value = clear(GEN_CALL); break;
        case EN: return enabled_;
        case STAT: {
            const bool room = commands_.size() < I2C_FIFO, none = commands_.empty();
            return (active_ ? 0x21u : 0u) | (room ? 2u : 0u) | (none ? 4u : 0u) |
                   (received_.empty() ? 0u : 8u) | (received_.size() == I2C_FIFO ? 0x10u : 0u);
        }
        case TXFLR: return static_cast<std::uint32_t>(commands_.size());
        case RXFLR: return static_cast<std::uint32_t>(received_.size());
        case SDA_HOLD: return hold_;
        case TX_ABRT_SOURCE: return abort_source_;
        case DMA_CR: return dma_;
        case DMA_TDLR: return dma_tx_;
        case DMA_RDLR: return dma_rx_;
        case SDA_SETUP: return setup_;
        case ACK_GENERAL_CALL: return general_call_;
        case EN_STAT: return enabled_ || stops_ || ends_;
        case FS_SPKLEN: return spike_;
        case COMP_PARAM: return I2C_PARAMETERS;
        case COMP_VERSION: return I2C_VERSION;
        case COMP_TYPE: return I2C_TYPE;
        default: return 0;
    }
    update();
    return value;
}

void I2cController::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    // Those that decide how the bus is spoken to hold still while it may be.
    const auto set = [this](std::uint32_t& to, std::uint32_t what) {
        if (!enabled_) to = what;
    };
    switch (offset) {
        case CON: set(con_, (value & CON_BITS & ~0x10u) | (con_ & 0x10)); break;
        case TAR: set(tar_, value & 0x1FFF); break;
        case SAR: set(sar_, value & 0x3FF); break;
        case DATA_CMD: command(value, now); break;
        case SS_HCNT: set(ss_high_, value & 0xFFFF); break;
        case SS_LCNT: set(ss_low_, value & 0xFFFF); break;
        case FS_HCNT: set(fs_high_, value & 0xFFFF); break;
        case FS_LCNT: set(fs_low_, value & 0xFFFF); break;
        case INTR_MASK: mask_ = value & 0xFFF; break;
        case RX_TL: rx_threshold_ = value & 0xFF; break;
        case TX_TL: tx_threshold_ = value & 0xFF; break;
        case EN: enable(value); break;
        case SDA_HOLD: set(hold_, value & 0xFFFF); break;
        case DMA_CR: dma_ = value & 3; break;
        case DMA_TDLR: dma_tx_ = value & 0x3F; break;
        case DMA_RDLR: dma_rx_ = value & 0x3F; break;
        case SDA_SETUP: set(setup_, value & 0xFF); break;
        case ACK_GENERAL_CALL: general_call_ = value & 1; break;
        case FS_SPKLEN: set(spike_, value & 0xFF); break;
        default: break;
    }
    update();
}

void I2cController::command(std::uint32_t value, const sc_core::sc_time& now) {
    if (!enabled_ || aborted_) return;
    if (commands_.size() == I2C_FIFO) {
        raised_ |= TX_OVER;
        return;
    }
    commands_.push_back(value & (0xFF | READS | STOP | START_AGAIN));
    if (!busy_) step_.notify(now - sc_core::sc_time_stamp());
}

void I2cController::enable(std::uint32_t value) {
    constexpr std::uint32_t ENABLE_BIT = 1, ABORT_BIT = 2;
    const bool enables = value & ENABLE_BIT, aborts = (value & ABORT_BIT) && enabled_ && active_;
    if (aborts || (enabled_ && !enables)) {
        commands_.clear();
        stops_ = busy_;
        if (!busy_ && active_) {
            sent_stop_ = false;
            stop();
        }
    }
    if (aborts) {
        raised_ |= TX_ABRT;
        abort_source_ |= BY_USER;
        aborted_ = true;
    }
    if (enabled_ && !enables) {
        received_.clear();
        aborted_ = false;
    }
    enabled_ = enables;
}

}  // namespace sim
