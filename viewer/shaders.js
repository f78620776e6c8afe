// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// GLSL of the page. The light is that of pictures (src/render/shading.cpp).
"use strict";

const Shaders = (() => {
  const light = `
    vec3 decoded(vec3 s) { return mix(s / 12.92, pow((s + 0.055) / 1.055, vec3(2.4)), step(0.04045, s)); }
    vec3 encoded(vec3 l) {
      l = clamp(l, 0.0, 1.0);
      return mix(12.92 * l, 1.055 * pow(l, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, l));
    }
    // All in the viewer's frame: x right, y up, z towards.
    vec3 shaded(vec3 albedo, vec3 normal, vec3 toViewer, float sky) {
      const vec3 key = vec3(-0.4511, 0.5513, 0.7017), lamp2 = vec3(0.5970, -0.0995, 0.7960);
      float fromSky = 0.58 * sky * sqrt(sky) * (1.0 - 0.15 * (1.0 - normal.y));
      float reached = 1.0 - 0.70 * (1.0 - sky);
      float lamps = 0.50 * max(0.0, dot(normal, key)) + 0.10 * max(0.0, dot(normal, lamp2));
      float aside = 1.0 - clamp(dot(normal, toViewer), 0.0, 1.0);
      float rim = 1.0 - 0.30 * aside * aside * aside;
      float g = max(0.0, dot(normal, normalize(key + toViewer)));   // to the power of 24
      g *= g * g;
      g *= g;
      g *= g;
      return rim * (fromSky + reached * lamps) * albedo + 0.02 * reached * g * g;
    }
  `;

  const surfaceVertex = `
    attribute vec4 look;      // normal (octahedral), share of the sky
    attribute vec3 patches;   // how much of each kind of patch there is around
    attribute vec3 corners;   // the atoms of the triangle's three corners
    attribute vec4 tint;      // colour of a class
    attribute vec4 values;    // curvature, depth, component, value from elsewhere
    uniform float eye;        // distance of the viewer, 0 without perspective
    varying vec3 at, inView, normal_, kinds;
    varying float sky, curvature, depth, brought;
    varying vec3 ofClass;
    flat varying vec3 atoms;
    flat varying float component;
    centroid varying vec3 within;   // as inView, but never beyond the triangle's edges
    void main() {
      vec2 o = look.xy * (255.0 / 127.0) - 1.0;
      vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
      if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(o.x < 0.0 ? -1.0 : 1.0, o.y < 0.0 ? -1.0 : 1.0);
      normal_ = normalMatrix * n;
      sky = look.z;
      kinds = patches;
      atoms = corners;
      curvature = values.x;
      depth = values.y;
      component = values.z;
      brought = values.w;
      ofClass = tint.rgb;
      at = position;
      vec4 seen = modelViewMatrix * vec4(position, 1.0);
      inView = within = seen.xyz;
      gl_Position = projectionMatrix * seen;
    }
  `;

  const surfaceFragment = `
    uniform highp sampler2D spheres;   // atoms: centre, radius
    uniform highp sampler2D paint;     // atoms: colour, and whether chosen
    uniform int scheme;                // 0 atoms, 1 components, 2 values, 3 classes
    uniform vec4 overPatch[3];         // light of a kind of patch, not encoded; w: whether it goes before the atom's
    uniform highp sampler2D ofComponent;
    uniform vec3 ramp[9];
    uniform vec2 range;
    uniform int value;                 // 0 curvature, 1 depth, 2 from elsewhere
    uniform vec2 scale;                // of the latter: step, and what zero stands for
    uniform vec3 none;                 // where there is none of the latter
    uniform vec2 steps;                // of curvature and depth
    uniform vec4 plane;                // kept is dot(plane, (at, 1)) <= 0
    uniform bool inPerspective;
    uniform vec3 inside, accent;
    uniform float opacity, chosen;     // chosen: a component, or -1
    uniform mat4 projectionMatrix;
    uniform bool choosing;             // whether any atom is chosen
    varying vec3 at, inView, normal_, kinds;
    varying float sky, curvature, depth, brought;
    varying vec3 ofClass;
    flat varying vec3 atoms;
    flat varying float component;
    centroid varying vec3 within;   // as inView, but never beyond the triangle's edges
    ${light}
    ivec2 place(highp sampler2D table, float n) {
      int width = textureSize(table, 0).x, i = int(n + 0.5);
      return ivec2(i % width, i / width);
    }
    float above(float atom) {
      vec4 ball = texelFetch(spheres, place(spheres, atom), 0);
      return distance(at, ball.xyz) - ball.w;
    }
    vec4 painted(float atom) {
      vec4 c = texelFetch(paint, place(paint, atom), 0);
      return vec4(decoded(c.rgb), c.a);
    }
    // The first of three classes by value, mixed with the second where a pixel straddles their border.
    vec4 sharp(vec3 v, vec3 blur, vec4 a, vec4 b, vec4 c) {
      if (v.y > v.x) { v.xy = v.yx; blur.yz = blur.zy; vec4 t = a; a = b; b = t; }
      if (v.z > v.x) { v.xz = v.zx; blur.xz = blur.zx; vec4 t = a; a = c; c = t; }
      if (v.z > v.y) { v.yz = v.zy; blur.xy = blur.yx; b = c; }
      return mix(a, b, 0.5 * (1.0 - smoothstep(0.0, max(blur.x, 1e-6), v.x - v.y)));
    }
    vec3 widths(vec3 v) { return fwidth(vec3(v.x - v.y, v.x - v.z, v.y - v.z)); }   // of pairs xy, xz, yz
    vec4 byAtom() {
      vec4 a = painted(atoms.x);
      if (atoms.x == atoms.y && atoms.y == atoms.z) return a;   // all over a triangle
      vec3 gaps = -vec3(above(atoms.x), above(atoms.y), above(atoms.z));
      return sharp(gaps, widths(gaps), a, painted(atoms.y), painted(atoms.z));
    }
    vec4 byPatch(vec4 atom, int k) {
      return vec4(mix(atom.rgb, overPatch[k].rgb, overPatch[k].w), atom.a);
    }
    vec4 byAtomAndPatch() {
      vec4 atom = byAtom();
      if (overPatch[1].w == 0.0) return atom;   // no scheme names contact patches alone
      return sharp(kinds, widths(kinds), byPatch(atom, 0), byPatch(atom, 1), byPatch(atom, 2));
    }
    vec3 byValue() {
      if (value == 2 && brought < -0.5) return decoded(none);
      float v = value == 0 ? curvature * steps.x : value == 1 ? depth * steps.y : brought * scale.x + scale.y;
      float p = 8.0 * clamp((v - range.x) / max(range.y - range.x, 1e-9), 0.0, 1.0);
      int i = min(int(p), 7);
      return decoded(mix(ramp[i], ramp[i + 1], p - float(i)));
    }
    // Of the inner side, a little nearer (Å): where the surface turns over, its outer side must not shine through.
    float depthOfInside(vec3 toViewer) {
      vec4 clip = projectionMatrix * vec4(within + 0.15 * toViewer, 1.0);
      return 0.5 * clip.z / clip.w + 0.5;
    }
    void main() {
      vec4 atom = scheme == 0 || choosing ? byAtomAndPatch() : vec4(0.0);
      vec3 toViewer = inPerspective ? normalize(-inView) : vec3(0.0, 0.0, 1.0);
      vec3 n = normalize(normal_);
#ifdef CUT
      if (dot(plane.xyz, at) + plane.w > 0.0) discard;
      gl_FragDepth = gl_FragCoord.z;
      if (!gl_FrontFacing || dot(n, toViewer) < -0.1) {
        gl_FragDepth = depthOfInside(toViewer);
        gl_FragColor = vec4(inside, opacity);
        return;
      }
#endif
      vec3 albedo;
      if (scheme == 0)
        albedo = atom.rgb;
      else
        albedo = scheme == 3 ? decoded(ofClass) : scheme == 1 ? decoded(texelFetch(ofComponent, place(ofComponent, component), 0).rgb) : byValue();
      if (choosing && atom.a > 0.0) albedo = mix(albedo, accent, 0.65 * atom.a);
      if (abs(component - chosen) < 0.5) albedo = mix(albedo, accent, 0.8);
      float open = gl_FrontFacing ? sky : 0.7;
      if (!gl_FrontFacing) n = -n;
      float aside = 1.0 - clamp(dot(n, toViewer), 0.0, 1.0);
      gl_FragColor = vec4(encoded(shaded(albedo, n, toViewer, open)), mix(opacity, 1.0, 0.6 * aside * aside * opacity));
    }
  `;

  // Bodies beside the surface, in one colour each.
  const bodyVertex = `
    attribute vec2 look;      // normal (octahedral)
    attribute vec4 tint;      // colour; w: whether it is chosen
    varying vec3 normal_, inView;
    varying vec4 tint_;
    void main() {
      vec2 o = look * (255.0 / 127.0) - 1.0;
      vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
      if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(o.x < 0.0 ? -1.0 : 1.0, o.y < 0.0 ? -1.0 : 1.0);
      normal_ = normalMatrix * n;
      tint_ = tint;
      vec4 seen = modelViewMatrix * vec4(position, 1.0);
      inView = seen.xyz;
      gl_Position = projectionMatrix * seen;
    }
  `;
  const bodyFragment = `
    uniform bool inPerspective;
    uniform float opacity;
    varying vec3 normal_, inView;
    varying vec4 tint_;
    ${light}
    void main() {
      vec3 toViewer = inPerspective ? normalize(-inView) : vec3(0.0, 0.0, 1.0);
      vec3 n = normalize(normal_);
      float aside = 1.0 - clamp(dot(n, toViewer), 0.0, 1.0);
      vec3 seen = encoded(shaded(decoded(tint_.rgb), n, toViewer, 0.9));
      gl_FragColor = vec4(seen, mix(opacity, 1.0, max(0.35 * aside * aside, 0.3 * tint_.a)));
    }
  `;

  // Balls: a square before each, rays through its pixels.
  const ballVertex = `
    attribute vec4 ball;
    attribute vec3 colour;
    uniform float size, fixedSize;
    varying vec3 inView, centre, colour_;
    varying float radius;
    void main() {
      radius = fixedSize > 0.0 ? fixedSize : size * ball.w;
      colour_ = colour;
      centre = (modelViewMatrix * vec4(ball.xyz, 1.0)).xyz;
      // Towards the viewer by the radius, and larger: in perspective a ball's outline lies before its centre.
      inView = centre + vec3(1.5 * radius * position.xy, radius);
      gl_Position = projectionMatrix * vec4(inView, 1.0);
    }
  `;
  const ballFragment = `
    uniform mat4 projectionMatrix;
    uniform bool inPerspective;
    uniform vec4 planeInView;
    uniform bool cut;
    varying vec3 inView, centre, colour_;
    varying float radius;
    ${light}
    void main() {
      if (cut && dot(planeInView.xyz, centre) + planeInView.w > 0.0) discard;
      vec3 way = inPerspective ? normalize(inView) : vec3(0.0, 0.0, -1.0);
      vec3 from = inPerspective ? vec3(0.0) : vec3(inView.xy, 0.0);
      vec3 d = from - centre;
      float b = dot(d, way), disc = b * b - dot(d, d) + radius * radius;
      if (disc < 0.0) discard;
      vec3 hit = from + (-b - sqrt(disc)) * way;
      vec4 clip = projectionMatrix * vec4(hit, 1.0);
      gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;
      vec3 n = (hit - centre) / radius;
      gl_FragColor = vec4(encoded(shaded(decoded(colour_), n, -way, 0.85)), 1.0);
    }
  `;

  // Half bonds: a cylinder of unit length along y, laid from one end to the other.
  const stickVertex = `
    attribute vec3 start, end, colour;
    uniform float thickness;
    varying vec3 normal_, inView, colour_;
    varying vec3 middle;
    void main() {
      vec3 axis = end - start;
      vec3 y = normalize(axis), x = normalize(cross(y, abs(y.x) < 0.8 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
      vec3 z = cross(x, y);
      vec3 at = start + (position.y + 0.5) * axis + thickness * (position.x * x + position.z * z);
      normal_ = normalMatrix * (normal.x * x + normal.z * z);
      colour_ = colour;
      middle = (modelViewMatrix * vec4(start, 1.0)).xyz;
      vec4 seen = modelViewMatrix * vec4(at, 1.0);
      inView = seen.xyz;
      gl_Position = projectionMatrix * seen;
    }
  `;
  const stickFragment = `
    uniform bool inPerspective;
    uniform vec4 planeInView;
    uniform bool cut;
    varying vec3 normal_, inView, colour_, middle;
    ${light}
    void main() {
      if (cut && dot(planeInView.xyz, middle) + planeInView.w > 0.0) discard;
      vec3 toViewer = inPerspective ? normalize(-inView) : vec3(0.0, 0.0, 1.0);
      gl_FragColor = vec4(encoded(shaded(decoded(colour_), normalize(normal_), toViewer, 0.85)), 1.0);
    }
  `;

  return {surfaceVertex, surfaceFragment, bodyVertex, bodyFragment, ballVertex, ballFragment, stickVertex, stickFragment};
})();
