"use strict";
// Headings, the machine, and the first drawing of everything.

function showGroup() {
  const group = choice.group, { scene, machine } = group;
  byId("title").textContent = scene.name;
  byId("subtitle").textContent = `${scene.size.join(" × ")} pixels on ${machine.renderer}`;
  byId("summary").replaceChildren(...group.summary.map((text) => make("p", {}, ...marked(text))));
  const failed = group.rows.filter((row) => row.failure).length;
  const facts = [];
  if (group.original) {
    facts.push(["original", ms(group.original[0])],
      ["geometry alone", `${ms(group.geometry * group.original[0])}, ${percent(group.geometry)}`]);
  }
  facts.push(["variants", String(variantsOf(group).length)], ["cached values", String(group.nodes.length)],
    ["peers", String(peersOf(group).length)]);
  if (failed) facts.push(["without a result", String(failed)]);
  if (page.stale) facts.push(["stale, left out", `${page.stale} of the store`]);
  if (page.missing) facts.push(["pictures missing", String(page.missing)]);
  definitions(byId("facts"), facts);
  definitions(byId("machine"), [
    ["renderer", machine.renderer], ["driver", machine.driver], ["clock", machine.clock],
    ["processor", `${machine.processor}, ${machine.cores} cores`], ["system", machine.system],
    ["scene", `${scene.path}, ${scene.size.join(" × ")}, ${scene.frames} frames, mapping ${scene.mapping}`],
    ["measured", group.dates[0] === group.dates[1] ? group.dates[0] : `${group.dates.join(" to ")}`],
    ["shadercache", group.versions.join(", ")],
    ...(group.original ? [["original", `${ms(group.original[0])} in the middle of all trials, `
      + `from ${ms(group.original[1])} to ${ms(group.original[2])}`]] : []),
  ]);
}

function setUpGroups() {
  const select = byId("group");
  fillSelect(select, page.groups.map(({ name }, place) => [place, name]), 0);
  byId("group-control").hidden = page.groups.length < 2;
  select.addEventListener("change", () => choice.chooseGroup(Number(select.value)));
  choice.listeners.group.push(showGroup);
}

function redraw() {
  for (const task of [drawPlane, drawNodes, drawPeriods, drawCurves, showDetails]) soon(task);
}

setUpGroups();
setUpPickers();
setUpPictures();
setUpDetails();
setUpPlane();
setUpFigures();
setUpTable();
setUpSource();
choice.chooseGroup(0);
theme.listeners.push(redraw);

byId("repeat-note").replaceChildren(...marked(
  "A closer look at any configuration shows the command that measures it again. The page itself is made by"));
byId("repeat-all").textContent = `shadercache report ${page.store} -o page.html`;
byId("made").textContent = `Made by shadercache ${page.version}, ${page.made}, from ${page.store}.`;

let width = innerWidth;
addEventListener("resize", () => {
  // Labels are placed for a width; a phone's address bar changes only the height.
  if (innerWidth === width) return;
  width = innerWidth;
  requestAnimationFrame(redraw);
});
