// de1sim_i2c_master.v - an I2C master's bits: START, bytes with their acknowledge, STOP
//
//   cmd_i   9 STA, 8 STO, 7..0 the byte; the first after a START is the address with R/W
//
//               ___     ___     ___           ___      SDA changes hold_i clocks after SCL has
//   SCL  ______|   |___|   |___|   |_ ... ___|         fallen, and is sampled as SCL rises, which
//        ~~|___ADR6____ADR5____ADR4__ ... ______|~~    a device can delay
//
// A byte that is read goes out before its acknowledge, which waits for the command after it: there
// is none before a STOP or another START.  Without a command SCL stays low.  A device that does not
// acknowledge gets a STOP; who loses the bus to another master lets go of it at once.

`default_nettype none

module de1sim_i2c_master (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        enable_i,
    input  wire [15:0] low_i, high_i, hold_i,  // clocks
    input  wire [9:0]  cmd_i,
    input  wire        cmd_valid_i,
    output wire        cmd_taken_o,
    input  wire        stands_i,               // no START meanwhile

    output wire        busy_o,
    output wire        byte_valid_o,
    output wire [7:0]  byte_o,
    output wire        nack_o,
    output wire        lost_o,

    input  wire        scl_i, sda_i,
    output wire        scl_low_o, sda_low_o
);
    localparam [3:0] OFF = 4'd0, READY = 4'd1, START = 4'd2, LOW = 4'd3, RISE = 4'd4, HIGH = 4'd5,
                     HOLD = 4'd6, FREE = 4'd7, DONE = 4'd8;
    localparam [1:0] DATA = 2'd0, RESTART = 2'd1, STOP = 2'd2;
    localparam [3:0] ACK = 4'd8;

    // ---- The wires --------------------------------------------------------
    reg [1:0] scl_q, sda_q;
    reg       sda_before_q, scl_before_q, used_q;
    wire      scl = scl_q[1], sda = sda_q[1];

    always @(posedge clk_i) begin
        scl_q <= {scl_q[0], scl_i};
        sda_q <= {sda_q[0], sda_i};
        {scl_before_q, sda_before_q} <= {scl, sda};
        if (scl && scl_before_q && sda_before_q != sda) used_q <= !sda;  // START, STOP
        if (rst_i) begin
            {scl_q, sda_q} <= 4'b1111;
            {scl_before_q, sda_before_q, used_q} <= 3'b110;
        end
    end

    // ---- Bits -------------------------------------------------------------
    reg  [3:0]  state_q, bit_q;
    reg  [1:0]  slot_q;
    reg  [15:0] count_q;
    reg  [7:0]  shift_q;
    reg         enable_q, address_q, read_q, stop_q, loaded_q, ack_q, low_q;

    wire        gets   = read_q && !address_q;  // this byte comes from the device
    wire [15:0] last   = low_i == 16'd0 ? 16'd0 : low_i - 16'd1;
    wire [15:0] hold   = hold_i < last ? hold_i : last;
    wire        low_ends  = state_q == LOW && count_q >= last;
    wire        high_ends = state_q == HIGH && (count_q + 16'd1 >= high_i || !scl);
    wire        wants  = slot_q == STOP ? 1'b1
                       : slot_q == RESTART ? 1'b0
                       : bit_q == ACK ? gets && ack_q : !gets && !shift_q[7];
    wire        sample = state_q == RISE && scl;
    wire        drives = bit_q == ACK ? gets : !gets;
    wire        loses  = sample && slot_q == DATA && drives && !low_q && !sda;

    // After the acknowledge, or where nothing was there: the next command.
    wire        byte_ends = high_ends && slot_q == DATA && bit_q == ACK;
    wire        stops  = stop_q && !address_q;
    wire        refused = byte_ends && !gets && !ack_q;
    wire        waits  = (byte_ends && !refused && !stops) || (state_q == HOLD && bit_q == ACK);
    wire        starts = state_q == START && count_q + 16'd1 >= high_i;
    assign cmd_taken_o  = (waits && cmd_valid_i) || (starts && !loaded_q);
    assign byte_valid_o = high_ends && slot_q == DATA && gets && bit_q == 4'd7;
    assign byte_o       = shift_q;
    assign nack_o       = refused;
    assign lost_o       = loses;
    assign busy_o       = state_q != OFF && state_q != DONE;
    assign scl_low_o    = state_q == LOW || state_q == HOLD;
    assign sda_low_o    = low_q;

    always @(posedge clk_i) begin
        enable_q <= enable_i;
        count_q  <= count_q + 16'd1;
        case (state_q)
            OFF:   if (enable_i && !enable_q) state_q <= READY;
            READY: if (!stands_i && cmd_valid_i && !used_q && scl && sda) begin
                state_q  <= START;
                count_q  <= 16'd0;
                loaded_q <= 1'b0;
                low_q    <= 1'b1;
            end
            START: if (starts) begin
                state_q   <= LOW;
                count_q   <= 16'd0;
                slot_q    <= DATA;
                bit_q     <= 4'd0;
                address_q <= 1'b1;
                if (!loaded_q) shift_q <= cmd_i[7:0];
                read_q    <= loaded_q ? shift_q[0] : cmd_i[0];
            end
            LOW: begin
                if (count_q >= hold) low_q <= wants;
                if (low_ends) state_q <= RISE;
            end
            RISE: if (scl) begin
                state_q <= HIGH;
                count_q <= 16'd0;
                if (slot_q == DATA && bit_q != ACK) shift_q <= {shift_q[6:0], sda};
                if (slot_q == DATA && bit_q == ACK && !gets) ack_q <= !sda;
                if (loses) begin
                    state_q <= DONE;
                    low_q   <= 1'b0;
                end
            end
            HIGH: if (high_ends) begin
                state_q <= LOW;
                count_q <= 16'd0;
                if (slot_q == RESTART) begin
                    state_q  <= START;
                    loaded_q <= 1'b1;
                    low_q    <= 1'b1;
                end else if (slot_q == STOP) begin
                    state_q <= FREE;
                    low_q   <= 1'b0;
                end else if (bit_q == ACK) begin
                    address_q <= 1'b0;
                    if (refused || stops) slot_q <= STOP;
                    else if (!cmd_valid_i) state_q <= HOLD;
                end else begin
                    bit_q <= bit_q + 4'd1;
                    if (bit_q == 4'd7 && gets) begin
                        ack_q <= !stop_q && cmd_valid_i && !cmd_i[9];
                        if (!stop_q && !cmd_valid_i) begin
                            state_q <= HOLD;
                            bit_q   <= 4'd7;
                        end
                    end
                end
            end
            HOLD: if (cmd_valid_i) begin
                state_q <= LOW;
                count_q <= 16'd0;
                if (bit_q != ACK) begin
                    bit_q <= ACK;
                    ack_q <= !cmd_i[9];
                end
            end
            FREE: if (count_q >= last) state_q <= cmd_valid_i && !stands_i ? READY : DONE;
            DONE: if (cmd_valid_i && !stands_i) state_q <= READY;
                  else if (!enable_i) state_q <= OFF;
            default: state_q <= OFF;
        endcase
        if (waits && cmd_valid_i) begin
            shift_q   <= cmd_i[7:0];
            stop_q    <= cmd_i[8];
            address_q <= 1'b0;
            slot_q    <= cmd_i[9] ? RESTART : DATA;
            bit_q     <= 4'd0;
        end
        if (rst_i) begin
            {state_q, slot_q, bit_q} <= 10'd0;
            {enable_q, address_q, read_q, stop_q, loaded_q, ack_q, low_q} <= 7'd0;
        end
    end
endmodule

`default_nettype wire
