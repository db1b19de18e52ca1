// decode.cpp - words of a page into what the interpreter executes
//
// Source: The RISC-V Instruction Set Manual, volume I, 20191213, chapter 24.
#include "sim/cpu/riscv/instructions.h"

namespace sim {

namespace {

using Op = RiscvOp;

constexpr std::uint32_t bits(std::uint32_t word, unsigned low, unsigned count) {
    return word >> low & ((1u << count) - 1);
}

constexpr std::int32_t sign_extended(std::uint32_t value, unsigned width) {
    return static_cast<std::int32_t>(value << (32 - width)) >> (32 - width);
}

std::int32_t imm_i(std::uint32_t word) { return static_cast<std::int32_t>(word) >> 20; }
std::int32_t imm_s(std::uint32_t word) {
    return sign_extended(bits(word, 25, 7) << 5 | bits(word, 7, 5), 12);
}
std::int32_t imm_b(std::uint32_t word) {
    return sign_extended(bits(word, 31, 1) << 12 | bits(word, 7, 1) << 11 | bits(word, 25, 6) << 5 |
                             bits(word, 8, 4) << 1,
                         13);
}
std::int32_t imm_j(std::uint32_t word) {
    return sign_extended(bits(word, 31, 1) << 20 | bits(word, 12, 8) << 12 |
                             bits(word, 20, 1) << 11 | bits(word, 21, 10) << 1,
                         21);
}

bool writes_integer(Op::Code code) {
    switch (code) {
        case Op::FLW:
        case Op::FMV_W_X:
        case Op::FCVT_S_W:
        case Op::FCVT_S_WU: return false;
        case Op::FEQ:
        case Op::FLT:
        case Op::FLE:
        case Op::FCLASS:
        case Op::FCVT_W_S:
        case Op::FCVT_WU_S:
        case Op::FMV_X_W: return true;
        default: return code < Op::FLW || code > Op::FMV_W_X;
    }
}

class Decoder {
public:
    Decoder(RiscvPage& page, const RiscvClocks& clocks) : page_{page}, clocks_{clocks} {}

    void page() {
        page_.ops.assign(RiscvPage::WORDS, {});
        Op next;
        next.code = Op::NEXT_PAGE;
        page_.ops.push_back(next);
        for (std::uint32_t i = RiscvPage::WORDS; i-- > 0;) one(i);
    }

private:
    static constexpr bool ENDS_RUN[] = {
#define RISCV_OP(name, clocks, ends) ends,
#include "sim/cpu/riscv/instructions.def"
#undef RISCV_OP
    };

    std::uint16_t clocks_of(Op::Code code) const {
        const std::uint16_t all[] = {
#define RISCV_OP(name, clocks, ends) clocks_.clocks,
#include "sim/cpu/riscv/instructions.def"
#undef RISCV_OP
        };
        return all[code];
    }

    void one(std::uint32_t index) {
        const std::uint32_t word = page_.words[index];
        Op op;
        op.code = Op::ILLEGAL;
        op.rd = static_cast<std::uint8_t>(bits(word, 7, 5));
        op.rs1 = static_cast<std::uint8_t>(bits(word, 15, 5));
        op.rs2 = static_cast<std::uint8_t>(bits(word, 20, 5));
        if (bits(word, 0, 2) == 3) decode(word, index, op);
        if (op.rd == 0 && writes_integer(op.code)) {
            op.rd = Op::NOWHERE;
            if (op.code > Op::NOP && op.code <= Op::REMU) op.code = Op::NOP;
        }
        const Op& after = page_.ops[index + 1];
        op.run = static_cast<std::uint16_t>(ENDS_RUN[op.code] ? 1 : 1 + after.run);
        op.clocks =
            static_cast<std::uint16_t>(clocks_of(op.code) + (ENDS_RUN[op.code] ? 0 : after.clocks));
        page_.ops[index] = op;
    }

