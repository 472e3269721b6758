// Machine files by the module and by the program: node machine_files_test.mjs PROGRAM MODULE FOLDER.
// Both must say the same of a file that is wrong, and make the same machine of one that is right.
// Ends with 0; 1 where they differ, which is printed.
import {spawnSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {check, finish, machineOf} from "./machine.mjs";

const [program, module, folder] = process.argv.slice(2), machine = machineOf(module);
fs.mkdirSync(folder, {recursive: true});
const run = (...words) => spawnSync(program, words, {cwd: folder, encoding: "utf8"});
const put = (name, text) => { fs.writeFileSync(path.join(folder, name), text); return name; };
const read = (name) => {
  try {
    return machine.readFile(name, fs.readFileSync(path.join(folder, name), "utf8"));
  } catch (error) {
    return {error: error.message};
  }
};

const fresh = run("machine", "new").stdout;
// The new file with a line in place of the one that begins so.
const changed = (begin, line) => {
  const text = fresh.replace(new RegExp(`^${begin} .*$`, "m"), line);
  if (text === fresh) check(false, `the new file has no line "${begin}"`);
  return text;
};
const bad = {
  "no TOML": "mass = ",
  "no TOML, later": `${fresh}\n[model\n`,
  "a key twice": `${fresh}\n[scene]\nmass = 1\n`,
  "too deep": `${"a.".repeat(40)}a = 1\n`,
  "too large for TOML": changed("mass", "mass = 1e999"),
  "two points": changed("mass", "mass = 1.2.3"),
  "nothing": "",
  "no window": fresh.replace("[window]", "[windows]"),
  "another table": `${fresh}\n[other]\nx = 1\n`,
  "a number for a table": `model = 3\n${fresh}`,
  "unknown key": changed("mass", "mas = 1.2"),
  "unknown key, far": changed("mass", "colour = 1.2"),
  "missing key": changed("mass", ""),
  "missing wall": changed("restitution", "restitution_lower = 0.5"),
  "given twice": changed("restitution", "restitution = 0.5\nrestitution_lower = 0.5"),
  "out of range": changed("mass", "mass = -1"),
  "out of range, a share": changed("restitution", "restitution = 1.5"),
  "not finite": changed("friction", "friction = nan"),
  "infinite": changed("mass", "mass = inf"),
  "walls in the wrong order": changed("wall_upper", 'wall_upper = "-3 mm"'),
  "a word": changed("mass", 'mass = "heavy"'),
  "another unit": changed("mass", 'mass = "3 mm"'),
  "a unit that is none": changed("mass", 'mass = "3 lb"'),
  "a plus": changed("mass", 'mass = "+3 g"'),
  "hexadecimal": changed("mass", 'mass = "0x10 g"'),
  "too large": changed("mass", 'mass = "1e999 g"'),
  "quotes": changed("mass", "mass = \"it's\""),
  "letters beyond ASCII": changed("mass", 'mass = "3 µg"'),
  "a truth": changed("mass", "mass = true"),
  "a list": changed("mass", 'mass = [1, 0.1, "x", [], {a = 1}]'),
  "a date": changed("mass", "mass = 1979-05-27"),
  "a time": changed("mass", "mass = 07:32:00"),
  "both": changed("mass", "mass = 1979-05-27T07:32:00"),
  "no plus_minus": changed("friction", "friction = { value = 0.2 }"),
  "negative plus_minus": changed("friction", "friction = { value = 0.2, plus_minus = -0.1 }"),
  "out of range at an end": changed("friction", "friction = { value = 0.05, plus_minus = 0.1 }"),
  "a profile of nothing": changed("omega", "omega = []"),
  "two windows": changed("revolutions", "revolutions = 10\nseconds = 3"),
  "an endless window": changed("revolutions", "revolutions = -3"),
  "unknown choice": `${fresh}\n[model]\nfidelity = "fine"\n`,
  "a number for a choice": `${fresh}\n[model]\nfidelity = 1.5\n`,
  "a word for a truth": `${fresh}\n[model]\ncontact_friction = "yes"\n`,
  "radius and product": changed("path_radius", "path_radius = 0.065\ncentrifugal_mass_radius = 3"),
};
for (const [what, text] of Object.entries(bad)) {
  const name = put("machine.toml", text), native = run("machine", "check", name), {error} = read(name);
  check(native.status === 2, `${what}: the program takes it`);
  const told = native.stderr.trimEnd().split("\n").at(-1);
  check(told === `ricochet: ${error}`, `${what}: the module says\n  ${error}\nand the program\n  ${told}`);
}
// The module can do less than the program: it says so.
put("machine.toml", changed("omega", "omega = [[0, 0], [1, 6]]"));
check(/^machine.toml: scene.omega is a profile/.test(read("machine.toml").error), "it shows a speed profile");

// What a file makes, by the program's count, and by that of the file that the module writes of it.
const count = (name) => JSON.parse(run("simulate", "--scene", name, "--format", "json").stdout).count;
const good = {
  "machine new": [fresh, /^$/],
  "uncertain": [changed("friction", "friction = { value = 0.2, plus_minus = 0.05 }"), /^scene.friction is uncertain in the file: taken at its value, 0.2$/],
  "uncertain, with a unit": [changed("mass", 'mass = { value = "1200 g", plus_minus = "100 g" }'), /^scene.mass is uncertain in the file: taken at its value, 1.2$/],
  "each wall": [changed("restitution", "restitution_lower = 0.5\nrestitution_upper = 0.75"), /^$/],
  "as version 1 had it": [changed("counting_limit", 'slowest = "5 mm/s"').replace(/^restitution .*$/m, "restitution = [0.5, 0.75]"), /^machine.toml: count.slowest is now called counting_limit\nmachine.toml: scene.restitution = .* restitution_upper$/],
  "compliant": [`${fresh}\n[model]\nfidelity = "compliant"\ncontact_law = "kelvin-voigt"\n`, /^$/],
  "examples/machine.toml": [fs.readFileSync(new URL("../../examples/machine.toml", import.meta.url), "utf8"), /^$/],
};
for (const [what, [text, notes]] of Object.entries(good)) {
  for (const again of [1, 2]) {  // warnings, too, are told of every file
    const name = put("machine.toml", text), found = read(name);
    if (found.error) {
      check(false, `${what}: ${found.error}`);
      continue;
    }
    check(notes.test(found.notes.join("\n")), `${what}, ${again}: it notes ${JSON.stringify(found.notes)}`);
    machine.set(found.numbers);
    const own = machine.simulate(found.numbers[machine.fields.find(({key}) => key === "omega").place], 0).count, native = count(name);
    check(own === native, `${what}: ${own} collisions, by the program ${native}`);
    const back = read(put("written.toml", machine.file()));
    check(back.error === undefined && found.numbers.every((x, k) => Object.is(x, back.numbers[k])), `${what}: the file that the module writes is another machine: ${back.error ?? ""}`);
    check(count("written.toml") === native, `${what}: the program counts otherwise in the file that the module writes`);
  }
}

// A file that is refused leaves the machine as it was.
const before = machine.file();
read(put("machine.toml", bad["out of range"]));
check(machine.file() === before, "a file that is refused changes the machine");

finish(`${Object.keys(bad).length} wrong files, ${Object.keys(good).length} right ones`);
