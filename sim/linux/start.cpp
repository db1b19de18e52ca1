#include "sim/linux/start.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>
#include <stdexcept>

#include "sim/linux/arm_abi.h"

namespace sim {

namespace {

constexpr std::uint32_t HELPERS = 0xFFFF0000;
constexpr std::uint32_t STACK_BYTES = 8 << 20, KERNEL_STACK_BYTES = 256 << 10, HEADER_BYTES = 32,
                        TICKS_A_SECOND = 100;
constexpr std::size_t MOST_ARGUMENT_BYTES = 128 << 10;

struct Code {
    std::uint32_t offset;
    std::vector<std::uint32_t> arguments;
};

const std::vector<Code>& helper_code() {
    static const std::vector<Code> code{
        {SIGRETURN_CODE - HELPERS, {0xE3A07077, 0xEF000000}},     // mov r7, #119; svc #0
        {RT_SIGRETURN_CODE - HELPERS, {0xE3A070AD, 0xEF000000}},  // mov r7, #173; svc #0
        {0xF60,                                                   // cmpxchg64
         {0xE92D00F0,                                             //    push {r4, r5, r6, r7}
          0xE1C040D0,                                             //    ldrd r4, r5, [r0]
          0xE1C160D0,                                             //    ldrd r6, r7, [r1]
          0xF57FF05B,                                             //    dmb ish
          0xE1B20F9F,                                             // 1: ldrexd r0, r1, [r2]
          0xE0303004,                                             //    eors r3, r0, r4
          0x00313005,                                             //    eorseq r3, r1, r5
          0x01A23F96,                                             //    strexdeq r3, r6, r7, [r2]
          0x03330001,                                             //    teqeq r3, #1
          0x0AFFFFF9,                                             //    beq 1b
          0xF57FF05B,                                             //    dmb ish
          0xE2730000,                                             //    rsbs r0, r3, #0
          0xE8BD00F0,                                             //    pop {r4, r5, r6, r7}
          0xE12FFF1E}},                                           //    bx lr
        {0xFA0, {0xF57FF05B, 0xE12FFF1E}},                        // memory_barrier: dmb ish; bx lr
        {0xFC0,                                                   // cmpxchg
         {0xF57FF05B,                                             //    dmb ish
          0xE1923F9F,                                             // 1: ldrex r3, [r2]
          0xE0533000,                                             //    subs r3, r3, r0
          0x01823F91,                                             //    strexeq r3, r1, [r2]
          0x03330001,                                             //    teqeq r3, #1
          0x0AFFFFFA,                                             //    beq 1b
          0xE2730000,                                             //    rsbs r0, r3, #0
          0xEAFFFFEF}},                                           //    b memory_barrier
        {0xFE0, {0xEE1D0F70, 0xE12FFF1E}},  // get_tls: mrc p15, 0, r0, c13, c0, 3; bx lr
        {0xFFC, {5}},                       // version
    };
    return code;
}

std::uint32_t page_down(std::uint32_t address) { return address & ~(AddressSpace::PAGE - 1); }
std::uint32_t page_up(std::uint32_t address) { return page_down(address + AddressSpace::PAGE - 1); }

void map_segments(AddressSpace& memory, const ElfProgram& program) {
    for (const ElfSegment& segment : program.segments) {
        const std::uint32_t end = page_up(segment.address + segment.size);
        for (std::uint32_t page = page_down(segment.address); page < end;) {
            const auto there = memory.at(page);
            const std::uint32_t border = there ? std::min(end, there->second.end) : end;
            bool mapped = there.has_value();
            if (!there) {
                std::uint32_t free_end = page + AddressSpace::PAGE;
                while (free_end < end && memory.is_free(free_end, AddressSpace::PAGE))
                    free_end += AddressSpace::PAGE;
                mapped = memory.map(page, free_end - page, arm_access::READ | arm_access::WRITE);
                page = free_end;
            } else {
                page = border;
            }
            if (!mapped)
                throw std::runtime_error{program.file.string() + ": does not fit into the memory"};
        }
        memory.write(segment.address, segment.data.data(), segment.data.size());
    }
    // Pages that two segments share have the rights of both.
    for (const ElfSegment& segment : program.segments) {
        const std::uint32_t begin = page_down(segment.address);
        const std::uint32_t end = page_up(segment.address + segment.size);
        for (std::uint32_t page = begin; page < end; page += AddressSpace::PAGE) {
            unsigned access = arm_access::READ;
            for (const ElfSegment& other : program.segments)
                if (page + AddressSpace::PAGE > other.address && page < other.address + other.size)
                    access |= (other.writable ? arm_access::WRITE : 0) |
                              (other.executable ? arm_access::EXECUTE : 0);
            if (memory.at(page)->second.access != access)
                memory.protect(page, AddressSpace::PAGE, access);
        }
    }
}

// The first page after all segments.
std::uint32_t end_of(const ElfProgram& program) {
    std::uint32_t end = 0;
    for (const ElfSegment& segment : program.segments)
        end = std::max(end, segment.address + segment.size);
    return page_up(end);
}

// Grows down from the top, strings first, then arguments.
class Stack {
public:
    Stack(AddressSpace& memory, std::uint32_t top) : memory_{memory}, at_{top} {}

