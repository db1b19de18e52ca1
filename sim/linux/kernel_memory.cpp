// kernel_memory.cpp - LinuxKernel's calls for memory: heap, areas, /dev/mem
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint64_t LARGEST_FILE = std::uint64_t{1} << 32;  // that is mapped shared
constexpr unsigned ACCESS = arm_access::ALL;                    // PROT_ bits have the same places

bool aligned(std::uint32_t address) { return address % AddressSpace::PAGE == 0; }

std::uint32_t page_up(std::uint32_t address) {
    return (address + AddressSpace::PAGE - 1) & ~(AddressSpace::PAGE - 1);
}

// Whole pages, 0 when that is more than a process has.
std::uint32_t pages(std::uint32_t bytes) { return bytes > AddressSpace::TOP ? 0 : page_up(bytes); }

}  // namespace

LinuxKernel::Result LinuxKernel::sys_brk(const Arguments& a) {
    const std::uint32_t wish = a[0];
    if (wish < process_->break_begin || wish > memory().top() - AddressSpace::PAGE)
        return process_->break_end;
    const std::uint32_t was = page_up(process_->break_end), will = page_up(wish);
    if (will < was) memory().unmap(will, was - will);
    if (will > was && (!memory().is_free(was, will - was) ||
                       !memory().map(was, will - was, arm_access::READ | arm_access::WRITE)))
        return process_->break_end;
    return process_->break_end = wish;
}

std::optional<std::uint32_t> LinuxKernel::place_of(std::uint32_t wish, std::uint32_t bytes,
                                                   std::uint32_t flags) const {
    if (flags & (arm_mmap::FIXED | arm_mmap::FIXED_NOREPLACE)) return wish;
    wish &= ~(AddressSpace::PAGE - 1);
    if (wish != 0 && memory().holds(wish, bytes) && memory().is_free(wish, bytes)) return wish;
    return memory().find_room(bytes);
}

LinuxKernel::Result LinuxKernel::sys_mmap2(const Arguments& a) {
    const std::uint32_t wish = a[0], bytes = pages(a[1]), flags = a[3], page = a[5];
    const unsigned access = a[2] & ACCESS;
    const int fd = static_cast<int>(a[4]);
    const std::uint32_t type = flags & arm_mmap::TYPE;
    const bool anonymous = flags & arm_mmap::ANONYMOUS;
    if (!anonymous && files().flags(fd) < 0) return -EBADF;
    if (a[1] == 0 || type == 0 || type > arm_mmap::SHARED_VALIDATE) return -EINVAL;
    if (!anonymous && type == arm_mmap::SHARED_VALIDATE && (flags & ~arm_mmap::KNOWN))
        return -EOPNOTSUPP;
    if (bytes == 0) return -ENOMEM;
    const bool fixed = flags & (arm_mmap::FIXED | arm_mmap::FIXED_NOREPLACE);
    if (fixed && (!aligned(wish) || !memory().holds(wish, bytes)))
        return aligned(wish) ? -ENOMEM : -EINVAL;
    if ((flags & arm_mmap::FIXED_NOREPLACE) && !memory().is_free(wish, bytes)) return -EEXIST;

    if (!anonymous) {
        const auto mode = static_cast<std::uint32_t>(files().flags(fd)) & arm_open::ACCESS;
        const bool shared_write = (access & arm_access::WRITE) && type != arm_mmap::PRIVATE;
        if (mode == arm_open::WRONLY || (shared_write && mode != arm_open::RDWR)) return -EACCES;
        if (files().is_memory(fd)) return map_bus(a, bytes, access, a[5]);
        if (ModuleFile* const file = module_file(fd)) return map_module(fd, *file, a, bytes);
        if (LinuxDevice* const device = files().device(fd)) {
            if (const auto range = device->on_bus()) {
                if (std::uint64_t{page} * AddressSpace::PAGE + bytes > page_up(range->second))
                    return -EINVAL;
                return map_bus(a, bytes, access, range->first / AddressSpace::PAGE + page);
            }
            return map_shared(a, bytes, access, device->memory(), type == arm_mmap::PRIVATE);
        }
        if (!S_ISREG(files().status_of(fd).second.mode)) return -ENODEV;
        if (type != arm_mmap::PRIVATE) {
            const auto shared = std::make_shared<SharedMemory>(files().on_host(fd).first);
            const std::int64_t place = map_shared(a, bytes, access, shared, false);
            if (place >= 0 && (access & arm_access::EXECUTE) && page == 0)
                loader_.mapped(files(), fd, static_cast<std::uint32_t>(place));
            return place;
        }
    }
    if (anonymous && type != arm_mmap::PRIVATE)
        return map_shared({wish, a[1], a[2], flags, 0, 0}, bytes, access,
                          std::make_shared<SharedMemory>(), false);
    const auto place = place_of(wish, bytes, flags);
    if (!place || !memory().map(*place, bytes, anonymous ? access : ACCESS)) return -ENOMEM;
    if (anonymous) return *place;
    const std::int64_t error =
        fill_from_file(fd, *place, bytes, std::int64_t{page} * AddressSpace::PAGE);
    if (error < 0) memory().unmap(*place, bytes);
    if (error < 0) return error;
    memory().protect(*place, bytes, access);
    if ((access & arm_access::EXECUTE) && page == 0) loader_.mapped(files(), fd, *place);
    return *place;
}

