// usbfs.c WHAT - USB devices by usbfs, with the calls of libusb's Linux part
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/netlink.h>
#include <linux/usbdevice_fs.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <time.h>
#include <unistd.h>

static const char* error_of(int result) { return result < 0 ? strerrorname_np(errno) : "0"; }

static long ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static void attribute(const char* device, const char* name) {
    char path[300], text[100];
    snprintf(path, sizeof path, "/sys/bus/usb/devices/%s/%s", device, name);
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    ssize_t bytes = read(fd, text, sizeof text - 1);
    while (bytes > 0 && text[bytes - 1] == '\n') --bytes;
    printf(" %.*s", bytes < 0 ? 1 : (int)bytes, bytes < 0 ? "-" : text);
    close(fd);
}

static void lists(void) {
    struct statfs file_system;
    struct dirent** names;
    const int count = scandir("/sys/bus/usb/devices", &names, NULL, alphasort);
    statfs("/sys", &file_system);
    printf("%lx\n", (unsigned long)file_system.f_type);
    for (int i = 0; i < count; ++i) {
        const char* const name = names[i]->d_name;
        if (name[0] == '.') continue;
        printf("%s:", name);
        if (strchr(name, ':')) {
            attribute(name, "bInterfaceClass");
            attribute(name, "bInterfaceProtocol");
        } else {
            static const char* const NAMES[] = {
                "busnum",   "devnum",    "speed",  "bConfigurationValue",
                "idVendor", "idProduct", "product"};
            for (unsigned n = 0; n < sizeof NAMES / sizeof *NAMES; ++n) attribute(name, NAMES[n]);
        }
        printf("\n");
    }
    printf("nodes:");
    const int nodes = scandir("/dev/bus/usb/001", &names, NULL, alphasort);
    for (int i = 0; i < nodes; ++i) printf(" %s", names[i]->d_name);
    printf("\n");
}

static void print(const uint8_t* bytes, int count) {
    for (int i = 0; i < count; ++i)
        printf("%02x%s", bytes[i], i + 1 == count || i % 16 == 15 ? "\n" : " ");
}

static int control(int fd, int type, int request, int value, int index, int length, void* data) {
    struct usbdevfs_ctrltransfer transfer = {type, request, value, index, length, 1000, data};
    return ioctl(fd, USBDEVFS_CONTROL, &transfer);
}

static int driver_request(int fd, int code) {
    struct usbdevfs_ioctl request = {0, code, NULL};
    return ioctl(fd, USBDEVFS_IOCTL, &request);
}

// Takes the interface of the device from its driver.
static int take(const char* node) {
    struct usbdevfs_getdriver driver = {.interface = 0};
    const unsigned interface = 0;
    const int fd = open(node, O_RDWR | O_CLOEXEC);
    const int named = ioctl(fd, USBDEVFS_GETDRIVER, &driver);
    printf("driver %s\n", named < 0 ? error_of(named) : driver.driver);
    printf("claim %s", error_of(ioctl(fd, USBDEVFS_CLAIMINTERFACE, &interface)));
    printf(", detach %s", error_of(driver_request(fd, USBDEVFS_DISCONNECT)));
    printf(", again %s", error_of(driver_request(fd, USBDEVFS_DISCONNECT)));
    printf(", claim %s\n", error_of(ioctl(fd, USBDEVFS_CLAIMINTERFACE, &interface)));
    return fd;
}

static void descriptors(void) {
    uint8_t data[256];
    uint32_t capabilities;
    struct usbdevfs_connectinfo info;
    int fd = open("/dev/bus/usb/001/003", O_RDONLY);
    print(data, (int)read(fd, data, 18));
    print(data, (int)read(fd, data, sizeof data));
    printf("%s\n", error_of(ioctl(fd, USBDEVFS_GET_CAPABILITIES, &capabilities)));
    close(fd);
    fd = open("/dev/bus/usb/001/003", O_RDWR);
    ioctl(fd, USBDEVFS_GET_CAPABILITIES, &capabilities);
    ioctl(fd, USBDEVFS_CONNECTINFO, &info);
    printf("%x, %u %d\n", capabilities, info.devnum, info.slow);
    print(data, control(fd, 0x80, 6, 0x301, 0x409, 255, data));
    printf("%s", error_of(control(fd, 0x80, 6, 0x302, 0x409, 255, data)));
    printf(" %s\n", error_of(control(fd, 0x81, 6, 0x2200, 0, 255, data)));
    close(fd);
    fd = take("/dev/bus/usb/001/003");
    print(data, control(fd, 0x81, 6, 0x2200, 0, 255, data));
    printf("%d", control(fd, 0x21, 11, 0, 0, 0, NULL));  // the boot protocol
    printf(" %d %x", control(fd, 0xA1, 3, 0, 0, 1, data), data[0]);
    data[0] = 2;
    printf(" %d\n", control(fd, 0x21, 9, 0x200, 0, 1, data));  // Caps Lock's lamp
}

