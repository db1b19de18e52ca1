// dcfifo_mixed_widths.v - Intel's FIFO from one clock to another, its words wider at one end
//
// Of a wide word the lowest bits are the first narrow one.  lpm_numwords counts those of the
// writing end, as wrusedw does; rdusedw counts the reading end's, whole ones only.
//
// Clocks from a request to what it changes, by the "FIFO Intel FPGA IP User Guide" (683522), with
// n = rdsync_delaypipe - 2 stages to the reading end and m = wrsync_delaypipe - 2 back:
//
//                          wrreq                    rdreq
//     wrfull, wrempty      1 wrclk                  1 rdclk + m wrclk
//     wrusedw              2 wrclk                  1 rdclk + m + 1 wrclk
//     rdfull, rdempty      2 wrclk + n rdclk        1 rdclk
//     rdusedw              2 wrclk + n + 1 rdclk    2 rdclk
//
// q is as scfifo's.  A write into a full FIFO and a read from an empty one are ignored, also where
// the checking is OFF, which the guide forbids.  Pulses of aclr take effect at once at both ends.
//
// Not handled: ECC, aclr synchronised to a clock.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module dcfifo_mixed_widths #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthu = 1, LPM_WIDTHU = lpm_widthu,
    parameter lpm_width_r = 1, LPM_WIDTH_R = lpm_width_r,
    parameter lpm_widthu_r = 1, LPM_WIDTHU_R = lpm_widthu_r,
    parameter lpm_numwords = 4, LPM_NUMWORDS = lpm_numwords,
    parameter lpm_showahead = "OFF", LPM_SHOWAHEAD = lpm_showahead,
    parameter rdsync_delaypipe = 4, RDSYNC_DELAYPIPE = rdsync_delaypipe,
    parameter wrsync_delaypipe = 4, WRSYNC_DELAYPIPE = wrsync_delaypipe,
    // Without meaning here.
    parameter add_ram_output_register = "OFF", ADD_RAM_OUTPUT_REGISTER = add_ram_output_register,
    parameter clocks_are_synchronized = "FALSE",
    parameter CLOCKS_ARE_SYNCHRONIZED = clocks_are_synchronized,
    parameter add_usedw_msb_bit = "OFF", ADD_USEDW_MSB_BIT = add_usedw_msb_bit,
    parameter delay_rdusedw = 1, DELAY_RDUSEDW = delay_rdusedw,
    parameter delay_wrusedw = 1, DELAY_WRUSEDW = delay_wrusedw,
    parameter enable_ecc = "FALSE", ENABLE_ECC = enable_ecc,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "dcfifo_mixed_widths", LPM_TYPE = lpm_type,
    parameter maximize_speed = 5, MAXIMIZE_SPEED = maximize_speed,
    parameter optimize_for_speed = 5, OPTIMIZE_FOR_SPEED = optimize_for_speed,
    parameter overflow_checking = "ON", OVERFLOW_CHECKING = overflow_checking,
    parameter ram_block_type = "AUTO", RAM_BLOCK_TYPE = ram_block_type,
    parameter read_aclr_synch = "OFF", READ_ACLR_SYNCH = read_aclr_synch,
    parameter underflow_checking = "ON", UNDERFLOW_CHECKING = underflow_checking,
    parameter use_eab = "ON", USE_EAB = use_eab,
    parameter write_aclr_synch = "OFF", WRITE_ACLR_SYNCH = write_aclr_synch
) (
    input  wire                    aclr,

    input  wire                    wrclk, wrreq,
    input  wire [LPM_WIDTH-1:0]    data,
    output wire                    wrfull, wrempty,
    output wire [LPM_WIDTHU-1:0]   wrusedw,

    input  wire                    rdclk, rdreq,
    output wire [LPM_WIDTH_R-1:0]  q,
    output wire                    rdfull, rdempty,
    output wire [LPM_WIDTHU_R-1:0] rdusedw,

    output wire [1:0]              eccstatus
);
    localparam AHEAD   = LPM_SHOWAHEAD == "ON";
    localparam WIDTH   = LPM_WIDTH > LPM_WIDTH_R ? LPM_WIDTH : LPM_WIDTH_R;
    localparam PARTS   = WIDTH / LPM_WIDTH;           // words written and read in one of memory
    localparam PARTS_R = WIDTH / LPM_WIDTH_R;
    localparam WORDS   = LPM_NUMWORDS / PARTS;
    localparam STAGES   = RDSYNC_DELAYPIPE > 3 ? RDSYNC_DELAYPIPE - 2 : 1;
    localparam STAGES_W = WRSYNC_DELAYPIPE > 3 ? WRSYNC_DELAYPIPE - 2 : 1;

    // Words written and read since the reset.  Only their differences matter, and their lower bits.
    reg [31:0] written_q, written_gray_q, read_q;
    reg [32*STAGES-1:0]   written_meta_q;             // what the reading end knows, newest lowest
    reg [32*STAGES_W-1:0] read_meta_q;

    reg [WIDTH-1:0] memory [0:WORDS-1];

    // ---- The writing end ----------------------------------------------------
    // In parts of a memory's word: those of the word that is being read count as there.
    wire [31:0] read_seen = read_meta_q[32*STAGES_W-1 -: 32];
    wire [31:0] used      = (written_q * PARTS_R - read_seen * PARTS + PARTS_R - 1) / PARTS_R;
    wire        write     = wrreq && !wrfull;
    wire [31:0] slot      = written_q % LPM_NUMWORDS;
    reg  [31:0] used_q;

    always @(posedge wrclk)
        if (write) memory[slot / PARTS][(slot % PARTS) * LPM_WIDTH +: LPM_WIDTH] <= data;

    always @(posedge wrclk or posedge aclr)
        if (aclr) begin
            written_q <= 0;
            written_gray_q <= 0;
            read_meta_q <= 0;
            used_q <= 0;
        end else begin
            written_q <= written_q + write;
            written_gray_q <= written_q;
            read_meta_q <= {read_meta_q, read_q};
            used_q <= used;
        end

    assign wrfull = used == LPM_NUMWORDS;
    assign wrempty = used == 0;
    assign wrusedw = used_q[LPM_WIDTHU-1:0];

    // ---- The reading end ----------------------------------------------------
    wire [31:0] written_seen = written_meta_q[32*STAGES-1 -: 32];
    wire [31:0] there        = (written_seen * PARTS_R - read_q * PARTS) / PARTS;
    wire        read         = rdreq && !rdempty;
    wire [31:0] wanted       = (AHEAD ? read_q + read : read_q) % (WORDS * PARTS_R);
    reg  [31:0] there_q;
    reg  [LPM_WIDTH_R-1:0] q_q;

    always @(posedge rdclk or posedge aclr)
        if (aclr) begin
            read_q <= 0;
            written_meta_q <= 0;
            there_q <= 0;
            q_q <= 0;
        end else begin
            read_q <= read_q + read;
            written_meta_q <= {written_meta_q, written_gray_q};
            there_q <= there;
            if (AHEAD || read)
                q_q <= memory[wanted / PARTS_R][(wanted % PARTS_R) * LPM_WIDTH_R +: LPM_WIDTH_R];
        end

    assign q = q_q;
    assign rdfull = there == WORDS * PARTS_R;
    assign rdempty = there == 0;
    assign rdusedw = there_q[LPM_WIDTHU_R-1:0];
    assign eccstatus = 2'd0;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
