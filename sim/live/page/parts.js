// parts.js - parts on the headers and displays: what each shows, and what is pressed.
import {addButton, addSwitch} from "./controls.js";
import {addTerminal} from "./terminals.js";

const $ = (id) => document.getElementById(id);

function makePart(name, {kind, on, off, stays}, play) {
    const part = document.createElement("div");
    part.id = `part-${name}`;
    part.title = `${kind} ${name}`;
    const set = (pressed) => play(pressed ? on : off);
    if (on && stays) addSwitch(part, name, set);
    else if (on) addButton(part, name, name, set);
    else part.insertAdjacentHTML("beforeend", "<p></p>");
    const label = part.querySelector("p");
    if (label) label.textContent = name;
    $("parts").hidden = false;
    $("parts").append(part);
    return part;
}

// Rows of the characters . # +, an LED each.
function showRows(part, rows) {
    let grid = part.querySelector(".leds");
    if (!grid) {
        grid = document.createElement("div");
        grid.className = "leds";
        grid.setAttribute("role", "img");
        grid.style.gridTemplateColumns = `repeat(${rows[0].length}, 1em)`;
        grid.innerHTML = "<span class=\"lamp\"></span>".repeat(rows.join("").length);
        part.append(grid);
    }
    [...rows.join("")].forEach((led, n) => {
        grid.children[n].classList.toggle("lit", led !== ".");
        grid.children[n].classList.toggle("dim", led === "+");
    });
    grid.setAttribute("aria-label", `${part.title}: ${rows.join(" ")}`);
}

function showPicture(part, picture) {
    let image = part.querySelector("img");
    if (!image) {
        image = document.createElement("img");
        image.alt = `the picture of ${part.title}`;
        part.append(image);
    }
    image.src = picture;
}

// The message "parts"; `play` gets a step.
export function parts(all, play) {
    for (const [name, one] of Object.entries(all)) {
        if (one.kind === "terminal") { addTerminal(name, name); continue; }
        const part = $(`part-${name}`) || makePart(name, one, play);
        if (one.rows) showRows(part, one.rows);
        if (one.picture) showPicture(part, one.picture);
    }
}

// Another run may have others.
export function clearParts() {
    $("parts").hidden = true;
    document.querySelectorAll("#parts > div").forEach((part) => part.remove());
}
