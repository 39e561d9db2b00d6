/* The functions of FMI 3.0 over an instance. */

#include <stdbool.h>
#include <stdint.h>

typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef const char *fmi3String;
typedef const uint8_t *fmi3Binary;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String, fmi3String);

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif
#define CHECK(expression) return (expression) == 0 ? fmi3OK : fmi3Error;
#define NOT_PROVIDED(name, arguments) EXPORT fmi3Status name arguments { return fmi3Error; }
#define ALLOWED(modes) if (!allowed(m, modes, __func__)) { return fmi3Error; }
#define EXCHANGE(modes) if (!allowed_if(0, m, modes, __func__)) { return fmi3Error; }

static void report(void *instance, int is_error, const char *message)
{
    Instance *m = instance;
    if (m->logger != NULL && (is_error || m->logging)) {
        fmi3LogMessageCallback logger;
        memcpy(&logger, &m->logger, sizeof logger);
        logger(m->environment, is_error ? fmi3Error : fmi3OK, is_error ? "logStatusError" : "logAll", message);
    }
}

EXPORT const char *fmi3GetVersion(void) { return "3.0"; }

static fmi3Instance instantiate(fmi3String token, bool logging, fmi3InstanceEnvironment environment,
                                fmi3LogMessageCallback logger, int steps_itself)
{
    Instance *m = calloc(1, sizeof *m);
    if (m == NULL) {
        return NULL;
    }
    m->report = report;
    m->logging = logging;
    m->steps_itself = steps_itself;
    m->environment = environment;
    memcpy(&m->logger, &logger, sizeof m->logger);
    if (token == NULL || strcmp(token, TOKEN) != 0) {
        report(m, 1, "the model description belongs to another binary: its instantiation token differs");
        free(m);
        return NULL;
    }
    initialise(m);
    return m;
}

EXPORT fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, bool visible,
                                                 bool logging, fmi3InstanceEnvironment environment,
                                                 fmi3LogMessageCallback logger)
{
    (void)name;
    (void)resources;
    (void)visible;
    return instantiate(token, logging, environment, logger, 0);
}

EXPORT fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, bool visible,
                                                bool logging, bool events, bool early,
                                                const fmi3ValueReference intermediate[], size_t n,
                                                fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
                                                void *update)
{
    (void)name;
    (void)resources;
    (void)visible;
    (void)events;
    (void)early;
    (void)intermediate;
    (void)n;
    (void)update;
    return instantiate(token, logging, environment, logger, 1);
}

EXPORT fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                                      bool visible, bool logging, fmi3InstanceEnvironment environment,
                                                      fmi3LogMessageCallback logger, void *clocks, void *lock,
                                                      void *unlock)
{
    (void)name; (void)token; (void)resources; (void)visible; (void)logging;
    (void)environment; (void)logger; (void)clocks; (void)lock; (void)unlock;
    return NULL;
}

EXPORT void fmi3FreeInstance(fmi3Instance m) { free(m); }

EXPORT fmi3Status fmi3SetDebugLogging(fmi3Instance m, bool on, size_t n, const fmi3String categories[])
{
    (void)n;
    (void)categories;
    ALLOWED(~0)
    ((Instance *)m)->logging = on;
    return fmi3OK;
}

EXPORT fmi3Status fmi3EnterInitializationMode(fmi3Instance m, bool tolerance_defined, double tolerance, double start,
                                              bool stop_defined, double stop)
{
    (void)tolerance_defined;
    (void)tolerance;
    (void)stop_defined;
    (void)stop;
    ALLOWED(INSTANTIATED)
    ((Instance *)m)->state.t = start;
    CHECK(!isfinite(start) || enter_mode(m, INITIALISING))
}

EXPORT fmi3Status fmi3ExitInitializationMode(fmi3Instance m)
{
    ALLOWED(INITIALISING)
    CHECK(begin(m) || enter_mode(m, ((Instance *)m)->steps_itself ? STEPPING : EVENT))
}
EXPORT fmi3Status fmi3Reset(fmi3Instance m)
{
    ALLOWED(~0)
    initialise(m);
    return fmi3OK;
}
EXPORT fmi3Status fmi3Terminate(fmi3Instance m) { ALLOWED(STARTED) CHECK(enter_mode(m, TERMINATED)) }
EXPORT fmi3Status fmi3EnterEventMode(fmi3Instance m) { EXCHANGE(CONTINUOUS) CHECK(enter_mode(m, EVENT)) }
EXPORT fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance m) { EXCHANGE(EVENT) CHECK(enter_mode(m, CONTINUOUS)) }
EXPORT fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance m) { ALLOWED(INITIALISING | EVENT) return fmi3OK; }
NOT_PROVIDED(fmi3EnterStepMode, (fmi3Instance m)) /* of units with events in co-simulation */
NOT_PROVIDED(fmi3EnterConfigurationMode, (fmi3Instance m)) /* of units with structural parameters */
NOT_PROVIDED(fmi3ExitConfigurationMode, (fmi3Instance m))

