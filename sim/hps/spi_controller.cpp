#include "sim/hps/spi_controller.h"

namespace sim {

namespace {

constexpr std::uint64_t SPI_CLOCK_PS = 5'000;  // 200 MHz
constexpr std::size_t SPI_FIFO = 256;
constexpr std::uint32_t SEND_ALONE = 1, RECEIVE_ALONE = 2, EEPROM = 3;  // modes
constexpr std::uint32_t SCPH = 0x40, SCPOL = 0x80, OUTPUT_OFF = 0x400;  // ctrlr0
constexpr std::uint32_t SPI_TX_EMPTY = 1, SPI_TX_OVER = 2, SPI_RX_UNDER = 4, SPI_RX_OVER = 8,
                        SPI_RX_FULL = 0x10, SPI_EVENTS = SPI_TX_OVER | SPI_RX_UNDER | SPI_RX_OVER;
constexpr std::uint32_t SPI_IDENTITY = 0x05510000, SPI_VERSION = 0x3332302A;

}  // namespace

enum SpiController::Offset : std::uint32_t {
    CTRLR0 = 0x00,
    CTRLR1 = 0x04,
    SSIENR = 0x08,
    SER = 0x10,
    BAUDR = 0x14,
    TXFTLR = 0x18,
    RXFTLR = 0x1C,
    TXFLR = 0x20,
    RXFLR = 0x24,
    SR = 0x28,
    IMR = 0x2C,
    ISR = 0x30,
    RISR = 0x34,
    TXOICR = 0x38,
    RXOICR = 0x3C,
    RXUICR = 0x40,
    MSTICR = 0x44,
    ICR = 0x48,
    DMACR = 0x4C,
    IDR = 0x58,
    SSI_VERSION = 0x5C,
    DR = 0x60,
    DR_END = 0xF0,
    RX_SAMPLE_DELAY = 0xFC
};

SpiController::SpiController(const sc_core::sc_module_name& module_name, Role role,
                             std::function<void(bool)> line)
    : Registers{module_name}, role_{role}, line_{std::move(line)} {
    SC_HAS_PROCESS(SpiController);
    SC_METHOD(serve);
    sensitive << step_;
    dont_initialize();
    reset();
}

void SpiController::reset() {
    control_ = 7;
    frames_ = slaves_ = divider_ = tx_threshold_ = rx_threshold_ = raised_ = dma_ = delay_ = 0;
    mask_ = 0x1F;
    enabled_ = busy_ = false;
    to_receive_ = 0;
    to_send_.clear();
    received_.clear();
    step_.cancel();
    release_wires();
    update();
}

void SpiController::release_wires() {
    if (fabric_) fabric_->release((control_ & SCPOL) != 0);
}

// ---- The wires ----

bool SpiController::has_work() const {
    return role_ == Role::MASTER && enabled_ && slaves_ != 0 && divider_ != 0 &&
           (!to_send_.empty() || to_receive_ != 0);
}

SpiFormat SpiController::format() const {
    return {(control_ & 0xF) + 1, (control_ & SCPH) != 0, (control_ & SCPOL) != 0};
}

void SpiController::begin(const sc_core::sc_time& in) {
    if (busy_ || !has_work()) return;
    busy_ = true;
    is_over_ = !fabric_;
    if (!fabric_)
        step_.notify(in + sc_core::sc_time::from_value(format().bits * divider_ * SPI_CLOCK_PS));
    else if (in == sc_core::SC_ZERO_TIME)
        send();
    else
        step_.notify(in);
}

void SpiController::send() {
    const std::uint32_t mode = control_ >> 8 & 3;
    if (mode == RECEIVE_ALONE && to_receive_ == 0) {
        repeated_ = to_send_.front();
        to_send_.pop_front();
        to_receive_ = frames_ + 1;
    }
    const std::uint32_t value = mode == RECEIVE_ALONE ? repeated_
                                : to_send_.empty()    ? 0
                                                      : to_send_.front();
    is_over_ = true;
    fabric_->send({format(), divider_ * SPI_CLOCK_PS, delay_ * SPI_CLOCK_PS, slaves_,
                   value & ((1u << format().bits) - 1)});
}

// A frame is due to begin on its wires, or has gone over them.
void SpiController::serve() {
    if (!is_over_) return send();
    const std::uint32_t mode = control_ >> 8 & 3;
    busy_ = false;
    if (!fabric_) sent_(slaves_, to_send_.empty() ? 0 : to_send_.front());
    const std::uint32_t came = fabric_ ? fabric_->received() : 0;
    const bool starts = fabric_ ? mode == EEPROM : mode >= RECEIVE_ALONE;
    if (starts && !to_send_.empty()) {
        to_send_.pop_front();  // what starts it, or the EEPROM's command
        if (to_send_.empty()) to_receive_ = frames_ + 1;
    } else {
        const bool only_receives = to_receive_ != 0;
        if (only_receives) --to_receive_;
        if (!to_send_.empty() && !(fabric_ && only_receives)) to_send_.pop_front();
        if (mode != SEND_ALONE) receive(came);
    }
    begin(sc_core::SC_ZERO_TIME);
    update();
}

void SpiController::receive(std::uint32_t frame) {
    if (received_.size() < SPI_FIFO)
        received_.push_back(frame);
    else
        raised_ |= SPI_RX_OVER;
}

// ---- Wires to the FPGA ----

void SpiController::connect(FabricWires wires) {
    wires_ = std::move(wires);
    if (role_ == Role::MASTER) {
        fabric_ = std::make_unique<SpiMasterWires>(sc_core::sc_gen_unique_name("spi_wires"),
                                                   *wires_, [this] { serve(); });
        return;
    }
    slave_.emplace(SpiSlaveWires::Frames{
        [this] { return next_of_slave(); },
        [this] {
            if (!to_send_.empty() && (control_ >> 8 & 3) != RECEIVE_ALONE) to_send_.pop_front();
        },
        [this](std::uint32_t frame) {
            if ((control_ >> 8 & 3) != SEND_ALONE) receive(frame);
        },
        [this](bool txd, bool is_selected) {
            const bool drives = is_selected && !(control_ & OUTPUT_OFF);
            wires_->drive((txd && drives ? 1u : 0u) | (drives ? 0u : 2u), moved_at_);
        }});
}

std::uint32_t SpiController::next_of_slave() const {
    return to_send_.empty() || (control_ >> 8 & 3) == RECEIVE_ALONE ? 0 : to_send_.front();
}

void SpiController::moved(std::uint64_t levels, std::uint64_t time_ps) {
    if (fabric_) return fabric_->moved(levels);
    moved_at_ = sc_core::sc_time::from_value(time_ps);
    slave_->moved(levels & 1, enabled_ && !(levels >> 1 & 1), levels >> 2 & 1, format());
    update();
}

// ---- Registers ----

std::uint32_t SpiController::raw() const {
    return raised_ | (enabled_ && to_send_.size() <= tx_threshold_ ? SPI_TX_EMPTY : 0) |
           (received_.size() > rx_threshold_ ? SPI_RX_FULL : 0);
}

void SpiController::update() {
    const bool up = raw() & mask_;
    if (std::exchange(up_, up) != up) line_(up);
}

std::uint32_t SpiController::read(std::uint32_t offset, const sc_core::sc_time& now) {
    if (wires_) wires_->catch_up(now);
    const auto clear = [this](std::uint32_t events) {
        const bool was = raised_ & events;
        raised_ &= ~events;
        update();
        return static_cast<std::uint32_t>(was);
    };
    switch (offset) {
        case CTRLR0: return control_;
        case CTRLR1: return frames_;
        case SSIENR: return enabled_;
        case SER: return slaves_;
        case BAUDR: return divider_;
        case TXFTLR: return tx_threshold_;
        case RXFTLR: return rx_threshold_;
        case TXFLR: return static_cast<std::uint32_t>(to_send_.size());
        case RXFLR: return static_cast<std::uint32_t>(received_.size());
        case SR:
            return (busy_ ? 1u : 0u) | (to_send_.size() < SPI_FIFO ? 2u : 0u) |
                   (to_send_.empty() ? 4u : 0u) | (received_.empty() ? 0u : 8u) |
                   (received_.size() == SPI_FIFO ? 0x10u : 0u);
        case IMR: return mask_;
        case ISR: return raw() & mask_;
        case RISR: return raw();
        case TXOICR: return clear(SPI_TX_OVER);
        case RXOICR: return clear(SPI_RX_OVER);
        case RXUICR: return clear(SPI_RX_UNDER);
        case MSTICR: return 0;
        case ICR: return clear(SPI_EVENTS);
        case DMACR: return dma_;
        case IDR: return SPI_IDENTITY;
        case SSI_VERSION: return SPI_VERSION;
        case RX_SAMPLE_DELAY: return delay_;
        default: break;
    }
    if (offset < DR || offset >= DR_END) return 0;
    std::uint32_t frame = 0;
    if (received_.empty()) {
        raised_ |= SPI_RX_UNDER;
    } else {
        frame = received_.front();
        received_.pop_front();
    }
    update();
    return frame;
}

void SpiController::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    if (wires_) wires_->catch_up(now);
    const auto set = [this](std::uint32_t& to, std::uint32_t what) {
        if (!enabled_) to = what;
    };
    switch (offset) {
        case CTRLR0: set(control_, value & 0xFFFF); break;
        case CTRLR1: set(frames_, value & 0xFFFF); break;
        case SSIENR:
            enabled_ = value & 1;
            if (!enabled_) {
                to_send_.clear();
                received_.clear();
                to_receive_ = 0;
                busy_ = false;
                step_.cancel();
            }
            release_wires();
            break;
        case SER: slaves_ = role_ == Role::MASTER ? value & 0xF : 0; break;
        case BAUDR: set(divider_, value & 0xFFFE); break;
        case TXFTLR: tx_threshold_ = value & 0xFF; break;
        case RXFTLR: rx_threshold_ = value & 0xFF; break;
        case IMR: mask_ = value & 0x1F; break;
        case DMACR: dma_ = value & 3; break;
        case RX_SAMPLE_DELAY: delay_ = value & 0x7F; break;
        default:
            if (offset < DR || offset >= DR_END || !enabled_) break;
            if (to_send_.size() < SPI_FIFO)
                to_send_.push_back(value);
            else
                raised_ |= SPI_TX_OVER;
    }
    begin(now - sc_core::sc_time_stamp());
    update();
}

}  // namespace sim
