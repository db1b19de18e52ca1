// hex_port.v - HEX3-0 and HEX5-4: six digits of seven segments, a byte each, bit 7 reads 0
//
// The registers hold the pins' levels, so a digit is inverted when it is written and when it is
// read.

`default_nettype none

module hex_port (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_low_i,     // HEX3_0 is addressed
    input  wire        we_high_i,    // HEX5_4 is
    input  wire [3:0]  wstrb_i,
    // Only the register's offset in the block is used, and seven bits of each byte.
    // verilator lint_off UNUSED
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    input  wire [31:0] wdata_i,
    // verilator lint_on UNUSED
    input  wire        re_low_i,
    input  wire        re_high_i,
    output reg  [31:0] rdata_o,

    output reg  [41:0] hex_no,       // HEX5 in 41:35 ... HEX0 in 6:0, segments g..a, 0 = lit
    output wire        awake_o
);
    assign awake_o = rdata_o != 32'd0;

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_low_i && raddr_i[3:0] == 4'd0)
            rdata_o <= {1'b0, ~hex_no[27:21], 1'b0, ~hex_no[20:14], 1'b0, ~hex_no[13:7],
                        1'b0, ~hex_no[6:0]};
        if (re_high_i && raddr_i[3:0] == 4'd0)
            rdata_o <= {17'd0, ~hex_no[41:35], 1'b0, ~hex_no[34:28]};

        if (we_low_i && waddr_i[3:0] == 4'd0) begin
            if (wstrb_i[0]) hex_no[6:0]   <= ~wdata_i[6:0];
            if (wstrb_i[1]) hex_no[13:7]  <= ~wdata_i[14:8];
            if (wstrb_i[2]) hex_no[20:14] <= ~wdata_i[22:16];
            if (wstrb_i[3]) hex_no[27:21] <= ~wdata_i[30:24];
        end
        if (we_high_i && waddr_i[3:0] == 4'd0) begin
            if (wstrb_i[0]) hex_no[34:28] <= ~wdata_i[6:0];
            if (wstrb_i[1]) hex_no[41:35] <= ~wdata_i[14:8];
        end
        if (rst_i) hex_no <= ~42'd0;
    end
endmodule

`default_nettype wire
