#include "sim/cpu/elf.h"

#include <cxxabi.h>
#include <gelf.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr std::uint64_t MAX_BYTES = 256u << 20;

constexpr std::size_t EM_AT = 18;  // the machine's number, low byte first
constexpr const char* BUILD =
    "build it with arm-none-eabi-gcc, for Linux with arm-linux-gnueabihf-gcc, or for Nios V with "
    "riscv64-unknown-elf-gcc -march=rv32im_zicsr -mabi=ilp32";
constexpr const char* NIOS_V_BUILD = "build it with -march=rv32im_zicsr -mabi=ilp32";
constexpr std::uint32_t COMPRESSED = 1;  // EF_RISCV_RVC

std::string machine(unsigned number) {
    switch (number) {
        case EM_X86_64: return "x86-64, this computer's";
        case EM_386: return "x86";
        case EM_AARCH64: return "64-bit ARM";
        case EM_ALTERA_NIOS2: return "Nios II";
        case EM_RISCV: return "RISC-V";
        default: return fmt::format("number {}", number);
    }
}

struct ElfEnd {
    void operator()(Elf* elf) const { elf_end(elf); }
};
using ElfHandle = std::unique_ptr<Elf, ElfEnd>;

class Reader {
public:
    Reader(const std::filesystem::path& file, const std::vector<MemoryRange>& memory,
           Linking linking)
        : file_{file}, memory_{memory}, linking_{linking} {}

    ElfProgram load() {
        open();
        ElfProgram program;
        program.file = file_;
        program.entry = header_->e_entry;
        read_segments(program);
        read_sections(program);
        read_functions(program);
        program.movable = is_movable();
        if (program.movable) program.move(POSITION_INDEPENDENT_BASE);
        return program;
    }

    ElfMachine machine_of() {
        open();
        return header_->e_machine == EM_RISCV ? ElfMachine::RISCV : ElfMachine::ARM;
    }

    bool expects_linux() {
        open();
        if (header_->e_ident[EI_OSABI] == ELFOSABI_LINUX) return true;
        const std::vector<Elf32_Phdr> headers = program_headers();
        return std::any_of(headers.begin(), headers.end(), [this](const Elf32_Phdr& header) {
            return header.p_type == PT_INTERP || has_linux_tag(header);
        });
    }

private:
    void open() {
        read_file();
        elf_version(EV_CURRENT);
        elf_.reset(elf_memory(bytes_.data(), bytes_.size()));
        check_header();
    }

    // An ABI tag is a note of 4 words, the first of which is the system: 0 is Linux.
    bool has_linux_tag(const Elf32_Phdr& header) const {
        if (header.p_type != PT_NOTE) return false;
        Elf_Data* notes =
            elf_getdata_rawchunk(elf_.get(), header.p_offset, header.p_filesz, ELF_T_NHDR);
        if (!notes) return false;
        GElf_Nhdr note;
        std::size_t name = 0, words = 0;
        for (std::size_t at = 0; (at = gelf_getnote(notes, at, &note, &name, &words)) > 0;) {
            const auto* bytes = static_cast<const char*>(notes->d_buf);
            if (note.n_type == NT_GNU_ABI_TAG && note.n_namesz == sizeof ELF_NOTE_GNU &&
                note.n_descsz >= 16 &&
                std::memcmp(bytes + name, ELF_NOTE_GNU, sizeof ELF_NOTE_GNU) == 0)
                return std::memcmp(bytes + words, "\0\0\0", 4) == 0;
        }
        return false;
    }

    template <class... Args>
    [[noreturn]] void refuse(fmt::format_string<Args...> format, Args&&... args) const {
        throw ElfError{file_.string() + ": " + fmt::format(format, std::forward<Args>(args)...)};
    }

    void read_file() {
        std::error_code error;
        if (std::filesystem::is_directory(file_, error)) refuse("is a folder");
        std::ifstream in{file_, std::ios::binary};
        if (!in && errno == ENOENT) refuse("is not there");
        if (!in) refuse("cannot read: {}", std::strerror(errno));
        char block[65536];
        while (in.read(block, sizeof block), in.gcount() > 0) {
            bytes_.insert(bytes_.end(), block, block + in.gcount());
            if (bytes_.size() > MAX_BYTES) refuse("is larger than {} bytes", MAX_BYTES);
        }
    }

