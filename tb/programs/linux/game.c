// game.c - a dot on LEDR that a and d move: it checks for a key every 20 ms, until a q.
//
// With the argument "poll" it uses poll(), with "read" a non-blocking read().  "waits" measures how
// long select() and poll() wait until a timeout, and for a line.
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/select.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static volatile unsigned* lw;

static long now_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static int by_select(struct timeval* timeout) {
    fd_set keys;
    FD_ZERO(&keys);
    FD_SET(STDIN_FILENO, &keys);
    const int count = select(STDIN_FILENO + 1, &keys, NULL, NULL, timeout);
    return count == FD_ISSET(STDIN_FILENO, &keys) ? count : -2;
}

static int by_poll(int timeout_ms) {
    struct pollfd keys = {STDIN_FILENO, POLLIN, 0};
    const int count = poll(&keys, 1, timeout_ms);
    return count == (keys.revents == POLLIN) ? count : -2;
}

// The key, 0 where none was pressed, or -1.
static int key(const char* how) {
    char c = 0;
    if (strcmp(how, "read") == 0) {
        const long count = read(STDIN_FILENO, &c, 1);
        return count == 1 ? c : errno == EAGAIN ? 0 : -1;
    }
    struct timeval at_once = {0, 0};
    const int pressed = strcmp(how, "poll") == 0 ? by_poll(0) : by_select(&at_once);
    if (pressed <= 0) return pressed;
    return read(STDIN_FILENO, &c, 1) == 1 ? c : -1;
}

static int play(const char* how) {
    struct termios settings;
    tcgetattr(STDIN_FILENO, &settings);
    settings.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &settings);
    if (strcmp(how, "read") == 0) {
        fcntl(STDIN_FILENO, F_SETFL, fcntl(STDIN_FILENO, F_GETFL) | O_NONBLOCK);
        if (!(fcntl(STDIN_FILENO, F_GETFL) & O_NONBLOCK)) return 3;
    }
    const int mem = open("/dev/mem", O_RDWR | O_SYNC);
    lw = mmap(NULL, 0x5000, PROT_READ | PROT_WRITE, MAP_SHARED, mem, 0xFF200000);
    if (lw == MAP_FAILED) return 1;
    int place = 5, pictures = 0, c = 0;
    for (; c != 'q'; ++pictures) {
        c = key(how);
        if (c < 0) return 2;
        if (c == 'a' && place < 9) ++place;
        if (c == 'd' && place > 0) --place;
        lw[0] = 1u << place;
        lw[8] = (unsigned)pictures;  // HEX3-0
        usleep(20000);
    }
    printf("over after %d pictures\n", pictures);
    return 0;
}

static int waits(void) {
    long begin = now_ms();
    struct timeval timeout = {0, 50000};
    int count = by_select(&timeout);
    printf("select: %d after %ld ms, %ld us left\n", count, now_ms() - begin,
           (long)timeout.tv_usec);
    begin = now_ms();
    count = by_poll(30);
    printf("poll: %d after %ld ms\n", count, now_ms() - begin);
    printf("type\n");
    begin = now_ms();
    timeout.tv_sec = 1;
    count = by_select(&timeout);
    const long left_ms = timeout.tv_sec * 1000 + timeout.tv_usec / 1000;
    printf("select: %d, %s\n", count, now_ms() - begin + left_ms <= 1000 ? "in time" : "late");
    printf("poll: %d\n", by_poll(-1));
    char line[8] = "";
    printf("read: %ld\n", (long)read(STDIN_FILENO, line, sizeof line));
    struct timeval at_once = {0, 0};
    printf("select: %d\n", by_select(&at_once));
    struct pollfd others[2] = {{STDOUT_FILENO, POLLOUT, 0}, {77, POLLIN, 0}};
    const int found = poll(others, 2, -1);
    printf("poll: %d, %d, %d\n", found, others[0].revents == POLLOUT,
           others[1].revents == POLLNVAL);
    return 0;
}

int main(int argc, char** argv) {
    const char* how = argc > 1 ? argv[1] : "select";
    return strcmp(how, "waits") == 0 ? waits() : play(how);
}
