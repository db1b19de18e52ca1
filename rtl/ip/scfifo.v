// scfifo.v - Intel's FIFO of one clock
//
// Clocks from a request to what it changes, by the "FIFO Intel FPGA IP User Guide" (683522):
//
//                                             to usedw, full   to empty   to q
//     rdreq                                          1             1        1
//     wrreq, lpm_showahead OFF                       1             1        -
//     wrreq, ON                                      1             2        2
//     wrreq, add_ram_output_register ON: one more to empty and q
//     wrreq, use_eab OFF                             1             1        1 (ON)
//
// q shows with lpm_showahead the word that the next rdreq takes away, else the one that the last
// rdreq took.  A write into a full FIFO and a read from an empty one are ignored, also where the
// checking is OFF, which the guide forbids.
//
// Not handled: ECC.

`default_nettype none
// Texts of different lengths, parameters with numbers, and numbers with 0.
// verilator lint_off WIDTH
// verilator lint_off UNSIGNED

module scfifo #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthu = 1, LPM_WIDTHU = lpm_widthu,
    parameter lpm_numwords = 2, LPM_NUMWORDS = lpm_numwords,
    parameter lpm_showahead = "OFF", LPM_SHOWAHEAD = lpm_showahead,
    parameter almost_full_value = 0, ALMOST_FULL_VALUE = almost_full_value,
    parameter almost_empty_value = 0, ALMOST_EMPTY_VALUE = almost_empty_value,
    parameter allow_rwcycle_when_full = "OFF", ALLOW_RWCYCLE_WHEN_FULL = allow_rwcycle_when_full,
    parameter add_ram_output_register = "OFF", ADD_RAM_OUTPUT_REGISTER = add_ram_output_register,
    parameter use_eab = "ON", USE_EAB = use_eab,
    // Without meaning here.
    parameter overflow_checking = "ON", OVERFLOW_CHECKING = overflow_checking,
    parameter underflow_checking = "ON", UNDERFLOW_CHECKING = underflow_checking,
    parameter enable_ecc = "FALSE", ENABLE_ECC = enable_ecc,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "scfifo", LPM_TYPE = lpm_type,
    parameter maximum_depth = 0, MAXIMUM_DEPTH = maximum_depth,
    parameter maximize_speed = 5, MAXIMIZE_SPEED = maximize_speed,
    parameter optimize_for_speed = 5, OPTIMIZE_FOR_SPEED = optimize_for_speed,
    parameter ram_block_type = "AUTO", RAM_BLOCK_TYPE = ram_block_type
) (
    input  wire                  clock, aclr, sclr,
    input  wire                  wrreq,
    input  wire [LPM_WIDTH-1:0]  data,
    input  wire                  rdreq,
    output wire [LPM_WIDTH-1:0]  q,
    output wire [LPM_WIDTHU-1:0] usedw,
    output wire                  full, empty, almost_full, almost_empty,
    output wire [1:0]            eccstatus
);
    localparam AHEAD   = LPM_SHOWAHEAD == "ON";
    localparam LATENCY = USE_EAB == "OFF" ? 1
                       : 1 + AHEAD + (ADD_RAM_OUTPUT_REGISTER == "ON");  // of wrreq to empty

    reg [LPM_WIDTH-1:0] memory [0:LPM_NUMWORDS-1];
    reg [LPM_WIDTH-1:0] q_q;
    reg [31:0]          count_q, shown_q;      // words inside; of which empty knows
    reg [31:0]          write_at_q, read_at_q;
    reg [LATENCY:0]     writes_q;              // of the clocks before

    wire write = wrreq && (!full || rdreq && ALLOW_RWCYCLE_WHEN_FULL == "ON");
    wire read  = rdreq && !empty;
    wire shown = LATENCY == 1 ? write : writes_q[LATENCY - 2];

    wire [31:0] read_next = !read ? read_at_q : read_at_q == LPM_NUMWORDS - 1 ? 0 : read_at_q + 1;

    always @(posedge clock) if (write) memory[write_at_q] <= data;

    always @(posedge clock or posedge aclr)
        if (aclr) begin
            count_q <= 0;
            shown_q <= 0;
            write_at_q <= 0;
            read_at_q <= 0;
            writes_q <= 0;
            q_q <= 0;
        end else begin
            count_q <= count_q + write - read;
            shown_q <= shown_q + shown - read;
            if (write) write_at_q <= write_at_q == LPM_NUMWORDS - 1 ? 0 : write_at_q + 1;
            read_at_q <= read_next;
            writes_q <= {writes_q[LATENCY-1:0], write};
            if (AHEAD)
                q_q <= write && write_at_q == read_next ? data : memory[read_next];
            else if (read) q_q <= memory[read_at_q];
            if (sclr) begin
                count_q <= 0;
                shown_q <= 0;
                write_at_q <= 0;
                read_at_q <= 0;
                writes_q <= 0;
            end
        end

    assign q = q_q;
    assign usedw = count_q[LPM_WIDTHU-1:0];
    assign full = count_q == LPM_NUMWORDS;
    assign empty = shown_q == 0;
    assign almost_full = count_q >= ALMOST_FULL_VALUE;
    assign almost_empty = count_q < ALMOST_EMPTY_VALUE;
    assign eccstatus = 2'd0;
// verilator lint_on UNSIGNED
// verilator lint_on WIDTH
endmodule

`default_nettype wire
