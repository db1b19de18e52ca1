#include "sim/linux/usb_bus.h"

#include <algorithm>
#include <cerrno>

#include <fmt/format.h>

#include "sim/linux/usb_file.h"

namespace sim {

namespace {

constexpr const char* CONTROLLER = "/sys/devices/platform/soc/ffb40000.usb";
constexpr const char* DEVICES = "/sys/bus/usb/devices/";
constexpr std::uint64_t PS_PER_MS = 1'000'000'000;

UsbBytes hub_descriptor(std::uint16_t vendor, std::uint16_t product, std::uint16_t release,
                        bool is_root) {
    constexpr std::uint8_t DEVICE = 1, HUB = 9, PACKET = 64;
    const auto low = [](std::uint16_t value) { return static_cast<std::uint8_t>(value); };
    const auto high = [](std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8); };
    const std::uint8_t first_text = is_root ? 1 : 0;
    return {18,
            DEVICE,
            0x00,
            0x02,
            HUB,
            0,
            1,
            PACKET,
            low(vendor),
            high(vendor),
            low(product),
            high(product),
            low(release),
            high(release),
            static_cast<std::uint8_t>(first_text * 3),
            static_cast<std::uint8_t>(first_text * 2),
            first_text,
            1};
}

const UsbBytes HUB_CONFIGURATION{9, 2, 25,   0, 1, 1, 0, 0xE0, 0,  // powered by itself
                                 9, 4, 0,    0, 1, 9, 0, 0,    0,  // a hub
                                 7, 5, 0x81, 3, 4, 0, 12};         // what has changed

}  // namespace

UsbBus::UsbBus(LinuxInput& input, UeventGroup& uevents, std::function<std::uint64_t()> now_ps,
               std::function<void()> notify)
    : input_{input},
      uevents_{uevents},
      processor_ps_{std::move(now_ps)},
      notify_{std::move(notify)} {
    const std::string root = std::string{CONTROLLER} + "/usb1";
    nodes_.push_back(std::make_shared<Node>(
        Node{"usb1", root, 1, nullptr, hub_descriptor(0x1D6B, 0x0002, 0x0601, true),
             HUB_CONFIGURATION, "Linux 6.1.0 dwc2_hsotg", "DWC OTG Controller", "hub"}));
    nodes_.push_back(std::make_shared<Node>(Node{"1-1", root + "/1-1", 2, nullptr,
                                                 hub_descriptor(0x0424, 0x2512, 0x0BB3, false),
                                                 HUB_CONFIGURATION, "", "", "hub"}));
}

// ---- Plugs --------------------------------------------------------------------------------------

void UsbBus::attach(UsbPorts& ports) {
    agenda_ = &ports.agenda;
    for (UsbDevice* const device : ports.all()) {
        device->on_plug([this, device] { device->is_plugged() ? add(*device) : remove(*device); });
        device->on_report([this, device] { look(*device); });
        if (device->is_plugged()) add(*device);
    }
}

void UsbBus::add(UsbDevice& device) {
    const std::string hub = nodes_[1]->name + ".";
    unsigned port = 1;
    const auto is_taken = [&](const auto& node) {
        return node->name == hub + std::to_string(port);
    };
    while (std::any_of(nodes_.begin(), nodes_.end(), is_taken)) ++port;
    const std::string name = hub + std::to_string(port);
    constexpr unsigned MOST = 127;
    if (next_number_ > MOST) next_number_ = 3;
    const auto node = std::make_shared<Node>(
        Node{name, nodes_[1]->folder + "/" + name, next_number_++, &device,
             device.device_descriptor(), device.configuration(), "", device.about().name, ""});
    nodes_.push_back(node);
    bind(*node, "usbhid");
    tell(*node, "add");
}

void UsbBus::remove(UsbDevice& device) {
    const auto node = node_of(device);
    node->connected = false;
    for (const auto& waiting : node->waiting)
        if (const auto transfer = waiting.lock()) end(*transfer, -ESHUTDOWN);
    bind(*node, "");
    nodes_.erase(std::find(nodes_.begin(), nodes_.end(), node));
    tell(*node, "remove");
}

std::shared_ptr<UsbBus::Node> UsbBus::node_of(const UsbDevice& device) const {
    for (const auto& node : nodes_)
        if (node->device == &device) return node;
    return nullptr;
}

