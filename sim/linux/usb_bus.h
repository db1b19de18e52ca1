// usb_bus.h - Linux' USB: the bus of the board's host controller, what is on it, who drives what.
//
//   /sys/bus/usb/devices   usb1, the root hub; 1-1, the board's hub; 1-1.1 and so on, with their
//                          interfaces, 1-1.1:1.0
//   /dev/bus/usb/001/*     usbfs, for libusb                                        usb_file.h
//
// The driver usbhid takes each keyboard, mouse and gamepad that is plugged in, and shows it as an
// input device (input.h); by usbfs a program may take it instead.  Ports and the numbers of events
// are the lowest that are free, numbers on the bus go up.
//
// A control transfer takes 1 ms.  The interrupt endpoint is asked every 8 ms for a report, if a
// transfer waits for one.  A transfer ends with a report of less than a packet, 8 bytes, or when
// its buffer is full; the rest of a report for which there is no room is lost, as the board's
// controller has it.
//
// Source: Linux 6.1, drivers/usb/core, drivers/usb/dwc2/hcd_intr.c;
// Documentation/ABI/testing/sysfs-bus-usb.
//
// Not handled: isochronous transfers, suspending, more than one configuration, authorisation.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/board/usb_ports.h"
#include "sim/linux/device.h"
#include "sim/linux/input.h"
#include "sim/linux/own_files.h"
#include "sim/linux/uevents.h"

namespace sim {

// What Linux calls a URB.
struct UsbTransfer {
    std::uint8_t endpoint = 0;
    UsbSetup setup{};                   // of endpoint 0
    UsbBytes data;                      // to be sent, or received
    std::size_t room = 0;               // for what is received
    std::uint32_t urb = 0, buffer = 0;  // the program's, where it has given one
    int status = 0;
    bool done = false;
    std::uint64_t order = 0;  // in which they were done
};

class UsbBus {
public:
    static constexpr std::uint8_t IN = 0x80;
    static constexpr unsigned MAJOR = 189;  // of the nodes below /dev/bus/usb

    // A device on the bus, or a hub.
    struct Node {
        std::string name, folder;  // "1-1.2"; in /sys
        unsigned number;
        UsbDevice* device;  // nullptr: a hub
        UsbBytes descriptor, configuration;
        std::string maker, product;   // may be empty
        std::string driver;           // of its interface, "usbhid"; or empty
        const void* owner = nullptr;  // the open file that has it, if that is "usbfs"
        bool connected = true;
        std::deque<std::weak_ptr<UsbTransfer>> waiting = {};  // for reports
        bool polled = false;                                  // at the next 8 ms

        bool has_endpoint(std::uint8_t endpoint) const { return endpoint == (1 | IN); }
    };

    // `now_ps` of the processor; `notify`: a program may go on.
    UsbBus(LinuxInput& input, UeventGroup& uevents, std::function<std::uint64_t()> now_ps,
           std::function<void()> notify);

    // What is plugged in now, and from now on.
    void attach(UsbPorts& ports);

    void list(OwnFiles& files) const;
    // By a path without links; nullptr: it is none of its.
    std::shared_ptr<LinuxDevice> open(const std::string& path);

    // Its transfers end with an error when it is unplugged.
    void submit(const std::shared_ptr<Node>& node, const std::shared_ptr<UsbTransfer>& transfer);
    // With this status, unless it is done already.
    void end(UsbTransfer& transfer, int status);
    void bind(Node& node, const std::string& driver, const void* owner = nullptr);

    const std::function<void()>& notify() const { return notify_; }

private:
    void look(UsbDevice& device);
    void add(UsbDevice& device);
    void remove(UsbDevice& device);
    std::shared_ptr<Node> node_of(const UsbDevice& device) const;
    void describe(const Node& node, OwnFiles& files) const;
    void poll_later(const std::shared_ptr<Node>& node);
    void poll(const std::shared_ptr<Node>& node);
    std::uint64_t now_ps() const;
    void tell(const Node& node, const char* action);
    static std::string uevent_of(const Node& node);

    LinuxInput& input_;
    UeventGroup& uevents_;
    const std::function<std::uint64_t()> processor_ps_;
    const std::function<void()> notify_;
    Agenda* agenda_ = nullptr;
    std::vector<std::shared_ptr<Node>> nodes_;
    unsigned next_number_ = 3;
    std::uint64_t ended_ = 0;  // transfers
};

}  // namespace sim
