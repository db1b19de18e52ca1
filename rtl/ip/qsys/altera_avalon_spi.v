// altera_avalon_spi.v - Platform Designer's SPI, as master or slave
//
//   0 rxdata       the word that has come
//   1 txdata       write: the word that goes next, if TRDY
//   2 status       ROE 3, TOE 4, TMT 5, TRDY 6, RRDY 7, E 8, EOP 9; any write clears ROE, TOE, RRDY
//                  and EOP
//   3 control      the interrupts of these bits, where they are but TMT; SSO 10: a master's SS_n
//                  stays low between words
//   5 slaveselect  of a master: a 1 for each SS_n that is low, from the next word, or SSO, on
//   6 eop_value    a word that sets EOP as it is read or written
//
// ROE: a word has come over one that nobody had read; TOE: a word was written without TRDY, and is
// lost; E: one of them.  TMT: nothing is on the way; of a slave, nor is it selected.
//
//         __                             __
//   SS_n    |___________________________|          CPOL 0, CPHA 0: MISO is sampled at each edge
//                ___     ___     ___               of SCLK that leads, and MOSI changes at the
//   SCLK  ______|   |___|   |___|   |______        others; with CPHA 1 it is the other way round
//   MOSI    <   7   ><  6  ><  5  >
//
// A half period is HALF clocks, and before the first edge there are LEAD of them.  A slave samples
// its inputs with its own clock; without a new word it sends the one that has come last.
//
// Source: Embedded Peripherals IP User Guide, SPI Core; the Verilog that it generates.

