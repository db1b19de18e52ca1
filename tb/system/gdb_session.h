// gdb_session.h - test fixture: de1sim --gdb, driven by the real gdb-multiarch in batch mode
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "tb/system/cli.h"

namespace tb {

class Gdb : public tb::CommandLine {
protected:
    const std::filesystem::path errors = folder / "stderr";
    std::string elf, port;
    std::future<tb::Outcome> server;

    // Starts `de1sim run --gdb 0 WORDS...` and waits until it says its port.
    void start(const std::string& program, const std::string& steps,
               const std::vector<std::string>& words = {}) {
        elf = program;
        const auto file = folder / scenario(steps);
        tb::Command command;
        command.arguments = {"/bin/sh",     "-c",    "exec \"$@\" 2>'" + errors.string() + "'",
                             "sh",          DE1SIM,  "run",
                             file.string(), "--out", out.string(),
                             "--frames",    "none",  "--elf",
                             elf,           "--gdb", "0"};
        command.arguments.insert(command.arguments.end(), words.begin(), words.end());
        server = std::async(std::launch::async, [command] { return tb::run_program(command); });
        std::smatch found;
        for (unsigned i = 0; i < 1000 && port.empty(); ++i) {
            const std::string text = said();
            if (std::regex_search(text, found, std::regex{"waiting for gdb at 127.0.0.1:(\\d+)\n"}))
                port = found[1];
            else
                std::this_thread::sleep_for(std::chrono::milliseconds{10});
        }
        ASSERT_FALSE(port.empty()) << said();
    }
    std::string said() const {
        return std::filesystem::exists(errors) ? folder.get("stderr") : std::string{};
    }

    // What gdb prints for these commands, having connected; it detaches when they are done.
    std::string gdb(const std::vector<std::string>& commands,
                    std::function<bool()> interrupt_when = {}) const {
        tb::Command command;
        command.arguments = {GDB,      "-nx",
                             "-batch", elf,
                             "-iex",   "set debuginfod enabled off",
                             "-ex",    "set confirm off",
                             "-ex",    "target remote 127.0.0.1:" + port};
        for (const std::string& line : commands) {
            command.arguments.push_back("-ex");
            command.arguments.push_back(line);
        }
        command.interrupt_when = std::move(interrupt_when);
        const tb::Outcome outcome = tb::run_program(command);
        EXPECT_FALSE(outcome.timed_out) << outcome.out;
        return outcome.out + outcome.err;
    }
    tb::Outcome end() {
        tb::Outcome outcome = server.get();
        EXPECT_FALSE(outcome.timed_out) << said();
        return outcome;
    }
};

}  // namespace tb
