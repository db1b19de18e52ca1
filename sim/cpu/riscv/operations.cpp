// operations.cpp - what RiscvCore's interpreter leaves to functions: memory beyond the main RAM,
// atomic and floating-point instructions, CSRs
#include <algorithm>
#include <cstring>

#include "sim/cpu/riscv/core.h"

namespace sim {

// ---- Memory -------------------------------------------------------------------------------------

// RAM that loads and stores use without the bus; or nullptr.
std::uint8_t* RiscvCore::data_at(std::uint32_t address, unsigned bytes) const {
    const Ram* ram = ram_at(address, bytes);
    return ram && !ram->data_by_bus ? ram->bytes + (address - ram->base) : nullptr;
}

bool RiscvCore::load(std::uint32_t address, unsigned bytes, std::uint32_t& value) {
    value = 0;
    if (address % bytes) return raise(riscv_cause::LOAD_MISALIGNED, address);
    if (const std::uint8_t* const ram = data_at(address, bytes)) {
        std::memcpy(&value, ram, bytes);
        return true;
    }
    return bus_.read(address, bytes, value) || raise(riscv_cause::LOAD_FAULT, address);
}

bool RiscvCore::store(std::uint32_t address, unsigned bytes, std::uint32_t value) {
    if (address % bytes) return raise(riscv_cause::STORE_MISALIGNED, address);
    if (std::uint8_t* const ram = data_at(address, bytes)) {
        std::memcpy(ram, &value, bytes);
        return true;
    }
    return bus_.write(address, bytes, value) || raise(riscv_cause::STORE_FAULT, address);
}

bool RiscvCore::atomic(const RiscvOp& op) {
    const std::uint32_t address = x_[op.rs1], operand = x_[op.rs2];
    std::uint32_t value = 0;
    if (op.code == RiscvOp::LR) {
        if (!load(address, 4, value)) return false;
        reserved_ = address;
        x_[op.rd] = value;
        return true;
    }
    if (address % 4) return raise(riscv_cause::STORE_MISALIGNED, address);
    if (op.code == RiscvOp::SC) {
        const bool succeeds = reserved_ == address;
        reserved_.reset();
        if (succeeds && !store(address, 4, operand)) return false;
        x_[op.rd] = !succeeds;
        return true;
    }
    if (!load(address, 4, value)) return raise(riscv_cause::STORE_FAULT, address);
    const auto as_signed = [](std::uint32_t word) { return static_cast<std::int32_t>(word); };
    std::uint32_t result = operand;  // AMOSWAP
    switch (op.imm) {
        case 0x00: result = value + operand; break;
        case 0x04: result = value ^ operand; break;
        case 0x08: result = value | operand; break;
        case 0x0C: result = value & operand; break;
        case 0x10: result = as_signed(value) < as_signed(operand) ? value : operand; break;
        case 0x14: result = as_signed(value) > as_signed(operand) ? value : operand; break;
        case 0x18: result = std::min(value, operand); break;
        case 0x1C: result = std::max(value, operand); break;
        default: break;
    }
    if (!store(address, 4, result)) return false;
    x_[op.rd] = value;
    return true;
}

// ---- Floating point -----------------------------------------------------------------------------

// False: its rounding mode is none.
bool RiscvCore::floating(const RiscvOp& op) {
    constexpr std::uint32_t SIGN = 0x80000000;
    const std::uint32_t a = f_[op.rs1], b = f_[op.rs2];
    std::uint32_t& f = f_[op.rd & 31];
    std::uint32_t& x = x_[op.rd];
    switch (op.code) {  // those that do not round
        case RiscvOp::FSGNJ: f = (a & ~SIGN) | (b & SIGN); return true;
        case RiscvOp::FSGNJN: f = (a & ~SIGN) | (~b & SIGN); return true;
        case RiscvOp::FSGNJX: f = a ^ (b & SIGN); return true;
        case RiscvOp::FMIN: f = fpu_.lower(a, b); return true;
        case RiscvOp::FMAX: f = fpu_.higher(a, b); return true;
        case RiscvOp::FEQ: x = fpu_.equal(a, b); return true;
        case RiscvOp::FLT: x = fpu_.less(a, b); return true;
        case RiscvOp::FLE: x = fpu_.less_or_equal(a, b); return true;
        case RiscvOp::FCLASS: x = RiscvFpu::classify(a); return true;
        default: break;
    }
    constexpr unsigned DYNAMIC = 7;
    unsigned rounding = op.imm & 7;
    if (rounding == DYNAMIC) rounding = frm_;
    if (rounding > RiscvFpu::TIES_AWAY) return false;
    const std::uint32_t c = f_[op.imm >> 8 & 31];
    switch (op.code) {
        case RiscvOp::FADD: f = fpu_.add(a, b, rounding); break;
        case RiscvOp::FSUB: f = fpu_.subtract(a, b, rounding); break;
        case RiscvOp::FMUL: f = fpu_.multiply(a, b, rounding); break;
        case RiscvOp::FDIV: f = fpu_.divide(a, b, rounding); break;
        case RiscvOp::FSQRT: f = fpu_.root(a, rounding); break;
        case RiscvOp::FMADD: f = fpu_.fused(a, b, c, rounding); break;
        case RiscvOp::FMSUB: f = fpu_.fused(a, b, c ^ SIGN, rounding); break;
        case RiscvOp::FNMSUB: f = fpu_.fused(a ^ SIGN, b, c, rounding); break;
        case RiscvOp::FNMADD: f = fpu_.fused(a ^ SIGN, b, c ^ SIGN, rounding); break;
        case RiscvOp::FCVT_W_S: x = fpu_.to_int(a, true, rounding); break;
        case RiscvOp::FCVT_WU_S: x = fpu_.to_int(a, false, rounding); break;
        case RiscvOp::FCVT_S_W: f = fpu_.from_int(x_[op.rs1], true, rounding); break;
        case RiscvOp::FCVT_S_WU: f = fpu_.from_int(x_[op.rs1], false, rounding); break;
        default: break;
    }
    return true;
}

// ---- CSRs ---------------------------------------------------------------------------------------

namespace {

constexpr std::uint32_t LINES = 0xFFFF0088;  // of mie and mip
constexpr std::uint32_t MISA = 0x40001121;   // 32 bits; A, F, I, M

std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); }

