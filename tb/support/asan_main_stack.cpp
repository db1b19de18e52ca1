// asan_main_stack.cpp - tells AddressSanitizer where the main stack lies; in sanitized builds only.
//
// libsystemc reports each switch between coroutines, but without bounds for the main stack.  After
// the first switch an exception there would not clear the marks of dead variables, which ends in a
// false alarm.  This wraps the call and adds the bounds.
#include <dlfcn.h>
#include <pthread.h>

#include <cstddef>

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

}  // namespace

extern "C" __attribute__((no_sanitize("address"))) void __sanitizer_start_switch_fiber(
    void** save, const void* bottom, std::size_t size) {
    using Function = void (*)(void**, const void*, std::size_t);
    static const auto next =
        reinterpret_cast<Function>(dlsym(RTLD_NEXT, "__sanitizer_start_switch_fiber"));
    static const Stack main_stack;
    if (bottom)
        next(save, bottom, size);
    else
        next(save, main_stack.bottom, main_stack.size);
}