    void decode(std::uint32_t word, std::uint32_t index, Op& op) {
        const std::uint32_t funct3 = bits(word, 12, 3), funct7 = bits(word, 25, 7);
        const std::uint32_t pc = page_.base + index * 4;
        switch (bits(word, 2, 5)) {
            case 0x0D:  // LUI
                op.code = Op::LI;
                op.imm = static_cast<std::int32_t>(word & 0xFFFFF000);
                break;
            case 0x05:  // AUIPC
                op.code = Op::LI;
                op.imm = static_cast<std::int32_t>(pc + (word & 0xFFFFF000));
                break;
            case 0x1B:
                op.code = Op::JAL;
                if (imm_j(word) & 2) op.rd = Op::NOWHERE;
                op.imm = distance(index, imm_j(word));
                break;
            case 0x19:
                if (funct3 != 0) break;
                op.code = Op::JALR;
                op.imm = imm_i(word);
                break;
            case 0x18: {
                constexpr Op::Code CODES[] = {Op::BEQ, Op::BNE, Op::ILLEGAL, Op::ILLEGAL,
                                              Op::BLT, Op::BGE, Op::BLTU,    Op::BGEU};
                op.code = CODES[funct3];
                if (op.code != Op::ILLEGAL) op.imm = distance(index, imm_b(word));
                break;
            }
            case 0x00: {
                constexpr Op::Code CODES[] = {Op::LB,  Op::LH,  Op::LW,      Op::ILLEGAL,
                                              Op::LBU, Op::LHU, Op::ILLEGAL, Op::ILLEGAL};
                op.code = CODES[funct3];
                op.imm = imm_i(word);
                break;
            }
            case 0x08:
                if (funct3 > 2) break;
                op.code = static_cast<Op::Code>(Op::SB + funct3);
                op.imm = imm_s(word);
                break;
            case 0x04: immediate(word, funct3, funct7, op); break;
            case 0x0C: registers(funct3, funct7, op); break;
            case 0x03:
                if (funct3 == 0) op.code = Op::NOP;  // FENCE: accesses are in order
                if (funct3 == 1) op.code = Op::FENCE_I;
                op.rd = 1;  // of neither the register counts
                break;
            case 0x1C: system(word, funct3, op); break;
            case 0x0B: atomic(word, funct3, op); break;
            case 0x01:
                if (funct3 == 2) op.code = Op::FLW, op.imm = imm_i(word);
                break;
            case 0x09:
                if (funct3 == 2) op.code = Op::FSW, op.imm = imm_s(word);
                break;
            case 0x10:
            case 0x11:
            case 0x12:
            case 0x13:
                if (bits(word, 25, 2) != 0) break;
                op.code = static_cast<Op::Code>(Op::FMADD + (bits(word, 2, 5) - 0x10));
                op.imm = static_cast<std::int32_t>(funct3 | bits(word, 27, 5) << 8);
                break;
            case 0x14: floating(funct3, funct7, op); break;
            default: break;
        }
    }

    // In Ops, from the jump's to where it goes; perhaps through one that is added for it.
    std::int32_t distance(std::uint32_t index, std::int32_t bytes) {
        const auto target = static_cast<std::int64_t>(index) * 4 + bytes;
        if (target >= 0 && target < RiscvPage::BYTES && bytes % 4 == 0) return bytes / 4;
        Op far;
        far.code = bytes % 4 ? Op::MISALIGNED : Op::FAR;
        far.imm = static_cast<std::int32_t>(page_.base + index * 4) + bytes;
        far.rd = static_cast<std::uint8_t>(index);
        far.rs1 = static_cast<std::uint8_t>(index >> 8);
        page_.ops.push_back(far);
        return static_cast<std::int32_t>(page_.ops.size() - 1 - index);
    }

