// The data of the page, as the program wrote them, and the decoding of their lists of numbers.

export const contents = JSON.parse(document.getElementById("contents").textContent);

function bytes(text) {
  const raw = atob(text);
  const decoded = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) decoded[i] = raw.charCodeAt(i);
  return decoded.buffer;
}

export const floats = (text) => new Float32Array(bytes(text));
export const integers = (text) => new Int32Array(bytes(text));
export const shorts = (text) => new Uint16Array(bytes(text));