// `value` with one half changed.
std::uint64_t with(std::uint64_t value, bool upper, std::uint32_t half) {
    return upper ? low(value) | std::uint64_t{half} << 32 : (value & 0xFFFFFFFF00000000) | half;
}

}  // namespace

std::optional<std::uint32_t> RiscvCore::csr(std::uint32_t number) const {
    using namespace riscv_csr;
    switch (number) {
        case FFLAGS: return fpu_.flags;
        case FRM: return frm_;
        case FCSR: return frm_ << 5 | fpu_.flags;
        case MSTATUS:
            return mstatus_ | riscv_mstatus::MPP |
                   ((mstatus_ & riscv_mstatus::FS) == riscv_mstatus::FS ? riscv_mstatus::SD : 0);
        case riscv_csr::MISA: return sim::MISA;
        case riscv_csr::MIE: return mie_;
        case MTVEC: return mtvec_;
        case MSCRATCH: return mscratch_;
        case MEPC: return mepc_;
        case MCAUSE: return mcause_;
        case MTVAL: return mtval_;
        case MIP: return mip_;
        case MCYCLE: return low(bus_.cycles() + cycles_written_);
        case MCYCLEH: return high(bus_.cycles() + cycles_written_);
        case MINSTRET: return low(instructions_ + instructions_written_);
        case MINSTRETH: return high(instructions_ + instructions_written_);
        case MVENDORID:
        case MARCHID:
        case MIMPID:
        case MHARTID: return 0;
        default: return std::nullopt;
    }
}

bool RiscvCore::set_csr(std::uint32_t number, std::uint32_t value) {
    using namespace riscv_csr;
    switch (number) {
        case FFLAGS:
        case FRM:
        case FCSR: return write_floating(number, value);
        case MSTATUS:
            mstatus_ = value & (riscv_mstatus::MIE | riscv_mstatus::MPIE | riscv_mstatus::FS);
            return true;
        case riscv_csr::MISA: return true;
        case riscv_csr::MIE: mie_ = value & LINES; return true;
        case MTVEC:
            mtvec_ = value & ~2u;
            mtvec_set_ = true;
            return true;
        case MSCRATCH: mscratch_ = value; return true;
        case MEPC: mepc_ = value & ~3u; return true;
        case MCAUSE: mcause_ = value; return true;
        case MTVAL: mtval_ = value; return true;
        case MIP: return true;  // all bits are lines
        case MCYCLE:
        case MCYCLEH: {
            const std::uint64_t now = bus_.cycles();
            cycles_written_ = with(now + cycles_written_, number == MCYCLEH, value) - now;
            return true;
        }
        case MINSTRET:
        case MINSTRETH: {
            const std::uint64_t now = instructions_ + instructions_written_;
            instructions_written_ = with(now, number == MINSTRETH, value) - (instructions_ + 1);
            return true;
        }
        default: return false;
    }
}

bool RiscvCore::write_floating(std::uint32_t number, std::uint32_t value) {
    if (number != riscv_csr::FFLAGS) {
        const unsigned mode = (number == riscv_csr::FCSR ? value >> 5 : value) & 7;
        if (nearest_alone_ && mode != RiscvFpu::NEAREST) return false;
        frm_ = mode;
    }
    if (number != riscv_csr::FRM) fpu_.flags = value & 0x1F;
    return true;
}

// False: it is not there, or cannot be written.
bool RiscvCore::change_csr(std::uint32_t word) {
    const std::uint32_t number = word >> 20, rs1 = word >> 15 & 31, rd = word >> 7 & 31;
    const unsigned kind = word >> 12 & 3;  // 1 writes, 2 sets bits, 3 clears bits
    const std::uint32_t operand = word >> 14 & 1 ? rs1 : x_[rs1];
    const bool writes = kind == 1 || rs1 != 0;
    if (writes && number >> 10 == 3) return false;
    const std::optional<std::uint32_t> old = csr(number);
    if (!old) return false;
    const std::uint32_t value = kind == 1 ? operand : kind == 2 ? *old | operand : *old & ~operand;
    if (writes && !set_csr(number, value)) return false;
    if (rd) x_[rd] = *old;
    return true;
}

}  // namespace sim
