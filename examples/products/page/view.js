// The canvas: the model, its light and the camera.

import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, DynamicDrawUsage, HemisphereLight,
  Mesh, MeshStandardMaterial, PerspectiveCamera, RepeatWrapping, Scene, SRGBColorSpace, TextureLoader, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const clay = new Color("#d2cdc4");

// From no error to the greatest.
export const errorColors = ["#35518f", "#2a8a93", "#5ab871", "#dcc83b", "#e8602c"];

// Edges of triangles as thin lines upon the surface, and errors as colours.
function extendShader(shader, uniforms) {
  Object.assign(shader.uniforms, uniforms);
  shader.vertexShader = shader.vertexShader
    .replace("#include <common>", `#include <common>
      attribute float error;
      varying float vError;
      varying vec3 vCorner;`)
    .replace("#include <begin_vertex>", `#include <begin_vertex>
      vError = error;
      int k = gl_VertexID % 3;
      vCorner = vec3(k == 0, k == 1, k == 2);`);
  shader.fragmentShader = shader.fragmentShader
    .replace("#include <common>", `#include <common>
      uniform float errorScale;
      uniform vec3 errorColors[5];
      uniform bool showsErrors;
      uniform bool showsEdges;
      uniform vec3 edgeColor;
      varying float vError;
      varying vec3 vCorner;
      vec3 colorOfError(float x) {
        float s = clamp(x, 0., 1.) * 4.;
        int i = min(int(s), 3);
        return mix(errorColors[i], errorColors[i + 1], s - float(i));
      }`)
    .replace("#include <color_fragment>", `#include <color_fragment>
      if (showsErrors) diffuseColor.rgb = colorOfError(vError * errorScale);`)
    .replace("#include <opaque_fragment>", `
      if (showsEdges) {
        vec3 distances = vCorner / max(fwidth(vCorner), vec3(1e-6));
        float nearest = min(min(distances.x, distances.y), distances.z);
        outgoingLight = mix(edgeColor, outgoingLight, mix(.3, 1., smoothstep(.2, 1.2, nearest)));
      }
      #include <opaque_fragment>`);
}

export class View {
  constructor(canvas, corners, { whenDrawn, whenTouched }) {
    this.corners = corners;
    this.whenDrawn = whenDrawn;
    this.whenTouched = whenTouched;
    this.uniforms = {
      errorScale: { value: 1 },
      errorColors: { value: errorColors.map((color) => new Color(color)) },
      showsErrors: { value: false },
      showsEdges: { value: false },
      edgeColor: { value: new Color("#1a212c") },
    };
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.camera = new PerspectiveCamera(32, 1, 1, 10);
    this.scene = new Scene();
    this.addLights();
    this.addMesh();
    this.turnUp("y");
    this.isDirty = true;
    this.renderer.setAnimationLoop(() => this.frame());
  }

  // They go with the camera, so that what one looks at is lit from above on the left.
  addLights() {
    const key = new DirectionalLight("#fff6ea", 2.5), fill = new DirectionalLight("#dfeaff", 0.7);
    key.position.set(-1.1, 1.5, 1.6);
    fill.position.set(1.7, 0.1, 0.9);
    this.camera.add(key, fill, key.target, fill.target);
    this.scene.add(this.camera, new HemisphereLight("#f4f7ff", "#8d8273", 0.85), new AmbientLight("#ffffff", 0.15));
  }

