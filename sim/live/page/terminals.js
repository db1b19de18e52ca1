// terminals.js - a terminal for each line on which a program prints and is typed to.

const $ = (id) => document.getElementById(id);
const LINES = {serial: "Serial line", "jtag-0": "JTAG UART 0", "jtag-1": "JTAG UART 1"};
const MOST = 100000;  // characters of each that are kept

// `type` gets the text and the line.
export function makeTerminals(type) {
    for (const [line, title] of Object.entries(LINES)) {
        const part = document.createElement("section");
        part.setAttribute("aria-label", title);
        part.innerHTML = `<h2>${title}</h2>
            <pre class="console" id="printed-${line}" tabindex="0" aria-label="Printed on ${title}"></pre>
            <form><input id="type-${line}" autocomplete="off" aria-label="Type on ${title}">
            <button>Send</button></form>`;
        part.querySelector("form").onsubmit = (event) => {
            event.preventDefault();
            const input = $(`type-${line}`);
            type(input.value + "\n", line);
            input.value = "";
        };
        $("terminals").append(part);
    }
}

export function printed(texts) {
    for (const [line, text] of Object.entries(texts)) {
        const pane = $(`printed-${line}`);
        if (!pane) continue;
        const follow = pane.scrollTop + pane.clientHeight >= pane.scrollHeight - 4;
        pane.textContent = (pane.textContent + text).slice(-MOST);
        if (follow) pane.scrollTop = pane.scrollHeight;
    }
}

export function clearTerminals() {
    for (const line of Object.keys(LINES)) $(`printed-${line}`).textContent = "";
}
