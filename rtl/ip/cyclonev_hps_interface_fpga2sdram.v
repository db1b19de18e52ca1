// cyclonev_hps_interface_fpga2sdram.v - the FPGA's ports to the processor's SDRAM
//
// Six command ports share four data ports of 64 bits each way.  The cfg_ inputs say how:
//
//   cfg_cport_type       2 bits of each command port: 0 unused, 1 writes, 2 reads, 3 both
//   cfg_port_width       2 bits of each command port: 0: 32 bits, 1: 64, 2: 128, 3: 256
//   cfg_axi_mm_select    a bit of each command port: AXI or Avalon-MM
//   cfg_rfifo_cport_map  4 bits of each data port for reads: its command port
//   cfg_cport_rfifo_map  3 bits of each command port: the first of its data ports; wfifo as rfifo
//
// rd_data is 63:0 of data; AXI has the response in 65:64, last in 66, the ID in 74:67.  wr_data is
// 63:0 of data; the byte enables are 87:80 of Avalon-MM, 71:64 of AXI.  wrack_data is the response
// in 1:0, the ID in 9:2, at the port of the command.
//
// Source: the Verilog that Platform Designer generates of the processor.
//
// Not handled: other clocks than cmd_port_clk_N at a port; exclusive accesses; priorities.

