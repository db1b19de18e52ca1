// altera_modular_adc.v - Platform Designer's Modular ADC core: the converter of a MAX 10 with its
// control, and where it is wanted, a sequencer and a store of samples
//
//   sequencer --command--> control --response--> sample store
//                             |
//                      fiftyfivenm_adcblock, a conversion in each us
//
// Control: a command is taken (ready, for a clock) where a conversion ends; its response comes at
// the end of the next one.
// Sequencer, register 0: bit 0 runs; bits 3:1 0 = again and again, 1 = once, then bit 0 is 0.  A
// run that is cleared ends with its last slot.
// Sample store: 0 to 63 the slots' samples; 64 bit 0 enables the interrupt, at first 1; 65 bit 0
// says that a sequence has ended, writing 1 clears it.
//
// Source: MAX 10 Analog to Digital Converter User Guide, "Modular ADC Core"; the Verilog that
// Platform Designer generates for it.
//
// Not handled: recalibration; threshold violations; averages of the temperature; the first
// conversions after a reset, which the core spends on switching on.

`default_nettype none

module altera_modular_adc #(
    parameter CLKDIV = 2,
    parameter FIRST = 1,              // which of two converters
    parameter SEQUENCED = 1,          // 0 = commands come from outside
    parameter STORED = 1,             // 0 = responses go outside
    parameter [5:0] LAST_SLOT = 6'd0,
    parameter [319:0] SLOTS = 320'd0  // 5 bits each: the channel
) (
    input  wire        clock_clk,
    input  wire        reset_sink_reset_n,
    input  wire        adc_pll_clock_clk,
    input  wire        adc_pll_locked_export,

    input  wire        command_valid,
    input  wire [4:0]  command_channel,
    input  wire        command_startofpacket,
    input  wire        command_endofpacket,
    output wire        command_ready,

    output reg         response_valid,
    output reg  [4:0]  response_channel,
    output reg  [11:0] response_data,
    output reg         response_startofpacket,
    output reg         response_endofpacket,

    input  wire        sequencer_csr_address,
    input  wire        sequencer_csr_read,
    input  wire        sequencer_csr_write,
    // verilator lint_off UNUSED
    input  wire [31:0] sequencer_csr_writedata,
    // verilator lint_on UNUSED
    output reg  [31:0] sequencer_csr_readdata,

    input  wire [6:0]  sample_store_csr_address,
    input  wire        sample_store_csr_read,
    input  wire        sample_store_csr_write,
    // verilator lint_off UNUSED
    input  wire [31:0] sample_store_csr_writedata,
    // verilator lint_on UNUSED
    output reg  [31:0] sample_store_csr_readdata,
    output reg         sample_store_irq_irq
);
    wire clk = clock_clk, rst_n = reset_sink_reset_n;

    // ---- The sequencer ----------------------------------------------------
    reg        run_q, ends_q;  // ends_q: with the last slot
    reg  [2:0] mode_q;
    reg  [5:0] slot_q;
    wire       is_last = slot_q == LAST_SLOT;
    wire       asks    = SEQUENCED != 0 ? run_q : command_valid;
    wire [4:0] channel = SEQUENCED != 0 ? SLOTS[5 * slot_q +: 5] : command_channel;
    wire       first   = SEQUENCED != 0 ? slot_q == 6'd0 : command_startofpacket;
    wire       last    = SEQUENCED != 0 ? is_last : command_endofpacket;
    wire       take;
    wire       csr_we  = sequencer_csr_write && !sequencer_csr_address;

    assign command_ready = take;

    always @(posedge clk or negedge rst_n) begin
        if (!rst_n) begin
            {run_q, ends_q, mode_q, slot_q} <= 11'd0;
            sequencer_csr_readdata          <= 32'd0;
        end else begin
            if (csr_we && !run_q) mode_q <= sequencer_csr_writedata[3:1];
            if (csr_we && sequencer_csr_writedata[0]) run_q <= 1'b1;
            if (csr_we && !sequencer_csr_writedata[0] && run_q) ends_q <= 1'b1;
            if (take && SEQUENCED != 0) begin
                slot_q <= is_last ? 6'd0 : slot_q + 6'd1;
                if (is_last && (ends_q || mode_q != 3'd0)) {run_q, ends_q} <= 2'd0;
            end
            sequencer_csr_readdata <= sequencer_csr_read && !sequencer_csr_address
                                      ? {28'd0, mode_q, run_q} : 32'd0;
        end
    end

    // ---- The control ------------------------------------------------------
    // The converter's wires by channel, from 0; 17 is the temperature.
    function [4:0] wire_of;
        input [4:0] number;
        case (number)
            5'd0:    wire_of = 5'd3;
            5'd1:    wire_of = 5'd4;
            5'd2:    wire_of = 5'd6;
            5'd3:    wire_of = 5'd10;
            5'd4:    wire_of = 5'd12;
            5'd5:    wire_of = 5'd16;
            5'd6:    wire_of = 5'd14;
            5'd7:    wire_of = 5'd13;
            5'd8:    wire_of = 5'd2;
            5'd17:   wire_of = 5'd0;
            default: wire_of = 5'd31;
        endcase
    endfunction

    reg  [4:0]  channel_q;
    reg         first_q, last_q, busy_q;
    reg         eoc_meta_q, eoc_q, eoc_before_q;
    wire        eoc;
    wire [11:0] data;
    wire        ended = eoc_before_q && !eoc_q;

    assign take = ended && asks;

    // verilator lint_off PINCONNECTEMPTY
    fiftyfivenm_adcblock #(.clkdiv(CLKDIV), .is_this_first_or_second_adc(FIRST)) block (
        .clkin_from_pll_c0(adc_pll_clock_clk), .soc(adc_pll_locked_export), .usr_pwd(1'b0),
        .tsen(channel_q == 5'd17), .chsel(wire_of(channel_q)), .clk_dft(), .eoc(eoc), .dout(data)
    );
    // verilator lint_on PINCONNECTEMPTY

    always @(posedge clk or negedge rst_n) begin
        if (!rst_n) begin
            {eoc_meta_q, eoc_q, eoc_before_q, busy_q} <= 4'd0;
            {channel_q, first_q, last_q}              <= 7'd0;
            {response_valid, response_channel, response_data} <= 18'd0;
            {response_startofpacket, response_endofpacket}    <= 2'd0;
        end else begin
            {eoc_before_q, eoc_q, eoc_meta_q} <= {eoc_q, eoc_meta_q, eoc};
            response_valid <= ended && busy_q;
            if (ended) begin
                response_channel       <= channel_q;
                response_data          <= data;
                response_startofpacket <= first_q;
                response_endofpacket   <= last_q;
                busy_q                 <= asks;
                if (asks) {channel_q, first_q, last_q} <= {channel, first, last};
            end
        end
    end

    // ---- The store --------------------------------------------------------
    reg  [11:0] samples_q [0:63];
    reg  [11:0] sample_q;
    reg  [31:0] register_q;
    reg  [5:0]  stored_q;
    reg         enable_q, ended_q, was_sample_q;
    wire        ends     = response_valid && response_endofpacket;
    wire        store_we = sample_store_csr_write;

    always @(posedge clk) begin
        if (response_valid && STORED != 0) samples_q[stored_q] <= response_data;
        if (sample_store_csr_read) sample_q <= samples_q[sample_store_csr_address[5:0]];
    end

    always @(posedge clk or negedge rst_n) begin
        if (!rst_n) begin
            {stored_q, ended_q, was_sample_q, sample_store_irq_irq} <= 9'd0;
            {register_q, sample_store_csr_readdata}                 <= 64'd0;
            enable_q <= 1'b1;
        end else begin
            if (response_valid) stored_q <= ends ? 6'd0 : stored_q + 6'd1;
            if (store_we && sample_store_csr_address == 7'h40)
                enable_q <= sample_store_csr_writedata[0];
            if (ends)
                ended_q <= 1'b1;
            else if (store_we && sample_store_csr_address == 7'h41 && sample_store_csr_writedata[0])
                ended_q <= 1'b0;
            register_q <= !sample_store_csr_read             ? 32'd0
                          : sample_store_csr_address == 7'h40 ? {31'd0, enable_q}
                          : sample_store_csr_address == 7'h41 ? {31'd0, ended_q} : 32'd0;
            was_sample_q              <= sample_store_csr_read && !sample_store_csr_address[6];
            sample_store_csr_readdata <= was_sample_q ? {20'd0, sample_q} : register_q;
            sample_store_irq_irq      <= enable_q && ended_q && STORED != 0;
        end
    end
endmodule

`default_nettype wire
