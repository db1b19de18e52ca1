// qemu-arm, which is QEMU for programs of one user, as a Machine.
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include "tb/sim/arm_core/machine.h"
#include "tb/sim/arm_core/qemu_shared.h"

namespace tb::core {

namespace {

static_assert(CODE == QEMU_CODE && DATA == QEMU_DATA && FAR_DATA == QEMU_FAR_DATA);
static_assert(PART == QEMU_PART && PARTS == QEMU_PARTS);

[[noreturn]] void fail(const char* what) {
    throw std::system_error{errno, std::generic_category(), what};
}

class Qemu final : public Machine {
public:
    Qemu() {
        const int file = memfd_create("qemu_shared", 0);
        if (file < 0 || ftruncate(file, sizeof(QemuShared)) != 0) fail("shared memory");
        void* const memory_ =
            mmap(nullptr, sizeof(QemuShared), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        if (memory_ == MAP_FAILED) fail("shared memory");
        shared_ = static_cast<QemuShared*>(memory_);
        int in[2], out[2];
        if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) fail("pipe");
        child_ = fork();
        if (child_ == 0) {
            dup2(in[0], STDIN_FILENO);
            dup2(out[1], STDOUT_FILENO);
            const std::string path = "/proc/self/fd/" + std::to_string(file);
            execl(QEMU_ARM, "qemu-arm", "-cpu", "cortex-a9", QEMU_GUEST, path.c_str(), nullptr);
            _exit(127);
        }
        close(in[0]);
        close(out[1]);
        to_ = in[1];
        from_ = out[0];
        wait_for_stop();
    }
    ~Qemu() override {
        close(to_);
        close(from_);
        waitpid(child_, nullptr, 0);
        munmap(shared_, sizeof *shared_);
    }

    void set(const State& state) override { state_ = state; }
    State state() const override { return state_; }

    std::uint32_t run(std::uint32_t begin, std::uint32_t, unsigned) override {
        std::memcpy(shared_->code, memory->code.data(), PART);
        std::memcpy(shared_->data, memory->data.data(), PART);
        std::copy(state_.r.begin(), state_.r.end(), shared_->r);
        std::copy(state_.d.begin(), state_.d.end(), shared_->d);
        shared_->r[15] = begin;
        shared_->cpsr = state_.cpsr;
        shared_->fpscr = state_.fpscr;
        shared_->changed_begin = changed_begin_ - CODE;
        shared_->changed_bytes = changed_end_ - changed_begin_;
        changed_begin_ = changed_end_ = CODE;
        if (write(to_, "g", 1) != 1) fail("qemu-arm");
        wait_for_stop();
        std::memcpy(memory->data.data(), shared_->data, PART);
        std::copy(shared_->r, shared_->r + 15, state_.r.begin());
        std::copy(shared_->d, shared_->d + 32, state_.d.begin());
        state_.cpsr = shared_->cpsr;
        state_.fpscr = shared_->fpscr;
        if (shared_->signal == SIGBUS) return shared_->r[15] + UNALIGNED;
        return shared_->signal == SIGILL ? shared_->r[15] : OTHER;
    }
    std::uint32_t run_on(std::uint32_t, unsigned) override { return OTHER; }

    void code_changed(std::uint32_t begin, std::uint32_t bytes) override {
        const bool none = changed_begin_ == changed_end_;
        changed_begin_ = none ? begin : std::min(changed_begin_, begin);
        changed_end_ = none ? begin + bytes : std::max(changed_end_, begin + bytes);
    }

private:
    void wait_for_stop() {
        char byte;
        if (read(from_, &byte, 1) != 1) throw std::runtime_error{"qemu-arm has ended"};
    }

    QemuShared* shared_;
    State state_;
    pid_t child_;
    int to_, from_;
    std::uint32_t changed_begin_ = CODE, changed_end_ = CODE + PART;
};

}  // namespace

std::unique_ptr<Machine> qemu() { return std::make_unique<Qemu>(); }

}  // namespace tb::core
