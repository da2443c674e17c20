/* The functions of FMI 3.0 for co-simulation. */
#include "fmi3.h"

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

static void log_message(fmi3LogMessageCallback logger, void* environment, fmi3Status status,
                        const char* message) {
  if (logger != NULL) logger(environment, status, "logStatusError", message);
}

/* The status of a call, and its reason to the importer's logger. */
static fmi3Status report(const fmu* m, fmu_result result) {
  fmi3Status const status = result == FMU_OK ? fmi3OK : result == FMU_DISCARD ? fmi3Discard : fmi3Error;
  if (status != fmi3OK) log_message((fmi3LogMessageCallback)m->logger, m->environment, status, m->message);
  return status;
}

static fmi3Status refuse(fmi3Instance instance, const char* why) {
  fmu* const m = (fmu*)instance;
  if (m == NULL) return fmi3Error;
  m->message = why;
  return report(m, FMU_ERROR);
}

static fmi3Status refuse_type(fmi3Instance instance, size_t count) {
  return count == 0 ? fmi3OK : refuse(instance, "this FMU has no variable of this type");
}

static fmi3Status refuse_call(fmi3Instance instance) {
  return refuse(instance, "modelDescription.xml does not offer this function");
}

/* ---- instances and phases ---------------------------------------------------------------------- */

FMI3_EXPORT const char* FMI3_NAME(GetVersion)(void) {
  return "3.0";
}

FMI3_EXPORT fmi3Status FMI3_NAME(SetDebugLogging)(fmi3Instance instance, fmi3Boolean on, size_t count,
                                                  const fmi3String categories[]) {
  return fmi3OK; /* errors are logged always, and there is nothing else to log */
}

FMI3_EXPORT fmi3Instance FMI3_NAME(InstantiateCoSimulation)(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging_on,
    fmi3Boolean event_mode_used, fmi3Boolean early_return_allowed, const fmi3ValueReference intermediate[],
    size_t intermediate_count, fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
    fmi3IntermediateUpdateCallback update) {
  const char* why = "modelDescription.xml offers neither event mode nor intermediate variables";
  fmu* const m = event_mode_used || intermediate_count > 0 ? NULL : fmu_instantiate(token, name, &why);
  if (m == NULL) {
    log_message(logger, environment, fmi3Error, why);
    return NULL;
  }
  m->environment = environment;
  m->logger = (void (*)(void))logger;
  return m;
}

FMI3_EXPORT fmi3Instance FMI3_NAME(InstantiateModelExchange)(fmi3String name, fmi3String token,
                                                             fmi3String resources, fmi3Boolean visible,
                                                             fmi3Boolean logging_on,
                                                             fmi3InstanceEnvironment environment,
                                                             fmi3LogMessageCallback logger) {
  log_message(logger, environment, fmi3Error, "this FMU is for co-simulation");
  return NULL;
}

FMI3_EXPORT fmi3Instance FMI3_NAME(InstantiateScheduledExecution)(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging_on,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger, fmi3ClockUpdateCallback update,
    fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock) {
  log_message(logger, environment, fmi3Error, "this FMU is for co-simulation");
  return NULL;
}

FMI3_EXPORT void FMI3_NAME(FreeInstance)(fmi3Instance instance) {
  if (instance != NULL) fmu_free((fmu*)instance);
}

FMI3_EXPORT fmi3Status FMI3_NAME(EnterInitializationMode)(fmi3Instance instance,
                                                          fmi3Boolean tolerance_defined,
                                                          fmi3Float64 tolerance, fmi3Float64 start,
                                                          fmi3Boolean stop_defined, fmi3Float64 stop) {
  fmu* const m = (fmu*)instance;
  return m == NULL ? fmi3Error : report(m, fmu_enter_initialization(m, start));
}

FMI3_EXPORT fmi3Status FMI3_NAME(ExitInitializationMode)(fmi3Instance instance) {
  fmu* const m = (fmu*)instance;
  return m == NULL ? fmi3Error : report(m, fmu_exit_initialization(m));
}

