"""random_systems_test.py DE1SIM FOLDER [CASE...] - random systems whose masters check their reads

Masters of all widths, with and without readdatavalid and bursts, on two clocks; slaves of all
widths and timings, with and without bursts, which drive rubbish when their data do not count.
Each master has a window of each slave to itself, and a copy of what it wrote there, with which it
compares what it reads.
In the environment: SYSTEMS, how many there are; ACCESSES of each master; SEED of the first.
"""
import os
import random

from case import run
from systems import SystemCase, pio, qsys

SYSTEMS, ACCESSES = int(os.environ.get("SYSTEMS", 4)), int(os.environ.get("ACCESSES", 5000))
SEED = int(os.environ.get("SEED", 1))
WINDOW = 512  # bytes

COMPONENT = """set_module_property NAME {name}
add_fileset synth QUARTUS_SYNTH "" ""
set_fileset_property synth TOP_LEVEL {name}
add_fileset_file {name}.v VERILOG PATH {name}.v
add_interface clock clock end
add_interface_port clock clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clock
add_interface_port reset reset reset Input 1
add_interface result conduit end
add_interface_port result result export Output {results}
add_interface bus avalon {side}
set_interface_property bus associatedClock clock
set_interface_property bus associatedReset reset
"""

MASTER = """module {name}(input clk, input reset, output [1:0] result,
output [31:0] address, output read, write, output [{width}-1:0] writedata,
output [{bytes}-1:0] byteenable, output [5:0] burstcount, input waitrequest,
input readdatavalid, input [{width}-1:0] readdata);
localparam BYTES = {bytes}, WORDS = {window} / BYTES;
reg [7:0] copy [0:{windows}*{window}-1];
reg [31:0] base [0:{windows}-1];
reg [{width}-1:0] expected [0:1023];
reg [9:0] asked, answered;
reg [31:0] seed, count;
reg active, writes, bad;
reg [5:0] left;        // words of the burst after this one
reg [7:0] window;
reg [15:0] word;       // of the window
reg [{bytes}-1:0] bytes;
reg [{width}-1:0] data;
reg [5:0] burst;
reg [31:0] first;
wire waits = count >= {accesses} || asked - answered > 10'd900;
assign result = {{count >= {accesses} && asked == answered && !active, bad}};
assign address = first, read = active && !writes, write = active && writes;
assign writedata = data, byteenable = bytes, burstcount = burst;
function [31:0] next(input [31:0] x);
    begin next = x ^ x << 13; next = next ^ next >> 17; next = next ^ next << 5; end
endfunction
function [15:0] after(input [15:0] x, input [15:0] n);
    after = {wraps} ? (x & ~({wraps} - 1)) | ((x + n) & ({wraps} - 1)) : x + n;
endfunction
integer i, n;
reg [31:0] r;
initial begin {bases} for (i = 0; i < {windows}*{window}; i = i + 1) copy[i] = 0; end
task draw_word; begin  // the data and bytes of a word that is written: one at least
    for (i = 0; i < BYTES; i = i + 1) begin
        r = next(r); data[8*i +: 8] <= r[15:8]; bytes[i] <= r[20] || r[31:29] == 0;
    end
    bytes[r[27:21] % BYTES] <= 1;
end endtask
always @(posedge clk) begin
    r = seed;
    if (readdatavalid || ({unpiped} && read && !waitrequest)) begin
        if (readdata != expected[answered]) bad <= 1;
        answered <= answered + 1;
    end
    if (active && !waitrequest) begin
        count <= count + 1;
        if (writes) begin
            for (i = 0; i < BYTES; i = i + 1)
                if (bytes[i]) copy[window * {window} + word * BYTES + i] = data[8*i +: 8];
            word <= after(word, 1);
            left <= left - 1;
            if (left == 0) active <= 0; else draw_word;
        end else active <= 0;
    end else if (!active && !waits) begin
        r = next(r); window = r[27:8] % {windows};
        r = next(r); word = r[27:8] % WORDS;
        r = next(r); writes = r[9]; burst = 1;
        if ({bursts} && r[14:13] == 0) burst = 1 + r[24:20] % ({bursts} + !{bursts});
        if (!{wraps} && word + burst > WORDS) burst = 1;
        left <= burst - 1;
        first <= base[window] + word * BYTES;
        draw_word;
        if (!writes) begin
            bytes <= ~0;
            for (n = 0; n < burst; n = n + 1)
                for (i = 0; i < BYTES; i = i + 1)
                    expected[(asked + n) % 1024][8*i +: 8] =
                        copy[window * {window} + after(word, n) * BYTES + i];
            asked <= asked + burst;
        end
        r = next(r); active <= r[7] || r[3];
        if (!(r[7] || r[3])) asked <= asked;
    end
    seed <= next(r);
    if (reset) begin
        active <= 0; seed <= {seed}; count <= 0; asked <= 0; answered <= 0; bad <= 0;
    end
end
endmodule
"""

