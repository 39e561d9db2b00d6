static const Function *chosen(SimStruct *S)
{
    char name[LONGEST_NAME];
    if (mxGetString(ssGetSFcnParam(S, 0), name, sizeof name) != 0) {
        return NULL;
    }
    for (size_t k = 0; k < sizeof functions / sizeof *functions; ++k) {
        if (strcmp(functions[k].name, name) == 0) {
            return &functions[k];
        }
    }
    return NULL;
}

static void mdlInitializeSizes(SimStruct *S)
{
    ssSetNumSFcnParams(S, 1);
    if (ssGetNumSFcnParams(S) != ssGetSFcnParamsCount(S)) {
        return; /* Simulink says so */
    }
    ssSetSFcnParamTunable(S, 0, 0);
    const Function *const own = chosen(S);
    if (own == NULL) {
        ssSetErrorStatus(S, NO_SUCH_FUNCTION);
        return;
    }
    if (!ssSetNumInputPorts(S, own->inputs) || !ssSetNumOutputPorts(S, own->outputs + 1)) {
        return;
    }
    for (int_T k = 0; k < own->inputs; ++k) {
        ssSetInputPortWidth(S, k, own->input_size[k]);
        ssSetInputPortRequiredContiguous(S, k, 1);
        ssSetInputPortDirectFeedThrough(S, k, 1);
    }
    for (int_T k = 0; k < own->outputs; ++k) {
        ssSetOutputPortWidth(S, k, own->output_size[k]);
    }
    ssSetOutputPortWidth(S, own->outputs, 1);
    ssSetNumSampleTimes(S, 1);
    ssSetOptions(S, SS_OPTION_EXCEPTION_FREE_CODE);
}

static void mdlInitializeSampleTimes(SimStruct *S)
{
    ssSetSampleTime(S, 0, INHERITED_SAMPLE_TIME);
    ssSetOffsetTime(S, 0, 0.0);
}

#define MDL_START
static void mdlStart(SimStruct *S)
{
    ssSetUserData(S, (void *)chosen(S));
}

static void mdlOutputs(SimStruct *S, int_T tid)
{
    const Function *const own = (const Function *)ssGetUserData(S);
    const real_T *given[MOST_PORTS] = {NULL};
    real_T *made[MOST_PORTS] = {NULL};
    (void)tid;
    for (int_T k = 0; k < own->inputs; ++k) {
        given[k] = (const real_T *)ssGetInputPortSignal(S, k);
    }
    for (int_T k = 0; k < own->outputs; ++k) {
        made[k] = (real_T *)ssGetOutputPortSignal(S, k);
    }
    *(real_T *)ssGetOutputPortSignal(S, own->outputs) = own->call(given, made);
}

static void mdlTerminate(SimStruct *S)
{
    (void)S;
}

#ifdef MATLAB_MEX_FILE
#include "simulink.c"
#else
#include "cg_sfun.h"
#endif