    std::uint32_t push(const void* data, std::size_t bytes) {
        at_ -= static_cast<std::uint32_t>(bytes);
        memory_.write(at_, data, bytes);
        return at_;
    }
    std::uint32_t push(const std::string& text) { return push(text.c_str(), text.size() + 1); }
    std::uint32_t push_words(const std::vector<std::uint32_t>& arguments) {
        at_ = (at_ - static_cast<std::uint32_t>(4 * arguments.size())) & ~7u;
        memory_.write(at_, arguments.data(), 4 * arguments.size());
        return at_;
    }

private:
    AddressSpace& memory_;
    std::uint32_t at_;
};

// `base`: where the interpreter lies, or 0.
std::uint32_t make_stack(AddressSpace& memory, const ElfProgram& program, std::uint32_t base,
                         const std::vector<std::string>& arguments,
                         const std::vector<std::string>& variables) {
    std::size_t bytes = 0;
    for (const auto* list : {&arguments, &variables})
        for (const std::string& argument : *list) bytes += argument.size() + 5;
    if (bytes > MOST_ARGUMENT_BYTES)
        throw std::runtime_error{"the program's arguments are longer than 131072 bytes"};
    const bool is_kernel = memory.top() != AddressSpace::TOP;
    const std::uint32_t size = is_kernel ? KERNEL_STACK_BYTES : STACK_BYTES;
    const auto begin =
        is_kernel ? memory.find_room(size) : std::optional{AddressSpace::TOP - STACK_BYTES};
    if (!begin || !memory.map(*begin, size, arm_access::ALL))
        throw std::runtime_error{program.file.string() + ": no room for its stack"};
    Stack stack{memory, *begin + size - 4};
    const std::uint32_t name = stack.push(path_of(program)), platform = stack.push("v7l");
    static const std::uint8_t RANDOM_BYTES[16] = {0x9E, 0x37, 0x79, 0xB9, 0x7F, 0x4A, 0x7C, 0x15,
                                                  0xF3, 0x9C, 0xC0, 0x60, 0x5C, 0xED, 0xC8, 0x34};
    const std::uint32_t random = stack.push(RANDOM_BYTES, sizeof RANDOM_BYTES);

    std::vector<std::uint32_t> words{static_cast<std::uint32_t>(arguments.size())};
    for (const std::string& argument : arguments) words.push_back(stack.push(argument));
    words.push_back(0);
    for (const std::string& variable : variables) words.push_back(stack.push(variable));
    words.push_back(0);
    using namespace arm_aux;
    const std::uint32_t able = arm_hwcap::HALF | arm_hwcap::THUMB | arm_hwcap::FAST_MULT |
                               arm_hwcap::VFP | arm_hwcap::EDSP | arm_hwcap::NEON |
                               arm_hwcap::VFPV3 | arm_hwcap::TLS | arm_hwcap::VFPD32;
    if (program.headers != 0)
        words.insert(words.end(),
                     {PHDR, program.headers, PHENT, HEADER_BYTES, PHNUM, program.header_count});
    words.insert(words.end(), {PAGESZ,   AddressSpace::PAGE,
                               BASE,     base,
                               FLAGS,    0,
                               ENTRY,    program.entry,
                               UID,      0,
                               EUID,     0,
                               GID,      0,
                               EGID,     0,
                               PLATFORM, platform,
                               HWCAP,    able,
                               HWCAP2,   0,
                               CLKTCK,   TICKS_A_SECOND,
                               SECURE,   0,
                               RANDOM,   random,
                               EXECFN,   name,
                               END,      0});
    return stack.push_words(words);
}

}  // namespace

KernelHelpers::KernelHelpers(ArmCore& core) : core_{core} {
    void* page = mmap(nullptr, AddressSpace::PAGE, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) throw std::bad_alloc{};
    page_ = static_cast<std::uint8_t*>(page);
    for (const Code& code : helper_code())
        std::memcpy(page_ + code.offset, code.arguments.data(), 4 * code.arguments.size());
}

KernelHelpers::~KernelHelpers() { munmap(page_, AddressSpace::PAGE); }

void KernelHelpers::connect() {
    core_.map_ram(HELPERS, AddressSpace::PAGE, page_,
                  arm_access::READ | arm_access::EXECUTE | arm_access::NORMAL);
}

void KernelHelpers::set_tls(std::uint32_t value) {
    std::memcpy(page_ + 0xFF0, &value, sizeof value);
    core_.set_cp15(cp15::TPIDRURO, value);
}

std::string path_of(const ElfProgram& program) { return "/" + program.file.filename().string(); }

const std::vector<std::string>& first_environment() {
    static const std::vector<std::string> all{"PATH=/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/",
                                              "TERM=linux"};
    return all;
}

std::uint32_t start_linux_program(ArmCore& core, AddressSpace& memory, const ElfProgram& program,
                                  ElfProgram* interpreter,
                                  const std::vector<std::string>& arguments,
                                  const std::vector<std::string>& variables) {
    map_segments(memory, program);
    std::uint32_t base = 0, entry = program.entry;
    if (interpreter) {
        if (!interpreter->movable)
            throw std::runtime_error{interpreter->file.string() +
                                     ": no interpreter: it is not position-independent"};
        const auto room = memory.find_room(end_of(*interpreter) - POSITION_INDEPENDENT_BASE);
        if (!room)
            throw std::runtime_error{program.file.string() + ": does not fit into the memory"};
        base = *room;
        interpreter->move(base - POSITION_INDEPENDENT_BASE);
        map_segments(memory, *interpreter);
        entry = interpreter->entry;
    }
    const std::uint32_t sp = make_stack(memory, program, base, arguments, variables);
    core.set_floating_point(true);
    core.set_cpsr(arm_mode::USR | arm_cpsr::I | arm_cpsr::F | (entry & 1 ? arm_cpsr::T : 0));
    for (unsigned number = 0; number < 15; ++number) core.set_reg(number, 0);
    core.set_reg(13, sp);
    core.set_reg(15, entry);
    return end_of(program);
}

}  // namespace sim
