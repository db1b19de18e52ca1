// ELF files: a real one, truncated and corrupted in every way that the loader must detect.
#include <gmock/gmock.h>

#include <elf.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>

#include "sim/cpu/elf.h"
#include "tb/support/temp_folder.h"

namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<sim::MemoryRange> memory{{0, 0x40000000}, {0xFFFF0000, 0x10000}};

class ElfFile : public ::testing::Test {
protected:
    const TempFolder folder;
    std::string good = [] {
        std::ifstream in{PROGRAM_ELF, std::ios::binary};
        return std::string{std::istreambuf_iterator<char>{in}, {}};
    }();

    sim::ElfProgram load(const std::string& bytes) const {
        folder.put("a.elf", bytes);
        return sim::load_elf(folder / "a.elf", memory);
    }
    // The message of both functions that read a file.
    std::string refusal(const std::string& bytes) const {
        try {
            load(bytes);
            sim::expects_linux(folder / "a.elf");
            return "loaded";
        } catch (const sim::ElfError& e) {
            return e.what();
        }
    }
    std::string with_header(const std::function<void(Elf32_Ehdr&)>& change) const {
        std::string bytes = good;
        change(*reinterpret_cast<Elf32_Ehdr*>(bytes.data()));
        return bytes;
    }
    // Changes the program header of the `index`th PT_LOAD.
    std::string with_segment(unsigned index, const std::function<void(Elf32_Phdr&)>& change) const {
        std::string bytes = good;
        const auto& header = *reinterpret_cast<const Elf32_Ehdr*>(bytes.data());
        auto* segment = reinterpret_cast<Elf32_Phdr*>(bytes.data() + header.e_phoff);
        for (;; ++segment)
            if (segment->p_type == PT_LOAD && index-- == 0) break;
        change(*segment);
        return bytes;
    }
};

TEST_F(ElfFile, IsLoadedWithSegmentsAndEntry) {
    const sim::ElfProgram program = load(good);
    EXPECT_EQ(program.entry, 0x0u);
    ASSERT_GE(program.segments.size(), 2u);
    EXPECT_EQ(program.segments[0].physical, 0u);
    std::uint32_t first = 0;
    std::memcpy(&first, program.segments[0].data.data(), 4);
    EXPECT_EQ(first >> 24, 0xEAu) << "a branch, the reset vector";
}

TEST_F(ElfFile, BeginsWhereItsHeaderSays) {
    for (const std::uint32_t entry : {0x10u, 0x11u})  // ARM, Thumb
        EXPECT_EQ(load(with_header([entry](Elf32_Ehdr& h) { h.e_entry = entry; })).entry, entry);
}

TEST_F(ElfFile, IsLoadedToItsPhysicalAddresses) {
    const sim::ElfSegment before = load(good).segments[1];
    const sim::ElfProgram program = load(with_segment(1, [](Elf32_Phdr& s) {
        s.p_paddr = 0x02000000;
        s.p_vaddr = 0x30000000;
    }));
    EXPECT_EQ(program.segments[1].physical, 0x02000000u);
    EXPECT_EQ(program.segments[1].address, 0x30000000u);
    EXPECT_EQ(program.segments[1].data, before.data);
    EXPECT_EQ(program.segments[0].physical, 0u);
}

TEST_F(ElfFile, HasItsEntryAmongTheAddressesAtWhichItRuns) {
    const auto moved = [this](std::uint32_t entry) {
        std::string bytes = with_segment(0, [](Elf32_Phdr& s) { s.p_vaddr = 0x30000000; });
        reinterpret_cast<Elf32_Ehdr*>(bytes.data())->e_entry = entry;
        return bytes;
    };
    EXPECT_EQ(load(moved(0x30000004)).entry, 0x30000004u);
    EXPECT_THAT(refusal(moved(0x4)), HasSubstr("its entry point 0x00000004 is in no executable"));
}

TEST_F(ElfFile, NamesTheFunctionAroundAnAddress) {
    const sim::ElfProgram program = load(good);
    for (const sim::ElfFunction& f : program.functions)
        if (f.name == "main") {
            EXPECT_EQ(program.function(f.address), "main");
            EXPECT_EQ(program.function(f.address + 4), "main+0x4");
        }
    EXPECT_EQ(program.function(0x30000000), "");
}

