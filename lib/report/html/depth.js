// Depths as colours: the deepest finding at each point of the mesh, in bands whose borders are contours.

const depthShades = ["#ffe88f", "#ffc653", "#ff9f33", "#f77722", "#e24a1d", "#c0222d", "#931344", "#5f0b52"];

/** The greatest depth of these findings at each point of the mesh; of all, also those that the page has no rows of. */
function pointDepths(data, findings) {
  const {points, node_points, point_depths, deepest} = data.picture;
  const depths = new Float32Array(points.length / 3);
  if (findings.length === data.findings.id.length)
    point_depths.forEach((share, point) => {
      depths[point] = (share / 255) * deepest;
    });
  for (const i of findings) {
    if (!hasPointDepth(data, i)) continue;
    depths[node_points[i]] = Math.max(depths[node_points[i]], data.findings.penetration[i]);
  }
  return depths;
}

/** The finding has a point of the mesh and a depth, so it can be a colour there. */
function hasPointDepth(data, i) {
  const point = data.picture.node_points[i];
  return point !== undefined && point !== nowhere && data.findings.penetration[i] > 0;
}

/** What the shaders of faces and mesh lines share: depths as bands, and the fading of all that is far from a place. */
function makeLook(deepest) {
  return {
    deepest: {value: deepest > 0 ? deepest : 1},
    shades: {value: depthShades.map((shade) => new THREE.Color(shade))},
    back: {value: new THREE.Color()},
    place: {value: new THREE.Vector3()},
    reach: {value: 0},  // 0: nothing fades
  };
}

const fadeCode = `
  float far = reach > 0.0 ? smoothstep(reach, 2.0 * reach, distance(where, place)) : 0.0;
  if (far > 0.5 && mod(floor(gl_FragCoord.x) + 2.0 * floor(gl_FragCoord.y), 4.0) > 0.5) discard;
  gl_FragColor.rgb = mix(gl_FragColor.rgb, back, 0.7 * far);`;

const bandCode = `
  if (depthHere > 0.02 * deepest) {
    float band = min(floor(${depthShades.length}.0 * depthHere / deepest), ${depthShades.length - 1}.0);
    for (int i = 0; i < ${depthShades.length}; ++i) if (float(i) == band) diffuseColor.rgb = shades[i];
  }`;

/** Gives a material the look; with bands where its geometry has depths. */
function useLook(material, look, bands) {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, look);
    const varying = `varying vec3 where;\n${bands ? "varying float depthHere;\n" : ""}`;
    shader.vertexShader = `${varying}${bands ? "attribute float depth;\n" : ""}${shader.vertexShader}`.replace(
        "#include <begin_vertex>",
        `#include <begin_vertex>\n  where = position;${bands ? "\n  depthHere = depth;" : ""}`);
    const uniforms = `uniform vec3 back, place, shades[${depthShades.length}];\nuniform float reach, deepest;\n`;
    shader.fragmentShader = `${varying}${uniforms}${shader.fragmentShader}`
                                .replace("#include <color_fragment>",
                                         `#include <color_fragment>${bands ? bandCode : ""}`)
                                .replace("#include <fog_fragment>", `#include <fog_fragment>${fadeCode}`);
  };
  return material;
}
