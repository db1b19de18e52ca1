// file_kind.cpp - see file_kind.h
#include "sim/run/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "sim/cpu/elf.h"
#include "sim/process/shell_word.h"

namespace sim {

namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// Where de1sim's examples are, with their start-up: beside this program, installed or built.
fs::path examples() {
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
    for (const fs::path& place : {self / "share/de1sim/examples", self / "examples"})
        if (fs::is_regular_file(place / "start.S", error)) return place;
    return "/usr/share/de1sim/examples";
}

// A file in a command.
std::string word(const fs::path& file) { return shell_word(file.string()); }

std::string elf_of(const fs::path& file) { return word(fs::path{file}.replace_extension(".elf")); }

// The commands that make a program of `file` and run it.
std::string built(const fs::path& file, bool assembly, bool cpp) {
    const fs::path from = examples();
    const std::string elf = elf_of(file);
    const std::string runs = fmt::format("-o {} && de1sim {}", elf, elf);
    if (assembly)
        return fmt::format(
            "arm-none-eabi-gcc -mcpu=cortex-a9 -mfpu=neon -g {} -nostartfiles -T {} {}", word(file),
            word(from / "program.ld"), runs);
    return fmt::format(
        "arm-none-eabi-gcc -mcpu=cortex-a9 -mfpu=neon -mfloat-abi=soft -g -O1 {} "
        "{} {} -nostartfiles -Wl,-u,exit -T {} {}-lm {}",
        word(file), word(from / "course/syscalls.c"), word(from / "start.S"),
        word(from / "course/memory.ld"), cpp ? "-lstdc++ " : "", runs);
}

std::string folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path().string() : ".";
}

// The Quartus project that `file` seems to belong to: of its folder or the one above it.
std::string project_of(const fs::path& file) {
    std::error_code error;
    const fs::path folder = folder_of(file);
    for (const fs::path& place : {folder, folder / ".."}) {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator{place, error})
            if (lower(entry.path().extension().string()) == ".qsf") found.push_back(entry.path());
        if (!found.empty())
            return std::min_element(found.begin(), found.end())->lexically_normal().string();
    }
    return "PROJECT.qsf";
}

std::string played(const std::string& project) {
    return fmt::format("de1sim live --project {0}, or de1sim run SCENARIO.yaml --project {0}",
                       shell_word(project));
}

