// kernel_modules.cpp - LinuxKernel's modules: how they are loaded, initialised and removed
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream{text};
    return {std::istream_iterator<std::string>{stream}, {}};
}

// For this process and those that it starts.
std::string path_of(const SharedMemory& file) {
    return fmt::format("/proc/{}/fd/{}", getpid(), file.fd());
}

std::string without_suffix(const std::string& file) {
    std::string name = std::filesystem::path{file}.stem().string();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

}  // namespace

std::optional<KernelModule*> LinuxKernel::module_named(const std::string& name) const {
    for (const auto& module : modules_)
        if (module->name == name) return module.get();
    return std::nullopt;
}

// Its threads begin when the processor is free; `on_initialised` is called with the result of its
// init function.  std::runtime_error if it cannot be loaded.
KernelModule& LinuxKernel::load_module(ElfProgram program, std::vector<std::string> parameters,
                                       std::function<void(int)> on_initialised) {
    const std::string name = without_suffix(program.file.string());
    if (!program.is_modules())
        throw std::runtime_error{fmt::format(
            "{} is no kernel module that de1sim link has made: compile its C files with de1sim "
            "link FILE.c -o {}.ko",
            program.file.string(), name)};
    if (module_named(name))
        throw std::runtime_error{fmt::format("the module {} is loaded already", name)};
    for (const ElfSegment& segment : program.segments)
        if (!kernel_space().is_free(segment.address & ~(AddressSpace::PAGE - 1),
                                    segment.size + AddressSpace::PAGE))
            throw std::runtime_error{
                fmt::format("the module {} has the same place in memory as one that is loaded: "
                            "link both by one de1sim link",
                            name)};
    auto made = std::make_unique<KernelModule>();
    KernelModule& module = *made;
    module.name = name;
    module.on_initialised = std::move(on_initialised);
    module.process = std::make_unique<LinuxProcess>(
        LinuxProcess{next_number_++, 0, kernel_memory_, LinuxFiles{{}, {}, {}, console_, system_}});
    LinuxProcess& process = *module.process;
    process.module = &module;
    process.command = "/" + name;
    parameters.insert(parameters.begin(), name);
    ArmCore& core = cpu_.core();
    if (running_) running_->save(core);
    process.break_begin = process.break_end =
        loader_.begin(*kernel_memory_, program, std::nullopt, parameters, {});
    process.threads.push_back(std::make_unique<LinuxThread>(process.number, process));
    LinuxThread& first = *process.threads.back();
    first.save(core);
    if (running_) {
        running_->load(core);
        first.share = running_->share;
    }
    program.file = name;
    loader_.add_names(std::move(program));
    scheduler_.add(first, false);
    modules_.push_back(std::move(made));
    return module;
}

AddressSpace& LinuxKernel::kernel_space() {
    if (!kernel_memory_) {
        constexpr std::uint32_t TOP = 0xF0000000;
        kernel_memory_ = std::make_shared<AddressSpace>(cpu_.core(), KERNEL_BASE, TOP);
        kernel_memory_->attach();
    }
    return *kernel_memory_;
}

// The program begins when they are initialised; one that fails ends the run.
void LinuxKernel::load_first_module(const ElfProgram& elf,
                                    const std::vector<std::string>& parameters,
                                    const std::filesystem::path& file) {
    const std::string name = without_suffix(elf.file.string());
    first_modules_.push_back(name);
    KernelModule& module = load_module(elf, parameters, [this, name](int result) {
        changed_ = true;
        if (result == 0) return;
        over_ = true;
        cpu_.end(fmt::format(
            "the module {} cannot be loaded: its init function returned {} ({}) at {:.6f} ms", name,
            result, std::strerror(-result), static_cast<double>(now_ns()) / 1e6));
    });
    module.elf = std::filesystem::absolute(file);
}

void LinuxKernel::load_first_modules() {
    const ElfProgram& program = cpu_.program().elf;
    for (const LinuxSettings::Module& module : settings_.modules)
        load_first_module(module.elf, module.parameters, module.elf.file);
    if (program.is_modules()) load_first_module(program, {}, program.file);
    if (program.modules.empty()) return;
    carried_ = std::make_shared<SharedMemory>(program.modules.data(), program.modules.size());
    ElfProgram carried = load_elf(path_of(*carried_), linux_memory(), Linking::ANY);
    carried.file = program.modules_name;
    load_first_module(carried, {}, path_of(*carried_));
}

bool LinuxKernel::modules_are_initialised() const {
    return std::all_of(modules_.begin(), modules_.end(),
                       [](const auto& module) { return module->initialised.has_value(); });
}

