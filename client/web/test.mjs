// Runs the unit tests of tests/: `node test.mjs FOLDER [REPORT]` compiles them into FOLDER; REPORT is a JUnit file.
import { spawnSync } from "node:child_process";
import { readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const [folder = join(here, "dist-tests"), report] = process.argv.slice(2);

function run(...words) {
  const { status } = spawnSync(process.execPath, words, { stdio: "inherit" });
  if (status !== 0) process.exit(status ?? 1);
}

run(join(here, "node_modules/typescript/bin/tsc"), "--project", join(here, "tsconfig.tests.json"), "--outDir", folder);
writeFileSync(join(folder, "package.json"), '{"type": "module"}\n');
const tests = readdirSync(join(folder, "tests")).filter((name) => name.endsWith(".test.js"));
const reporters = ["--test-reporter=spec", "--test-reporter-destination=stdout"];
if (report) reporters.push("--test-reporter=junit", `--test-reporter-destination=${report}`);
run("--test", ...reporters, ...tests.map((name) => join(folder, "tests", name)));
