// SPDX-License-Identifier: BSD-3-Clause
// A camera about a point, turned by drags and keys; z is upwards.

const cameraKeys = {
  ArrowLeft: (camera) => camera.turn(-0.1, 0),
  ArrowRight: (camera) => camera.turn(0.1, 0),
  ArrowUp: (camera) => camera.turn(0, 0.1),
  ArrowDown: (camera) => camera.turn(0, -0.1),
  '+': (camera) => camera.zoom(0.9),
  '-': (camera) => camera.zoom(1.1),
};

const lensFocus = 2.6;    // half the height of the picture is 1
const filledPart = 0.86;  // of the picture, which a motion may take

class Camera {
  constructor(changed) {
    Object.assign(this, {changed, azimuth: -0.95, elevation: 0.36, distance: 1, target: [0, 0, 0], isFramed: false});
  }
  direction() {
    const {azimuth, elevation} = this, across = Math.cos(elevation);
    return [across * Math.cos(azimuth), across * Math.sin(azimuth), Math.sin(elevation)];
  }
  matrix(aspect) {
    const {distance, target} = this, eye = add3(target, this.direction(), distance);
    return multiply4(lens4(lensFocus, aspect, distance / 60, distance * 40), view4(eye, target, [0, 0, 1]));
  }
  // Sees all points as large as it can, from where it is or from the given angles. On each axis of the picture a point
  // at (u, depth) is in sight from the distance d and the place c if |u - c| <= k (d - depth), k the slope of the lens:
  // the least d is half the span of u + k depth above u - k depth over k, and c its middle.
  frame(points, aspect, azimuth = this.azimuth, elevation = this.elevation) {
    Object.assign(this, {azimuth, elevation});
    const {low, high} = boxOf(points), centre = times3(add3(low, high), 0.5), z = this.direction();
    const x = unit3(cross3([0, 0, 1], z)), depths = points.map((p) => dot3(add3(p, centre, -1), z));
    this.target = centre;
    this.distance = depths.reduce((most, depth) => Math.max(most, depth), 0) + 0.1 * length3(add3(high, low, -1));
    for (const [axis, k] of [[x, (filledPart * aspect) / lensFocus], [cross3(z, x), filledPart / lensFocus]]) {
      let least = Infinity, most = -Infinity;
      points.forEach((p, i) => {
        const u = dot3(add3(p, centre, -1), axis);
        least = Math.min(least, u - k * depths[i]);
        most = Math.max(most, u + k * depths[i]);
      });
      this.target = add3(this.target, axis, (least + most) / 2);
      this.distance = Math.max(this.distance, (most - least) / (2 * k));
    }
    this.isFramed = true;
    this.changed();
  }
  moved() {
    this.isFramed = false;
    this.changed();
  }
  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.min(1.5, Math.max(-1.5, this.elevation + elevation));
    this.moved();
  }
  zoom(factor) {
    this.distance *= factor;
    this.moved();
  }
  shift(right, up) {
    const z = this.direction(), x = unit3(cross3([0, 0, 1], z)), y = cross3(z, x);
    this.target = add3(add3(this.target, x, -right * this.distance), y, up * this.distance);
    this.moved();
  }
  // The wheel scrolls the page unless the picture has the focus.
  listen(canvas) {
    let held = null;
    canvas.addEventListener('pointerdown', (event) => {
      held = [event.clientX, event.clientY];
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointerup', () => { held = null; });
    canvas.addEventListener('pointermove', (event) => {
      if (!held) return;
      const dx = event.clientX - held[0], dy = event.clientY - held[1];
      held = [event.clientX, event.clientY];
      if (event.shiftKey) this.shift(dx * 0.0011, dy * 0.0011);
      else this.turn(-dx * 0.008, dy * 0.008);
    });
    canvas.addEventListener('wheel', (event) => {
      if (document.activeElement !== canvas && !event.ctrlKey) return;
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.001));
    }, {passive: false});
    canvas.addEventListener('keydown', (event) => {
      if (!(event.key in cameraKeys)) return;
      event.preventDefault();
      cameraKeys[event.key](this);
    });
  }
}
