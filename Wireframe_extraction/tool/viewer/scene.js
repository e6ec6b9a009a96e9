// The cloud, the stages and the curves in space.

import * as three from "three";
import {
  BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, PerspectiveCamera, Points, PointsMaterial,
  Scene, ShaderMaterial, Sphere, Vector2, Vector3, WebGLRenderer
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

import { channels } from "./colours.js";

const fewestPoints = 20000;                      // that are drawn however slow the computer is
const frameTime = { motion: 40, rest: 1500 };    // how long a frame may take, in milliseconds

const cloudVertexShader = `
  attribute vec4 sample_;
  uniform float size, range;
  uniform vec3 stops[5];
  varying vec3 colour;
  void main() {
    float position = 4.0 * min(sample_.w / range, 1.0);
    int first = int(min(floor(position), 3.0));
    colour = mix(stops[first], stops[first + 1], position - float(first));
    gl_Position = projectionMatrix * modelViewMatrix * vec4(sample_.xyz - 0.5, 1.0);
    gl_PointSize = size;
  }`;
const cloudFragmentShader = `
  varying vec3 colour;
  void main() {
    if (distance(gl_PointCoord, vec2(0.5)) > 0.5)
      discard;
    gl_FragColor = vec4(colour, 1.0);
  }`;

function roundPoints(options) {
  const material = new PointsMaterial({ sizeAttenuation: false, ...options });
  material.onBeforeCompile = shader => {
    shader.fragmentShader = shader.fragmentShader.replace("#include <clipping_planes_fragment>",
      "if (distance(gl_PointCoord, vec2(0.5)) > 0.5) discard;\n#include <clipping_planes_fragment>");
  };
  return material;
}

export class View {
  constructor(canvas, axes, data) {
    if (three.ColorManagement) // colours are shown as they are, and always were before three.js had this
      three.ColorManagement.enabled = false;
    this.canvas = canvas;
    this.axes = axes;
    this.data = data;
    const context = canvas.getContext("webgl2", { antialias: true, powerPreference: "default" });
    if (!context)
      throw new Error("there is no context for it");
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.outputColorSpace = three.LinearSRGBColorSpace;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new Scene();
    this.scene.background = new Color("#f6f8fb");
    this.camera = new PerspectiveCamera(32, 1, 0.001, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.enableKeys = false; // which older ones have for the whole page
    this.controls.minDistance = 1e-4;
    this.controls.maxDistance = 20;
    this.controls.addEventListener("change", () => this.onMove());
    this.objects = {};
    this.pointShare = 1;
    this.mostPoints = { motion: 200000, rest: 200000 };   // until it is known how quick the computer is
    this.addLayers();
    this.addCloud();
    this.addVertices();
    this.addCurves();
    this.resize();
    this.look("isometric");
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  // the cloud -------------------------------------------------------------------------------------

  addCloud() {
    const { samples } = this.data.cloud;
    const geometry = new BufferGeometry();
    const attribute = new BufferAttribute(samples, 4, true);
    geometry.setAttribute("sample_", attribute);
    geometry.setAttribute("position", attribute); // by which older ones count; the shader does not use it
    geometry.boundingSphere = new Sphere(new Vector3(), 1);
    this.numberOfPoints = samples.length / 4;
    this.cloudMaterial = new ShaderMaterial({
      vertexShader: cloudVertexShader,
      fragmentShader: cloudFragmentShader,
      uniforms: {
        size: { value: 2 },
        range: { value: 1 },
        stops: { value: this.data.field_colours.map(colour => new Vector3(...channels(colour))) }
      }
    });
    this.add("cloud", new Points(geometry, this.cloudMaterial));
    this.objects.cloud.visible = this.numberOfPoints > 0;
    this.setPointSize(2.5);
  }

  // Points come in random order: the first ones are an even thinning of all.
  setNumberOfPoints(count) {
    this.drawnPoints = Math.max(1, Math.round(count));
    this.objects.cloud.geometry.setDrawRange(0, this.drawnPoints);
  }

  setPointShare(share) {
    this.pointShare = share;
    this.setNumberOfPoints(this.pointsFor("rest"));
    this.draw();
  }

  // what is wanted, or what the computer is known to draw quickly enough
  pointsFor(state) {
    return Math.min(this.mostPoints[state], this.pointShare * this.numberOfPoints);
  }

  isThinned() {
    return this.drawnPoints + 1 < this.pointShare * this.numberOfPoints;
  }

  setPointSize(size) {
    this.cloudMaterial.uniforms.size.value = size * this.renderer.getPixelRatio();
    // those of edges would hide them
    for (const layer of this.data.layers)
      if (this.objects[layer.name] && layer.edges.length === 0)
        this.objects[layer.name].material.size = (size + 1.5) * this.renderer.getPixelRatio();
    this.draw();
  }

  setFieldRange(share) {
    this.cloudMaterial.uniforms.range.value = Math.max(share, 1e-6);
    this.draw();
  }

  // While the view moves, fewer points are drawn if all of them would take too long.
  onMove() {
    this.isMoving = true;
    this.setNumberOfPoints(this.pointsFor("motion"));
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.isMoving = false;
      this.refine();
    }, 250);
    this.draw();
  }

  // at rest, more and more points
  refine() {
    if (!this.isMoving && this.pointsFor("rest") > this.drawnPoints + 1) {
      this.setNumberOfPoints(this.pointsFor("rest"));
      this.draw();
    }
    this.onRefine?.();
  }

  // Learns from how long a frame took.
  learn(milliseconds, points) {
    const state = this.isMoving ? "motion" : "rest";
    if (milliseconds > frameTime[state])
      this.mostPoints[state] = Math.max(fewestPoints, this.isMoving ? points / 2 : points);
    else if (milliseconds < frameTime[state] / 2)
      this.mostPoints[state] = Math.max(this.mostPoints[state], 2 * points);
  }

  // Waits until the frame is drawn that was just sent; until then, no other one is sent.
  waitForFrame() {
    const gl = this.renderer.getContext();
    const begin = performance.now(), points = this.drawnPoints;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    this.isBusy = true;
    const look = () => {
      if (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) {
        setTimeout(look, 2);
        return;
      }
      gl.deleteSync(fence);
      this.isBusy = false;
      // the first frame also prepares all later ones
      if (this.hasDrawn && this.objects.cloud.visible)
        this.learn(performance.now() - begin, points);
      this.hasDrawn = true;
      if (this.isAsked)
        this.draw();
      else
        this.refine();
    };
    setTimeout(look, 1);
  }

  // the stages ------------------------------------------------------------------------------------

  addLayers() {
    for (const layer of this.data.layers) {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(layer.positions, 3));
      geometry.setAttribute("color", new BufferAttribute(layer.colours, 3, true));
      const points = new Points(geometry, roundPoints({ size: 3 * this.renderer.getPixelRatio(), vertexColors: true }));
      this.add(layer.name, points);
      points.visible = false;
      if (layer.edges.length > 0)
        points.add(this.edgesOf(layer));
    }
  }

  // An edge has a colour of its own, so that each needs two points of its own.
  edgesOf(layer) {
    const count = layer.edges.length;
    const positions = new Float32Array(3 * count), colours = new Uint8Array(3 * count);
    for (let i = 0; i < count; ++i)
      for (let axis = 0; axis < 3; ++axis) {
        positions[3 * i + axis] = layer.positions[3 * layer.edges[i] + axis];
        colours[3 * i + axis] = layer.edgeColours[3 * (i >> 1) + axis];
      }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("color", new BufferAttribute(colours, 3, true));
    const edges = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
    edges.frustumCulled = false;
    return edges;
  }

  addVertices() {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(this.data.vertices, 3));
    this.add("vertices", new Points(geometry, roundPoints({
      size: 9 * this.renderer.getPixelRatio(), color: "#11151c"
    })));
    this.objects.vertices.renderOrder = 3;
  }

  add(name, object) {
    object.frustumCulled = false;
    this.objects[name] = object;
    this.scene.add(object);
  }

  setVisible(name, isVisible) {
    this.objects[name].visible = isVisible;
    if (name === "curves")
      this.highlight.visible = isVisible;
    this.draw();
  }

  // the curves ------------------------------------------------------------------------------------

  addCurves() {
    this.curveMaterial = new LineMaterial({ linewidth: 3, vertexColors: true });
    this.highlightMaterial = new LineMaterial({ linewidth: 7, color: "#ff2fa0", depthTest: false });
    this.add("curves", new LineSegments2(new LineSegmentsGeometry(), this.curveMaterial));
    this.highlight = new LineSegments2(new LineSegmentsGeometry(), this.highlightMaterial);
    this.highlight.frustumCulled = false;
    this.highlight.visible = false;
    this.highlight.renderOrder = 2;
    this.scene.add(this.highlight);
  }

  setLineWidth(width) {
    this.curveMaterial.linewidth = width;
    this.highlightMaterial.linewidth = width + 4;
    this.draw();
  }

  // Shows these curves, each in the colour that the function gives.
  showCurves(curves, colourOf) {
    this.shownCurves = curves;
    const { positions, colours } = this.segmentsOf(curves, colourOf);
    this.replace(this.objects.curves, positions, colours);
    this.draw();
  }

  showHighlight(curves) {
    const { positions } = this.segmentsOf(curves, () => [1, 0, 0]);
    this.replace(this.highlight, positions);
    this.highlight.visible = curves.length > 0 && this.objects.curves.visible;
    this.draw();
  }

  replace(lines, positions, colours) {
    lines.geometry.dispose();
    lines.geometry = new LineSegmentsGeometry();
    lines.geometry.setPositions(positions);
    if (colours)
      lines.geometry.setColors(colours);
  }

  segmentsOf(curves, colourOf) {
    let count = 0;
    for (const curve of curves)
      count += curve.count - 1;
    const positions = new Float32Array(6 * count), colours = new Float32Array(6 * count);
    let at = 0;
    for (const curve of curves) {
      const colour = colourOf(curve);
      for (let i = curve.first; i + 1 < curve.first + curve.count; ++i, at += 6) {
        positions.set(this.data.curvePoints.subarray(3 * i, 3 * i + 6), at);
        colours.set(colour, at);
        colours.set(colour, at + 3);
      }
    }
    return { positions, colours };
  }

  // the shown curve under the pointer, or null
  curveAt(x, y, tolerance = 8) {
    if (!this.objects.curves.visible)
      return null;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const point = new Vector3();
    let best = null, bestCost = Infinity;
    const place = index => {
      point.fromArray(this.data.curvePoints, 3 * index).project(this.camera);
      return [(point.x + 1) * width / 2, (1 - point.y) * height / 2, point.z];
    };
    for (const curve of this.shownCurves) {
      let last = place(curve.first);
      for (let i = curve.first + 1; i < curve.first + curve.count; ++i) {
        const next = place(i);
        const away = last[2] < 1 && next[2] < 1 ? distanceToSegment(x, y, last, next) : Infinity;
        // of two curves that are equally near, the front one is meant
        const cost = away + 4 * next[2];
        if (away < tolerance && cost < bestCost) {
          best = curve;
          bestCost = cost;
        }
        last = next;
      }
    }
    return best;
  }

  // where the middle of a curve is on the canvas, in pixels
  placeOf(curve) {
    const index = curve.first + (curve.count >> 1);
    const point = new Vector3().fromArray(this.data.curvePoints, 3 * index).project(this.camera);
    return { x: (point.x + 1) * this.canvas.clientWidth / 2, y: (1 - point.y) * this.canvas.clientHeight / 2 };
  }

  // the camera ------------------------------------------------------------------------------------

  // The directions are those of the drawings in .svg.
  look(name) {
    const directions = {
      isometric: [1, -1, 1], front: [0, -1, 0], right: [1, 0, 0], top: [0, -1e-4, 1]
    };
    this.controls.target.set(0, 0, 0);
    const away = this.distanceFor(0.5 * Math.hypot(...this.data.extent));
    this.camera.position.fromArray(directions[name]).normalize().multiplyScalar(away);
    this.controls.update();
    this.onMove();
  }

  zoomTo(curve) {
    const points = new BufferGeometry();
    points.setAttribute("position", new BufferAttribute(
      this.data.curvePoints.slice(3 * curve.first, 3 * (curve.first + curve.count)), 3));
    points.computeBoundingSphere();
    const { center, radius } = points.boundingSphere;
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(direction, this.distanceFor(Math.max(2 * radius, 0.02)));
    this.controls.update();
    this.onMove();
  }

  distanceFor(radius) {
    const angle = Math.PI / 360 * this.camera.fov;
    return 1.06 * radius / Math.sin(Math.min(angle, Math.atan(Math.tan(angle) * this.camera.aspect)));
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0)
      return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(width, height, false);
    for (const material of [this.curveMaterial, this.highlightMaterial])
      material.resolution.set(width, height);
    this.draw();
  }

  // at the next frame, however often it is asked for
  draw() {
    this.isAsked = true;
    if (this.frame || this.isBusy)
      return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.isAsked = false;
      const away = this.camera.position.distanceTo(this.controls.target);
      this.camera.near = Math.max(away / 1000, away - 4);
      this.camera.far = away + 4;
      this.camera.updateProjectionMatrix();
      this.renderer.render(this.scene, this.camera);
      this.drawAxes();
      this.waitForFrame();
    });
  }

  // how the axes lie, in a corner of the view
  drawAxes() {
    const context = this.axes.getContext("2d");
    const { width, height } = this.axes;
    context.clearRect(0, 0, width, height);
    context.lineWidth = 2;
    context.font = "11px sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    const turned = [["x", "#c2362f"], ["y", "#2d8a3e"], ["z", "#2b5fc1"]].map(([name, colour], i) => {
      const direction = new Vector3().setComponent(i, 1).transformDirection(this.camera.matrixWorldInverse);
      return { name, colour, direction };
    }).sort((a, b) => a.direction.z - b.direction.z);
    for (const { name, colour, direction } of turned) {
      const at = length => new Vector2(width / 2 + length * direction.x, height / 2 - length * direction.y);
      const end = at(28), label = at(37);
      context.strokeStyle = context.fillStyle = colour;
      context.beginPath();
      context.moveTo(width / 2, height / 2);
      context.lineTo(end.x, end.y);
      context.stroke();
      context.fillText(name, label.x, label.y);
    }
  }
}

function distanceToSegment(x, y, [ax, ay], [bx, by]) {
  const dx = bx - ax, dy = by - ay;
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / square, 0), 1) : 0;
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
