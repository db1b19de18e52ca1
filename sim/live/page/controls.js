// controls.js - buttons and switches of the board and of the parts on its headers.
// `set` is called with true and false, as the control is moved.

// Held while it is pressed; a right click or Shift holds it until the next click.
export function addButton(parent, label, title, set) {
    const button = document.createElement("button");
    button.textContent = label;
    button.setAttribute("aria-label", title);
    let held = false, latched = false;
    const hold = (on) => {
        if (on === held) return;
        held = on;
        button.classList.toggle("on", on);
        set(on);
    };
    button.onpointerdown = (event) => {
        event.preventDefault();
        button.focus();
        button.setPointerCapture(event.pointerId);
        if (latched) { latched = false; return; }
        latched = event.shiftKey || event.button === 2;
        hold(true);
    };
    button.onpointerup = button.onpointercancel = () => { if (!latched) hold(false); };
    button.oncontextmenu = (event) => event.preventDefault();
    button.onkeydown = (event) => {
        if (event.key !== " " && event.key !== "Enter") return;
        event.preventDefault();
        if (event.repeat) return;
        latched = event.shiftKey && !latched;
        hold(true);
    };
    button.onkeyup = (event) => {
        if ((event.key === " " || event.key === "Enter") && !latched) hold(false);
    };
    button.onblur = () => { if (!latched) hold(false); };
    button.release = () => { held = latched = false; button.classList.remove("on"); };
    parent.append(button);
    return button;
}

// Stays where it was moved to; off at first.
export function addSwitch(parent, label, set) {
    const button = document.createElement("button");
    const show = (on) => {
        button.setAttribute("aria-checked", on);
        button.classList.toggle("on", on);
    };
    button.textContent = label;
    button.setAttribute("role", "switch");
    button.onclick = () => {
        const on = button.getAttribute("aria-checked") === "false";
        show(on);
        set(on);
    };
    button.release = () => show(false);
    show(false);
    parent.append(button);
    return button;
}