    void check_header() {
        const auto* ident = reinterpret_cast<const unsigned char*>(bytes_.data());
        if (bytes_.size() < EI_NIDENT || std::memcmp(ident, ELFMAG, SELFMAG) != 0)
            refuse("not an ELF file");
        if (ident[EI_CLASS] == ELFCLASS64) {
            const unsigned number = bytes_.size() > EM_AT ? ident[EM_AT] : EM_NONE;
            if (number == EM_RISCV)
                refuse("a 64-bit ELF file (RISC-V), expected 32 bits for Nios V: {}", NIOS_V_BUILD);
            refuse("a 64-bit ELF file ({}), expected 32 bits for the board's ARM: {}",
                   machine(number), BUILD);
        }
        if (ident[EI_DATA] == ELFDATA2MSB) refuse("a big-endian ELF file, expected little-endian");
        header_ = elf_ ? elf32_getehdr(elf_.get()) : nullptr;
        if (!header_) refuse("a damaged ELF file: {}", elf_errmsg(-1));
        check_machine();
        if (is_movable() && linking_ == Linking::STATIC)
            refuse(
                "dynamically linked or position-independent, expected a static executable: link "
                "it with -static");
        if (is_movable() && header_->e_entry == 0 && linking_ != Linking::LIBRARY)
            refuse("a shared library, expected a program");
        if (header_->e_type != ET_EXEC && !is_movable())
            refuse(
                "not an executable (type {}): an object file, not linked yet: leave out -c, or "
                "link it as the examples' Makefile does",
                header_->e_type);
        const auto inside = [this](std::uint64_t offset, std::uint64_t bytes) {
            return offset <= bytes_.size() && bytes <= bytes_.size() - offset;
        };
        if (!inside(header_->e_phoff, std::uint64_t{header_->e_phnum} * sizeof(Elf32_Phdr)) ||
            !inside(header_->e_shoff, std::uint64_t{header_->e_shnum} * sizeof(Elf32_Shdr)))
            refuse("is cut off: its tables lie beyond its end");
    }

    void check_machine() const {
        const unsigned number = header_->e_machine;
        if (number == EM_ALTERA_NIOS2)
            refuse(
                "for Nios II, which is not simulated, expected ARM or Nios V: the same C source "
                "can mostly be built for these: {}",
                BUILD);
        if (number != EM_ARM && number != EM_RISCV)
            refuse("for another machine ({}), expected ARM: {}", machine(number), BUILD);
        if (number == EM_RISCV && (header_->e_flags & COMPRESSED))
            refuse("has compressed instructions, which Nios V does not have: {}", NIOS_V_BUILD);
        if (number == EM_RISCV && linking_ != Linking::STATIC)
            refuse(
                "for RISC-V, and dynamically linked or for Linux, which the ARM has, not Nios V: "
                "link it with -static -no-pie");
    }

    bool is_movable() const { return header_->e_type == ET_DYN; }

    // Copies, because in a damaged file what libelf points to may be unaligned.
    std::vector<Elf32_Phdr> program_headers() const {
        std::size_t count = 0;
        const void* headers = elf32_getphdr(elf_.get());
        if (elf_getphdrnum(elf_.get(), &count) != 0 || (count > 0 && !headers))
            refuse("a damaged ELF file: {}", elf_errmsg(-1));
        std::vector<Elf32_Phdr> copies(count);
        if (count > 0) std::memcpy(copies.data(), headers, count * sizeof copies[0]);
        return copies;
    }

    void read_segments(ElfProgram& program) {
        const std::vector<Elf32_Phdr> headers = program_headers();
        bool entry_found = false;
        for (const Elf32_Phdr& header : headers) {
            if (header.p_type == PT_INTERP || header.p_type == PT_DYNAMIC) {
                if (linking_ == Linking::STATIC)
                    refuse("dynamically linked, expected a static executable");
                if (header.p_type == PT_INTERP) program.interpreter = interpreter(header);
            }
            if (header.p_type != PT_LOAD || header.p_memsz == 0) continue;
            check_place(header, program);
            const auto* data = reinterpret_cast<const std::uint8_t*>(bytes_.data());
            program.segments.push_back(
                {header.p_paddr,
                 header.p_vaddr,
                 header.p_memsz,
                 {data + header.p_offset, data + header.p_offset + header.p_filesz},
                 (header.p_flags & PF_W) != 0,
                 (header.p_flags & PF_X) != 0});
            const std::uint32_t table = header_->e_phoff - header.p_offset;
            if (table < header.p_filesz &&
                headers.size() * sizeof header <= header.p_filesz - table) {
                program.headers = header.p_vaddr + table;
                program.header_count = static_cast<std::uint32_t>(headers.size());
            }
            if ((header.p_flags & PF_X) &&
                (header_->e_entry & ~1u) - header.p_vaddr < header.p_memsz)
                entry_found = true;
        }
        if (program.segments.empty()) refuse("nothing to load: no PT_LOAD segment");
        if (!entry_found && linking_ != Linking::LIBRARY)
            refuse("its entry point 0x{:08X} is in no executable segment", header_->e_entry);
    }