static struct usbdevfs_urb* submit(int fd, int bytes) {
    struct usbdevfs_urb* const urb = calloc(1, sizeof *urb);
    urb->type = USBDEVFS_URB_TYPE_INTERRUPT;
    urb->endpoint = 0x81;
    urb->buffer = malloc(bytes);
    urb->buffer_length = bytes;
    printf("submit %s\n", error_of(ioctl(fd, USBDEVFS_SUBMITURB, urb)));
    return urb;
}

static struct usbdevfs_urb* reap(int fd) {
    struct pollfd wait = {fd, POLLOUT, 0};
    struct usbdevfs_urb* urb = NULL;
    poll(&wait, 1, -1);
    const long now = ms();
    const int result = ioctl(fd, USBDEVFS_REAPURBNDELAY, &urb);
    printf("poll %x, reap %s", wait.revents, error_of(result));
    if (result < 0) {
        printf("\n");
        return NULL;
    }
    printf(", %d, %ld ms: ", urb->status, now % 8);
    print(urb->buffer, urb->actual_length);
    if (urb->actual_length == 0) printf("none\n");
    return urb;
}

static void keyboard(void) {
    void* none;
    char event[16];
    const int events = open("/dev/input/event0", O_RDONLY | O_NONBLOCK);
    const int fd = take("/dev/bus/usb/001/003");
    printf("events %s", error_of(read(events, event, sizeof event)));
    printf(", node %s\n", error_of(access("/dev/input/event0", F_OK)));
    printf("reap %s\n", error_of(ioctl(fd, USBDEVFS_REAPURBNDELAY, &none)));
    struct usbdevfs_urb* urb = submit(fd, 8);
    printf("ready\n");
    for (int i = 0; i < 4; ++i) {
        urb = reap(fd);
        if (ioctl(fd, USBDEVFS_SUBMITURB, urb) < 0) printf("%s\n", error_of(-1));
    }
    printf("discard %s", error_of(ioctl(fd, USBDEVFS_DISCARDURB, urb)));
    printf(", again %s\n", error_of(ioctl(fd, USBDEVFS_DISCARDURB, urb)));
    reap(fd);
    uint8_t data[8];
    struct usbdevfs_bulktransfer bulk = {0x81, 8, 50, data};
    const long before = ms();
    printf("bulk %s", error_of(ioctl(fd, USBDEVFS_BULK, &bulk)));
    printf(", %ld ms\n", ms() - before);
    bulk.timeout = 0;
    printf("waits\n");
    print(data, ioctl(fd, USBDEVFS_BULK, &bulk));
    const unsigned interface = 0;
    printf("release %s", error_of(ioctl(fd, USBDEVFS_RELEASEINTERFACE, &interface)));
    printf(", again %s", error_of(ioctl(fd, USBDEVFS_RELEASEINTERFACE, &interface)));
    printf(", attach %d", driver_request(fd, USBDEVFS_CONNECT));
    printf(", again %s", error_of(driver_request(fd, USBDEVFS_CONNECT)));
    printf(", node %s\n", error_of(access("/dev/input/event0", F_OK)));
}

static void mouse(void) {
    const int fd = take("/dev/bus/usb/001/004");
    submit(fd, 4), submit(fd, 4), submit(fd, 4);
    printf("ready\n");
    reap(fd), reap(fd), reap(fd);
    printf("%d\n", control(fd, 0x21, 11, 0, 0, 0, NULL));  // the boot protocol
    submit(fd, 4), submit(fd, 2);
    printf("boot\n");
    reap(fd), reap(fd);
}

static void gamepad(void) {
    const int fd = take("/dev/bus/usb/001/005");
    printf("ready\n");
    for (int i = 0; i < 4; ++i) free(submit(fd, 7)), reap(fd);
}

// By the kind of request that libusb's interrupt transfers become.
static int receive(int fd, uint8_t* data, int room) {
    struct usbdevfs_bulktransfer bulk = {0x81, room, 1000, data};
    return ioctl(fd, USBDEVFS_BULK, &bulk);
}

static void snes(void) {
    uint8_t data[256];
    const int fd = take("/dev/bus/usb/001/003");
    print(data, (int)read(fd, data, 18));
    print(data, (int)read(fd, data, sizeof data));
    print(data, control(fd, 0x81, 6, 0x2200, 0, sizeof data, data));
    print(data, control(fd, 0x80, 6, 0x0302, 0x409, sizeof data, data));
    receive(fd, data, 8);
    const long before = ms();
    for (int i = 0; i < 10; ++i) receive(fd, data, 8);
    printf("ten reports in %ld ms\n", ms() - before);
    print(data, 8);
    print(data, receive(fd, data, 7));
    print(data, receive(fd, data, 20));
}

