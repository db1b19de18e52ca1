// input.c WHAT - the keyboard, the mouse and gamepads on USB as Linux' input devices
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <linux/input.h>
#include <linux/joystick.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static const char* error_of(int result) { return result < 0 ? strerrorname_np(errno) : "0"; }

static void list(const char* folder, int with_targets) {
    struct dirent** names;
    const int count = scandir(folder, &names, NULL, alphasort);
    printf("%s\n", folder);
    for (int i = 0; i < count; ++i) {
        char path[300], target[200];
        if (names[i]->d_name[0] == '.') continue;
        snprintf(path, sizeof path, "%s/%s", folder, names[i]->d_name);
        printf("  %s%s", names[i]->d_name, names[i]->d_type == DT_DIR ? "/" : "");
        const ssize_t bytes = readlink(path, target, sizeof target);
        if (bytes > 0) printf(" -> %.*s", with_targets ? (int)bytes : 13, target);
        printf("\n");
    }
}

static void lists(void) {
    struct stat status;
    char line[200], target[PATH_MAX];
    list("/dev/input", 1);
    list("/dev/input/by-id", 1);
    list("/dev/input/by-path", 1);
    list("/sys/class/input", 0);
    printf("%d\n", chdir("/dev/input"));
    list("by-path/../by-id/..", 1);
    stat("by-id/usb-04d9_USB_Keyboard-event-kbd", &status);
    printf("%o %x\n", status.st_mode, (unsigned)status.st_rdev);
    lstat("/dev/input/by-id/usb-04d9_USB_Keyboard-event-kbd", &status);
    printf("%o\n", status.st_mode);
    const char* const real = realpath("/sys/class/input/event2/device/name", target);
    printf("%s\n", real ? strstr(real, "1-1.3:") : "none");
    printf("%s", error_of(open("/dev/input", O_RDWR)));
    printf(" %s\n", error_of(open("/dev/input/mice", O_RDONLY | O_DIRECTORY)));
    FILE* const devices = fopen("/proc/bus/input/devices", "r");
    while (fgets(line, sizeof line, devices)) {
        line[strcspn(line, "\n")] = 0;
        printf("%.60s%s\n", line, line[0] == 'H' ? "." : "");  // which ends with a blank
    }
}

static void bits(int fd, const char* name, int type) {
    uint8_t all[96];
    const int bytes = ioctl(fd, EVIOCGBIT(type, sizeof all), all);
    printf("%s %d:", name, bytes);
    for (int i = 0; i < 8 * bytes; ++i)
        if (all[i / 8] >> i % 8 & 1) printf(" %d", i);
    printf("\n");
}

static void describe(const char* path) {
    char text[64] = "";
    struct input_id id;
    struct input_absinfo axis;
    uint32_t numbers[2] = {0, 0};
    const int fd = open(path, O_RDWR);
    ioctl(fd, EVIOCGNAME(sizeof text), text);
    ioctl(fd, EVIOCGID, &id);
    const int is_keyboard = strstr(text, "Keyboard") != NULL;
    printf("%s, %x %04x:%04x %04x,", text, id.bustype, id.vendor, id.product, id.version);
    ioctl(fd, EVIOCGPHYS(sizeof text), text);
    printf(" %s,", text);
    printf(" %d", ioctl(fd, EVIOCGUNIQ(sizeof text), text));
    printf(", repeats %s", error_of(ioctl(fd, EVIOCGREP, numbers)));
    printf(" %u %u\n", numbers[0], numbers[1]);
    bits(fd, "types", 0);
    if (!is_keyboard) bits(fd, "keys", EV_KEY);
    bits(fd, "movements", EV_REL);
    bits(fd, "axes", EV_ABS);
    bits(fd, "lamps", EV_LED);
    printf("%d %d %d\n", ioctl(fd, EVIOCGBIT(EV_KEY, sizeof text), text),
           ioctl(fd, EVIOCGBIT(EV_SW, sizeof text), text), ioctl(fd, EVIOCGBIT(EV_PWR, 4), text));
    for (int which = 0; which < 0x12; which += 0x11) {
        const int got = ioctl(fd, EVIOCGABS(which), &axis);
        if (got == 0)
            printf("axis %d: %d in %d to %d, %d, %d\n", which, axis.value, axis.minimum,
                   axis.maximum, axis.fuzz, axis.flat);
        else
            printf("no axis: %s\n", error_of(got));
    }
    close(fd);
}