FMI3_EXPORT fmi3Status FMI3_NAME(Terminate)(fmi3Instance instance) {
  fmu* const m = (fmu*)instance;
  return m == NULL ? fmi3Error : report(m, fmu_terminate(m));
}

FMI3_EXPORT fmi3Status FMI3_NAME(Reset)(fmi3Instance instance) {
  fmu* const m = (fmu*)instance;
  return m == NULL ? fmi3Error : report(m, fmu_reset(m));
}

FMI3_EXPORT fmi3Status FMI3_NAME(DoStep)(fmi3Instance instance, fmi3Float64 time, fmi3Float64 step,
                                         fmi3Boolean no_state_set_before, fmi3Boolean* event_needed,
                                         fmi3Boolean* terminate, fmi3Boolean* early_return,
                                         fmi3Float64* last_successful_time) {
  fmu* const m = (fmu*)instance;
  fmu_result result;
  if (m == NULL) return fmi3Error;
  result = fmu_step(m, time, step);
  if (event_needed != NULL) *event_needed = false;
  if (terminate != NULL) *terminate = false;
  if (early_return != NULL) *early_return = false;
  if (last_successful_time != NULL) *last_successful_time = m->time;
  return report(m, result);
}

/* ---- variables --------------------------------------------------------------------------------- */

/* Int32 is that of --plain-integers. */
#define FMI3_VARIABLES(Name, type, types)                                                                   \
  FMI3_EXPORT fmi3Status FMI3_NAME(Get##Name)(fmi3Instance instance, const fmi3ValueReference references[], \
                                              size_t count, type values[], size_t value_count) {            \
    fmu* const m = (fmu*)instance;                                                                          \
    double value = 0;                                                                                       \
    size_t i;                                                                                               \
    if (m == NULL || value_count != count) return refuse(instance, "one value belongs to one reference");   \
    for (i = 0; i < count; ++i) {                                                                           \
      if (fmu_get(m, references[i], types, &value) != FMU_OK) return report(m, FMU_ERROR);                  \
      values[i] = (type)value;                                                                              \
    }                                                                                                       \
    return fmi3OK;                                                                                          \
  }                                                                                                         \
  FMI3_EXPORT fmi3Status FMI3_NAME(Set##Name)(fmi3Instance instance, const fmi3ValueReference references[], \
                                              size_t count, const type values[], size_t value_count) {      \
    fmu* const m = (fmu*)instance;                                                                          \
    size_t i;                                                                                               \
    if (m == NULL || value_count != count) return refuse(instance, "one value belongs to one reference");   \
    for (i = 0; i < count; ++i) {                                                                           \
      if (fmu_set(m, references[i], types, (double)values[i]) != FMU_OK) return report(m, FMU_ERROR);       \
    }                                                                                                       \
    return fmi3OK;                                                                                          \
  }
FMI3_VARIABLES(Float64, fmi3Float64, FMU_REAL)
FMI3_VARIABLES(Boolean, fmi3Boolean, FMU_BOOLEAN)
FMI3_VARIABLES(Int32, fmi3Int32, FMU_ENUMERATION | FMU_BOOLEAN)
FMI3_VARIABLES(Int64, fmi3Int64, FMU_ENUMERATION)

#define FMI3_NO_VARIABLES(Name, type)                                                                       \
  FMI3_EXPORT fmi3Status FMI3_NAME(Get##Name)(fmi3Instance instance, const fmi3ValueReference references[], \
                                              size_t count, type values[], size_t value_count) {            \
    return refuse_type(instance, count);                                                                    \
  }                                                                                                         \
  FMI3_EXPORT fmi3Status FMI3_NAME(Set##Name)(fmi3Instance instance, const fmi3ValueReference references[], \
                                              size_t count, const type values[], size_t value_count) {      \
    return refuse_type(instance, count);                                                                    \
  }
