// kernel_modules.cpp - LinuxKernel's modules: loading them, requests to them, their files
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

const char* word_for(kmod_operation operation) {
    switch (operation) {
        case KMOD_OPEN: return "open";
        case KMOD_RELEASE: return "release";
        case KMOD_FLUSH: return "close";
        case KMOD_READ: return "read";
        case KMOD_WRITE: return "write";
        case KMOD_SEEK: return "lseek";
        case KMOD_IOCTL: return "ioctl";
        case KMOD_MMAP: return "mmap";
        case KMOD_POLL: return "poll";
        case KMOD_FASYNC: return "fasync";
        case KMOD_EXIT: return "exit";
        case KMOD_INITIALISED: break;
    }
    return "init";
}

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

// ---- Loading ------------------------------------------------------------------------------------

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

// ---- Requests -----------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::request(KernelModule& module, ModuleRequest request,
                                         const std::string& what) {
    account();
    auto shared = std::make_shared<ModuleRequest>(std::move(request));
    LinuxThread* const thread = shared->thread;
    shared->process = thread ? &thread->process : nullptr;
    module.requests.push_back(shared);
    if (!module.idle.empty()) {
        LinuxThread* const server = module.idle.back();
        module.idle.pop_back();
        serve(module, *server);
    }
    if (!thread) return std::nullopt;
    LinuxWait wait;
    wait.what = what;
    wait.uninterrupted = true;
    wait.interrupted = [this, &module, thread] {
        for (const auto& [server, served] : module.served)
            if (served->thread == thread && server->wait && server->wait->by_signal)
                resume(*server, -EINTR);
    };
    return this->wait(std::move(wait));
}

// It runs at once, in place of the program's thread.
void LinuxKernel::serve(KernelModule& module, LinuxThread& server) {
    const auto request = module.requests.front();
    module.requests.pop_front();
    module.served[&server] = request;
    kmod_request words{};
    words.operation = request->operation;
    words.file = request->file;
    words.flags = request->flags;
    words.a = request->arguments[0];
    words.b = request->arguments[1];
    words.c = request->arguments[2];
    words.is_last = module.idle.empty();
    if (request->thread) {
        words.pid = static_cast<std::uint32_t>(request->thread->number);
        const std::string& command = request->thread->process.command;
        command.substr(command.rfind('/') + 1).copy(words.command, sizeof words.command - 1);
        server.share = request->thread->share;
        next_ = &server;
    }
    module.process->memory->write(server.request, &words, sizeof words);
    resume(server, 0);
}

// The server's thread has answered, or begins.
LinuxKernel::Result LinuxKernel::module_next(KernelModule& module, std::uint32_t at) {
    kmod_request answer;
    LinuxThread& server = *running_;
    if (!memory().read(at, &answer, sizeof answer)) return -EFAULT;
    server.request = at;
    const auto served = module.served.find(&server);
    if (served != module.served.end()) {
        const auto request = served->second;
        module.served.erase(served);
        finish(module, *request,
               static_cast<std::int64_t>(
                   std::uint64_t{static_cast<std::uint32_t>(answer.result_high)} << 32 |
                   static_cast<std::uint32_t>(answer.result)));
        if (running_ != &server) return std::nullopt;  // the module is no more
    } else if (!module.initialised) {
        module.initialised = answer.result;
        const auto on_initialised = std::move(module.on_initialised);
        const int result = answer.result;
        if (result < 0) unload(module);
        on_initialised(result);
        if (result < 0) return std::nullopt;
    }
    LinuxWait wait;
    wait.what = "a request";
    wait.inside = wait.uninterrupted = wait.idle = true;
    const Result result = this->wait(std::move(wait));
    module.idle.push_back(&server);
    if (!module.requests.empty()) {
        module.idle.pop_back();
        suspend();
        serve(module, server);
    }
    return result;
}

// The program's thread gets the result.
void LinuxKernel::finish(KernelModule& module, const ModuleRequest& request, std::int64_t result) {
    constexpr std::int64_t RESTARTSYS = -512, RESTARTNOINTR = -513;
    LinuxThread* const thread = request.thread;
    changed_ = true;
    if (request.operation != KMOD_POLL) poll_again();
    account();
    if (!thread) {
        if (request.finish) request.finish(result);
        if (request.operation == KMOD_OPEN && result > 0)
            this->request(module, {KMOD_RELEASE, static_cast<std::uint32_t>(result)}, "");
        return;
    }
    thread->share = running_->share;
    if (result == RESTARTSYS || result == RESTARTNOINTR) {
        thread->restarts = true;
        resume(*thread, std::nullopt);
    } else {
        LinuxProcess* const present = std::exchange(process_, &thread->process);
        const Result given = request.finish ? request.finish(result) : Result{result};
        process_ = running_ ? present : processes_.front().get();
        resume(*thread, given);
    }
    next_ = thread;
}

