// cyclonev_hps_interface_mpu_event_standby.v - events between processor and FPGA: none comes

`default_nettype none

module cyclonev_hps_interface_mpu_event_standby (
    // verilator lint_off UNUSED
    input  wire       eventi,
    output wire       evento,
    output wire [1:0] standbywfe,
    output wire [1:0] standbywfi
    // verilator lint_on UNUSED
);
    assign {evento, standbywfe, standbywfi} = 5'd0;
endmodule

`default_nettype wire