bool is_one_of(const std::string& ending, std::initializer_list<const char*> endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::string begin_of(const fs::path& file) {
    std::array<char, 4096> bytes;
    std::ifstream in{file, std::ios::binary};
    in.read(bytes.data(), bytes.size());
    return {bytes.data(), static_cast<std::size_t>(in.gcount())};
}

// By its first bytes; "" if they do not tell.
std::string kind_by_bytes(const fs::path& file, const std::string& begin) {
    constexpr const char* NO_ELF = "is {}, not a program (ELF file)";
    const std::pair<const char*, const char*> magics[] = {
        {"\x89PNG", "a picture"},        {"\xFF\xD8\xFF", "a picture"},
        {"PK\x03\x04", "a ZIP archive"}, {"\x1F\x8B", "a compressed file"},
        {"%PDF", "a PDF document"},      {"RIFF", "a sound file or film"},
        {"MZ", "a program for Windows"}};
    for (const auto& [magic, name] : magics)
        if (begin.rfind(magic, 0) == 0) return fmt::format(NO_ELF, name);
    if (begin.rfind("!<arch>", 0) == 0)
        return fmt::format("is a library, not a program: link it, as in arm-none-eabi-gcc ... {}",
                           word(file));
    if (begin.rfind("#!", 0) == 0) return "is a script: bash " + word(file) + " runs it";
    return "";
}

// Calls that only Linux answers.
bool is_for_linux(const std::string& source) {
    const auto has = [&](const char* text) { return source.find(text) != std::string::npos; };
    return has("sys/mman.h") || has("pthread.h") || has("sys/socket.h") || has("fcntl.h");
}

// By the end of its name; "" if that does not tell.
std::string kind_by_name(const fs::path& file, const std::string& begin) {
    const std::string ending = lower(file.extension().string()), name = file.string();
    if (ending == ".c" && is_for_linux(begin)) {
        const std::string program = word(fs::path{file}.replace_extension(""));
        return fmt::format(
            "is C source, not a program: build it, for the board's Linux: arm-linux-gnueabihf-gcc "
            "-static {} -o {} -lpthread -lm && de1sim {}",
            word(file), program, program);
    }
    if (ending == ".c")
        return "is C source, not a program: build it, for example: " + built(file, false, false);
    if (is_one_of(ending, {".cpp", ".cc", ".cxx", ".c++"}))
        return "is C++ source, not a program: build it, for example: " + built(file, false, true);
    if (ending == ".s" || ending == ".asm")
        return "is assembly source, not a program: build it, for example: " +
               built(file, true, false);
    if (is_one_of(ending, {".h", ".hpp", ".ld"}))
        return "is a part of a program's source: build the program, and run its ELF file";
    if (is_one_of(ending, {".bin", ".img"}))
        return fmt::format(
            "is an image of memory, without addresses: run the ELF file that it was made of, or "
            "make one, here for address 0: arm-none-eabi-objcopy -I binary -O elf32-littlearm -B "
            "arm --rename-section .data=.text,code,alloc,load,contents,readonly {} image.o && "
            "arm-none-eabi-ld -Ttext=0 -e 0 image.o -o {} && de1sim {}",
            word(file), elf_of(file), elf_of(file));
    if (is_one_of(ending, {".hex", ".ihex", ".ihx", ".srec", ".s19", ".s28", ".s37", ".mot"}))
        return fmt::format(
            "is an image of memory in text, not a program: run the ELF file that it was made of "
            "({})",
            elf_of(file));
    if (is_one_of(ending, {".sof", ".rbf", ".pof", ".jic", ".jam", ".svf"}))
        return "is a bitstream; de1sim runs the design that it was made of: " +
               played(project_of(file));
    if (is_one_of(ending, {".v", ".sv", ".vh", ".svh", ".vhd", ".vhdl"}))
        return "is a design's source: its folder or Quartus project runs: " +
               played(project_of(file) == "PROJECT.qsf" ? folder_of(file) : project_of(file));
    if (is_one_of(ending, {".qsf", ".qpf"})) return "is a Quartus project: " + played(name);
    if (is_one_of(ending, {".qip", ".qsys", ".sdc", ".mif", ".bdf", ".tcl"}))
        return "is a part of a Quartus project: " + played(project_of(file));
    if (is_one_of(ending, {".amp", ".ncf"}))
        return fmt::format(
            "is a project of Intel's Monitor Program: copy {}, put its source files there, make, "
            "and run course.elf",
            word(examples() / "course"));
    return "";
}

std::string what_it_is(const fs::path& file, bool may_be_text) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) return "is not there";
    if (fs::is_directory(status)) {
        const std::string folder = word(file);
        return may_be_text ? fmt::format(
                                 "is a folder: for one of scenarios: de1sim test {0}; for "
                                 "one of Verilog: de1sim live --project {0}",
                                 folder)
                           : "is a folder, not a program (ELF file)";
    }
    if (!fs::is_regular_file(status)) return "";  // a pipe is read by nobody twice
    const std::string begin = begin_of(file), ending = lower(file.extension().string());
    const bool yaml = is_one_of(ending, {".yaml", ".yml"});
    if (may_be_text && yaml) return "";
    if (const std::string kind = kind_by_bytes(file, begin); !kind.empty()) return kind;
    if (const std::string kind = kind_by_name(file, begin); !kind.empty()) return kind;
    if (begin.empty() && !may_be_text) return "is empty, not a program (ELF file)";
    if (begin.find('\0') != std::string::npos || (!may_be_text && !yaml))
        return may_be_text ? "is neither a program (ELF file) nor a scenario (YAML)"
                           : "is not a program (ELF file)";
    return may_be_text ? "" : "is a scenario, not a program (ELF file): de1sim run " + word(file);
}

}  // namespace

void refuse_other_kinds(const fs::path& file) {
    if (is_elf(file)) return;
    const std::string kind = what_it_is(file, true);
    if (!kind.empty()) throw std::runtime_error{file.string() + ": " + kind};
}

void refuse_no_program(const fs::path& file) {
    if (is_elf(file)) return;
    const std::string kind = what_it_is(file, false);
    if (!kind.empty()) throw std::runtime_error{file.string() + ": " + kind};
}

}  // namespace sim
