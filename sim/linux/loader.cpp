#include "sim/linux/loader.h"

#include <elf.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/linux/start.h"

namespace sim {

namespace {

constexpr const char* CACHE = "ld.so.cache";   // which need not be there
constexpr std::uint32_t LINKING_FAILED = 127;  // the exit code of glibc's dynamic linker

std::string file_name(const std::string& path) {
    return std::filesystem::path{path}.filename().string();
}

// Debian's package of a library for the cross compiler: "install libc6-armhf-cross, or "; or "".
std::string package_of(const std::string& library) {
    constexpr std::pair<const char*, const char*> PACKAGES[] = {
        {"libstdc++.so", "libstdc++6"}, {"libgcc_s.so", "libgcc-s1"},
        {"libatomic.so", "libatomic1"}, {"libgomp.so", "libgomp1"},
        {"libc.so", "libc6"},           {"libm.so", "libc6"},
        {"libpthread.so", "libc6"},     {"libdl.so", "libc6"},
        {"librt.so", "libc6"}};
    for (const auto& [name, package] : PACKAGES)
        if (library.rfind(name, 0) == 0) return fmt::format("install {}-armhf-cross, or ", package);
    return "";
}

std::string host_path(int host) { return "/proc/self/fd/" + std::to_string(host); }

// Why the dynamic linker of the hard-float ABI does not take this library; or "".
std::string why_unfit(int host) {
    try {
        if (!is_elf(host_path(host))) return "no ELF file";
        load_elf(host_path(host), linux_memory(), Linking::LIBRARY);
    } catch (const std::runtime_error& e) {
        const std::string what = e.what();
        const std::size_t begin = what.find(": ") + 2;
        return what.substr(begin, what.find(": ", begin) - begin);  // without what to do
    }
    Elf32_Ehdr header{};
    const bool read = ::pread(host, &header, sizeof header, 0) == sizeof header;
    return read && (header.e_flags & EF_ARM_ABI_FLOAT_SOFT) ? "for the soft-float ABI" : "";
}

}  // namespace

bool is_library(const std::string& path) {
    const std::string name = file_name(path);
    return name.find(".so") != std::string::npos || name == CACHE;
}

const std::vector<MemoryRange>& linux_memory() {
    static const std::vector<MemoryRange> memory{
        {AddressSpace::BOTTOM, AddressSpace::TOP - AddressSpace::BOTTOM},
        {KERNEL_BASE, std::uint64_t{KERNEL_PLACES} * KERNEL_PLACE_BYTES}};
    return memory;
}

ElfProgram LinuxLoader::load(const std::string& path, int host) {
    const std::shared_ptr<void> open{nullptr, [host](void*) { ::close(host); }};
    ElfProgram program = load_elf(host_path(host), linux_memory(), Linking::ANY);
    program.file = path;
    return program;
}

std::optional<ElfProgram> LinuxLoader::interpreter_of(const ElfProgram& program,
                                                      const LinuxFiles& files) {
    const std::string& path = program.interpreter;
    if (path.empty()) return std::nullopt;
    const int host = files.open_to_load(path);
    if (host >= 0) return load(path, host);
    std::string what_to_do = "copy the board's /lib into the folder of --linux-root";
    if (path == "/lib/ld-linux-armhf.so.3")
        what_to_do = "install libc6-armhf-cross, or " + what_to_do + ", or link it with -static";
    if (path == "/lib/ld-linux.so.3")
        what_to_do =
            "it is for the soft-float ABI: build it with arm-linux-gnueabihf-gcc, or " + what_to_do;
    throw std::runtime_error{
        fmt::format("{}: is dynamically linked, and its interpreter {} is not there: {}",
                    program.file.string(), path, what_to_do)};
}

std::uint32_t LinuxLoader::begin(AddressSpace& memory, const ElfProgram& program,
                                 std::optional<ElfProgram> interpreter,
                                 const std::vector<std::string>& arguments,
                                 const std::vector<std::string>& variables) {
    const std::uint32_t end = start_linux_program(
        cpu_.core(), memory, program, interpreter ? &*interpreter : nullptr, arguments, variables);
    if (interpreter) add_names(std::move(*interpreter));
    return end;
}

void LinuxLoader::looked_for(const std::string& path, int host) {
    const std::string name = file_name(path);
    if (name == CACHE) return;
    const std::string unfit = host < 0 ? "" : why_unfit(host);
    if (host >= 0 && unfit.empty()) {
        if (missing_ == name) missing_.clear();
        return;
    }
    if (missing_ != name) unfit_.clear();
    missing_ = name;
    if (!unfit.empty()) unfit_ = path + " is " + unfit;
}

std::string LinuxLoader::missing() const {
    return missing_.empty()
               ? ""
               : missing_ + (unfit_.empty() ? ", which is not there" : "; but " + unfit_);
}

// One that cannot be read has no names.
void LinuxLoader::mapped(const LinuxFiles& files, int fd, std::uint32_t place) {
    const auto [host, path] = files.on_host(fd);
    try {
        if (host < 0 || !is_elf(host_path(host))) return;
        ElfProgram library = load_elf(host_path(host), linux_memory(), Linking::LIBRARY);
        library.move(place - POSITION_INDEPENDENT_BASE);
        library.file = path;
        add_names(std::move(library));
    } catch (const std::runtime_error&) {
    }
}

void LinuxLoader::add_names(ElfProgram library) {
    for (ElfSegment& segment : library.segments) segment.data.clear();
    cpu_.add_library(std::move(library));
}

std::string LinuxLoader::failure(std::uint32_t exit_code) const {
    if (exit_code != LINKING_FAILED || missing_.empty()) return "";
    return fmt::format(
        "the program needs the library {}: {}copy it from the board into /usr/lib of the folder of "
        "--linux-root, or link the program with -static",
        missing(), package_of(missing_));
}

}  // namespace sim
