// The VS Code extension as far as a run without VS Code goes: node vscode_extension.js GAPCHECK EXTENSION FOLDER TOOLS. The
// grammar by the library that VS Code uses; the code with a stand-in for the module `vscode`.
const assert = require("assert");
const fs = require("fs");
const Module = require("module");
const path = require("path");

const [gapcheck, extension, folder, tools] = process.argv.slice(2);
const fromTools = (name) => require(path.join(tools, "node_modules", name));
const manifest = JSON.parse(fs.readFileSync(path.join(extension, "package.json"), "utf8"));

async function checkGrammar() {
  const { Registry, parseRawGrammar } = fromTools("vscode-textmate");
  const oniguruma = fromTools("vscode-oniguruma");
  const wasm = fs.readFileSync(path.join(tools, "node_modules/vscode-oniguruma/release/onig.wasm"));
  await oniguruma.loadWASM(wasm.buffer);
  const file = path.join(extension, manifest.contributes.grammars[0].path);
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => parseRawGrammar(fs.readFileSync(file, "utf8"), file),
  });
  const grammar = await registry.loadGrammar("source.lsdyna");
  const lines = ["$ comment", "*NODE", "       1             1.0", "$ gapcheck: ignore GC1", "*PART", "         1      &pid",
    "1,&t,2.5", "*TITLE", "any 1,2 text"];
  let stack = null;
  const found = lines.map((line) => {
    const result = grammar.tokenizeLine(line, stack);
    stack = result.ruleStack;
    return result.tokens.map((token) => `${token.startIndex}-${token.endIndex} ${token.scopes.at(-1)}`);
  });
  const has = (line, token) => assert(found[line].includes(token), `${lines[line]}: ${found[line].join("; ")}`);
  has(0, "0-9 comment.line.lsdyna");
  has(1, "1-5 keyword.control.lsdyna");
  has(2, "0-8 constant.numeric.field.lsdyna");
  has(2, "8-24 variable.other.field.lsdyna");
  has(3, "0-22 comment.line.directive.lsdyna");
  has(4, "1-5 keyword.control.lsdyna");
  has(5, "0-10 constant.numeric.field.lsdyna");
  has(5, "16-20 variable.parameter.lsdyna");
  has(6, "2-4 variable.parameter.lsdyna");
  has(6, "5-8 constant.numeric.field.lsdyna");
  has(8, "0-12 string.unquoted.lsdyna");
}

function checkMatcher() {
  const pattern = manifest.contributes.problemMatchers[0].pattern;
  const { spawnSync } = require("child_process");
  const run = spawnSync(gapcheck, ["audit", "main deck.k", "--format", "github"], { cwd: folder, encoding: "utf8" });
  const matches = run.stdout.split("\n").map((line) => line.match(new RegExp(pattern.regexp))).filter((match) => match);
  const match = matches.find((each) => each[pattern.code] === "GC101");
  assert(match, run.stdout);
  assert.strictEqual(match[pattern.severity], "warning");
  assert(match[pattern.file].endsWith("mesh türen.k") && Number(match[pattern.line]) > 0, match[0]);
}

async function checkCode() {
  const commands = {}, panels = [], errors = [];
  const values = { path: gapcheck, arguments: [] };
  let deck = path.join(folder, "main deck.k");
  const vscode = {
    workspace: { getConfiguration: () => ({ get: (name, otherwise) => values[name] ?? otherwise }) },
    window: {
      get activeTextEditor() { return { document: { isUntitled: false, uri: { fsPath: deck } } }; },
      withProgress: (_, work) => work(),
      createWebviewPanel: (...given) => { panels.push({ given, webview: {} }); return panels.at(-1); },
      showErrorMessage: (text) => errors.push(text),
    },
    commands: { registerCommand: (name, action) => { commands[name] = action; return {}; } },
    ProgressLocation: { Notification: 15 }, ViewColumn: { Beside: -2 },
  };
  const started = [];
  class LanguageClient {
    constructor(...given) { started.push(given); }
    start() { return Promise.resolve(); }
    stop() { return Promise.resolve(); }
  }
  const load = Module._load;
  Module._load = (name, ...more) =>
    name === "vscode" ? vscode : name === "vscode-languageclient/node" ? { LanguageClient } : load(name, ...more);
  const code = require(path.join(extension, manifest.main));
  await code.activate({ subscriptions: [] });
  assert.deepStrictEqual(started[0][2], { command: gapcheck, args: ["lsp"] });
  assert.strictEqual(started[0][3].documentSelector[0].language, manifest.contributes.languages[0].id);
  await commands[manifest.contributes.commands[0].command]();
  assert.deepStrictEqual(errors, []);
  assert(panels[0].webview.html.includes("<html") && panels[0].given[3].enableScripts);
  deck = path.join(folder, "no such deck.k");
  await commands["gapcheck.showPicture"]();
  assert(panels.length === 1 && errors.length === 1 && errors[0].includes("no such deck.k"), errors.join());
  await code.deactivate();
  Module._load = load;
  // The client that the package takes along is the real one.
  assert(fs.existsSync(path.join(extension, "node_modules/vscode-languageclient/node.js")));
}

checkGrammar().then(checkMatcher).then(checkCode).then(() => console.log("VS Code extension: as expected"), (error) => {
  console.error(error);
  process.exit(1);
});
