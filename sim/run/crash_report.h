// crash_report.h - the report of a run that ends by a signal such as SIGSEGV: de1sim's own death.
//
// Between construction and destruction SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT write
// report.json and junit.xml, which say "internal error", and end the process with exit code 2.  A
// handler of a signal may do next to nothing, so the files are made ready while all is well:
// renew() says how far the run has come.
//
// Not handled: pictures, sound and console of such a run, which stay behind as NAME.part or not at
// all; SIGKILL.  Only one at a time may be there.  With the address sanitizer there is none: it
// says more.
#pragma once

#include <filesystem>

#include "sim/report/report.h"

namespace sim {

class CrashReport {
public:
    // Files of `out`, with what `report` says of the run.
    CrashReport(const std::filesystem::path& out, const RunReport& report);
    ~CrashReport();
    CrashReport(const CrashReport&) = delete;
    CrashReport& operator=(const CrashReport&) = delete;

    void renew(double simulated_s, std::uint64_t frames_shown);

private:
    RunReport report_;
};

}  // namespace sim
