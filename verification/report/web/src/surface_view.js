// SPDX-License-Identifier: GPL-3.0-or-later
import {
  AmbientLight, BackSide, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, FrontSide, LineBasicMaterial,
  Group, LineSegments, Mesh, MeshLambertMaterial, PerspectiveCamera, Points, PointsMaterial, Scene, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { element, prose, table } from "./dom.js";
import { pictures, report } from "./data.js";
import { about, toPower } from "./number_text.js";

function floats(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

// Viridis at nine places: even to the eye, and readable without colour vision.
const viridis = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"].map((text) => new Color(text));

function colourAt(share) {
  const place = Math.min(Math.max(share, 0), 1) * (viridis.length - 1);
  const below = Math.min(Math.floor(place), viridis.length - 2);
  return viridis[below].clone().lerp(viridis[below + 1], place - below);
}

function range(values) {
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return { least, most, share: (value) => (most > least ? (value - least) / (most - least) : 0.5) };
}

function painted(values) {
  const { share } = range(values);
  const colours = new Float32Array(3 * values.length);
  values.forEach((value, i) => colourAt(share(value)).toArray(colours, 3 * i));
  return new BufferAttribute(colours, 3);
}

function scale(values, words) {
  const { least, most } = range(values);
  return element("p", { class: "scale" }, `${words}: ${about(least, 4)} `,
    element("span", { class: "ramp", "aria-hidden": "true" }), ` ${about(most, 4)}`);
}

/** Leaves out what belongs to walls that turn their back to the eye: `facing` is the inner normal of the wall. */
function onFacingWalls(material) {
  const before = material.onBeforeCompile;
  material.onBeforeCompile = (shader, renderer) => {
    before.call(material, shader, renderer);
    shader.vertexShader = shader.vertexShader
      .replace("void main() {", "attribute vec3 facing;\nvarying float seen;\nvoid main() {")
      .replace("#include <project_vertex>", `#include <project_vertex>
      seen = dot(facing, cameraPosition - (modelMatrix * vec4(position, 1.0)).xyz);`);
    shader.fragmentShader = shader.fragmentShader
      .replace("void main() {", "varying float seen;\nvoid main() {")
      .replace("#include <clipping_planes_fragment>", `#include <clipping_planes_fragment>
      if (seen < 0.0) discard;`);
  };
  return material;
}

/** The inner normals of the elements, from their corners, which run counterclockwise as these see them. */
function innerNormals(corners) {
  const normals = [];
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  for (let k = 0; k < corners.length; k += 9) {
    a.fromArray(corners, k);
    b.fromArray(corners, k + 3).sub(a);
    c.fromArray(corners, k + 6).sub(a);
    normals.push(b.clone().cross(c).normalize());
  }
  return normals;
}

/** The sides of all elements, each with the normal of its own. */
function sides(corners, normals) {
  const [places, facing] = [[], []];
  normals.forEach((normal, element) => {
    for (const corner of [0, 1, 1, 2, 2, 0]) {
      places.push(...corners.subarray(9 * element + 3 * corner, 9 * element + 3 * corner + 3));
      facing.push(normal.x, normal.y, normal.z);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places), 3));
  geometry.setAttribute("facing", new BufferAttribute(new Float32Array(facing), 3));
  return geometry;
}

/** How far from the centre a camera must stand that looks along -`from` for all corners to be in its picture. */
function distanceFor(corners, center, from, up, halfHeight, aspect) {
  const right = new Vector3().crossVectors(up, from).normalize();
  const above = new Vector3().crossVectors(from, right);
  const [place, halfWidth] = [new Vector3(), halfHeight * aspect];
  let distance = 0;
  for (let k = 0; k < corners.length; k += 3) {
    place.fromArray(corners, k).sub(center);
    distance = Math.max(distance, place.dot(from) + Math.max(Math.abs(place.dot(right)) / halfWidth, Math.abs(place.dot(above)) / halfHeight));
  }
  return distance;
}

// Round points, nearer to the eye than they are by so much: the wall on which they lie does not cover half of each.
function disks(geometry, looks, nearer) {
  const material = new PointsMaterial({ ...looks, transparent: true });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace("#include <project_vertex>", `#include <project_vertex>
      vec4 before = projectionMatrix * (mvPosition + vec4(0.0, 0.0, ${toPower(nearer, 17)}, 0.0));
      gl_Position.z = before.z / before.w * gl_Position.w;`);
    shader.fragmentShader = shader.fragmentShader.replace("#include <clipping_planes_fragment>", `#include <clipping_planes_fragment>
      if (length(gl_PointCoord - 0.5) > 0.5) discard;`);
  };
  material.customProgramCacheKey = () => String(nearer);
  const points = new Points(geometry, onFacingWalls(material));
  points.renderOrder = looks.vertexColors ? 2 : 1;
  return points;
}

/** The surface of a problem at one level, to turn (drag, arrow keys) and zoom (wheel, + and -). */
export function surfaceView(index) {
  const problem = report.problems[index];
  const picture = pictures[index];
  const corners = floats(picture.corners);
  const nodes = floats(picture.nodes);
  const colourings = [{ name: "radiosity", corner: floats(picture.corner_values), node: floats(picture.node_values) }];
  if (picture.node_errors) colourings.push({ name: "error", corner: floats(picture.corner_errors), node: floats(picture.node_errors) });

  const canvas = element("canvas", { tabindex: "0", role: "img", "aria-label": `${problem.name}: triangulation and radiosity in space; drag to turn, arrow keys turn, plus and minus zoom` });
  const holder = element("div", { class: "space" }, canvas);
  const legend = element("div");
  const controls = element("div", { class: "filters" });
  const page = [element("h1", {}, prose(problem.name)),
    element("p", { class: "quiet" }, `Level ${picture.level}, ${corners.length / 9} elements, ${nodes.length / 3} nodes. Curved elements are drawn flat.`),
    controls, holder, legend,
    element("details", {}, element("summary", {}, "The problem file"), element("pre", {}, problem.problem)),
    element("details", {}, element("summary", {}, "Its levels"), table(`Levels of ${problem.name}`, ["level", "elements", "unknowns", "h"],
      problem.levels.map((level) => [level.level, level.elements, level.unknowns, about(level.mesh_size, 4)].map(String))))];

  let renderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
  } catch {
    holder.replaceChildren(element("p", { class: "note" }, "This browser offers no WebGL: the view in space is not shown."));
    return page;
  }

  const scene = new Scene();
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  geometry.computeBoundingSphere();
  const { center, radius } = geometry.boundingSphere;
  // Corners run counterclockwise as the inner normal sees them. Walls are solid from inside; those between the eye and the
  // inside are cut away, and a breath of them is left.
  const normals = innerNormals(corners);
  const skin = new Mesh(geometry, new MeshLambertMaterial({ vertexColors: true, side: FrontSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
  const ghost = new Mesh(geometry, new MeshLambertMaterial({ vertexColors: true, side: BackSide, transparent: true, opacity: 0.14, depthWrite: false }));
  ghost.renderOrder = 3;
  const lines = sides(corners, normals);
  const edges = new LineSegments(lines, onFacingWalls(new LineBasicMaterial({ color: 0x222222, transparent: true, opacity: 0.55 })));
  const dots = new BufferGeometry();
  dots.setAttribute("position", new BufferAttribute(nodes, 3));
  const ofNodes = new Float32Array(nodes.length);
  // A node has the normal of its element: elements have equally many nodes, in their order; meshless sites have none.
  const each = nodes.length / 3 / normals.length;
  if (Number.isInteger(each)) normals.forEach((normal, k) => { for (let j = 0; j < each; ++j) normal.toArray(ofNodes, 3 * (each * k + j)); });
  dots.setAttribute("facing", new BufferAttribute(ofNodes, 3));
  const points = new Group();
  points.add(disks(dots, { size: radius / 18, color: 0x222222 }, radius / 30), disks(dots, { size: radius / 26, vertexColors: true }, radius / 26));
  scene.add(skin, ghost, edges, points, new AmbientLight(0xffffff, 2.2));
  const lamp = new DirectionalLight(0xffffff, 1.2);
  const camera = new PerspectiveCamera(38, 1, radius / 100, radius * 20);
  camera.up.set(0, 0, 1);
  const from = new Vector3(1.5, -2.2, 1.3).normalize();
  const margin = 1.06;
  const halfHeight = Math.tan((camera.fov * Math.PI) / 360);
  camera.add(lamp);
  scene.add(camera);

  const orbit = new OrbitControls(camera, canvas);
  orbit.target.copy(center);
  orbit.update();
  const render = () => renderer.render(scene, camera);
  orbit.addEventListener("change", render);
  canvas.addEventListener("keydown", (event) => {
    const offset = camera.position.clone().sub(center);
    const turn = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.12], ArrowDown: [0, -0.12] }[event.key];
    const zoom = { "+": 0.88, "=": 0.88, "-": 1.14 }[event.key];
    if (!turn && !zoom) return;
    event.preventDefault();
    if (zoom) offset.multiplyScalar(zoom);
    if (turn) {
      offset.applyAxisAngle(camera.up, turn[0]);
      const side = new Vector3().crossVectors(offset, camera.up).normalize();
      const lifted = offset.clone().applyAxisAngle(side, turn[1]);
      if (Math.abs(lifted.clone().normalize().z) < 0.98) offset.copy(lifted);
    }
    camera.position.copy(center).add(offset);
    orbit.update();
    render();
  });

  const paint = (colouring) => {
    geometry.setAttribute("color", painted(colouring.corner));
    dots.setAttribute("color", painted(colouring.node));
    legend.replaceChildren(scale(colouring.node, colouring.name === "error" ? "|u − uₙ| at the nodes" : "uₙ at the nodes"));
    render();
  };
  let placed = false;
  const fit = () => {
    const width = Math.max(280, holder.clientWidth);
    const height = Math.max(280, Math.min(width, 0.78 * innerHeight));
    renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    renderer.setSize(width, height, true);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    if (!placed) {
      camera.position.copy(center).addScaledVector(from, margin * distanceFor(corners, center, from, camera.up, halfHeight, camera.aspect));
      orbit.update();
      placed = true;
    }
    render();
  };
  const toggle = (words, object) => {
    const box = element("input", { type: "checkbox", checked: true, onchange: () => { object.visible = box.checked; render(); } });
    return element("label", {}, box, ` ${words}`);
  };
  const backs = element("input", { type: "checkbox", onchange: () => {
    skin.material.side = backs.checked ? DoubleSide : FrontSide;
    ghost.visible = !backs.checked;
    skin.material.needsUpdate = true;
    render();
  } });
  const opacity = element("input", { type: "range", min: "0.15", max: "1", step: "0.05", value: "1", oninput: () => {
    skin.material.opacity = Number(opacity.value);
    skin.material.transparent = skin.material.opacity < 1;
    skin.material.needsUpdate = true;
    render();
  } });
  controls.append(
    ...colourings.map((colouring, i) => element("label", {},
      element("input", { type: "radio", name: "colouring", checked: i === 0, onchange: () => paint(colouring) }), ` ${colouring.name}`)),
    toggle("triangulation", edges), toggle("nodes", points), element("label", {}, backs, " walls from outside"), element("label", {}, "solid ", opacity));
  requestAnimationFrame(() => { fit(); paint(colourings[0]); });
  new ResizeObserver(fit).observe(holder);
  return page;
}
