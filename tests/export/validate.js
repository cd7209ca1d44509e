// SPDX-License-Identifier: MIT
// Asks the validator of the Khronos Group about files of `polhode export`: no errors and no warnings.
// usage: validate.js POLHODE SCENES
"use strict";
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const validator = require("gltf-validator");
const [polhode, scenes] = process.argv.slice(2);

(async () => {
  let bad = 0;
  for (const name of fs.readdirSync(scenes).filter((one) => one.endsWith(".toml"))) {
    if (/^\[\[panel\]\]|^\[sweep\]/m.test(fs.readFileSync(`${scenes}/${name}`, "utf8"))) continue; // a film of several scenes
    const part = name === "euler_disc.toml" ? ["--to", "2"] : []; // it turns ever faster: the table of the whole is too large
    const bytes = execFileSync(polhode, ["export", `${scenes}/${name}`, ...part, "-o", "-", "--quiet"], { maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "inherit"] });
    const { issues } = await validator.validateBytes(new Uint8Array(bytes));
    const worst = issues.messages.filter((one) => one.severity < 2);
    console.log(issues.numErrors + issues.numWarnings === 0 ? "ok" : "BAD", name, `${(bytes.length * 1e-6).toFixed(2)} MB`);
    for (const one of worst.slice(0, 5)) console.log("  ", one.code, one.message, one.pointer);
    bad += issues.numErrors + issues.numWarnings;
  }
  process.exit(bad ? 1 : 0);
})();
