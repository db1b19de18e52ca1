// metronome_driver.c - the metronome's kernel module: /dev/metronome
#include <linux/errno.h>
#include <linux/fs.h>
#include <linux/init.h>
#include <linux/io.h>
#include <linux/kernel.h>
#include <linux/miscdevice.h>
#include <linux/module.h>
#include <linux/of.h>
#include <linux/of_address.h>
#include <linux/platform_device.h>
#include <linux/uaccess.h>

#include "metronome.h"

enum { PERIOD = 0, BEATS = 4 };  // registers

static void __iomem *registers;

static long metronome_ioctl(struct file *file, unsigned int request, unsigned long argument)
{
	u32 value;

	switch (request) {
	case METRONOME_SET_PERIOD:
		if (copy_from_user(&value, (void __user *)argument, sizeof(value)))
			return -EFAULT;
		iowrite32(value, registers + PERIOD);
		return 0;
	case METRONOME_GET_BEATS:
		value = ioread32(registers + BEATS);
		if (copy_to_user((void __user *)argument, &value, sizeof(value)))
			return -EFAULT;
		return 0;
	}
	return -ENOTTY;
}

static const struct file_operations operations = {
	.owner = THIS_MODULE,
	.unlocked_ioctl = metronome_ioctl,
};

static struct miscdevice device = {
	.minor = MISC_DYNAMIC_MINOR,
	.name = "metronome",
	.fops = &operations,
};

static int metronome_probe(struct platform_device *platform)
{
	registers = of_iomap(platform->dev.of_node, 0);
	if (!registers)
		return -ENOMEM;
	pr_info("metronome: probed\n");
	return misc_register(&device);
}

static int metronome_remove(struct platform_device *platform)
{
	misc_deregister(&device);
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
