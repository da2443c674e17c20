// The language server for JavaScript, array by array of messages: the WebAssembly exports these functions.
// One server at a time.
#pragma once

extern "C" {

/// Begins a server, instead of the one before. `arguments_json`: those of `axisc lsp`, an array of strings.
/// 0, or what is wrong is on standard error.
int axisc_server_begin(char const* arguments_json);

/// Takes messages that arrived together, an array of their texts, without frames; the messages to send, an
/// array, with the diagnostics of what has changed. Valid until the next call.
char const* axisc_server_take(char const* messages_json);
}
