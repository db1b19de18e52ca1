#include "sim/cpu/disassembly.h"

#include <array>
#include <cctype>
#include <cstring>

#include <capstone/capstone.h>
#include <fmt/format.h>

namespace sim {

namespace {

// How the instructions begin, as Capstone writes them, that later processors have: division, the
// second version of VFP and NEON, virtualization, ARMv8-A.
constexpr const char* LATER[] = {
    "sdiv",      "udiv",   "vfma",      "vfms",      "vfnma",         "vfnms",
    "crc32",     "lda",    "stl",       "sha1",      "sha256",        "aes",
    "vmaxnm",    "vminnm", "vrint",     "vsel",      "vcvta",         "vcvtn",
    "vcvtp",     "vcvtm",  "vcvtb.f64", "vcvtt.f64", "vcvtb.f16.f64", "vcvtt.f16.f64",
    "vmull.p64", "hvc",    "eret",      "hlt",       "sevl",          "dcps",
};

}  // namespace

std::string disassembly(const ArmCore& core, std::uint32_t address) {
    std::array<std::uint8_t, 4> bytes{};
    std::size_t size = bytes.size();
    while (size > 0 && !core.read_ram(address, bytes.data(), size)) size -= 2;
    const bool thumb = core.cpsr() & arm_cpsr::T;
    csh engine;
    const int mode = (thumb ? CS_MODE_THUMB : CS_MODE_ARM) | CS_MODE_V8;
    if (cs_open(CS_ARCH_ARM, static_cast<cs_mode>(mode), &engine) != CS_ERR_OK) return "";
    cs_insn* instruction = nullptr;
    const std::size_t count = cs_disasm(engine, bytes.data(), size, address, 1, &instruction);
    std::string text;
    if (count > 0) {
        text = instruction->mnemonic;
        if (*instruction->op_str) text += std::string{" "} + instruction->op_str;
        cs_free(instruction, count);
    }
    cs_close(&engine);
    return text;
}

std::string absent_from_cortex_a9(const std::string& instruction) {
    for (const char* name : LATER) {
        if (instruction.compare(0, std::strlen(name), name) != 0) continue;
        std::string upper = name;
        for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        return upper + " is not in a Cortex-A9; build with -mcpu=cortex-a9";
    }
    return "";
}

}  // namespace sim
