// board.js - the page of `de1sim live`: draws what comes over the WebSocket, sends what is pressed.
// The protocol is in sim/live/README.md.
import {addButton, addSwitch} from "./controls.js";
import {clearInside, event, inside} from "./inside.js";
import {clearParts, parts} from "./parts.js";
import {clearTerminals, makeTerminals, printed} from "./terminals.js";

const $ = (id) => document.getElementById(id);
const token = new URLSearchParams(location.search).get("token");
const TILE = 16, PICTURE = 1, SOUND = 2;

const socket = new WebSocket(`ws://${location.host}/ws?token=${token}`);
socket.binaryType = "arraybuffer";
const send = (message) => { if (socket.readyState === 1) socket.send(JSON.stringify(message)); };
const step = (name, value) => send({step: {[name]: value}});

function say(text, wrong = false) {
    $("message").textContent = text;
    $("message").className = wrong ? "wrong" : "";
}

// ---- Monitor ----

const canvas = $("monitor"), context = canvas.getContext("2d");
let shown = 0;  // pictures, for who tests this page

function picture(view) {
    const width = view.getUint16(1, true), height = view.getUint16(3, true);
    if (!width) return;
    if (canvas.width !== width || canvas.height !== height) {
        canvas.width = width;
        canvas.height = height;
        zoom();
    }
    const columns = Math.ceil(width / TILE), size = 2 + TILE * TILE * 3;
    for (let at = 9; at + size <= view.byteLength; at += size) {
        const number = view.getUint16(at, true), tile = context.createImageData(TILE, TILE);
        for (let from = at + 2, to = 0; to < tile.data.length; to += 4) {
            tile.data[to] = view.getUint8(from++);
            tile.data[to + 1] = view.getUint8(from++);
            tile.data[to + 2] = view.getUint8(from++);
            tile.data[to + 3] = 255;
        }
        context.putImageData(tile, number % columns * TILE, Math.floor(number / columns) * TILE);
    }
    canvas.dataset.shown = ++shown;
}

function zoom() {
    const factor = $("zoom").value;
    canvas.classList.toggle("fit", factor === "fit");
    canvas.style.width = factor === "fit" ? "" : `${canvas.width * factor}px`;
}
$("zoom").onchange = zoom;
zoom();

// ---- Sound: off until the volume is moved, as browsers want it ----

let sound = null, gain = null;
$("volume").oninput = async () => {
    if (!sound) {
        const audio = new AudioContext();
        await audio.audioWorklet.addModule("sound.js");
        sound = new AudioWorkletNode(audio, "board-sound", {outputChannelCount: [2]});
        sound.port.onmessage = ({data}) => { $("volume").dataset.heard = data; };
        gain = audio.createGain();
        sound.connect(gain).connect(audio.destination);
    }
    gain.gain.value = $("volume").value / 100;
};

function samples(buffer, view) {
    if (sound)
        sound.port.postMessage({rate: view.getUint32(1, true), samples: new Int16Array(buffer.slice(5))});
}

// ---- Lamps ----

const SEGMENTS = ["6,2 30,2 26,7 10,7", "31,4 31,29 26,27 26,9", "31,32 31,57 26,52 26,34",
    "6,59 30,59 26,54 10,54", "5,32 5,57 10,52 10,34", "5,4 5,29 10,27 10,9",
    "7,30 10,27 26,27 29,30 26,33 10,33"];
// How many there are the message `board` says; here as many as on the DE1-SoC.  Wire 0 comes first.
const numbered = (bus, count) => Array.from({length: count}, (_, n) => `${bus}[${n}]`);
const plain = (wire) => wire.replace(/[[\]]/g, "");
let leds = [];
function makeDigits(count) {
    if ($("hex").children.length === count) return;
    $("hex").replaceChildren();
    for (let digit = count - 1; digit >= 0; --digit) {
        const polygons = SEGMENTS.map((points) => `<polygon points="${points}"/>`).join("");
        $("hex").insertAdjacentHTML("beforeend", `<svg viewBox="0 0 36 61" data-digit="${digit}" data-wire="HEX${digit}[0]">${polygons}<circle hidden data-wire="HEX${digit}[7]" cx="34" cy="57" r="2"/></svg>`);
    }
}
function makeLeds(wires) {
    if (leds.length === wires.length) return;
    leds = wires;
    $("ledr").replaceChildren();
    leds.forEach((wire, n) => {
        $("ledr").insertAdjacentHTML("afterbegin", `<div class="lamp" id="ledr${n}" data-wire="${wire}" title="${plain(wire)}"></div>`);
        $(`ledr${n}`).style.gridColumn = wires.length - n;  // above its switch
    });
}
makeDigits(6);
makeLeds(numbered("LEDR", 10));

