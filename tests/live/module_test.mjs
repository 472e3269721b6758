// The module against the native program: node module_test.mjs SCENES MODULE FOLDER [COMPARED], where
// SCENES is the program of scenes.cpp and MODULE the module, compressed or not. A module with the
// bytes of COMPARED, which another test compares, is not compared again. Ends with 0; 1 where they
// differ, which is printed; 77 where there is no such module and CI is not set.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {Machine, bytesOf, check, finish, machineOf} from "./machine.mjs";

const [program, file, folder, compared] = process.argv.slice(2);
if (!fs.existsSync(file)) {
  console.log(`${file} is missing: Debian's Clang for WebAssembly is not there; .ci/run installs it`);
  process.exit(process.env.CI ? 1 : 77);
}
if (compared && bytesOf(file).equals(bytesOf(compared))) {
  console.log(`the same ${bytesOf(file).length} bytes as ${compared}`);
  process.exit(0);
}
const number = 100_000;
fs.mkdirSync(folder, {recursive: true});
const answers = path.join(folder, "scenes.bin");
execFileSync(program, [String(number), answers]);
const bytes = fs.readFileSync(answers), all = new Float64Array(bytes.buffer, bytes.byteOffset, bytes.length / 8);
fs.rmSync(answers);

const started = performance.now(), machine = machineOf(file), ready = performance.now();
check(WebAssembly.Module.imports(machine.module).every(({module}) => module === "wasi_snapshot_preview1"), "the module asks for more than a terminal");

let at = 0;
const next = (size) => all.subarray(at, at += size);
const [fields, scenes] = next(2);
check(scenes === number && fields === machine.fields.length, `${fields} numbers a scene, ${machine.fields.length} in the module`);

const omega = machine.fields.findIndex(({key}) => key === "omega");
let differ = 0, collisions = 0, endless = 0;
for (let k = 0; k < scenes; ++k) {
  const numbers = next(fields), [count] = next(1);
  let own = NaN;
  try {
    machine.set(numbers);
    [own] = machine.counts(numbers[omega], 0, 1);
    collisions += own;
  } catch {
    ++endless;
  }
  if (!Object.is(own, count) && ++differ <= 5) check(false, `scene ${k}: ${own} collisions, native ${count}`);
}
const counted = performance.now();
check(differ === 0, `${differ} of ${scenes} scenes have another count`);
check(collisions > 5 * scenes, `only ${collisions} collisions`);

// The paper's first four cases: all that the page shows of them.
const list = () => next(next(1)[0]);
const same = (own, native, what, most = 0) => {
  check(own.length === native.length, `${what}: ${own.length} numbers, native ${native.length}`);
  const far = Array.from(native).findIndex((x, k) => !(Object.is(own[k], x) || Math.abs(own[k] - x) <= most * Math.abs(x)));
  check(far < 0, `${what}: number ${far} is ${own[far]}, native ${native[far]}`);
};
for (const {id, threshold} of machine.cases.slice(0, 4)) {
  machine.set(next(fields));
  const counts = machine.counts(0.02, 0.02, 900), native = list();
  same(counts, native, `${id}, counts`);
  const {count, impacts} = machine.simulate(9, 0);
  same([count, ...impacts.flatMap(({time, speed}) => [time, speed])], list(), `${id}, impacts`, 1e-9);
  same(machine.regimes(0.01, 18).flatMap(({from, to, most}) => [from, to, most]), list(), `${id}, regimes`, 1e-9);
  const {quiet, limit, threshold: split, loud, misclassified} = machine.windowRule(counts, 0.02, 1, threshold);
  same([quiet, split, loud, misclassified], list(), `${id}, the paper's rule`);
  for (const [racer, name] of Machine.racers.entries()) {
    same(machine.race(racer, 7, 100, limit, 18).flatMap(({omega: x, count: there}) => [x, there]), list(), `${id}, ${name}`, 1e-9);
  }
  same([machine.raceGoal(limit, 18)], list(), `${id}, goal of the race`, 1e-9);
  const border = machine.regimes(0.01, 18).find(({most}) => most > 2).from, [nativeBorder, below, ...nativeMoves] = list();
  const moves = machine.sensitivities(border).map(({percent}) => percent);
  same([border, machine.quietLimitBelow(border)], [nativeBorder, below], `${id}, border`, 1e-9);
  check(moves.length === nativeMoves.length && moves.every((x, k) => Math.abs(x - nativeMoves[k]) < 1e-6), `${id}: moved by ${moves}, native ${nativeMoves}`);
}
check(at === all.length, `${all.length - at} numbers are left`);

// What the machine refuses leaves it as it was.
const before = machine.counts(0.02, 0.02, 900), spoilt = [...machine.numbers];
spoilt[machine.fields.findIndex(({key}) => key === "mass")] = -1;
let said = "";
try { machine.set(spoilt); } catch (error) { said = error.message; }
check(/mass = -1: must be/.test(said), `a negative mass: ${said}`);
same(machine.counts(0.02, 0.02, 900), before, "after a refusal");
check(machine.quantity("0.9 mm", "m") === 0.0009 && Number.isNaN(machine.quantity("0.9 inch", "m")), "units");

const mean = (counted - ready) / scenes;
finish(`${scenes} scenes, ${collisions} collisions, ${endless} endless; ready after ${(ready - started).toFixed(0)} ms, ${(1000 * mean).toFixed(0)} us a scene`);
