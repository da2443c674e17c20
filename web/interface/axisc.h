/* axisc for other languages: files in, findings, images and answers out. The page and editors that run axisc
 * as WebAssembly use it; it may still change.
 *
 * A workspace is the files of the disk, unsaved text over them, and a language. Any number of them, one call
 * at a time in each. Settings (axisc.json) are read anew by every call. Paths are UTF-8 with `/`, and count
 * from the working folder. Nothing is printed, nothing is written to the disk.
 *
 * Functions return 0; AXISC_FINDINGS where lists have errors, so that there is no image or no answer; or
 * AXISC_FAILED where the input cannot be read or the question makes no sense. axisc_error() tells both, for
 * people. */
#ifndef AXISC_H
#define AXISC_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct axisc_workspace axisc_workspace;

/* Owned by the caller, freed by axisc_free(). */
typedef struct axisc_bytes {
  char* data;
  size_t size;
} axisc_bytes;

enum axisc_result { AXISC_OK = 0, AXISC_FINDINGS = 1, AXISC_FAILED = 2 };

/* `options`: {"language": "en" or "de", "cycle_time": "2ms" where no file says one}, both optional, or null.
 * After AXISC_FAILED the workspace, if there is one, only tells why, and must be closed as well. */
int axisc_open(char const* options, axisc_workspace** workspace);
void axisc_close(axisc_workspace* workspace);

/* Text that is not on the disk, in the place of a file or beside them; a folder is searched on the disk
 * alone. */
int axisc_put(axisc_workspace* workspace, char const* path, char const* bytes, size_t size);
int axisc_drop(axisc_workspace* workspace, char const* path);
/* The bytes as they are now. */
int axisc_read(axisc_workspace* workspace, char const* path, axisc_bytes* bytes);

/* Findings of a file in its machine, or of everything in a folder: JSON, as `axisc lint --format json`. */
int axisc_check(axisc_workspace* workspace, char const* path, axisc_bytes* findings);
/* Repairs what `axisc lint --fix` repairs. The new bytes are unsaved text; `changed` becomes a JSON array of
 * their paths. After AXISC_FAILED nothing has changed. */
int axisc_fix(axisc_workspace* workspace, char const* path, axisc_bytes* changed);
/* The image of the machine that the file belongs to, or of the only one in a folder. */
int axisc_compile(axisc_workspace* workspace, char const* path, axisc_bytes* image);

/* A JSON object: "question" names one of those below, "input" the file or folder it is about, which is judged
 * in its machine.
 *   machine_of  the path of the machine that the file belongs to; its own if there is none
 *   machine     what it consists of                      "format"
 *   contour     what its filters do to a path            "format"
 *   picture     "kind" as `axisc plot` has them, "axis", "group", "before", "program", "plant", "move";
 *               an SVG
 *   report      the acceptance report                    "before"; HTML
 *   explain     "word": a code, a parameter, a message   "format"
 * "format" is text (default), json, csv, markdown or html. */
int axisc_answer(axisc_workspace* workspace, char const* question, axisc_bytes* answer);

/* Language server protocol: an array of messages that arrived together, as strings; becomes the array of the
 * messages to send, diagnostics of what has changed included. */
int axisc_message(axisc_workspace* workspace, char const* messages, axisc_bytes* replies);

/* Why the last call was not AXISC_OK. Valid until the next one. */
char const* axisc_error(axisc_workspace const* workspace);
void axisc_free(axisc_bytes* bytes);

#ifdef __cplusplus
}
#endif

#endif
