// de1sim_pll_counters.v - a PLL's counters as a program writes them, and the clocks that they make
//
//   reconfig_to_pll    0 clock, 1 write, 2 start, 3..8 address, 9..40 data, with the clock's rise
//   reconfig_from_pll  0..31 what is at the address
//
//   3 N, 4 M, 5 C (22..18 which)   7..0 low, 15..8 high, 16 bypass, 17 odd: a half less of high
//   7 K   32 bits of a fraction of M, where FRACTIONAL
//   10 to 27   C0 to C17, to be read
//
// At the start the clocks' periods become REFERENCE_FS * N * C / (M + K / 2^32).  Where the VCO,
// which is M / N of the reference, is out of its range, the PLL does not lock again, and they stay.
// unlocks_o is high for a clock at least.

`default_nettype none

module de1sim_pll_counters #(
    parameter [63:0]      REFERENCE_FS = 64'd20000000,
    parameter             FRACTIONAL   = 0,
    parameter [31:0]      K            = 32'd0,
    parameter [17:0]      M            = 18'd0,
    parameter [17:0]      N            = 18'd0,
    parameter [18*18-1:0] C            = 324'd0   // C0 below
) (
    // verilator lint_off UNUSED
    input  wire [63:0]      reconfig_to_pll,      // some bits are those of the vendor's alone
    // verilator lint_on UNUSED
    output wire [63:0]      reconfig_from_pll,
    output reg              set_o,                // rises when these are there
    output reg              unlocks_o,
    output reg [18*64-1:0]  period_fs_o,
    output reg [18*64-1:0]  high_fs_o
);
    localparam [127:0] LEAST_FS = 128'd625000, MOST_FS = 128'd3333334;  // of the VCO: 1600, 300 MHz
    localparam [8:0]   WHOLE = 9'd256;                                  // a count of 0

    wire        clk   = reconfig_to_pll[0];
    wire        write = reconfig_to_pll[1], start = reconfig_to_pll[2];
    wire [5:0]  at    = reconfig_to_pll[8:3];
    wire [31:0] data  = reconfig_to_pll[40:9];

    reg  [17:0]       m_q, n_q;
    reg  [31:0]       k_q;
    reg  [18*18-1:0]  c_q;
    reg               starts_q;

    initial {m_q, n_q, k_q, c_q} = {M, N, K, C};

    // ---- Registers --------------------------------------------------------
    // A clock's half later, so that what comes with its rise is there.
    always @(negedge clk) begin
        if (write)
            case (at)
                6'd3:    n_q <= data[17:0];
                6'd4:    m_q <= data[17:0];
                6'd5:    if (data[22:18] < 5'd18) c_q[18*data[22:18] +: 18] <= data[17:0];
                6'd7:    k_q <= data;
                default: ;
            endcase
        starts_q <= start;
    end

    wire [5:0]  which = at - 6'd10;
    reg  [31:0] there;
    always @*
        case (at)
            6'd3:    there = {14'd0, n_q};
            6'd4:    there = {14'd0, m_q};
            6'd7:    there = k_q;
            default: there = which < 6'd18 ? {14'd0, c_q[18*which[4:0] +: 18]} : 32'd0;
        endcase
    assign reconfig_from_pll = {32'd0, there};

    // ---- Clocks -----------------------------------------------------------
    function [63:0] count(input [7:0] of);
        count = of == 8'd0 ? {55'd0, WHOLE} : {56'd0, of};
    endfunction
    function [63:0] total(input [17:0] counter);
        total = counter[16] ? 64'd1 : count(counter[15:8]) + count(counter[7:0]);
    endfunction
    // Of 2^32 femtoseconds.
    wire [127:0] multiplier = {32'd0, total(m_q), FRACTIONAL != 0 ? k_q : 32'd0};
    wire [127:0] reference  = {32'd0, REFERENCE_FS * total(n_q), 32'd0};
    wire [127:0] vco_fs     = reference / multiplier;
    wire         is_in_range = vco_fs >= LEAST_FS && vco_fs <= MOST_FS;

    integer i;
    reg [127:0] period, high;
    reg [17:0]  counter;
    always @(negedge clk) begin
        set_o     <= 1'b0;
        unlocks_o <= starts_q || (unlocks_o && !set_o);
        if (starts_q && is_in_range) begin
            set_o <= 1'b1;
            for (i = 0; i < 18; i = i + 1) begin
                counter = c_q[18*i +: 18];
                period  = (reference * {64'd0, total(counter)} + multiplier / 2) / multiplier;
                high    = counter[16] ? period / 2
                          : period * ({63'd0, count(counter[15:8]), 1'b0} - {127'd0, counter[17]})
                            / {63'd0, total(counter), 1'b0};
                period_fs_o[64*i +: 64] <= period[63:0];
                high_fs_o[64*i +: 64]   <= high[63:0];
            end
        end
    end
endmodule

`default_nettype wire
