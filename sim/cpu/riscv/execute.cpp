// execute.cpp - RiscvCore's interpreter: each instruction jumps to the code of the next
#include <cstring>

#include "sim/cpu/riscv/core.h"

// Labels as values, of GCC and Clang.
#pragma GCC diagnostic ignored "-Wpedantic"

namespace sim {

namespace {

std::int32_t as_signed(std::uint32_t value) { return static_cast<std::int32_t>(value); }

std::uint32_t high_of(std::int64_t product) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(product) >> 32);
}

std::uint32_t quotient(std::uint32_t a, std::uint32_t b) {
    if (b == 0) return 0xFFFFFFFF;
    if (a == 0x80000000 && b == 0xFFFFFFFF) return a;
    return static_cast<std::uint32_t>(as_signed(a) / as_signed(b));
}

std::uint32_t remainder(std::uint32_t a, std::uint32_t b) {
    if (b == 0) return a;
    if (b == 0xFFFFFFFF) return 0;
    return static_cast<std::uint32_t>(as_signed(a) % as_signed(b));
}

}  // namespace

// CLOSELY: counts and looks at each instruction, else at each run of them.
//
// `left` is what is left of the clocks, and `done` the instructions, when all that was entered is
// done: of a run from `op` on, so that the present time is `end` - `left` - rest(op).
template <bool CLOSELY>
RiscvStop RiscvCore::execute(std::uint64_t most) {
    static const void* const LABELS[] = {
#define RISCV_OP(name, clocks, ends) &&do_##name,
#include "sim/cpu/riscv/instructions.def"
#undef RISCV_OP
    };
    std::uint32_t* const x = x_.data();
    const Ram main = ram_.empty() || ram_.front().data_by_bus ? Ram{} : ram_.front();
    const std::int64_t taken = clocks_.taken - clocks_.branch;
    auto end = static_cast<std::int64_t>(end_);
    std::int64_t left = end - static_cast<std::int64_t>(at_);
    std::uint64_t done = instructions_;
    std::uint32_t pc = pc_;
    RiscvPage* page = nullptr;
    const RiscvOp* op = nullptr;

    const auto rest = [](const RiscvOp* o) -> std::int64_t {
        return CLOSELY ? o->own_clocks() : o->clocks;
    };
    const auto rest_run = [](const RiscvOp* o) -> unsigned { return CLOSELY ? 1 : o->run; };
    // The core's own members are those before the present instruction.
    const auto show = [&] {
        at_ = static_cast<std::uint64_t>(end - left - rest(op));
        instructions_ = done - rest_run(op);
        pc_ = page->pc_of(op);
    };
    // Somebody may have changed when run() ends.
    const auto look = [&] {
        end = static_cast<std::int64_t>(end_);
        left = end - static_cast<std::int64_t>(at_) - rest(op);
    };
    const auto stop = [&](RiscvStop why) {
        at_ = static_cast<std::uint64_t>(end - left);
        instructions_ = done;
        pc_ = pc;
        return why;
    };
    const auto touches = [&](std::uint32_t address, unsigned bytes, bool write) {
        return CLOSELY && probe_ && probe_->touches(address, bytes, write);
    };

#define GO goto* LABELS[op->code]
#define ENTER                                                   \
    do {                                                        \
        if (CLOSELY) goto closely;                              \
        if (__builtin_expect(op->clocks > left, 0)) goto leave; \
        left -= op->clocks;                                     \
        done += op->run;                                        \
        GO;                                                     \
    } while (0)
#define NEXT                       \
    do {                           \
        ++op;                      \
        if (CLOSELY) goto closely; \
        GO;                        \
    } while (0)
#define ALU(name, value)                                             \
    do_##name : {                                                    \
        const std::uint32_t a = x[op->rs1], b = x[op->rs2],          \
                            i = static_cast<std::uint32_t>(op->imm); \
        (void)a, (void)b, (void)i;                                   \
        x[op->rd] = (value);                                         \
        NEXT;                                                        \
    }
#define BRANCH(name, condition)                             \
    do_##name : {                                           \
        const std::uint32_t a = x[op->rs1], b = x[op->rs2]; \
        if (condition) {                                    \
            left -= taken;                                  \
            op += op->imm;                                  \
        } else {                                            \
            ++op;                                           \
        }                                                   \
        ENTER;                                              \
    }
// After an instruction that the core made outside of this function.
#define GO_ON                     \
    do {                          \
        look();                   \
        if (left < 0) goto early; \
        NEXT;                     \
    } while (0)
