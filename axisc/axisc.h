/* axisc for every language: files in; findings, images and answers out.
 *
 *   axisc_workspace* workspace = NULL;
 *   axisc_bytes findings = {NULL, 0};
 *   if (axisc_open(NULL, NULL, &workspace) == AXISC_OK && axisc_check(workspace, "x.lis", &findings) >= 0)
 *     fwrite(findings.data, 1, findings.size, stdout);
 *   axisc_free(&findings);
 *   axisc_close(workspace);
 *
 * A workspace is the files of the disk, unsaved text over them, and a language. Files and settings
 * (axisc.json) are read anew by every call. Paths are UTF-8 with `/`, and count from the working folder;
 * other texts are UTF-8 too. Nothing is printed, nothing is written to the disk, no signal is handled, no
 * process is ended.
 *
 * Ownership: inputs are used during the call alone. Results belong to the caller until axisc_free(), also
 * when the workspace is closed. Each is followed by a NUL that its size does not count.
 * Threads: any number of workspaces, in any threads; one call at a time in each (AXISC_BUSY otherwise),
 * except axisc_cancel().
 * Versions: numbers never change meaning, axisc_files begins with its size, axisc_bytes stays as it is, JSON
 * carries its version (docs/schemas). */
#ifndef AXISC_H
#define AXISC_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#if defined(__ELF__)
#pragma GCC visibility push(default) /* what a shared library shows */
#endif

/* Changes when a program must be compiled again. 0: it may do so from one version of axisc to the next. */
#define AXISC_ABI_VERSION 0u
uint32_t axisc_abi_version(void);

/* What functions return. Below 0 there is no result, and axisc_error() says why. */
typedef enum axisc_result {
  AXISC_OK = 0,
  AXISC_FINDINGS = 1,      /* lists have errors: findings are there, an image or an answer is not */
  AXISC_ENDED = 2,         /* of axisc_message(): the client has said exit after shutdown */
  AXISC_BROKEN_OFF = 3,    /* of axisc_message(): it has said exit without shutdown */
  AXISC_BAD_ARGUMENT = -1, /* null, an unknown number, JSON or a question that is none */
  AXISC_NOT_FOUND = -2,    /* the file or folder that the call is about does not exist */
  AXISC_UNUSABLE = -3,     /* a file, a setting or a word of the question cannot be used */
  AXISC_CANCELLED = -4,
  AXISC_BUSY = -5, /* the workspace is in another call; axisc_error() stays that call's */
  AXISC_NO_MEMORY = -6,
  AXISC_INTERNAL = -7 /* a defect of axisc */
} axisc_result;

typedef struct axisc_workspace axisc_workspace;

typedef struct axisc_bytes {
  char* data;
  size_t size;
} axisc_bytes;

/* Where lists, machine files and NC programs are read instead of the disk. Called during a call, in its
 * thread; must not call functions of the same workspace but axisc_cancel(). A call asks for a file at most
 * once, however often it reads it. A folder that a call names, and settings, are looked for on the disk. */
typedef struct axisc_files {
  uint32_t size;     /* sizeof(axisc_files) */
  uint32_t reserved; /* 0 */
  void* context;     /* handed to both */
  /* Gives the file by axisc_copy(); AXISC_OK, AXISC_NOT_FOUND, or anything else: not readable. */
  int (*read)(void* context, char const* path, axisc_bytes* file);
  /* Gives the names of the files in a folder, a NUL after each. May be null: none is known. */
  int (*list)(void* context, char const* folder, axisc_bytes* names);
} axisc_files;

/* `options`: a JSON object, or null. All are optional: "language" ("en" or "de"); "cycle_time" ("2ms") where
 * no file says one, "override_cycle_time" whatever files say; "axis_type", "kind" and "build" as of
 * `axisc lint`. `files`: null for the disk; copied. After a result below 0 the workspace, if it is not null,
 * only tells why, and must be closed as well. */
int axisc_open(char const* options, axisc_files const* files, axisc_workspace** workspace);
/* Null is allowed. */
void axisc_close(axisc_workspace* workspace);

/* Text that is not on the disk, in the place of a file or beside them; a folder is searched on the disk
 * alone. "./x.lis" is "x.lis"; a relative and an absolute path are two names. */
int axisc_put(axisc_workspace* workspace, char const* path, void const* bytes, size_t size);
int axisc_drop(axisc_workspace* workspace, char const* path);
/* The bytes as they are now. */
int axisc_read(axisc_workspace* workspace, char const* path, axisc_bytes* bytes);

