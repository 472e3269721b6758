"use strict";

// Machine files, as docs/machine-files.md describes them: TOML from and to the numbers of a machine.

// The number that a value of the file gives for a field; throws an Error that says what is wrong.
const numberIn = (machine, field, value, notes) => {
  const place = `${field.table}.${field.key}`, given = typeof value === "string" ? `"${value}"` : String(value);
  if (field.choices) {
    const choice = field.choices.indexOf(String(value));
    if (choice < 0 || (typeof value === "boolean") !== (field.choices[0] === "false")) throw new Error(`${place} = ${given}: must be ${field.choices.join(" or ")}`);
    return choice;
  }
  if (typeof value === "number") return value;
  if (typeof value === "bigint") return Number(value);
  if (typeof value === "string") {
    if (field.key === "contact_speed" && value === "each") return NaN;
    const number = machine.quantity(value, field.unit);
    if (!Number.isNaN(number)) return number;
  } else if (Array.isArray(value) && field.key === "omega") {
    throw new Error("scene.omega is a profile: this page takes a constant speed");
  } else if (value !== null && typeof value === "object" && "value" in value) {
    notes.push(`${place} is uncertain in the file: taken at its value`);
    return numberIn(machine, field, value.value, notes);
  }
  throw new Error(`${place} = ${given}: must be a number${field.unit.length > 1 ? `, or one with a unit, such as "1 ${field.unit}"` : ""}`);
};

// What the file says under other keys than those of the numbers.
const otherKeys = {scene: ["restitution", "path_radius"], window: [], count: ["slowest"], model: []};

const refuseUnknown = (machine, file, notes) => {
  for (const [name, table] of Object.entries(file)) {
    if (name === "across") notes.push("[across] is left out: this page has one direction");
    else if (!(name in otherKeys)) throw new Error(`[${name}]: there is no such table`);
    else for (const key of Object.keys(table)) {
      const known = otherKeys[name].includes(key) || machine.fields.some((field) => field.table === name && field.key === key);
      if (!known) throw new Error(`${name}.${key}: there is no such key`);
    }
  }
};

// The numbers of a machine file, and what was left out of it, as sentences.
const readMachineFile = (machine, text) => {
  const file = TOML.parse(text), notes = [], numbers = [];
  refuseUnknown(machine, file, notes);
  const scene = file.scene ?? {}, count = {...file.count};
  if ("slowest" in count) {
    count.counting_limit ??= count.slowest;
    notes.push("count.slowest is now called counting_limit");
  }
  if ("restitution" in scene) {
    const both = [].concat(scene.restitution);
    scene.restitution_lower ??= both[0];
    scene.restitution_upper ??= both.at(-1);
  }
  const tables = {scene, window: file.window ?? {}, count, model: file.model ?? {}};
  for (const field of machine.fields) {
    const value = tables[field.table][field.key];
    if (value !== undefined) numbers.push(numberIn(machine, field, value, notes));
    else if (field.required) throw new Error(`${field.table}.${field.key}: must be given`);
    else numbers.push(field.table === "window" ? NaN : field.usual);
  }
  const at = (key) => machine.fields.find((field) => field.key === key).place;
  if ("path_radius" in scene) {
    numbers[at("centrifugal_mass_radius")] = numbers[at("mass")] * numberIn(machine, {table: "scene", key: "path_radius", unit: "m"}, scene.path_radius, notes);
  }
  if (file.model?.contact_law === "kelvin-voigt" && !("contact_exponent" in file.model)) numbers[at("contact_exponent")] = 1;
  return {numbers, notes};
};

const tomlFloat = (x) => {
  if (!Number.isFinite(x)) return x > 0 ? "inf" : "-inf";
  const text = String(x);
  return /[.e]/.test(text) ? text : `${text}.0`;
};

// The machine as a file: what every command of ricochet reads by --scene.
const writeMachineFile = (machine, numbers) => {
  const lines = [], number = (key) => numbers[machine.fields.find((field) => field.key === key).place];
  const add = (key, value, field) => {
    const unit = [field.unit === "1" ? "" : field.unit, field.range].filter(Boolean).join(" ");
    const remark = [unit, field.remark].filter(Boolean).join(": ");
    lines.push(`${key} = ${value}${remark ? `  # ${remark}` : ""}`);
  };
  let table = "";
  for (const field of machine.fields) {
    const x = numbers[field.place];
    if (field.table !== table) lines.push(`${table ? "\n" : ""}[${table = field.table}]`);
    if (field.key === "restitution_lower" && x === number("restitution_upper")) add("restitution", tomlFloat(x), field);
    else if (field.key === "restitution_upper" && x === number("restitution_lower")) continue;
    else if (field.choices) add(field.key, field.choices[0] === "false" ? field.choices[x] : `"${field.choices[x]}"`, field);
    else if (!Number.isNaN(x)) add(field.key, tomlFloat(x), field);
    else if (field.key === "contact_speed") add(field.key, '"each"', field);
  }
  return `${lines.join("\n")}\n`;
};