`default_nettype none

module cyclonev_hps_interface_fpga2sdram (
    // verilator lint_off UNUSED
    input  wire [5:0]  cfg_axi_mm_select,
    input  wire [11:0] cfg_port_width,
    input  wire [11:0] cfg_cport_type,
    input  wire [17:0] cfg_cport_rfifo_map,
    input  wire [17:0] cfg_cport_wfifo_map,
    input  wire [15:0] cfg_rfifo_cport_map,
    input  wire [15:0] cfg_wfifo_cport_map,
    input  wire [59:0] cmd_data_0,
    input  wire        cmd_valid_0,
    input  wire        cmd_port_clk_0,
    input  wire        wrack_ready_0,
    input  wire [59:0] cmd_data_1,
    input  wire        cmd_valid_1,
    input  wire        cmd_port_clk_1,
    input  wire        wrack_ready_1,
    input  wire [59:0] cmd_data_2,
    input  wire        cmd_valid_2,
    input  wire        cmd_port_clk_2,
    input  wire        wrack_ready_2,
    input  wire [59:0] cmd_data_3,
    input  wire        cmd_valid_3,
    input  wire        cmd_port_clk_3,
    input  wire        wrack_ready_3,
    input  wire [59:0] cmd_data_4,
    input  wire        cmd_valid_4,
    input  wire        cmd_port_clk_4,
    input  wire        wrack_ready_4,
    input  wire [59:0] cmd_data_5,
    input  wire        cmd_valid_5,
    input  wire        cmd_port_clk_5,
    input  wire        wrack_ready_5,
    input  wire        rd_ready_0,
    input  wire        rd_clk_0,
    input  wire [89:0] wr_data_0,
    input  wire        wr_valid_0,
    input  wire        wr_clk_0,
    input  wire        rd_ready_1,
    input  wire        rd_clk_1,
    input  wire [89:0] wr_data_1,
    input  wire        wr_valid_1,
    input  wire        wr_clk_1,
    input  wire        rd_ready_2,
    input  wire        rd_clk_2,
    input  wire [89:0] wr_data_2,
    input  wire        wr_valid_2,
    input  wire        wr_clk_2,
    input  wire        rd_ready_3,
    input  wire        rd_clk_3,
    input  wire [89:0] wr_data_3,
    input  wire        wr_valid_3,
    input  wire        wr_clk_3,
    output wire        cmd_ready_0,
    output wire [9:0]  wrack_data_0,
    output wire        wrack_valid_0,
    output wire        cmd_ready_1,
    output wire [9:0]  wrack_data_1,
    output wire        wrack_valid_1,
    output wire        cmd_ready_2,
    output wire [9:0]  wrack_data_2,
    output wire        wrack_valid_2,
    output wire        cmd_ready_3,
    output wire [9:0]  wrack_data_3,
    output wire        wrack_valid_3,
    output wire        cmd_ready_4,
    output wire [9:0]  wrack_data_4,
    output wire        wrack_valid_4,
    output wire        cmd_ready_5,
    output wire [9:0]  wrack_data_5,
    output wire        wrack_valid_5,
    output wire [79:0] rd_data_0,
    output wire        rd_valid_0,
    output wire        wr_ready_0,
    output wire [79:0] rd_data_1,
    output wire        rd_valid_1,
    output wire        wr_ready_1,
    output wire [79:0] rd_data_2,
    output wire        rd_valid_2,
    output wire        wr_ready_2,
    output wire [79:0] rd_data_3,
    output wire        rd_valid_3,
    output wire        wr_ready_3
    // verilator lint_on UNUSED
);
    // Of the command ports, by their numbers.
    wire [5:0]    clk       = {cmd_port_clk_5, cmd_port_clk_4, cmd_port_clk_3, cmd_port_clk_2,
                               cmd_port_clk_1, cmd_port_clk_0};
    wire [5:0]    cmd_valid = {cmd_valid_5, cmd_valid_4, cmd_valid_3, cmd_valid_2, cmd_valid_1,
                               cmd_valid_0};
    wire [359:0]  cmd_data  = {cmd_data_5, cmd_data_4, cmd_data_3, cmd_data_2, cmd_data_1,
                               cmd_data_0};
    wire [5:0]    wrack_ready = {wrack_ready_5, wrack_ready_4, wrack_ready_3, wrack_ready_2,
                                 wrack_ready_1, wrack_ready_0};
    wire [5:0]    cmd_ready, rd_valid, wr_ready, wrack_valid;
    wire [1535:0] rd_data;
    wire [65:0]   rd_end;
    wire [59:0]   wrack_data;
    assign {cmd_ready_5, cmd_ready_4, cmd_ready_3, cmd_ready_2, cmd_ready_1, cmd_ready_0}
        = cmd_ready;
    assign {wrack_valid_5, wrack_valid_4, wrack_valid_3, wrack_valid_2, wrack_valid_1,
            wrack_valid_0} = wrack_valid;
    assign {wrack_data_5, wrack_data_4, wrack_data_3, wrack_data_2, wrack_data_1, wrack_data_0}
        = wrack_data;

    // Of the data ports.
    wire [359:0]  wr_words  = {wr_data_3, wr_data_2, wr_data_1, wr_data_0};
    wire [3:0]    wr_valids = {wr_valid_3, wr_valid_2, wr_valid_1, wr_valid_0};
    wire [3:0]    rd_readys = {rd_ready_3, rd_ready_2, rd_ready_1, rd_ready_0};
    wire [319:0]  rd_words;
    wire [3:0]    rd_valids, wr_readys;
    assign {rd_data_3, rd_data_2, rd_data_1, rd_data_0} = rd_words;
    assign {rd_valid_3, rd_valid_2, rd_valid_1, rd_valid_0} = rd_valids;
    assign {wr_ready_3, wr_ready_2, wr_ready_1, wr_ready_0} = wr_readys;

    genvar n;
    generate
        for (n = 0; n < 6; n = n + 1) begin : command
            wire [1:0]   kind  = cfg_cport_type[2 * n +: 2];
            wire [1:0]   width = cfg_port_width[2 * n +: 2];
            wire [1:0]   first_rd = cfg_cport_rfifo_map[3 * n +: 2];
            wire [1:0]   first_wr = cfg_cport_wfifo_map[3 * n +: 2];
            // The data ports that it uses, from the first on.
            wire [3:0]   used = width == 2'd3 ? 4'hf : width == 2'd2 ? 4'h3 : 4'h1;
            wire [3:0]   ready_words = rd_readys >> first_rd;
            wire [3:0]   valid_words = wr_valids >> first_wr;
            // verilator lint_off UNUSED
            wire [359:0] words = wr_words >> (90 * first_wr);
            // verilator lint_on UNUSED

            wire         is_axi = cfg_axi_mm_select[n];
            function [7:0] strobes;
                // verilator lint_off UNUSED
                input [89:0] word;
                // verilator lint_on UNUSED
                input        axi;
                strobes = axi ? word[71:64] : word[87:80];
            endfunction

            de1sim_hps_sdram_port #(.PORT(n)) port (
                .clk_i(clk[n]), .is_axi_i(is_axi), .width_i(width),
                .cmd_valid_i(cmd_valid[n] && kind != 2'd0), .cmd_ready_o(cmd_ready[n]),
                .cmd_data_i(cmd_data[60 * n +: 60]),
                .rd_valid_o(rd_valid[n]), .rd_ready_i(|(ready_words & used)),
                .rd_data_o(rd_data[256 * n +: 256]), .rd_end_o(rd_end[11 * n +: 11]),
                .wr_valid_i(kind[0] && |(valid_words & used)), .wr_ready_o(wr_ready[n]),
                .wr_data_i({words[333:270], words[243:180], words[153:90], words[63:0]}),
                .wr_strobes_i({strobes(words[359:270], is_axi), strobes(words[269:180], is_axi),
                               strobes(words[179:90], is_axi), strobes(words[89:0], is_axi)}),
                .wrack_valid_o(wrack_valid[n]), .wrack_ready_i(wrack_ready[n]),
                .wrack_data_o(wrack_data[10 * n +: 10])
            );
        end

        for (n = 0; n < 4; n = n + 1) begin : data
            wire [2:0]    reads  = cfg_rfifo_cport_map[4 * n +: 3];
            wire [2:0]    writes = cfg_wfifo_cport_map[4 * n +: 3];
            // verilator lint_off UNUSED
            wire [17:0]   firsts = cfg_cport_rfifo_map >> (3 * reads);
            wire [1535:0] all    = rd_data >> (256 * reads);
            wire [65:0]   ends   = rd_end >> (11 * reads);
            wire [5:0]    valids = rd_valid >> reads;
            wire [5:0]    readys = wr_ready >> writes;
            // verilator lint_on UNUSED
            wire [1:0]    number = n - firsts[1:0];  // among those of its command port
            assign rd_words[80 * n +: 80] = {5'd0, ends[10:0], all[64 * number +: 64]};
            assign rd_valids[n] = valids[0];
            assign wr_readys[n] = readys[0];
        end
    endgenerate
endmodule

`default_nettype wire
