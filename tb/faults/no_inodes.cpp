// no_inodes.cpp - a file system without room for another file, as a library to be preloaded: when
// NEW_FILES of them have been made, files and folders that are not there yet are ENOSPC.
#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

namespace {

std::atomic<long> made{0};

bool there_is_room(int folder, const char* path) {
    if (faccessat(folder, path, F_OK, AT_SYMLINK_NOFOLLOW) == 0) return true;
    const char* most = getenv("NEW_FILES");
    if (!most || made++ < atol(most)) return true;
    errno = ENOSPC;
    return false;
}

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int open_it(int folder, const char* path, int flags, mode_t mode) {
    if (flags & O_CREAT && !there_is_room(folder, path)) return -1;
    return next<int (*)(int, const char*, int, ...)>("openat")(folder, path, flags, mode);
}

FILE* open_stream(const char* name, const char* path, const char* mode) {
    if (strpbrk(mode, "wa") && !there_is_room(AT_FDCWD, path)) return nullptr;
    return next<FILE* (*)(const char*, const char*)>(name)(path, mode);
}

mode_t mode_of(int flags, va_list rest) { return flags & O_CREAT ? va_arg(rest, mode_t) : 0; }

}  // namespace

#define OPEN(name)                                          \
    extern "C" int name(const char* path, int flags, ...) { \
        va_list rest;                                       \
        va_start(rest, flags);                              \
        const mode_t mode = mode_of(flags, rest);           \
        va_end(rest);                                       \
        return open_it(AT_FDCWD, path, flags, mode);        \
    }
#define OPEN_AT(name)                                                   \
    extern "C" int name(int folder, const char* path, int flags, ...) { \
        va_list rest;                                                   \
        va_start(rest, flags);                                          \
        const mode_t mode = mode_of(flags, rest);                       \
        va_end(rest);                                                   \
        return open_it(folder, path, flags, mode);                      \
    }
OPEN(open)
OPEN(open64)
OPEN_AT(openat)
OPEN_AT(openat64)
extern "C" FILE* fopen(const char* path, const char* mode) {
    return open_stream("fopen", path, mode);
}
extern "C" FILE* fopen64(const char* path, const char* mode) {
    return open_stream("fopen64", path, mode);
}
extern "C" int mkdir(const char* path, mode_t mode) {
    if (!there_is_room(AT_FDCWD, path)) return -1;
    return next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}
extern "C" char* mkdtemp(char* path) {
    if (!there_is_room(AT_FDCWD, path)) return nullptr;
    return next<char* (*)(char*)>("mkdtemp")(path);
}
