// catches.c - a game on Linux: catch what falls, with a USB keyboard, mouse or gamepad
//
// Left and Right, the mouse or the left stick move the bat at the bottom; Start or Esc ends.  What
// is caught turns the bat greener, what is missed redder.
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/input.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

enum { WIDTH = 320, HEIGHT = 240, BAT = 48, SIZE = 12, DEVICES = 3, PERIOD_NS = 20000000 };

static uint16_t* pixels;
static int stride;  // pixels from one line to the next

static int bat = (WIDTH - BAT) / 2;
static int keys, stick;  // what moves it: -1 to 1; pixels per period
static int over;

static void fill(int x, int y, int width, int height, uint16_t colour) {
    for (int line = y; line < y + height && line < HEIGHT; ++line)
        for (int column = x; column < x + width && column < WIDTH; ++column)
            if (line >= 0 && column >= 0) pixels[line * stride + column] = colour;
}

static void hear(const struct input_event* event) {
    if (event->type == EV_KEY && event->value != 2) {
        if (event->code == KEY_LEFT) keys = -event->value;
        if (event->code == KEY_RIGHT) keys = event->value;
        if (event->code == KEY_ESC || event->code == BTN_START) over = 1;
    }
    if (event->type == EV_REL && event->code == REL_X) bat += event->value;
    if (event->type == EV_ABS && event->code == ABS_X) stick = (event->value - 128) / 16;
}

static void wait_until(const struct timespec* end) {
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, end, NULL);
}

int main(void) {
    struct pollfd devices[DEVICES];
    struct fb_fix_screeninfo screen;
    struct timespec next;
    const int fb = open("/dev/fb0", O_RDWR);
    ioctl(fb, FBIOGET_FSCREENINFO, &screen);
    pixels = mmap(NULL, screen.smem_len, PROT_READ | PROT_WRITE, MAP_SHARED, fb, 0);
    stride = (int)screen.line_length / 2;
    setvbuf(stdout, NULL, _IOLBF, 0);
    for (int i = 0; i < DEVICES; ++i) {
        char path[32], name[64] = "";
        snprintf(path, sizeof path, "/dev/input/event%d", i);
        devices[i] = (struct pollfd){open(path, O_RDONLY | O_NONBLOCK), POLLIN, 0};
        if (ioctl(devices[i].fd, EVIOCGNAME(sizeof name), name) > 0) printf("%s\n", name);
    }
    fill(0, 0, WIDTH, HEIGHT, 0x0008);
    int x = 60, y = 0, caught = 0, missed = 0;
    clock_gettime(CLOCK_MONOTONIC, &next);
    printf("ready\n");
    while (!over) {
        struct input_event event;
        poll(devices, DEVICES, 0);
        for (int i = 0; i < DEVICES; ++i)
            while ((devices[i].revents & POLLIN) &&
                   read(devices[i].fd, &event, sizeof event) == sizeof event)
                hear(&event);
        fill(x, y, SIZE, SIZE, 0x0008);
        fill(0, HEIGHT - 8, WIDTH, 8, 0x0008);
        bat += 4 * keys + stick;
        bat = bat < 0 ? 0 : bat > WIDTH - BAT ? WIDTH - BAT : bat;
        y += 4;
        if (y >= HEIGHT - 8 - SIZE) {
            const int hit = x + SIZE > bat && x < bat + BAT;
            caught += hit, missed += !hit;
            printf("%s at %d\n", hit ? "caught" : "missed", x);
            x = (x * 37 + 91) % (WIDTH - SIZE);
            y = 0;
        }
        const int green = caught * 12 > 63 ? 63 : caught * 12;
        const int red = missed * 8 > 31 ? 31 : missed * 8;
        fill(x, y, SIZE, SIZE, 0xFFE0);
        fill(bat, HEIGHT - 8, BAT, 8, (uint16_t)(red << 11 | green << 5 | 0x10));
        next.tv_nsec += PERIOD_NS;
        if (next.tv_nsec >= 1000000000) next.tv_nsec -= 1000000000, ++next.tv_sec;
        wait_until(&next);
    }
    printf("%d caught, %d missed\n", caught, missed);
    return 0;
}
