// altsource_probe.v - signals to look at and to set from a computer, of which there is none here
//
// source has its initial value, a hexadecimal text.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altsource_probe #(
    parameter source_width = 1, SOURCE_WIDTH = source_width,
    parameter probe_width = 1, PROBE_WIDTH = probe_width,
    parameter source_initial_value = "0", SOURCE_INITIAL_VALUE = source_initial_value,
    // Without meaning here.
    parameter enable_metastability = "NO", ENABLE_METASTABILITY = enable_metastability,
    parameter instance_id = "UNUSED", INSTANCE_ID = instance_id,
    parameter instance_index = 0, INSTANCE_INDEX = instance_index,
    parameter sld_auto_instance_index = "YES", SLD_AUTO_INSTANCE_INDEX = sld_auto_instance_index,
    parameter sld_instance_index = 0, SLD_INSTANCE_INDEX = sld_instance_index,
    parameter sld_node_info = 4746752, SLD_NODE_INFO = sld_node_info,
    parameter sld_ir_width = 4, SLD_IR_WIDTH = sld_ir_width,
    parameter width = 1, WIDTH = width,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altsource_probe", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire [(PROBE_WIDTH ? PROBE_WIDTH : 1)-1:0]   probe,
    input  wire                                         source_clk, source_ena,
    output wire [(SOURCE_WIDTH ? SOURCE_WIDTH : 1)-1:0] source,

    // The JTAG side, which some files connect by hand.
    input  wire                    raw_tck, tdi, usr1, clr, ena,
    input  wire                    jtag_state_cdr, jtag_state_sdr, jtag_state_e1dr,
    input  wire                    jtag_state_udr, jtag_state_cir, jtag_state_uir, jtag_state_tlr,
    input  wire [SLD_IR_WIDTH-1:0] ir_in,
    output wire [SLD_IR_WIDTH-1:0] ir_out,
    output wire                    tdo
);
    function [255:0] hexadecimal(input [8*64-1:0] text);
        integer i;
        reg [7:0] c;
        begin
            hexadecimal = 0;
            for (i = 63; i >= 0; i = i - 1) begin
                c = text[8*i +: 8];
                if (c >= "0" && c <= "9") hexadecimal = hexadecimal * 16 + {248'd0, c - "0"};
                else if (c >= "A" && c <= "F") hexadecimal = hexadecimal * 16 + {248'd0, c - 8'd55};
                else if (c >= "a" && c <= "f") hexadecimal = hexadecimal * 16 + {248'd0, c - 8'd87};
            end
        end
    endfunction

    assign source = hexadecimal(SOURCE_INITIAL_VALUE);
    assign ir_out = {SLD_IR_WIDTH{1'b0}};
    assign tdo = 1'b0;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
