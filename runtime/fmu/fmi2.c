/* The functions of FMI 2.0 for co-simulation. */
#include "fmi2.h"

#include "fmu_core.h"
#include "machine.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Unused: most functions below that a machine's filters have no use for. */
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-parameter"
#elif defined(_MSC_VER)
#pragma warning(disable : 4100)
#endif

static void log_message(fmi2CallbackLogger logger, void* environment, const char* name, fmi2Status status,
                        const char* message) {
  if (logger != NULL) logger(environment, name, status, "logStatusError", message);
}

/* The status of a call, and its reason to the importer's logger. */
static fmi2Status report(const fmu* m, fmu_result result) {
  fmi2Status const status = result == FMU_OK ? fmi2OK : result == FMU_DISCARD ? fmi2Discard : fmi2Error;
  if (status != fmi2OK)
    log_message((fmi2CallbackLogger)m->logger, m->environment, m->name != NULL ? m->name : "", status,
                m->message);
  return status;
}

static fmi2Status refuse(fmi2Component component, const char* why) {
  fmu* const m = (fmu*)component;
  if (m == NULL) return fmi2Error;
  m->message = why;
  return report(m, FMU_ERROR);
}

static fmi2Status refuse_type(fmi2Component component, size_t count) {
  return count == 0 ? fmi2OK : refuse(component, "this FMU has no variable of this type");
}

static fmi2Status refuse_call(fmi2Component component) {
  return refuse(component, "modelDescription.xml does not offer this function");
}

/* ---- instances and phases ---------------------------------------------------------------------- */

FMI2_EXPORT const char* FMI2_NAME(GetTypesPlatform)(void) {
  return "default";
}

FMI2_EXPORT const char* FMI2_NAME(GetVersion)(void) {
  return "2.0";
}

FMI2_EXPORT fmi2Status FMI2_NAME(SetDebugLogging)(fmi2Component component, fmi2Boolean on, size_t count,
                                                  const fmi2String categories[]) {
  return fmi2OK; /* errors are logged always, and there is nothing else to log */
}

FMI2_EXPORT fmi2Component FMI2_NAME(Instantiate)(fmi2String name, fmi2Type type, fmi2String guid,
                                                 fmi2String resources, const fmi2CallbackFunctions* functions,
                                                 fmi2Boolean visible, fmi2Boolean logging_on) {
  const char* why = "this FMU is for co-simulation";
  fmu* const m = type == fmi2CoSimulation ? fmu_instantiate(guid, name, &why) : NULL;
  if (m == NULL) {
    if (functions != NULL)
      log_message(functions->logger, functions->componentEnvironment, name, fmi2Error, why);
    return NULL;
  }
  if (functions != NULL) {
    m->environment = functions->componentEnvironment;
    m->logger = (void (*)(void))functions->logger;
  }
  return m;
}

FMI2_EXPORT void FMI2_NAME(FreeInstance)(fmi2Component component) {
  if (component != NULL) fmu_free((fmu*)component);
}

