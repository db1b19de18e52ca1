#include "sim/hps/memory.h"

#include <algorithm>
#include <cstring>

namespace sim {

Memory::Memory(const sc_core::sc_module_name& name, std::uint32_t size, sc_core::sc_time latency)
    : sc_module{name}, socket{"socket"}, size_{size}, latency_{latency} {
    socket.register_b_transport(this, &Memory::b_transport);
}

void Memory::b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
    std::uint64_t address = tx.get_address();
    std::uint64_t left = tx.get_data_length();
    std::uint8_t* data = tx.get_data_ptr();
    if (address > size_ || left > size_ - address) {
        tx.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
        return;
    }
    if (tx.get_byte_enable_ptr()) {
        tx.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
        return;
    }
    while (left) {
        const std::uint64_t at = address % PAGE, now = std::min<std::uint64_t>(left, PAGE - at);
        auto& page = pages_[static_cast<std::uint32_t>(address / PAGE)];
        if (tx.is_write()) {
            if (!page) page = std::make_unique<Page>(Page{});
            std::memcpy(page->data() + at, data, now);
        } else if (tx.is_read()) {
            if (page)
                std::memcpy(data, page->data() + at, now);
            else
                std::memset(data, 0, now);
        }
        address += now;
        data += now;
        left -= now;
    }
    delay += latency_;
    tx.set_response_status(tlm::TLM_OK_RESPONSE);
}

}  // namespace sim