LinuxKernel::Result LinuxKernel::insert_module(const std::string& path, const std::string& host,
                                               std::uint32_t parameters) {
    const auto text = memory().string(parameters);
    if (!text) return -EFAULT;
    try {
        ElfProgram program = load_elf(host, linux_memory(), Linking::ANY);
        program.file = path;
        if (module_named(without_suffix(path))) return -EEXIST;
        LinuxThread* const thread = running_;
        KernelModule& module =
            load_module(std::move(program), words_of(*text), [this, thread](int result) {
                const auto all = threads();
                if (std::find(all.begin(), all.end(), thread) != all.end()) resume(*thread, result);
            });
        std::error_code error;
        module.elf = std::filesystem::read_symlink(host, error);
        LinuxWait wait;
        wait.what = fmt::format("the module {} to be initialised", module.name);
        wait.inside = wait.uninterrupted = true;
        return this->wait(std::move(wait));
    } catch (const std::exception& e) {
        std::string why = e.what();
        if (why.rfind(host + ": ", 0) == 0) why.erase(0, host.size() + 2);
        outside_.log(fmt::format("{}: {}", path, why));
        return -ENOEXEC;
    }
}

LinuxKernel::Result LinuxKernel::sys_finit_module(const Arguments& a) {
    const auto [host, path] = files().on_host(static_cast<int>(a[0]));
    if (host < 0) return -EBADF;
    return insert_module(path, fmt::format("/proc/self/fd/{}", host), a[1]);
}

// The image's name is not known.
LinuxKernel::Result LinuxKernel::sys_init_module(const Arguments& a) {
    const std::uint8_t* const image = memory().bytes(a[0], a[1], arm_access::READ);
    if (!image) return -EFAULT;
    const SharedMemory copy{image, a[1]};
    return insert_module(fmt::format("module{}.ko", modules_.size() + 1), path_of(copy), a[2]);
}

LinuxKernel::Result LinuxKernel::sys_delete_module(const Arguments& a) {
    const auto name = memory().string(a[0]);
    if (!name) return -EFAULT;
    const auto found = module_named(without_suffix(*name));
    if (!found) return -ENOENT;
    if ((*found)->open_files > 0) return -EWOULDBLOCK;
    return remove_module(**found, running_);
}

LinuxKernel::Result LinuxKernel::remove_module(KernelModule& module, LinuxThread* thread) {
    ModuleRequest request{KMOD_EXIT};
    request.thread = thread;
    request.finish = [this, &module](std::int64_t) {
        unload(module);
        return 0;
    };
    return this->request(module, std::move(request), "rmmod " + module.name);
}

// The program ends: its files are closed, then the modules that the run itself has loaded leave, as
// `rmmod` after it would have them.
LinuxKernel::Result LinuxKernel::leave_modules(const Arguments& a) {
    while (process_->threads.size() > 1)
        end_thread(*process_->threads[process_->threads[0].get() == running_ ? 1 : 0]);
    process_->files.close_all(false);
    LinuxWait wait;
    wait.what = "the modules to leave";
    wait.inside = wait.uninterrupted = true;
    wait.look = [this, a, where = cpu_.where()](LinuxWait&) -> Result {
        if (std::any_of(modules_.begin(), modules_.end(),
                        [](const auto& module) { return module->is_busy(); }))
            return std::nullopt;
        while (!first_modules_.empty()) {
            const auto module = module_named(first_modules_.back());
            first_modules_.pop_back();
            if (!module) continue;
            remove_module(**module, nullptr);
            return std::nullopt;
        }
        end_run(a[0] & 0xFF, where);
        return 0;
    };
    return this->wait(std::move(wait));
}

// Its threads and files are no more.
void LinuxKernel::unload(KernelModule& module) {
    for (auto at = interrupts_.begin(); at != interrupts_.end();) {
        if (at->second.module == &module) mask_interrupt(at->first);
        at = at->second.module == &module ? interrupts_.erase(at) : std::next(at);
    }
    LinuxProcess& process = *module.process;
    while (!process.threads.empty()) end_thread(*process.threads.back());
    const std::uint32_t begin = process.break_begin & ~(KERNEL_PLACE_BYTES - 1);
    kernel_memory_->unmap(begin, KERNEL_PLACE_BYTES);
    modules_.erase(std::find_if(modules_.begin(), modules_.end(),
                                [&](const auto& one) { return one.get() == &module; }));
    if (process_ == &process) process_ = processes_.front().get();
    changed_ = true;
}

}  // namespace sim
