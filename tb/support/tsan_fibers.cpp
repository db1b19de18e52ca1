// tsan_fibers.cpp - tells ThreadSanitizer of SystemC's coroutines; in sanitized builds only.
//
// libsystemc reports each switch between coroutines in AddressSanitizer's way, if its functions are
// there.  Each stack, named by its bottom, is a fiber for ThreadSanitizer; the main one has none.
#include <sanitizer/tsan_interface.h>

#include <cstddef>
#include <map>

namespace {

void* fiber_of(const void* bottom) {
    static std::map<const void*, void*> fibers{{nullptr, __tsan_get_current_fiber()}};
    void*& fiber = fibers[bottom];
    if (!fiber) fiber = __tsan_create_fiber(0);
    return fiber;
}

}  // namespace

// Not instrumented, since it is entered on one fiber and left on another.
extern "C" __attribute__((no_sanitize("thread"))) void __sanitizer_start_switch_fiber(
    void**, const void* bottom, std::size_t) {
    __tsan_switch_to_fiber(fiber_of(bottom), 0);
}

extern "C" void __sanitizer_finish_switch_fiber(void*, const void**, std::size_t*) {}