std::int64_t LinuxKernel::map_shared(const Arguments& a, std::uint32_t bytes, unsigned access,
                                     std::shared_ptr<SharedMemory> shared, bool as_copy) {
    const std::uint64_t offset = std::uint64_t{a[5]} * AddressSpace::PAGE;
    if (!shared) return -ENODEV;
    if (offset + bytes > (shared->is_file() ? LARGEST_FILE : AddressSpace::RAM)) return -ENOMEM;
    const auto place = place_of(a[0], bytes, a[3]);
    if (!place) return -ENOMEM;
    if (!as_copy) {
        const bool mapped = memory().map_shared(*place, bytes, access, std::move(shared),
                                                static_cast<std::uint32_t>(offset));
        return mapped ? std::int64_t{*place} : -ENOMEM;
    }
    if (!memory().map(*place, bytes, ACCESS)) return -ENOMEM;
    std::uint8_t* const to = memory().bytes(*place, bytes, arm_access::WRITE);
    if (pread(shared->fd(), to, bytes, static_cast<off_t>(offset)) < 0) return -EIO;
    memory().protect(*place, bytes, access);
    return *place;
}

std::int64_t LinuxKernel::map_bus(const Arguments& a, std::uint32_t bytes, unsigned access,
                                  std::uint32_t page) {
    const std::uint64_t physical = std::uint64_t{page} * AddressSpace::PAGE;
    if (physical + bytes > std::uint64_t{1} << 32) return -EINVAL;
    const auto place = place_of(a[0], bytes, a[3]);
    if (!place) return -ENOMEM;
    const bool mapped = memory().map_bus(*place, bytes, access & ~arm_access::EXECUTE,
                                         static_cast<std::uint32_t>(physical));
    return mapped ? std::int64_t{*place} : -ENOMEM;
}

// The rest of the last page stays zero.
std::int64_t LinuxKernel::fill_from_file(int fd, std::uint32_t begin, std::uint32_t bytes,
                                         std::int64_t offset) {
    std::uint8_t* to = memory().bytes(begin, bytes, arm_access::WRITE);
    for (std::uint32_t done = 0; done < bytes;) {
        const std::int64_t count = files().read_at(fd, to + done, bytes - done, offset + done);
        if (count < 0) return count == -ESPIPE ? -ENODEV : count;
        if (count == 0) break;
        done += static_cast<std::uint32_t>(count);
    }
    return 0;
}

void LinuxKernel::files_changed() {
    for (const auto& process : processes_)
        if (process->memory) process->memory->fit_to_files();
}

// The file may have become longer: then the program goes on.
void LinuxKernel::after_file(std::uint32_t address) {
    memory().fit_to_files();
    if (memory().is_after_file(address))
        fault({SIGBUS,
               arm_signal_code::AFTER_FILE,
               {address},
               fmt::format("0x{:08X} is after the end of the mapped file", address)});
}

LinuxKernel::Result LinuxKernel::sys_munmap(const Arguments& a) {
    const std::uint32_t bytes = pages(a[1]);
    if (!aligned(a[0]) || bytes == 0 || !memory().holds(a[0], bytes)) return -EINVAL;
    if (!memory().may_unmap(a[0], bytes)) return -ENOMEM;
    memory().unmap(a[0], bytes);
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_mprotect(const Arguments& a) {
    if (!aligned(a[0])) return -EINVAL;
    if (a[1] == 0) return 0;
    const std::uint32_t bytes = pages(a[1]);
    if (bytes == 0 || !memory().holds(a[0], bytes)) return -ENOMEM;
    if ((a[2] & arm_access::WRITE) && !memory().may_write(a[0], bytes)) return -EACCES;
    return memory().protect(a[0], bytes, a[2] & ACCESS) ? 0 : -ENOMEM;
}

LinuxKernel::Result LinuxKernel::sys_mremap(const Arguments& a) {
    const std::uint32_t from = a[0], was = pages(a[1]), will = pages(a[2]), flags = a[3];
    if (!aligned(from) || will == 0 || was == 0 || (flags & arm_mremap::FIXED)) return -EINVAL;
    const auto area = memory().at(from);
    if (!memory().holds(from, was) || !area || area->second.end - from < was) return -EFAULT;
    if (will <= was) {
        if (will < was) memory().unmap(from + will, was - will);
        return from;
    }
    const bool on_bus = area->second.on_bus;
    const unsigned access = area->second.access;
    const std::shared_ptr<SharedMemory> shared = area->second.shared;
    const std::uint32_t physical = area->second.physical_at(from - area->first);
    if (memory().holds(from, will) && memory().is_free(from + was, will - was)) {
        const std::uint32_t more = will - was, at = physical + was;
        const bool mapped = on_bus   ? memory().map_bus(from + was, more, access, at)
                            : shared ? memory().map_shared(from + was, more, access, shared, at)
                                     : memory().map(from + was, more, access);
        return mapped ? std::int64_t{from} : -ENOMEM;
    }
    const auto to = flags & arm_mremap::MAYMOVE ? memory().find_room(will) : std::nullopt;
    if (!to) return -ENOMEM;
    if (on_bus) {
        if (!memory().map_bus(*to, will, access, physical)) return -ENOMEM;
    } else if (shared) {
        if (!memory().map_shared(*to, will, access, shared, physical)) return -ENOMEM;
    } else {
        if (!memory().map(*to, will, ACCESS)) return -ENOMEM;
        memory().protect(from, was, ACCESS);
        std::memcpy(memory().bytes(*to, was, arm_access::WRITE),
                    memory().bytes(from, was, arm_access::READ), was);
        memory().protect(*to, will, access);
    }
    memory().unmap(from, was);
    return *to;
}

LinuxKernel::Result LinuxKernel::sys_cacheflush(const Arguments& a) {
    if (a[1] < a[0]) return -EINVAL;
    cpu_.core().forget_translations(a[0], a[1] - a[0]);
    return 0;
}

}  // namespace sim
