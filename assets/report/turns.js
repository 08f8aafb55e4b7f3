// Pictures are drawn in turns: each after the one before is on the screen, so that the page answers in between.

let newest = 0;

// Draws these, the first at once. Whatever waits of an earlier call is not drawn any more.
export function drawInTurns(acts) {
  newest += 1;
  const own = newest;
  document.body.dataset.drawn = "some";
  const next = ([first, ...rest]) => {
    if (own !== newest) return;
    if (first) {
      first();
      requestAnimationFrame(() => setTimeout(next, 0, rest));
    } else {
      document.body.dataset.drawn = "all";
    }
  };
  next(acts);
}

export function drawAtOnce(acts) {
  newest += 1;
  acts.forEach((act) => act());
  document.body.dataset.drawn = "all";
}
