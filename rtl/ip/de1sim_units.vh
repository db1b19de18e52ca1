// de1sim_units.vh - "25.175 MHz" and "-9921 ps" as times in femtoseconds, for parameters of PLLs
//
// To be included in a module.  A text is at most 40 characters, with at most 6 decimal places.

// The number in millionths of the unit that follows it.
function [63:0] de1sim_millionths(input [8*40-1:0] text);
    integer i, places;
    reg [7:0] c;
    reg negative, point, unit;
    begin
        de1sim_millionths = 0;
        places = 0;
        negative = 0;
        point = 0;
        unit = 0;
        for (i = 39; i >= 0; i = i - 1) begin
            c = text[8*i +: 8];
            if (c == "-") negative = 1;
            if (c == ".") point = 1;
            if (c >= "A") unit = 1;
            if (c >= "0" && c <= "9" && !unit && places < 6) begin
                de1sim_millionths = de1sim_millionths * 10 + {56'd0, c - "0"};
                if (point) places = places + 1;
            end
        end
        for (i = 0; i < 6; i = i + 1)
            if (i >= places) de1sim_millionths = de1sim_millionths * 10;
        if (negative) de1sim_millionths = -de1sim_millionths;
    end
endfunction

// The first letter of the unit, 0 if there is none.
function [7:0] de1sim_unit(input [8*40-1:0] text);
    integer i;
    begin
        de1sim_unit = 0;
        for (i = 39; i >= 0; i = i - 1)
            if (text[8*i +: 8] >= "A" && de1sim_unit == 0) de1sim_unit = text[8*i +: 8];
    end
endfunction

// The period of a frequency in GHz, MHz, kHz or Hz, rounded; 0 for 0.
function [63:0] de1sim_period_fs(input [8*40-1:0] frequency);
    reg [63:0] hz;
    reg [7:0]  unit;
    begin
        hz = de1sim_millionths(frequency);
        unit = de1sim_unit(frequency);
        case (unit)
            "G": hz = hz * 1000;
            "k", "K": hz = hz / 1000;
            "H": hz = hz / 1000000;
            default: ;
        endcase
        de1sim_period_fs = hz == 0 ? 64'd0 : (64'd1000000000000000 + hz / 2) / hz;
    end
endfunction

// A phase in us, ns or ps, or without unit in ps, within one period: -1 ns of 20 is 19 ns.
function [63:0] de1sim_phase_fs(input [8*40-1:0] phase, input [63:0] period_fs);
    reg signed [63:0] fs;
    reg [7:0]         unit;
    begin
        fs = de1sim_millionths(phase);
        unit = de1sim_unit(phase);
        case (unit)
            "u": fs = fs * 1000;
            "n": ;
            default: fs = fs / 1000;
        endcase
        if (period_fs == 0) de1sim_phase_fs = 0;
        else begin
            fs = fs % $signed(period_fs);
            de1sim_phase_fs = fs < 0 ? fs + period_fs : fs;
        end
    end
endfunction
