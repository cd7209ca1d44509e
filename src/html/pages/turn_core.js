// The exact motion for other starting values, computed in the page: Polhode itself, compiled to WebAssembly
// (src/page/), in a thread of its own. turn.js asks it when a slider moves.
"use strict";
const turnCore = (() => {
  // what the thread runs; it is read as text, so it sees nothing of the page
  const thread = () => {
    let core;
    const view = () => new DataView(core.memory.buffer);
    // it has no files and no terminal, but it asks for the time
    const system = {
      clock_time_get: (id, precision, place) => {
        view().setBigUint64(place, BigInt(Math.round(1e6 * performance.now())), true);
        return 0;
      },
      environ_sizes_get: (count, size) => {
        view().setUint32(count, 0, true);
        view().setUint32(size, 0, true);
        return 0;
      },
      environ_get: () => 0,
    };
    const start = async (bytes) => {
      const module = await WebAssembly.compile(bytes);
      const imports = {};
      const badFile = 8;
      for (const { module: from, name } of WebAssembly.Module.imports(module)) {
        imports[from] ??= {};
        imports[from][name] = system[name] ?? (() => badFile);
      }
      core = (await WebAssembly.instantiate(module, imports)).exports;
      core._initialize?.();
    };
    const answer = (request) => {
      const words = new TextEncoder().encode(JSON.stringify(request));
      const place = core.polhode_request(words.length);
      new Uint8Array(core.memory.buffer, place, words.length).set(words);
      const size = core.polhode_answer();
      const all = new Uint8Array(core.memory.buffer, core.polhode_answer_bytes(), size);
      const end = 4 + new DataView(all.buffer, all.byteOffset).getUint32(0, true);
      return { about: JSON.parse(new TextDecoder().decode(all.subarray(4, end))), glb: all.slice(end) };
    };
    let started;
    onmessage = async ({ data }) => {
      try {
        if (data.core) started = start(data.core);
        await started;
        if (!data.request) return;
        const { about, glb } = answer(data.request);
        postMessage({ about, glb }, [glb.buffer]);
      } catch (error) {
        postMessage({ about: { error: `the motion cannot be computed here (${error.message})` }, broken: true });
      }
    };
  };

  const PATIENCE = 3000; // ms that an answer nobody wants any more may take
  const LONGEST_REST = 500; // ms
  // with two processors or fewer, what draws needs its turn: as long as an answer took, none is computed
  const rests = (navigator.hardwareConcurrency ?? 1) <= 2;
  let worker = null, working = null, waiting = null, impatience = 0, began = 0, resting = false;

  const bytes = async () => {
    const packed = Uint8Array.from(atob(document.querySelector("script[data-core]").textContent), (one) => one.charCodeAt(0));
    return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
  };
  const end = () => {
    worker?.terminate();
    worker = null;
  };
  const wake = async () => {
    const url = URL.createObjectURL(new Blob([`"use strict"; (${thread})();`], { type: "text/javascript" }));
    worker = new Worker(url);
    URL.revokeObjectURL(url);
    const mine = worker;
    worker.onmessage = ({ data }) => finish(data);
    worker.onerror = (event) => {
      event.preventDefault();
      finish({ about: { error: "the motion cannot be computed here" }, broken: true });
    };
    const core = await bytes();
    if (worker === mine) mine.postMessage({ core }, [core]);
  };
  const next = async () => {
    if (working || !waiting || resting) return;
    began = performance.now();
    working = waiting;
    waiting = null;
    const asked = working;
    if (!worker) await wake();
    if (working === asked) worker.postMessage({ request: asked.request });
  };
  const finish = (answer) => {
    clearTimeout(impatience);
    impatience = 0;
    if (answer?.broken) end();
    const asked = working;
    working = null;
    asked?.done(answer);
    if (rests) {
      resting = true;
      setTimeout(() => {
        resting = false;
        next();
      }, Math.min(LONGEST_REST, performance.now() - began));
    } else {
      next();
    }
  };

  return {
    // whether the page can compute motions
    here: () => document.querySelector("script[data-core]") !== null && typeof WebAssembly === "object" && typeof Worker === "function" && typeof DecompressionStream === "function",
    // Answers { about, glb }, as export/recomputed.h says. Of requests that have to wait, the last counts: the
    // others are answered with null. What takes too long while another waits is given up.
    ask: (request) => new Promise((done) => {
      waiting?.done(null);
      waiting = { request, done };
      if (working && !impatience) {
        impatience = setTimeout(() => {
          end();
          finish(null);
        }, PATIENCE);
      }
      next();
    }),
  };
})();
