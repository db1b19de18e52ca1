// altsyncram.v - Intel's RAM and ROM of M10K blocks: one port, or two with any clocks and widths
//
// Every parameter is there in both cases, and the upper one is used: it follows the lower one.
//
// A port takes address, data, wren, rden and byteena at its clock's edge; q shows the word after
// that edge, or with an output register after the next.  Without rden q stays.  The narrow words
// of a wide one begin at its lowest bits.
//
// Read during write: at the same port the new data, or with OLD_DATA the old; of the other port
// the old data.  Where Intel says "don't care" or "unknown", it is what a masked byte or the
// other port would read: the old data.
//
// Not handled: clears of the inputs (Cyclone V has none), ECC, NEW_DATA of the other port (MLAB).

`default_nettype none
// Strings of different lengths are compared, and parameters with numbers.
// verilator lint_off WIDTH

module altsyncram #(
    parameter operation_mode = "BIDIR_DUAL_PORT", OPERATION_MODE = operation_mode,
    parameter width_a = 1, WIDTH_A = width_a,
    parameter widthad_a = 1, WIDTHAD_A = widthad_a,
    parameter numwords_a = 0, NUMWORDS_A = numwords_a,
    parameter width_byteena_a = 1, WIDTH_BYTEENA_A = width_byteena_a,
    parameter outdata_reg_a = "UNREGISTERED", OUTDATA_REG_A = outdata_reg_a,
    parameter outdata_aclr_a = "NONE", OUTDATA_ACLR_A = outdata_aclr_a,
    parameter clock_enable_input_a = "NORMAL", CLOCK_ENABLE_INPUT_A = clock_enable_input_a,
    parameter clock_enable_output_a = "NORMAL", CLOCK_ENABLE_OUTPUT_A = clock_enable_output_a,
    parameter read_during_write_mode_port_a = "NEW_DATA_NO_NBE_READ",
    parameter READ_DURING_WRITE_MODE_PORT_A = read_during_write_mode_port_a,
    parameter width_b = 1, WIDTH_B = width_b,
    parameter widthad_b = 1, WIDTHAD_B = widthad_b,
    parameter numwords_b = 0, NUMWORDS_B = numwords_b,
    parameter width_byteena_b = 1, WIDTH_BYTEENA_B = width_byteena_b,
    parameter address_reg_b = "CLOCK1", ADDRESS_REG_B = address_reg_b,
    parameter address_reg_a = "CLOCK0", ADDRESS_REG_A = address_reg_a,  // without meaning
    parameter outdata_reg_b = "UNREGISTERED", OUTDATA_REG_B = outdata_reg_b,
    parameter outdata_aclr_b = "NONE", OUTDATA_ACLR_B = outdata_aclr_b,
    parameter clock_enable_input_b = "NORMAL", CLOCK_ENABLE_INPUT_B = clock_enable_input_b,
    parameter clock_enable_output_b = "NORMAL", CLOCK_ENABLE_OUTPUT_B = clock_enable_output_b,
    parameter read_during_write_mode_port_b = "NEW_DATA_NO_NBE_READ",
    parameter READ_DURING_WRITE_MODE_PORT_B = read_during_write_mode_port_b,
    parameter init_file = "UNUSED", INIT_FILE = init_file,
    parameter init_file_layout = "UNUSED", INIT_FILE_LAYOUT = init_file_layout,
    parameter width_eccstatus = 3, WIDTH_ECCSTATUS = width_eccstatus,
    // Without meaning here: how it is built, and clocks that are those of the address anyway.
    parameter address_aclr_a = "NONE", ADDRESS_ACLR_A = address_aclr_a,
    parameter address_aclr_b = "NONE", ADDRESS_ACLR_B = address_aclr_b,
    parameter byte_size = 8, BYTE_SIZE = byte_size,
    parameter byteena_aclr_a = "NONE", BYTEENA_ACLR_A = byteena_aclr_a,
    parameter byteena_aclr_b = "NONE", BYTEENA_ACLR_B = byteena_aclr_b,
    parameter byteena_reg_b = "CLOCK1", BYTEENA_REG_B = byteena_reg_b,
    parameter clock_enable_core_a = "USE_INPUT_CLKEN", CLOCK_ENABLE_CORE_A = clock_enable_core_a,
    parameter clock_enable_core_b = "USE_INPUT_CLKEN", CLOCK_ENABLE_CORE_B = clock_enable_core_b,
    parameter ecc_pipeline_stage_enabled = "FALSE",
    parameter ECC_PIPELINE_STAGE_ENABLED = ecc_pipeline_stage_enabled,
    parameter enable_ecc = "FALSE", ENABLE_ECC = enable_ecc,
    parameter enable_runtime_mod = "NO", ENABLE_RUNTIME_MOD = enable_runtime_mod,
    parameter implement_in_les = "OFF", IMPLEMENT_IN_LES = implement_in_les,
    parameter indata_aclr_a = "NONE", INDATA_ACLR_A = indata_aclr_a,
    parameter indata_aclr_b = "NONE", INDATA_ACLR_B = indata_aclr_b,
    parameter indata_reg_b = "CLOCK1", INDATA_REG_B = indata_reg_b,
    parameter instance_name = "UNUSED", INSTANCE_NAME = instance_name,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altsyncram", LPM_TYPE = lpm_type,
    parameter maximum_depth = 0, MAXIMUM_DEPTH = maximum_depth,
    parameter power_up_uninitialized = "FALSE", POWER_UP_UNINITIALIZED = power_up_uninitialized,
    parameter ram_block_type = "AUTO", RAM_BLOCK_TYPE = ram_block_type,
    parameter rdcontrol_aclr_b = "NONE", RDCONTROL_ACLR_B = rdcontrol_aclr_b,
    parameter rdcontrol_reg_b = "CLOCK1", RDCONTROL_REG_B = rdcontrol_reg_b,
    parameter read_during_write_mode_mixed_ports = "DONT_CARE",
    parameter READ_DURING_WRITE_MODE_MIXED_PORTS = read_during_write_mode_mixed_ports,
    parameter sim_show_memory_data_in_port_b_layout = "OFF",
    parameter SIM_SHOW_MEMORY_DATA_IN_PORT_B_LAYOUT = sim_show_memory_data_in_port_b_layout,
    parameter stratixiv_m144k_allow_dual_clocks = "ON",
    parameter STRATIXIV_M144K_ALLOW_DUAL_CLOCKS = stratixiv_m144k_allow_dual_clocks,
    parameter wrcontrol_aclr_a = "NONE", WRCONTROL_ACLR_A = wrcontrol_aclr_a,
    parameter wrcontrol_aclr_b = "NONE", WRCONTROL_ACLR_B = wrcontrol_aclr_b,
    parameter wrcontrol_wraddress_reg_b = "CLOCK1",
    parameter WRCONTROL_WRADDRESS_REG_B = wrcontrol_wraddress_reg_b
) (
    input  wire                       clock0, clock1,
    input  wire                       clocken0, clocken1, clocken2, clocken3,
    input  wire                       aclr0, aclr1,

    input  wire [WIDTHAD_A-1:0]       address_a,
    input  wire                       addressstall_a,
    input  wire                       wren_a, rden_a,
    input  wire [WIDTH_BYTEENA_A-1:0] byteena_a,
    input  wire [WIDTH_A-1:0]         data_a,
    output wire [WIDTH_A-1:0]         q_a,

    input  wire [WIDTHAD_B-1:0]       address_b,
    input  wire                       addressstall_b,
    input  wire                       wren_b, rden_b,
    input  wire [WIDTH_BYTEENA_B-1:0] byteena_b,
    input  wire [WIDTH_B-1:0]         data_b,
    output wire [WIDTH_B-1:0]         q_b,

    output wire [WIDTH_ECCSTATUS-1:0] eccstatus
);
    `include "de1sim_init.vh"

    // ---- The memory, of words as wide as the wider port's -------------------
    localparam DUAL    = OPERATION_MODE == "DUAL_PORT" || OPERATION_MODE == "BIDIR_DUAL_PORT";
    localparam BIDIR   = OPERATION_MODE == "BIDIR_DUAL_PORT";
    localparam WIDTH   = DUAL && WIDTH_B > WIDTH_A ? WIDTH_B : WIDTH_A;
    localparam PARTS_A = WIDTH / WIDTH_A;
    localparam PARTS_B = DUAL ? WIDTH / WIDTH_B : 1;
    localparam WORDS_A = NUMWORDS_A ? NUMWORDS_A : 1 << WIDTHAD_A;
    localparam WORDS_B = NUMWORDS_B ? NUMWORDS_B : 1 << WIDTHAD_B;
    localparam WORDS   = (WORDS_A + PARTS_A - 1) / PARTS_A;

    // Two ports with clocks of their own write it.
    // verilator lint_off MULTIDRIVEN
    reg [WIDTH-1:0] memory [0:WORDS-1];
    // verilator lint_on MULTIDRIVEN

    // The file has words of port A's width, unless it says otherwise.
    localparam FILE_B     = DUAL && (INIT_FILE_LAYOUT == "PORT_B"
                                     || INIT_FILE_LAYOUT != "PORT_A" && !BIDIR);
    localparam FILE_WIDTH = FILE_B ? WIDTH_B : WIDTH_A;
    localparam FILE_PARTS = WIDTH / FILE_WIDTH;
    localparam FILE_WORDS = FILE_B ? WORDS_B : WORDS_A;
    localparam INTS       = (FILE_WIDTH + 31) / 32;

    reg [32*INTS-1:0] word;
    integer at, part;
    initial if (de1sim_init_file(INIT_FILE, $sformatf("%m"), FILE_WIDTH, FILE_WORDS) != 0)
        for (at = 0; at < FILE_WORDS; at = at + 1) begin
            for (part = 0; part < INTS; part = part + 1)
                word[32*part +: 32] = de1sim_init_part(at, part);
            memory[at / FILE_PARTS][(at % FILE_PARTS) * FILE_WIDTH +: FILE_WIDTH] =
                word[FILE_WIDTH-1:0];
        end

    assign eccstatus = {WIDTH_ECCSTATUS{1'b0}};

    // ---- The ports ----------------------------------------------------------
    wire                 strobe_a, strobe_b;
    wire [WIDTHAD_A-1:0] at_a;
    wire [WIDTHAD_B-1:0] at_b;
    wire [WIDTH_A-1:0]   new_a;
    wire [WIDTH_B-1:0]   new_b;
    wire [WIDTH_A-1:0]   old_a = memory[at_a / PARTS_A][(at_a % PARTS_A) * WIDTH_A +: WIDTH_A];

    de1sim_ram_port #(
        .WIDTH(WIDTH_A), .WIDTHAD(WIDTHAD_A), .BYTES(WIDTH_BYTEENA_A), .ADDRESS_REG("CLOCK0"),
        .OUTDATA_REG(OUTDATA_REG_A), .OUTDATA_ACLR(OUTDATA_ACLR_A), .ENABLE(CLOCK_ENABLE_INPUT_A),
        .ENABLE_OUTPUT(CLOCK_ENABLE_OUTPUT_A), .MODE(READ_DURING_WRITE_MODE_PORT_A)
    ) port_a (
        .clock_i({clock1, clock0}), .clocken_i({clocken3, clocken2, clocken1, clocken0}),
        .aclr_i({aclr1, aclr0}), .address_i(address_a), .stall_i(addressstall_a),
        .wren_i(wren_a && OPERATION_MODE != "ROM"),
        .rden_i(rden_a && OPERATION_MODE != "DUAL_PORT"),
        .byteena_i(byteena_a), .data_i(data_a), .q_o(q_a),
        .at_o(at_a), .old_i(old_a), .strobe_o(strobe_a), .new_o(new_a)
    );
    always @(posedge clock0) if (strobe_a)
        memory[at_a / PARTS_A][(at_a % PARTS_A) * WIDTH_A +: WIDTH_A] <= new_a;

    generate
        if (DUAL) begin : two
            wire [WIDTH_B-1:0] old_b =
                memory[at_b / PARTS_B][(at_b % PARTS_B) * WIDTH_B +: WIDTH_B];
            wire clock_b = ADDRESS_REG_B == "CLOCK0" ? clock0 : clock1;

            de1sim_ram_port #(
                .WIDTH(WIDTH_B), .WIDTHAD(WIDTHAD_B), .BYTES(WIDTH_BYTEENA_B),
                .ADDRESS_REG(ADDRESS_REG_B), .OUTDATA_REG(OUTDATA_REG_B),
                .OUTDATA_ACLR(OUTDATA_ACLR_B), .ENABLE(CLOCK_ENABLE_INPUT_B),
                .ENABLE_OUTPUT(CLOCK_ENABLE_OUTPUT_B), .MODE(READ_DURING_WRITE_MODE_PORT_B)
            ) port_b (
                .clock_i({clock1, clock0}), .clocken_i({clocken3, clocken2, clocken1, clocken0}),
                .aclr_i({aclr1, aclr0}), .address_i(address_b), .stall_i(addressstall_b),
                .wren_i(wren_b && BIDIR), .rden_i(rden_b), .byteena_i(byteena_b), .data_i(data_b),
                .q_o(q_b), .at_o(at_b), .old_i(old_b), .strobe_o(strobe_b), .new_o(new_b)
            );
            always @(posedge clock_b) if (strobe_b)
                memory[at_b / PARTS_B][(at_b % PARTS_B) * WIDTH_B +: WIDTH_B] <= new_b;
        end else begin : one
            assign q_b = {WIDTH_B{1'b0}};
        end
    endgenerate
// verilator lint_on WIDTH
endmodule

`default_nettype wire