// What two gamepads report, when it is something else.
static void pads(void) {
    uint8_t last[2][8] = {{0}, {0}}, data[8];
    const char* const nodes[2] = {"/dev/bus/usb/001/003", "/dev/bus/usb/001/004"};
    const int fds[2] = {take(nodes[0]), take(nodes[1])};
    for (int seen = 0;;) {
        for (int i = 0; i < 2; ++i) {
            const int bytes = receive(fds[i], data, 8);
            if (bytes < 0) {
                printf("pad %d %s\n", i + 1, error_of(bytes));
                return;
            }
            if (memcmp(data, last[i], 8) == 0) continue;
            memcpy(last[i], data, 8);
            printf("pad %d: ", i + 1);
            print(data, bytes);
            if (++seen == 2) printf("ready\n");
        }
    }
}

static void pulls(void) {
    const int fd = take("/dev/bus/usb/001/003");
    void* urb;
    submit(fd, 8);
    printf("ready\n");
    reap(fd);
    reap(fd);
    printf("%s", error_of(ioctl(fd, USBDEVFS_REAPURB, &urb)));
    printf(" %s", error_of(driver_request(fd, USBDEVFS_CONNECT)));
    printf(" %s\n", error_of(open("/dev/bus/usb/001/003", O_RDWR)));
}

// As libusb hears of devices that come and go.
static void hears(void) {
    struct sockaddr_nl address = {.nl_family = AF_NETLINK, .nl_groups = 1};
    const int on = 1, fd = socket(AF_NETLINK, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC,
                                  NETLINK_KOBJECT_UEVENT);
    printf("bind %s", error_of(bind(fd, (struct sockaddr*)&address, sizeof address)));
    printf(" %s\n", error_of(setsockopt(fd, SOL_SOCKET, SO_PASSCRED, &on, sizeof on)));
    printf("ready\n");
    for (int i = 0; i < 2; ++i) {
        char text[1024], who[CMSG_SPACE(12)];
        struct iovec piece = {text, sizeof text};
        struct msghdr message = {&address, sizeof address, &piece, 1, who, sizeof who, 0};
        struct pollfd wait = {fd, POLLIN, 0};
        poll(&wait, 1, -1);
        const ssize_t bytes = recvmsg(fd, &message, 0);
        const struct cmsghdr* const first = CMSG_FIRSTHDR(&message);
        printf("from %u of group %u, %d, user %d\n", address.nl_pid, address.nl_groups,
               first ? first->cmsg_type : -1, first ? ((const int*)CMSG_DATA(first))[1] : -1);
        for (const char* at = text; at < text + bytes; at += strlen(at) + 1) printf("  %s\n", at);
    }
}

// Opens what a folder has under this name, and says what it is.
static int step(int folder, const char* name) {
    struct stat status;
    const int fd = openat(folder, name, O_PATH | O_NOFOLLOW | O_CLOEXEC);
    if (fd < 0 || fstat(fd, &status) != 0) {
        printf("%s: %s\n", name, error_of(-1));
        exit(1);
    }
    printf("%s %s\n", name, S_ISLNK(status.st_mode) ? "link" : "folder");
    return fd;
}

// As libudev finds a device: each name of the path by its own call, so that links are seen.
static void walks(void) {
    char target[100], own[30];
    struct statfs file_system;
    int fd = open("/", O_PATH | O_DIRECTORY | O_CLOEXEC);
    const char* const names[] = {"sys", "bus", "usb", "devices"};
    for (int n = 0; n < 4; ++n) fd = step(fd, names[n]);
    printf("%s\n", error_of(openat(fd, "1-1", O_RDONLY | O_NOFOLLOW)));
    step(fd, "1-1");
    const ssize_t bytes = readlinkat(fd, "1-1", target, sizeof target - 1);
    target[bytes < 0 ? 0 : bytes] = 0;
    for (const char* name = strtok(target, "/"); name; name = strtok(NULL, "/"))
        fd = step(fd, name);
    fstatfs(fd, &file_system);
    snprintf(own, sizeof own, "/proc/self/fd/%d", fd);
    const ssize_t length = readlink(own, target, sizeof target);
    printf("%lx %.*s %s\n", (unsigned long)file_system.f_type, (int)length, target,
           error_of(faccessat(fd, "uevent", F_OK, 0)));
    struct file_handle handle = {.handle_bytes = 0};
    int mount;
    printf("%s", error_of(name_to_handle_at(fd, "uevent", &handle, &mount, 0)));
    printf(" %s", error_of(name_to_handle_at(fd, "", &handle, &mount, 0)));
    printf(" %s\n", error_of(name_to_handle_at(fd, "", &handle, &mount, AT_EMPTY_PATH)));
}

int main(int argc, char** argv) {
    const char* what = argc > 1 ? argv[1] : "";
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (strcmp(what, "lists") == 0) lists();
    if (strcmp(what, "descriptors") == 0) descriptors();
    if (strcmp(what, "keyboard") == 0) keyboard();
    if (strcmp(what, "mouse") == 0) mouse();
    if (strcmp(what, "gamepad") == 0) gamepad();
    if (strcmp(what, "snes") == 0) snes();
    if (strcmp(what, "pads") == 0) pads();
    if (strcmp(what, "pulls") == 0) pulls();
    if (strcmp(what, "hears") == 0) hears();
    if (strcmp(what, "walks") == 0) walks();
    return 0;
}
