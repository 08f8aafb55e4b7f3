// The page of a surface without a sweep. The build of the program starts here.

import { readAddress } from "./address.js";
import { addCopyButtons } from "./copying.js";
import { element } from "./elements.js";
import { addLive, beginLive } from "./live.js";
import { axesWords } from "./live_axes.js";
import { drawFirst, followLook } from "./pictures.js";

addLive();
readAddress();
addCopyButtons();
if (beginLive()) element("counts").textContent = axesWords();
followLook();
window.addEventListener("hashchange", readAddress);
drawFirst();
