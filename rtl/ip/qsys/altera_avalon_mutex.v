// altera_avalon_mutex.v - Platform Designer's mutex, which one of several processors has
//
//   0 mutex   VALUE 15..0, OWNER 31..16: a write counts if VALUE is 0, or if its OWNER is this one
//   1 reset   RESET 0: there was a reset; a 1 clears it
//
// Source: Embedded Peripherals IP User Guide, Mutex Core.

`default_nettype none

module altera_avalon_mutex #(
    parameter [15:0] VALUE_INIT = 16'd0,
    parameter [15:0] OWNER_INIT = 16'd0
) (
    input  wire        clk,
    input  wire        reset_n,
    input  wire        address,
    input  wire        chipselect,
    input  wire        read,
    input  wire        write,
    input  wire [31:0] data_from_cpu,
    output wire [31:0] data_to_cpu
);
    reg [15:0] value_q, owner_q;
    reg        reset_q;
    wire       writes = chipselect && write;

    assign data_to_cpu = !(chipselect && read) ? 32'd0
                         : address ? {31'd0, reset_q} : {owner_q, value_q};

    always @(posedge clk) begin
        if (writes && !address && (value_q == 16'd0 || data_from_cpu[31:16] == owner_q))
            {owner_q, value_q} <= data_from_cpu;
        if (writes && address && data_from_cpu[0]) reset_q <= 1'b0;
        if (!reset_n) {owner_q, value_q, reset_q} <= {OWNER_INIT, VALUE_INIT, 1'b1};
    end
endmodule

`default_nettype wire
