// newlib.cpp - the system calls of newlib: memory, a console, exit.
#include <sys/stat.h>

#include <cerrno>
#include <cstddef>

#include "hal/console.h"
#include "processor.h"

extern "C" {

extern char __heap_start[], __heap_end[];
void* __dso_handle = nullptr;

void* _sbrk(std::ptrdiff_t bytes) {
    static char* end = __heap_start;
    if (bytes > __heap_end - end) {
        errno = ENOMEM;
        return reinterpret_cast<void*>(-1);
    }
    char* const before = end;
    end += bytes;
    return before;
}

int _write(int, const char* text, int count) {
    bare::Registers io;
    hal::Console console{io};
    for (int i = 0; i < count; ++i) {
        if (text[i] == '\n') console.send('\r');
        console.send(text[i]);
    }
    return count;
}

[[noreturn]] void _exit(int) {
    for (;;) asm volatile("wfi");
}

void _init() {}
void _fini() {}
int _kill(int, int) { _exit(1); }
int _getpid() { return 1; }
int _read(int, char*, int) { return 0; }
int _close(int) { return -1; }
int _lseek(int, int, int) { return 0; }
int _isatty(int) { return 1; }
int _fstat(int, struct stat* status) {
    status->st_mode = S_IFCHR;
    return 0;
}

}  // extern "C"
