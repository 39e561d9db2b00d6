"use strict";
/* Runs parts of a page in Node: `node view_check.cjs PAGE TASK.json` prints the answers to a task as JSON. */
const fs = require("node:fs");
const vm = require("node:vm");

const [, , page, taskFile] = process.argv;
const task = JSON.parse(fs.readFileSync(taskFile, "utf8"));
const context = vm.createContext({ console, atob });
const names = ["library", "functions", "Screws", "Kinematics"];
let source = "";
if (task.script) {
  source = `${fs.readFileSync(task.script, "utf8")};\nglobalThis.functions = ${task.constant};`;
} else {
  const html = fs.readFileSync(page, "utf8");
  const scripts = [...html.matchAll(/<script>\n?([\s\S]*?)<\/script>/g)].map((found) => found[1]);
  const data = /<script type="application\/json" id="data">([\s\S]*?)<\/script>/.exec(html)[1];
  source = [...scripts.slice(0, 4), ...names.map((name) => `globalThis.${name} = ${name};`), `globalThis.data = ${data};`].join("\n");
}
vm.runInContext(source, context);

const plain = (value) => {
  if (typeof value === "number") {
    return Number.isFinite(value) ? value : String(value);
  }
  if (value === null || typeof value !== "object") {
    return value;
  }
  return ArrayBuffer.isView(value) || Array.isArray(value)
    ? Array.from(value, plain)
    : Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)]));
};
const read = (value) => (Array.isArray(value) ? value.map(read) : typeof value === "string" ? Number(value) : value);

const answers = task.calls.map(([what, name, ...given]) => {
  if (what === "function") {
    return plain(context.functions[name](...given.map(read)));
  }
  if (what === "screws") {
    return plain(context.Screws[name](...given.map(read)));
  }
  context.model ??= context.Kinematics.make(context.data, context.functions);
  return plain(context.model[name](...given.map(read)));
});
process.stdout.write(JSON.stringify(answers));
