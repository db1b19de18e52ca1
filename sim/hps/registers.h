// registers.h - a TLM target of 32-bit registers: checks accesses, leaves the meaning to its heir.
//
// An access that is not one aligned word is TLM_BURST_ERROR, with byte enables
// TLM_BYTE_ENABLE_ERROR.  Every access takes 10 ns (L4 bus, 100 MHz).
#pragma once

#include <cstdint>
#include <cstring>

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

class Registers : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Registers> socket;

protected:
    explicit Registers(const sc_core::sc_module_name& module_name)
        : sc_module{module_name}, socket{"socket"} {
        socket.register_b_transport(this, &Registers::b_transport);
    }

    // `now` is the initiator's local time.  What is no register reads 0 and ignores writes.
    virtual std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) = 0;
    virtual void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) = 0;

private:
    void b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
        if (tx.get_data_length() != 4 || tx.get_address() % 4 != 0) {
            tx.set_response_status(tlm::TLM_BURST_ERROR_RESPONSE);
            return;
        }
        if (tx.get_byte_enable_ptr()) {
            tx.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
            return;
        }
        delay += sc_core::sc_time{10, sc_core::SC_NS};
        const sc_core::sc_time now = sc_core::sc_time_stamp() + delay;
        const auto offset = static_cast<std::uint32_t>(tx.get_address());
        std::uint32_t value;
        if (tx.is_read()) {
            value = read(offset, now);
            std::memcpy(tx.get_data_ptr(), &value, 4);
        } else if (tx.is_write()) {
            std::memcpy(&value, tx.get_data_ptr(), 4);
            write(offset, value, now);
        }
        tx.set_response_status(tlm::TLM_OK_RESPONSE);
    }
};

}  // namespace sim
