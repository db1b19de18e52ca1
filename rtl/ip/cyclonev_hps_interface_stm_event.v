// cyclonev_hps_interface_stm_event.v - events for the system trace: nobody reads them

`default_nettype none

module cyclonev_hps_interface_stm_event (
    // verilator lint_off UNUSED
    input  wire [27:0] stm_event
    // verilator lint_on UNUSED
);
endmodule

`default_nettype wire
