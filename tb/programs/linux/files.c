// files.c - files under the root, and paths that leave it
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

static const char* ioctl_error(int fd) {
    return ioctl(fd, 0x1234, 0) < 0 ? strerror(errno) : "done";
}

static void try_open(const char* path) {
    const int fd = open(path, O_RDONLY);
    printf("%s: %s\n", path, fd < 0 ? strerror(errno) : "open");
    if (fd >= 0) close(fd);
}

int main(void) {
    char line[100];
    FILE* in = fopen("/data/in.txt", "r");
    if (!in || !fgets(line, sizeof line, in)) return 1;
    printf("read %s", line);
    fseek(in, -5, SEEK_END);
    printf("last %s", fgets(line, sizeof line, in));
    fclose(in);

    FILE* out = fopen("data/out.txt", "w");
    if (!out) return 2;
    for (int i = 0; i < 1000; ++i) fprintf(out, "line %d\n", i);
    fclose(out);
    struct stat status;
    if (stat("/data/out.txt", &status) != 0) return 3;
    printf("wrote %ld bytes, %s\n", (long)status.st_size, S_ISREG(status.st_mode) ? "file" : "?");

    const int fd = open("/data/in.txt", O_RDONLY);
    const char* text = mmap(NULL, 4096, PROT_READ, MAP_PRIVATE, fd, 0);
    printf("mapped %.5s\n", text);
    printf("ioctl: %s\n", ioctl_error(fd));

    DIR* folder = opendir("/data");
    if (!folder || chdir("/data") != 0) return 4;
    for (struct dirent* entry; (entry = readdir(folder));) {
        if (fstatat(dirfd(folder), entry->d_name, &status, 0) != 0) return 5;
        printf("%s%s ", entry->d_name, S_ISDIR(status.st_mode) ? "/" : "");
    }
    closedir(folder);
    char here[20];
    printf("in %s\n", getcwd(here, sizeof here));
    if (access("in.txt", R_OK) != 0 || chdir("in.txt") == 0 || chdir("..") != 0) return 6;
    printf("in %s\n", getcwd(here, sizeof here));
    if (chdir("/inside/to_data") != 0) return 7;
    printf("in %s by a link\n", getcwd(here, sizeof here));
    const int data = open("/inside/to_data", O_RDONLY | O_DIRECTORY);
    if (chdir("/") != 0 || fchdir(data) != 0 || access("in.txt", R_OK) != 0) return 8;
    if (chdir("/") != 0) return 9;
    printf("not followed: %s\n", open("/inside/to_data", O_RDONLY | O_NOFOLLOW) < 0
                                     ? strerror(errno) : "open");
    printf("not made by a link: %s, ", open("/link", O_CREAT | O_EXCL | O_WRONLY, 0600) < 0
                                           ? strerror(errno) : "open");
    printf("%s\n", mkdir("/link", 0700) < 0 ? strerror(errno) : "made");

    printf("rights %d, ", chmod("data/out.txt", 0640));
    if (stat("data/out.txt", &status) != 0) return 10;
    printf("%o, ", status.st_mode & 0777);
    printf("%s, ", chmod("/none", 0640) < 0 ? "none" : "some");
    printf("%s\n", chown("data/out.txt", 0, 7) < 0 ? strerror(errno) : "changed");

    try_open("../outside.txt");
    try_open("/data/../../outside.txt");
    try_open("/link");
    try_open("/folder_link/outside.txt");
    try_open("/folder_link/inside/to_data/in.txt");
    try_open("/round");
    try_open("/none");
    try_open("/fifo");
    return 0;
}