    static void immediate(std::uint32_t word, std::uint32_t funct3, std::uint32_t funct7, Op& op) {
        constexpr Op::Code CODES[] = {Op::ADDI, Op::SLLI, Op::SLTI, Op::SLTIU,
                                      Op::XORI, Op::SRLI, Op::ORI,  Op::ANDI};
        op.imm = imm_i(word);
        if (funct3 == 1 || funct3 == 5) {
            op.imm = op.rs2;
            if (funct3 == 5 && funct7 == 0x20) op.code = Op::SRAI;
            if (funct7 != 0) return;
        }
        op.code = CODES[funct3];
    }

    static void registers(std::uint32_t funct3, std::uint32_t funct7, Op& op) {
        constexpr Op::Code CODES[] = {Op::ADD, Op::SLL, Op::SLT, Op::SLTU,
                                      Op::XOR, Op::SRL, Op::OR,  Op::AND};
        if (funct7 == 0) op.code = CODES[funct3];
        if (funct7 == 1) op.code = static_cast<Op::Code>(Op::MUL + funct3);
        if (funct7 == 0x20 && funct3 == 0) op.code = Op::SUB;
        if (funct7 == 0x20 && funct3 == 5) op.code = Op::SRA;
    }

    static void system(std::uint32_t word, std::uint32_t funct3, Op& op) {
        if (funct3 == 4) return;
        if (funct3 != 0) {
            op.code = Op::CSR;
            op.imm = static_cast<std::int32_t>(word);
            return;
        }
        switch (word) {
            case 0x00000073: op.code = Op::ECALL; break;
            case 0x00100073: op.code = Op::EBREAK; break;
            case 0x30200073: op.code = Op::MRET; break;
            case 0x10500073: op.code = Op::WFI; break;
            default: break;
        }
    }

    static void atomic(std::uint32_t word, std::uint32_t funct3, Op& op) {
        const std::uint32_t kind = bits(word, 27, 5);
        if (funct3 != 2) return;
        op.imm = static_cast<std::int32_t>(kind);
        if (kind == 2 && op.rs2 == 0) op.code = Op::LR;
        if (kind == 3) op.code = Op::SC;
        if (kind <= 1 || (kind % 4 == 0 && kind <= 0x1C)) op.code = Op::AMO;
    }

    static void floating(std::uint32_t funct3, std::uint32_t funct7, Op& op) {
        op.imm = static_cast<std::int32_t>(funct3);
        const auto one_of = [&](Op::Code first, unsigned count) {
            if (funct3 < count) op.code = static_cast<Op::Code>(first + funct3);
        };
        const bool alone = op.rs2 == 0;
        switch (funct7) {
            case 0x00: op.code = Op::FADD; break;
            case 0x04: op.code = Op::FSUB; break;
            case 0x08: op.code = Op::FMUL; break;
            case 0x0C: op.code = Op::FDIV; break;
            case 0x2C:
                if (alone) op.code = Op::FSQRT;
                break;
            case 0x10: one_of(Op::FSGNJ, 3); break;
            case 0x14: one_of(Op::FMIN, 2); break;
            case 0x50:
                if (funct3 < 3) op.code = static_cast<Op::Code>(Op::FLE - funct3);
                break;
            case 0x60:
                if (op.rs2 < 2) op.code = static_cast<Op::Code>(Op::FCVT_W_S + op.rs2);
                break;
            case 0x68:
                if (op.rs2 < 2) op.code = static_cast<Op::Code>(Op::FCVT_S_W + op.rs2);
                break;
            case 0x70:
                if (alone && funct3 == 0) op.code = Op::FMV_X_W;
                if (alone && funct3 == 1) op.code = Op::FCLASS;
                break;
            case 0x78:
                if (alone && funct3 == 0) op.code = Op::FMV_W_X;
                break;
            default: break;
        }
    }

    RiscvPage& page_;
    const RiscvClocks& clocks_;
};

}  // namespace

void decode(RiscvPage& page, const RiscvClocks& clocks) { Decoder{page, clocks}.page(); }

}  // namespace sim
