"use strict";
// What every part of a page uses: elements, words for numbers, the theme.

const page = JSON.parse(document.getElementById("data").textContent);

function byId(id) {
  return document.getElementById(id);
}

// An element with attributes and children; texts never become markup.
function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) {
    if (value === true) element.setAttribute(name, "");
    else if (value !== false && value != null) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child != null));
  return element;
}

// Text in which *words* are emphasised and `words` are code; code may hold asterisks.
function marked(text) {
  const parts = [];
  for (const [, strong, code, plain] of text.matchAll(/\*((?:`[^`]*`|[^*`])+)\*|`([^`]*)`|([^*`]+|[*`])/g)) {
    if (strong !== undefined) parts.push(make("strong", {}, ...marked(strong)));
    else if (code !== undefined) parts.push(make("code", {}, code));
    else parts.push(plain);
  }
  return parts;
}

function percent(share, digits) {
  if (share == null) return "–";
  const value = 100 * share;
  // From 9.95 on, one digit would print 10.0.
  const places = digits ?? (Math.abs(value) < 9.95 ? 1 : 0);
  return `${value.toFixed(places)} %`;
}

// An error from 0 to 1, as the papers write it.
function errorText(error) {
  if (error == null) return "–";
  if (error === 0) return "0";
  return (error < 1e-4 ? error.toExponential(1) : error.toPrecision(2)).replace(/^0\./, ".");
}

function ms(value) {
  return value == null ? "–" : `${value < 10 ? value.toFixed(2) : value.toFixed(1)} ms`;
}

function short(text, length) {
  return text.length > length ? `${text.slice(0, length - 1)}…` : text;
}

function fillSelect(select, options, chosen) {
  select.replaceChildren(
    ...options.map(([value, text]) =>
      make("option", { value, selected: String(value) === String(chosen) }, text)),
  );
}

// Radio buttons that look like one bar, of [value, text, why it cannot be had]; `choose` is called
// with the value that is picked.
function segments(place, name, options, chosen, choose) {
  place.replaceChildren(
    ...options.map(([value, text, absence]) => {
      const input = make("input", { type: "radio", name, value, disabled: Boolean(absence), title: absence || null });
      input.checked = value === chosen;
      input.addEventListener("change", () => choose(value));
      return make("label", {}, input, make("span", {}, text));
    }),
  );
}

function definitions(list, entries) {
  list.replaceChildren(
    ...entries.flatMap(([term, text]) => [make("dt", {}, term), make("dd", {}, ...[text].flat())]),
  );
}

// A command line, with a button that copies it.
function commandParts(text) {
  const button = make("button", { type: "button", class: "copy" }, "Copy");
  // Lines end between words: a browser would break `--size` behind its first hyphen as well.
  const words = text.split(/(?<= )/).map((word) => make("span", {}, word));
  const command = make("pre", { class: "command" }, ...words);
  button.addEventListener("click", () => {
    // A page opened as a file may not use the clipboard; what is selected can be copied by hand.
    getSelection().selectAllChildren(command);
    if (document.execCommand("copy")) button.textContent = "Copied";
  });
  return [command, button];
}

// Plotly wants colours: it cannot read the variables of the style.
function color(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

const theme = {
  // "auto" follows the system, also while the page is open.
  wish: "auto",
  system: matchMedia("(prefers-color-scheme: dark)"),
  listeners: [],

  get dark() {
    return this.wish === "auto" ? this.system.matches : this.wish === "dark";
  },

  apply() {
    document.documentElement.dataset.theme = this.dark ? "dark" : "light";
    byId("theme").textContent = `Theme: ${this.wish}`;
    for (const listener of this.listeners) listener();
  },

  next() {
    // The first step away from "auto" must change something.
    const order = this.system.matches ? ["auto", "light", "dark"] : ["auto", "dark", "light"];
    this.wish = order[(order.indexOf(this.wish) + 1) % order.length];
    this.apply();
  },
};
// Before anything is drawn: plots read their colours from the style of the theme.
theme.apply();
byId("theme").addEventListener("click", () => theme.next());
theme.system.addEventListener("change", () => theme.apply());
