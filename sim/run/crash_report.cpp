// crash_report.cpp - see crash_report.h
#include "sim/run/crash_report.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

#include "sim/files/whole_file.h"
#include "sim/run/run.h"
#include "sim/text/messages.h"

namespace sim {

namespace {

struct Ending {
    int signal;
    const char* fault;
};
constexpr Ending ENDINGS[] = {
    {SIGSEGV, "internal error: de1sim was ended by SIGSEGV"},
    {SIGBUS, "internal error: de1sim was ended by SIGBUS"},
    {SIGFPE, "internal error: de1sim was ended by SIGFPE"},
    {SIGILL, "internal error: de1sim was ended by SIGILL"},
    {SIGABRT, "internal error: de1sim was ended by SIGABRT"},
};

struct File {
    std::string path, part, text;
};
using Files = std::array<File, 2>;
struct Prepared {
    std::array<Files, std::size(ENDINGS)> endings;
};

// A signal handler can reach nothing else.  One is renewed while the other one counts.
Prepared prepared[2];
volatile std::sig_atomic_t counts = 0;
alignas(16) char stack[1 << 16];  // the program's own may be what is at its end

void write_prepared(const File& file) {
    const int descriptor = open(file.part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) return;
    const char* at = file.text.data();
    std::size_t left = file.text.size();
    while (left > 0) {
        const ssize_t written = write(descriptor, at, left);
        if (written <= 0) return;
        at += written;
        left -= static_cast<std::size_t>(written);
    }
    close(descriptor);
    rename(file.part.c_str(), file.path.c_str());
}

void on_death(int signal) {
    for (std::size_t i = 0; i < std::size(ENDINGS); ++i) {
        if (ENDINGS[i].signal != signal) continue;
        remove_open_parts();
        for (const File& file : prepared[counts].endings[i]) write_prepared(file);
        constexpr std::string_view NAME = "de1sim: ", NEWLINE = "\n";
        for (const std::string_view text : {NAME, std::string_view{ENDINGS[i].fault}, NEWLINE})
            [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    }
    _exit(WRONG_INPUT);
}

// SIGBUS is that of a full disk where waveforms are written, and stays theirs.  What a translator
// of instructions has put on SIGSEGV only says so and goes on.
void handle_by(void (*handler)(int)) {
#ifndef __SANITIZE_ADDRESS__
    for (const Ending& ending : ENDINGS) {
        struct sigaction action {};
        sigaction(ending.signal, nullptr, &action);
        const bool theirs = action.sa_handler != SIG_DFL && action.sa_handler != on_death;
        if (ending.signal == SIGBUS && theirs) continue;
        action = {};
        action.sa_handler = handler;
        action.sa_flags = SA_ONSTACK | SA_RESETHAND;
        sigaction(ending.signal, &action, nullptr);
    }
#else
    (void)handler;
#endif
}

}  // namespace

CrashReport::CrashReport(const std::filesystem::path& out, const RunReport& report)
    : report_{report} {
    report_.end = RunEnd::INTERNAL_ERROR;
    for (Prepared& each : prepared)
        for (Files& files : each.endings) {
            files[0].path = (out / "report.json").string();
            files[1].path = (out / "junit.xml").string();
            for (File& file : files) file.part = file.path + ".part";
        }
    renew(0, 0);
    stack_t alternate{};
    alternate.ss_sp = stack;
    alternate.ss_size = sizeof stack;
    sigaltstack(&alternate, nullptr);
    handle_by(on_death);
}

CrashReport::~CrashReport() { handle_by(SIG_DFL); }

void CrashReport::renew(double simulated_s, std::uint64_t frames_shown) {
    report_.simulated_s = simulated_s;
    report_.frames_shown = frames_shown;
    const int other = 1 - counts;
    for (std::size_t i = 0; i < std::size(ENDINGS); ++i) {
        report_.faults = {ENDINGS[i].fault};
        prepared[other].endings[i][0].text = to_json(report_);
        prepared[other].endings[i][1].text = to_junit(report_);
    }
    counts = other;
}

}  // namespace sim
