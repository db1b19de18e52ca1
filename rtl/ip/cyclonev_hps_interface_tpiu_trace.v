// cyclonev_hps_interface_tpiu_trace.v - the trace port: nobody uses it

`default_nettype none

module cyclonev_hps_interface_tpiu_trace (
    // verilator lint_off UNUSED
    input  wire  traceclk_ctl
    // verilator lint_on UNUSED
);
endmodule

`default_nettype wire
