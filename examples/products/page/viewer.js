// The viewer: its controls, and the level that they ask for. The header of a model has
//   name, inputFaces, notes    what is told of the file, and what is not shown
//   faces, width, places       of the finest level; the numbers of a vertex, where its colour and its
//                              texture coordinates are among them (0: it has none)
//   isColored, materials, images
//   center, unit               of the box, and half of its diagonal: positions are from the one in the other
//   arrays                     see levels.js
//
// The part of the address behind # sets it up: #faces=500&color=error&wireframe=1&turn=0&up=z

import { Corners } from "./corners.js";
import { Levels } from "./levels.js";
import { errorColors, View } from "./view.js";

const element = (id) => document.getElementById(id);
const textOfCount = (count) => count.toLocaleString("en");
const textOfPercent = (part) => `${Number((100 * part).toPrecision(3)).toLocaleString("en", { maximumFractionDigits: 9 })} %`;

const steps = Number(element("level").max);

let header, levels, finest, coarsest, colorings, view, corners; // of the model
let wanted = 0; // contractions of the level that is to be shown
let shown = -1;

// The slider goes by the logarithm of the number of faces.
function facesOfSlider(step) {
  return Math.round(Math.exp(Math.log(coarsest) + (step / steps) * (Math.log(finest) - Math.log(coarsest))));
}
function sliderOfFaces(faces) {
  if (finest === coarsest) return steps;
  return Math.round((steps * Math.log(faces / coarsest)) / Math.log(finest / coarsest));
}

function ask(faces) {
  wanted = levels.find(Math.min(Math.max(faces, coarsest), finest));
}

function greatestError(faces) {
  let greatest = 0;
  for (let corner = 0; corner < 3 * faces; ++corner) greatest = Math.max(greatest, corners.errors[corner]);
  return greatest;
}

function tell(faces, greatest) {
  const vertices = levels.verticesAt(wanted);
  const share = textOfPercent(faces / header.inputFaces);
  element("facts").textContent =
    `${textOfCount(faces)} ${faces === 1 ? "face" : "faces"} (${share} of ${textOfCount(header.inputFaces)}) · ${textOfCount(vertices)} vertices`;
  element("error").textContent = `error ${textOfPercent(levels.errorAt(wanted))} of the diagonal`;
  element("greatest").textContent = textOfPercent(greatest);
  element("level").setAttribute("aria-valuetext", `${textOfCount(faces)} faces`);
  if (document.activeElement !== element("count")) element("count").value = faces;
  if (document.activeElement !== element("level")) element("level").value = sliderOfFaces(faces);
}

// Once for each picture at most, however fast the slider moves.
function showWanted() {
  requestAnimationFrame(showWanted);
  if (shown === wanted) return;
  shown = wanted;
  const faces = corners.goTo(wanted);
  const greatest = greatestError(faces);
  view.update(faces, greatest);
  tell(faces, greatest);
}

// In a wide window the header stands beside the model, not above it.
function layOut() {
  const header = document.querySelector("header").getBoundingClientRect();
  const panel = element("panel").getBoundingClientRect();
  view.resize({ top: innerWidth < 900 ? header.bottom : 20, bottom: innerHeight - panel.top });
}

function setPressed(id, isPressed) {
  element(id).setAttribute("aria-pressed", isPressed);
}
function showEdges(areShown) {
  setPressed("edges", areShown);
  view.showEdges(areShown);
}
function turnByItself(does) {
  setPressed("rotation", does);
  view.controls.autoRotate = does;
}
function turnUp(axis) {
  element("up").querySelector("span").textContent = axis.toUpperCase();
  view.turnUp(axis);
}
function color(by) {
  for (const radio of document.getElementsByName("coloring")) radio.checked = radio.value === by;
  element("legend").hidden = by !== "error";
  view.show(by);
  layOut();
}