TEST_F(ElfFile, LeavesOutWhatIsInNoSection) {
    sim::ElfProgram program = load(good);
    const std::vector<std::uint8_t> before = program.segments[1].data;
    ASSERT_GE(before.size(), 12u);
    program.sections = {{program.segments[1].address + 4, 4, ".text", false, true}};
    program.leave_only_sections();
    std::vector<std::uint8_t> expected(before.size());
    std::copy_n(before.begin() + 4, 4, expected.begin() + 4);
    EXPECT_EQ(program.segments[1].data, expected);

    program = load(good);
    program.sections.clear();
    program.leave_only_sections();
    EXPECT_EQ(program.segments[1].data, before);
}

TEST_F(ElfFile, IsRefusedOrLoadedWhereverItIsCutOff) {
    for (std::size_t length = 0; length < good.size(); length += length < 256 ? 1 : 97) {
        const std::string said = refusal(good.substr(0, length));
        EXPECT_THAT(said, StartsWith((folder / "a.elf").string() + ": ")) << length;
    }
}

TEST_F(ElfFile, IsRefusedOrLoadedWithAnyHeaderByteChanged) {
    for (std::size_t at = 0; at < 52 + 4 * 32; ++at)
        for (const int value : {0x00, 0x7f, 0x80, 0xff}) {
            std::string bytes = good;
            bytes[at] = static_cast<char>(value);
            refusal(bytes);
        }
}

TEST_F(ElfFile, ThatIsNoneIsRefused) {
    EXPECT_THAT(refusal("#!/bin/sh\n#0123456789"), HasSubstr(": not an ELF file"));
    EXPECT_THAT(refusal(""), HasSubstr(": not an ELF file"));
}

TEST_F(ElfFile, ThatIsNotThereOrAFolderIsNamed) {
    EXPECT_THROW(sim::load_elf(folder / "none.elf", memory), sim::ElfError);
    EXPECT_THROW(sim::load_elf(folder.path(), memory), sim::ElfError);
}

TEST_F(ElfFile, ForAnotherMachineIsRefused) {
    EXPECT_THAT(
        refusal(with_header([](Elf32_Ehdr& h) { h.e_machine = EM_386; })),
        HasSubstr("for another machine (x86), expected ARM: build it with arm-none-eabi-gcc"));
}

TEST_F(ElfFile, ForNiosIIIsRefusedAndSaysSo) {
    EXPECT_THAT(refusal(with_header([](Elf32_Ehdr& h) { h.e_machine = EM_ALTERA_NIOS2; })),
                HasSubstr("for Nios II, which is not simulated, expected ARM or Nios V"));
}

TEST_F(ElfFile, ForRiscVIsLoaded) {
    folder.put("a.elf", with_header([](Elf32_Ehdr& h) {
                   h.e_machine = EM_RISCV;
                   h.e_flags = 0;
               }));
    EXPECT_EQ(sim::machine_of(folder / "a.elf"), sim::ElfMachine::RISCV);
    EXPECT_NO_THROW(sim::load_elf(folder / "a.elf", memory));
}

TEST_F(ElfFile, ForRiscVIsRefusedWithTheSameReasonWhenItsMachineIsAskedFor) {
    constexpr std::uint32_t COMPRESSED = 1;  // EF_RISCV_RVC
    const auto refused = [&](unsigned type, std::uint32_t flags) -> std::string {
        folder.put("a.elf", with_header([&](Elf32_Ehdr& h) {
                       h.e_type = static_cast<Elf32_Half>(type);
                       h.e_machine = EM_RISCV;
                       h.e_flags = flags;
                   }));
        try {
            sim::machine_of(folder / "a.elf");
        } catch (const sim::ElfError& error) {
            return error.what();
        }
        return "";
    };
    const char* const compressed = "has compressed instructions, which Nios V does not have";
    EXPECT_THAT(refused(ET_EXEC, COMPRESSED), HasSubstr(compressed));
    EXPECT_THROW(sim::load_elf(folder / "a.elf", memory), sim::ElfError);
    EXPECT_THAT(refused(ET_DYN, COMPRESSED), HasSubstr(compressed));
    EXPECT_THAT(refused(ET_DYN, 0), HasSubstr("link it with -static -no-pie"));
}

