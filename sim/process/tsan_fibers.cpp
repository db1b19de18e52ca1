// tsan_fibers.cpp - ThreadSanitizer knows SystemC's coroutines; in sanitized builds only.
//
// libsystemc notifies sanitizers of a switch by yield(), but not of one by abort(), with which a
// process ends.  The last process to run often ends so, and then the main stack is returned to.
// This stands before both functions; libsystemc calls them by a table, which the dynamic linker
// fills in with the first of each name.
#include <dlfcn.h>
#include <sanitizer/tsan_interface.h>
#include <sysc/kernel/sc_cor.h>

#include <map>

#define YIELD "_ZN7sc_core13sc_cor_pkg_qt5yieldEPNS_6sc_corE"
#define ABORT "_ZN7sc_core13sc_cor_pkg_qt5abortEPNS_6sc_corE"

namespace {

using sc_core::sc_cor;
using sc_core::sc_cor_pkg;
using Switch = void (*)(sc_cor_pkg*, sc_cor*);

std::map<const sc_cor*, void*> fibers;
const sc_cor* current;

// The fiber of a coroutine that begins or goes on; that of the main one is there.
void* begin(sc_cor_pkg* package, const sc_cor* next) {
    if (!current) fibers[current = package->get_main()] = __tsan_get_current_fiber();
    void*& fiber = fibers[next];
    if (!fiber) fiber = __tsan_create_fiber(0);
    current = next;
    return fiber;
}

// The fiber of the coroutine that ends.
void* end() {
    const auto ended = fibers.find(current);
    void* fiber = ended->second;
    fibers.erase(ended);
    return fiber;
}

Switch function(const char* name) { return reinterpret_cast<Switch>(dlsym(RTLD_NEXT, name)); }

}  // namespace

extern "C" {

void tsan_yield(sc_cor_pkg* package, sc_cor* next) __asm__(YIELD);
void tsan_abort(sc_cor_pkg* package, sc_cor* next) __asm__(ABORT);

// Not instrumented, since they are entered on one fiber and left on another.
__attribute__((no_sanitize("thread"))) void tsan_yield(sc_cor_pkg* package, sc_cor* next) {
    static const Switch real = function(YIELD);
    __tsan_switch_to_fiber(begin(package, next), 0);
    real(package, next);
}

__attribute__((no_sanitize("thread"))) void tsan_abort(sc_cor_pkg* package, sc_cor* next) {
    static const Switch real = function(ABORT);
    void* const ended = end();
    __tsan_switch_to_fiber(begin(package, next), 0);
    __tsan_destroy_fiber(ended);
    real(package, next);
}

}  // extern "C"
