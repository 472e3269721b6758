// What the tests of the module share: the module as the page's script has it, and a list of complaints.
import fs from "node:fs";
import vm from "node:vm";
import zlib from "node:zlib";

const script = fs.readFileSync(new URL("../../src/live/page/machine.js", import.meta.url), "utf8");
export const Machine = vm.runInContext(`${script}; Machine`, vm.createContext({WebAssembly, TextDecoder, TextEncoder}));

// The bytes of a module, compressed or not.
export const bytesOf = (file) => {
  const bytes = fs.readFileSync(file);
  return bytes[0] === 0x1f ? zlib.gunzipSync(bytes) : bytes;
};

export const machineOf = (file) => new Machine(new WebAssembly.Module(bytesOf(file)));

const wrong = [];
export const check = (holds, what) => { if (!holds) wrong.push(what); };
export const finish = (summary) => {
  for (const what of wrong) console.log(what);
  console.log(`${summary}; ${wrong.length} complaints`);
  process.exit(wrong.length ? 1 : 0);
};
