// asks.c - asks for a number and squares it on HEX and the console, again until its input ends.
//
// With the argument "keys" it takes characters as they come, without echo, until a q.
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <termios.h>
#include <unistd.h>

static int keys(void) {
    struct termios settings;
    if (tcgetattr(0, &settings) != 0) return 2;
    settings.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    if (tcsetattr(0, TCSANOW, &settings) != 0) return 3;
    for (char c = 0; c != 'q';) {
        if (read(0, &c, 1) != 1) return 4;
        printf("[%c]\n", c);
    }
    return 0;
}

int main(int argc, char** argv) {
    if (argc > 1 && strcmp(argv[1], "keys") == 0) return keys();
    const int mem = open("/dev/mem", O_RDWR | O_SYNC);
    volatile unsigned* lw =
        mmap(NULL, 0x5000, PROT_READ | PROT_WRITE, MAP_SHARED, mem, 0xFF200000);
    if (lw == MAP_FAILED) return 1;
    int number;
    while (printf("Number? "), fflush(stdout), scanf("%d", &number) == 1) {
        lw[0] = (unsigned)(number * number);
        printf("squared %d%s\n", number * number, isatty(0) ? "" : " (no terminal)");
    }
    printf("no more\n");
    return 0;
}
