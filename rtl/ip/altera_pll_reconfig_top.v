// altera_pll_reconfig_top.v - the registers by which a program changes an altera_pll's counters
//
//   0 mode     0: accesses wait while the PLL is set, 1: status is to be looked at
//   1 status   0 the PLL is not being set
//   2 start    write: what has been written since becomes the PLL's
//   3 N, 4 M, 5 C (22..18 which), 7 K, 10 to 27 C0 to C17 to be read: de1sim_pll_counters.v
//
// Setting takes BUSY clocks here, a guess, in which nothing is written.
//
// Source: AN 661, Fractional PLL Reconfiguration with Altera PLL and Altera PLL Reconfig.
//
// Not handled: dynamic phase shifts (6), bandwidth (8), charge pump (9) and VCO divider (28), which
// keep what is written; a MIF (31).

`default_nettype none

module altera_pll_reconfig_top #(
    parameter enable_byteenable = 0, ENABLE_BYTEENABLE = enable_byteenable,
    parameter byteenable_width = 4, BYTEENABLE_WIDTH = byteenable_width,
    parameter reconf_width = 64, RECONF_WIDTH = reconf_width,
    parameter reconfig_addr_width = 6, RECONFIG_ADDR_WIDTH = reconfig_addr_width,
    parameter reconfig_data_width = 32, RECONFIG_DATA_WIDTH = reconfig_data_width,
    // Without meaning here.
    parameter device_family = "Cyclone V", DEVICE_FAMILY = device_family,
    parameter enable_mif = 0, ENABLE_MIF = enable_mif,
    parameter mif_file_name = "", MIF_FILE_NAME = mif_file_name,
    parameter rom_addr_width = 9, ROM_ADDR_WIDTH = rom_addr_width,
    parameter rom_data_width = 32, ROM_DATA_WIDTH = rom_data_width,
    parameter rom_num_words = 512, ROM_NUM_WORDS = rom_num_words,
    parameter wait_for_lock = 1, WAIT_FOR_LOCK = wait_for_lock
) (
    input  wire                           mgmt_clk,
    input  wire                           mgmt_reset,
    input  wire                           mgmt_read,
    input  wire                           mgmt_write,
    input  wire [RECONFIG_ADDR_WIDTH-1:0] mgmt_address,
    input  wire [RECONFIG_DATA_WIDTH-1:0] mgmt_writedata,
    // verilator lint_off UNUSED
    input  wire [BYTEENABLE_WIDTH-1:0]    mgmt_byteenable,   // a counter is written whole
    // verilator lint_on UNUSED
    output wire [RECONFIG_DATA_WIDTH-1:0] mgmt_readdata,
    output wire                           mgmt_waitrequest,

    output wire [RECONF_WIDTH-1:0]        reconfig_to_pll,
    // verilator lint_off UNUSED
    input  wire [RECONF_WIDTH-1:0]        reconfig_from_pll  // some bits are the vendor's alone
    // verilator lint_on UNUSED
);
    localparam [7:0] BUSY = 8'd100;
    localparam [5:0] MODE = 6'd0, STATUS = 6'd1, START = 6'd2, PHASE = 6'd6, BANDWIDTH = 6'd8,
                     CHARGE_PUMP = 6'd9, VCO_DIVIDER = 6'd28;

    reg         polled_q, read_q, write_q, start_q;
    reg  [7:0]  busy_q;
    reg  [31:0] data_q, phase_q, bandwidth_q, pump_q, divider_q;
    reg  [5:0]  at_q;

    // ---- The program's side -----------------------------------------------
    // A read takes two clocks, in the second of which the PLL's answer is there.
    wire        busy   = busy_q != 8'd0;
    wire        waits  = busy && !polled_q;
    wire        writes = mgmt_write && !waits;
    wire [5:0]  at     = mgmt_address;
    assign mgmt_waitrequest = waits || (mgmt_read && !read_q);
    assign mgmt_readdata = at == MODE ? {31'd0, polled_q} : at == STATUS ? {31'd0, !busy}
                         : at == PHASE ? phase_q : at == BANDWIDTH ? bandwidth_q
                         : at == CHARGE_PUMP ? pump_q : at == VCO_DIVIDER ? divider_q
                         : reconfig_from_pll[31:0];

    always @(posedge mgmt_clk) begin
        read_q  <= mgmt_read && !waits && !read_q;
        write_q <= writes && !busy;
        start_q <= writes && !busy && at == START;
        if (mgmt_read || mgmt_write) at_q <= at;
        data_q  <= mgmt_writedata;
        if (writes && !busy)
            case (at)
                MODE:        polled_q    <= mgmt_writedata[0];
                PHASE:       phase_q     <= mgmt_writedata;
                BANDWIDTH:   bandwidth_q <= mgmt_writedata;
                CHARGE_PUMP: pump_q      <= mgmt_writedata;
                VCO_DIVIDER: divider_q   <= mgmt_writedata;
                default:     ;
            endcase
        if (busy) busy_q <= busy_q - 8'd1;
        if (writes && !busy && at == START) busy_q <= BUSY;
        if (mgmt_reset) begin
            {polled_q, read_q, write_q, start_q, busy_q} <= 12'd0;
            {phase_q, bandwidth_q, pump_q, divider_q}    <= 128'd0;
        end
    end

    // ---- The PLL's side ---------------------------------------------------
    assign reconfig_to_pll = {{RECONF_WIDTH - 41{1'b0}}, data_q, at_q, start_q, write_q, mgmt_clk};
endmodule

`default_nettype wire
