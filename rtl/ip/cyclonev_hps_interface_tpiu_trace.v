// cyclonev_hps_interface_tpiu_trace.v - the trace port: nobody traces

`default_nettype none

module cyclonev_hps_interface_tpiu_trace (
    // verilator lint_off UNUSED
    input  wire        traceclk_ctl,
    input  wire        traceclkin,
    // verilator lint_on UNUSED
    output wire [31:0] trace_data,
    output wire        traceclk
);
    assign {trace_data, traceclk} = 33'd0;
endmodule

`default_nettype wire
