/* The functions of FMI 2.0 over an instance. */

typedef void *fmi2Component;
typedef void *fmi2ComponentEnvironment;
typedef void *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String, ...);
typedef struct {
    fmi2CallbackLogger logger;
    void *(*allocateMemory)(size_t, size_t);
    void (*freeMemory)(void *);
    void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;
typedef struct {
    fmi2Boolean newDiscreteStatesNeeded, terminateSimulation, nominalsOfContinuousStatesChanged;
    fmi2Boolean valuesOfContinuousStatesChanged, nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif
#define CHECK(expression) return (expression) == 0 ? fmi2OK : fmi2Error;
#define NOT_PROVIDED(name, arguments) EXPORT fmi2Status name arguments { return fmi2Error; }
#define CO_SIMULATION 1 /* fmi2CoSimulation of fmi2Type */
#define ALLOWED(modes) if (!allowed(c, modes, __func__)) { return fmi2Error; }
#define EXCHANGE(modes) if (!allowed_if(0, c, modes, __func__)) { return fmi2Error; }

static void report(void *instance, int is_error, const char *message)
{
    Instance *m = instance;
    if (m->logger != NULL && (is_error || m->logging)) {
        fmi2CallbackLogger logger;
        memcpy(&logger, &m->logger, sizeof logger);
        logger(m->environment, m->name, is_error ? fmi2Error : fmi2OK, is_error ? "logStatusError" : "logAll", "%s",
               message);
    }
}

EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
EXPORT const char *fmi2GetVersion(void) { return "2.0"; }

EXPORT fmi2Component fmi2Instantiate(fmi2String name, int type, fmi2String guid, fmi2String resources,
                                     const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    (void)resources;
    (void)visible;
    Instance *m = calloc(1, sizeof *m);
    if (m == NULL) {
        return NULL;
    }
    m->name = malloc(strlen(name) + 1);
    if (m->name == NULL) {
        free(m);
        return NULL;
    }
    strcpy(m->name, name);
    m->report = report;
    m->logging = logging;
    m->steps_itself = type == CO_SIMULATION;
    if (callbacks != NULL) {
        m->environment = callbacks->componentEnvironment;
        memcpy(&m->logger, &callbacks->logger, sizeof m->logger);
    }
    if (guid == NULL || strcmp(guid, TOKEN) != 0) {
        report(m, 1, "the model description belongs to another binary: its guid differs");
        free(m->name);
        free(m);
        return NULL;
    }
    initialise(m);
    return m;
}

EXPORT void fmi2FreeInstance(fmi2Component c)
{
    Instance *m = c;
    if (m != NULL) {
        free(m->name);
        free(m);
    }
}

EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[])
{
    (void)n;
    (void)categories;
    ALLOWED(~0)
    ((Instance *)c)->logging = on;
    return fmi2OK;
}

EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                      fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop)
{
    (void)tolerance_defined;
    (void)tolerance;
    (void)stop_defined;
    (void)stop;
    ALLOWED(INSTANTIATED)
    ((Instance *)c)->state.t = start;
    return isfinite(start) ? fmi2OK : fmi2Error;
}

EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c) { ALLOWED(INSTANTIATED) CHECK(enter_mode(c, INITIALISING)) }
EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    ALLOWED(INITIALISING)
    CHECK(begin(c) || enter_mode(c, ((Instance *)c)->steps_itself ? STEPPING : EVENT))
}
EXPORT fmi2Status fmi2Terminate(fmi2Component c) { ALLOWED(STARTED) CHECK(enter_mode(c, TERMINATED)) }
EXPORT fmi2Status fmi2Reset(fmi2Component c)
{
    ALLOWED(~0)
    initialise(c);
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[])
{
    ALLOWED(READABLE)
    int failed = 0;
    for (size_t k = 0; k < n; ++k) {
        failed |= get_value(c, vr[k], value + k);
    }
    CHECK(failed)
}

EXPORT fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real value[])
{
    ALLOWED(WRITABLE)
    int failed = 0;
    for (size_t k = 0; k < n; ++k) {
        failed |= set_value(c, vr[k], value[k]);
    }
    CHECK(failed)
}

#define NONE_OF(type, T)                                                                                               \
    EXPORT fmi2Status fmi2Get##type(fmi2Component c, const fmi2ValueReference vr[], size_t n, T value[])               \
    {                                                                                                                  \
        (void)c; (void)vr; (void)value;                                                                                \
        return n == 0 ? fmi2OK : fmi2Error;                                                                            \
    }                                                                                                                  \
    EXPORT fmi2Status fmi2Set##type(fmi2Component c, const fmi2ValueReference vr[], size_t n, const T value[])         \
    {                                                                                                                  \
        (void)c; (void)vr; (void)value;                                                                                \
        return n == 0 ? fmi2OK : fmi2Error;                                                                            \
    }
NONE_OF(Integer, fmi2Integer)
NONE_OF(Boolean, fmi2Boolean)
NONE_OF(String, fmi2String)

EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    ALLOWED(~0)
    if (*state == NULL) {
        *state = malloc(sizeof(State));
    }
    if (*state == NULL) {
        return fmi2Error;
    }
    memcpy(*state, &((Instance *)c)->state, sizeof(State));
    return fmi2OK;
}
EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state)
{
    ALLOWED(~0)
    if (state == NULL) {
        return fmi2Error;
    }
    memcpy(&((Instance *)c)->state, state, sizeof(State));
    return fmi2OK;
}
EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    (void)c;
    free(*state);
    *state = NULL;
    return fmi2OK;
}
EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size)
{
    (void)c;
    (void)state;
    *size = sizeof(State);
    return fmi2OK;
}
EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    (void)c;
    if (state == NULL || size < sizeof(State)) {
        return fmi2Error;
    }
    memcpy(bytes, state, sizeof(State));
    return fmi2OK;
}
EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    if (size != sizeof(State) || fmi2GetFMUstate(c, state) != fmi2OK) {
        return fmi2Error;
    }
    memcpy(*state, bytes, size);
    return fmi2OK;
}

/* -- model exchange -- */

EXPORT fmi2Status fmi2EnterEventMode(fmi2Component c) { EXCHANGE(CONTINUOUS) CHECK(enter_mode(c, EVENT)) }
EXPORT fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) { EXCHANGE(EVENT) CHECK(enter_mode(c, CONTINUOUS)) }

EXPORT fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info)
{
    EXCHANGE(EVENT)
    memset(info, 0, sizeof *info);
    if (drifted(c)) {
        info->valuesOfContinuousStatesChanged = 1;
        CHECK(close_state(c, settle))
    }
    return fmi2OK;
}

EXPORT fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean no_set, fmi2Boolean *event,
                                              fmi2Boolean *terminate)
{
    (void)no_set;
    EXCHANGE(CONTINUOUS)
    *event = drifted(c);
    *terminate = 0;
    return fmi2OK;
}

EXPORT fmi2Status fmi2SetTime(fmi2Component c, fmi2Real t)
{
    Instance *m = c;
    EXCHANGE(EVENT | CONTINUOUS)
    if (!isfinite(t)) {
        return fmi2Error;
    }
    m->state.derived = m->state.derived && m->state.t == t;
    m->state.t = t;
    return fmi2OK;
}

EXPORT fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n)
{
    EXCHANGE(CONTINUOUS)
    int failed = n != NQ + NV + NX;
    for (unsigned int k = 0; k < NQ + NV + NX && !failed; ++k) {
        failed |= set_value(c, VR_Q + k, x[k]);
    }
    CHECK(failed)
}

static int slice(fmi2Component c, unsigned int from, double out[], size_t n)
{
    int failed = n != NQ + NV + NX;
    for (unsigned int k = 0; k < NQ + NV + NX && !failed; ++k) {
        failed |= get_value(c, from + k, out + k);
    }
    return failed;
}
EXPORT fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n)
{
    EXCHANGE(READABLE)
    CHECK(slice(c, VR_Q, x, n))
}
EXPORT fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real x[], size_t n)
{
    EXCHANGE(READABLE)
    CHECK(slice(c, VR_Q_RATE, x, n))
}
EXPORT fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real z[], size_t n)
{
    (void)z;
    EXCHANGE(READABLE)
    return n == 0 ? fmi2OK : fmi2Error;
}
EXPORT fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real x[], size_t n)
{
    EXCHANGE(INSTANTIATED | READABLE)
    for (size_t k = 0; k < n; ++k) {
        x[k] = 1.0;
    }
    return fmi2OK;
}

/* -- co-simulation -- */

EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real t, fmi2Real h, fmi2Boolean no_set)
{
    (void)no_set;
    return allowed_if(1, c, STEPPING, __func__) && communicate(c, t, h) == 0 ? fmi2OK : fmi2Error;
}
NOT_PROVIDED(fmi2GetDirectionalDerivative, (fmi2Component c, const fmi2ValueReference unknown[], size_t m,
             const fmi2ValueReference known[], size_t n, const fmi2Real seed[], fmi2Real sensitivity[]))
NOT_PROVIDED(fmi2SetRealInputDerivatives, (fmi2Component c, const fmi2ValueReference vr[], size_t n,
             const fmi2Integer order[], const fmi2Real value[]))
NOT_PROVIDED(fmi2GetRealOutputDerivatives, (fmi2Component c, const fmi2ValueReference vr[], size_t n,
             const fmi2Integer order[], fmi2Real value[]))
NOT_PROVIDED(fmi2CancelStep, (fmi2Component c))
NOT_PROVIDED(fmi2GetStatus, (fmi2Component c, int kind, fmi2Status *value))
NOT_PROVIDED(fmi2GetRealStatus, (fmi2Component c, int kind, fmi2Real *value))
NOT_PROVIDED(fmi2GetIntegerStatus, (fmi2Component c, int kind, fmi2Integer *value))
NOT_PROVIDED(fmi2GetBooleanStatus, (fmi2Component c, int kind, fmi2Boolean *value))
NOT_PROVIDED(fmi2GetStringStatus, (fmi2Component c, int kind, fmi2String *value))
