"use strict";
// The pictures of the chosen row.

const ABSENCES = {
  cached: "there is no such picture", difference: "it takes two pictures of one size",
  hits: "this has no cache", age: "kept by sweeps with --cache age=on", payload: "there is no such picture",
};

function showPictures() {
  const row = choice.row;
  showShot(row, row && row.kind === "peer" ? { cached: row.label } : {}, absenceOf(row));
}

function absenceOf(row) {
  if (!row || row.failure) return ["There is no picture: this configuration has no result."];
  const small = page.pictures[row.thumbnail];
  const text = row.layers
    ? "The store holds no pictures of this configuration."
    : "The pictures of this configuration were left out, so that the page stays below 12 MB. "
      + "Those on the fronts, the peers and the fastest of each value come first.";
  return [text, ...(small ? [make("img", { src: small, alt: "The cached frame, small" })] : [])];
}

function setUpPictures() {
  setUpViewer(ABSENCES);
  choice.listeners.row.push(showPictures);
}
