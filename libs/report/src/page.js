// The deformed mesh at the output that the slider chooses. The address may choose, too: #run=1&step=3&field=stress_xx&factor=1
'use strict';
(() => {
  const element = (id) => document.getElementById(id);
  const source = element('shapes');
  if (!source) return;
  const data = JSON.parse(source.textContent);
  const canvas = element('mesh'), slider = element('step'), factor = element('factor');
  const runs = element('run'), fields = element('field'), edges = element('edges');

  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const once = (make) => { let value; return () => value ??= make(); };
  for (const run of data.runs) {
    for (const mesh of run.meshes) {
      mesh.points = once(((text) => () => new Uint16Array(bytes(text)))(mesh.points));
      mesh.triangles = once(((text) => () => new Uint32Array(bytes(text)))(mesh.triangles));
    }
    for (const shape of run.shapes) {
      shape.displacement = once(((text) => () => new Int16Array(bytes(text)))(shape.displacement));
      shape.values = shape.values.map((text) => once(() => new Uint8Array(bytes(text))));
    }
  }

  const run = () => data.runs[Number(runs.value)];
  const shape = () => run().shapes[Number(slider.value) - 1];

  // Where the points are in metres: x, y of each.
  const positions = (r, s, times) => {
    const points = r.meshes[s.mesh].points(), u = s.displacement(), out = new Float64Array(points.length);
    for (let k = 0; k < out.length; ++k) {
      const low = r.low[k % 2], high = r.high[k % 2];
      out[k] = low + (high - low) * points[k] / 65535 + times * r.displacement * u[k] / 32767;
    }
    return out;
  };

  // The part of the plane that is shown: all outputs of the run fit into it.
  const views = new Map();
  const view = (r, times) => {
    const key = data.runs.indexOf(r) + '/' + times;
    if (!views.has(key)) {
      const box = [Infinity, Infinity, -Infinity, -Infinity];
      for (const s of r.shapes) {
        const at = positions(r, s, times);
        for (let k = 0; k < at.length; ++k) {
          box[k % 2] = Math.min(box[k % 2], at[k]);
          box[2 + k % 2] = Math.max(box[2 + k % 2], at[k]);
        }
      }
      views.set(key, box);
    }
    return views.get(key);
  };

  const colours = Array.from({length: 255}, (_, k) => {
    const place = k / 254 * (data.palette.length - 1), low = Math.min(Math.floor(place), data.palette.length - 2);
    const part = (n) => [1, 3, 5].map((i) => parseInt(data.palette[n].slice(i, i + 2), 16));
    const a = part(low), b = part(low + 1);
    return `rgb(${a.map((v, i) => Math.round(v + (b[i] - v) * (place - low))).join(',')})`;
  });
  colours.push('#ffffff');  // no value

  const draw = () => {
    const r = run(), s = shape(), times = Number(factor.value);
    const at = positions(r, s, times), [left, low, right, high] = view(r, times);
    const width = canvas.clientWidth, margin = 6;
    const ratio = (high - low) / (right - left || 1);
    const height = Math.min(Math.max(width * ratio, 160), Math.max(320, 0.75 * innerHeight));
    const dots = window.devicePixelRatio || 1;
    canvas.style.height = height + 'px';
    canvas.width = Math.round(width * dots);
    canvas.height = Math.round(height * dots);
    const pen = canvas.getContext('2d');
    const scale = Math.min((width - 2 * margin) / (right - left || 1), (height - 2 * margin) / (high - low || 1));
    const x0 = (width - scale * (right - left)) / 2, y0 = (height - scale * (high - low)) / 2;
    pen.scale(dots, dots);
    pen.lineJoin = 'round';
    const x = (n) => x0 + scale * (at[2 * n] - left), y = (n) => height - y0 - scale * (at[2 * n + 1] - low);

    const mesh = r.meshes[s.mesh], corners = mesh.triangles(), values = s.values[Number(fields.value)]();
    const paths = new Map(), lines = new Path2D();
    for (let t = 0; t < values.length; ++t) {
      if (!paths.has(values[t])) paths.set(values[t], new Path2D());
      for (const path of [paths.get(values[t]), lines]) {
        path.moveTo(x(corners[3 * t]), y(corners[3 * t]));
        path.lineTo(x(corners[3 * t + 1]), y(corners[3 * t + 1]));
        path.lineTo(x(corners[3 * t + 2]), y(corners[3 * t + 2]));
        path.closePath();
      }
    }
    pen.lineWidth = 0.6;  // closes the seams between triangles
    for (const [value, path] of paths) {
      pen.fillStyle = pen.strokeStyle = colours[value];
      pen.fill(path);
      pen.stroke(path);
    }
    if (edges.checked) {
      pen.strokeStyle = 'rgba(0,0,0,0.35)';
      pen.lineWidth = 0.4;
      pen.stroke(lines);
    }
    pen.strokeStyle = '#000000';
    pen.lineWidth = 1.4;
    pen.beginPath();
    for (let n = mesh.bulk; 2 * n + 2 < at.length; n += 2) {
      pen.moveTo(x(n), y(n));
      pen.lineTo(x(n + 1), y(n + 1));
    }
    pen.stroke();
  };

  const tell = () => {
    const r = run(), s = shape(), f = r.fields[Number(fields.value)];
    element('state').textContent = s.title;
    slider.setAttribute('aria-valuetext', s.title);
    const list = element('numbers');
    list.replaceChildren(...s.numbers.map(([name, value]) => {
      const item = document.createElement('li');
      item.textContent = name + ' ' + value;
      return item;
    }));
    element('bar').style.background = `linear-gradient(to right, ${data.palette.join(', ')})`;
    element('low').textContent = f.low;
    element('high').textContent = f.high;
    element('legend').textContent = f.title;
    element('extremes').textContent = f.extremes;
    canvas.dataset.run = r.label;
    canvas.dataset.step = slider.value;
    canvas.dataset.load = s.load;
    canvas.dataset.field = f.name;
    canvas.setAttribute('aria-label', `Deformed mesh of ${r.label}, ${s.title}, coloured by ${f.title}`);
  };

  const show = () => { tell(); draw(); };

  const option = (text, value) => new Option(text, value);
  const choose = (number) => {
    const kept = fields.selectedIndex >= 0 ? fields.selectedOptions[0].dataset.name : '';
    runs.value = number;
    const r = run();
    fields.replaceChildren(...r.fields.map((f, k) => {
      const o = option(f.title, k);
      o.dataset.name = f.name;
      o.selected = f.name === kept;
      return o;
    }));
    factor.value = r.factor;
    edges.checked = r.shapes[0].values[0]().length <= 6000;  // more of them hide the colours
    slider.max = r.shapes.length;
    slider.value = r.shapes.length;
    slider.disabled = r.shapes.length < 2;
  };

  const obey = () => {
    const wish = new URLSearchParams(location.hash.slice(1));
    if (data.runs[Number(wish.get('run')) - 1]) choose(Number(wish.get('run')) - 1);
    const name = [...fields.options].findIndex((o) => o.dataset.name === wish.get('field'));
    if (name >= 0) fields.selectedIndex = name;
    if (Number(wish.get('step')) > 0) slider.value = Number(wish.get('step'));
    if (Number(wish.get('factor')) > 0) factor.value = Number(wish.get('factor'));
    show();
  };

  let timer = 0;
  const stop = () => {
    clearInterval(timer);
    timer = 0;
    element('play').textContent = 'Play';
  };
  element('play').addEventListener('click', () => {
    if (timer) return stop();
    element('play').textContent = 'Stop';
    timer = setInterval(() => {
      slider.value = Number(slider.value) % run().shapes.length + 1;
      show();
    }, 300);
  });

  runs.replaceChildren(...data.runs.map((r, k) => option(r.label, k)));
  element('run-choice').hidden = data.runs.length < 2;
  choose(0);
  obey();
  runs.addEventListener('change', () => { choose(Number(runs.value)); show(); });
  slider.addEventListener('input', () => { stop(); show(); });
  for (const input of [fields, edges]) input.addEventListener('change', show);
  factor.addEventListener('input', () => { if (Number(factor.value) > 0) show(); });
  addEventListener('hashchange', obey);
  addEventListener('resize', draw);
})();
