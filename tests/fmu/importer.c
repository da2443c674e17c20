/* Imports the library of an FMU as any tool does, with declarations of its own:
 *
 *   importer LIBRARY TOKEN PERIOD OUTPUT... < SCENARIO
 *
 * OUTPUT is f17, b18 or e19: type and reference. A line of the scenario sets an input (f16 0x1.8p+3, b20 1,
 * e80 2), or is "init", "step K" (K cycles, exact), "late" (a step that is no whole number of cycles),
 * "keep", "restore" or "reset". After init and each step a line has all outputs. -DFMI=2 or -DFMI=3. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _WIN32
#include <windows.h>
#define OPEN(name) (void*)LoadLibraryA(name)
#define FIND(library, name) (void*)GetProcAddress((HMODULE)(library), name)
#else
#include <dlfcn.h>
#define OPEN(name) dlopen(name, RTLD_NOW)
#define FIND(library, name) dlsym(library, name)
#endif

#if FMI == 3
#define NAME(two, three) "fmi3" three
#define COUNT , (size_t)1
typedef int64_t enumeration;
typedef unsigned char truth;
static void print_log(void* environment, int status, const char* category, const char* message) {
  (void)environment;
  printf("log %d %s: %s\n", status, category, message);
}
#else
#define NAME(two, three) "fmi2" two
#define COUNT
typedef int enumeration;
typedef int truth;
static void print_log(void* environment, const char* name, int status, const char* category,
                      const char* message, ...) {
  (void)environment;
  printf("log %d %s: %s%s\n", status, category, message, strcmp(name, "test") == 0 ? "" : " (wrong name)");
}
struct {
  void (*logger)(void*, const char*, int, const char*, const char*, ...);
  void *allocate, *release, *finished, *environment;
} callbacks = {print_log, NULL, NULL, NULL, NULL};
#endif

static void* library;
static void* found(const char* name) {
  void* const function = FIND(library, name);
  if (function == NULL) printf("%s is missing\n", name);
  if (function == NULL) exit(2);
  return function;
}
#define CALL(name, parameters) ((int(*) parameters)(intptr_t)found(name))

static void* instance;
static double now, period;

static int is_ok(int status) {
  if (status != 0) printf("status %d\n", status);
  return status == 0;
}

static void get(char type, uint32_t reference) {
  double f = 0;
  truth b = 0;
  enumeration e = 0;
#if FMI == 3
#define GET (void*, const uint32_t*, size_t, void*, size_t)
#else
#define GET (void*, const uint32_t*, size_t, void*)
#endif
  if (type == 'f') is_ok(CALL(NAME("GetReal", "GetFloat64"), GET)(instance, &reference, 1, &f COUNT));
  if (type == 'b') is_ok(CALL(NAME("GetBoolean", "GetBoolean"), GET)(instance, &reference, 1, &b COUNT));
  if (type == 'e') is_ok(CALL(NAME("GetInteger", "GetInt64"), GET)(instance, &reference, 1, &e COUNT));
  printf(" %a", type == 'f' ? f : type == 'b' ? (double)b : (double)e);
}

static void set(char type, uint32_t reference, const char* text) {
  double const f = strtod(text, NULL);
  truth const b = (truth)f;
  enumeration const e = (enumeration)f;
#if FMI == 3
#define SET (void*, const uint32_t*, size_t, const void*, size_t)
#else
#define SET (void*, const uint32_t*, size_t, const void*)
#endif
  if (type == 'f') is_ok(CALL(NAME("SetReal", "SetFloat64"), SET)(instance, &reference, 1, &f COUNT));
  if (type == 'b') is_ok(CALL(NAME("SetBoolean", "SetBoolean"), SET)(instance, &reference, 1, &b COUNT));
  if (type == 'e') is_ok(CALL(NAME("SetInteger", "SetInt64"), SET)(instance, &reference, 1, &e COUNT));
}

static void step(double size) {
#if FMI == 3
  truth event = 9, end = 9, early = 9;
  double last = -1;
  int const status = CALL("fmi3DoStep", (void*, double, double, truth, truth*, truth*, truth*, double*))(
      instance, now, size, 0, &event, &end, &early, &last);
  if (event != 0 || end != 0 || early != 0 || last != (status == 0 ? now + size : now))
    printf("wrong report\n");
#else
  int const status = CALL("fmi2DoStep", (void*, double, double, int))(instance, now, size, 1);
#endif
  if (is_ok(status)) now += size;
}

static void initialize(void) {
#if FMI == 3
  is_ok(CALL("fmi3EnterInitializationMode", (void*, truth, double, double, truth, double))(instance, 0, 0, 0,
                                                                                           0, 0));
#else
  is_ok(CALL("fmi2SetupExperiment", (void*, int, double, double, int, double))(instance, 0, 0, 0, 0, 0));
  is_ok(CALL("fmi2EnterInitializationMode", (void*))(instance));
#endif
  is_ok(CALL(NAME("ExitInitializationMode", "ExitInitializationMode"), (void*))(instance));
  now = 0;
}

static void instantiate(const char* token) {
#if FMI == 3
  instance = ((void* (*)(const char*, const char*, const char*, truth, truth, truth, truth, const uint32_t*,
                         size_t, void*, void (*)(void*, int, const char*, const char*),
                         void*))(intptr_t)found("fmi3InstantiateCoSimulation"))(
      "test", token, NULL, 0, 0, 0, 0, NULL, 0, NULL, print_log, NULL);
#else
  instance = ((void* (*)(const char*, int, const char*, const char*, const void*, int, int))(intptr_t)found(
      "fmi2Instantiate"))("test", 1, token, NULL, &callbacks, 0, 0);
#endif
}

int main(int argc, char** argv) {
  char line[200], word[32], number[64];
  void* state = NULL;
  int i;
  library = OPEN(argv[1]);
  if (library == NULL) return 2;
  instantiate(argv[2]);
  if (instance == NULL) return 1;
  period = strtod(argv[3], NULL);
  while (fgets(line, sizeof line, stdin) != NULL) {
    int const words = sscanf(line, "%31s %63s", word, number);
    if (words == 2 && strcmp(word, "step") != 0) {
      set(word[0], (uint32_t)strtoul(word + 1, NULL, 10), number);
      continue;
    }
    if (strcmp(word, "init") == 0) initialize();
    if (strcmp(word, "step") == 0) step(strtod(number, NULL) * period);
    if (strcmp(word, "late") == 0) step(1.5 * period);
    if (strcmp(word, "reset") == 0) is_ok(CALL(NAME("Reset", "Reset"), (void*))(instance));
    if (strcmp(word, "keep") == 0)
      is_ok(CALL(NAME("GetFMUstate", "GetFMUState"), (void*, void**))(instance, &state));
    if (strcmp(word, "restore") == 0)
      is_ok(CALL(NAME("SetFMUstate", "SetFMUState"), (void*, void*))(instance, state));
    if (strcmp(word, "init") != 0 && strcmp(word, "step") != 0) continue;
    for (i = 4; i < argc; ++i) get(argv[i][0], (uint32_t)strtoul(argv[i] + 1, NULL, 10));
    printf("\n");
  }
  if (state != NULL) is_ok(CALL(NAME("FreeFMUstate", "FreeFMUState"), (void*, void**))(instance, &state));
  is_ok(CALL(NAME("Terminate", "Terminate"), (void*))(instance));
  ((void (*)(void*))(intptr_t)found(NAME("FreeInstance", "FreeInstance")))(instance);
  return 0;
}