function lamps({ledr, hex, hex_text, gpio}) {
    for (const svg of $("hex").children) {
        const lit = hex[svg.dataset.digit];
        [...svg.children].forEach((segment, n) => segment.classList.toggle("lit", lit >> n & 1));
    }
    $("hex").setAttribute("aria-label", `HEX${hex_text.length - 1} to HEX0: ${hex_text}`);
    leds.forEach((_, n) => $(`ledr${n}`).classList.toggle("lit", ledr >> n & 1));
    const shown = $("ledr").querySelectorAll(".lamp:not([hidden])");
    if (shown.length) $("ledr").setAttribute("aria-label", `${shown[0].title} to ${shown[shown.length - 1].title}: ${ledr.toString(2).padStart(shown.length, "0")}`);
    gpio.forEach((header, which) => headerPins(which, BigInt(header.levels), BigInt(header.outputs)));
}

const HEADERS = [["GPIO_0", 36], ["GPIO_1", 36], ["ARDUINO_IO", 16]];
HEADERS.forEach(([name, pins], which) => {
    let rows = "";
    for (let pin = 0; pin < pins; ++pin)
        rows += `${pin % 6 ? "" : "<tr>"}<td data-wire="${name}[${pin}]">${pin}<span class="lamp" id="gpio${which}_${pin}"></span></td>`;
    $("headers").insertAdjacentHTML("beforeend", `<div data-wire="${name}[0]"${name === "ARDUINO_IO" ? " hidden" : ""}><p><span id="header${which}">${name}</span> (outputs bold)</p><table>${rows}</table></div>`);
});
function headerPins(which, levels, outputs) {
    for (let pin = 0n; pin < HEADERS[which][1]; ++pin) {
        const lamp = $(`gpio${which}_${pin}`);
        lamp.classList.toggle("lit", Boolean(levels >> pin & 1n));
        lamp.parentElement.classList.toggle("out", Boolean(outputs >> pin & 1n));
    }
}

// ---- Buttons and switches ----

const held = (kind, value) => (on) => step(on ? "hold" : "release", {[kind]: value});
for (const key of "123A456B789C0FED")
    addButton($("keypad"), key, `keypad ${key}`, held("keypad", key)).dataset.wire = "GPIO_0[0]";
for (let key = 3; key >= 0; --key)
    addButton($("keys"), `KEY${key}`, `KEY${key}`, held("key", key)).dataset.wire = `KEY[${key}]`;
addButton($("keys"), "HPS_KEY", "HPS_KEY", held("key", "hps")).dataset.wire = "HPS";
function makeSwitches(wires) {
    if ($("switches").querySelectorAll("[data-wire]").length === wires.length) return;
    $("switches").replaceChildren();
    for (let n = wires.length - 1; n >= 0; --n) {
        const button = addSwitch($("switches"), `SW${n}`, held("switch", n));
        button.dataset.wire = wires[n];
        button.style.gridColumn = wires.length - n;
    }
}
makeSwitches(numbered("SW", 10));
for (let channel = 0; channel < 8; ++channel) {
    $("voltages").insertAdjacentHTML("beforeend",
        `<p data-wire="ADC_DOUT ANALOG[${channel}]"><label><span>CH${channel}</span> <input type="range" min="0" max="4.095" step="0.005" value="0" data-channel="${channel}"></label> <output></output></p>`);
}
$("voltages").oninput = ({target}) => {
    target.closest("p").querySelector("output").textContent = `${target.value} V`;
    step("set-voltage", {channel: Number(target.dataset.channel), volts: Number(target.value)});
};

for (const [way, text] of [["right", "to the right"], ["towards", "towards you"]])
    $("tilt").insertAdjacentHTML("beforeend",
        `<p><label>Tilted ${text} <input type="range" min="-90" max="90" value="0" data-way="${way}"></label> <output></output></p>`);
