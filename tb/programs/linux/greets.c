// greets.c - a program with a library of its own; with an argument that writes to nowhere, with two
// it looks for another one
#include <dlfcn.h>
#include <stddef.h>

void greet(int* to);

int main(int count, char** arguments) {
    int done = 0;
    if (count > 2) return dlopen("libsongs.so.2", RTLD_NOW) != NULL;
    greet(count > 1 && arguments[1] ? NULL : &done);
    return !done;
}
