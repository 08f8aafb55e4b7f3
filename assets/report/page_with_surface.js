// The page of a sweep that has a surface too. The build of the program starts here.

import { addLive } from "./live.js";
import { beginSweep } from "./sweep_page.js";

addLive();
beginSweep();
