// Starts gapcheck lsp for decks, and shows the page of `gapcheck audit --html` beside the text.
const { execFile } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

function settings() {
  const all = vscode.workspace.getConfiguration("gapcheck");
  return { program: all.get("path", "gapcheck"), options: all.get("arguments", []) };
}

/// The page of a deck; rejects with what gapcheck says where there is none.
function pageOf(program, options, deck) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "gapcheck-"));
  const page = path.join(folder, "deck.html");
  return new Promise((resolve, reject) => {
    const limits = { cwd: path.dirname(deck), maxBuffer: 64 << 20 };
    execFile(program, ["audit", deck, "--quiet", "--html", page, ...options], limits, (error, _, said) => {
      fs.readFile(page, "utf8", (missing, html) => {
        fs.rm(folder, { recursive: true, force: true }, () => undefined);
        if (missing) reject(new Error(said.trim() || (error && error.message) || "gapcheck wrote no page"));
        else resolve(html);
      });
    });
  });
}

async function showPicture() {
  const editor = vscode.window.activeTextEditor;
  if (!editor || editor.document.isUntitled) return;
  const deck = editor.document.uri.fsPath;
  const { program, options } = settings();
  try {
    const html = await vscode.window.withProgress(
      { location: vscode.ProgressLocation.Notification, title: "gapcheck: " + path.basename(deck) },
      () => pageOf(program, options, deck));
    const panel = vscode.window.createWebviewPanel("gapcheck", path.basename(deck), vscode.ViewColumn.Beside,
      { enableScripts: true, retainContextWhenHidden: true });
    panel.webview.html = html;
  } catch (error) {
    vscode.window.showErrorMessage("gapcheck: " + error.message);
  }
}

function activate(context) {
  context.subscriptions.push(vscode.commands.registerCommand("gapcheck.showPicture", showPicture));
  const { program, options } = settings();
  client = new LanguageClient("gapcheck", "gapcheck", { command: program, args: ["lsp", ...options] },
    { documentSelector: [{ scheme: "file", language: "lsdyna" }] });
  return client.start();
}

function deactivate() {
  return client && client.stop();
}

module.exports = { activate, deactivate };