FMI3_NO_VARIABLES(Float32, fmi3Float32)
FMI3_NO_VARIABLES(Int8, fmi3Int8)
FMI3_NO_VARIABLES(UInt8, fmi3UInt8)
FMI3_NO_VARIABLES(Int16, fmi3Int16)
FMI3_NO_VARIABLES(UInt16, fmi3UInt16)
FMI3_NO_VARIABLES(UInt32, fmi3UInt32)
FMI3_NO_VARIABLES(UInt64, fmi3UInt64)
FMI3_NO_VARIABLES(String, fmi3String)

FMI3_EXPORT fmi3Status FMI3_NAME(GetBinary)(fmi3Instance instance, const fmi3ValueReference references[],
                                            size_t count, size_t sizes[], fmi3Binary values[],
                                            size_t value_count) {
  return refuse_type(instance, count);
}

FMI3_EXPORT fmi3Status FMI3_NAME(SetBinary)(fmi3Instance instance, const fmi3ValueReference references[],
                                            size_t count, const size_t sizes[], const fmi3Binary values[],
                                            size_t value_count) {
  return refuse_type(instance, count);
}

FMI3_EXPORT fmi3Status FMI3_NAME(GetClock)(fmi3Instance instance, const fmi3ValueReference references[],
                                           size_t count, fmi3Clock values[]) {
  return refuse_type(instance, count);
}

FMI3_EXPORT fmi3Status FMI3_NAME(SetClock)(fmi3Instance instance, const fmi3ValueReference references[],
                                           size_t count, const fmi3Clock values[]) {
  return refuse_type(instance, count);
}

/* ---- states ------------------------------------------------------------------------------------ */

FMI3_EXPORT fmi3Status FMI3_NAME(GetFMUState)(fmi3Instance instance, fmi3FMUState* state) {
  fmu* const m = (fmu*)instance;
  return m == NULL || state == NULL ? fmi3Error : report(m, fmu_keep_state(m, state));
}

FMI3_EXPORT fmi3Status FMI3_NAME(SetFMUState)(fmi3Instance instance, fmi3FMUState state) {
  fmu* const m = (fmu*)instance;
  return m == NULL ? fmi3Error : report(m, fmu_restore_state(m, state));
}

FMI3_EXPORT fmi3Status FMI3_NAME(FreeFMUState)(fmi3Instance instance, fmi3FMUState* state) {
  if (instance == NULL || state == NULL) return fmi3Error;
  fmu_free_state(*state);
  *state = NULL;
  return fmi3OK;
}

/* ---- what is not offered ----------------------------------------------------------------------- */

#define FMI3_NOT_OFFERED(Name, ...)                                            \
  FMI3_EXPORT fmi3Status FMI3_NAME(Name)(fmi3Instance instance, __VA_ARGS__) { \
    return refuse_call(instance);                                              \
  }
#define FMI3_NOT_OFFERED_PLAIN(Name)                              \
  FMI3_EXPORT fmi3Status FMI3_NAME(Name)(fmi3Instance instance) { \
    return refuse_call(instance);                                 \
  }
#define FMI3_REFERENCES const fmi3ValueReference references[], size_t count

FMI3_NOT_OFFERED(SerializedFMUStateSize, fmi3FMUState state, size_t* size)
FMI3_NOT_OFFERED(SerializeFMUState, fmi3FMUState state, fmi3Byte bytes[], size_t size)
FMI3_NOT_OFFERED(DeserializeFMUState, const fmi3Byte bytes[], size_t size, fmi3FMUState* state)
FMI3_NOT_OFFERED(GetNumberOfVariableDependencies, fmi3ValueReference reference, size_t* count)
FMI3_NOT_OFFERED(GetVariableDependencies, fmi3ValueReference dependent, size_t elements[],
                 fmi3ValueReference independents[], size_t independent_elements[], fmi3DependencyKind kinds[],
                 size_t count)