$("tilt").oninput = () => {
    const tilt = {};
    for (const range of $("tilt").querySelectorAll("input")) {
        tilt[range.dataset.way] = Number(range.value);
        range.closest("p").querySelector("output").textContent = `${range.value} degrees`;
    }
    step("tilt-board", tilt);
};
function levelRanges() {
    document.querySelectorAll("#voltages input, #tilt input").forEach((range) => { range.value = 0; });
    document.querySelectorAll("#voltages output, #tilt output").forEach((text) => { text.textContent = ""; });
}

// ---- PS/2 keyboard and mouse, while the monitor has the focus ----

const KEYS = {Escape: "Esc", ControlLeft: "Ctrl", ControlRight: "RightCtrl", ShiftLeft: "Shift", ShiftRight: "RightShift",
    AltLeft: "Alt", AltRight: "RightAlt", MetaLeft: "Win", MetaRight: "RightWin", ContextMenu: "Menu", ArrowUp: "Up",
    ArrowDown: "Down", ArrowLeft: "Left", ArrowRight: "Right", Space: "Space", NumpadDivide: "NumpadSlash",
    NumpadMultiply: "NumpadStar", NumpadSubtract: "NumpadMinus", NumpadAdd: "NumpadPlus", NumpadDecimal: "NumpadPoint",
    Minus: "-", Equal: "=", BracketLeft: "[", BracketRight: "]", Semicolon: ";", Quote: "'", Backquote: "`",
    Backslash: "\\", Comma: ",", Period: ".", Slash: "/"};
const SAME = /^(F\d+|PrintScreen|ScrollLock|Pause|Backspace|Tab|Enter|CapsLock|Insert|Home|PageUp|PageDown|Delete|End|NumLock|Numpad\d|NumpadEnter)$/;
function keyName(code) {
    if (KEYS[code]) return KEYS[code];
    if (/^Key[A-Z]$/.test(code)) return code[3].toLowerCase();
    if (/^Digit\d$/.test(code)) return code[5];
    return SAME.test(code) ? code : null;
}
const down = new Set();
const hasPs2 = () => !$("focus").hidden;
canvas.onkeydown = (event) => {
    if (!hasPs2()) return;
    if (event.ctrlKey && event.code === "Escape") { canvas.blur(); return; }
    const key = keyName(event.code);
    if (!key) return;
    event.preventDefault();
    if (event.repeat || down.has(key)) return;  // the keyboard repeats by itself
    down.add(key);
    step("hold-key", key);
};
const keyUp = (key) => { if (down.delete(key)) step("release-key", key); };
canvas.onkeyup = (event) => { if (!hasPs2()) return; keyUp(keyName(event.code)); event.preventDefault(); };
canvas.onblur = () => { [...down].forEach(keyUp); $("focus").textContent = "click the picture to type on the PS/2 keyboard"; };
canvas.onfocus = () => { $("focus").textContent = "keys go to the board; Ctrl+Esc ends that"; };

const BUTTONS = ["left", "middle", "right"], pushed = new Set();
canvas.onpointerdown = (event) => {
    canvas.focus();
    if (!$("mouse").checked) return;
    if (document.pointerLockElement !== canvas) canvas.requestPointerLock()?.catch?.(() => {});
    const button = BUTTONS[event.button];
    if (button && !pushed.has(button)) { pushed.add(button); step("hold-mouse", button); }
};
canvas.onpointerup = (event) => {
    if (pushed.delete(BUTTONS[event.button])) step("release-mouse", BUTTONS[event.button]);
};
document.addEventListener("pointerlockchange", () => {
    const locked = document.pointerLockElement === canvas;
    $("focus").textContent = locked ? "the mouse is the board's; Esc gives it back" : "";
    if (!locked) [...pushed].forEach((button) => { pushed.delete(button); step("release-mouse", button); });
});
// A step per picture of the browser, since a step takes 10 ms.
let way = null;
canvas.onpointermove = (event) => {
    if (!$("mouse").checked || !(event.movementX || event.movementY)) return;
    if (!way) requestAnimationFrame(() => {
        step("move-mouse", {right: Math.round(way.right), down: Math.round(way.down), for: "10ms"});
        way = null;
    });
    way = {right: (way?.right ?? 0) + event.movementX, down: (way?.down ?? 0) + event.movementY};
};
canvas.onwheel = (event) => {
    if (!$("mouse").checked) return;
    event.preventDefault();
    step("turn-wheel", Math.max(-8, Math.min(8, Math.sign(event.deltaY))));
};
canvas.oncontextmenu = (event) => { if ($("mouse").checked) event.preventDefault(); };

