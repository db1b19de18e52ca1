// de1sim_hps_bridge.v - a bridge of the processor to the FPGA: its accesses as commands
//
// It meets the simulated processor in the chip around the design (de1sim_chip.v): an access is
// there when its bit of hps_request differs from that of hps_answer.  Commands as in
// de1sim_avalon_decoder.v, one at a time, of up to eight bytes.

`default_nettype none

module de1sim_hps_bridge #(
    parameter FULL  = 0,   // 1: HPS-to-FPGA, 0: the lightweight one
    parameter WIDTH = 32,  // 32, 64 or 128
    parameter BYTES = WIDTH / 8
) (
    input  wire             clk_i,
    input  wire [1:0]       size_i,  // of the bus behind it: 0: 32 bits, 1: 64, 2: 128, 3: unused

    output wire             valid_o,
    input  wire             ready_i,
    output wire             write_o,
    output wire [31:0]      address_o,
    output wire [WIDTH-1:0] wdata_o,
    output wire [BYTES-1:0] be_o,
    input  wire [2:0]       waits_i,  // for what, as de1sim_chip's hps_waits_o; 0: not known
    input  wire             rvalid_i,
    input  wire [WIDTH-1:0] rdata_i
);
`ifdef DE1SIM_LISTS
    // The design alone, without the chip.
    assign valid_o   = 1'b0;
    assign write_o   = 1'b0;
    assign address_o = 32'd0;
    assign wdata_o   = {WIDTH{1'b0}};
    assign be_o      = {BYTES{1'b0}};
`else
    localparam COPIES = WIDTH > 64 ? WIDTH / 64 : 1;

    reg              busy_q = 0, valid_q = 0, write_q = 0, answer_q = 0;
    reg  [31:0]      address_q = 0;
    reg  [63:0]      wdata_q = 0;
    reg  [7:0]       be_q = 0;
    reg  [63:0]      rdata_q = 0;

    wire             request = FULL != 0 ? de1sim_chip.hps_request[1] : de1sim_chip.hps_request[0];
    wire [BYTES-1:0] lane    = address_q & (BYTES - 1) & ~7;
    wire [127:0]     answer  = {{128-WIDTH{1'b0}}, rdata_i} >> {lane, 3'd0};
    wire [127:0]     wide    = {2{wdata_q}};

    assign valid_o   = valid_q;
    assign write_o   = write_q;
    assign address_o = address_q & ~(BYTES - 1);
    assign wdata_o   = WIDTH == 32 ? wdata_q >> {address_q[2], 5'd0} : wide[WIDTH-1:0];
    assign be_o      = WIDTH == 32 ? be_q >> {address_q[2], 2'd0} : {8'd0, be_q} << lane;

    always @(posedge clk_i) begin
        if (!busy_q && request != answer_q) begin
            busy_q    <= 1'b1;
            valid_q   <= 1'b1;
            write_q   <= de1sim_chip.hps_write;
            address_q <= de1sim_chip.hps_address;
            wdata_q   <= de1sim_chip.hps_wdata;
            be_q      <= de1sim_chip.hps_be;
        end
        if (valid_q && ready_i) valid_q <= 1'b0;
        if (rvalid_i) begin
            busy_q   <= 1'b0;
            answer_q <= !answer_q;
            rdata_q  <= WIDTH == 32 ? {2{rdata_i[31:0]}} : answer[63:0];
        end
        if (de1sim_chip.hps_reset[0]) begin  // ends an access, which nobody will answer
            busy_q   <= 1'b0;
            valid_q  <= 1'b0;
            answer_q <= request;
        end
    end

    generate
        if (FULL != 0) begin : full
            assign de1sim_chip.hps_answer[1] = answer_q;
            assign de1sim_chip.hps_full_rdata = rdata_q;
            assign de1sim_chip.hps_size[3:2] = size_i + 2'd1;
            assign de1sim_chip.hps_waits[5:3] = busy_q ? waits_i : 3'd7;
        end else begin : lightweight
            assign de1sim_chip.hps_answer[0] = answer_q;
            assign de1sim_chip.hps_lw_rdata = rdata_q;
            assign de1sim_chip.hps_size[1:0] = size_i + 2'd1;
            assign de1sim_chip.hps_waits[2:0] = busy_q ? waits_i : 3'd7;
        end
    endgenerate
`endif
endmodule

`default_nettype wire
