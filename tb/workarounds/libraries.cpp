// libraries.cpp - NAME: "there", if a library's fault NAME of workarounds.py is there, or "gone".
#include <cstdio>
#include <map>
#include <string>

#include <systemc>

namespace {

// Of 1 ms, 2 ms ... to_seconds() is the nearest number.
bool seconds() {
    for (unsigned ms = 1; ms < 1000; ++ms)
        if (sc_core::sc_time(ms, sc_core::SC_MS).to_seconds() != ms / 1e3) return true;
    return false;
}

}  // namespace

int sc_main(int argc, char** argv) {
    const std::map<std::string, bool (*)()> faults{{"seconds", seconds}};
    const auto fault = faults.find(argc > 1 ? argv[1] : "");
    if (fault == faults.end()) return 2;
    std::puts(fault->second() ? "there" : "gone");
    return 0;
}
