// altera_avalon_new_sdram_controller.v - Platform Designer's SDRAM controller: one row is open
//
// A read in the open row is a READ in each clock; its data are taken casLatency + 1 clocks after
// the command is at the pins.  Another row costs PRECHARGE and ACTIVE.  Refreshes come in time,
// whatever is asked.
//
// Source: Embedded Peripherals IP User Guide, SDRAM Controller Core.
//
// Not handled: several chip selects, pins that are shared with other memories.

`default_nettype none

module altera_avalon_new_sdram_controller #(
    parameter dataWidth   = 16,
    parameter rowWidth    = 13,
    parameter columnWidth = 10,
    parameter casLatency  = 3,
    parameter POWER_UP    = 10000,  // clocks, as all that follow
    parameter REFRESH     = 781,    // between two
    parameter T_RP        = 2,
    parameter T_RCD       = 2,
    parameter T_RFC       = 7,
    parameter T_WR        = 2,
    parameter T_MRD       = 3,
    parameter INIT_REFRESHES = 2,
    parameter BYTES       = dataWidth / 8,
    parameter ADDRESS     = 2 + rowWidth + columnWidth
) (
    input  wire                 clk,
    input  wire                 reset_n,

    input  wire [ADDRESS-1:0]   az_addr,        // row and bank above the column
    input  wire [BYTES-1:0]     az_be_n,
    input  wire                 az_cs,
    input  wire [dataWidth-1:0] az_data,
    input  wire                 az_rd_n,
    input  wire                 az_wr_n,
    output reg  [dataWidth-1:0] za_data,
    output reg                  za_valid,
    output wire                 za_waitrequest,

    output reg  [rowWidth-1:0]  zs_addr,
    output reg  [1:0]           zs_ba,
    output reg                  zs_cas_n,
    output wire                 zs_cke,
    output reg                  zs_cs_n,
    inout  wire [dataWidth-1:0] zs_dq,
    output reg  [BYTES-1:0]     zs_dqm,
    output reg                  zs_ras_n,
    output reg                  zs_we_n
);
    // CS_N, RAS_N, CAS_N, WE_N.
    localparam [3:0] NOP = 4'b0111, PRECHARGE = 4'b0010, REFRESHES = 4'b0001, MODE = 4'b0000,
                     ACTIVE = 4'b0011, READ = 4'b0101, WRITE = 4'b0100;
    localparam [2:0] WAITS = 3'd0, CLOSES = 3'd1, INIT = 3'd2, SETS = 3'd3, IDLE = 3'd4;

    // The bank is between row and column, in two parts: its upper bit is the address's highest.
    wire [columnWidth-1:0] column = az_addr[columnWidth-1:0];
    wire [rowWidth-1:0]    row    = az_addr[columnWidth+1 +: rowWidth];
    wire [1:0]             bank   = {az_addr[ADDRESS-1], az_addr[columnWidth]};

    wire asks   = az_cs && !(az_rd_n && az_wr_n);
    wire writes = !az_wr_n;

    // ---- The state --------------------------------------------------------
    reg [2:0]          state_q, then_q;  // then_q: after a wait
    reg [15:0]         left_q;           // clocks of the wait
    reg [15:0]         refresh_q;        // until the next one is due
    reg                due_q;
    reg [3:0]          inits_q;
    reg                open_q;
    reg [rowWidth-1:0] row_q;
    reg [1:0]          bank_q;
    reg [7:0]          written_q;        // clocks until a written row may be closed
    reg [casLatency+1:0] reads_q;        // under way

    wire hit   = open_q && row == row_q && bank == bank_q;
    wire quiet = reads_q == 0;
    wire takes = state_q == IDLE && !due_q && asks && hit && (!writes || quiet);

    assign za_waitrequest = !takes;
    assign zs_cke = 1'b1;

    reg                 drives_q;
    reg [dataWidth-1:0] data_q;
    assign zs_dq = drives_q ? data_q : {dataWidth{1'bz}};

    always @(posedge clk)
        if (!reset_n) begin
            state_q   <= WAITS;
            then_q    <= CLOSES;
            left_q    <= POWER_UP;
            refresh_q <= REFRESH;
            inits_q   <= INIT_REFRESHES;
            {due_q, open_q, drives_q, za_valid} <= 4'd0;
            written_q <= 8'd0;
            reads_q   <= 0;
            {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= 4'b1111;
            zs_addr   <= 0;
            zs_ba     <= 2'd0;
            zs_dqm    <= {BYTES{1'b1}};
            za_data   <= 0;
            data_q    <= 0;
            row_q     <= 0;
            bank_q    <= 2'd0;
        end else begin
            {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= NOP;
            drives_q  <= 1'b0;
            zs_dqm    <= {BYTES{1'b0}};
            refresh_q <= refresh_q == 16'd0 ? REFRESH : refresh_q - 16'd1;
            if (refresh_q == 16'd0) due_q <= 1'b1;
            if (written_q != 8'd0) written_q <= written_q - 8'd1;
            reads_q  <= {reads_q[casLatency:0], takes && !writes};
            za_valid <= reads_q[casLatency];
            za_data  <= zs_dq;
            case (state_q)
                WAITS:
                    if (left_q == 16'd0) state_q <= then_q;
                    else left_q <= left_q - 16'd1;
                CLOSES: begin
                    {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= PRECHARGE;
                    zs_addr[10] <= 1'b1;  // all banks
                    state_q <= WAITS;
                    then_q  <= INIT;
                    left_q  <= T_RP;
                end
                INIT:
                    if (inits_q == 4'd0) begin
                        state_q <= SETS;
                    end else begin
                        {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= REFRESHES;
                        inits_q <= inits_q - 4'd1;
                        state_q <= WAITS;
                        left_q  <= T_RFC;
                    end
                SETS: begin
                    {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= MODE;
                    zs_ba   <= 2'd0;
                    zs_addr <= casLatency << 4;  // bursts of one
                    state_q <= WAITS;
                    then_q  <= IDLE;
                    left_q  <= T_MRD;
                end
                IDLE:
                    if (takes) begin
                        {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= writes ? WRITE : READ;
                        zs_addr  <= {{rowWidth-columnWidth{1'b0}}, column};
                        zs_ba    <= bank;
                        zs_dqm   <= writes ? az_be_n : {BYTES{1'b0}};
                        drives_q <= writes;
                        data_q   <= az_data;
                        if (writes) written_q <= T_WR;
                    end else if (open_q && quiet && written_q == 8'd0 && (due_q || (asks && !hit)))
                    begin
                        {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= PRECHARGE;
                        zs_addr[10] <= 1'b1;
                        open_q  <= 1'b0;
                        state_q <= WAITS;
                        left_q  <= T_RP;
                    end else if (!open_q && due_q) begin
                        {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= REFRESHES;
                        due_q   <= 1'b0;
                        state_q <= WAITS;
                        left_q  <= T_RFC;
                    end else if (!open_q && asks) begin
                        {zs_cs_n, zs_ras_n, zs_cas_n, zs_we_n} <= ACTIVE;
                        zs_addr <= row;
                        zs_ba   <= bank;
                        row_q   <= row;
                        bank_q  <= bank;
                        open_q  <= 1'b1;
                        state_q <= WAITS;
                        left_q  <= T_RCD;
                    end
                default: state_q <= IDLE;
            endcase
        end
endmodule

`default_nettype wire
