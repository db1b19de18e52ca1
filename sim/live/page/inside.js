// inside.js - the panel that shows what goes on inside: the message "inside", aborts, violations.

const $ = (id) => document.getElementById(id);
const percent = (share) => `${(100 * share).toFixed(0)} %`;

// A figure with its name; `meter`: how much of how much.
function row(name, text, meter) {
    let line = [...$("figures").children].find((one) => one.dataset.name === name);
    if (!line) {
        line = document.createElement("div");
        line.dataset.name = name;
        line.innerHTML = "<dt></dt><dd><span></span> </dd>";
        line.querySelector("dt").textContent = name;
        $("figures").append(line);
    }
    line.querySelector("span").textContent = text;
    if (!meter) return;
    let bar = line.querySelector("meter");
    if (!bar) {
        bar = document.createElement("meter");
        bar.setAttribute("aria-label", name);
        line.querySelector("dd").append(bar);
    }
    [bar.value, bar.max] = meter;
}

let before = null;

export function inside(now) {
    const frames = before ? now.frames - before.frames : 0;
    const pictures = before ? now.pictures - before.pictures : 0;
    before = now;
    row("Frames", `${now.frames}`);
    row("New pictures", `${now.pictures}${frames > 0 ? `, ${pictures} in the last ${frames} frames` : ""}`);
    row("Signal", now.signal || "none yet");
    if (now.program) {
        const {function: name, pc, waiting, busy, on_bus, instructions, interrupts, aborts} = now.program;
        const where = name || `0x${pc.toString(16).padStart(8, "0")}`;
        row("Program", waiting ? `${where}, waits for ${waiting}` : where);
        if (busy !== undefined) {
            row("Of a frame's 16.7 ms", `${percent(busy)}, on the bus ${percent(on_bus)}`, [busy, 1]);
            row("Instructions per frame", instructions.toLocaleString());
        }
        row("Interrupts, aborts", `${interrupts}, ${aborts}`);
    }
    if (now.bus) {
        const {reads, writes, bursts, errors} = now.bus;
        row("Bus per frame", `${reads} reads, ${writes} writes, ${bursts} bursts`);
        row("Refused accesses", `${errors}`);
    }
    if (now.audio && !$("volume").closest("label").hidden) {
        const {to_play: out, recorded, size, underruns} = now.audio;
        row("Samples to play", `${out[0]}, ${out[1]} of ${size}`, [Math.min(...out), size]);
        row("Samples recorded", `${recorded[0]}, ${recorded[1]} of ${size}`, [Math.max(...recorded), size]);
        row("Underruns", `${underruns}`);
    }
    row("Violations", `VGA ${now.vga_violations}, SDRAM ${now.sdram_violations}, codec ${now.codec_errors}`);
}

// An abort, a reset; "wrong": a fault, a violation.
export function event(line, kind = "") {
    const item = document.createElement("li");
    item.className = kind;
    item.textContent = line;
    $("events").append(item);
    while ($("events").children.length > 100) $("events").firstChild.remove();
}

export function clearInside() {
    before = null;
    $("figures").textContent = $("events").textContent = "";
}