    void check_place(const Elf32_Phdr& header, const ElfProgram& program) const {
        const std::uint64_t begin = header.p_paddr, end = begin + header.p_memsz;
        const std::string name = fmt::format("its segment 0x{:08X} - 0x{:08X}", begin, end - 1);
        if (header.p_filesz > header.p_memsz)
            refuse("{} has more bytes in the file than in memory", name);
        if (header.p_offset > bytes_.size() || header.p_filesz > bytes_.size() - header.p_offset)
            refuse("is cut off: {} lies beyond its end", name);
        const std::uint64_t base = is_movable() ? POSITION_INDEPENDENT_BASE : 0;
        if (std::none_of(memory_.begin(), memory_.end(), [&](const MemoryRange& range) {
                return base + begin >= range.base && base + end <= range.base + range.size;
            }))
            refuse("{} is not in the memory", name);
        for (const ElfSegment& other : program.segments)
            if (begin < std::uint64_t{other.physical} + other.size && other.physical < end)
                refuse("{} overlaps the one at 0x{:08X}", name, other.physical);
    }

    std::string interpreter(const Elf32_Phdr& header) const {
        const std::size_t end = std::size_t{header.p_offset} + header.p_filesz;
        if (header.p_filesz < 2 || end > bytes_.size() || bytes_[end - 1] != '\0')
            refuse("a damaged ELF file: its interpreter has no name");
        return &bytes_[header.p_offset];
    }

    // Sections and names are optional: wrong ones are left out, not refused.
    void read_sections(ElfProgram& program) const {
        for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf_.get(), section));) {
            GElf_Shdr header;
            if (!gelf_getshdr(section, &header)) continue;
            const char* name = elf_strptr(elf_.get(), header_->e_shstrndx, header.sh_name);
            if (const Elf_Data* data = elf_getdata(section, nullptr);
                data && data->d_buf && name &&
                std::string_view{name}.rfind(MODULES_SECTION, 0) == 0) {
                const auto* const bytes = static_cast<const std::uint8_t*>(data->d_buf);
                program.modules.assign(bytes, bytes + data->d_size);
                program.modules_name = name + std::string_view{MODULES_SECTION}.size();
            }
            if (!(header.sh_flags & SHF_ALLOC)) continue;
            program.sections.push_back({static_cast<std::uint32_t>(header.sh_addr),
                                        static_cast<std::uint32_t>(header.sh_size),
                                        name ? name : "", (header.sh_flags & SHF_WRITE) != 0,
                                        (header.sh_flags & SHF_EXECINSTR) != 0});
        }
    }

    void read_functions(ElfProgram& program) const {
        for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf_.get(), section));) {
            GElf_Shdr header;
            if (!gelf_getshdr(section, &header) ||
                (header.sh_type != SHT_SYMTAB && header.sh_type != SHT_DYNSYM))
                continue;
            const Elf_Data* data = elf_getdata(section, nullptr);
            if (!data || !data->d_buf) continue;
            Elf32_Sym symbol;
            const auto* symbols = static_cast<const char*>(data->d_buf);
            for (std::size_t at = 0; at + sizeof symbol <= data->d_size; at += sizeof symbol) {
                std::memcpy(&symbol, symbols + at, sizeof symbol);
                const unsigned type = ELF32_ST_TYPE(symbol.st_info);
                const char* name = elf_strptr(elf_.get(), header.sh_link, symbol.st_name);
                if (symbol.st_shndx == SHN_UNDEF || !name || !*name || *name == '$') continue;
                if (type != STT_FUNC && type != STT_NOTYPE) continue;
                if (type == STT_NOTYPE && !is_code(symbol.st_shndx)) continue;
                program.functions.push_back({symbol.st_value & ~1u, symbol.st_size, name});
            }
        }
        // Of several names for one address, the one with a size, then the first in alphabetical
        // order.
        std::sort(program.functions.begin(), program.functions.end(),
                  [](const ElfFunction& a, const ElfFunction& b) {
                      if (a.address != b.address) return a.address < b.address;
                      return (a.size != 0) != (b.size != 0) ? a.size != 0 : a.name < b.name;
                  });
        const auto same = [](const ElfFunction& a, const ElfFunction& b) {
            return a.address == b.address;
        };
        program.functions.erase(
            std::unique(program.functions.begin(), program.functions.end(), same),
            program.functions.end());
    }

    bool is_code(unsigned index) const {
        Elf_Scn* section = elf_getscn(elf_.get(), index);
        GElf_Shdr header;
        return section && gelf_getshdr(section, &header) && (header.sh_flags & SHF_EXECINSTR);
    }

    const std::filesystem::path& file_;
    const std::vector<MemoryRange>& memory_;
    const Linking linking_;
    std::vector<char> bytes_;
    ElfHandle elf_;
    const Elf32_Ehdr* header_ = nullptr;
};

