// signals.cpp - send-signal: what `kill` from another shell does to a Linux program
#include "sim/board/signal_receiver.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/step_form.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

// By their numbers, from 1.
const std::vector<std::string> SIGNALS{
    "SIGHUP",  "SIGINT",    "SIGQUIT", "SIGILL",   "SIGTRAP", "SIGABRT", "SIGBUS",  "SIGFPE",
    "SIGKILL", "SIGUSR1",   "SIGSEGV", "SIGUSR2",  "SIGPIPE", "SIGALRM", "SIGTERM", "SIGSTKFLT",
    "SIGCHLD", "SIGCONT",   "SIGSTOP", "SIGTSTP",  "SIGTTIN", "SIGTTOU", "SIGURG",  "SIGXCPU",
    "SIGXFSZ", "SIGVTALRM", "SIGPROF", "SIGWINCH", "SIGIO",   "SIGPWR",  "SIGSYS"};
constexpr std::uint64_t MOST = 4'194'304;  // Linux's pid_max at most

class SendSignal : public Action {
public:
    explicit SendSignal(const Values& v)
        : number_{v.number<unsigned>("name")}, process_{v.number<int>("process")} {}

    std::string describe() const override {
        return "send " + SIGNALS[number_] + " to " +
               (process_ == SignalReceiver::PROGRAM ? "the program"
                                                    : "process " + std::to_string(process_));
    }
    bool needs_linux() const override { return true; }
    void act(BoardControl& board) const override {
        auto& program = board.part<SignalReceiver>("Linux program");
        board.act([&program, signal = number_ + 1, process = process_] {
            program.send(signal, process);
        });
    }

private:
    unsigned number_;  // in the list
    int process_;
};

const ValueType SIGNAL = word("a signal: " + list_of(SIGNALS), SIGNALS);
const ValueType PROCESS = whole_number("a process's number, 1 or more", 1, MOST);

}  // namespace

namespace steps {

std::vector<StepForm> signals() {
    return {
        {"send-signal",
         "Send a signal to a Linux program, as `kill` from another shell does, and go on.",
         Notation::BOTH,
         {},
         {{"name", SIGNAL, Need::REQUIRED, "", "SIGUSR1 and so on: those of `kill -l` up to 31."},
          {"process", PROCESS, Need::OPTIONAL, "101",
           "The process's number; the program itself is 101, what it forks first 102. If there is "
           "none the log has a line."}},
         make<SendSignal>},
    };
}

}  // namespace steps

}  // namespace sim