EXPORT fmi3Status fmi3GetFloat64(fmi3Instance m, const fmi3ValueReference vr[], size_t n, double values[], size_t size)
{
    ALLOWED(READABLE)
    int failed = n != size;
    for (size_t k = 0; k < n && !failed; ++k) {
        failed |= get_value(m, vr[k], values + k);
    }
    CHECK(failed)
}

EXPORT fmi3Status fmi3SetFloat64(fmi3Instance m, const fmi3ValueReference vr[], size_t n, const double values[],
                                 size_t size)
{
    ALLOWED(WRITABLE)
    int failed = n != size;
    for (size_t k = 0; k < n && !failed; ++k) {
        failed |= set_value(m, vr[k], values[k]);
    }
    CHECK(failed)
}

#define NONE_OF(type, T)                                                                                               \
    EXPORT fmi3Status fmi3Get##type(fmi3Instance m, const fmi3ValueReference vr[], size_t n, T values[], size_t size)  \
    {                                                                                                                  \
        (void)m; (void)vr; (void)values; (void)size;                                                                   \
        return n == 0 ? fmi3OK : fmi3Error;                                                                            \
    }                                                                                                                  \
    EXPORT fmi3Status fmi3Set##type(fmi3Instance m, const fmi3ValueReference vr[], size_t n, const T values[],         \
                                    size_t size)                                                                       \
    {                                                                                                                  \
        (void)m; (void)vr; (void)values; (void)size;                                                                   \
        return n == 0 ? fmi3OK : fmi3Error;                                                                            \
    }
NONE_OF(Float32, float)
NONE_OF(Int8, int8_t)
NONE_OF(UInt8, uint8_t)
NONE_OF(Int16, int16_t)
NONE_OF(UInt16, uint16_t)
NONE_OF(Int32, int32_t)
NONE_OF(UInt32, uint32_t)
NONE_OF(Int64, int64_t)
NONE_OF(UInt64, uint64_t)
NONE_OF(Boolean, bool)
NONE_OF(String, fmi3String)
NOT_PROVIDED(fmi3GetBinary, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, size_t sizes[],
             fmi3Binary values[], size_t size))
NOT_PROVIDED(fmi3SetBinary, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, const size_t sizes[],
             const fmi3Binary values[], size_t size))
NOT_PROVIDED(fmi3GetClock, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, bool values[]))
NOT_PROVIDED(fmi3SetClock, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, const bool values[]))
NOT_PROVIDED(fmi3GetNumberOfVariableDependencies, (fmi3Instance m, fmi3ValueReference vr, size_t *n))
NOT_PROVIDED(fmi3GetVariableDependencies, (fmi3Instance m, fmi3ValueReference dependent, size_t of_dependent[],
             fmi3ValueReference independents[], size_t of_independents[], int kinds[], size_t n))

EXPORT fmi3Status fmi3GetFMUState(fmi3Instance m, fmi3FMUState *state)
{
    ALLOWED(~0)
    if (*state == NULL) {
        *state = malloc(sizeof(State));
    }
    if (*state == NULL) {
        return fmi3Error;
    }
    memcpy(*state, &((Instance *)m)->state, sizeof(State));
    return fmi3OK;
}
EXPORT fmi3Status fmi3SetFMUState(fmi3Instance m, fmi3FMUState state)
{
    ALLOWED(~0)
    if (state == NULL) {
        return fmi3Error;
    }
    memcpy(&((Instance *)m)->state, state, sizeof(State));
    return fmi3OK;
}
EXPORT fmi3Status fmi3FreeFMUState(fmi3Instance m, fmi3FMUState *state)
{
    (void)m;
    free(*state);
    *state = NULL;
    return fmi3OK;
}
EXPORT fmi3Status fmi3SerializedFMUStateSize(fmi3Instance m, fmi3FMUState state, size_t *size)
{
    (void)m;
    (void)state;
    *size = sizeof(State);
    return fmi3OK;
}
EXPORT fmi3Status fmi3SerializeFMUState(fmi3Instance m, fmi3FMUState state, uint8_t bytes[], size_t size)
{
    (void)m;
    if (state == NULL || size < sizeof(State)) {
        return fmi3Error;
    }
    memcpy(bytes, state, sizeof(State));
    return fmi3OK;
}
EXPORT fmi3Status fmi3DeserializeFMUState(fmi3Instance m, const uint8_t bytes[], size_t size, fmi3FMUState *state)
{
    if (size != sizeof(State) || fmi3GetFMUState(m, state) != fmi3OK) {
        return fmi3Error;
    }
    memcpy(*state, bytes, size);
    return fmi3OK;
}

/* -- model exchange -- */

EXPORT fmi3Status fmi3UpdateDiscreteStates(fmi3Instance m, bool *again, bool *terminate, bool *nominals, bool *values,
                                           bool *next_defined, double *next)
{
    EXCHANGE(EVENT)
    *again = *terminate = *nominals = *next_defined = false;
    *next = 0.0;
    *values = drifted(m) != 0;
    if (*values) {
        CHECK(close_state(m, settle))
    }
    return fmi3OK;
}