// A name of C may be that of a type in mangled form: "w" is wchar_t.
std::string demangled(const std::string& name) {
    if (name.rfind("_Z", 0) != 0) return name;
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text{
        abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free};
    return status == 0 ? text.get() : name;
}

bool holds(const ElfSegment& segment, std::uint32_t address) {
    return address - segment.address < segment.size;
}

// Without the libraries.
std::string own_function(const ElfProgram& program, std::uint32_t address) {
    const auto next = std::upper_bound(
        program.functions.begin(), program.functions.end(), address,
        [](std::uint32_t value, const ElfFunction& f) { return value < f.address; });
    if (next == program.functions.begin()) return "";
    const ElfFunction& f = *(next - 1);
    const std::uint32_t offset = address - f.address;
    if (f.size != 0 && offset >= f.size) return "";
    const bool loaded =
        std::any_of(program.segments.begin(), program.segments.end(),
                    [&](const ElfSegment& s) { return holds(s, address) && holds(s, f.address); });
    if (!loaded) return "";
    return demangled(f.name) + (offset ? fmt::format("+0x{:x}", offset) : "");
}

}  // namespace

std::string ElfProgram::function(std::uint32_t address) const {
    std::string name = own_function(*this, address);
    for (auto library = libraries.rbegin(); name.empty() && library != libraries.rend();
         ++library) {
        const auto& all = library->segments;
        if (std::none_of(all.begin(), all.end(),
                         [address](const ElfSegment& s) { return holds(s, address); }))
            continue;
        const std::string file_name = library->file.filename().string();
        name = own_function(*library, address);
        name = name.empty() ? fmt::format("{}+0x{:x}", file_name, address - all.front().address)
                            : name + " of " + file_name;
    }
    return name;
}

void ElfProgram::move(std::uint32_t bytes) {
    entry += bytes;
    if (headers != 0) headers += bytes;
    for (ElfSegment& segment : segments) {
        segment.physical += bytes;
        segment.address += bytes;
    }
    for (ElfFunction& one : functions) one.address += bytes;
    for (ElfSection& section : sections) section.address += bytes;
}

void ElfProgram::leave_only_sections() {
    if (sections.empty()) return;
    for (ElfSegment& segment : segments) {
        std::vector<std::uint8_t> kept(segment.data.size());
        for (const ElfSection& section : sections) {
            const std::uint64_t from = std::max(section.address, segment.address),
                                to = std::min(std::uint64_t{section.address} + section.size,
                                              std::uint64_t{segment.address} + kept.size());
            for (std::uint64_t at = from; at < to; ++at)
                kept[at - segment.address] = segment.data[at - segment.address];
        }
        segment.data = std::move(kept);
    }
}

ElfProgram load_elf(const std::filesystem::path& file, const std::vector<MemoryRange>& memory,
                    Linking linking) {
    return Reader{file, memory, linking}.load();
}

bool is_elf(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        return false;  // a pipe would block for
                       // ever
    char magic[SELFMAG] = {};
    return std::ifstream{file, std::ios::binary}.read(magic, SELFMAG) &&
           std::memcmp(magic, ELFMAG, SELFMAG) == 0;
}

ElfMachine machine_of(const std::filesystem::path& file) {
    try {
        return Reader{file, {}, Linking::STATIC}.machine_of();
    } catch (const ElfError&) {  // perhaps a program for Linux
        return Reader{file, {}, Linking::ANY}.machine_of();
    }
}

bool expects_linux(const std::filesystem::path& file) {
    return Reader{file, {}, Linking::ANY}.expects_linux();
}

}  // namespace sim
