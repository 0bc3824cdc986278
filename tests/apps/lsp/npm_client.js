// The protocol's own client for Node speaks with gapcheck lsp: node npm_client.js GAPCHECK FOLDER, with
// vscode-languageserver-protocol where Node finds it.
const assert = require("assert");
const { spawn } = require("child_process");
const path = require("path");
const { pathToFileURL } = require("url");
const fs = require("fs");
const lsp = require("vscode-languageserver-protocol/node");

const [gapcheck, folder] = process.argv.slice(2);
const uri = (name) => pathToFileURL(path.join(folder, name)).toString();

async function main() {
  const server = spawn(gapcheck, ["lsp", "--stdio"], { cwd: folder });
  const connection = lsp.createProtocolConnection(
    new lsp.StreamMessageReader(server.stdout), new lsp.StreamMessageWriter(server.stdin));
  const published = [];
  let waiting = null;
  connection.onNotification(lsp.PublishDiagnosticsNotification.type, (params) => {
    published.push(params);
    if (waiting) waiting();
  });
  connection.onNotification(lsp.LogMessageNotification.type, () => waiting && waiting());
  let applied = null;
  connection.onRequest(lsp.ApplyWorkspaceEditRequest.type, (params) => {
    applied = params;
    if (waiting) waiting();
    return { applied: true };
  });
  const until = async (what, holds) => {
    const end = Date.now() + 20000;
    while (!holds()) {
      assert(Date.now() < end, what);
      await new Promise((resolve) => { waiting = resolve; setTimeout(resolve, 100); });
    }
  };
  connection.listen();
  const started = await connection.sendRequest(lsp.InitializeRequest.type, {
    processId: process.pid, rootUri: pathToFileURL(folder).toString(), capabilities: {},
    workspaceFolders: [{ uri: pathToFileURL(folder).toString(), name: "deck" }],
  });
  assert.strictEqual(started.capabilities.hoverProvider, true);
  await connection.sendNotification(lsp.InitializedNotification.type, {});

  const mesh = uri("mesh türen.k"), main = uri("main deck.k");
  for (const [document, name] of [[mesh, "mesh türen.k"], [main, "main deck.k"]])
    await connection.sendNotification(lsp.DidOpenTextDocumentNotification.type, { textDocument: {
      uri: document, languageId: "lsdyna", version: 1, text: fs.readFileSync(path.join(folder, name), "utf8") } });
  // The server may write the URI of a file in another form than the client.
  const same = (a, b) => decodeURIComponent(a) === decodeURIComponent(b);
  const codes = (document) => {
    const last = published.filter((each) => same(each.uri, document)).pop();
    return last ? last.diagnostics.map((each) => each.code) : [];
  };
  await until("no GC101", () => codes(mesh).includes("GC101"));

  const at = (document, line, character) => ({ textDocument: { uri: document }, position: { line, character } });
  const hover = await connection.sendRequest(lsp.HoverRequest.type, at(main, 7, 9));
  assert(hover.contents.value.includes("`&t` = 1"), hover.contents.value);
  const target = await connection.sendRequest(lsp.DefinitionRequest.type, at(mesh, 2, 19));
  assert(same(target.uri, main), target.uri);
  const list = await connection.sendRequest(lsp.ReferencesRequest.type,
    { ...at(main, 6, 9), context: { includeDeclaration: true } });
  assert.strictEqual(list.length, 3);
  const items = await connection.sendRequest(lsp.CompletionRequest.type, at(main, 8, 5));
  assert(items.items.some((each) => each.label === "*MAT_ELASTIC"));
  const symbols = await connection.sendRequest(lsp.DocumentSymbolRequest.type, { textDocument: { uri: mesh } });
  assert.deepStrictEqual(symbols.map((each) => each.name), ["*PART", "*NODE", "*ELEMENT_SHELL"]);
  assert.strictEqual((await connection.sendRequest(lsp.FoldingRangeRequest.type,
    { textDocument: { uri: mesh } })).length, 3);
  await assert.rejects(connection.sendRequest(lsp.RenameRequest.type, { ...at(mesh, 2, 9), newName: "2" }),
    /part 2 is there already/);
  // A request that the client cancels at once is answered all the same: with its result or as cancelled.
  const source = new lsp.CancellationTokenSource();
  const cancelled = connection.sendRequest(lsp.HoverRequest.type, at(main, 7, 9), source.token);
  source.cancel();
  await cancelled.catch((error) => assert.strictEqual(error.code, lsp.LSPErrorCodes.RequestCancelled));
  await connection.sendRequest(lsp.ExecuteCommandRequest.type, { command: "gapcheck.fix", arguments: [mesh] });
  await until("no edit", () => applied !== null);
  assert(Object.keys(applied.edit.changes).some((each) => same(each, mesh)));

  await connection.sendRequest(lsp.ShutdownRequest.type);
  const ended = new Promise((resolve) => server.on("exit", resolve));
  await connection.sendNotification(lsp.ExitNotification.type);
  assert.strictEqual(await ended, 0);
  connection.dispose();
  console.log("npm client: as expected");
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
