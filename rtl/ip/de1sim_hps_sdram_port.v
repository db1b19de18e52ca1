// de1sim_hps_sdram_port.v - a command port of fpga2sdram, with the data ports that it uses
//
// cmd_data of Avalon-MM: read 0, write 1, address from 2 on in words of the bus, burstcount 41:34.
// Of AXI: read 0, write 1, address 34:3, length 38:35, ID 50:43, size 53:51, burst 55:54.
//
// An Avalon burst's words each come with cmd_valid; those of AXI with wr_valid.

`default_nettype none

module de1sim_hps_sdram_port #(
    parameter PORT = 0
) (
    input  wire         clk_i,
    input  wire         is_axi_i,
    input  wire [1:0]   width_i,    // 0: 32 bits, 1: 64, 2: 128, 3: 256

    input  wire         cmd_valid_i,
    output wire         cmd_ready_o,
    // verilator lint_off UNUSED
    input  wire [59:0]  cmd_data_i,
    // verilator lint_on UNUSED

    output wire         rd_valid_o,
    input  wire         rd_ready_i,
    output wire [255:0] rd_data_o,
    output wire [10:0]  rd_end_o,   // AXI's ID, last, response

    input  wire         wr_valid_i,
    output wire         wr_ready_o,
    input  wire [255:0] wr_data_i,
    input  wire [31:0]  wr_strobes_i,

    output wire         wrack_valid_o,
    input  wire         wrack_ready_i,
    output wire [9:0]   wrack_data_o  // ID, response
);
    wire [5:0]  bytes   = 6'd4 << width_i;
    wire [2:0]  bus     = {1'b0, width_i} + 3'd2;  // its size
    wire [31:0] address = is_axi_i ? cmd_data_i[34:3] : cmd_data_i[33:2] << bus;
    wire [7:0]  beats   = is_axi_i ? {4'd0, cmd_data_i[38:35]} + 8'd1 : cmd_data_i[41:34];
    wire [2:0]  size    = is_axi_i ? cmd_data_i[53:51] : bus;
    wire [1:0]  burst   = is_axi_i ? cmd_data_i[55:54] : 2'd1;
    wire [7:0]  id      = cmd_data_i[50:43];

    wire        reads_ready, writes_ready, data_ready, data_last;
    wire        data_valid = is_axi_i ? wr_valid_i : cmd_valid_i && cmd_data_i[1];
    reg         begun_q = 1'b0;  // with an Avalon burst, whose command has been taken

    de1sim_hps_reads #(.PORT(PORT)) reads (
        .clk_i(clk_i), .width_i(bytes),
        .valid_i(cmd_valid_i && cmd_data_i[0]), .ready_o(reads_ready), .address_i(address),
        .beats_i(beats), .size_i(size), .burst_i(burst), .id_i(id),
        .valid_o(rd_valid_o), .ready_i(rd_ready_i || !is_axi_i), .data_o(rd_data_o),
        .response_o(rd_end_o[1:0]), .last_o(rd_end_o[2]), .id_o(rd_end_o[10:3])
    );

    wire        command = cmd_valid_i && cmd_data_i[1] && !begun_q;
    de1sim_hps_writes #(.PORT(PORT)) writes (
        .clk_i(clk_i), .width_i(bytes),
        .valid_i(command), .ready_o(writes_ready), .address_i(address),
        .beats_i(beats), .size_i(size), .burst_i(burst), .id_i(id),
        .data_valid_i(data_valid), .data_ready_o(data_ready), .data_last_o(data_last),
        .data_i(wr_data_i), .strobes_i(wr_strobes_i),
        .valid_o(wrack_valid_o), .ready_i(wrack_ready_i || !is_axi_i),
        .response_o(wrack_data_o[1:0]), .id_o(wrack_data_o[9:2])
    );

    always @(posedge clk_i)
        if (!is_axi_i) begin
            if (data_valid && data_ready && data_last) begun_q <= 1'b0;
            else if (command && writes_ready)          begun_q <= 1'b1;
        end

    assign cmd_ready_o = cmd_data_i[0] ? reads_ready : is_axi_i ? writes_ready : data_ready;
    assign wr_ready_o  = is_axi_i && data_ready;
endmodule

`default_nettype wire
