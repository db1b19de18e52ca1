// cyclonev_pseudo_diff_out.v - device primitive: a signal and its opposite, for two pins

`default_nettype none

module cyclonev_pseudo_diff_out #(
    // Without meaning here.
    parameter lpm_type = "cyclonev_pseudo_diff_out", LPM_TYPE = lpm_type
) (
    input  wire i, oein, dtcin,
    output wire o, obar,
    output wire oeout, oebout,
    output wire dtc, dtcbar
);
    assign o = i;
    assign obar = !i;
    assign oeout = oein;
    assign oebout = oein;
    assign dtc = dtcin;
    assign dtcbar = dtcin;
endmodule

`default_nettype wire
