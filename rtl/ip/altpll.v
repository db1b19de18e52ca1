// altpll.v - the PLL of Quartus's ALTPLL wizard: up to ten clocks made of inclk[0]
//
// The period of clk[i] is inclk0_input_frequency (which is a period in ps) * clkI_divide_by /
// clkI_multiply_by.  clk[i] is there with port_clkI "PORT_USED", or without any word about the
// port if it is clk[0] or has a factor.  It is 0 in areset, without pllena, and without its
// clkena, if those two are said to be used.  locked is that of de1sim_pll_lock.
//
// Not handled: the input's true frequency, inclk[1], reconfiguration, dynamic phase, pfdena,
// extclk, spread spectrum, feedback from outside.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altpll #(
    parameter inclk0_input_frequency = 20000, INCLK0_INPUT_FREQUENCY = inclk0_input_frequency,
    parameter width_clock = 6, WIDTH_CLOCK = width_clock,
    parameter port_pllena = "PORT_CONNECTIVITY", PORT_PLLENA = port_pllena,
    parameter clk0_multiply_by = 0, CLK0_MULTIPLY_BY = clk0_multiply_by,
    parameter clk0_divide_by = 0, CLK0_DIVIDE_BY = clk0_divide_by,
    parameter clk0_phase_shift = "0", CLK0_PHASE_SHIFT = clk0_phase_shift,
    parameter clk0_duty_cycle = 50, CLK0_DUTY_CYCLE = clk0_duty_cycle,
    parameter port_clk0 = "PORT_CONNECTIVITY", PORT_CLK0 = port_clk0,
    parameter clk1_multiply_by = 0, CLK1_MULTIPLY_BY = clk1_multiply_by,
    parameter clk1_divide_by = 0, CLK1_DIVIDE_BY = clk1_divide_by,
    parameter clk1_phase_shift = "0", CLK1_PHASE_SHIFT = clk1_phase_shift,
    parameter clk1_duty_cycle = 50, CLK1_DUTY_CYCLE = clk1_duty_cycle,
    parameter port_clk1 = "PORT_CONNECTIVITY", PORT_CLK1 = port_clk1,
    parameter clk2_multiply_by = 0, CLK2_MULTIPLY_BY = clk2_multiply_by,
    parameter clk2_divide_by = 0, CLK2_DIVIDE_BY = clk2_divide_by,
    parameter clk2_phase_shift = "0", CLK2_PHASE_SHIFT = clk2_phase_shift,
    parameter clk2_duty_cycle = 50, CLK2_DUTY_CYCLE = clk2_duty_cycle,
    parameter port_clk2 = "PORT_CONNECTIVITY", PORT_CLK2 = port_clk2,
    parameter clk3_multiply_by = 0, CLK3_MULTIPLY_BY = clk3_multiply_by,
    parameter clk3_divide_by = 0, CLK3_DIVIDE_BY = clk3_divide_by,
    parameter clk3_phase_shift = "0", CLK3_PHASE_SHIFT = clk3_phase_shift,
    parameter clk3_duty_cycle = 50, CLK3_DUTY_CYCLE = clk3_duty_cycle,
    parameter port_clk3 = "PORT_CONNECTIVITY", PORT_CLK3 = port_clk3,
    parameter clk4_multiply_by = 0, CLK4_MULTIPLY_BY = clk4_multiply_by,
    parameter clk4_divide_by = 0, CLK4_DIVIDE_BY = clk4_divide_by,
    parameter clk4_phase_shift = "0", CLK4_PHASE_SHIFT = clk4_phase_shift,
    parameter clk4_duty_cycle = 50, CLK4_DUTY_CYCLE = clk4_duty_cycle,
    parameter port_clk4 = "PORT_CONNECTIVITY", PORT_CLK4 = port_clk4,
    parameter clk5_multiply_by = 0, CLK5_MULTIPLY_BY = clk5_multiply_by,
    parameter clk5_divide_by = 0, CLK5_DIVIDE_BY = clk5_divide_by,
    parameter clk5_phase_shift = "0", CLK5_PHASE_SHIFT = clk5_phase_shift,
    parameter clk5_duty_cycle = 50, CLK5_DUTY_CYCLE = clk5_duty_cycle,
    parameter port_clk5 = "PORT_CONNECTIVITY", PORT_CLK5 = port_clk5,
    parameter clk6_multiply_by = 0, CLK6_MULTIPLY_BY = clk6_multiply_by,
    parameter clk6_divide_by = 0, CLK6_DIVIDE_BY = clk6_divide_by,
    parameter clk6_phase_shift = "0", CLK6_PHASE_SHIFT = clk6_phase_shift,
    parameter clk6_duty_cycle = 50, CLK6_DUTY_CYCLE = clk6_duty_cycle,
    parameter port_clk6 = "PORT_CONNECTIVITY", PORT_CLK6 = port_clk6,
    parameter clk7_multiply_by = 0, CLK7_MULTIPLY_BY = clk7_multiply_by,
    parameter clk7_divide_by = 0, CLK7_DIVIDE_BY = clk7_divide_by,
    parameter clk7_phase_shift = "0", CLK7_PHASE_SHIFT = clk7_phase_shift,
    parameter clk7_duty_cycle = 50, CLK7_DUTY_CYCLE = clk7_duty_cycle,
    parameter port_clk7 = "PORT_CONNECTIVITY", PORT_CLK7 = port_clk7,
    parameter clk8_multiply_by = 0, CLK8_MULTIPLY_BY = clk8_multiply_by,
    parameter clk8_divide_by = 0, CLK8_DIVIDE_BY = clk8_divide_by,
    parameter clk8_phase_shift = "0", CLK8_PHASE_SHIFT = clk8_phase_shift,
    parameter clk8_duty_cycle = 50, CLK8_DUTY_CYCLE = clk8_duty_cycle,
    parameter port_clk8 = "PORT_CONNECTIVITY", PORT_CLK8 = port_clk8,
    parameter clk9_multiply_by = 0, CLK9_MULTIPLY_BY = clk9_multiply_by,
    parameter clk9_divide_by = 0, CLK9_DIVIDE_BY = clk9_divide_by,
    parameter clk9_phase_shift = "0", CLK9_PHASE_SHIFT = clk9_phase_shift,
    parameter clk9_duty_cycle = 50, CLK9_DUTY_CYCLE = clk9_duty_cycle,
    parameter port_clk9 = "PORT_CONNECTIVITY", PORT_CLK9 = port_clk9,
    parameter port_clkena0 = "PORT_CONNECTIVITY", PORT_CLKENA0 = port_clkena0,
    parameter port_clkena1 = "PORT_CONNECTIVITY", PORT_CLKENA1 = port_clkena1,
    parameter port_clkena2 = "PORT_CONNECTIVITY", PORT_CLKENA2 = port_clkena2,
    parameter port_clkena3 = "PORT_CONNECTIVITY", PORT_CLKENA3 = port_clkena3,
    parameter port_clkena4 = "PORT_CONNECTIVITY", PORT_CLKENA4 = port_clkena4,
    parameter port_clkena5 = "PORT_CONNECTIVITY", PORT_CLKENA5 = port_clkena5,
    `include "altpll_ignored.vh"
) (
    input  wire [1:0]             inclk,
    input  wire                   areset, pllena, pfdena,
    input  wire [5:0]             clkena,
    output wire [WIDTH_CLOCK-1:0] clk,
    output wire                   locked,

    input  wire                   fbin, clkswitch, configupdate,
    input  wire [3:0]             extclkena,
    input  wire                   phasestep, phaseupdown,
    input  wire [WIDTH_PHASECOUNTERSELECT-1:0] phasecounterselect,
    input  wire                   scanaclr, scanclk, scanclkena, scandata, scanread, scanwrite,
    inout  wire                   fbmimicbidir,
    output wire [3:0]             extclk,
    output wire [1:0]             clkbad,
    output wire                   activeclock, clkloss, enable0, enable1, fbout, fref, icdrclk,
    output wire                   phasedone, scandataout, scandone, sclkout0, sclkout1,
    output wire                   vcooverrange, vcounderrange
);
    `include "de1sim_units.vh"

    function [63:0] multiply(input integer i);
        case (i)
            0: multiply = CLK0_MULTIPLY_BY;
            1: multiply = CLK1_MULTIPLY_BY;
            2: multiply = CLK2_MULTIPLY_BY;
            3: multiply = CLK3_MULTIPLY_BY;
            4: multiply = CLK4_MULTIPLY_BY;
            5: multiply = CLK5_MULTIPLY_BY;
            6: multiply = CLK6_MULTIPLY_BY;
            7: multiply = CLK7_MULTIPLY_BY;
            8: multiply = CLK8_MULTIPLY_BY;
            9: multiply = CLK9_MULTIPLY_BY;
            default: multiply = 0;
        endcase
    endfunction
    function [63:0] divide(input integer i);
        case (i)
            0: divide = CLK0_DIVIDE_BY;
            1: divide = CLK1_DIVIDE_BY;
            2: divide = CLK2_DIVIDE_BY;
            3: divide = CLK3_DIVIDE_BY;
            4: divide = CLK4_DIVIDE_BY;
            5: divide = CLK5_DIVIDE_BY;
            6: divide = CLK6_DIVIDE_BY;
            7: divide = CLK7_DIVIDE_BY;
            8: divide = CLK8_DIVIDE_BY;
            9: divide = CLK9_DIVIDE_BY;
            default: divide = 0;
        endcase
    endfunction
    function [8*40-1:0] phase(input integer i);
        case (i)
            0: phase = CLK0_PHASE_SHIFT;
            1: phase = CLK1_PHASE_SHIFT;
            2: phase = CLK2_PHASE_SHIFT;
            3: phase = CLK3_PHASE_SHIFT;
            4: phase = CLK4_PHASE_SHIFT;
            5: phase = CLK5_PHASE_SHIFT;
            6: phase = CLK6_PHASE_SHIFT;
            7: phase = CLK7_PHASE_SHIFT;
            8: phase = CLK8_PHASE_SHIFT;
            9: phase = CLK9_PHASE_SHIFT;
            default: phase = 0;
        endcase
    endfunction
    function [63:0] duty(input integer i);
        case (i)
            0: duty = CLK0_DUTY_CYCLE;
            1: duty = CLK1_DUTY_CYCLE;
            2: duty = CLK2_DUTY_CYCLE;
            3: duty = CLK3_DUTY_CYCLE;
            4: duty = CLK4_DUTY_CYCLE;
            5: duty = CLK5_DUTY_CYCLE;
            6: duty = CLK6_DUTY_CYCLE;
            7: duty = CLK7_DUTY_CYCLE;
            8: duty = CLK8_DUTY_CYCLE;
            9: duty = CLK9_DUTY_CYCLE;
            default: duty = 0;
        endcase
    endfunction
    function [8*40-1:0] port(input integer i);
        case (i)
            0: port = PORT_CLK0;
            1: port = PORT_CLK1;
            2: port = PORT_CLK2;
            3: port = PORT_CLK3;
            4: port = PORT_CLK4;
            5: port = PORT_CLK5;
            6: port = PORT_CLK6;
            7: port = PORT_CLK7;
            8: port = PORT_CLK8;
            9: port = PORT_CLK9;
            default: port = 0;
        endcase
    endfunction
    function has_enable(input integer i);
        case (i)
            0: has_enable = PORT_CLKENA0 == "PORT_USED";
            1: has_enable = PORT_CLKENA1 == "PORT_USED";
            2: has_enable = PORT_CLKENA2 == "PORT_USED";
            3: has_enable = PORT_CLKENA3 == "PORT_USED";
            4: has_enable = PORT_CLKENA4 == "PORT_USED";
            5: has_enable = PORT_CLKENA5 == "PORT_USED";
            default: has_enable = 0;
        endcase
    endfunction

    wire stopped = areset || (PORT_PLLENA == "PORT_USED" && !pllena);
    de1sim_pll_lock lock (.refclk_i(inclk[0]), .rst_i(stopped), .locked_o(locked));

    genvar i;
    generate
        for (i = 0; i < WIDTH_CLOCK; i = i + 1) begin : output_clock
            localparam [63:0] MULTIPLY = multiply(i) ? multiply(i) : 1;
            localparam [63:0] DIVIDE   = divide(i) ? divide(i) : 1;
            localparam [63:0] PERIOD_FS =
                (INCLK0_INPUT_FREQUENCY * 64'd1000 * DIVIDE + MULTIPLY / 2) / MULTIPLY;
            if (port(i) == "PORT_USED"
                || port(i) == "PORT_CONNECTIVITY" && (i == 0 || multiply(i) || divide(i)))
            begin : used
                wire clock;
                de1sim_pll_tap #(
                    .PERIOD_FS(PERIOD_FS), .PHASE_FS(de1sim_phase_fs(phase(i), PERIOD_FS)),
                    .HIGH_FS(PERIOD_FS * duty(i) / 100)
                ) tap (.clk(clock), .set_i(1'b0), .period_fs_i(64'd0), .high_fs_i(64'd0));
                if (has_enable(i)) begin : gated
                    assign clk[i] = clock && !stopped && clkena[i];
                end else begin : free
                    assign clk[i] = clock && !stopped;
                end
            end else begin : unused
                assign clk[i] = 1'b0;
            end
        end
    endgenerate

    assign extclk = 4'd0;
    assign clkbad = 2'd0;
    assign {activeclock, clkloss, enable0, enable1, fbout, fref, icdrclk} = 7'd0;
    assign phasedone = 1'b1;
    assign {scandataout, scandone, sclkout0, sclkout1, vcooverrange, vcounderrange} = 6'd0;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
