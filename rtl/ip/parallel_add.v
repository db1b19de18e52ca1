// parallel_add.v - the sum of SIZE numbers, with a pipeline
//
// Number i of data is shifted to the left by i * SHIFT bits.  With MSW_SUBTRACT the last one is
// subtracted.  A result that is narrower than the sum has its lower bits, or with
// RESULT_ALIGNMENT MSB its upper ones: the sum is as wide as the last number after its shift,
// and as many bits more as SIZE numbers of this width need.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module parallel_add #(
    parameter width = 4, WIDTH = width,
    parameter size = 2, SIZE = size,
    parameter widthr = 4, WIDTHR = widthr,
    parameter shift = 0, SHIFT = shift,
    parameter msw_subtract = "NO", MSW_SUBTRACT = msw_subtract,
    parameter representation = "UNSIGNED", REPRESENTATION = representation,
    parameter pipeline = 0, PIPELINE = pipeline,
    parameter result_alignment = "LSB", RESULT_ALIGNMENT = result_alignment,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "parallel_add", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                  clock, clken, aclr,
    input  wire [SIZE*WIDTH-1:0] data,             // number 0 lowest
    output wire [WIDTHR-1:0]     result
);
    function integer more_bits(input integer numbers);
        for (more_bits = 0; 1 << more_bits < numbers; more_bits = more_bits + 1) begin end
    endfunction

    localparam SIGNED = REPRESENTATION == "SIGNED";
    localparam MINUS  = MSW_SUBTRACT == "YES";
    localparam FULL   = WIDTH + SHIFT * (SIZE - 1) + more_bits(SIZE);
    localparam TOTAL  = WIDTHR > FULL ? WIDTHR : FULL;
    localparam LOWEST = RESULT_ALIGNMENT == "MSB" && WIDTHR < FULL ? FULL - WIDTHR : 0;

    integer i;
    reg [TOTAL-1:0] number, sum;
    always @* begin
        sum = 0;
        for (i = 0; i < SIZE; i = i + 1) begin
            number = {{TOTAL{SIGNED && data[WIDTH*(i+1) - 1]}}, data[WIDTH*i +: WIDTH]};
            number = number << SHIFT * i;
            sum = MINUS && i == SIZE - 1 ? sum - number : sum + number;
        end
    end

    de1sim_pipeline #(.WIDTH(WIDTHR), .STAGES(PIPELINE)) registers (
        .clock_i(clock), .clken_i(clken), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i(sum[LOWEST +: WIDTHR]), .q_o(result));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
