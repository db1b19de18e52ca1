// lanes.vh - the bits of a word that a write's byte strobes name.
function [31:0] lanes;
    input [3:0] strobes;
    lanes = {{8{strobes[3]}}, {8{strobes[2]}}, {8{strobes[1]}}, {8{strobes[0]}}};
endfunction

function [31:0] merged;
    input [31:0] old_word;
    input [31:0] new_word;
    input [3:0]  strobes;
    merged = (new_word & lanes(strobes)) | (old_word & ~lanes(strobes));
endfunction
