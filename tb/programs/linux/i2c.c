// i2c.c - the board's accelerometer by /dev/i2c-0: three ways to its registers; then the LED.
#include <errno.h>
#include <fcntl.h>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum {
    ADXL345 = 0x53,
    DEVID = 0x00,
    BW_RATE = 0x2C,
    POWER_CTL = 0x2D,
    FORMAT = 0x31,
    DATAX0 = 0x32
};

int main(void) {
    const int bus = open("/dev/i2c-0", O_RDWR);
    if (bus < 0) return perror("open"), 1;
    ioctl(bus, I2C_SLAVE, 0x1D);
    uint8_t byte = DEVID;
    if (write(bus, &byte, 1) < 0) printf("0x1D: %s\n", strerror(errno));

    ioctl(bus, I2C_SLAVE, ADXL345);
    if (write(bus, &byte, 1) == 1 && read(bus, &byte, 1) == 1) printf("id %02X\n", byte);

    union i2c_smbus_data data = {.byte = 0x08};
    struct i2c_smbus_ioctl_data set = {I2C_SMBUS_WRITE, POWER_CTL, I2C_SMBUS_BYTE_DATA, &data};
    ioctl(bus, I2C_SMBUS, &set);
    data.byte = 0x0B;  // full resolution, 16 g
    set.command = FORMAT;
    ioctl(bus, I2C_SMBUS, &set);
    struct i2c_smbus_ioctl_data get = {I2C_SMBUS_READ, BW_RATE, I2C_SMBUS_BYTE_DATA, &data};
    if (ioctl(bus, I2C_SMBUS, &get) == 0) printf("rate %02X\n", data.byte);
    usleep(20000);

    uint8_t first = DATAX0, xyz[6];
    struct i2c_msg messages[2] = {{ADXL345, 0, 1, &first}, {ADXL345, I2C_M_RD, 6, xyz}};
    struct i2c_rdwr_ioctl_data both = {messages, 2};
    if (ioctl(bus, I2C_RDWR, &both) == 2)
        printf("x %d y %d z %d\n", (int16_t)(xyz[1] << 8 | xyz[0]), (int16_t)(xyz[3] << 8 | xyz[2]),
               (int16_t)(xyz[5] << 8 | xyz[4]));
    data.block[0] = 6;
    struct i2c_smbus_ioctl_data block = {I2C_SMBUS_READ, DATAX0, I2C_SMBUS_I2C_BLOCK_DATA, &data};
    if (ioctl(bus, I2C_SMBUS, &block) == 0)
        printf("block z %d\n", (int16_t)(data.block[6] << 8 | data.block[5]));

    const int led = open("/sys/class/leds/hps_led0/brightness", O_RDWR);
    if (write(led, "1\n", 2) == 2) printf("lit\n");
    char state[20] = "";
    if (read(open("/sys/class/fpga_manager/fpga0/state", O_RDONLY), state, 19) > 0)
        printf("%s", state);
    return 0;
}
