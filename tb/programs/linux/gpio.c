// gpio.c WHAT - the processor's pins below /sys/class/gpio, and its LED below /sys/class/leds
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/mman.h>
#include <sys/select.h>
#include <unistd.h>

#define GPIO "/sys/class/gpio/"
#define KEY GPIO "gpio479/"
#define LED "/sys/class/leds/hps_led0/"
#define DRIVER "/sys/bus/platform/drivers/leds-gpio/"
#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static const char* written(const char* path, const char* text) {
    const int file = open(path, O_WRONLY);
    if (file < 0) return strerror(errno);
    const char* const result =
        write(file, text, strlen(text)) == (ssize_t)strlen(text) ? "done" : strerror(errno);
    close(file);
    return result;
}

// What stays until it has shown four more.
static const char* shown(const char* path) {
    static char texts[4][100];
    static unsigned next;
    char* const text = texts[next++ % COUNT(texts)];
    const int file = open(path, O_RDONLY);
    if (file < 0) return strerror(errno);
    const long count = read(file, text, sizeof texts[0] - 1);
    close(file);
    if (count < 0) return strerror(errno);
    text[count] = 0;
    text[strcspn(text, "\n")] = 0;
    return text;
}

static void say(const char* path, const char* text) {
    printf("%s > %s: %s\n", text, strrchr(path, '/') + 1, written(path, text));
}

// Which there are, and what is refused.
static void refusals(void) {
    DIR* const folder = opendir(GPIO);
    for (const struct dirent* entry; (entry = readdir(folder));)
        if (entry->d_name[0] != '.') printf("%s ", entry->d_name);
    closedir(folder);
    printf("\n%s, %s pins from %s\n", shown(GPIO "gpiochip454/label"),
           shown(GPIO "gpiochip454/ngpio"), shown(GPIO "gpiochip454/base"));
    say(GPIO "export", "512");
    say(GPIO "export", "426");
    say(GPIO "export", "-1");
    say(GPIO "export", "key");
    say(GPIO "export", "99999999999");
    say(GPIO "unexport", "479");
    say(GPIO "export", "0x1df\n");
    say(GPIO "export", "479");
    say(GPIO "export", "478");  // the LED's
    say(KEY "value", "1");      // of an input
    say(KEY "direction", "up");
    say(KEY "edge", "up");
    say(KEY "edge", "falling");
    say(KEY "direction", "out");
    say(KEY "edge", "none");
    say(KEY "direction", "high");
    say(KEY "edge", "rising");
    printf("%s %s %s\n", access(GPIO "gpio480", F_OK) ? "no" : "yes", shown(GPIO "export"),
           written(GPIO "gpiochip454/base", "1"));
    const int value = open(KEY "value", O_RDWR);
    char text[2];
    say(GPIO "unexport", "479");
    printf("%ld %s, %s\n", (long)read(value, text, sizeof text), strerror(errno),
           access(KEY "value", F_OK) ? "gone" : "there");
}

static char level(int file) {
    char text[3] = "";
    lseek(file, 0, SEEK_SET);
    if (read(file, text, sizeof text) != 2) exit(1);
    return text[0];
}

// By poll(), select() and epoll: each change, then each press, then each release, by active_low.
static void key(void) {
    written(GPIO "export", "479");
    printf("%s ", written(KEY "edge", "both"));
    printf("%s %s\n", shown(KEY "direction"), shown(KEY "edge"));
    const int file = open(KEY "value", O_RDONLY);
    struct pollfd wait = {file, POLLPRI, 0};
    printf("%d %x before it is read, ", poll(&wait, 1, 0), wait.revents);
    printf("%c, ", level(file));
    printf("%d after\n", poll(&wait, 1, 0));
    for (int i = 0; i < 4; ++i) {
        const int found = poll(&wait, 1, -1);
        printf("%d %x %c\n", found, wait.revents, level(file));
    }
    written(KEY "edge", "falling");
    for (int i = 0; i < 2; ++i) {
        fd_set excepted;
        FD_ZERO(&excepted);
        FD_SET(file, &excepted);
        const int found = select(file + 1, NULL, NULL, &excepted, NULL);
        printf("%d %d %c\n", found, FD_ISSET(file, &excepted) != 0, level(file));
    }
    printf("%s ", written(KEY "active_low", "1"));
    printf("%s %c\n", shown(KEY "active_low"), level(file));
    const int list = epoll_create1(0);
    struct epoll_event event = {.events = EPOLLPRI | EPOLLET};
    epoll_ctl(list, EPOLL_CTL_ADD, file, &event);
    for (int i = 0; i < 2; ++i) {
        const int found = epoll_wait(list, &event, 1, -1);
        printf("%d %x %c\n", found, event.events, level(file));
    }
}

// Steps of the scenario see it: lit, dark, lit, dark, lit, dark.
static void led(void) {
    const int memory = open("/dev/mem", O_RDWR);
    volatile unsigned* const registers =
        mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, memory, (off_t)0xFF709000);
    printf("%s %s %d\n", shown(LED "trigger"), shown(LED "brightness"),
           access(LED "delay_on", F_OK));
    printf("%s %s\n", written(LED "brightness", "1\n"), shown(LED "brightness"));
    printf("%u %u\n", registers[0] >> 24 & 1, registers[1] >> 24 & 1);
    usleep(50000);
    written(LED "brightness", "0");
    usleep(50000);
    printf("%s ", written(DRIVER "unbind", "leds"));
    printf("%s %d ", written(DRIVER "unbind", "leds"), access(LED "brightness", F_OK));
    printf("%s\n", written(GPIO "export", "478"));
    say(DRIVER "bind", "leds");
    say(GPIO "gpio478/direction", "high");
    printf("%s\n", shown(GPIO "gpio478/value"));
    usleep(50000);
    say(GPIO "gpio478/value", "0");
    usleep(50000);
    written(GPIO "gpio478/active_low", "1");
    printf("%s, ", shown(GPIO "gpio478/value"));
    say(GPIO "gpio478/value", "0");
    usleep(50000);
    written(GPIO "unexport", "478");
    say(DRIVER "bind", "leds");
    written(LED "brightness", "0");
    printf("end\n");
    usleep(50000);
}

// The LED's own triggers.
static void triggers(void) {
    say(LED "trigger", "disco");
    say(LED "trigger", "timer");
    written(LED "delay_on", "20");
    written(LED "delay_off", "30");
    printf("%s, %s and %s ms\n", shown(LED "trigger"), shown(LED "delay_on"),
           shown(LED "delay_off"));
    usleep(200000);
    say(LED "trigger", "heartbeat");
    usleep(1000000);
    say(LED "brightness", "0");
    printf("%s\n", shown(LED "trigger"));
    usleep(100000);
}

int main(int argc, char** argv) {
    static const struct {
        const char* name;
        void (*run)(void);
    } all[] = {{"refusals", refusals}, {"key", key}, {"led", led}, {"triggers", triggers}};
    setvbuf(stdout, NULL, _IOLBF, 0);
    for (unsigned i = 0; i < COUNT(all); ++i)
        if (argc > 1 && strcmp(argv[1], all[i].name) == 0) {
            all[i].run();
            return 0;
        }
    return 2;
}
