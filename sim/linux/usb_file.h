// usb_file.h - an open file of usbfs, /dev/bus/usb/001/*, as libusb uses it
//
// read() gives the descriptors.  Transfers are submitted as URBs and reaped when they are done, for
// which poll() shows POLLOUT; or they are waited for (LinuxKernel::usb_control()).  A transfer
// claims an interface that nobody has.  When the device is unplugged all but reaping is ENODEV.
//
// Source: Linux 6.1, drivers/usb/core/devio.c; include/uapi/linux/usbdevice_fs.h.
//
// Not handled: isochronous URBs, streams, mmap(), signals when a URB is done, HUB_PORTINFO,
// DROP_PRIVILEGES, suspending, configuration 0.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "sim/linux/device.h"
#include "sim/linux/usb_bus.h"

namespace sim {

class UsbFile final : public LinuxDevice {
public:
    UsbFile(UsbBus& bus, std::shared_ptr<UsbBus::Node> node) : bus_{bus}, node_{std::move(node)} {}
    ~UsbFile() override;

    FileStatus status() const override;
    std::string name() const override;
    unsigned can_do() const override;
    std::int64_t read(void* data, std::size_t bytes) override;
    std::int64_t read_at(void* data, std::size_t bytes, std::int64_t offset) override;
    std::int64_t seek(std::int64_t offset, int whence) override;
    // What does not wait, and REAPURB: EAGAIN where it would have to.
    std::int64_t control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) override;

    // USBDEVFS_ numbers of requests that wait.
    static constexpr std::uint8_t CONTROL = 0, BULK = 2, REAP = 12, RESET = 20;
    static bool is_request(std::uint32_t request) { return (request >> 8 & 0xFF) == 'U'; }
    // A transfer of CONTROL or BULK, and after how many ms it ends, 0: never; or the error.
    struct Begun {
        int error;
        std::shared_ptr<UsbTransfer> transfer;
        std::uint32_t ms;
    };
    Begun begin(std::uint32_t request, std::uint32_t at, AddressSpace& memory);
    // Once it is done: the bytes, or the error.
    static std::int64_t finish(const UsbTransfer& transfer, AddressSpace& memory);
    void cancel(UsbTransfer& transfer) { bus_.end(transfer, -ENOENT); }

private:
    struct Urb;

    int may_ask(const UsbSetup& setup);
    int claim(std::uint32_t interface);
    std::int64_t submit(std::uint32_t at, AddressSpace& memory);
    std::int64_t reap(std::uint32_t at, AddressSpace& memory);
    std::int64_t discard(std::uint32_t urb);
    std::int64_t driver_request(std::uint32_t interface, std::uint32_t request);
    std::int64_t take_from(std::uint32_t at, AddressSpace& memory);
    std::int64_t name_driver(std::uint32_t at, AddressSpace& memory) const;
    void reset();

    UsbBus& bus_;
    const std::shared_ptr<UsbBus::Node> node_;
    std::deque<std::shared_ptr<UsbTransfer>> transfers_;  // that have not been reaped
    std::int64_t at_ = 0;
};

}  // namespace sim