SLAVE = """module {name}(input clk, input reset, output result, input [{bits}-1:0] address,
input read, write, input [{width}-1:0] writedata, input [{bytes}-1:0] byteenable,
output [{width}-1:0] readdata, output waitrequest, output readdatavalid);
reg [{width}-1:0] words [0:(1 << {bits}) - 1];
reg [31:0] seed;
reg [15:0] clock;  // of this transfer
reg bad;
assign result = bad;
function [31:0] next(input [31:0] x);
    begin next = x ^ x << 13; next = next ^ next >> 17; next = next ^ next << 5; end
endfunction
localparam KIND = {kind}, READ = {read}, WRITE = {write}, LATENCY = {latency};
wire [{width}-1:0] rubbish = {{({width} + 31) / 32{{seed ^ 32'h5A5A5A5A}}}};
reg [{width}-1:0] line [0:15];
reg [15:0] come;   // which of the line are answers
reg [{bits}-1:0] was;
wire ends = KIND == 2 || KIND == 3 ? !waitrequest : clock == (write ? WRITE : READ);
assign waitrequest = (KIND == 2 || KIND == 3) && (seed[11] || seed[5]);
assign readdatavalid = KIND == 3 && come[LATENCY];
assign readdata = KIND == 1 || KIND == 3 ? (come[LATENCY] ? line[LATENCY] : rubbish)
                : read && ends ? words[address] : rubbish;
integer i;
always @(posedge clk) begin
    seed <= next(seed);
    was <= address;
    clock <= (read || write) && !ends ? clock + 1 : 0;
    if (clock != 0 && (address != was || !(read || write))) bad <= 1;  // within a transfer
    if (read && write) bad <= 1;
    if (write && ends)
        for (i = 0; i < {bytes}; i = i + 1)
            if (byteenable[i]) words[address][8*i +: 8] <= writedata[8*i +: 8];
    for (i = 15; i > 1; i = i - 1) begin line[i] <= line[i-1]; come[i] <= come[i-1]; end
    line[1] <= words[address]; come[1] <= read && ends;
    if (reset) begin seed <= {seed}; clock <= 0; come <= 0; bad <= 0; end
end
endmodule
"""

# With bursts: of 1 << {most} words at most, whose first address and length alone count.
BURST_SLAVE = """module {name}(input clk, input reset, output result, input [{bits}-1:0] address,
input read, write, input [{width}-1:0] writedata, input [{bytes}-1:0] byteenable,
input [{most}:0] burstcount, input beginbursttransfer,
output reg [{width}-1:0] readdata, output waitrequest, output reg readdatavalid);
localparam MOST = 1 << {most};
reg [{width}-1:0] words [0:(1 << {bits}) - 1];
reg [31:0] seed;
reg bad;
assign result = bad;
function [31:0] next(input [31:0] x);
    begin next = x ^ x << 13; next = next ^ next >> 17; next = next ^ next << 5; end
endfunction
function [{bits}-1:0] after(input [{bits}-1:0] x, input [15:0] n);
    after = {wraps} ? (x & ~(MOST - 1)) | ((x + n) & (MOST - 1)) : x + n;
endfunction
reg [{bits}-1:0] first [0:255];  // of the reads that wait
reg [15:0] length [0:255];
reg [7:0] oldest, newest;
reg [15:0] given;                // words of the oldest
reg [15:0] written, whole;       // words of the burst that is written, and all of them
reg [{bits}-1:0] to;
wire [15:0] place = write && written != 0 ? written : 0;
wire [{bits}-1:0] at = after(written != 0 ? to : address, place);
assign waitrequest = seed[11] || seed[5];
integer i;
always @(posedge clk) begin
    seed <= next(seed);
    readdatavalid <= 0;
    readdata <= {{({width} + 31) / 32{{seed ^ 32'h5A5A5A5A}}}};
    if (read && write) bad <= 1;
    if ((read || write) && written == 0) begin
        if (burstcount == 0 || burstcount > MOST) bad <= 1;
        if ({boundaries} && address % burstcount != 0) bad <= 1;
    end
    if (written != 0 && (read || beginbursttransfer)) bad <= 1;
    if (read && !waitrequest) begin
        first[newest] <= address; length[newest] <= burstcount; newest <= newest + 1;
        if ((newest - oldest) % 256 > {pending}) bad <= 1;
    end
    if (write && !waitrequest) begin
        if (oldest != newest) bad <= 1;
        if (written == 0) begin to <= address; whole <= burstcount; end
        written <= written + 1 == (written == 0 ? burstcount : whole) ? 0 : written + 1;
        for (i = 0; i < {bytes}; i = i + 1)
            if (byteenable[i]) words[at][8*i +: 8] <= writedata[8*i +: 8];
    end
    if (oldest != newest && (seed[7] || seed[22])) begin
        readdatavalid <= 1;
        readdata <= words[after(first[oldest], given)];
        given <= given + 1 == length[oldest] ? 0 : given + 1;
        if (given + 1 == length[oldest]) oldest <= oldest + 1;
    end
    if (reset) begin
        seed <= {seed}; bad <= 0; oldest <= 0; newest <= 0; given <= 0; written <= 0;
    end
end
endmodule
"""


