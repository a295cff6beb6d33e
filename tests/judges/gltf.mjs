// Khronos' validator over glTF files: each has to be without an error or a warning. What it can't judge it says in notes,
// which don't count: it knows no EXT_mesh_gpu_instancing, and so finds the accessors of instances unused.
// usage: node gltf.mjs FILE...
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

const WARNING = 1;
let bad = 0;
for (const path of process.argv.slice(2)) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(path)), { maxIssues: 10000 });
  for (const { code, message, pointer, severity } of issues.messages) {
    if (severity <= WARNING) console.error(`${path}: ${code} at ${pointer}: ${message}`);
  }
  console.log(`${path}: ${issues.numErrors} errors, ${issues.numWarnings} warnings`);
  bad += issues.numErrors + issues.numWarnings;
}
process.exit(bad > 0 ? 1 : 0);
