// terminals.js - a terminal for each line on which a program prints and is typed to.

const $ = (id) => document.getElementById(id);
const LINES = {serial: "Serial line", "jtag-0": "JTAG UART 0", "jtag-1": "JTAG UART 1"};
const MOST = 100000;  // characters of each that are kept

let send = () => {};

// Of a line, or of a terminal among the parts, whose name is its title.
export function addTerminal(line, title) {
    if ($(`printed-${line}`)) return $(`printed-${line}`);
    const part = document.createElement("section");
    part.setAttribute("aria-label", title);
    part.innerHTML = `<h2></h2><pre class="console" tabindex="0"></pre>
        <form><input autocomplete="off"><button>Send</button></form>`;
    const pane = part.querySelector("pre"), input = part.querySelector("input");
    part.querySelector("h2").textContent = title;
    pane.id = `printed-${line}`;
    pane.setAttribute("aria-label", `Printed on ${title}`);
    input.id = `type-${line}`;
    input.setAttribute("aria-label", `Type on ${title}`);
    part.querySelector("form").onsubmit = (event) => {
        event.preventDefault();
        send(input.value + "\n", line);
        input.value = "";
    };
    $("terminals").append(part);
    return pane;
}

// `type` gets the text and the line.
export function makeTerminals(type) {
    send = type;
    for (const [line, title] of Object.entries(LINES)) addTerminal(line, title);
    $("printed-serial").closest("section").dataset.wire = "HPS";
}

export function printed(texts) {
    for (const [line, text] of Object.entries(texts)) {
        const pane = addTerminal(line, line);
        const follow = pane.scrollTop + pane.clientHeight >= pane.scrollHeight - 4;
        pane.textContent = (pane.textContent + text).slice(-MOST);
        if (follow) pane.scrollTop = pane.scrollHeight;
    }
}

export function clearTerminals() {
    for (const pane of document.querySelectorAll("#terminals pre")) pane.textContent = "";
}
