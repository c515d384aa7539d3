-- What the test in neovim.rs does in Neovim 0.7 and later; what came of it is written to the file RESULT as JSON.
local result = {}

-- Nothing depends on how long it takes; what does not come within the time has failed.
local function wait_for(what, condition)
  assert(vim.wait(120000, condition, 20), what .. ' did not come')
end

local function run()
  vim.cmd('edit ' .. vim.fn.fnameescape(vim.env.TEXT))
  vim.bo.filetype = 'markdown'
  local options = {
    name = 'proofread',
    cmd = { vim.env.PROOFREAD, 'lsp' },
    root_dir = vim.fn.getcwd(),
    settings = { proofread = { doubts = false } },
  }
  local client
  if vim.lsp.start then
    client = vim.lsp.start(options)
  else
    -- Before 0.8.
    client = vim.lsp.start_client(options)
    vim.lsp.buf_attach_client(0, client)
  end

  wait_for('a finding', function() return #vim.diagnostic.get(0) == 1 end)
  local found = vim.diagnostic.get(0)[1]
  result.found = {
    line = found.lnum, from = found.col, to = found.end_col, severity = found.severity,
    source = found.source, code = found.code, message = found.message,
  }

  vim.api.nvim_win_set_cursor(0, { found.lnum + 1, found.col })
  vim.lsp.buf.hover()
  local function float()
    for _, window in ipairs(vim.api.nvim_list_wins()) do
      if vim.api.nvim_win_get_config(window).relative ~= '' then return window end
    end
  end
  wait_for('a window', function() return float() ~= nil end)
  local window = float()
  result.hover = vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false)
  vim.api.nvim_win_close(window, true)

  vim.ui.select = function(items, _, choose) choose(items[1], 1) end
  local before = vim.api.nvim_buf_get_lines(0, 0, -1, false)
  vim.lsp.buf.code_action()
  wait_for('an edit', function()
    return not vim.deep_equal(before, vim.api.nvim_buf_get_lines(0, 0, -1, false))
  end)
  result.mended = vim.api.nvim_buf_get_lines(0, 0, -1, false)
  wait_for('the end of the finding', function() return #vim.diagnostic.get(0) == 0 end)

  -- A person types on.
  vim.api.nvim_buf_set_lines(0, -1, -1, false, { '𝟙 and $2 + 2 = 5$' })
  wait_for('another finding', function() return #vim.diagnostic.get(0) == 1 end)
  local other = vim.diagnostic.get(0)[1]
  result.other = { line = other.lnum, from = other.col, to = other.end_col }
  vim.lsp.stop_client(client)
  wait_for('the end of the server', function() return vim.lsp.get_client_by_id(client) == nil end)
end

local ran, why = pcall(run)
if not ran then result.failed = tostring(why) end
vim.fn.writefile({ vim.fn.json_encode(result) }, vim.env.RESULT)
vim.cmd('qa!')
