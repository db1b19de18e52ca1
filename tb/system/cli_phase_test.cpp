// cli_phase_test.cpp - the processor's timers are in no fixed phase to the fabric's clock.
#include <gmock/gmock.h>

#include <sstream>

#include "tb/system/cli.h"

namespace {

class Phases : public tb::CommandLine {
protected:
    // The numbers after `name` on the console.
    std::vector<double> counts(const std::string& name) const {
        const std::string text = file("console.txt");
        std::istringstream line{text.substr(text.find(name) + name.size())};
        std::vector<double> all(16);
        for (double& count : all) line >> count;
        EXPECT_TRUE(line) << text;
        return all;
    }
    // Against 16 equally likely ways: above 37.70 in one of a thousand samples that are so.
    static double chi_square(const std::vector<double>& counts) {
        double all = 0, sum = 0;
        for (const double count : counts) all += count;
        const double expected = all / static_cast<double>(counts.size());
        for (const double count : counts) sum += (count - expected) * (count - expected) / expected;
        return sum;
    }
    void run(const char* seed) const {
        const tb::Outcome outcome = de1sim({LOW_BITS_ELF, "--frames", "none", "--seed", seed,
                                            "--duration", "1s", "--out", out.string()});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
};

TEST_F(Phases, AreSpreadEvenlyAfterARegisterOfTheFpga) {
    run("1");
    EXPECT_LT(chi_square(counts("after KEY:")), 37.70) << file("console.txt");
}

TEST_F(Phases, AreSpreadEvenlyInAnInterruptOfTheFpga) {
    run("1");
    EXPECT_LT(chi_square(counts("in an interrupt:")), 37.70) << file("console.txt");
}

TEST_F(Phases, AreTheSameInEveryRunOfASeed) {
    run("1");
    const std::string first = file("console.txt");
    run("1");
    EXPECT_EQ(file("console.txt"), first);
    run("2");
    EXPECT_NE(file("console.txt"), first);
}

}  // namespace
