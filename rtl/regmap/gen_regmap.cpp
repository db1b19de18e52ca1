// gen_regmap.cpp - prints the other views of regmap.def:
//   gen_regmap vh       regmap.vh, included by the RTL
//   gen_regmap decode   lw_decode.vh, which block owns an address on the lightweight bridge
//   gen_regmap md       REGISTERS.md, for people
//   gen_regmap de10     DE10_LITE.md, the DE10-Lite Computer's
//   gen_regmap c        sw/examples/registers.h, for programs in C
#include <cstdio>
#include <cstring>
#include <vector>

#include "de10_lite.h"
#include "regmap.h"

namespace {

void print_verilog() {
    std::puts("// regmap.vh - generated from regmap.def by `make regmap`; do not edit.");
    std::puts("// Every module uses a few of these constants.");
    std::puts("// verilator lint_off UNUSEDPARAM");
    std::printf("localparam [31:0] REGMAP_HASH = 32'h%08x;\n", regmap::REGMAP_HASH);
    std::puts("\n// Select lines of the lightweight bridge.");
    for (const auto& block : regmap::BLOCKS)
        if (regmap::on_lightweight_bridge(block))
            std::printf("localparam SEL_%s = %d;\n", block.name, regmap::select(block));
#define BLOCK(b, base, size, text)                                      \
    std::printf("\nlocalparam [31:0] %s_BASE = 32'h%08x;\n", #b, base); \
    std::printf("localparam [31:0] %s_SIZE = 32'h%08x;\n", #b, size);
#define REG(b, r, offset, access, reset, text)                                     \
    std::printf("localparam [31:0] %s_%s = 32'h%08x;\n", #b, #r, regmap::b##_##r); \
    std::printf("localparam [31:0] %s_%s_RESET = 32'h%08x;\n", #b, #r, reset);
#define FIELD(b, r, f, lsb, width, text)                             \
    std::printf("localparam %s_%s_%s_LSB = %d;\n", #b, #r, #f, lsb); \
    std::printf("localparam %s_%s_%s_W = %d;\n", #b, #r, #f, width);
#define IRQ(name, id) std::printf("\nlocalparam %s_IRQ = %d;  // GIC ID %d\n", #name, id - 72, id);
#include "regmap.def"
#undef BLOCK
#undef REG
#undef FIELD
#undef IRQ
    std::puts("// verilator lint_on UNUSEDPARAM");
}

int log2(std::uint32_t size) {
    int bits = 0;
    while (size >>= 1) ++bits;
    return bits;
}

void print_decoder() {
    std::puts("// lw_decode.vh - generated from regmap.def by `make regmap`; do not edit.");
    std::puts("// The select line of the block that gets an access on the lightweight bridge.\n");
    std::printf("function [%d:0] line_of;\n", regmap::LW_SELECTS - 1);
    std::puts("    // All registers are words, and the upper bits are not looked at.");
    std::puts("    // verilator lint_off UNUSED");
    std::printf("    input [%d:0] addr;\n", log2(regmap::LW_SIZE) - 1);
    std::puts("    // verilator lint_on UNUSED\n    input write;\n    begin");
    std::printf("        line_of = %d'd0;\n", regmap::LW_SELECTS);
    for (const auto& block : regmap::BLOCKS) {
        if (!regmap::on_lightweight_bridge(block)) continue;
        const int top = log2(regmap::LW_DECODED) - 1, low = log2(block.size);
        std::printf("        line_of[SEL_%s] = %saddr[%d:%d] == %s_BASE[%d:%d];\n", block.name,
                    regmap::takes_writes(block) ? "" : "!write && ", top, low, block.name, top,
                    low);
    }
    std::printf("        if (line_of == %d'd0) line_of[SEL_%s] = 1'b1;\n", regmap::LW_SELECTS,
                regmap::lw_default().name);
    std::puts("    end\nendfunction");
}

// The interrupt of the block of that name; 0: none.
unsigned interrupt_of(const char* name) {
#define BLOCK(b, base, size, text)
#define REG(b, r, offset, access, reset, text)
#define FIELD(b, r, f, lsb, width, text)
#define IRQ(irq, id) \
    if (std::strcmp(#irq, name) == 0) return id;
#include "regmap.def"
#undef BLOCK
#undef REG
#undef FIELD
#undef IRQ
    return 0;
}

using Regs = std::vector<regmap::Reg>;
using Fields = std::vector<regmap::Field>;

void print_block(const regmap::Block& block, unsigned interrupt, const Regs& regs,
                 const Fields& fields) {
    std::printf("\n## %s\n\n`0x%08X`, `0x%X` bytes", block.name, block.base, block.size);
    if (interrupt) std::printf("; interrupt %u", interrupt);
    std::printf(": %s.\n", block.text);
    const char* const access[] = {"RO", "RW", "WO"};
    bool first = true;
    for (const auto& reg : regs) {
        if (reg.addr - block.base >= block.size) continue;
        if (first) std::puts("\n| register | address | access | reset | |\n|---|---|---|---|---|");
        first = false;
        std::printf("| `%s` | `0x%08X` | %s | `0x%08X` | %s |\n", reg.name, reg.addr,
                    access[static_cast<int>(reg.access)], reg.reset, reg.text);
        for (const auto& field : fields) {
            if (std::strcmp(field.reg, reg.name) != 0) continue;
            if (field.width == 1)
                std::printf("| %s | bit %u", field.name, field.lsb);
            else
                std::printf("| %s | bits %u:%u", field.name, field.lsb + field.width - 1,
                            field.lsb);
            std::printf(" | | | %s |\n", field.text);
        }
    }
}

const Regs REGS_OF_DE1{std::begin(regmap::REGS), std::end(regmap::REGS)};
const Fields FIELDS_OF_DE1{std::begin(regmap::FIELDS), std::end(regmap::FIELDS)};

void print_markdown() {
    std::puts("# Registers\n");
    std::puts("Generated from regmap.def by `make regmap`; do not edit.");
    std::printf("`SYSID_HASH` reads `0x%08X` for this map.\n", regmap::REGMAP_HASH);
    std::puts(
        "\nA block reads 0 and loses writes where it has no register; a read-only register loses");
    std::puts(
        "writes.  Addresses without a block, and writes to a block that can only be read, go to");
    std::printf("%s on the lightweight bridge, and to the SDRAM on the full bridge; addresses\n",
                regmap::lw_default().name);
    std::printf("repeat each %u KB and each 256 MB.  A run reports it, once per place.\n",
                regmap::LW_DECODED / 1024);
    for (const auto& block : regmap::BLOCKS)
        print_block(block, interrupt_of(block.name), REGS_OF_DE1, FIELDS_OF_DE1);
}

void print_de10_lite() {
    using namespace regmap::de10_lite;
    std::puts("# Registers of the DE10-Lite Computer with Nios V\n");
    std::puts("Generated from de10_lite.def by `make regmap`; do not edit.");
    std::puts("`de1sim --board de10-lite prog.elf` has them.\n");
    std::puts(
        "A block reads 0 and loses writes where it has no register; a read-only register loses");
    std::puts(
        "writes.  Addresses without a block, and writes to a block that can only be read, go to");
    std::puts(
        "the SDRAM, of which they have the lower 26 bits.  A run reports it, once per place.");
    std::puts("Interrupts are bits of `mie` and `mip`.");
    for (const auto& block : OWN_AND_SAME) {
        unsigned interrupt = 0;
        for (const Line& line : LINES)
            if (std::strcmp(line.block, block.name) == 0) interrupt = line.number;
        if (is_same(block))
            print_block(block, interrupt, REGS_OF_DE1, FIELDS_OF_DE1);
        else
            print_block(block, interrupt, {std::begin(OWN_REGS), std::end(OWN_REGS)},
                        {std::begin(OWN_FIELDS), std::end(OWN_FIELDS)});
    }
}

void print_c() {
    std::puts(
        "// registers.h - the registers of the FPGA, by the names of rtl/regmap/REGISTERS.md");
    std::puts("//\n// Generated from regmap.def by `make regmap`; do not edit.");
    std::puts("#pragma once\n\n#include <stdint.h>\n");
    std::puts("#define REGISTER(address) (*(volatile uint32_t*)(address))\n");
    for (const auto& reg : regmap::REGS)
        std::printf("#define %s REGISTER(0x%08X)\n", reg.name, reg.addr);
}

}  // namespace

int main(int argc, char** argv) {
    const char* const view = argc == 2 ? argv[1] : "";
    if (std::strcmp(view, "vh") == 0) return print_verilog(), 0;
    if (std::strcmp(view, "decode") == 0) return print_decoder(), 0;
    if (std::strcmp(view, "md") == 0) return print_markdown(), 0;
    if (std::strcmp(view, "de10") == 0) return print_de10_lite(), 0;
    if (std::strcmp(view, "c") == 0) return print_c(), 0;
    std::fprintf(stderr, "usage: gen_regmap vh|decode|md|de10|c\n");
    return 2;
}
