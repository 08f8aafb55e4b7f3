// The page of a sweep. The build of the program starts here.

import { beginSweep } from "./sweep_page.js";

beginSweep();
