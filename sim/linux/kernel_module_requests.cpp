// kernel_module_requests.cpp - LinuxKernel's requests to modules, and the files that make them
#include <algorithm>
#include <cerrno>
#include <utility>

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

}  // namespace

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
