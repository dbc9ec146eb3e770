"use strict";
// Shaders as coloured lines, with expressions marked, and a row of tabs for several of them.

const WORDS = new RegExp("^(?:" + [
  "attribute|break|bool|case|centroid|const|continue|default|discard|do|double|else|false|flat|float|for|if",
  "in|inout|int|invariant|layout|mat[234](?:x[234])?|out|precise|return|[iu]?sampler\\w+|smooth|struct",
  "switch|true|uint|uniform|varying|void|while|[biu]?vec[234]",
].join("|") + ")$");
const TOKENS = /(\/\/[^\n]*|\/\*[^]*?(?:\*\/|$))|(^[ \t]*#[^\n]*)|(\b\d[\w.]*|\.\d\w*)|([A-Za-z_]\w*)/gm;

let texts = null; // hash -> text, once it is unpacked

async function unpackTexts() {
  const packed = atob(byId("texts").textContent.trim());
  // atob gives a string with a character for each byte.
  const bytes = new Uint8Array(packed.length);
  for (let at = 0; at < packed.length; at++) bytes[at] = packed.charCodeAt(at);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  texts = await new Response(stream).json();
}

// Stretches of a text with the class of each: [start, end, class].
function stretches(text) {
  const found = [];
  for (const match of text.matchAll(TOKENS)) {
    const [all, comment, directive, number, word] = match;
    let kind = null;
    if (comment !== undefined) kind = "c";
    else if (directive !== undefined || number !== undefined) kind = directive === undefined ? "n" : "w";
    else if (word.startsWith("sc_")) kind = "a";
    else if (WORDS.test(word)) kind = "w";
    if (kind) found.push([match.index, match.index + all.length, kind]);
  }
  return found;
}

// The lines of a text as elements; `spans` are [start, end] to be marked.
function codeLines(text, spans) {
  const colored = stretches(text);
  const cuts = new Set([0, text.length]);
  for (const [start, end] of [...colored, ...spans]) cuts.add(start).add(end);
  // Indentation is a stretch of its own: what is marked begins behind it.
  for (const { index, 0: all } of text.matchAll(/\n[ \t]*/g)) cuts.add(index).add(index + 1).add(index + all.length);
  const points = [...cuts].sort((a, b) => a - b);
  const lines = [make("span", { class: "line" })];
  let next = 0;
  for (let at = 0; at + 1 < points.length; at++) {
    const [start, end] = [points[at], points[at + 1]];
    if (text[start] === "\n") {
      lines.push(make("span", { class: "line" }));
      continue;
    }
    while (next < colored.length && colored[next][1] <= start) next++;
    const inside = next < colored.length && colored[next][0] <= start;
    let piece = text.slice(start, end);
    if (inside) piece = make("span", { class: colored[next][2] }, piece);
    const hot = text.slice(start, end).trim() && spans.some(([from, to]) => from <= start && end <= to);
    if (hot) lines.at(-1).classList.add("hot");
    lines.at(-1).append(hot ? make("mark", {}, piece) : piece);
  }
  return lines;
}

// Lines and columns, counted from 1, as places in the text.
function spansOf(text, places) {
  const starts = [0];
  for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) starts.push(at + 1);
  const offset = (lineNumber, column) => (starts[lineNumber - 1] ?? text.length) + column - 1;
  return places.map(([from, first, to, last]) => [offset(from, first), offset(to, last)]);
}

// To the marked expression, or to main(): what stands above it are declarations.
function scrollToPoint(pane) {
  const marks = [...pane.querySelectorAll("mark")], line = marks.length && marks[0].parentElement;
  const begin = marks[0] || [...pane.children].find(({ textContent }) => textContent.startsWith("void main("));
  const from = pane.getBoundingClientRect();
  pane.scrollTo(0, 0);
  if (!begin) return;
  const to = begin.getBoundingClientRect();
  pane.scrollTop = to.top - from.top - (line ? 0.35 * pane.clientHeight : 20);
  if (!line) return;
  // Only as far as needed, so that the beginning of the line stays where it fits.
  const end = marks.filter((mark) => mark.parentElement === line).at(-1).getBoundingClientRect().right;
  if (end > from.right) pane.scrollLeft = Math.min(end - from.right + 30, to.left - from.left - 70);
}

function showCode(pane, hash, spans) {
  const text = texts[hash];
  if (text === undefined) pane.replaceChildren(make("span", { class: "line" }, "This text is missing."));
  else pane.replaceChildren(...codeLines(text, spans(text)));
  scrollToPoint(pane);
}

// A tab for each of the names; `select` is called with the name that is chosen, as `first` is now.
function showTabs(tabs, names, first, select) {
  const buttons = names.map((name) => make("button", { type: "button", role: "tab", "aria-selected": "false" }, name));
  const press = (at) => {
    buttons.forEach((button, place) => {
      button.setAttribute("aria-selected", String(place === at));
      button.tabIndex = place === at ? 0 : -1;
    });
    select(names[at]);
  };
  buttons.forEach((button, at) => {
    button.addEventListener("click", () => press(at));
    button.addEventListener("keydown", ({ key }) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[key];
      if (!step) return;
      const to = (at + step + names.length) % names.length;
      press(to);
      buttons[to].focus();
    });
  });
  tabs.replaceChildren(...buttons);
  if (names.length) press(Math.max(0, names.indexOf(first)));
}