#define LOAD(name, type, width, destination)                                            \
    do_##name : {                                                                       \
        const std::uint32_t address = x[op->rs1] + static_cast<std::uint32_t>(op->imm); \
        const std::uint32_t offset = address - main.base;                               \
        if (touches(address, width, false)) goto watched;                               \
        type value;                                                                     \
        if (__builtin_expect(offset < main.size && address % width == 0, 1)) {          \
            std::memcpy(&value, main.bytes + offset, width);                            \
            destination = static_cast<std::uint32_t>(static_cast<std::int32_t>(value)); \
            NEXT;                                                                       \
        }                                                                               \
        std::uint32_t word = 0;                                                         \
        show();                                                                         \
        if (!load(address, width, word)) goto trapped;                                  \
        value = static_cast<type>(word);                                                \
        destination = static_cast<std::uint32_t>(static_cast<std::int32_t>(value));     \
        GO_ON;                                                                          \
    }
#define STORE(name, type, width, source)                                                \
    do_##name : {                                                                       \
        const std::uint32_t address = x[op->rs1] + static_cast<std::uint32_t>(op->imm); \
        const std::uint32_t offset = address - main.base;                               \
        if (touches(address, width, true)) goto watched;                                \
        if (__builtin_expect(offset < main.size && address % width == 0, 1)) {          \
            const auto value = static_cast<type>(source);                               \
            std::memcpy(main.bytes + offset, &value, width);                            \
            NEXT;                                                                       \
        }                                                                               \
        show();                                                                         \
        if (!store(address, width, source)) goto trapped;                               \
        GO_ON;                                                                          \
    }
#define FLOATING(name)                            \
    do_##name : if (!floating(*op)) goto illegal; \
    NEXT;

lookup:
    page = page_at(pc);
    if (!page) {
        trap_ = {riscv_cause::FETCH_FAULT, pc};
        return stop(RiscvStop::TRAP);
    }
    op = &page->ops[pc / 4 % RiscvPage::WORDS];
    ENTER;

closely:
    if (op->run == 0) GO;
    if (left <= 0 || most == 0 || ended_) goto leave;
    --most;
    if (probe_ || tally_) {
        pc = page->pc_of(op);
        stop(RiscvStop::LIMIT);
        if (probe_ && !past_probe_ && probe_->before(pc)) {
            ended_ = true;
            return RiscvStop::LIMIT;
        }
        if (tally_) tally_->executes(pc);
    }
    left -= op->own_clocks();
    ++done;
    GO;

leave:
    if (op->run == 0 && op->code != RiscvOp::NEXT_PAGE) GO;
    pc = page->pc_of(op);
    return stop(RiscvStop::LIMIT);

early:  // after the present instruction, in its run
    left += rest(op) - op->own_clocks();
    done -= rest_run(op) - 1;
    pc = page->pc_of(op) + 4;
    return stop(RiscvStop::LIMIT);

watched:
    ended_ = true;
    left += rest(op);
    done -= rest_run(op);
    pc = page->pc_of(op);
    return stop(RiscvStop::LIMIT);

illegal:
    trap_ = {riscv_cause::ILLEGAL, page->words[static_cast<std::size_t>(op - page->ops.data())]};
trapped:
    left += rest(op);
    done -= rest_run(op);
    pc = page->pc_of(op);
    return stop(RiscvStop::TRAP);

do_NEXT_PAGE:
    pc = page->base + RiscvPage::BYTES;
    goto lookup;
do_FAR:
    pc = static_cast<std::uint32_t>(op->imm);
    goto lookup;
do_MISALIGNED:
    trap_ = {riscv_cause::FETCH_MISALIGNED, static_cast<std::uint32_t>(op->imm)};
    op = &page->ops[op->rd | static_cast<unsigned>(op->rs1) << 8];
    left += op->own_clocks();
    done -= 1;
    pc = page->pc_of(op);
    return stop(RiscvStop::TRAP);

