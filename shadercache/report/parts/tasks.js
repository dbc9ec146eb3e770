"use strict";
// What takes long is done later, one after another, so that the page shows what it has meanwhile.
const waiting = new Set();
let running = false;

// A set: a plot that several listeners ask for is drawn once.
function soon(task) {
  if (!waiting.size && !running) setTimeout(nextTask);
  waiting.add(task);
}

async function nextTask() {
  const [task] = waiting;
  // Taken out before it runs: who asks for it meanwhile has something newer to show.
  waiting.delete(task);
  running = true;
  await task();
  running = false;
  if (waiting.size) setTimeout(nextTask);
  // The first time only: whoever opens the page by a script waits for this mark.
  else document.documentElement.dataset.drawn ||= String(Math.round(performance.now()));
}
