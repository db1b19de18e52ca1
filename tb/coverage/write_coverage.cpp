// Writes the coverage counters of every Verilated model when it ends, into a file of its own.
//
// The counters lie in the model and die with it, and the tests' models die with their fixtures: too
// early for a write at exit.  So the linker (--wrap) puts this in front of the destructor of
// VerilatedSyms, the base class of each model's data.
#include <unistd.h>

#include <string>

#include <verilated.h>
#include <verilated_cov.h>

extern "C" {
// VerilatedSyms::~VerilatedSyms()
void __real__ZN13VerilatedSymsD2Ev(VerilatedSyms* model);

void __wrap__ZN13VerilatedSymsD2Ev(VerilatedSyms* model) {
    static unsigned models = 0;
    const std::string file =
        COVERAGE_DATA "/" + std::to_string(getpid()) + "-" + std::to_string(models++) + ".dat";
    model->_vm_contextp__->coveragep()->write(file.c_str());
    __real__ZN13VerilatedSymsD2Ev(model);
}
}