void UsbBus::bind(Node& node, const std::string& driver, const void* owner) {
    const bool was_hid = node.driver == "usbhid";
    node.driver = driver;
    node.owner = owner;
    if (driver == "usbhid") {
        input_.bind(*node.device, node.name, node.folder + "/" + node.name + ":1.0");
        look(*node.device);
    } else if (was_hid) {
        input_.unbind(*node.device);
    }
    notify_();
}

void UsbBus::tell(const Node& node, const char* action) {
    std::string message =
        fmt::format("{}@{}\nACTION={}\nDEVPATH={}\nSUBSYSTEM=usb\n{}", action,
                    node.folder.substr(4), action, node.folder.substr(4), uevent_of(node));
    std::replace(message.begin(), message.end(), '\n', '\0');
    uevents_.tell(std::move(message));
    notify_();
}

// ---- Transfers ----------------------------------------------------------------------------------

std::uint64_t UsbBus::now_ps() const { return std::max(agenda_->now_ps(), processor_ps_()); }

void UsbBus::submit(const std::shared_ptr<Node>& node,
                    const std::shared_ptr<UsbTransfer>& transfer) {
    if (transfer->endpoint != 0) {
        node->waiting.push_back(transfer);
        if (node->device && node->device->has_report()) poll_later(node);
        return;
    }
    agenda_->at(now_ps() + PS_PER_MS, [this, node, transfer] {
        if (!node->connected) return end(*transfer, -ESHUTDOWN);
        if (transfer->done) return;
        constexpr std::uint8_t GET_DESCRIPTOR = 6;
        std::optional<UsbBytes> answer;
        if (node->device)
            answer = node->device->control(transfer->setup, transfer->data);
        else if (transfer->setup.request == GET_DESCRIPTOR && transfer->setup.value == 0x100)
            answer = node->descriptor;
        else if (transfer->setup.request == GET_DESCRIPTOR && transfer->setup.value == 0x200)
            answer = node->configuration;
        if (!answer) return end(*transfer, -EPIPE);
        answer->resize(std::min(answer->size(), transfer->room));
        transfer->data = std::move(*answer);
        end(*transfer, 0);
    });
}

void UsbBus::end(UsbTransfer& transfer, int status) {
    if (transfer.done) return;
    transfer.done = true;
    transfer.order = ++ended_;
    transfer.status = status;
    if (status != 0 && transfer.endpoint == 0) transfer.data.clear();
    notify_();
}

// A report has been loaded.
void UsbBus::look(UsbDevice& device) {
    const auto node = node_of(device);
    if (!node) return;
    if (node->driver == "usbhid") {
        if (device.about().reports_always) return;
        while (device.has_report()) device.take_report();
    } else if (device.has_report() && !node->waiting.empty()) {
        poll_later(node);
    }
}

void UsbBus::poll_later(const std::shared_ptr<Node>& node) {
    constexpr std::uint64_t PERIOD_PS = UsbDevice::PERIOD_MS * PS_PER_MS;
    if (std::exchange(node->polled, true)) return;
    agenda_->at((now_ps() / PERIOD_PS + 1) * PERIOD_PS, [this, node] { poll(node); });
}

void UsbBus::poll(const std::shared_ptr<Node>& node) {
    node->polled = false;
    if (!node->connected || !node->device->has_report()) return;
    while (!node->waiting.empty()) {
        const auto transfer = node->waiting.front().lock();
        if (!transfer || transfer->done) {
            node->waiting.pop_front();
            continue;
        }
        const UsbBytes report = node->device->take_report();
        UsbBytes& data = transfer->data;
        data.insert(data.end(), report.begin(), report.end());
        if (report.size() < UsbDevice::PACKET || data.size() >= transfer->room) {
            data.resize(std::min(data.size(), transfer->room));
            node->waiting.pop_front();
            end(*transfer, 0);
        }
        break;
    }
    if (!node->waiting.empty() && node->device->has_report()) poll_later(node);
}

// ---- The files ----------------------------------------------------------------------------------

std::string UsbBus::uevent_of(const Node& node) {
    const auto word = [&](std::size_t at) {
        return node.descriptor[at] | node.descriptor[at + 1] << 8;
    };
    return fmt::format(
        "MAJOR={}\nMINOR={}\nDEVNAME=bus/usb/001/{:03}\nDEVTYPE=usb_device\nPRODUCT={:x}/{:x}/"
        "{:x}\n"
        "TYPE={}/{}/{}\nBUSNUM=001\nDEVNUM={:03}\n",
        MAJOR, node.number - 1, node.number, word(8), word(10), word(12), node.descriptor[4],
        node.descriptor[5], node.descriptor[6], node.number);
}