`default_nettype none

module altera_avalon_spi #(
    parameter MASTER = 1,
    parameter BITS   = 8,
    parameter WIDTH  = 16,  // of the registers
    parameter SLAVES = 1,
    parameter CPOL   = 0,
    parameter CPHA   = 0,
    parameter LSB    = 0,   // goes first
    parameter HALF   = 195,
    parameter LEAD   = 1,
    parameter SYNC   = 1    // registers at a slave's inputs
) (
    input  wire              clk,
    input  wire              reset_n,

    input  wire [2:0]        mem_addr,
    input  wire              spi_select,
    input  wire              read_n,
    input  wire              write_n,
    // verilator lint_off UNUSED
    input  wire [WIDTH-1:0]  data_from_cpu,  // no register has all
    // verilator lint_on UNUSED
    output wire [WIDTH-1:0]  data_to_cpu,
    output reg               irq,

    // The upper ones are a master's, the lower a slave's.
    // verilator lint_off UNUSED
    input  wire              miso_i,
    output wire              mosi_o,
    output wire              sclk_o,
    output wire [SLAVES-1:0] ss_no,
    output wire              miso_o,
    input  wire              mosi_i,
    input  wire              sclk_i,
    input  wire              ss_ni
    // verilator lint_on UNUSED
);
    localparam [31:0] NUMBER = BITS;
    localparam [6:0]  EDGES  = {NUMBER[5:0], 1'b0};
    localparam [5:0]  LAST   = NUMBER[5:0] - 6'd1;
    localparam [2:0] RXDATA = 3'd0, TXDATA = 3'd1, STATUS = 3'd2, CONTROL = 3'd3, SELECT = 3'd5,
                     EOP = 3'd6;

    // An access is seen once, in its first clock.
    reg  reads_q, writes_q;
    wire reads  = spi_select && !read_n && !reads_q;
    wire writes = spi_select && !write_n && !writes_q;
    wire puts   = writes && mem_addr == TXDATA;
    wire gets   = reads && mem_addr == RXDATA;
    wire clears = writes && mem_addr == STATUS;
    wire [BITS-1:0] word = data_from_cpu[BITS-1:0];

    always @(posedge clk) {reads_q, writes_q} <= {reads, writes} & {2{reset_n}};

    // ---- Words ------------------------------------------------------------
    reg  [BITS-1:0] waiting_q, tx_q, rx_q, rxdata_q;
    reg             waits_q;
    wire            starts, samples, shifts, ends;  // from master or slave
    wire            bit_in;
    wire [BITS-1:0] shifted;                        // rx_q after another bit
    wire            trdy = !waits_q;

    generate
        if (BITS == 1) begin : one
            assign shifted = bit_in;
        end else if (LSB != 0) begin : lsb
            assign shifted = {bit_in, rx_q[BITS-1:1]};
        end else begin : msb
            assign shifted = {rx_q[BITS-2:0], bit_in};
        end
    endgenerate
    wire [BITS-1:0] got = samples ? shifted : rx_q;
    wire            bit_out = LSB != 0 ? tx_q[0] : tx_q[BITS-1];

    reg  roe_q, toe_q, rrdy_q, eop_q;
    reg  [BITS-1:0] end_q;
    always @(posedge clk) begin
        if (samples) rx_q <= shifted;
        if (shifts) tx_q <= LSB != 0 ? tx_q >> 1 : tx_q << 1;
        if (ends && MASTER == 0) tx_q <= got;
        if (starts) tx_q <= waiting_q;
        if (puts && trdy) waiting_q <= word;
        waits_q <= (puts && trdy) || (waits_q && !starts);
        if (puts && !trdy) toe_q <= 1'b1;
        if ((puts && word == end_q) || (gets && rxdata_q == end_q)) eop_q <= 1'b1;
        if (gets) rrdy_q <= 1'b0;
        if (clears) {roe_q, toe_q, rrdy_q, eop_q} <= 4'd0;
        if (ends) begin
            rxdata_q <= got;
            rrdy_q   <= 1'b1;
            if (rrdy_q && !gets) roe_q <= 1'b1;
        end
        if (!reset_n) begin
            {waits_q, roe_q, toe_q, rrdy_q, eop_q} <= 5'd0;
            {tx_q, rxdata_q} <= {BITS + BITS{1'b0}};
        end
    end

    // ---- Its wires --------------------------------------------------------
    reg  [SLAVES-1:0] wanted_q, select_q;
    reg  [10:0] control_q;
    wire        tmt;
    wire        selects = writes && mem_addr == CONTROL && data_from_cpu[10] && !control_q[10];

    generate
        if (MASTER != 0) begin : master
            reg         busy_q, sclk_q;
            reg  [31:0] clock_q, lead_q;
            reg  [6:0]  edge_q;                          // those that have been
            wire        tick = busy_q && clock_q == HALF - 1;
            wire        edges = tick && lead_q <= 32'd1 && edge_q != EDGES;
            wire        leads = edges && !edge_q[0];
            assign starts  = waits_q && !busy_q;
            assign ends    = tick && edge_q == EDGES;
            assign samples = edges && leads == (CPHA == 0);
            assign shifts  = edges && leads != (CPHA == 0) && edge_q != 7'd0;
            assign bit_in  = miso_i;
            assign tmt     = !busy_q && !waits_q;
            assign mosi_o  = bit_out;
            assign sclk_o  = sclk_q ^ (CPOL != 0);
            assign ss_no   = busy_q || control_q[10] ? ~select_q : {SLAVES{1'b1}};
            assign miso_o  = 1'b0;

            always @(posedge clk) begin
                clock_q <= !busy_q || tick ? 32'd0 : clock_q + 32'd1;
                if (tick && lead_q != 32'd0) lead_q <= lead_q - 32'd1;
                if (edges) begin
                    sclk_q <= !sclk_q;
                    edge_q <= edge_q + 7'd1;
                end
                if (starts || selects) select_q <= wanted_q;
                if (ends) busy_q <= 1'b0;
                if (starts) begin
                    busy_q <= 1'b1;
                    lead_q <= LEAD;
                    edge_q <= 7'd0;
                end
                if (!reset_n) begin
                    {busy_q, sclk_q} <= 2'd0;
                    select_q <= {{SLAVES - 1{1'b0}}, 1'b1};
                end
            end
        end else begin : slave
            reg  [2:0]  wires_q [0:SYNC];                // ss_n, SCLK, MOSI; the latest first
            reg  [5:0]  bit_q;                           // those that have been sampled
            reg         tail_q;                          // CPHA 0: after the last of them
            reg         new_q;                           // tx_q has not been sent
            wire [2:0]  now   = wires_q[SYNC-1];
            wire [2:0]  was   = wires_q[SYNC];
            wire        on    = !now[2];
            wire        rises = on && !was[2] && now[1] != was[1] && now[1] == (CPOL == 0);
            wire        falls = on && !was[2] && now[1] != was[1] && now[1] != (CPOL == 0);
            assign samples = CPHA == 0 ? rises : falls;
            assign shifts  = (CPHA == 0 ? falls : rises) && bit_q != 6'd0;
            assign ends    = samples && bit_q == LAST;
            assign starts  = waits_q && !new_q && (!on || (bit_q == 6'd0 && !tail_q && !samples));
            assign bit_in  = now[0];
            assign tmt     = !on && !waits_q;
            assign miso_o  = bit_out;
            assign {mosi_o, sclk_o, ss_no} = {2'b00, {SLAVES{1'b1}}};

            integer n;
            always @(posedge clk) begin
                wires_q[0] <= {ss_ni, sclk_i, mosi_i};
                for (n = 0; n < SYNC; n = n + 1) wires_q[n+1] <= wires_q[n];
                if (samples) bit_q <= ends ? 6'd0 : bit_q + 6'd1;
                if (CPHA == 0 && ends) tail_q <= 1'b1;
                if (falls) tail_q <= 1'b0;
                if (starts) new_q <= 1'b1;
                else if (ends || !reset_n) new_q <= 1'b0;
                if (!on || !reset_n) {bit_q, tail_q} <= 7'd0;
                select_q <= wanted_q;
            end
        end
    endgenerate

    // ---- Registers --------------------------------------------------------
    wire [9:0] status = {eop_q, roe_q || toe_q, rrdy_q, trdy, tmt, toe_q, roe_q, 3'd0};

    reg  [31:0] data_q, selected, eop_value, rxdata;
    assign data_to_cpu = data_q[WIDTH-1:0];
    always @* begin
        {selected, eop_value, rxdata} = 96'd0;
        selected[SLAVES-1:0] = select_q;
        eop_value[BITS-1:0]  = end_q;
        rxdata[BITS-1:0]     = rxdata_q;
    end

    always @(posedge clk) begin
        irq <= (status & control_q[9:0] & 10'h3D8) != 10'd0;
        if (writes)
            case (mem_addr)
                CONTROL: control_q <= data_from_cpu[10:0] & 11'h7D8;
                SELECT:  wanted_q  <= data_from_cpu[SLAVES-1:0];
                EOP:     end_q     <= word;
                default: ;
            endcase
        case (mem_addr)
            STATUS:  data_q <= {22'd0, status};
            CONTROL: data_q <= {21'd0, control_q};
            SELECT:  data_q <= selected;
            EOP:     data_q <= eop_value;
            default: data_q <= rxdata;
        endcase
        if (!reset_n) begin
            {control_q, irq} <= 12'd0;
            wanted_q <= {{SLAVES - 1{1'b0}}, 1'b1};
            end_q    <= {BITS{1'b0}};
        end
    end
endmodule

`default_nettype wire