static void describes(void) {
    describe("/dev/input/event0");
    describe("/dev/input/event1");
    describe("/dev/input/by-id/usb-0079_USB_Gamepad-event-joystick");
}

static void held(int fd, int lamps) {
    uint8_t all[96];
    const int bytes = ioctl(fd, lamps ? EVIOCGLED(96) : EVIOCGKEY(96), all);
    printf("%s %d:", lamps ? "lit" : "held", bytes);
    for (int i = 0; i < 8 * bytes; ++i)
        if (all[i / 8] >> i % 8 & 1) printf(" %d", i);
    printf("\n");
}

static void print_event(int fd) {
    struct input_event event;
    if (read(fd, &event, sizeof event) != sizeof event) {
        printf("%s\n", error_of(-1));
        return;
    }
    printf("%u %d %d %d\n",
           (unsigned)(event.input_event_sec * 1000 + event.input_event_usec / 1000), event.type,
           event.code, event.value);
}

// Who grabs a device hears it alone; what is asked for is not told again.
static void grabs(void) {
    const int one = open("/dev/input/event0", O_RDWR), on = 1;
    const int other = open("/dev/input/event0", O_RDWR | O_NONBLOCK);
    ioctl(one, FIONBIO, &on);
    print_event(one);
    printf("ready %s", error_of(ioctl(one, EVIOCGRAB, 1)));
    printf(" %s", error_of(ioctl(other, EVIOCGRAB, 1)));
    printf(" %s\n", error_of(ioctl(other, EVIOCGRAB, 0)));
    struct pollfd wait = {one, POLLIN, 0};
    poll(&wait, 1, -1);
    print_event(one), print_event(one), print_event(one);
    print_event(other);
    held(other, 0);
    printf("%s\n", error_of(ioctl(one, EVIOCGRAB, 0)));
    poll(&wait, 1, -1);
    held(one, 0);
    print_event(one);
    print_event(one);
    const struct input_event lamp = {.type = EV_LED, .code = LED_CAPSL, .value = 1};
    printf("%zd\n", write(one, &lamp, sizeof lamp));
    held(other, 1);
}

static void repeats(void) {
    const unsigned times[2] = {100, 20};
    const int fd = open("/dev/input/event0", O_RDWR);
    struct input_event event;
    int count = 0;
    printf("ready\n");
    for (int end = 0; end < 2;) {
        read(fd, &event, sizeof event);
        if (event.type != EV_KEY) continue;
        if (event.value != 2) {
            printf("%d, %d repeated\n", event.value, count);
            count = 0;
        }
        count += event.value == 2;
        if (event.value == 0) ++end, ioctl(fd, EVIOCSREP, times);
    }
}

static void pulls(void) {
    const int fd = open("/dev/input/event0", O_RDONLY), mice = open("/dev/input/mice", O_RDONLY),
              mouse = open("/dev/input/mouse0", O_RDONLY);
    struct pollfd wait[2] = {{fd, POLLIN, 0}, {mouse, POLLIN, 0}};
    uint8_t packet[3];
    char text[64];
    printf("ready\n");
    print_event(fd), print_event(fd), print_event(fd);
    print_event(fd);  // when it is unplugged
    poll(wait, 2, -1);
    printf("poll %x\n", wait[0].revents);
    printf("name %s\n", error_of(ioctl(fd, EVIOCGNAME(sizeof text), text)));
    printf("open %s\n", error_of(open("/dev/input/event0", O_RDONLY)));
    printf("mouse %s\n", error_of(read(mouse, packet, 3)));
    printf("mice %zd %d\n", read(mice, packet, 3), packet[1]);  // of a new mouse
    list("/dev/input", 1);
}