FMI2_EXPORT fmi2Status FMI2_NAME(SetupExperiment)(fmi2Component component, fmi2Boolean tolerance_defined,
                                                  fmi2Real tolerance, fmi2Real start,
                                                  fmi2Boolean stop_defined, fmi2Real stop) {
  fmu* const m = (fmu*)component;
  if (m == NULL || m->phase != FMU_INSTANTIATED) return refuse(component, "the FMU is initialized already");
  m->time = start;
  return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2_NAME(EnterInitializationMode)(fmi2Component component) {
  fmu* const m = (fmu*)component;
  return m == NULL ? fmi2Error : report(m, fmu_enter_initialization(m, m->time));
}

FMI2_EXPORT fmi2Status FMI2_NAME(ExitInitializationMode)(fmi2Component component) {
  fmu* const m = (fmu*)component;
  return m == NULL ? fmi2Error : report(m, fmu_exit_initialization(m));
}

FMI2_EXPORT fmi2Status FMI2_NAME(Terminate)(fmi2Component component) {
  fmu* const m = (fmu*)component;
  return m == NULL ? fmi2Error : report(m, fmu_terminate(m));
}

FMI2_EXPORT fmi2Status FMI2_NAME(Reset)(fmi2Component component) {
  fmu* const m = (fmu*)component;
  return m == NULL ? fmi2Error : report(m, fmu_reset(m));
}

FMI2_EXPORT fmi2Status FMI2_NAME(DoStep)(fmi2Component component, fmi2Real time, fmi2Real step,
                                         fmi2Boolean no_state_set_before) {
  fmu* const m = (fmu*)component;
  return m == NULL ? fmi2Error : report(m, fmu_step(m, time, step));
}

FMI2_EXPORT fmi2Status FMI2_NAME(CancelStep)(fmi2Component component) {
  return refuse(component, "a step is over when DoStep returns");
}

/* ---- variables --------------------------------------------------------------------------------- */

/* Integers serve enumerations, and with --plain-integers booleans too. The time, reference 0, is no variable
 * of FMI 2.0. */
#define FMI2_VARIABLES(Name, type, types)                                                                  \
  FMI2_EXPORT fmi2Status FMI2_NAME(Get##Name)(                                                             \
      fmi2Component component, const fmi2ValueReference references[], size_t count, type values[]) {       \
    fmu* const m = (fmu*)component;                                                                        \
    double value = 0;                                                                                      \
    size_t i;                                                                                              \
    if (m == NULL) return fmi2Error;                                                                       \
    for (i = 0; i < count; ++i) {                                                                          \
      if (fmu_get(m, references[i], references[i] == 0 ? 0 : (types), &value) != FMU_OK)                   \
        return report(m, FMU_ERROR);                                                                       \
      values[i] = (type)value;                                                                             \
    }                                                                                                      \
    return fmi2OK;                                                                                         \
  }                                                                                                        \
  FMI2_EXPORT fmi2Status FMI2_NAME(Set##Name)(                                                             \
      fmi2Component component, const fmi2ValueReference references[], size_t count, const type values[]) { \
    fmu* const m = (fmu*)component;                                                                        \
    size_t i;                                                                                              \
    if (m == NULL) return fmi2Error;                                                                       \
    for (i = 0; i < count; ++i) {                                                                          \
      if (fmu_set(m, references[i], references[i] == 0 ? 0 : (types), (double)values[i]) != FMU_OK)        \
        return report(m, FMU_ERROR);                                                                       \
    }                                                                                                      \
    return fmi2OK;                                                                                         \
  }
FMI2_VARIABLES(Real, fmi2Real, FMU_REAL)
FMI2_VARIABLES(Integer, fmi2Integer, FMU_ENUMERATION | FMU_BOOLEAN)
FMI2_VARIABLES(Boolean, fmi2Boolean, FMU_BOOLEAN)

FMI2_EXPORT fmi2Status FMI2_NAME(GetString)(fmi2Component component, const fmi2ValueReference references[],
                                            size_t count, fmi2String values[]) {
  return refuse_type(component, count);
}

FMI2_EXPORT fmi2Status FMI2_NAME(SetString)(fmi2Component component, const fmi2ValueReference references[],
                                            size_t count, const fmi2String values[]) {
  return refuse_type(component, count);
}

/* ---- states ------------------------------------------------------------------------------------ */

FMI2_EXPORT fmi2Status FMI2_NAME(GetFMUstate)(fmi2Component component, fmi2FMUstate* state) {
  fmu* const m = (fmu*)component;
  return m == NULL || state == NULL ? fmi2Error : report(m, fmu_keep_state(m, state));
}

FMI2_EXPORT fmi2Status FMI2_NAME(SetFMUstate)(fmi2Component component, fmi2FMUstate state) {
  fmu* const m = (fmu*)component;
  return m == NULL ? fmi2Error : report(m, fmu_restore_state(m, state));
}

FMI2_EXPORT fmi2Status FMI2_NAME(FreeFMUstate)(fmi2Component component, fmi2FMUstate* state) {
  if (component == NULL || state == NULL) return fmi2Error;
  fmu_free_state(*state);
  *state = NULL;
  return fmi2OK;
}

/* ---- what is left of a step -------------------------------------------------------------------- */

FMI2_EXPORT fmi2Status FMI2_NAME(GetRealStatus)(fmi2Component component, fmi2StatusKind kind,
                                                fmi2Real* value) {
  fmu* const m = (fmu*)component;
  if (m == NULL || kind != fmi2LastSuccessfulTime) return fmi2Discard;
  *value = m->time;
  return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2_NAME(GetBooleanStatus)(fmi2Component component, fmi2StatusKind kind,
                                                   fmi2Boolean* value) {
  if (component == NULL || kind != fmi2Terminated) return fmi2Discard;
  *value = 0;
  return fmi2OK;
}

/* ---- what is not offered ----------------------------------------------------------------------- */

FMI2_EXPORT fmi2Status FMI2_NAME(GetStatus)(fmi2Component component, fmi2StatusKind kind, fmi2Status* value) {
  return fmi2Discard;
}

FMI2_EXPORT fmi2Status FMI2_NAME(GetIntegerStatus)(fmi2Component component, fmi2StatusKind kind,
                                                   fmi2Integer* value) {
  return fmi2Discard;
}

FMI2_EXPORT fmi2Status FMI2_NAME(GetStringStatus)(fmi2Component component, fmi2StatusKind kind,
                                                  fmi2String* value) {
  return fmi2Discard;
}

#define FMI2_NOT_OFFERED(Name, ...)                                              \
  FMI2_EXPORT fmi2Status FMI2_NAME(Name)(fmi2Component component, __VA_ARGS__) { \
    return refuse_call(component);                                               \
  }
FMI2_NOT_OFFERED(SerializedFMUstateSize, fmi2FMUstate state, size_t* size)
FMI2_NOT_OFFERED(SerializeFMUstate, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
FMI2_NOT_OFFERED(DeSerializeFMUstate, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state)
FMI2_NOT_OFFERED(GetDirectionalDerivative, const fmi2ValueReference unknowns[], size_t unknown_count,
                 const fmi2ValueReference knowns[], size_t known_count, const fmi2Real knowns_change[],
                 fmi2Real unknowns_change[])
FMI2_NOT_OFFERED(SetRealInputDerivatives, const fmi2ValueReference references[], size_t count,
                 const fmi2Integer orders[], const fmi2Real values[])
FMI2_NOT_OFFERED(GetRealOutputDerivatives, const fmi2ValueReference references[], size_t count,
                 const fmi2Integer orders[], fmi2Real values[])

#ifdef __cplusplus
}
#endif
