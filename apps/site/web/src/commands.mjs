// SPDX-License-Identifier: GPL-3.0-or-later
import { execFile } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdir, mkdtemp, readFile, rename, rm, symlink, writeFile } from "node:fs/promises";
import os from "node:os";
import path from "node:path";
import { promisify } from "node:util";

const call = promisify(execFile);

export const digest = (...parts) => {
  const hash = createHash("sha256");
  for (const part of parts) hash.update(part).update("\0");
  return hash.digest("hex").slice(0, 32);
};

/**
 * Runs commands as a reader would, in a folder of their own beside the checkout's `apps` and `papers`, and keeps what they
 * gave for as long as the program stays the same.
 */
export class Commands {
  constructor({ checkout, program, python, module, cache }) {
    Object.assign(this, { checkout, program, python, module, cache });
  }

  async begin() {
    await mkdir(this.cache, { recursive: true });
    this.state = digest(await readFile(this.program));
    this.environment = {
      PATH: `${path.dirname(this.program)}:/usr/local/bin:/usr/bin:/bin`, LANG: "C.UTF-8", HOME: this.cache,
      PYTHONPATH: this.module, RADCERT_STORE: path.join(this.cache, "store"), PYTHONDONTWRITEBYTECODE: "1",
    };
  }

  async kept(key, make) {
    const file = path.join(this.cache, key);
    try {
      return await readFile(file);
    } catch {
      const made = await make();
      const temporary = `${file}.${process.pid}`;
      await writeFile(temporary, made);
      await rename(temporary, file);
      return made;
    }
  }

  async inFolder(action) {
    const folder = await mkdtemp(path.join(os.tmpdir(), "radcert-site-"));
    try {
      for (const part of ["apps", "papers"]) await symlink(path.join(this.checkout, part), path.join(folder, part));
      return await action(folder);
    } finally {
      await rm(folder, { recursive: true });
    }
  }

  async run(command, folder) {
    const [program, ...words] = command.split(" ");
    const file = program === "python3" ? this.python : program;
    const { stdout } = await call(file, words, { cwd: folder, env: this.environment, maxBuffer: 1 << 28 });
    return stdout;
  }

  /** What a command prints. */
  async printed(command) {
    const key = `printed-${digest(this.state, command)}`;
    return (await this.kept(key, () => this.inFolder((folder) => this.run(command, folder)))).toString();
  }

  /** The bytes of a file that a command writes. */
  picture(command, name) {
    const key = `picture-${digest(this.state, command, name)}`;
    return this.kept(key, () => this.inFolder(async (folder) => {
      await this.run(command, folder);
      return readFile(path.join(folder, name));
    }));
  }

  /** What a script of Python writes as JSON: `state` is what the result depends on. */
  async json(script, words, state) {
    const key = `json-${digest(this.state, await readFile(script), ...state)}`;
    return JSON.parse((await this.kept(key, () => this.inFolder(async (folder) => {
      const [first, ...options] = words;
      await call(this.python, ["-B", script, first, path.join(folder, "out.json"), ...options],
        { cwd: folder, env: this.environment, maxBuffer: 1 << 28 });
      return readFile(path.join(folder, "out.json"));
    }))).toString());
  }
}
