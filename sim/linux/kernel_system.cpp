// kernel_system.cpp - LinuxKernel's own files, and the calls that make files without a name
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/devices.h"
#include "sim/linux/i2c_file.h"
#include "sim/linux/kernel.h"
#include "sim/linux/pipes.h"

namespace sim {

namespace {

constexpr const char* SHARED_FOLDER = "/dev/shm/";
constexpr const char* I2C_BUS = "/dev/i2c-0";
constexpr std::uint32_t PROCESSORS = 2, STAT_TICK_NS = 10'000'000;

bool begins(const std::string& text, const char* with) { return text.rfind(with, 0) == 0; }

// As the board's kernel says it.
std::string cpu_info() {
    std::string text;
    for (int number = 0; number < static_cast<int>(PROCESSORS); ++number)
        text += fmt::format(
            "processor\t: {}\nmodel name\t: ARMv7 Processor rev 0 (v7l)\nBogoMIPS\t: 200.00\n"
            "Features\t: half thumb fastmult vfp edsp neon vfpv3 tls vfpd32 \n"
            "CPU implementer\t: 0x41\nCPU architecture: 7\nCPU variant\t: 0x3\n"
            "CPU part\t: 0xc09\nCPU revision\t: 0\n\n",
            number);
    return text + "Hardware\t: Altera SOCFPGA\nRevision\t: 0000\nSerial\t\t: 0000000000000000\n";
}

constexpr const char* IO_MEMORY =
    "00000000-3fffffff : System RAM\n"
    "ff702000-ff703fff : ff702000.ethernet\n"
    "ff704000-ff704fff : ff704000.dwmmc0\n"
    "ff706000-ff706fff : ff706000.fpgamgr\n"
    "ff708000-ff708fff : ff708000.gpio\n"
    "ff709000-ff709fff : ff709000.gpio\n"
    "ff70a000-ff70afff : ff70a000.gpio\n"
    "ffb40000-ffb4ffff : ffb40000.usb\n"
    "ffc02000-ffc0201f : serial\n"
    "ffc04000-ffc04fff : ffc04000.i2c\n"
    "ffd02000-ffd02fff : ffd02000.watchdog\n"
    "ffe01000-ffe01fff : ffe01000.pdma\n"
    "ffff0000-ffffffff : ffff0000.sram\n";

// As the board's driver (altvipfb) does at boot, but when the program wants the picture.
void start_frame_reader(const LinuxKernel::Outside& outside) {
    const PixelBuffer& pixels = *outside.pixels;
    const std::uint32_t all = pixels.width * pixels.height;
    enum { CONTROL, SELECT = 3, BASE, WORDS, SAMPLES, WIDTH = 8, HEIGHT, INTERLACED };
    for (auto [number, value] : {std::pair{BASE, pixels.base},
                                 {WORDS, all / (pixels.word / pixels.bits)},
                                 {SAMPLES, all},
                                 {WIDTH, pixels.width},
                                 {HEIGHT, pixels.height},
                                 {INTERLACED, 3},
                                 {SELECT, 0},
                                 {CONTROL, 1}})
        outside.access(true, pixels.frame_reader + 4 * static_cast<std::uint32_t>(number), value);
}

}  // namespace

// "status" and so on, of a process or one of its threads.
std::optional<std::string> LinuxKernel::text_of_process(const LinuxProcess& process,
                                                        const LinuxThread* of_thread,
                                                        const std::string& name) const {
    const auto& threads = process.threads;
    const LinuxThread& thread = of_thread ? *of_thread : *threads.front();
    const std::string command =
        thread.name.empty() ? process.command.substr(process.command.rfind('/') + 1).substr(0, 15)
                            : thread.name;
    std::uint64_t bytes = 0;
    std::string maps;
    for (const auto& [begin, area] : process.memory->areas()) {
        bytes += area.end - begin;
        maps += fmt::format("{:08x}-{:08x} {}{}{}{} {:08x} 00:00 0\n", begin, area.end,
                            area.access & arm_access::READ ? 'r' : '-',
                            area.access & arm_access::WRITE ? 'w' : '-',
                            area.access & arm_access::EXECUTE ? 'x' : '-',
                            area.shared || area.on_bus ? 's' : 'p', area.physical);
    }
    const char* const state = process.stopped ? "T (stopped)"
                              : thread.wait   ? "S (sleeping)"
                                              : "R (running)";
    if (name == "maps") return maps;
    if (name == "comm") return command + "\n";
    if (name == "cmdline") return process.command_line;
    if (name == "statm") return fmt::format("{0} {0} 0 0 0 0 0\n", bytes / AddressSpace::PAGE);
    if (name == "status")
        return fmt::format(
            "Name:\t{}\nUmask:\t{:04o}\nState:\t{}\nTgid:\t{}\nPid:\t{}\nPPid:\t{}\n"
            "Uid:\t0\t0\t0\t0\nGid:\t0\t0\t0\t0\nVmPeak:\t{:8} kB\nVmSize:\t{:8} kB\n"
            "VmRSS:\t{:8} kB\nThreads:\t{}\nCpus_allowed:\t3\nCpus_allowed_list:\t0-1\n",
            command, process.umask, state, process.number, thread.number, process.parent,
            bytes / 1024, bytes / 1024, bytes / 1024, threads.size());
    if (name == "stat")
        return fmt::format(
            "{0} ({1}) {7} {2} {8} {9} 1025 1 0 0 0 0 0 {3} 0 0 0 20 0 {4} 0 0 {5} {6} 4294967295 "
            "0 0 0 0 0 0 0 0 0 0 0 17 0 0 0 0 0 0\n",
            thread.number, command, process.parent,
            (of_thread ? thread.used_ns : used_ns(process)) / STAT_TICK_NS, threads.size(), bytes,
            bytes / AddressSpace::PAGE, state[0], process.group, process.session);
    return std::nullopt;
}

// Texts of /proc and /sys.
std::optional<std::string> LinuxKernel::system_text(const std::string& path) const {
    constexpr std::uint64_t KB = AddressSpace::RAM / 1024;
    const std::uint64_t ms = now_ns() / 1'000'000;
    if (path == "/proc/cpuinfo") return cpu_info();
    if (path == "/proc/iomem") return IO_MEMORY;
    if (path == "/sys/class/fpga_manager/fpga0/state") return "operating\n";
    if (path == "/sys/class/fpga_manager/fpga0/name") return "Altera SOCFPGA FPGA Manager\n";
    if (path == "/proc/version") return "Linux version 6.1.0 (de1soc) #1\n";
    if (path == "/proc/uptime")
        return fmt::format("{}.{:02} {}.{:02}\n", ms / 1000, ms / 10 % 100, ms / 1000,
                           ms / 10 % 100);
    if (path == "/proc/loadavg")
        return fmt::format("0.00 0.00 0.00 1/{} {}\n", threads().size(), next_number_ - 1);
    if (path == "/proc/meminfo")
        return fmt::format("MemTotal: {0:14} kB\nMemFree: {0:15} kB\nMemAvailable: {0:10} kB\n",
                           KB);
    if (path == "/proc/stat")
        return fmt::format(
            "cpu  {0} 0 0 0 0 0 0 0 0 0\ncpu0 {0} 0 0 0 0 0 0 0 0 0\n"
            "cpu1 0 0 0 {0} 0 0 0 0 0 0\n",
            ms / 10);
    for (const char* which : {"online", "possible", "present"})
        if (path == std::string{"/sys/devices/system/cpu/"} + which) return "0-1\n";
    if (path == "/proc/modules") return modules_text();
    if (path == "/proc/interrupts") return interrupts_text();
    if (!begins(path, "/proc/")) return std::nullopt;
    const std::string name = path.substr(path.rfind('/') + 1);
    for (const auto& process : processes_) {
        const std::string folder = fmt::format("/proc/{}/", process->number);
        if (!process->memory || process->threads.empty() || !begins(path, folder.c_str())) continue;
        if (path == folder + name) return text_of_process(*process, nullptr, name);
        for (const auto& thread : process->threads)
            if (path == fmt::format("{}task/{}/{}", folder, thread->number, name))
                return text_of_process(*process, thread.get(), name);
    }
    return std::nullopt;
}

std::string LinuxKernel::modules_text() const {
    std::string text;
    for (const auto& module : modules_)
        text += fmt::format("{} {} {} - Live 0x{:08x} (O)\n", module->name,
                            module->process->break_end % KERNEL_PLACE_BYTES, module->open_files,
                            module->process->break_begin & ~(KERNEL_PLACE_BYTES - 1));
    return text;
}

std::string LinuxKernel::interrupts_text() const {
    std::string text = "           CPU0       CPU1       \n";
    for (const auto& [number, interrupt] : interrupts_)
        text += fmt::format("{:3}: {:10} {:10}     GIC-0 {:3} Level     {}\n", number,
                            interrupt.count, 0, number, interrupt.name);
    return text;
}

// Vigna's splitmix64.
std::uint8_t LinuxKernel::random_byte() {
    std::uint64_t z = random_ += 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return static_cast<std::uint8_t>(z >> 56);
}

std::shared_ptr<AttributeFile> LinuxKernel::open_attribute(const std::string& path) {
    auto file = gpio_.open(path);
    return file ? file : led_.open(path);
}

std::pair<int, std::shared_ptr<LinuxDevice>> LinuxKernel::open_own(const std::string& path,
                                                                   std::uint32_t flags) {
    const bool writes = (flags & arm_open::ACCESS) != arm_open::RDONLY;
    if (path == "/dev/null") return {0, devices::null()};
    if (path == "/dev/zero" || path == "/dev/full") return {0, devices::zero(path == "/dev/full")};
    if (path == "/dev/urandom" || path == "/dev/random")
        return {0, devices::random([this] { return random_byte(); })};
    if (path == "/dev/fb0" && outside_.pixels) {
        if (outside_.pixels->frame_reader && !std::exchange(frame_reader_runs_, true))
            start_frame_reader(outside_);
        return {0, devices::framebuffer(*outside_.pixels, outside_.access)};
    }
    if (auto device = input_.open(path)) return {0, std::move(device)};
    if (auto device = usb_.open(path)) return {0, std::move(device)};
    if (auto file = open_attribute(path)) {
        const bool reads = (flags & arm_open::ACCESS) != arm_open::WRONLY;
        if (!file->allows(reads, writes)) return {-EACCES, nullptr};
        return {0, std::move(file)};
    }
    if (path == I2C_BUS && outside_.i2c0)
        return {0, std::make_shared<I2cFile>(
                       *outside_.i2c0, [this] { return cpu_.now().value(); },
                       [this](std::uint64_t ps) { cpu_.pause(sc_core::sc_time::from_value(ps)); })};
    if (begins(path, SHARED_FOLDER)) {
        const std::string name = path.substr(std::strlen(SHARED_FOLDER));
        if (name.empty() || name.find('/') != std::string::npos) return {-EINVAL, nullptr};
        auto found = shared_files_.find(name);
        if (found != shared_files_.end() && (flags & arm_open::CREAT) && (flags & arm_open::EXCL))
            return {-EEXIST, nullptr};
        if (found == shared_files_.end()) {
            if (!(flags & arm_open::CREAT)) return {-ENOENT, nullptr};
            found = shared_files_.emplace(name, std::make_shared<SharedMemory>()).first;
        }
        if (writes && (flags & arm_open::TRUNC)) found->second->resize(0);
        return {0, devices::shared(found->second)};
    }
    auto text = system_text(path);
    if (!text) return {-ENOENT, nullptr};
    if (writes) return {-EACCES, nullptr};
    return {0, devices::text(path, std::move(*text))};
}

std::optional<FileStatus> LinuxKernel::status_of_own(const std::string& path) {
    if (begins(path, SHARED_FOLDER)) {
        const auto found = shared_files_.find(path.substr(std::strlen(SHARED_FOLDER)));
        if (found == shared_files_.end()) return std::nullopt;
        return devices::status_of_shared(*found->second);
    }
    if (auto status = module_status(path)) return status;
    if (network_.has_path(path))
        return LinuxSocket{network_, SocketAddress::UNIX, LinuxSocket::STREAM}.status();
    if (path == "/dev/null") return devices::null()->status();
    if (path == "/dev/zero" || path == "/dev/full") return devices::zero(false)->status();
    if (path == "/dev/urandom" || path == "/dev/random") return devices::random({})->status();
    if (path == "/dev/fb0" && outside_.pixels)
        return devices::framebuffer(*outside_.pixels, {})->status();
    if (const auto device = input_.open(path)) return device->status();
    if (const auto device = usb_.open(path)) return device->status();
    if (const auto file = open_attribute(path)) return file->status();
    if (path == I2C_BUS && outside_.i2c0) return I2cFile{*outside_.i2c0, {}, {}}.status();
    if (system_text(path)) return devices::status_of_text();
    return std::nullopt;
}

int LinuxKernel::remove_system(const std::string& path) {
    if (network_.remove_path(path) || nodes_.erase(path)) return 0;
    if (!begins(path, SHARED_FOLDER)) return -EACCES;
    return shared_files_.erase(path.substr(std::strlen(SHARED_FOLDER))) ? 0 : -ENOENT;
}

// The C library makes semaphores so that have a name.
LinuxKernel::Result LinuxKernel::sys_link(const Arguments& a) {
    const auto from = memory().string(a[0]), to = memory().string(a[1]);
    if (!from || !to) return -EFAULT;
    if (!begins(*from, SHARED_FOLDER) || !begins(*to, SHARED_FOLDER)) {
        not_emulated("link");
        return -ENOSYS;
    }
    const auto found = shared_files_.find(from->substr(std::strlen(SHARED_FOLDER)));
    if (found == shared_files_.end()) return -ENOENT;
    const std::string name = to->substr(std::strlen(SHARED_FOLDER));
    return shared_files_.emplace(name, found->second).second ? 0 : -EEXIST;
}

// ---- Files without a name -----------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::give_two(std::uint32_t to, const std::array<int, 2>& numbers) {
    if (numbers[0] >= 0 && numbers[1] >= 0 && memory().write(to, numbers.data(), sizeof numbers))
        return 0;
    for (const int number : numbers)
        if (number >= 0) files().close(number);
    return numbers[0] < 0 || numbers[1] < 0 ? -EMFILE : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_pipe2(const Arguments& a) {
    if (a[1] & ~(arm_open::CLOEXEC | arm_open::NONBLOCK | arm_open::DIRECT)) return -EINVAL;
    auto [reader, writer] = make_pipe();
    const int first = files().add(std::move(reader), a[1] | arm_open::RDONLY);
    return give_two(a[0], {first, files().add(std::move(writer), a[1] | arm_open::WRONLY)});
}

LinuxKernel::Result LinuxKernel::sys_pipe(const Arguments& a) { return sys_pipe2({a[0], 0}); }

LinuxKernel::Result LinuxKernel::sys_eventfd2(const Arguments& a) {
    constexpr std::uint32_t AS_SEMAPHORE = 1;
    if (a[1] & ~(AS_SEMAPHORE | arm_open::CLOEXEC | arm_open::NONBLOCK)) return -EINVAL;
    return files().add(devices::event(a[0], a[1] & AS_SEMAPHORE),
                       (a[1] & ~AS_SEMAPHORE) | arm_open::RDWR);
}

LinuxKernel::Result LinuxKernel::sys_eventfd(const Arguments& a) { return sys_eventfd2({a[0], 0}); }

LinuxKernel::Result LinuxKernel::sys_memfd_create(const Arguments& a) {
    constexpr std::uint32_t CLOSES = 1;
    return files().add(devices::shared(std::make_shared<SharedMemory>()),
                       arm_open::RDWR | (a[1] & CLOSES ? arm_open::CLOEXEC : 0));
}

}  // namespace sim
