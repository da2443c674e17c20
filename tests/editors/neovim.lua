-- What Neovim shows of the samples, and what it does to them. Ends with status 1 at the first difference.
local folder = os.getenv('AXISC_SAMPLES')

local function check(condition, what)
  if condition then return end
  io.stderr:write('neovim: ' .. what .. '\n')
  vim.cmd('cquit 1')
end

local function wait(condition, what)
  check(vim.wait(20000, condition, 10), what)
end

local function lint(file, wanted)
  local text = vim.fn.system({'axisc', 'lint', file, '--format', 'json'})
  return vim.tbl_filter(function(finding)
    return vim.fn.fnamemodify(finding.file, ':t') == wanted
  end, vim.json.decode(text).diagnostics)
end

local function open(file)
  vim.cmd('edit ' .. folder .. '/' .. file)
  wait(function() return #vim.lsp.buf_get_clients() == 1 end, file .. ' has no server')
end

-- The same findings at the same places.
local function equals_lint(input, file)
  open(file)
  local expected = lint(folder .. '/' .. input, vim.fn.fnamemodify(file, ':t'))
  wait(function() return #vim.diagnostic.get(0) == #expected end,
    file .. ' shows ' .. #vim.diagnostic.get(0) .. ' findings, lint ' .. #expected)
  local shown = vim.diagnostic.get(0)
  table.sort(shown, function(a, b) return a.lnum < b.lnum or (a.lnum == b.lnum and a.col < b.col) end)
  table.sort(expected, function(a, b) return a.line < b.line or (a.line == b.line and a.column < b.column) end)
  for i, finding in ipairs(expected) do
    check(shown[i].lnum == finding.line - 1, file .. ': line of finding ' .. i)
    check(vim.startswith(shown[i].message, finding.message), file .. ': message of finding ' .. i)
  end
  return #expected
end

local function ask(method, line, character, more)
  local params = vim.tbl_extend('force', {
    textDocument = vim.lsp.util.make_text_document_params(),
    position = {line = line, character = character},
  }, more or {})
  local answers = vim.lsp.buf_request_sync(0, 'textDocument/' .. method, params, 20000)
  check(answers and next(answers), method .. ' is not answered')
  local _, answer = next(answers)
  check(not answer.error, method .. ': ' .. vim.inspect(answer.error))
  return answer.result
end

local function line_of(text)
  return vim.fn.search('\\V' .. text, 'cnw') - 1
end

local function run()
  check(equals_lint('mistakes/typing.lis', 'mistakes/typing.lis') > 5, 'the sample has findings')
  equals_lint('mistakes/controller/listen/hochlauf.lis', 'mistakes/controller/listen/sda_mds1.lis')
  equals_lint('mistakes/controller/listen/hochlauf.lis', 'mistakes/controller/listen/hochlauf.lis')
  equals_lint('mill/machine.json', 'mill/machine.json')
  equals_lint('mill/machine.json', 'mill/x.lis')

  open('mill/default.lis')
  check(vim.bo.filetype == 'axis-list', 'the file type')
  local filter = line_of('filter[0].fg_f0')
  local hover = ask('hover', filter, 3).contents.value
  check(hover:find('P-AXIS-00067', 1, true), 'the page of a name')
  check(ask('hover', filter, 53).contents.value:find('42 Hz', 1, true), 'the quantity of a value')

  vim.api.nvim_win_set_cursor(0, {filter + 1, 0})
  vim.cmd('normal! Ofilter[0].ty')
  local found = vim.lsp.omnifunc(1, '')
  check(found == -2 or found >= 0, 'completion')
  local items = ask('completion', filter, 12)
  check(#vim.tbl_filter(function(item) return item.label == 'type' end, items.items or items) == 1, 'names are completed')
  vim.cmd('undo')

  -- A mistake, and its fix.
  local text = vim.api.nvim_buf_get_lines(0, filter, filter + 1, false)[1]
  vim.api.nvim_buf_set_lines(0, filter, filter + 1, false, {(text:gsub('42 ', '42,5'))})
  wait(function() return #vim.diagnostic.get(0, {lnum = filter}) == 1 end, 'the mistake is shown')
  local actions = ask('codeAction', 0, 0, {
    range = {start = {line = filter, character = 0}, ['end'] = {line = filter, character = 60}},
    context = {diagnostics = {}, only = {'quickfix'}},
  })
  check(#actions > 0 and actions[1].edit ~= nil and actions[1].title:find('42.5', 1, true), 'the fix comes first')
  vim.ui.select = function(offered, _, choose) choose(offered[1], 1) end
  vim.api.nvim_win_set_cursor(0, {filter + 1, 53})
  vim.cmd('normal \\a')
  wait(function() return #vim.diagnostic.get(0, {lnum = filter}) == 0 end, 'the fix ends the finding')
  check(vim.api.nvim_buf_get_lines(0, filter, filter + 1, false)[1]:find('42.5', 1, true), 'the fix is applied')

  -- Layout as fmt writes it.
  vim.api.nvim_buf_set_lines(0, filter, filter + 1, false, {'filter[0].fg_f0 42 ( Hz'})
  local copy = vim.fn.tempname() .. '.lis'
  vim.cmd('silent write ' .. copy)
  vim.fn.system({'axisc', 'fmt', copy})
  if vim.lsp.buf.format then vim.lsp.buf.format({timeout_ms = 20000}) else vim.lsp.buf.formatting_sync(nil, 20000) end
  check(table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n') == table.concat(vim.fn.readfile(copy), '\n'),
    'the layout is that of fmt')

  open('controller/listen/hochlauf.lis')
  local named = line_of('achs_mds[2]')
  local character = vim.api.nvim_buf_get_lines(0, named, named + 1, false)[1]:find('achsmds3', 1, true)
  vim.api.nvim_win_set_cursor(0, {named + 1, character})
  vim.cmd('normal gd')
  wait(function() return vim.fn.expand('%:t') == 'achsmds3.lis' end, 'gd opens the file')
  open('controller/listen/hochlauf.lis')
  check(ask('definition', named, character).uri:find('achsmds3.lis', 1, true), 'the name of a file leads to it')
  check(#ask('documentSymbol', 0, 0) > 3, 'symbols')

  -- Settings apply at once.
  open('manual/axis-pt1.lis')
  wait(function() return #vim.diagnostic.get(0) == 1 end, 'a list alone has no cycle time')
  local client = vim.lsp.buf_get_clients()[1] or select(2, next(vim.lsp.buf_get_clients()))
  client.config.settings = {axisc = {cycleTime = '1ms'}}
  client.notify('workspace/didChangeConfiguration', {settings = client.config.settings})
  wait(function() return #vim.diagnostic.get(0) == 0 end, 'the cycle time of the settings counts')
end

local good, message = pcall(run)
check(good, tostring(message))
vim.cmd('qall!')
