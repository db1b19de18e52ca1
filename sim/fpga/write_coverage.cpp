// Writes the coverage counters of every Verilated model when it ends, into a file of its own.
//
// The counters are part of the model, and the tests' models are destroyed with their fixtures,
// before the process exits.  So the linker (--wrap) calls this before the destructor of
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