static void joystick(void) {
    struct js_event event;
    char name[64] = "";
    uint8_t axes, buttons, map[64];
    uint16_t codes[512];
    uint32_t version;
    const int fd = open("/dev/input/js0", O_RDONLY);
    ioctl(fd, JSIOCGVERSION, &version);
    ioctl(fd, JSIOCGAXES, &axes);
    ioctl(fd, JSIOCGBUTTONS, &buttons);
    printf("%d bytes of a name, ", ioctl(fd, JSIOCGNAME(sizeof name), name));
    printf("%s, version %x, %d axes, %d buttons\n", name, version, axes, buttons);
    ioctl(fd, JSIOCGAXMAP, map);
    ioctl(fd, JSIOCGBTNMAP, codes);
    for (int i = 0; i < axes; ++i) printf("%d ", map[i]);
    printf("%x to %x\nready\n", codes[0], codes[buttons - 1]);
    for (int first = 1; read(fd, &event, sizeof event) == sizeof event;) {
        if (event.type & JS_EVENT_INIT) {
            if (event.value != 0) printf("at first %d is %d\n", event.number, event.value);
            continue;
        }
        if (first) printf("from %u ms\n", event.time);
        first = 0;
        printf("%s %d: %d\n", event.type == JS_EVENT_AXIS ? "axis" : "button", event.number,
               event.value);
    }
    printf("%s\n", error_of(-1));
}

static void gamepad(void) {
    const int fd = open("/dev/input/event2", O_RDONLY);
    struct input_event event;
    printf("ready\n");
    do {
        read(fd, &event, sizeof event);
        printf("%d %d %d\n", event.type, event.code, event.value);
    } while (event.type != EV_KEY || event.value != 0);
}

// Two gamepads as joysticks, until the first is unplugged and both are let go of.
static void pads(void) {
    struct js_event event;
    describe("/dev/input/event0");
    describe("/dev/input/event1");
    struct pollfd files[2] = {{open("/dev/input/js0", O_RDONLY), POLLIN, 0},
                              {open("/dev/input/js1", O_RDONLY), POLLIN, 0}};
    for (int i = 0; i < 2; ++i) {
        uint8_t axes, buttons;
        ioctl(files[i].fd, JSIOCGAXES, &axes);
        ioctl(files[i].fd, JSIOCGBUTTONS, &buttons);
        printf("js%d: %d axes, %d buttons\n", i, axes, buttons);
    }
    printf("ready\n");
    while (poll(files, 2, 150) > 0) {
        for (int i = 0; i < 2; ++i) {
            if (files[i].revents == 0) continue;
            if (read(files[i].fd, &event, sizeof event) < 0) {
                printf("js%d %s\n", i, error_of(-1));
                files[i].fd = -1;
            } else if (!(event.type & JS_EVENT_INIT)) {
                printf("js%d %s %d: %d\n", i, event.type == JS_EVENT_AXIS ? "axis" : "button",
                       event.number, event.value);
            } else if (event.value != 0) {
                printf("js%d has %d at first\n", i, event.value);
            }
        }
    }
    list("/dev/input/by-id", 1);
}

int main(int argc, char** argv) {
    const char* what = argc > 1 ? argv[1] : "";
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (strcmp(what, "lists") == 0) lists();
    if (strcmp(what, "describes") == 0) describes();
    if (strcmp(what, "grabs") == 0) grabs();
    if (strcmp(what, "repeats") == 0) repeats();
    if (strcmp(what, "pulls") == 0) pulls();
    if (strcmp(what, "joystick") == 0) joystick();
    if (strcmp(what, "gamepad") == 0) gamepad();
    if (strcmp(what, "pads") == 0) pads();
    return 0;
}