void UsbBus::describe(const Node& node, OwnFiles& files) const {
    const UsbBytes& d = node.descriptor;
    const UsbBytes& c = node.configuration;
    const bool is_root = node.number == 1;
    const auto text = [&](const std::string& name, const std::string& value) {
        files.add_text(node.folder + "/" + name, value + "\n");
    };
    const auto word = [&](std::size_t at) { return d[at] | d[at + 1] << 8; };
    std::string both{d.begin(), d.end()};
    both.append(c.begin(), c.end());
    files.add_text(node.folder + "/descriptors", both);
    text("busnum", "1");
    text("devnum", std::to_string(node.number));
    text("devpath", is_root ? "0" : node.name.substr(2));
    text("speed", node.device ? "1.5" : "480");
    text("version", fmt::format("{:2x}.{:02x}", d[3], d[2]));
    text("maxchild", is_root ? "1" : node.device ? "0" : "4");
    text("bDeviceClass", fmt::format("{:02x}", d[4]));
    text("bDeviceSubClass", fmt::format("{:02x}", d[5]));
    text("bDeviceProtocol", fmt::format("{:02x}", d[6]));
    text("bMaxPacketSize0", std::to_string(d[7]));
    text("idVendor", fmt::format("{:04x}", word(8)));
    text("idProduct", fmt::format("{:04x}", word(10)));
    text("bcdDevice", fmt::format("{:04x}", word(12)));
    text("bNumConfigurations", "1");
    text("bConfigurationValue", "1");
    text("bNumInterfaces", " 1");
    text("bmAttributes", fmt::format("{:2x}", c[7]));
    text("bMaxPower", fmt::format("{}mA", c[8] * 2));
    text("dev", fmt::format("{}:{}", MAJOR, node.number - 1));
    files.add_text(node.folder + "/uevent", uevent_of(node));
    if (!node.maker.empty()) text("manufacturer", node.maker);
    if (!node.product.empty()) text("product", node.product);
    if (is_root) text("serial", "ffb40000.usb");
    const std::string interface = (is_root ? "1-0" : node.name) + ":1.0";
    const auto of_interface = [&](const std::string& name, const std::string& value) {
        text(interface + "/" + name, value);
    };
    of_interface("bInterfaceNumber", "00");
    of_interface("bAlternateSetting", " 0");
    of_interface("bNumEndpoints", "01");
    of_interface("bInterfaceClass", fmt::format("{:02x}", c[14]));
    of_interface("bInterfaceSubClass", fmt::format("{:02x}", c[15]));
    of_interface("bInterfaceProtocol", fmt::format("{:02x}", c[16]));
    of_interface("uevent",
                 "DEVTYPE=usb_interface" + (node.driver.empty() ? "" : "\nDRIVER=" + node.driver));
    std::string up;
    for (const char character : node.folder.substr(4))
        if (character == '/') up += "../";
    files.add_link(node.folder + "/subsystem", up + "bus/usb");
    files.add_link(node.folder + "/" + interface + "/subsystem", up + "../bus/usb");
    files.add_link(node.folder + "/driver", up + "bus/usb/drivers/usb");
    files.add_link(DEVICES + node.name, "../../.." + node.folder.substr(4));
    files.add_link(DEVICES + interface, "../../.." + node.folder.substr(4) + "/" + interface);
    if (!node.driver.empty()) {
        files.add_link(node.folder + "/" + interface + "/driver",
                       up + "../bus/usb/drivers/" + node.driver);
        files.add_link("/sys/bus/usb/drivers/" + node.driver + "/" + interface,
                       "../../../.." + node.folder.substr(4) + "/" + interface);
    }
    files.add(fmt::format("/dev/bus/usb/001/{:03}", node.number));
}

void UsbBus::list(OwnFiles& files) const {
    for (const char* driver : {"hub", "usb", "usbfs", "usbhid"})
        files.add_folder(std::string{"/sys/bus/usb/drivers/"} + driver);
    for (const auto& node : nodes_) describe(*node, files);
}

std::shared_ptr<LinuxDevice> UsbBus::open(const std::string& path) {
    for (const auto& node : nodes_)
        if (path == fmt::format("/dev/bus/usb/001/{:03}", node->number))
            return std::make_shared<UsbFile>(*this, node);
    return nullptr;
}

}  // namespace sim
