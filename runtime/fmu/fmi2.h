/* Types of the Functional Mock-up Interface 2.0 as its functions in fmi2.c take them, and their names. */
#ifndef FMI2_H
#define FMI2_H

#include <stddef.h>

typedef void* fmi2Component;
typedef void* fmi2ComponentEnvironment;
typedef void* fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean; /* 0 or 1 */
typedef char fmi2Byte;
typedef const char* fmi2String;

typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;

typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status,
                                   fmi2String category, fmi2String message, ...);
typedef struct {
  fmi2CallbackLogger logger;
  void* (*allocateMemory)(size_t count, size_t size);
  void (*freeMemory)(void* memory);
  void (*stepFinished)(fmi2ComponentEnvironment environment, fmi2Status status);
  fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

/* FMI2_NAME(DoStep) is fmi2DoStep in a shared library. Linked statically, it is MODEL_fmi2DoStep with the
 * prefix of machine.h; who compiles a library defines FMI2_OVERRIDE_FUNCTION_PREFIX, as the standard says. */
#define FMI2_JOIN(prefix, name) prefix##fmi2##name
#define FMI2_EXPAND(prefix, name) FMI2_JOIN(prefix, name)
#ifndef FMI2_OVERRIDE_FUNCTION_PREFIX
#define FMI2_NAME(name) FMI2_EXPAND(FMI2_FUNCTION_PREFIX, name)
#define FMI2_EXPORT
#else
#ifdef FMI2_ACTUAL_FUNCTION_PREFIX
#define FMI2_NAME(name) FMI2_EXPAND(FMI2_ACTUAL_FUNCTION_PREFIX, name)
#define FMI2_EXPORT
#else
#define FMI2_NAME(name) fmi2##name
#if defined(_WIN32)
#define FMI2_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define FMI2_EXPORT __attribute__((visibility("default")))
#else
#define FMI2_EXPORT
#endif
#endif
#endif

#endif
