"use strict";
// The shader with the cached expression marked, and the files of the variant beside it.

async function showSource() {
  const row = choice.row;
  if (!row) return;
  if (texts === null) await unpackTexts();
  if (row !== choice.row) return; // another was chosen while the texts were unpacked
  const names = Object.keys(row.texts), own = names.filter((name) => name.startsWith("source"));
  const node = row.node == null ? null : choice.group.nodes[row.node];
  const fragment = own.find((name) => name.endsWith(".frag")) || own[0];
  byId("source-name").replaceChildren(make("span", {}, fragment || "no source"));
  if (fragment) showCode(byId("source"), row.texts[fragment], (text) => spansOf(text, node ? node.places : []));
  else byId("source").replaceChildren(make("span", { class: "line" }, "A peer has no shader of its own here."));
  showFiles(row, names.filter((name) => !own.includes(name)).concat(own.filter((name) => name !== fragment)));
}

function showFiles(row, names) {
  const pane = byId("emitted");
  if (!names.length) pane.replaceChildren(make("span", { class: "line" }, "There are no files: nothing was emitted."));
  showTabs(byId("emitted-tabs"), names, names.find((name) => name.endsWith(".frag")),
    (name) => showCode(pane, row.texts[name], () => []));
}

function setUpSource() {
  choice.listeners.row.push(() => soon(showSource));
}
