// gen_regmap.cpp - prints the other views of regmap.def:
//   gen_regmap vh   regmap.vh, included by the RTL
//   gen_regmap md   REGISTERS.md, for people
#include <cstdio>
#include <cstring>

#include "regmap.h"

namespace {

void print_verilog() {
    std::puts("// regmap.vh - generated from regmap.def by `make regmap`; do not edit.");
    std::puts("// Every module uses a few of these constants.");
    std::puts("// verilator lint_off UNUSEDPARAM");
    std::printf("localparam [31:0] REGMAP_HASH = 32'h%08x;\n", regmap::REGMAP_HASH);
#define BLOCK(b, base, size)                                            \
    std::printf("\nlocalparam [31:0] %s_BASE = 32'h%08x;\n", #b, base); \
    std::printf("localparam [31:0] %s_SIZE = 32'h%08x;\n", #b, size);
#define REG(b, r, offset, access, reset)                                           \
    std::printf("localparam [31:0] %s_%s = 32'h%08x;\n", #b, #r, regmap::b##_##r); \
    std::printf("localparam [31:0] %s_%s_RESET = 32'h%08x;\n", #b, #r, reset);
#define FIELD(b, r, f, lsb, width)                                   \
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

void print_markdown() {
    std::puts("# Registers\n");
    std::puts("Generated from regmap.def by `make regmap`; do not edit. Comments stand there.\n");
    std::puts("| register | address | access | reset | fields |\n|---|---|---|---|---|");
    const char* const access[] = {"RO", "RW", "WO"};
    for (const auto& reg : regmap::REGS) {
        std::printf("| `%s` | `0x%08X` | %s | `0x%08X` |", reg.name, reg.addr,
                    access[static_cast<int>(reg.access)], reg.reset);
        for (const auto& field : regmap::FIELDS) {
            if (std::strcmp(field.reg, reg.name) != 0) continue;
            if (field.width == 1)
                std::printf(" %s[%u]", field.name, field.lsb);
            else
                std::printf(" %s[%u:%u]", field.name, field.lsb + field.width - 1, field.lsb);
        }
        std::puts(" |");
    }
    std::printf("\n`SYSID_HASH` reads `0x%08X` for this map.\n", regmap::REGMAP_HASH);
    std::puts("\n| window | base | bytes |\n|---|---|---|");
    for (const auto& block : regmap::BLOCKS)
        std::printf("| %s | `0x%08X` | `0x%X` |\n", block.name, block.base, block.size);
    std::puts("\n| interrupt | GIC ID |\n|---|---|");
#define BLOCK(b, base, size)
#define REG(b, r, offset, access, reset)
#define FIELD(b, r, f, lsb, width)
#define IRQ(name, id) std::printf("| %s | %d |\n", #name, id);
#include "regmap.def"
#undef BLOCK
#undef REG
#undef FIELD
#undef IRQ
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "vh") == 0) return print_verilog(), 0;
    if (argc == 2 && std::strcmp(argv[1], "md") == 0) return print_markdown(), 0;
    std::fprintf(stderr, "usage: gen_regmap vh|md\n");
    return 2;
}
