// Writes the coverage counters of every Verilated model when it ends, into a file of its own.
//
// The counters are part of the model.  Most tests' models are destroyed with their fixtures, before
// the process exits; those that SystemC holds are not destroyed at all.  So the linker (--wrap)
// calls this before the destructor of VerilatedSyms, the base class of each model's data, and after
// its constructor, which sees to it that models that are left are written at the process's exit.
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string>

#include <verilated.h>
#include <verilated_cov.h>

namespace {

VerilatedContext* context = nullptr;  // of the models that are not written yet

void write_counters() {
    if (!context) return;
    // Process ids alone come again.
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    const std::string file =
        COVERAGE_DATA "/" + std::to_string(getpid()) + "-" + std::to_string(now) + ".dat";
    context->coveragep()->write(file.c_str());
    context->coveragep()->clear();  // the counters go with their model
    context = nullptr;
}

}  // namespace

extern "C" {
// VerilatedSyms::VerilatedSyms(VerilatedContext*), VerilatedSyms::~VerilatedSyms()
void __real__ZN13VerilatedSymsC2EP16VerilatedContext(VerilatedSyms* model, VerilatedContext* of);
void __real__ZN13VerilatedSymsD2Ev(VerilatedSyms* model);

void __wrap__ZN13VerilatedSymsC2EP16VerilatedContext(VerilatedSyms* model, VerilatedContext* of) {
    __real__ZN13VerilatedSymsC2EP16VerilatedContext(model, of);
    static const int registered = std::atexit(write_counters);
    static_cast<void>(registered);
    context = model->_vm_contextp__;
}

void __wrap__ZN13VerilatedSymsD2Ev(VerilatedSyms* model) {
    write_counters();
    __real__ZN13VerilatedSymsD2Ev(model);
}
}