FMI3_NOT_OFFERED(GetDirectionalDerivative, FMI3_REFERENCES, const fmi3ValueReference knowns[],
                 size_t known_count, const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[],
                 size_t sensitivity_count)
FMI3_NOT_OFFERED(GetAdjointDerivative, FMI3_REFERENCES, const fmi3ValueReference knowns[], size_t known_count,
                 const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[],
                 size_t sensitivity_count)
FMI3_NOT_OFFERED(GetOutputDerivatives, FMI3_REFERENCES, const fmi3Int32 orders[], fmi3Float64 values[],
                 size_t value_count)
FMI3_NOT_OFFERED_PLAIN(EnterConfigurationMode)
FMI3_NOT_OFFERED_PLAIN(ExitConfigurationMode)
FMI3_NOT_OFFERED_PLAIN(EnterEventMode)
FMI3_NOT_OFFERED_PLAIN(EnterStepMode)
FMI3_NOT_OFFERED_PLAIN(EvaluateDiscreteStates)
FMI3_NOT_OFFERED_PLAIN(EnterContinuousTimeMode)
FMI3_NOT_OFFERED(UpdateDiscreteStates, fmi3Boolean* needed, fmi3Boolean* terminate, fmi3Boolean* nominals,
                 fmi3Boolean* values, fmi3Boolean* is_event_defined, fmi3Float64* event_time)
FMI3_NOT_OFFERED(GetIntervalDecimal, FMI3_REFERENCES, fmi3Float64 intervals[],
                 fmi3IntervalQualifier qualifiers[])
FMI3_NOT_OFFERED(GetIntervalFraction, FMI3_REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                 fmi3IntervalQualifier qualifiers[])
FMI3_NOT_OFFERED(GetShiftDecimal, FMI3_REFERENCES, fmi3Float64 shifts[])
FMI3_NOT_OFFERED(GetShiftFraction, FMI3_REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
FMI3_NOT_OFFERED(SetIntervalDecimal, FMI3_REFERENCES, const fmi3Float64 intervals[])
FMI3_NOT_OFFERED(SetIntervalFraction, FMI3_REFERENCES, const fmi3UInt64 counters[],
                 const fmi3UInt64 resolutions[])
FMI3_NOT_OFFERED(SetShiftDecimal, FMI3_REFERENCES, const fmi3Float64 shifts[])
FMI3_NOT_OFFERED(SetShiftFraction, FMI3_REFERENCES, const fmi3UInt64 counters[],
                 const fmi3UInt64 resolutions[])
FMI3_NOT_OFFERED(ActivateModelPartition, fmi3ValueReference clock, fmi3Float64 time)
FMI3_NOT_OFFERED(CompletedIntegratorStep, fmi3Boolean no_state_set_before, fmi3Boolean* enter_event_mode,
                 fmi3Boolean* terminate)
FMI3_NOT_OFFERED(SetTime, fmi3Float64 time)
FMI3_NOT_OFFERED(SetContinuousStates, const fmi3Float64 states[], size_t count)
FMI3_NOT_OFFERED(GetContinuousStates, fmi3Float64 states[], size_t count)
FMI3_NOT_OFFERED(GetContinuousStateDerivatives, fmi3Float64 derivatives[], size_t count)
FMI3_NOT_OFFERED(GetNominalsOfContinuousStates, fmi3Float64 nominals[], size_t count)
FMI3_NOT_OFFERED(GetEventIndicators, fmi3Float64 indicators[], size_t count)

/* There are none, which every importer may know. */
static fmi3Status none(size_t* count) {
  if (count == NULL) return fmi3Error;
  *count = 0;
  return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3_NAME(GetNumberOfEventIndicators)(fmi3Instance instance, size_t* count) {
  return none(count);
}

FMI3_EXPORT fmi3Status FMI3_NAME(GetNumberOfContinuousStates)(fmi3Instance instance, size_t* count) {
  return none(count);
}

#ifdef __cplusplus
}
#endif