function addColorings() {
  colorings = [["plain", "Plain"], ...(header.isColored ? [["color", "Colours"]] : []), ["error", "Error"]];
  element("colorings").replaceChildren();
  for (const [value, name] of colorings) {
    const label = document.createElement("label"), radio = document.createElement("input");
    Object.assign(radio, { type: "radio", name: "coloring", value });
    radio.addEventListener("change", () => color(value));
    label.append(radio, name);
    element("colorings").append(label);
  }
}

function addNotes() {
  element("notes").replaceChildren();
  const cap = `To keep the page small, its finest level has ${textOfCount(finest)} of the ${textOfCount(header.inputFaces)} faces of the file.`;
  for (const note of finest < header.inputFaces ? [cap, ...header.notes] : header.notes) {
    const item = document.createElement("li");
    item.textContent = note;
    element("notes").append(item);
  }
}

const turns = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
const sizes = { "+": 1.1, "=": 1.1, "-": 1 / 1.1 };
function useKey(event) {
  if (event.target !== element("model") || event.ctrlKey || event.metaKey || event.altKey) return;
  if (turns[event.key]) view.turn(...turns[event.key]);
  else if (sizes[event.key]) view.zoom(sizes[event.key]);
  else return;
  event.preventDefault();
  turnByItself(false);
}

function listen() {
  const pressed = (id) => element(id).getAttribute("aria-pressed") === "true";
  element("level").addEventListener("input", (event) => ask(facesOfSlider(Number(event.target.value))));
  element("count").addEventListener("input", (event) => event.target.value && ask(Number(event.target.value)));
  element("count").addEventListener("blur", () => (element("count").value = levels.facesAt(wanted)));
  element("edges").addEventListener("click", () => showEdges(!pressed("edges")));
  element("rotation").addEventListener("click", () => turnByItself(!pressed("rotation")));
  element("up").addEventListener("click", () => {
    const axis = element("up").querySelector("span").textContent;
    turnUp({ Y: "z", Z: "x", X: "y" }[axis]);
  });
  addEventListener("keydown", useKey);
  addEventListener("resize", layOut);
  addEventListener("hashchange", setUp);
}

// By the address.
function setUp() {
  const asked = new URLSearchParams(location.hash.slice(1));
  const isCalm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const one = (name, values, byDefault) => (values.includes(asked.get(name)) ? asked.get(name) : byDefault);
  turnUp(one("up", ["x", "y", "z"], "y"));
  color(one("color", colorings.map(([value]) => value), header.isColored ? "color" : "plain"));
  showEdges(one("wireframe", ["0", "1"], "0") === "1");
  turnByItself(one("turn", ["0", "1"], isCalm ? "0" : "1") === "1");
  ask(Number(asked.get("faces")) || finest);
}

// A canvas that another model was drawn on is taken away with all that belongs to it.
function makeView() {
  if (view) {
    view.dispose();
    const canvas = element("model").cloneNode();
    delete canvas.dataset.triangles;
    element("model").replaceWith(canvas);
  }
  view = new View(element("model"), corners, {
    whenDrawn: (triangles) => (element("model").dataset.triangles = triangles),
    whenTouched: () => turnByItself(false),
  });
}

/** Shows a model, by its header and the bytes of its arrays, instead of one that was shown before. */
export function show(newHeader, bytes) {
  const isFirst = !view;
  header = newHeader;
  levels = new Levels(header, bytes);
  finest = levels.facesAt(0);
  coarsest = levels.facesAt(levels.contractions);
  element("name").textContent = header.name;
  element("ramp").style.background = `linear-gradient(to right, ${errorColors})`;
  Object.assign(element("count"), { min: coarsest, max: finest });
  element("level").disabled = element("count").disabled = finest === coarsest;
  addNotes();
  addColorings();
  corners = new Corners(levels, header.places);
  shown = -1;
  makeView();
  view.setMaterials(header.materials, header.images);
  if (isFirst) listen();
  setUp();
  if (isFirst) showWanted();
}

/** How many faces the level has that is shown; or asks for one of so many. */
export const facesShown = () => levels.facesAt(wanted);
export const showFaces = ask;
