// A page of the program: what it holds is shown by the viewer.

import { bytesOfBase64 } from "./levels.js";
import { show } from "./viewer.js";

const element = (id) => document.getElementById(id);

try {
  const bytes = bytesOfBase64(element("data").textContent);
  element("data").remove();
  show(JSON.parse(element("header").textContent), bytes);
} catch (error) {
  element("failure").textContent = `The model cannot be shown: ${error.message}`;
  element("failure").hidden = false;
  element("panel").hidden = true;
}
