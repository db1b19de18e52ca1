// jtag_terminals.v - the host's side of the JTAG UARTs: Quartus' bridge to the chip's JTAG pins
//
// Bit or byte n belongs to number n, which nios2-terminal calls instance n.  Signals are those of
// jtag_uart.v, seen from the host.

`default_nettype none

module jtag_terminals (
    input  wire        clk_i,
    input  wire        rst_i,
    output wire [1:0]  take_o,
    input  wire [1:0]  sent_i,
    input  wire [15:0] sent_data_i,
    input  wire [1:0]  room_i,
    output wire [1:0]  typed_o,
    output wire [15:0] typed_data_o,
    output wire [1:0]  idle_o
);
    genvar n;
    generate for (n = 0; n < 2; n = n + 1) begin : terminal
        alt_jtag_atlantic #(
            .INSTANCE_ID             (n),
            .LOG2_RXFIFO_DEPTH       (6),
            .LOG2_TXFIFO_DEPTH       (6),
            .SLD_AUTO_INSTANCE_INDEX ("YES")
        ) atlantic (
            .clk     (clk_i),
            .rst_n   (!rst_i),
            .r_ena   (take_o[n]),
            .r_val   (sent_i[n]),
            .r_dat   (sent_data_i[8 * n +: 8]),
            .t_dav   (room_i[n]),
            .t_ena   (typed_o[n]),
            .t_dat   (typed_data_o[8 * n +: 8]),
            .t_pause (idle_o[n])
        );
    end endgenerate
endmodule

`default_nettype wire