class RandomSystems(SystemCase):
    def master(self, draw, name, bases):
        width = draw.choice([8, 16, 32, 32, 64, 128])
        piped, bursts = draw.random() < 0.7, draw.random() < 0.6
        most = draw.choice([1, 3, 4, 5])                 # 1 << most words
        most = min(most, (WINDOW * 8 // width).bit_length() - 1)
        wraps = bursts and piped and draw.random() < 0.2
        self.component(name, MASTER.format(
            name=name, width=width, bytes=width // 8, window=WINDOW, windows=len(bases),
            accesses=ACCESSES, unpiped=int(not piped), bursts=(1 << most) * (bursts and piped),
            wraps=(1 << most) * wraps,
            seed=draw.randrange(1, 1 << 31),
            bases=" ".join(f"base[{n}] = {base};" for n, base in enumerate(bases))), "start", 2,
            [("address", "Output", 32), ("read", "Output", 1), ("write", "Output", 1),
             ("writedata", "Output", width), ("byteenable", "Output", width // 8),
             ("waitrequest", "Input", 1), ("readdata", "Input", width)] +
            [("readdatavalid", "Input", 1)] * piped +
            [("burstcount", "Output", most + 1)] * (bursts and piped),
            {"linewrapBursts": "true"} if wraps else {})

    def slave(self, draw, name, windows):
        width = draw.choice([8, 16, 32, 32, 64, 128, 256])
        kind, read, write = draw.choice([0, 1, 2, 3, 4, 4, 4]), draw.randrange(4), draw.randrange(3)
        latency = draw.randrange(1, 4) if kind == 1 else draw.randrange(1, 15)
        bits = max(1, (windows * WINDOW * 8 // width - 1).bit_length())
        setup, hold = (draw.randrange(3), draw.randrange(3)) if kind == 0 else (0, 0)
        properties = {0: {"readWaitTime": read, "writeWaitTime": write, "setupTime": setup,
                          "holdTime": hold},
                      1: {"readWaitTime": 0, "readLatency": latency},
                      2: {}, 4: {}, 3: {"maximumPendingReadTransactions": 16}}[kind]
        if kind == 1:
            read = write = 0
        if kind == 4:
            most, pending = draw.choice([1, 2, 3, 4, 6]), draw.choice([1, 2, 7])
            most = min(most, bits)
            wraps, boundaries = draw.random() < 0.3, draw.random() < 0.3
            self.component(name, BURST_SLAVE.format(
                name=name, width=width, bytes=width // 8, bits=bits, most=most, pending=pending,
                wraps=int(wraps), boundaries=int(boundaries), seed=draw.randrange(1, 1 << 31)),
                "end", 1,
                [("address", "Input", bits), ("read", "Input", 1), ("write", "Input", 1),
                 ("writedata", "Input", width), ("readdata", "Output", width),
                 ("burstcount", "Input", most + 1), ("beginbursttransfer", "Input", 1)] +
                [("byteenable", "Input", width // 8)] * (width > 8) +
                [("waitrequest", "Output", 1), ("readdatavalid", "Output", 1)],
                {"maximumPendingReadTransactions": pending,
                 "linewrapBursts": str(wraps).lower(),
                 "burstOnBurstBoundariesOnly": str(boundaries).lower()})
            return (1 << bits) * width // 8
        self.component(name, SLAVE.format(
            name=name, width=width, bytes=width // 8, bits=bits, kind=kind, read=read, write=write,
            latency=latency, seed=draw.randrange(1, 1 << 31)), "end", 1,
            [("address", "Input", bits), ("read", "Input", 1), ("write", "Input", 1),
             ("writedata", "Input", width), ("readdata", "Output", width)] +
            [("byteenable", "Input", width // 8)] * (width > 8) +
            [("waitrequest", "Output", 1)] * (kind > 1) +
            [("readdatavalid", "Output", 1)] * (kind == 3), properties)
        return max(1 << bits, 1) * width // 8

    def component(self, name, verilog, side, results, ports, properties=None):
        text = COMPONENT.format(name=name, side=side, results=results)
        for key, value in (properties or {}).items():
            text += f"set_interface_property bus {key} {value}\n"
        for role, direction, width in ports:
            text += f"add_interface_port bus {role} {role} {direction} {width}\n"
        (self.folder / f"{name}_hw.tcl").write_text(text)
        # Inputs that the interface has not are 0, and bytes of a narrow slave are all there.
        inside = {role for role, _, _ in ports}
        for role, value in (("readdatavalid", "1'b0"), ("byteenable", "1'b1")):
            if role not in inside and side == ("start" if role == "readdatavalid" else "end"):
                kind = "input " if role == "readdatavalid" else "input [1-1:0] "
                verilog = verilog.replace(f", {kind}{role}", "").replace(f"\n{kind}{role},", "\n")
                verilog = verilog.replace(");\n", f");\nwire [0:0] {role} = {value};\n", 1)
        (self.folder / f"{name}.v").write_text(verilog)

    def one(self, seed):
        draw = random.Random(seed)
        masters, slaves = draw.randrange(1, 5), draw.randrange(1, 6)
        modules = [("clk_0", "clock_source", {}), ("clk_1", "clock_source", {})]
        wires, exports = [], [("second", "clk_1.clk_in"), ("reset_1", "clk_1.clk_in_reset")]
        base, bases = 0, []
        for n in range(slaves):
            span = self.slave(draw, f"s{n}", masters)
            base = -(-base // span) * span
            bases.append(base)
            base += span
        for n in range(masters):
            self.master(draw, f"m{n}", [b + n * WINDOW for b in bases])
        for name in [f"m{n}" for n in range(masters)] + [f"s{n}" for n in range(slaves)]:
            clock = draw.choice(["clk_0", "clk_0", "clk_1"])
            modules.append((name, name, {}))
            wires += [("clock", clock + ".clk", name + ".clock"),
                      ("reset", clock + ".clk_reset", name + ".reset")]
            exports.append((name, name + ".result"))
        wires += [("avalon", f"m{m}.bus", f"s{s}.bus", bases[s])
                  for m in range(masters) for s in range(slaves)]
        results = "".join(f", .m{n}_export({{done[{n}], bad[{n}]}})" for n in range(masters)) + \
            "".join(f", .s{n}_export(wrong[{n}])" for n in range(slaves))
        self.write(sys_qsys=qsys(modules, wires, exports), top_v=f"""module top(input CLOCK_50,
output [9:0] LEDR);
wire [{masters - 1}:0] done, bad;
wire [{slaves - 1}:0] wrong;
reg slow = 0;
always @(posedge CLOCK_50) slow <= !slow;
assign LEDR = {{7'd0, wrong != 0, bad != 0, &done}};
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .second_clk(slow), .reset_1_reset_n(1'b1)
{results});
endmodule
""", top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
             "set_global_assignment -name VERILOG_FILE top.v\n"
             "set_global_assignment -name QSYS_FILE sys.qsys\n",
                   s_yaml="name: s\nversion: 1\nproject: top.qsf\nsteps:\n"
                          f"  - expect-leds: {{equals: 1, timeout: {ACCESSES * 20}us}}\n")
        done = self.de1sim("run", "s.yaml")
        self.assertEqual(done.returncode, 0, f"seed {seed}: {done.stdout}{done.stderr}")

    def test_what_was_written_is_read(self):
        for seed in range(SEED, SEED + SYSTEMS):
            self.one(seed)


if __name__ == "__main__":
    run()
