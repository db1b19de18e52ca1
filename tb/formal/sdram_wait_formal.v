// sdram_wait_formal.v - how long the screen waits for the SDRAM while the processor accesses it
// continuously.
//
// By 12-step induction.  The requests are unconstrained, but stable until they are taken.

`default_nettype none

module sdram_wait_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        screen_req_i,
    input wire [23:0] screen_index_i,
    input wire        req_i,
    input wire        we_i,
    input wire [23:0] index_i
);
    // Clocks up to the one in which a request is taken, as in pixel_dma_formal.v: FIRST if the
    // processor's request has begun, NEXT if it comes in the clock after the previous one was
    // taken.
    localparam [3:0]  FIRST = 4'd11, NEXT = 4'd7;
    localparam [12:0] POWER_UP = 13'd5000, INTERVAL = 13'd192;

    reg         live = 1'b0;
    wire        screen_take, take;

    sdram dut (
        .clk_i(clk_i), .rst_i(rst_i),
        .screen_req_i(screen_req_i), .screen_index_i(screen_index_i), .screen_take_o(screen_take),
        .screen_valid_o(), .req_i(req_i), .we_i(we_i), .index_i(index_i), .wdata_i(32'd0),
        .wstrb_i(4'd0), .take_o(take), .valid_o(), .rdata_o(), .dram_cs_no(), .dram_ras_no(),
        .dram_cas_no(), .dram_we_no(), .dram_ba_o(), .dram_addr_o(), .dram_dqm_o(), .dram_dq_o(),
        .dram_dq_oe_o(), .dram_dq_i(16'd0), .awake_o()
    );

    wire [12:0] dut__controller__interval__count_q;
    wire [3:0]  dut__controller__step_q;
    wire        dut__controller__refresh_q;
    wire        set_up = dut__controller__step_q == 4'd10;

    reg         screen_held_q, held_q, held_we_q, next_q;
    reg  [23:0] screen_held_index_q, held_index_q;
    reg  [3:0]  wait_q;                  // clocks since the screen's request
    reg  [12:0] phase_q;                 // clocks to the next refresh
    reg         begun_q;                 // one has been due

    always @(posedge clk_i) begin
        live    <= 1'b1;
        screen_held_q       <= screen_req_i && !screen_take && !rst_i;
        screen_held_index_q <= screen_index_i;
        held_q       <= req_i && !take && !rst_i;
        held_we_q    <= we_i;
        held_index_q <= index_i;
        next_q       <= screen_req_i && (screen_take || next_q) && !rst_i;
        wait_q       <= screen_req_i && !screen_take && !rst_i ? wait_q + 4'd1 : 4'd0;
        phase_q      <= rst_i ? POWER_UP : phase_q == 13'd0 ? INTERVAL - 13'd1 : phase_q - 13'd1;
        begun_q      <= (begun_q || phase_q == 13'd0) && !rst_i;
    end
    always @(*) begin
        if (!live) assume (rst_i);
        assume (!screen_held_q || (screen_req_i && screen_index_i == screen_held_index_q));
        assume (!held_q || (req_i && we_i == held_we_q && index_i == held_index_q));
        // The screen's first comes 30,000 clocks after a reset.
        assume (set_up || !screen_req_i);
    end

    always @(*) if (live) begin
        a_screen_waits: assert (wait_q < (next_q ? NEXT : FIRST));
    end

    // ---- Invariants: a refresh is done before the next is due ----
    wire [12:0] late = INTERVAL - 13'd1 - phase_q;
    always @(*) if (live) begin
        i_due:   assert (dut__controller__interval__count_q == phase_q);
        i_phase: assert (phase_q <= (begun_q ? INTERVAL - 13'd1 : POWER_UP));
        i_steps: assert (dut__controller__step_q <= 4'd10);
        i_begins: assert (begun_q || (!dut__controller__refresh_q
                                      && dut__controller__step_q == 4'd0));
        i_init:  assert (!begun_q || set_up || (dut__controller__refresh_q && late
                         <= {8'd0, dut__controller__step_q, 1'b0} + 13'd1));
        i_late:  assert (!set_up || !dut__controller__refresh_q || late < 13'd8);
    end
endmodule

`default_nettype wire