/* Findings of a file in its machine, or of everything in a folder: JSON, as `axisc lint --format json`. There
 * is a report also where the result is below 0 because some of the files cannot be read. */
int axisc_check(axisc_workspace* workspace, char const* path, axisc_bytes* findings);

typedef enum axisc_fixes {
  AXISC_FIX_SAFE = 0, /* as `axisc lint --fix`: nothing that could change what the machine does */
  AXISC_FIX_ALL = 1   /* as --fix=all */
} axisc_fixes;
/* Repairs. The new bytes are unsaved text; `report` becomes a JSON object, {"version": 1, "files": an array
 * of their paths, "fixed": the number of findings that were repaired}. After a result below 0 nothing has
 * changed. `fixes`: an axisc_fixes. */
int axisc_fix(axisc_workspace* workspace, char const* path, int fixes, axisc_bytes* report);

/* The image of the machine that the file belongs to, or of the only one in a folder. `options`: a JSON object
 * as the options of `axisc compile`, {"strip": "yes", "bounds": "no", "image_version": "7"}, or null.
 * `findings` as of axisc_check(), or null. */
int axisc_compile(axisc_workspace* workspace, char const* path, char const* options, axisc_bytes* image,
                  axisc_bytes* findings);

/* A JSON object of texts, or of arrays of texts where there may be several: "question" names one of those
 * below, "input" the file or folder it is about; lists are judged in their machine.
 *   machines      the machines in a folder, or that of a file: what describes it, and what says its NC cycle
 *                 time                                       "format"
 *   machine       what it consists of; JSON is a machine file, but for a project, whose lists are not files
 *                                                            "format"
 *   get           values in force: "words" are an axis and parameters, blanks between them; "format"
 *   filters       those of each axis in words, and their delay   "format"
 *   contour       what its filters do to a path              "format"
 *   delay_budget  what delays its axes                       "format"
 *   diff          what differs from "before", another input  "format"
 *   inspect       what is in an image                        "axis", "format"
 *   response      "axis", "port" (setpoint, interface, velocity), "frequencies" ("10,20"); "format"
 *   compare       what a scope recorded beside what is computed: "recording", "axis", "in", "out" (columns);
 *                 "unit", "numbers", "format"
 *   circle        the circular test: "feed" in mm/min and "radius" in mm, or "recording", of both directions
 *                 or one of each; "plane", "tolerance" in um; "setpoint", "actual" ("X=COLUMN" each),
 *                 "external" ("yes"), "unit", "numbers"; "format", which may be svg
 *   identify      mass and friction of an axis in recordings of its motion: "recording", one or several,
 *                 "axis"; "actual", "force" (columns), "unit", "numbers"; "format"
 *   picture       "kind" as `axisc plot` has them, "axis", "group", "before", "program", "plant", "move",
 *                 "recording", "in", "out"; an SVG
 *   report        the acceptance report                      "before", "title", "customer", "author", "date";
 *                 HTML
 *   fmu           an FMU of its filters, without libraries: the bytes of the file
 *                 "version" (3, the default, or 2, of the FMI), "name"
 *   explain       "word": a code, a parameter, a message     "format"
 * "format" is text (default), json, csv, markdown or html. "unit" of recorded positions is 0.1um, um, mm or
 * incr, "numbers" scaled or raw, of columns with a scale: without them both are recognised. The files of
 * "program", "plant" and "recording" are read from the disk. */
int axisc_answer(axisc_workspace* workspace, char const* question, axisc_bytes* answer);

/* Language server protocol: a JSON array of messages that arrived together, as texts; becomes the array of
 * the messages to send, each on a line of its own, diagnostics of what has changed included. Open documents
 * are those of the messages, all other files those of the disk. After AXISC_ENDED or AXISC_BROKEN_OFF nothing
 * is answered any more. */
int axisc_message(axisc_workspace* workspace, char const* messages, axisc_bytes* replies);

/* Ends the present call, if there is one, before it reads its next file. From any thread, while the workspace
 * is open; axisc_message() is not ended. */
void axisc_cancel(axisc_workspace* workspace);

/* Why the last call returned a number below 0, in lines for people; empty after any other number, whose
 * findings or replies say it. Valid until the next call. Never null. */
char const* axisc_error(axisc_workspace const* workspace);

/* For callbacks: replaces the bytes by a copy. AXISC_OK, AXISC_BAD_ARGUMENT or AXISC_NO_MEMORY. */
int axisc_copy(axisc_bytes* bytes, void const* data, size_t size);
/* Frees and empties. Null and empty ones are allowed. */
void axisc_free(axisc_bytes* bytes);

#if defined(__ELF__)
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