  addMesh() {
    const { positions, normals, errors, colors, coordinates } = this.corners;
    this.geometry = new BufferGeometry();
    const add = (name, array, size) =>
      array && this.geometry.setAttribute(name, new BufferAttribute(array, size).setUsage(DynamicDrawUsage));
    add("position", positions, 3);
    add("normal", normals, 3);
    add("error", errors, 1);
    add("color", colors, 3);
    add("uv", coordinates, 2);
    this.mesh = new Mesh(this.geometry, []);
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  // Of {color, image, cutoff}, as a page holds them. Images are data URIs.
  setMaterials(recorded, images) {
    const textures = images.map((image) => {
      const texture = new TextureLoader().load(image, () => (this.isDirty = true));
      texture.wrapS = texture.wrapT = RepeatWrapping;
      texture.flipY = false;
      texture.colorSpace = SRGBColorSpace;
      texture.anisotropy = 4;
      return texture;
    });
    this.recorded = recorded.map(({ color, image, cutoff }) => ({
      color: new Color().setRGB(...color), map: image === undefined || !this.corners.coordinates ? null : textures[image], alphaTest: cutoff ?? 0,
    }));
    this.mesh.material = recorded.map(() => {
      const material = new MeshStandardMaterial({ side: DoubleSide, roughness: 0.55, metalness: 0 });
      material.onBeforeCompile = (shader) => extendShader(shader, this.uniforms);
      return material;
    });
  }

  // The canvas draws nothing any more.
  dispose() {
    this.renderer.setAnimationLoop(null);
    this.controls.dispose();
    this.geometry.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  // "plain", "color" or "error".
  show(coloring) {
    this.uniforms.showsErrors.value = coloring === "error";
    this.mesh.material.forEach((material, i) => {
      const own = coloring === "color" ? this.recorded[i] : { color: clay, map: null, alphaTest: 0 };
      material.color.copy(own.color);
      material.map = own.map;
      material.alphaTest = own.alphaTest;
      material.vertexColors = coloring === "color" && this.corners.colors !== null;
      material.needsUpdate = true;
    });
    this.isDirty = true;
  }

  showEdges(areShown) {
    this.uniforms.showsEdges.value = areShown;
    this.isDirty = true;
  }

  // Draws the level that the corners are at, with errors from 0 to `greatest` as colours.
  update(faces, greatest) {
    for (const attribute of Object.values(this.geometry.attributes)) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, 3 * faces * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    this.geometry.clearGroups();
    for (const { material, start, count } of this.corners.groups) this.geometry.addGroup(start, count, material);
    this.geometry.setDrawRange(0, 3 * faces);
    this.uniforms.errorScale.value = greatest > 0 ? 1 / greatest : 0;
    this.isDirty = true;
  }

  // Which axis of the model points up. The camera looks from in front, a little from above.
  turnUp(axis) {
    const direction = { x: [0.28, 0.55, 1], y: [0.55, 0.28, 1], z: [0.55, -1, 0.32] }[axis];
    this.camera.up.set(Number(axis === "x"), Number(axis === "y"), Number(axis === "z"));
    this.size = this.sizeAround("xyz".indexOf(axis));
    this.camera.position.set(...direction);
    this.setControls();
    this.fit();
  }

  // They read the camera's axis once.
  setControls() {
    const autoRotate = this.controls?.autoRotate ?? false;
    this.controls?.dispose();
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    Object.assign(this.controls, { enableDamping: true, autoRotate, autoRotateSpeed: 1.4 });
    this.controls.addEventListener("change", () => (this.isDirty = true));
    this.controls.addEventListener("start", () => this.whenTouched());
  }

  // Lets the model fill the part of the canvas that nothing covers: {top, bottom} are covered pixels.
  resize(covered) {
    this.covered = covered;
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, 0, (covered.bottom - covered.top) / 2, width, height);
    this.fit();
  }

  // The cylinder around an axis through the centre of the box that holds the finest level.
  sizeAround(up) {
    const { values, width } = this.corners.levels.vertices;
    let height = 0, radius = 0;
    for (let at = 0; at < values.length; at += width) {
      height = Math.max(height, Math.abs(values[at + up]));
      radius = Math.max(radius, Math.hypot(values[at + ((up + 1) % 3)], values[at + ((up + 2) % 3)]));
    }
    return { height, radius };
  }

  // However the model turns around its axis, it stays in the picture.
  fit() {
    if (!this.covered) return;
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    const free = Math.max(height - this.covered.top - this.covered.bottom, height / 4);
    const slope = Math.tan((this.camera.fov / 2) * (Math.PI / 180));
    const offset = this.camera.position.clone().sub(this.controls.target).normalize();
    const sine = Math.abs(offset.dot(this.camera.up)), cosine = Math.sqrt(1 - sine * sine);
    const { height: h, radius: r } = this.size;
    const across = r / (slope * (width / height)), along = (h * cosine + r * sine) / (slope * (free / height));
    const distance = Math.max(1.06 * Math.max(across, along) + 0.35 * r, 0.1);
    this.camera.near = distance / 200;
    this.camera.far = distance * 12;
    this.camera.position.copy(this.controls.target).addScaledVector(offset, distance);
    this.controls.minDistance = distance / 30;
    this.controls.maxDistance = distance * 5;
    this.camera.updateProjectionMatrix();
    this.isDirty = true;
  }

  // Turns the model, by angles to the left and up.
  turn(left, up) {
    this.controls.rotateLeft(left);
    this.controls.rotateUp(up);
  }
  zoom(factor) {
    this.controls.dollyIn(factor);
  }

  frame() {
    this.controls.update();
    if (!this.isDirty) return;
    this.isDirty = false;
    this.renderer.render(this.scene, this.camera);
    this.whenDrawn(this.renderer.info.render.triangles);
  }
}
