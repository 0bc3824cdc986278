-- Neovim's own client speaks with gapcheck lsp: nvim --headless -u NONE -l is newer than Debian's, so that
-- check_clients.py starts `nvim --headless -u NONE -c "luafile neovim.lua"`. In the environment: GAPCHECK and FOLDER.
local gapcheck, folder = os.getenv("GAPCHECK"), os.getenv("FOLDER")

local function fail(what)
  io.stderr:write("neovim: " .. what .. "\n")
  vim.cmd("cquit 1")
end

local function check(condition, what)
  if not condition then fail(what) end
end

local function run()
  vim.cmd("edit " .. vim.fn.fnameescape(folder .. "/mesh türen.k"))
  local buffer = vim.api.nvim_get_current_buf()
  local logged = {}
  local id = vim.lsp.start_client({
    name = "gapcheck",
    cmd = { gapcheck, "lsp" },
    root_dir = folder,
    handlers = { ["window/logMessage"] = function(_, result) table.insert(logged, result.message) end },
  })
  check(id, "the client did not start")
  vim.lsp.buf_attach_client(buffer, id)
  local client = vim.lsp.get_client_by_id(id)
  local function ask(method, params)
    local response, why = client.request_sync(method, params, 10000, buffer)
    check(response and not response.err, method .. ": " .. vim.inspect(response and response.err or why))
    return response.result
  end
  local document = vim.lsp.util.make_text_document_params(buffer)
  local function at(line, character)
    return { textDocument = document, position = { line = line, character = character } }
  end

  -- The audit of the main deck, which was found by its include, marks lines of this file.
  check(vim.wait(20000, function() return #logged > 0 end), "no audit")
  check(vim.wait(5000, function() return #vim.diagnostic.get(buffer) > 0 end), "no diagnostics")
  local codes = {}
  for _, each in ipairs(vim.diagnostic.get(buffer)) do codes[each.user_data.lsp.code or ""] = true end
  check(codes.GC101, "GC101 is missing: " .. vim.inspect(codes))

  -- A letter in a number while one types, and no more when it is undone.
  local function errors()
    local errors = vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR })
    return #errors, errors[1]
  end
  vim.api.nvim_buf_set_text(buffer, 6, 20, 6, 21, { "x" })
  check(vim.wait(5000, function() return errors() == 1 end), "no error while typing")
  local _, first = errors()
  check(first.lnum == 6 and first.message:find("field x"), vim.inspect(first))
  vim.cmd("undo")
  check(vim.wait(5000, function() return errors() == 0 end), "the error stays")

  -- Neovim sends what changed in units of UTF-16. A server that is one off has another text then.
  math.randomseed(3)
  local pieces = { "ä", "😀", "x", "*PART", "", "1,2", "€" }
  for _ = 1, 200 do
    local count = vim.api.nvim_buf_line_count(buffer)
    local row = math.random(0, count - 1)
    local line = vim.api.nvim_buf_get_lines(buffer, row, row + 1, true)[1]
    local from = vim.str_byteindex(line, math.random(0, vim.str_utfindex(line)))
    local text = { pieces[math.random(#pieces)] }
    if math.random(4) == 1 then table.insert(text, pieces[math.random(#pieces)]) end
    vim.api.nvim_buf_set_text(buffer, row, from, row, math.random(3) == 1 and #line or from, text)
  end
  local by_edits = ask("textDocument/documentSymbol", { textDocument = document })
  local whole = table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, true), "\n") .. "\n"
  local copy = { uri = document.uri .. ".copy.k" }
  client.notify("textDocument/didOpen",
    { textDocument = { uri = copy.uri, languageId = "lsdyna", version = 1, text = whole } })
  check(vim.deep_equal(by_edits, ask("textDocument/documentSymbol", { textDocument = copy })), "the texts differ")
  check(#by_edits > 3, "no symbols")
  vim.cmd("silent undo 0")

  -- Hover, definition, rename and format through Neovim's own functions.
  local hover = ask("textDocument/hover", at(2, 19))
  check(hover.contents.value:find("**SECID**", 1, true), vim.inspect(hover))
  local target = ask("textDocument/definition", at(2, 19))
  check(target.uri:find("main%%20deck.k"), vim.inspect(target))
  vim.api.nvim_win_set_cursor(0, { 3, 9 })
  vim.lsp.buf.rename("12")
  check(vim.wait(5000, function()
    return vim.api.nvim_buf_get_lines(buffer, 2, 3, true)[1]:find("^        12         1") ~= nil
  end), "not renamed: " .. vim.api.nvim_buf_get_lines(buffer, 2, 3, true)[1])
  local elements = 0
  for _, line in ipairs(vim.api.nvim_buf_get_lines(buffer, 0, -1, true)) do
    if line:find("^ +%d+      12 ") then elements = elements + 1 end
  end
  check(elements == 4, "renamed in " .. elements .. " elements")
  vim.api.nvim_buf_set_lines(buffer, 2, 3, true, { "12,1,1" })
  local edits = ask("textDocument/rangeFormatting", { textDocument = document, options = { tabSize = 8 },
    range = { start = { line = 2, character = 0 }, ["end"] = { line = 3, character = 0 } } })
  vim.lsp.util.apply_text_edits(edits, buffer, client.offset_encoding)
  check(vim.api.nvim_buf_get_lines(buffer, 2, 3, true)[1] == "        12         1         1", "not formatted")

  client.stop()
  check(vim.wait(5000, function() return client.is_stopped() end), "the server does not stop")
end

local ok, why = pcall(run)
if not ok then fail(tostring(why)) end
vim.cmd("qall!")
