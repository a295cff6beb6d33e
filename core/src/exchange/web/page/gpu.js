// WebGL 2: what stands on the graphics card, and a frame's passes. Sky and sprites go into a target of linear light, the
// tone curve brings it to the canvas, as in render/src/frame.rs.

const DATA_ROW = 2048;

class Gpu {
  constructor(canvas, scene) {
    // Nothing here needs depth, and sprites smooth their own edges.
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, powerPreference: "high-performance" });
    if (!gl) throw new Error("This page draws with WebGL 2, which this browser does not offer, or which is turned off.");
    this.gl = gl;
    this.scene = scene;
    const floats = gl.getExtension("EXT_color_buffer_float") || gl.getExtension("EXT_color_buffer_half_float");
    // Without floats, linear light is kept in the bytes of sRGB: what is brighter than white is cut.
    this.linear_format = floats ? gl.RGBA16F : gl.SRGB8_ALPHA8;
    this.background = this.program(["cover_vertex"], "background_fragment");
    this.shadows = this.program(["clouds", "shadows_vertex"], "shadows_fragment");
    this.sprites = this.program(["clouds", "sprites_vertex"], "sprites_fragment");
    this.tone = this.program(["cover_vertex"], "tone_fragment");
    this.atlas = this.upload_atlas();
    const words = (name) => this.data_texture(scene.words(name));
    this.data = {
      sprite_data: words("sprites"), group_data: words("groups"), cloud_data: words("clouds"), stir_data: words("stirs"),
      baked_data: words("baked"), shade_data: gl.createTexture(),
      moment_data: this.data_texture(new Uint32Array(4)), pose_data: this.data_texture(new Uint32Array(4)),
    };
    this.empty = gl.createVertexArray();
    this.vertices = gl.createVertexArray();
    this.instances = gl.createBuffer();
    gl.bindVertexArray(this.vertices);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribIPointer(0, 3, gl.UNSIGNED_INT, 0, 0);
    gl.vertexAttribDivisor(0, 1);
    this.casters = gl.createBuffer();
    this.caster_vertices = this.upload_casters();
    this.shadow_map = gl.createTexture();
    this.shadow_framebuffer = gl.createFramebuffer();
    gl.bindTexture(gl.TEXTURE_2D, this.shadow_map);
    gl.texStorage2D(gl.TEXTURE_2D, 1, floats ? gl.R16F : gl.R8, HEADER.constants.SHADOW_TEXELS, HEADER.constants.SHADOW_TEXELS);
    this.filter(gl.TEXTURE_2D, gl.LINEAR, gl.LINEAR);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadow_framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.shadow_map, 0);
    this.linear = gl.createTexture();
    this.framebuffer = gl.createFramebuffer();
    this.size = [0, 0];
  }

  /** Each sprite's cloud, number, and the bits of its optical depth. */
  upload_casters() {
    const gl = this.gl;
    const depths = this.scene.words("depths");
    const casters = new Uint32Array(3 * depths.length);
    HEADER.clouds.forEach(({ first_sprite, sprites }, index) => {
      for (let sprite = first_sprite; sprite < first_sprite + sprites; sprite++) {
        casters.set([index, sprite, depths[sprite]], 3 * sprite);
      }
    });
    this.caster_count = depths.length;
    const vertices = gl.createVertexArray();
    gl.bindVertexArray(vertices);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.casters);
    gl.bufferData(gl.ARRAY_BUFFER, casters, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribIPointer(0, 3, gl.UNSIGNED_INT, 0, 0);
    gl.vertexAttribDivisor(0, 1);
    return vertices;
  }

  /** A program, with the places of its uniforms by name. */
  program(vertex, fragment) {
    const gl = this.gl;
    const literal = (value) => (Number.isInteger(value) ? value.toFixed(1) : String(value));
    const defines = Object.entries(HEADER.constants).map(([name, value]) => `#define ${name} ${literal(value)}\n`).join("");
    const program = gl.createProgram();
    for (const [kind, ids] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, [fragment]]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, `#version 300 es\n${defines}#define DATA_ROW ${DATA_ROW}u\n${text_of("frame")}${ids.map(text_of).join("")}`);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
        throw new Error(`This browser's graphics driver refuses a shader (${ids.at(-1)}): ${gl.getShaderInfoLog(shader)}`);
      }
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(`This browser's graphics driver refuses the shaders: ${gl.getProgramInfoLog(program)}`);
    }
    const places = {};
    for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; i--) {
      const { name } = gl.getActiveUniform(program, i);
      places[name.replace("[0]", "")] = gl.getUniformLocation(program, name);
    }
    return { program, places };
  }

  upload_atlas() {
    const gl = this.gl;
    const { TILE_SIZE, LAST_MIP } = HEADER.constants;
    const tiles = HEADER.mean_opacities.length;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, LAST_MIP + 1, gl.RGBA8, TILE_SIZE, TILE_SIZE, tiles);
    let from = 0;
    for (let mip = 0; mip <= LAST_MIP; mip++) {
      const side = TILE_SIZE >> mip;
      const texels = this.scene.atlas.subarray(from, from += 4 * side * side * tiles);
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, mip, 0, 0, 0, side, side, tiles, gl.RGBA, gl.UNSIGNED_BYTE, texels);
    }
    this.filter(gl.TEXTURE_2D_ARRAY, gl.LINEAR, gl.LINEAR_MIPMAP_LINEAR);
    return texture;
  }

  filter(target, near, far) {
    const gl = this.gl;
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, near);
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, far);
    gl.texParameteri(target, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(target, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  }

  /** Words by the four, in rows. */
  data_texture(words) {
    const texture = this.gl.createTexture();
    this.write_data(texture, words);
    return texture;
  }

  write_data(texture, words) {
    const gl = this.gl;
    const rows = Math.max(1, Math.ceil(words.length / (4 * DATA_ROW)));
    const whole = new Uint32Array(4 * DATA_ROW * rows);
    whole.set(words);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, DATA_ROW, rows, 0, gl.RGBA_INTEGER, gl.UNSIGNED_INT, whole);
    this.filter(gl.TEXTURE_2D, gl.NEAREST, gl.NEAREST);
  }

  /** What other clouds take of the light over each: four floats a node, in rows. */
  write_shades(nodes) {
    const gl = this.gl;
    const rows = Math.max(1, Math.ceil(nodes.length / (4 * DATA_ROW)));
    const whole = new Float32Array(4 * DATA_ROW * rows);
    whole.set(nodes);
    gl.bindTexture(gl.TEXTURE_2D, this.data.shade_data);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, DATA_ROW, rows, 0, gl.RGBA, gl.FLOAT, whole);
    this.filter(gl.TEXTURE_2D, gl.NEAREST, gl.NEAREST);
  }

  /** The clouds' shadows for the ground, multiplied spot by spot. */
  draw_shadows(view, light, air, plane) {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadow_framebuffer);
    gl.viewport(0, 0, HEADER.constants.SHADOW_TEXELS, HEADER.constants.SHADOW_TEXELS);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ZERO, gl.SRC_COLOR);
    gl.bindVertexArray(this.caster_vertices);
    this.use(this.shadows, view, light, { ...air_of(air), ...ground_of(view, light), ...plane });
    this.bind(this.shadows, this.data);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.caster_count);
  }

  resize(width, height) {
    const gl = this.gl;
    if (this.size[0] === width && this.size[1] === height) return;
    this.size = [width, height];
    gl.deleteTexture(this.linear);
    this.linear = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.linear);
    gl.texStorage2D(gl.TEXTURE_2D, 1, this.linear_format, width, height);
    this.filter(gl.TEXTURE_2D, gl.NEAREST, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.linear, 0);
  }

  /** Uses a program with what every shader knows, and `more` by name: a number, or one to four of them. */
  use({ program, places }, view, light, more) {
    const gl = this.gl;
    gl.useProgram(program);
    const set = (name, values) => {
      const place = places[name];
      if (place) gl[`uniform${values.length}fv`](place, values);
    };
    set("right_in_world", view.right);
    set("up_in_world", view.up);
    set("forward_in_world", view.forward);
    set("size_px", [view.width, view.height]);
    set("pixel", [(2 * view.tan_half_height) / view.height]);
    const { sun_direction, ambient, directional, haze_length_m, exposure, dome_scale, sun_disc, glow_direction } = light;
    const lights = { sun_direction, ambient, directional, haze_length_m, exposure, dome_scale, sun_disc, glow_direction };
    const { shadow_axes, ...others } = more;
    Object.entries({ ...lights, ...others }).forEach(([name, values]) => set(name, values));
    if (places.dome_parameters) gl.uniform3fv(places.dome_parameters, light.dome_parameters);
    if (places.shadow_axes) gl.uniform3fv(places.shadow_axes, more.shadow_axes ?? [1, 0, 0, 0, 1, 0]);
  }

  /** Binds textures by the names of their samplers. */
  bind({ places }, textures) {
    const gl = this.gl;
    Object.entries(textures).forEach(([name, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(name === "atlas" ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D, texture);
      gl.uniform1i(places[name] ?? null, unit);
    });
    gl.activeTexture(gl.TEXTURE0);
  }

  /** A whole frame. */
  draw(view, light, air, list, veil, has_new_levels) {
    const gl = this.gl;
    this.resize(view.width, view.height);
    if (has_new_levels) this.write_data(this.data.cloud_data, this.scene.words("clouds"));
    this.write_data(this.data.moment_data, new Uint32Array(list.moments.buffer));
    const poses = new Float32Array(8 * list.poses.length);
    list.poses.forEach(({ towards, fade, up }, i) => poses.set([...towards, fade, ...up, 0], 8 * i));
    this.write_data(this.data.pose_data, new Uint32Array(poses.buffer));

    const plane = plane_of(list.shadows, view);
    if (list.has_new_shadows) {
      this.write_shades(list.shadows.nodes);
      if (plane.shadow_eye) this.draw_shadows(view, light, air, plane);
    }

    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.viewport(0, 0, view.width, view.height);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(this.empty);
    const on_ground = plane.shadow_eye ? plane : { shadow_share: [0] };
    this.use(this.background, view, light, { ...ground_of(view, light), ...on_ground });
    this.bind(this.background, { shadow_map: this.shadow_map });
    gl.drawArrays(gl.TRIANGLES, 0, 3);

    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.bindVertexArray(this.vertices);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
    gl.bufferData(gl.ARRAY_BUFFER, list.instances.subarray(0, 3 * list.count), gl.STREAM_DRAW);
    this.use(this.sprites, view, light, { ...air_of(air), ...plane });
    this.bind(this.sprites, { atlas: this.atlas, ...this.data });
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, list.count);

    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(this.empty);
    this.use(this.tone, view, light, { veil });
    this.bind(this.tone, { linear_picture: this.linear });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

/** The air that moves sprites one by one. */
const air_of = (air) => (air ? {
  air_lean: air.lean, air_lean_shear: air.shear, air_swings: air.swings,
  air_turned: [air.turned], air_turbulence: [air.turbulence], air_humidity: [air.humidity],
} : {});

/** Of shadows, what shaders know; without a plane none fall on the ground. */
function plane_of(shadows, view) {
  const known = { shadow_axes: shadows.axes.flat(), shadow_share: [shadows.share] };
  const { plane } = shadows;
  return plane ? { ...known, shadow_eye: shadows.eye_on_plane(view.eye), shadow_texel_m: plane.texel_m } : known;
}

/** The ground as the eye of `view` sees it. */
function ground_of(view, light) {
  const { GROUND_PERIOD_M } = HEADER.constants;
  const within = (x) => ((x % GROUND_PERIOD_M) + GROUND_PERIOD_M) % GROUND_PERIOD_M;
  const height_m = HEADER.ground_altitude_m === null ? 0 : view.eye[1] - HEADER.ground_altitude_m;
  return {
    ground_eye_height_m: [Math.max(height_m, 0)],
    ground_eye_in_pattern_m: [within(view.eye[0]), within(view.eye[2])],
    ground_dark: light.ground_dark,
    ground_bright: light.ground_bright,
    ground_without_sun: light.ground_without_sun,
  };
}
