// signals_test.cpp - send-signal
#include "sim/board/signal_receiver.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

struct Program : sim::SignalReceiver {
    std::string got;
    void send(unsigned signal, int process) override {
        got = std::to_string(signal) + " to " + std::to_string(process);
    }
};

class SignalSteps : public StepTest {
protected:
    Program program;
    SignalSteps() { board.parts->add("Linux program", program); }

    std::string error(const std::string& text) {
        try {
            read_step(text, "a.yaml");
        } catch (const std::exception& e) {
            return e.what();
        }
        return "none";
    }
};

TEST_F(SignalSteps, SendToTheProgramOrAProcess) {
    acts("send-signal: SIGUSR1");
    EXPECT_EQ(program.got, "10 to 101");
    acts("send-signal: {name: SIGSYS, process: 3}");
    EXPECT_EQ(program.got, "31 to 3");
    EXPECT_EQ(said("send-signal: SIGHUP"), "send SIGHUP to the program");
    EXPECT_EQ(said("send-signal: {name: SIGHUP, process: 3}"), "send SIGHUP to process 3");
    EXPECT_TRUE(read_step("send-signal: SIGHUP").step->needs_linux());
}

TEST_F(SignalSteps, RefuseOtherNamesWithTheList) {
    EXPECT_THAT(error("send-signal: SIGUSR3"),
                AllOf(HasSubstr("a.yaml:4:18: expected a signal: SIGHUP, SIGINT, SIGQUIT, "),
                      HasSubstr(", SIGPWR or SIGSYS, got \"SIGUSR3\""),
                      EndsWith("(did you mean \"SIGUSR1\"?)")));
    EXPECT_THAT(error("send-signal: {name: SIGHUP, process: 0}"),
                HasSubstr("expected a process's number, 1 or more, got"));
}

}  // namespace
