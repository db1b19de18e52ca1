// asan_stacks.cpp - AddressSanitizer knows on which stack the program is; in sanitized builds only.
//
// libsystemc reports each switch between coroutines by yield(), but without bounds for the main
// stack: after the first one, an exception there would not clear the marks of dead variables, which
// ends in a false alarm.  A switch by abort(), with which a process ends, it does not report: the
// leak check at the end would then look through the stack of that process, which is gone.  So the
// two functions here stand before the sanitizer's and SystemC's.
#include <dlfcn.h>
#include <pthread.h>
#include <sysc/kernel/sc_cor.h>

#include <cstddef>

#define ABORT "_ZN7sc_core13sc_cor_pkg_qt5abortEPNS_6sc_corE"

namespace {

struct Stack {
    void* bottom = nullptr;
    std::size_t size = 0;

    Stack() {
        pthread_attr_t attributes;
        if (pthread_getattr_np(pthread_self(), &attributes) != 0) return;
        pthread_attr_getstack(&attributes, &bottom, &size);
        pthread_attr_destroy(&attributes);
    }
};

// How sc_cor_qt begins in SystemC 2.3.4; its header is not installed.  The main one has no stack.
struct Coroutine {
    const void* functions;
    std::size_t stack_size;
    void* stack;
};

}  // namespace

extern "C" {

void __sanitizer_finish_switch_fiber(void* save, const void** bottom, std::size_t* size);

__attribute__((no_sanitize("address"))) void __sanitizer_start_switch_fiber(void** save,
                                                                            const void* bottom,
                                                                            std::size_t size) {
    using Function = void (*)(void**, const void*, std::size_t);
    static const auto next =
        reinterpret_cast<Function>(dlsym(RTLD_NEXT, "__sanitizer_start_switch_fiber"));
    static const Stack main_stack;
    if (bottom)
        next(save, bottom, size);
    else
        next(save, main_stack.bottom, main_stack.size);
}

void asan_abort(sc_core::sc_cor_pkg* package, sc_core::sc_cor* next) __asm__(ABORT);

__attribute__((no_sanitize("address"))) void asan_abort(sc_core::sc_cor_pkg* package,
                                                        sc_core::sc_cor* next) {
    using Function = void (*)(sc_core::sc_cor_pkg*, sc_core::sc_cor*);
    static const auto real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, ABORT));
    const auto* coroutine = reinterpret_cast<const Coroutine*>(next);
    __sanitizer_start_switch_fiber(nullptr, coroutine->stack, coroutine->stack_size);
    __sanitizer_finish_switch_fiber(nullptr, nullptr, nullptr);
    real(package, next);
}

}  // extern "C"
