// devices.c WHAT - the keyboard and the mouse on USB, and the frame buffer
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/input.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

// Each event that is neither SYN nor MSC, until `last` is let go of.
static void events(const char* path, int last) {
    char name[64] = "";
    struct input_event event;
    const int fd = open(path, O_RDONLY);
    ioctl(fd, EVIOCGNAME(sizeof name), name);
    printf("%s\n", name);
    while (read(fd, &event, sizeof event) == sizeof event)
        if (event.type != EV_SYN && event.type != EV_MSC) {
            printf("%d %d %d\n", event.type, event.code, (int)event.value);
            if (event.type == EV_KEY && event.code == last && event.value == 0) break;
        }
}

static void mice(void) {
    static const uint8_t ASKS[6] = {0xF3, 200, 0xF3, 100, 0xF3, 80};
    int8_t packet[4];
    const int fd = open("/dev/input/mice", O_RDWR | O_NONBLOCK);
    const long before = read(fd, packet, sizeof packet);
    if (write(fd, ASKS, sizeof ASKS) != sizeof ASKS) return;
    const long answer = read(fd, packet, sizeof packet);
    printf("ready %ld %ld\n", before, answer);
    for (;;) {
        struct pollfd wait = {fd, POLLIN, 0};
        poll(&wait, 1, -1);
        if (read(fd, packet, sizeof packet) != 4) break;
        printf("%02x %d %d %d\n", packet[0], packet[1], packet[2], packet[3]);
        if (packet[0] & 2) break;
    }
}

static void draws(void) {
    struct fb_var_screeninfo variable;
    struct fb_fix_screeninfo fixed;
    const int fd = open("/dev/fb0", O_RDWR);
    ioctl(fd, FBIOGET_VSCREENINFO, &variable);
    ioctl(fd, FBIOGET_FSCREENINFO, &fixed);
    uint8_t* pixels = mmap(NULL, fixed.smem_len, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    for (unsigned y = 0; y < variable.yres; ++y)
        for (unsigned x = 0; x < variable.xres; ++x)
            *(uint16_t*)(pixels + y * fixed.line_length + 2 * x) = y < 120 ? 0xF800 : 0x07E0;
    printf("%u x %u, %u bits, red %u at %u\n", variable.xres, variable.yres,
           variable.bits_per_pixel, variable.red.length, variable.red.offset);
    const uint8_t* shown = mmap(NULL, 0x40000, PROT_READ, MAP_SHARED, open("/dev/mem", O_RDONLY),
                                0xC8000000);  // what the monitor gets
    printf("%04x, %04x, pan %d\n", *(const uint16_t*)(shown + 119 * 1024 + 638),
           *(const uint16_t*)(shown + 120 * 1024), ioctl(fd, FBIOPAN_DISPLAY, &variable));
    // As `dd of=/dev/fb0 seek=...` and `dd if=/dev/fb0`, at no word's beginning.
    const uint8_t part[5] = {1, 2, 3, 4, 5};
    uint8_t back[8] = {0};
    const long at = lseek(fd, 119 * 1024 + 635, SEEK_SET);
    const long written = write(fd, part, sizeof part), next = lseek(fd, 0, SEEK_CUR);
    const long got = pread(fd, back, sizeof back, at - 1);
    printf("%ld %ld %ld: %02x %02x %02x %02x, %02x\n", written, next - at, got, back[0], back[1],
           back[5], shown[at + 4], shown[at - 1]);
    const long size = fixed.smem_len;
    const long cut = pwrite(fd, part, 5, size - 2), full = pwrite(fd, part, 5, size);
    const int error = errno;
    const long none = pread(fd, back, 8, size);
    printf("%ld %ld %s %ld\n", cut, full, strerror(error), none);
}

int main(int argc, char** argv) {
    const char* what = argc > 1 ? argv[1] : "";
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (strcmp(what, "keyboard") == 0) events("/dev/input/event0", KEY_ESC);
    if (strcmp(what, "mouse") == 0) events("/dev/input/event1", BTN_RIGHT);
    if (strcmp(what, "mice") == 0) mice();
    if (strcmp(what, "draws") == 0) draws();
    return 0;
}
