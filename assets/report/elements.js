// Elements of the page: found by their ids, shown, hidden and filled.

export const element = (id) => document.getElementById(id);

export const show = (id, shown) => {
  element(id).hidden = !shown;
};

// Shows or hides a picture with what belongs to it.
export const showPicture = (id, shown) => {
  element(id).closest("figure").hidden = !shown;
};

// Shows these words; an element without words is hidden.
export function say(id, words) {
  element(id).textContent = words;
  show(id, words !== "");
}

// A new element with a text.
export function withText(tag, text) {
  const made = document.createElement(tag);
  made.textContent = text;
  return made;
}

// A new button that does something when it is clicked.
export function button(text, act) {
  const made = withText("button", text);
  made.type = "button";
  made.addEventListener("click", act);
  return made;
}
