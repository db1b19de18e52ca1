#include "sim/hps/bus.h"

#include <algorithm>
#include <utility>

namespace sim {

Bus::Bus(const sc_core::sc_module_name& name) : sc_module{name}, socket{"socket"} {
    socket.register_b_transport(this, &Bus::b_transport);
    socket.register_get_direct_mem_ptr(this, &Bus::get_direct_mem_ptr);
}

tlm_utils::simple_initiator_socket<Bus>& Bus::window(const std::string& name, std::uint32_t base,
                                                     std::uint32_t size) {
    for (const Window& other : windows_)
        if (base - other.base < other.size || other.base - base < size)
            SC_REPORT_FATAL(this->name(),
                            ("window " + name + " overlaps window " + other.name).c_str());
    const std::string port = "to_" + std::to_string(windows_.size());
    windows_.push_back({name, base, size,
                        std::make_unique<tlm_utils::simple_initiator_socket<Bus>>(port.c_str())});
    return *windows_.back().socket;
}

std::size_t Bus::number_of(const std::string& name) const {
    std::string names;
    for (std::size_t i = 0; i < windows_.size(); ++i) {
        if (windows_[i].name == name) return i;
        names += (i ? ", " : "") + windows_[i].name;
    }
    SC_REPORT_FATAL(this->name(), ("no window " + name + "; there are: " + names).c_str());
    return 0;  // not reached, unless SystemC was told to go on after fatal errors
}

std::function<void(bool)> Bus::gate(const std::string& name) {
    return [this, i = number_of(name)](bool on) {
        Window& window = windows_[i];
        if (std::exchange(window.on, on) != on && socket.get_base_port().size() > 0)
            socket->invalidate_direct_mem_ptr(window.base, window.base + (window.size - 1));
    };
}

void Bus::describe(const std::string& name, std::string title, std::vector<Place> places) {
    Window& window = windows_[number_of(name)];
    window.title = std::move(title);
    window.places = std::move(places);
}

namespace {

std::optional<std::uint32_t> offset_in(const std::optional<Bus::Detour>& detour,
                                       std::uint32_t address) {
    if (!detour || address < detour->from) return std::nullopt;
    const std::uint32_t offset = (address - detour->from) % detour->each;
    return offset < detour->size ? std::optional{offset} : std::nullopt;
}

}  // namespace

std::uint32_t Bus::Window::within(std::uint32_t address) const {
    const auto offset = offset_in(detour, address);
    return (offset ? detour->to + *offset : address) - base;
}

void Bus::divert(const std::string& name, const Detour& detour) {
    windows_[number_of(name)].detour = detour;
}

bool Bus::is_diverted(std::uint32_t address) const {
    return std::any_of(windows_.begin(), windows_.end(), [address](const Window& window) {
        return address - window.base < window.size && offset_in(window.detour, address);
    });
}

void Bus::on_answered(const std::string& name, Notify notify) {
    windows_[number_of(name)].notify = std::move(notify);
}

Bus::Window* Bus::find(std::uint64_t address, unsigned bytes) {
    for (Window& window : windows_)
        if (address >= window.base && address - window.base < window.size &&
            bytes <= window.size - (address - window.base))
            return &window;
    return nullptr;
}

std::string Bus::place(std::uint32_t address) const {
    for (const Window& window : windows_)
        for (const Place& place : window.places)
            if (address - place.base < place.size) return place.name;
    return "";
}

bool Bus::has_place(std::uint32_t address) const {
    for (const Window& window : windows_)
        for (const Place& place : window.places)
            if (address - place.base < place.size) return true;
    return false;
}

std::string Bus::register_at(std::uint32_t address) const {
    const auto found = registers_.find(address / 4 * 4);
    return found == registers_.end() ? place(address) : found->second;
}

bool Bus::transfer(bool write, std::uint32_t address, unsigned char* data, unsigned bytes,
                   AxiAttributes& how, sc_core::sc_time& delay) {
    const Window* window = find(address, how.beat_bytes);
    const unsigned step = window && window->shows_bursts ? bytes : how.beat_bytes;
    for (unsigned done = 0; done < bytes; done += step)
        if (!forward(write, how.fixed ? address : address + done, data + done, step, &how, delay))
            return false;
    return true;
}

bool Bus::forward(bool write, std::uint32_t address, unsigned char* data, unsigned bytes,
                  AxiAttributes* how, sc_core::sc_time& delay) {
    tlm::tlm_generic_payload tx;
    if (how) tx.set_extension(how);
    tx.set_command(write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
    tx.set_address(address);
    tx.set_data_ptr(data);
    tx.set_data_length(bytes);
    const unsigned span = how && how->fixed ? how->beat_bytes : bytes;
    tx.set_streaming_width(span);
    Window* window = find(address, span);
    if (!window || !window->on) return false;
    tx.set_address(window->within(address));
    (*window->socket)->b_transport(tx, delay);
    window->written |= write;
    return tx.is_response_ok();
}

void Bus::b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
    const sc_core::sc_time begin =
        watch_ ? sc_core::sc_time_stamp() + delay : sc_core::SC_ZERO_TIME;
    ++(tx.get_data_length() > 4 ? counts_.bursts : tx.is_read() ? counts_.reads : counts_.writes);
    const std::uint64_t address = tx.get_address();
    Window* window = find(address, tx.get_data_length());
    if (window && window->on) {
        tx.set_address(window->within(static_cast<std::uint32_t>(address)));
        (*window->socket)->b_transport(tx, delay);
        tx.set_address(address);
        window->written |= tx.is_write();
        if (window->notify && tx.is_response_ok())
            window->notify(static_cast<std::uint32_t>(address), tx.get_data_length(),
                           tx.is_write());
    } else {
        tx.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);  // never a default target
    }
    if (!tx.is_response_ok()) ++counts_.errors;
    if (watch_)
        watch_({begin, sc_core::sc_time_stamp() + delay, static_cast<std::uint32_t>(address),
                tx.get_data_length(), tx.is_write(), tx.is_response_ok(), tx.get_data_ptr()});
}

bool Bus::get_direct_mem_ptr(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi) {
    const std::uint64_t address = tx.get_address();
    dmi.init();
    if (Window* window = find(address, 1)) {
        const std::uint64_t last = window->size - 1;
        tx.set_address(address - window->base);
        const bool granted = window->on && (*window->socket)->get_direct_mem_ptr(tx, dmi);
        tx.set_address(address);
        if (!granted) dmi.set_start_address(0);
        dmi.set_start_address(window->base + dmi.get_start_address());
        dmi.set_end_address(window->base + std::min<std::uint64_t>(dmi.get_end_address(), last));
        return granted;
    }
    std::uint64_t first = 0, last = 0xFFFFFFFF;
    for (const Window& window : windows_) {
        const std::uint64_t end = std::uint64_t{window.base} + window.size;
        if (end <= address) first = std::max(first, end);
        if (window.base > address) last = std::min<std::uint64_t>(last, window.base - 1);
    }
    dmi.set_start_address(first);
    dmi.set_end_address(last);
    return false;
}

}  // namespace sim
