// altera_avalon_pio.v - Platform Designer's PIO: a parallel port of 1 to 32 bits
//
//   0 data            read: the inputs, or the output register where there are none
//   1 direction       1 = output; bidirectional ports alone
//   2 interruptmask   where generateIRQ
//   3 edgecapture     where captureEdge; any write clears all bits, with bitClearingEdgeCapReg a 1
//                     clears its own
//   4 outset, 5 outclear    where bitModifyingOutReg: the 1s set and clear bits of the output
//
// Inputs are sampled once for data and twice more for edges, so an edge is in edgecapture three
// clocks after it is at the pin.
//
// Source: Embedded Peripherals IP User Guide, PIO Core.

`default_nettype none
// Strings of different lengths are compared; a port narrower than 32 bits is extended.
// verilator lint_off WIDTH

module altera_avalon_pio #(
    parameter        width                 = 8,
    parameter [31:0] resetValue            = 32'd0,
    parameter        captureEdge           = 0,
    parameter        edgeType              = "RISING",  // FALLING, ANY
    parameter        generateIRQ           = 0,
    parameter        irqType               = "LEVEL",   // EDGE
    parameter        bitClearingEdgeCapReg = 0,
    parameter        bitModifyingOutReg    = 0,
    parameter        has_input             = 1,
    parameter        has_output            = 1,
    parameter        is_bidir              = 0
) (
    input  wire             clk,
    input  wire             reset_n,

    input  wire [2:0]       address,
    input  wire             chipselect,
    input  wire             write_n,
    // verilator lint_off UNUSED
    input  wire [31:0]      writedata,  // a narrow port does not use all of it
    // verilator lint_on UNUSED
    output reg  [31:0]      readdata,
    output wire             irq,

    input  wire [width-1:0] in_port,
    output wire [width-1:0] out_port,
    inout  wire [width-1:0] bidir_port
);
    localparam [2:0] DATA = 3'd0, DIRECTION = 3'd1, MASK = 3'd2, EDGES = 3'd3, SET = 3'd4,
                     CLEAR = 3'd5;

    wire             write  = chipselect && !write_n;
    wire [width-1:0] wdata  = writedata[width-1:0];
    wire [2:0]       number = bitModifyingOutReg != 0 ? address : {1'b0, address[1:0]};
    wire [width-1:0] data   = is_bidir != 0 ? bidir_port : in_port;

    // ---- Output -----------------------------------------------------------
    reg [width-1:0] out_q, direction_q;
    assign out_port = out_q;

    genvar n;
    generate
        if (is_bidir != 0) begin : pins
            for (n = 0; n < width; n = n + 1) begin : pin
                assign bidir_port[n] = direction_q[n] ? out_q[n] : 1'bz;
            end
        end
    endgenerate

    always @(posedge clk)
        if (!reset_n) begin
            out_q       <= resetValue[width-1:0];
            direction_q <= {width{1'b0}};
        end else if (write) begin
            case (number)
                DATA:      out_q <= wdata;
                SET:       out_q <= out_q | wdata;
                CLEAR:     out_q <= out_q & ~wdata;
                DIRECTION: direction_q <= wdata;
                default:   ;
            endcase
        end

    // ---- Edges and interrupts ---------------------------------------------
    reg  [width-1:0] first_q, second_q, edges_q, mask_q;
    wire [width-1:0] edges = edgeType == "FALLING" ? ~first_q & second_q
                           : edgeType == "ANY"     ? first_q ^ second_q
                                                   : first_q & ~second_q;
    wire [width-1:0] clears = !(write && number == EDGES) ? {width{1'b0}}
                            : bitClearingEdgeCapReg != 0 ? wdata : {width{1'b1}};

    wire [width-1:0] asks = (irqType == "EDGE" ? edges_q : data) & mask_q;
    assign irq = generateIRQ != 0 && asks != {width{1'b0}};

    always @(posedge clk)
        if (!reset_n) begin
            first_q  <= {width{1'b0}};
            second_q <= {width{1'b0}};
            edges_q  <= {width{1'b0}};
            mask_q   <= {width{1'b0}};
        end else begin
            first_q  <= data;
            second_q <= first_q;
            edges_q  <= captureEdge != 0 ? (edges_q | edges) & ~clears : {width{1'b0}};
            if (write && number == MASK && generateIRQ != 0) mask_q <= wdata;
        end

    // ---- Reads ------------------------------------------------------------
    always @(posedge clk)
        if (!reset_n)
            readdata <= 32'd0;
        else
            case (number)
                DATA:      readdata <= has_input != 0 ? data : has_output != 0 ? out_q : 32'd0;
                DIRECTION: readdata <= is_bidir != 0 ? direction_q : 32'd0;
                MASK:      readdata <= mask_q;
                EDGES:     readdata <= edges_q;
                default:   readdata <= 32'd0;
            endcase
// verilator lint_on WIDTH
endmodule

`default_nettype wire
