// tap_from_top.v - the tap of pll_bench: clocks of its input, and a word to the test about each

`default_nettype none

module de1sim_pll_tap #(
    parameter [63:0] PERIOD_FS = 64'd0,
    parameter [63:0] PHASE_FS  = 64'd0,
    parameter [63:0] HIGH_FS   = 64'd0,
    parameter [63:0] SETTABLE  = 64'd0
) (
    output wire        clk,
    // verilator lint_off UNUSED
    input  wire        set_i,
    input  wire [63:0] period_fs_i,
    input  wire [63:0] high_fs_i
    // verilator lint_on UNUSED
);
    import "DPI-C" function void tap_found(input longint period_fs, input longint phase_fs,
                                           input longint high_fs, input string path);
    initial tap_found(PERIOD_FS, PHASE_FS, HIGH_FS, $sformatf("%m"));

    generate
        if (PERIOD_FS == 64'd40000000 && PHASE_FS == 64'd0) begin : clock_0
            assign clk = pll_bench.clocks_i[0];
        end else if (PERIOD_FS == 64'd10000000 && PHASE_FS == 64'd7000000) begin : clock_1
            assign clk = pll_bench.clocks_i[1];
        end else if (PERIOD_FS == 64'd39721946 || PERIOD_FS == 64'd39682500) begin : clock_2
            assign clk = pll_bench.clocks_i[2];
        end else begin : nobody
            assign clk = 1'b0;
        end
    endgenerate
endmodule

`default_nettype wire
