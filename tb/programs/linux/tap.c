// tap.c - a program that tests itself and finds a mistake
#include <stdio.h>

int main(void) {
    printf("TAP version 13\n1..2\nok 1 - subtracts\nnot ok 2 - adds: 2 + 2 is 5\n");
    return 0;
}