do_NOP:
    NEXT;
    ALU(LI, i)
    ALU(ADDI, a + i)
    ALU(SLTI, as_signed(a) < as_signed(i))
    ALU(SLTIU, a < i)
    ALU(XORI, a ^ i)
    ALU(ORI, a | i)
    ALU(ANDI, a & i)
    ALU(SLLI, a << i)
    ALU(SRLI, a >> i)
    ALU(SRAI, static_cast<std::uint32_t>(as_signed(a) >> i))
    ALU(ADD, a + b)
    ALU(SUB, a - b)
    ALU(SLL, a << (b & 31))
    ALU(SLT, as_signed(a) < as_signed(b))
    ALU(SLTU, a < b)
    ALU(XOR, a ^ b)
    ALU(SRL, a >> (b & 31))
    ALU(SRA, static_cast<std::uint32_t>(as_signed(a) >> (b & 31)))
    ALU(OR, a | b)
    ALU(AND, a & b)
    ALU(MUL, a * b)
    ALU(MULH, high_of(std::int64_t{as_signed(a)} * as_signed(b)))
    ALU(MULHSU, high_of(std::int64_t{as_signed(a)} * static_cast<std::int64_t>(b)))
    ALU(MULHU, static_cast<std::uint32_t>(std::uint64_t{a} * b >> 32))
    ALU(DIV, quotient(a, b))
    ALU(DIVU, b == 0 ? 0xFFFFFFFF : a / b)
    ALU(REM, remainder(a, b))
    ALU(REMU, b == 0 ? a : a % b)
    BRANCH(BEQ, a == b)
    BRANCH(BNE, a != b)
    BRANCH(BLT, as_signed(a) < as_signed(b))
    BRANCH(BGE, as_signed(a) >= as_signed(b))
    BRANCH(BLTU, a < b)
    BRANCH(BGEU, a >= b)
    LOAD(LB, std::int8_t, 1, x[op->rd])
    LOAD(LH, std::int16_t, 2, x[op->rd])
    LOAD(LW, std::uint32_t, 4, x[op->rd])
    LOAD(LBU, std::uint8_t, 1, x[op->rd])
    LOAD(LHU, std::uint16_t, 2, x[op->rd])
    LOAD(FLW, std::uint32_t, 4, f_[op->rd])
    STORE(SB, std::uint8_t, 1, x[op->rs2])
    STORE(SH, std::uint16_t, 2, x[op->rs2])
    STORE(SW, std::uint32_t, 4, x[op->rs2])
    STORE(FSW, std::uint32_t, 4, f_[op->rs2])

do_JAL:
    x[op->rd] = page->pc_of(op) + 4;
    op += op->imm;
    ENTER;
do_JALR : {
    const std::uint32_t target = (x[op->rs1] + static_cast<std::uint32_t>(op->imm)) & ~1u;
    if (target & 2) {
        trap_ = {riscv_cause::FETCH_MISALIGNED, target};
        goto trapped;
    }
    x[op->rd] = page->pc_of(op) + 4;
    pc = target;
    goto lookup;
}

do_LR:
do_SC:
do_AMO:
    if (op->code != RiscvOp::SC && touches(x[op->rs1], 4, false)) goto watched;
    if (op->code != RiscvOp::LR && touches(x[op->rs1], 4, true)) goto watched;
    show();
    if (!atomic(*op)) goto trapped;
    GO_ON;

    FLOATING(FADD)
    FLOATING(FSUB)
    FLOATING(FMUL)
    FLOATING(FDIV)
    FLOATING(FSQRT)
    FLOATING(FMADD)
    FLOATING(FMSUB)
    FLOATING(FNMSUB)
    FLOATING(FNMADD)
    FLOATING(FSGNJ)
    FLOATING(FSGNJN)
    FLOATING(FSGNJX)
    FLOATING(FMIN)
    FLOATING(FMAX)
    FLOATING(FEQ)
    FLOATING(FLT)
    FLOATING(FLE)
    FLOATING(FCLASS)
    FLOATING(FCVT_W_S)
    FLOATING(FCVT_WU_S)
    FLOATING(FCVT_S_W)
    FLOATING(FCVT_S_WU)
do_FMV_X_W:
    x[op->rd] = f_[op->rs1];
    NEXT;
do_FMV_W_X:
    f_[op->rd] = x[op->rs1];
    NEXT;

do_FENCE_I:
    ++generation_;
    pc = page->pc_of(op) + 4;
    goto lookup;
do_CSR:
    show();
    if (!change_csr(static_cast<std::uint32_t>(op->imm))) goto illegal;
    look();
    ++op;
    ended_ |= pending_interrupt().has_value();
    if (ended_) goto leave;
    ENTER;
do_MRET:
    mstatus_ = (mstatus_ & ~(riscv_mstatus::MIE | riscv_mstatus::MPIE)) | riscv_mstatus::MPIE |
               (mstatus_ & riscv_mstatus::MPIE ? riscv_mstatus::MIE : 0);
    pc = mepc_;
    ++returns_;
    ended_ |= pending_interrupt().has_value();
    if (ended_) return stop(RiscvStop::LIMIT);
    goto lookup;
do_WFI:
    ++op;
    if (is_pending()) ENTER;
    pc = page->pc_of(op);
    return stop(RiscvStop::WFI);
do_ECALL:
    trap_ = {riscv_cause::ECALL, 0};
    goto trapped;
do_EBREAK:
    trap_ = {riscv_cause::BREAKPOINT, page->pc_of(op)};
    goto trapped;
do_ILLEGAL:
    goto illegal;
#undef GO
#undef ENTER
#undef NEXT
#undef ALU
#undef BRANCH
#undef GO_ON
#undef LOAD
#undef STORE
#undef FLOATING
}

template RiscvStop RiscvCore::execute<false>(std::uint64_t most);
template RiscvStop RiscvCore::execute<true>(std::uint64_t most);

}  // namespace sim
