// picture_index.vh - where a byte offset of a picture's window lies in its memory.
//
//   offset = row << 10 | column of pixels << 1      (window of 512 KB)
//   index  = row * 160 + word                       (two pixels a word; PICTURE1 behind PICTURE0)
//
// 0 where nothing is stored: between the rows and behind the last one.

// The two lowest bits choose a lane, not a word.
// verilator lint_off UNUSED
function stored;
    input [18:0] offset;
    stored = offset[18:10] < 9'd240 && offset[9:2] < 8'd160;
endfunction

function [16:0] picture_index;
    input        second;   // PICTURE1
    input [18:0] offset;
    picture_index = stored(offset)
        ? (second ? 17'd38400 : 17'd0) + {2'd0, offset[17:10], 7'd0} + {4'd0, offset[17:10], 5'd0}
          + {9'd0, offset[9:2]}
        : 17'd0;
endfunction
// verilator lint_on UNUSED
