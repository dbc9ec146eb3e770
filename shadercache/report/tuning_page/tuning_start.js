"use strict";
// Headings, the machine, the method, and the first drawing of everything.

function showHead() {
  const { environment: where, size, budget } = tuning;
  byId("title").textContent = tuning.scene;
  byId("subtitle").textContent = [tuning.title, `${size.join(" × ")} pixels on ${where.gl.renderer}`]
    .filter((text) => text && text !== tuning.scene).join(" · ");
  byId("summary").replaceChildren(...[page.headline, page.coverage].map((text) => make("p", {}, ...marked(text))));
  const limits = page.verdicts.map(({ limit }) => limit).join(", ");
  definitions(byId("facts"), [
    ["original", ms(1e3 * tuning.original)], ["asked for", `${metricWords} ${limits}`],
    ["time spent", `${budget.spent.toFixed(0)} of ${budget.seconds.toFixed(0)} s`],
    ["fitted", `${fittedFamilies.length} combinations`], ["at full length", String(tuning.finalists.length)],
    ["on unseen frames", String(tuning.proven.length)],
  ]);
}

function showMethod() {
  const { environment: where, size, budget, metric } = tuning;
  definitions(byId("machine"), [
    ["renderer", where.gl.renderer], ["driver", `${where.gl.vendor}, ${where.gl.version}`],
    ["processor", `${where.cpu}, ${where.cores} cores`], ["system", where.system], ["tuned", where.date.replace("T", " ")],
    ...tuning.groups.map(({ fragment, objects, hits }) => [fragment,
      `${short(objects.join(", "), 120)}${hits ? `; ${percent(hits.mu.value, 1)} of what is seen was seen in the frame before` : ""}`]),
  ]);
  byId("left-out").replaceChildren(...page.leftOut.map((text) => make("li", {}, ...marked(text))));
  byId("left-out-title").hidden = !page.leftOut.length;
  byId("repeat-all").textContent = ["shadercache tune", ...page.scene,
    `--max-error ${tuning.bounds.join(",")}`, ...(metric === "rmse" ? [] : [`--metric ${metric}`]),
    `--size ${size.join("x")}`, `--budget ${budget.seconds}s`, "--page page.html"].join(" ");
  byId("made").textContent = `Made by shadercache ${page.version}, ${page.made}.`;
}

// The answer that gains the most, or the largest bound where nothing does.
function firstBound() {
  const gains = tuning.answers.map(({ proven: number }) => (number === null ? 0 : tuning.proven[number].speedup.median));
  const most = Math.max(...gains);
  return page.verdicts[most > 0 ? gains.indexOf(most) : gains.length - 1].error;
}

showHead();
showMethod();
setUpVerdicts();
setUpBound();
setUpTuningPlane();
setUpChosen();
setUpValues();
soon(drawTuningPlane);
choice.chooseBound(firstBound());
theme.listeners.push(() => soon(drawTuningPlane));

let width = innerWidth;
addEventListener("resize", () => {
  // Labels are placed for a width; a phone's address bar changes only the height.
  if (innerWidth === width) return;
  width = innerWidth;
  requestAnimationFrame(() => soon(drawTuningPlane));
});
