-- Starts `axisc lsp` for axis lists and machine files, once for all of them.
--   vim.g.axisc_command   what is started, {'axisc', 'lsp'}
--   vim.g.axisc_patterns  for which files, {'*.lis', 'machine.json'}
--   vim.g.axisc_settings  cycleTime, build, kind and language, {cycleTime = '1ms'}
local client

local function start()
  if client and not vim.lsp.client_is_stopped(client) then
    return client
  end
  local settings = vim.g.axisc_settings or vim.empty_dict()
  client = vim.lsp.start_client({
    name = 'axisc',
    cmd = vim.g.axisc_command or {'axisc', 'lsp'},
    root_dir = vim.fn.getcwd(),
    init_options = {axisc = settings},
    settings = {axisc = settings},
  })
  return client
end

local function attach(args)
  if args.file:lower():match('%.lis$') then
    vim.bo[args.buf].filetype = 'axis-list'
  end
  local id = start()
  if not id or not vim.lsp.buf_attach_client(args.buf, id) then
    return
  end
  vim.bo[args.buf].omnifunc = 'v:lua.vim.lsp.omnifunc'
  vim.keymap.set('n', 'K', vim.lsp.buf.hover, {buffer = args.buf})
  vim.keymap.set('n', 'gd', vim.lsp.buf.definition, {buffer = args.buf})
  vim.keymap.set('n', '<Leader>a', vim.lsp.buf.code_action, {buffer = args.buf})
  vim.keymap.set('n', '<Leader>f', vim.lsp.buf.format or vim.lsp.buf.formatting, {buffer = args.buf})
end

vim.api.nvim_create_autocmd({'BufReadPost', 'BufNewFile'}, {
  group = vim.api.nvim_create_augroup('axisc', {}),
  pattern = vim.g.axisc_patterns or {'*.lis', 'machine.json'},
  callback = attach,
})
