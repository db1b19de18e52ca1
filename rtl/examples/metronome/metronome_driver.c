// metronome_driver.c - the metronome's kernel module: /dev/metronome, whose read() waits for a beat
#include <linux/errno.h>
#include <linux/fs.h>
#include <linux/init.h>
#include <linux/interrupt.h>
#include <linux/io.h>
#include <linux/kernel.h>
#include <linux/miscdevice.h>
#include <linux/module.h>
#include <linux/of.h>
#include <linux/of_address.h>
#include <linux/platform_device.h>
#include <linux/uaccess.h>
#include <linux/wait.h>

#include "metronome.h"

enum { PERIOD = 0, BEATS = 4, STATUS = 8 };  // registers

static void __iomem *registers;
static int irq;
static DECLARE_WAIT_QUEUE_HEAD(beaten);
static u32 last_read;

static irqreturn_t metronome_handler(int number, void *data)
{
	if (!(ioread32(registers + STATUS) & 1))
		return IRQ_NONE;
	iowrite32(1, registers + STATUS);
	wake_up_interruptible(&beaten);
	return IRQ_HANDLED;
}

/* Waits for the next beat: how many there have been. */
static ssize_t metronome_read(struct file *file, char __user *to, size_t bytes, loff_t *at)
{
	u32 beats;

	if (bytes < sizeof(beats))
		return -EINVAL;
	if (wait_event_interruptible(beaten, ioread32(registers + BEATS) != last_read))
		return -ERESTARTSYS;
	last_read = beats = ioread32(registers + BEATS);
	return copy_to_user(to, &beats, sizeof(beats)) ? -EFAULT : sizeof(beats);
}

static long metronome_ioctl(struct file *file, unsigned int request, unsigned long argument)
{
	u32 value;

	switch (request) {
	case METRONOME_SET_PERIOD:
		if (copy_from_user(&value, (void __user *)argument, sizeof(value)))
			return -EFAULT;
		iowrite32(value, registers + PERIOD);
		return 0;
	}
	return -ENOTTY;
}

static const struct file_operations operations = {
	.owner = THIS_MODULE,
	.read = metronome_read,
	.unlocked_ioctl = metronome_ioctl,
};

static struct miscdevice device = {
	.minor = MISC_DYNAMIC_MINOR,
	.name = "metronome",
	.fops = &operations,
};

static int metronome_probe(struct platform_device *platform)
{
	int error;

	registers = of_iomap(platform->dev.of_node, 0);
	if (!registers)
		return -ENOMEM;
	irq = platform_get_irq(platform, 0);
	if (irq < 0)
		return irq;
	error = request_irq(irq, metronome_handler, 0, "metronome", NULL);
	if (error)
		return error;
	pr_info("metronome: probed\n");
	return misc_register(&device);
}

static int metronome_remove(struct platform_device *platform)
{
	misc_deregister(&device);
	free_irq(irq, NULL);
	iounmap(registers);
	return 0;
}

static const struct of_device_id matches[] = {
	{ .compatible = "lesson,metronome-1.0" },
	{ }
};
MODULE_DEVICE_TABLE(of, matches);

static struct platform_driver driver = {
	.probe = metronome_probe,
	.remove = metronome_remove,
	.driver = {
		.name = "metronome",
		.of_match_table = matches,
	},
};
module_platform_driver(driver);

MODULE_LICENSE("Dual MIT/GPL");
MODULE_DESCRIPTION("the metronome of de1sim's lesson");