EXPORT fmi3Status fmi3CompletedIntegratorStep(fmi3Instance m, bool no_set, bool *event, bool *terminate)
{
    (void)no_set;
    EXCHANGE(CONTINUOUS)
    *event = drifted(m) != 0;
    *terminate = false;
    return fmi3OK;
}

EXPORT fmi3Status fmi3SetTime(fmi3Instance instance, double t)
{
    Instance *m = instance;
    EXCHANGE(EVENT | CONTINUOUS)
    if (!isfinite(t)) {
        return fmi3Error;
    }
    m->state.derived = m->state.derived && m->state.t == t;
    m->state.t = t;
    return fmi3OK;
}

EXPORT fmi3Status fmi3SetContinuousStates(fmi3Instance m, const double x[], size_t n)
{
    EXCHANGE(CONTINUOUS)
    int failed = n != NQ + NV + NX;
    for (unsigned int k = 0; k < NQ + NV + NX && !failed; ++k) {
        failed |= set_value(m, VR_Q + k, x[k]);
    }
    CHECK(failed)
}

static int slice(fmi3Instance m, unsigned int from, double out[], size_t n)
{
    int failed = n != NQ + NV + NX;
    for (unsigned int k = 0; k < NQ + NV + NX && !failed; ++k) {
        failed |= get_value(m, from + k, out + k);
    }
    return failed;
}
EXPORT fmi3Status fmi3GetContinuousStates(fmi3Instance m, double x[], size_t n)
{
    EXCHANGE(READABLE)
    CHECK(slice(m, VR_Q, x, n))
}
EXPORT fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance m, double x[], size_t n)
{
    EXCHANGE(READABLE)
    CHECK(slice(m, VR_Q_RATE, x, n))
}
EXPORT fmi3Status fmi3GetEventIndicators(fmi3Instance m, double z[], size_t n)
{
    (void)z;
    EXCHANGE(READABLE)
    return n == 0 ? fmi3OK : fmi3Error;
}
EXPORT fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance m, double x[], size_t n)
{
    EXCHANGE(INSTANTIATED | READABLE)
    for (size_t k = 0; k < n; ++k) {
        x[k] = 1.0;
    }
    return fmi3OK;
}
EXPORT fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance m, size_t *n)
{
    EXCHANGE(INSTANTIATED | READABLE)
    *n = 0;
    return fmi3OK;
}
EXPORT fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance m, size_t *n)
{
    EXCHANGE(INSTANTIATED | READABLE)
    *n = NQ + NV + NX;
    return fmi3OK;
}

/* -- co-simulation -- */

EXPORT fmi3Status fmi3DoStep(fmi3Instance instance, double t, double h, bool no_set, bool *event, bool *terminate,
                             bool *early, double *last)
{
    Instance *m = instance;
    (void)no_set;
    if (!allowed_if(1, m, STEPPING, __func__)) {
        return fmi3Error;
    }
    *event = *terminate = *early = false;
    const int failed = communicate(m, t, h) != 0;
    *last = m->state.t;
    CHECK(failed)
}
NOT_PROVIDED(fmi3GetOutputDerivatives, (fmi3Instance m, const fmi3ValueReference vr[], size_t n,
             const int32_t orders[], double values[], size_t size))
NOT_PROVIDED(fmi3ActivateModelPartition, (fmi3Instance m, fmi3ValueReference clock, double t))
NOT_PROVIDED(fmi3GetDirectionalDerivative, (fmi3Instance m, const fmi3ValueReference unknowns[], size_t u,
             const fmi3ValueReference knowns[], size_t k, const double seed[], size_t s, double out[], size_t n))
NOT_PROVIDED(fmi3GetAdjointDerivative, (fmi3Instance m, const fmi3ValueReference unknowns[], size_t u,
             const fmi3ValueReference knowns[], size_t k, const double seed[], size_t s, double out[], size_t n))
NOT_PROVIDED(fmi3GetIntervalDecimal, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, double intervals[],
             int qualifiers[]))
NOT_PROVIDED(fmi3GetIntervalFraction, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, uint64_t counters[],
             uint64_t resolutions[], int qualifiers[]))
NOT_PROVIDED(fmi3GetShiftDecimal, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, double shifts[]))
NOT_PROVIDED(fmi3GetShiftFraction, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, uint64_t counters[],
             uint64_t resolutions[]))
NOT_PROVIDED(fmi3SetIntervalDecimal, (fmi3Instance m, const fmi3ValueReference vr[], size_t n,
             const double intervals[]))
NOT_PROVIDED(fmi3SetIntervalFraction, (fmi3Instance m, const fmi3ValueReference vr[], size_t n,
             const uint64_t counters[], const uint64_t resolutions[]))
NOT_PROVIDED(fmi3SetShiftDecimal, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, const double shifts[]))
NOT_PROVIDED(fmi3SetShiftFraction, (fmi3Instance m, const fmi3ValueReference vr[], size_t n, const uint64_t counters[],
             const uint64_t resolutions[]))
