// altdpram.v - a memory with a port to write and a port to read, as of MLABs
//
// A word is written at the edge of inclock.  Where the read address is not registered, q follows it
// at once.
//
// Not handled: clears of the inputs, a write without inclock.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altdpram #(
    parameter width = 1, WIDTH = width,
    parameter widthad = 1, WIDTHAD = widthad,
    parameter numwords = 0, NUMWORDS = numwords,
    parameter width_byteena = 1, WIDTH_BYTEENA = width_byteena,
    parameter rdaddress_reg = "OUTCLOCK", RDADDRESS_REG = rdaddress_reg,
    parameter outdata_reg = "UNREGISTERED", OUTDATA_REG = outdata_reg,
    parameter outdata_aclr = "OFF", OUTDATA_ACLR = outdata_aclr,
    parameter lpm_file = "UNUSED", LPM_FILE = lpm_file,
    // Without meaning here.
    parameter indata_reg = "INCLOCK", INDATA_REG = indata_reg,
    parameter wraddress_reg = "INCLOCK", WRADDRESS_REG = wraddress_reg,
    parameter wrcontrol_reg = "INCLOCK", WRCONTROL_REG = wrcontrol_reg,
    parameter indata_aclr = "OFF", INDATA_ACLR = indata_aclr,
    parameter wraddress_aclr = "OFF", WRADDRESS_ACLR = wraddress_aclr,
    parameter wrcontrol_aclr = "OFF", WRCONTROL_ACLR = wrcontrol_aclr,
    parameter rdaddress_aclr = "OFF", RDADDRESS_ACLR = rdaddress_aclr,
    parameter rdcontrol_aclr = "OFF", RDCONTROL_ACLR = rdcontrol_aclr,
    parameter rdcontrol_reg = "UNREGISTERED", RDCONTROL_REG = rdcontrol_reg,
    parameter byte_size = 5, BYTE_SIZE = byte_size,
    parameter disable_ce_on_input_registers = "OFF",
    parameter DISABLE_CE_ON_INPUT_REGISTERS = disable_ce_on_input_registers,
    parameter disable_ce_on_output_registers = "OFF",
    parameter DISABLE_CE_ON_OUTPUT_REGISTERS = disable_ce_on_output_registers,
    parameter maximum_depth = 0, MAXIMUM_DEPTH = maximum_depth,
    parameter ram_block_type = "AUTO", RAM_BLOCK_TYPE = ram_block_type,
    parameter read_during_write_mode_mixed_ports = "DONT_CARE",
    parameter READ_DURING_WRITE_MODE_MIXED_PORTS = read_during_write_mode_mixed_ports,
    parameter suppress_memory_conversion_warnings = "OFF",
    parameter SUPPRESS_MEMORY_CONVERSION_WARNINGS = suppress_memory_conversion_warnings,
    parameter use_eab = "ON", USE_EAB = use_eab,
    parameter implement_in_les = "OFF", IMPLEMENT_IN_LES = implement_in_les,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altdpram", LPM_TYPE = lpm_type
) (
    input  wire                     inclock, inclocken, outclock, outclocken, aclr,
    input  wire                     wren, rden,
    input  wire [WIDTHAD-1:0]       wraddress, rdaddress,
    input  wire                     wraddressstall, rdaddressstall,
    input  wire [WIDTH_BYTEENA-1:0] byteena,
    input  wire [WIDTH-1:0]         data,
    output wire [WIDTH-1:0]         q
);
    `include "de1sim_init.vh"

    localparam WORDS = NUMWORDS ? NUMWORDS : 1 << WIDTHAD;
    localparam BYTE  = WIDTH / WIDTH_BYTEENA;
    localparam INTS  = (WIDTH + 31) / 32;

    reg [WIDTH-1:0] memory [0:WORDS-1];
    reg [32*INTS-1:0] word;
    integer at, part;
    initial if (de1sim_init_file(LPM_FILE, $sformatf("%m"), WIDTH, WORDS) != 0)
        for (at = 0; at < WORDS; at = at + 1) begin
            for (part = 0; part < INTS; part = part + 1)
                word[32*part +: 32] = de1sim_init_part(at, part);
            memory[at] = word[WIDTH-1:0];
        end

    reg  [WIDTHAD-1:0] write_held_q, read_held_q;
    wire [WIDTHAD-1:0] write_at = wraddressstall ? write_held_q : wraddress;
    always @(posedge inclock) if (inclocken) write_held_q <= write_at;
    genvar i;
    generate
        for (i = 0; i < WIDTH_BYTEENA; i = i + 1) begin : bytes
            always @(posedge inclock) if (inclocken && wren && byteena[i])
                memory[write_at][BYTE*i +: BYTE] <= data[BYTE*i +: BYTE];
        end

        wire [WIDTHAD-1:0] read_at;
        if (RDADDRESS_REG == "UNREGISTERED") begin : at_once
            assign read_at = rdaddress;
        end else begin : registered
            localparam IN = RDADDRESS_REG == "INCLOCK";
            wire clock = IN ? inclock : outclock;
            always @(posedge clock)
                if ((IN ? inclocken : outclocken) && !rdaddressstall && rden)
                    read_held_q <= rdaddress;
            assign read_at = read_held_q;
        end

        if (OUTDATA_REG == "UNREGISTERED") begin : open
            assign q = memory[read_at];
        end else begin : output_register
            wire clear = OUTDATA_ACLR == "ON" && aclr;
            reg [WIDTH-1:0] q_q;
            always @(posedge outclock or posedge clear)
                if (clear) q_q <= 0;
                else if (outclocken) q_q <= memory[read_at];
            assign q = q_q;
        end
    endgenerate
// verilator lint_on WIDTH
endmodule

`default_nettype wire