makeTerminals((text, to) => step("type-serial", {text, to}));

// ---- Time, record, files ----

let paused = false;
$("pause").onclick = () => send({pause: !paused});
$("frame").onclick = () => send({frame: 1});
$("speed").onchange = () => send({speed: Number($("speed").value)});
$("reset").onclick = () => send({reset: true});
$("mark").onclick = () => send({mark: true});
$("save").onclick = () => send({save: true});
$("waves").onclick = () => {
    send({waves: {[$("when").value]: `${Number($("length").value)}ms`}});
    say("The run is repeated for its waveforms.");
};

function status(now) {
    paused = now.paused;
    $("pause").textContent = paused ? "Run" : "Pause";
    $("pause").setAttribute("aria-pressed", paused);
    $("status").value = `${now.time.toFixed(2)} s, ${paused ? "paused" : now.factor.toFixed(2) + " x real time"}, ` +
        `${now.frames} frames, ${now.pictures} new pictures, ${now.steps} steps recorded`;
}
function power() {
    clearTerminals();
    clearParts();
    document.querySelectorAll("button").forEach((button) => button.release?.());
    down.clear();
    pushed.clear();
    clearInside();
    levelRanges();
    say("power on");
}
function saved({file, text}) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], {type: "application/yaml"}));
    link.download = "live.yaml";
    link.click();
    say(`saved: ${file}`);
}

document.ondragover = (event) => event.preventDefault();
document.ondrop = async (event) => {
    event.preventDefault();
    const file = event.dataTransfer.files[0];
    if (file) runFile(file);
};
async function runFile(file) {
    say(`runs ${file.name}`);
    const answer = await fetch(`/run?token=${token}`, {method: "POST", body: file});
    if (!answer.ok) say(await answer.text(), true);
}
window.runFile = runFile;

// ---- What arrives ----

// Of the AD converter; those in a MAX 10 are measured up to 5 V.
function nameInputs(inFpga) {
    document.querySelectorAll("#voltages input").forEach((range) => {
        range.max = inFpga ? 5 : 4.095;
        range.previousElementSibling.textContent = `${inFpga ? "Arduino_A" : "CH"}${range.dataset.channel}`;
    });
}

// What the board has not is not shown.
function board({name, wires, names, digits, leds, switches}) {
    makeDigits(digits);
    makeLeds(leds);
    makeSwitches(switches);
    document.querySelectorAll("[data-wire]").forEach((part) => {
        const has = part.dataset.wire.split(" ").some((wire) => wires.includes(wire));
        part.toggleAttribute("hidden", !has);
    });
    document.title = name;
    $("name").textContent = name;
    leds.forEach((_, n) => { $(`ledr${n}`).title = `${names.LEDR || "LEDR"}${n}`; });
    HEADERS.forEach(([bus], which) => {
        $(`header${which}`).textContent = names[bus] ? `${names[bus]}, in steps ${bus}` : bus;
    });
    nameInputs(wires.includes("ANALOG[0]"));
}

const HANDLERS = {
    hello: ({title}) => { $("title").textContent = title; },
    board, lamps, status, inside, saved, power,
    parts: (all) => parts(all, (step) => send({step})),
    terminals: printed,
    log: (line) => { say(line); event(line); },
    fault: (line) => { say(line, true); event(line, "wrong"); },
    violation: (line) => { say(line, true); event(line, "wrong"); },
    error: (line) => say(line, true),
    waves: (file) => say(`waveforms: ${file}`),
    marked: (file) => say(`marked: ${file}`),
    ended: (code) => { if (code) say(`${$("message").textContent} The run has ended (exit code ${code}).`, true); },
};
socket.onmessage = ({data}) => {
    if (typeof data === "string") {
        for (const [name, value] of Object.entries(JSON.parse(data))) HANDLERS[name]?.(value);
        return;
    }
    const view = new DataView(data);
    if (view.getUint8(0) === PICTURE) picture(view);
    if (view.getUint8(0) === SOUND) samples(data, view);
};
socket.onclose = ({reason}) => say(`The connection has ended. ${reason}`, true);
