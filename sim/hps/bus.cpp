#include "sim/hps/bus.h"

namespace sim {

Bus::Bus(const sc_core::sc_module_name& name) : sc_module{name}, socket{"socket"} {
    socket.register_b_transport(this, &Bus::b_transport);
}

tlm_utils::simple_initiator_socket<Bus>& Bus::window(const std::string& name, std::uint32_t base,
                                                     std::uint32_t size) {
    for (const Window& other : windows_)
        if (base - other.base < other.size || other.base - base < size)
            SC_REPORT_FATAL(this->name(),
                            ("window " + name + " overlaps window " + other.name).c_str());
    windows_.push_back(
        {name, base, size,
         std::make_unique<tlm_utils::simple_initiator_socket<Bus>>(("to_" + name).c_str())});
    return *windows_.back().socket;
}

Bus::Window* Bus::find(std::uint64_t address, unsigned bytes) {
    for (Window& window : windows_)
        if (address >= window.base && address - window.base < window.size &&
            bytes <= window.size - (address - window.base))
            return &window;
    return nullptr;
}

void Bus::b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
    ++(tx.get_data_length() > 4 ? counts_.bursts : tx.is_read() ? counts_.reads : counts_.writes);
    const std::uint64_t address = tx.get_address();
    if (Window* window = find(address, tx.get_data_length())) {
        tx.set_address(address - window->base);
        (*window->socket)->b_transport(tx, delay);
        tx.set_address(address);
    } else {
        tx.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);  // never a default target
    }
    if (!tx.is_response_ok()) ++counts_.errors;
}

}  // namespace sim