TEST_F(ElfFile, Of64BitsIsRefused) {
    EXPECT_THAT(refusal(with_header([](Elf32_Ehdr& h) { h.e_ident[EI_CLASS] = ELFCLASS64; })),
                HasSubstr("64-bit"));
    EXPECT_THAT(refusal(with_header([](Elf32_Ehdr& h) {
                    h.e_ident[EI_CLASS] = ELFCLASS64;
                    h.e_machine = EM_RISCV;
                })),
                HasSubstr("for Nios V: build it with -march=rv32im_zicsr"));
}

TEST_F(ElfFile, OfTheOtherByteOrderIsRefused) {
    EXPECT_THAT(refusal(with_header([](Elf32_Ehdr& h) { h.e_ident[EI_DATA] = ELFDATA2MSB; })),
                HasSubstr("big-endian"));
}

TEST_F(ElfFile, ThatIsNotLinkedIsRefused) {
    EXPECT_THAT(refusal(with_header([](Elf32_Ehdr& h) { h.e_type = ET_REL; })),
                HasSubstr("not an executable (type 1)"));
}

TEST_F(ElfFile, ThatIsPositionIndependentIsMovedForLinux) {
    const std::vector<sim::MemoryRange> linux_memory{{0x1000, 0xBEFFF000}};
    constexpr std::uint32_t ENTRY = 0x10, BASE = sim::POSITION_INDEPENDENT_BASE;
    const auto movable = [&](std::uint32_t entry) {
        folder.put("a.elf", with_header([entry](Elf32_Ehdr& h) {
                       h.e_type = ET_DYN;
                       h.e_entry = entry;
                   }));
        return sim::load_elf(folder / "a.elf", linux_memory, sim::Linking::ANY);
    };
    const sim::ElfProgram moved = movable(ENTRY), before = load(good);
    EXPECT_EQ(moved.entry, BASE + ENTRY);
    ASSERT_EQ(moved.segments.size(), before.segments.size());
    EXPECT_EQ(moved.segments[0].address, before.segments[0].address + BASE);
    EXPECT_EQ(moved.function(BASE + ENTRY), before.function(ENTRY));
    EXPECT_THROW(movable(0), sim::ElfError) << "a shared library";
}

TEST_F(ElfFile, WithoutALinuxIsRefusedWhereItIsDynamic) {
    EXPECT_THAT(refusal(with_header([](Elf32_Ehdr& h) { h.e_type = ET_DYN; })),
                HasSubstr("dynamically linked"));
    EXPECT_THAT(refusal(with_segment(1, [](Elf32_Phdr& s) { s.p_type = PT_INTERP; })),
                HasSubstr("dynamically linked"));
}

TEST_F(ElfFile, WithSegmentsThatOverlapIsRefused) {
    EXPECT_THAT(refusal(with_segment(1, [](Elf32_Phdr& s) { s.p_paddr = 0x10; })),
                HasSubstr("overlaps the one at 0x00000000"));
}

TEST_F(ElfFile, WithASegmentOutsideOfMemoryIsRefused) {
    EXPECT_THAT(refusal(with_segment(1, [](Elf32_Phdr& s) { s.p_paddr = 0x80000000; })),
                HasSubstr("its segment 0x80000000"));
    EXPECT_THAT(refusal(with_segment(1, [](Elf32_Phdr& s) { s.p_memsz = 0xFFFFFFFF; })),
                HasSubstr("is not in the memory"));
}

TEST_F(ElfFile, WithMoreInTheFileThanInMemoryIsRefused) {
    EXPECT_THAT(refusal(with_segment(0, [](Elf32_Phdr& s) { s.p_memsz = s.p_filesz - 1; })),
                HasSubstr("more bytes in the file than in memory"));
}

TEST_F(ElfFile, WithItsEntryElsewhereIsRefused) {
    EXPECT_THAT(refusal(with_header([](Elf32_Ehdr& h) { h.e_entry = 0x00900000; })),
                HasSubstr("its entry point 0x00900000 is in no executable segment"));
}

}  // namespace
