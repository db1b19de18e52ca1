// greets.c - a program with a library of its own; with an argument that writes to nowhere
#include <stddef.h>

void greet(int* to);

int main(int count, char** arguments) {
    int done = 0;
    greet(count > 1 && arguments[1] ? NULL : &done);
    return !done;
}
