// SPDX-License-Identifier: BSD-3-Clause
// Solids and lines in WebGL2.

const vertexText = `#version 300 es
in vec3 p, n; uniform mat4 model, view; out vec3 normal, place;
void main() { normal = mat3(model) * n; place = p; gl_Position = view * model * vec4(p, 1); }`;
// Turning solids of revolution are seen by their sectors: pattern 1 of a cylinder, 2 of a sphere.
const fragmentText = `#version 300 es
precision highp float;
in vec3 normal, place; uniform vec3 colour; uniform float lit; uniform int pattern; out vec4 pixel;
void main() {
  vec3 n = normalize(normal);
  float light = 0.50 + 0.42 * max(0.0, dot(n, normalize(vec3(0.45, -0.6, 0.85))))
    + 0.16 * max(0.0, dot(n, normalize(vec3(-0.7, 0.3, 0.2))));
  float sector = pattern == 1 ? place.x * place.y : pattern == 2 ? place.x * place.y * place.z : 1.0;
  vec3 base = sector < 0.0 ? mix(colour, vec3(1.0), 0.42) : colour;
  pixel = vec4(lit > 0.5 ? base * light : colour, 1);
}`;

// Triangles of unit solids about the origin, [p, n] a corner: edges, diameters and heights are 1; cylinders along z.
function boxMesh() {
  const data = [];
  for (let axis = 0; axis < 3; axis++)
    for (const side of [-1, 1])
      for (const [a, b] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) {
        const p = [0, 0, 0], n = [0, 0, 0];
        p[axis] = side / 2;
        p[(axis + 1) % 3] = a / 2;
        p[(axis + 2) % 3] = b / 2;
        n[axis] = side;
        data.push(...p, ...n);
      }
  return data;
}
function cylinderMesh(parts = 48) {
  const data = [], rim = (i) => {
    const angle = (2 * Math.PI * i) / parts;
    return [Math.cos(angle), Math.sin(angle)];
  };
  for (let i = 0; i < parts; i++) {
    const [[a, b], [c, d]] = [rim(i), rim(i + 1)], low = -0.5, high = 0.5;
    for (const [x, y, z] of [[a, b, low], [c, d, low], [c, d, high], [a, b, low], [c, d, high], [a, b, high]])
      data.push(x / 2, y / 2, z, x, y, 0);
    for (const z of [low, high])
      for (const [x, y] of [[0, 0], [a, b], [c, d]]) data.push(x / 2, y / 2, z, 0, 0, 2 * z);
  }
  return data;
}
// Its tip is on the positive z axis.
function coneMesh(parts = 24) {
  const data = [], angle = (i) => (2 * Math.PI * i) / parts;
  const rim = (i) => [Math.cos(angle(i)) / 2, Math.sin(angle(i)) / 2, -0.5];
  const slope = ([x, y]) => unit3([2 * x, 2 * y, 0.5]);
  for (let i = 0; i < parts; i++) {
    const a = rim(i), b = rim(i + 1);
    data.push(...a, ...slope(a), ...b, ...slope(b), 0, 0, 0.5, ...slope(rim(i + 0.5)));
    for (const p of [[0, 0, -0.5], a, b]) data.push(...p, 0, 0, -1);
  }
  return data;
}
function sphereMesh(rows = 16, columns = 32) {
  const data = [];
  const corner = (i, j) => {
    const a = (Math.PI * i) / rows, b = (2 * Math.PI * j) / columns,
          n = [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)];
    return [...times3(n, 0.5), ...n];
  };
  for (let i = 0; i < rows; i++)
    for (let j = 0; j < columns; j++)
      data.push(
          ...corner(i, j), ...corner(i + 1, j), ...corner(i + 1, j + 1), ...corner(i, j), ...corner(i + 1, j + 1),
          ...corner(i, j + 1));
  return data;
}

// Null where the browser has no WebGL2.
function openScene(canvas) {
  const gl = canvas.getContext('webgl2', {antialias: true, preserveDrawingBuffer: true});
  if (!gl) return null;
  const program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertexText], [gl.FRAGMENT_SHADER, fragmentText]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.bindAttribLocation(program, 0, 'p');
  gl.bindAttribLocation(program, 1, 'n');
  gl.linkProgram(program);
  gl.useProgram(program);
  const place = Object.fromEntries(
      ['model', 'view', 'colour', 'lit', 'pattern'].map((name) => [name, gl.getUniformLocation(program, name)]));
  function mesh(data, stride) {
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STATIC_DRAW);
    return {buffer, stride, count: data.length / stride};
  }
  function show(what, model, colour, mode, count, pattern = 0) {
    const solid = what.stride === 6;
    gl.bindBuffer(gl.ARRAY_BUFFER, what.buffer);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 4 * what.stride, 0);
    if (solid) {
      gl.enableVertexAttribArray(1);
      gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 24, 12);
    } else {
      gl.disableVertexAttribArray(1);
      gl.vertexAttrib3f(1, 0, 0, 1);
    }
    gl.uniformMatrix4fv(place.model, false, model);
    gl.uniform3fv(place.colour, colour);
    gl.uniform1f(place.lit, solid ? 1 : 0);
    gl.uniform1i(place.pattern, pattern);
    gl.drawArrays(mode, 0, count);
  }
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.SCISSOR_TEST);
  const solids = Object.fromEntries(
      Object.entries({box: boxMesh(), cylinder: cylinderMesh(), cone: coneMesh(), sphere: sphereMesh()})
          .map(([kind, data]) => [kind, mesh(data, 6)]));
  return {
    lines: (points) => mesh(points, 3),
    remove: (lines) => gl.deleteBuffer(lines.buffer),
    solid: (kind, model, colour, pattern) =>
        show(solids[kind], model, colour, gl.TRIANGLES, solids[kind].count, pattern),
    segments: (lines, model, colour) => show(lines, model, colour, gl.LINES, lines.count),
    strip: (lines, colour, count) => show(lines, identity4, colour, gl.LINE_STRIP, Math.min(count, lines.count)),
    // What is drawn from here on is seen through what is there.
    over: () => gl.clear(gl.DEPTH_BUFFER_BIT),
    // A part of the canvas, cleared, seen through a matrix.
    pane(left, width, height, background, view) {
      gl.viewport(left, 0, width, height);
      gl.scissor(left, 0, width, height);
      gl.clearColor(...background, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.uniformMatrix4fv(place.view, false, view);
    },
  };
}
