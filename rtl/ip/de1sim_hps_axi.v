// de1sim_hps_axi.v - a bridge of the processor to the FPGA as AXI3: an access is one beat

`default_nettype none

module de1sim_hps_axi #(
    parameter FULL = 0,  // as de1sim_hps_bridge
    parameter ADDRESS_BITS = 30
) (
    input  wire                    clk,
    input  wire [1:0]              size_i,  // as de1sim_hps_bridge

    output wire [ADDRESS_BITS-1:0] awaddr,
    output wire [2:0]              awsize,
    output wire                    awvalid,
    input  wire                    awready,
    output wire [127:0]            wdata,
    output wire [15:0]             wstrb,
    output wire                    wvalid,
    input  wire                    wready,
    input  wire                    bvalid,

    output wire [ADDRESS_BITS-1:0] araddr,
    output wire [2:0]              arsize,
    output wire                    arvalid,
    input  wire                    arready,
    input  wire [127:0]            rdata,
    input  wire                    rvalid
);
    wire         valid, write;
    // verilator lint_off UNUSED
    wire [31:0]  address;  // of 16 bytes
    // verilator lint_on UNUSED
    wire [127:0] data;
    wire [15:0]  be;

    reg          aw_done_q = 0, w_done_q = 0;
    wire         aw_done = aw_done_q || awready, w_done = w_done_q || wready;
    wire         ready = write ? aw_done && w_done : arready;

    de1sim_hps_bridge #(.FULL(FULL), .WIDTH(128)) bridge (
        .clk_i(clk), .size_i(size_i),
        .valid_o(valid), .ready_i(ready), .write_o(write), .address_o(address),
        .wdata_o(data), .be_o(be),
        .waits_i(!valid ? (write ? 3'd3 : 3'd5) : !write ? 3'd4 : !aw_done ? 3'd1 : 3'd2),
        .rvalid_i((!valid || ready) && (bvalid || rvalid)),
        .rdata_i(size_i == 2'd0 ? {4{rdata[31:0]}} : size_i == 2'd1 ? {2{rdata[63:0]}} : rdata)
    );

    always @(posedge clk) begin
        aw_done_q <= valid && write && aw_done && !ready;
        w_done_q  <= valid && write && w_done && !ready;
    end

    assign awvalid = valid && write && !aw_done_q;
    assign wvalid  = valid && write && !w_done_q;
    assign arvalid = valid && !write;

    // ---- The smallest part of the bus that holds the bytes ----

    function [3:0] first_byte(input [15:0] enables);
        integer n;
        begin
            first_byte = 4'd0;
            for (n = 15; n >= 0; n = n - 1) if (enables[n]) first_byte = n[3:0];
        end
    endfunction

    function [3:0] last_byte(input [15:0] enables);
        integer n;
        begin
            last_byte = 4'd0;
            for (n = 0; n < 16; n = n + 1) if (enables[n]) last_byte = n[3:0];
        end
    endfunction

    wire [3:0] first = first_byte(be);
    wire [3:0] differ = first ^ last_byte(be);
    wire [2:0] size = differ[3] ? 3'd4 : differ[2] ? 3'd3 : differ[1] ? 3'd2 : {2'd0, differ[0]};

    assign {awsize, arsize} = {2{size}};
    assign awaddr = {address[ADDRESS_BITS-1:4], first};
    assign araddr = {address[ADDRESS_BITS-1:4], first};

    // ---- Its lanes ----

    wire [7:0] be_of_64 = be[15:8] | be[7:0];
    wire [3:0] be_of_32 = be_of_64[7:4] | be_of_64[3:0];
    assign wdata = size_i == 2'd0 ? {4{|be_of_64[7:4] ? data[63:32] : data[31:0]}} : data;
    assign wstrb = size_i == 2'd0 ? {12'd0, be_of_32} : size_i == 2'd1 ? {8'd0, be_of_64} : be;
endmodule

`default_nettype wire
