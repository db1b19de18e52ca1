// libgreet.c - a library of one's own: prints, and writes where it is told to
#include <stdio.h>

void greet(int* to) {
    printf("greetings from the library\n");
    fflush(stdout);
    *to = 1;
}
