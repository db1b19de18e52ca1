// cyclonev_hps_interface_fpga2sdram.v - the ports to the processor's SDRAM: they take nothing

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
    assign {cmd_ready_0, wrack_data_0, wrack_valid_0} = 12'd0;
    assign {cmd_ready_1, wrack_data_1, wrack_valid_1} = 12'd0;
    assign {cmd_ready_2, wrack_data_2, wrack_valid_2} = 12'd0;
    assign {cmd_ready_3, wrack_data_3, wrack_valid_3} = 12'd0;
    assign {cmd_ready_4, wrack_data_4, wrack_valid_4} = 12'd0;
    assign {cmd_ready_5, wrack_data_5, wrack_valid_5} = 12'd0;
    assign {rd_data_0, rd_valid_0, wr_ready_0} = 82'd0;
    assign {rd_data_1, rd_valid_1, wr_ready_1} = 82'd0;
    assign {rd_data_2, rd_valid_2, wr_ready_2} = 82'd0;
    assign {rd_data_3, rd_valid_3, wr_ready_3} = 82'd0;
endmodule

`default_nettype wire