// A thread or a process ends while a module works for it.
void LinuxKernel::forget_requests_of(const LinuxThread& thread) {
    for (const auto& module : modules_) {
        const auto forget = [&](ModuleRequest& request) {
            if (request.thread != &thread) return;
            request.thread = nullptr;
            request.process = nullptr;
            request.finish = nullptr;
        };
        for (const auto& request : module->requests) forget(*request);
        for (const auto& [server, request] : module->served) forget(*request);
        module->served.erase(const_cast<LinuxThread*>(&thread));
        const auto idle = std::remove(module->idle.begin(), module->idle.end(), &thread);
        module->idle.erase(idle, module->idle.end());
    }
    for (auto& [number, interrupt] : interrupts_) {
        if (interrupt.waiting == &thread) interrupt.waiting = nullptr;
        if (interrupt.running == &thread) interrupt.running = nullptr;
    }
    if (next_ == &thread) next_ = nullptr;
}

// A module does something for it.
bool LinuxKernel::is_in_module(const LinuxThread& thread) const {
    for (const auto& module : modules_)
        for (const auto& [server, request] : module->served)
            if (request->thread == &thread) return true;
    return false;
}

// Whose memory lies below the kernel's while this thread of a module runs.
const LinuxProcess* LinuxKernel::process_below(const LinuxThread& thread) const {
    const auto& served = thread.process.module->served;
    const auto found = served.find(const_cast<LinuxThread*>(&thread));
    return found == served.end() ? nullptr : found->second->process;
}

// ---- Files --------------------------------------------------------------------------------------

ModuleFile* LinuxKernel::module_file(int fd) const {
    return modules_.empty() ? nullptr : dynamic_cast<ModuleFile*>(files().device(fd));
}

LinuxKernel::Result LinuxKernel::open_module(const ModuleNode& node, const std::string& path,
                                             std::uint32_t flags) {
    ModuleRequest request{KMOD_OPEN};
    request.thread = running_;
    request.flags = flags & ~arm_open::CLOEXEC;
    request.arguments[0] = node.id;
    request.arguments[1] = node.number;
    request.finish = [this, node, path, flags](std::int64_t result) -> Result {
        if (result < 0) return result;
        const auto on_close = [this](ModuleFile& file) {
            if (over_) return;
            ModuleRequest release{KMOD_RELEASE, file.id};
            this->request(file.module, std::move(release), "");
        };
        const auto on_poll = [this](ModuleFile& file) { poll_module(file); };
        auto file = std::make_shared<ModuleFile>(*node.module, static_cast<std::uint32_t>(result),
                                                 path, status_of(node), on_close, on_poll);
        return files().add(std::move(file), flags);
    };
    return this->request(*node.module, std::move(request), "open of " + path);
}

LinuxKernel::Result LinuxKernel::request(int fd, ModuleFile& file, kmod_operation operation,
                                         std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    ModuleRequest request{operation, file.id,  static_cast<std::uint32_t>(files().flags(fd)),
                          {a, b, c}, running_, nullptr,
                          {}};
    return this->request(file.module, std::move(request),
                         fmt::format("{} of {}", word_for(operation), file.name()));
}

LinuxKernel::Result LinuxKernel::map_module(int fd, ModuleFile& file, const Arguments& a,
                                            std::uint32_t bytes) {
    const auto place = place_of(a[0], bytes, a[3]);
    if (!place) return -ENOMEM;
    if (!memory().map(*place, bytes, 0)) return -ENOMEM;  // what the module maps replaces it
    ModuleRequest request{KMOD_MMAP,
                          file.id,
                          static_cast<std::uint32_t>(files().flags(fd)),
                          {*place, bytes, a[5]},
                          running_,
                          nullptr,
                          {}};
    request.finish = [this, place = *place, bytes](std::int64_t result) -> Result {
        if (static_cast<std::int32_t>(result) >= 0) return place;
        memory().unmap(place, bytes);
        return result;
    };
    return this->request(file.module, std::move(request), "mmap of " + file.name());
}

}  // namespace sim
