/* {{ title }}
 * FMI 2.0 for co-simulation and model exchange, C99, no library beside C's own. To build: this file alone, as a shared library; -ffp-contract=off keeps the bits.
 * Types and functions are those of the standard (fmi-standard.org, 2.0.5). */
#include <stddef.h>

#include "unit.h"
#include "exchange.h"

#if defined(_WIN32)
#define FMI2_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define FMI2_EXPORT __attribute__((visibility("default")))
#else
#define FMI2_EXPORT
#endif

/* Linked into a program, functions begin with a prefix of the importer's. */
#if defined(FMI2_FUNCTION_PREFIX) && !defined(FMI2_OVERRIDE_FUNCTION_PREFIX)
#define FMI2_JOINED(a, b) a##b
#define FMI2_JOIN(a, b) FMI2_JOINED(a, b)
#define F(name) FMI2_EXPORT fmi2Status FMI2_JOIN(FMI2_FUNCTION_PREFIX, name)
#define G(type, name) FMI2_EXPORT type FMI2_JOIN(FMI2_FUNCTION_PREFIX, name)
#else
#define F(name) FMI2_EXPORT fmi2Status name
#define G(type, name) FMI2_EXPORT type name
#endif

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
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;
typedef struct {
    void (*logger)(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String, ...);
    void *(*allocateMemory)(size_t, size_t);
    void (*freeMemory)(void *);
    void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

typedef struct {
    unit unit;
    exchange exchange;
    fmi2CallbackFunctions host;
    char name[128];
} instance;

/* Says what is wrong. */
static fmi2Status refused(instance *me, const char *what)
{
    if (me->host.logger != NULL) {
        me->host.logger(me->host.componentEnvironment, me->name, fmi2Error, "logStatusError", what);
    }
    return fmi2Error;
}

/* What a unit said, as the standard has it. */
static fmi2Status status(instance *me, int wrong)
{
    return wrong != 0 ? refused(me, me->unit.told) : fmi2OK;
}

static fmi2Status out_of_turn(instance *me, const char *what)
{
    return me != NULL ? refused(me, what) : fmi2Error;
}

G(const char *, fmi2GetTypesPlatform)(void)
{
    return "default";
}

G(const char *, fmi2GetVersion)(void)
{
    return "2.0";
}

G(fmi2Component, fmi2Instantiate)(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources, const fmi2CallbackFunctions *host,
                                  fmi2Boolean visible, fmi2Boolean logging)
{
    instance *me, unborn;
    (void)resources, (void)visible, (void)logging;
    memset(&unborn, 0, sizeof unborn);
    if (host != NULL) {
        unborn.host = *host;
    }
    if (name != NULL) {
        (void)snprintf(unborn.name, sizeof unborn.name, "%s", name);
    }
    if (type != fmi2CoSimulation && type != fmi2ModelExchange) {
        (void)refused(&unborn, "only co-simulation and model exchange are in here");
        return NULL;
    }
    if (guid == NULL || strcmp(guid, UNIT_ID) != 0) {
        (void)refused(&unborn, "the GUID is not that of modelDescription.xml, " UNIT_ID);
        return NULL;
    }
    me = calloc(1, sizeof *me);
    if (me == NULL) {
        (void)refused(&unborn, "no memory for an instance");
        return NULL;
    }
    me->host = unborn.host;
    memcpy(me->name, unborn.name, sizeof me->name);
    unit_reset(&me->unit, type == fmi2ModelExchange);
    return me;
}

G(void, fmi2FreeInstance)(fmi2Component c)
{
    free(c);
}

F(fmi2SetDebugLogging)(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[])
{
    (void)on, (void)count, (void)categories;
    return c != NULL ? fmi2OK : fmi2Error;
}

F(fmi2SetupExperiment)(fmi2Component c, fmi2Boolean tolerant, fmi2Real tolerance, fmi2Real start, fmi2Boolean stops, fmi2Real stop)
{
    instance *me = c;
    (void)tolerant, (void)tolerance, (void)stops, (void)stop;
    return me != NULL ? status(me, unit_begin(&me->unit, start)) : fmi2Error;
}

F(fmi2EnterInitializationMode)(fmi2Component c)
{
    instance *me = c;
    return me != NULL ? status(me, unit_initialize(&me->unit)) : fmi2Error;
}

F(fmi2ExitInitializationMode)(fmi2Component c)
{
    instance *me = c;
    if (me == NULL) {
        return fmi2Error;
    }
    return status(me, me->unit.now.is_solved ? exchange_begin(&me->exchange, &me->unit) : unit_initialized(&me->unit, UNIT_STEPPING));
}

F(fmi2Terminate)(fmi2Component c)
{
    instance *me = c;
    return me != NULL ? status(me, unit_terminate(&me->unit)) : fmi2Error;
}

F(fmi2Reset)(fmi2Component c)
{
    instance *me = c;
    if (me == NULL) {
        return fmi2Error;
    }
    unit_reset(&me->unit, me->unit.now.is_solved);
    return fmi2OK;
}

F(fmi2GetReal)(fmi2Component c, const fmi2ValueReference references[], size_t count, fmi2Real values[])
{
    instance *me = c;
    size_t n;
    for (n = 0; me != NULL && n < count; n++) {
        if (exchange_get(&me->exchange, &me->unit, references[n], &values[n]) != 0) {
            return refused(me, me->unit.told);
        }
    }
    return me != NULL ? fmi2OK : fmi2Error;
}

F(fmi2SetReal)(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Real values[])
{
    instance *me = c;
    size_t n;
    for (n = 0; me != NULL && n < count; n++) {
        if (exchange_set(&me->unit, references[n], values[n]) != 0) {
            return refused(me, me->unit.told);
        }
    }
    return me != NULL ? fmi2OK : fmi2Error;
}

/* All values are real. */
#define NO_VALUES(get, set, type, word)                                                                                     \
    F(get)(fmi2Component c, const fmi2ValueReference references[], size_t count, type values[])                             \
    {                                                                                                                       \
        (void)references, (void)values;                                                                                     \
        return c != NULL && count == 0 ? fmi2OK : out_of_turn(c, "there are no " word " values");                           \
    }                                                                                                                       \
    F(set)(fmi2Component c, const fmi2ValueReference references[], size_t count, const type values[])                       \
    {                                                                                                                       \
        (void)references, (void)values;                                                                                     \
        return c != NULL && count == 0 ? fmi2OK : out_of_turn(c, "there are no " word " values");                           \
    }
NO_VALUES(fmi2GetInteger, fmi2SetInteger, fmi2Integer, "integer")
NO_VALUES(fmi2GetBoolean, fmi2SetBoolean, fmi2Boolean, "Boolean")
NO_VALUES(fmi2GetString, fmi2SetString, fmi2String, "string")

F(fmi2GetFMUstate)(fmi2Component c, fmi2FMUstate *kept)
{
    instance *me = c;
    if (me == NULL || kept == NULL) {
        return out_of_turn(me, "fmi2GetFMUstate needs a place for the state");
    }
    if (*kept != NULL) {
        memcpy(*kept, &me->unit.now, sizeof(unit_state));
        return fmi2OK;
    }
    *kept = unit_copy(&me->unit.now);
    return *kept != NULL ? fmi2OK : refused(me, "no memory for a state");
}

F(fmi2SetFMUstate)(fmi2Component c, fmi2FMUstate kept)
{
    instance *me = c;
    if (me == NULL || kept == NULL) {
        return out_of_turn(me, "fmi2SetFMUstate needs a state");
    }
    if (((const unit_state *)kept)->is_solved != me->unit.now.is_solved) {
        return refused(me, "the state is that of an instance for the other interface");
    }
    memcpy(&me->unit.now, kept, sizeof(unit_state));
    return fmi2OK;
}

F(fmi2FreeFMUstate)(fmi2Component c, fmi2FMUstate *kept)
{
    if (c == NULL) {
        return fmi2Error;
    }
    if (kept != NULL) {
        free(*kept);
        *kept = NULL;
    }
    return fmi2OK;
}

F(fmi2SerializedFMUstateSize)(fmi2Component c, fmi2FMUstate kept, size_t *size)
{
    if (c == NULL || kept == NULL || size == NULL) {
        return out_of_turn(c, "fmi2SerializedFMUstateSize needs a state");
    }
    *size = UNIT_BYTES;
    return fmi2OK;
}

F(fmi2SerializeFMUstate)(fmi2Component c, fmi2FMUstate kept, fmi2Byte bytes[], size_t size)
{
    if (c == NULL || kept == NULL || bytes == NULL || size < UNIT_BYTES) {
        return out_of_turn(c, "fmi2SerializeFMUstate needs a state and room for it");
    }
    unit_pack(kept, bytes);
    return fmi2OK;
}

F(fmi2DeSerializeFMUstate)(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *kept)
{
    instance *me = c;
    if (me == NULL || kept == NULL || !unit_packed(bytes, size)) {
        return out_of_turn(me, "the bytes are no state of this FMU");
    }
    *kept = unit_unpack(bytes);
    return *kept != NULL ? fmi2OK : refused(me, "no memory for a state");
}

F(fmi2GetDirectionalDerivative)(fmi2Component c, const fmi2ValueReference unknowns[], size_t unknown, const fmi2ValueReference knowns[],
                                size_t known, const fmi2Real moved[], fmi2Real moves[])
{
    (void)unknowns, (void)unknown, (void)knowns, (void)known, (void)moved, (void)moves;
    return out_of_turn(c, "there are no directional derivatives");
}

/* The rate of an input: the same number as der_u1 and its like. */
F(fmi2SetRealInputDerivatives)(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[],
                               const fmi2Real values[])
{
    instance *me = c;
    size_t n;
    for (n = 0; me != NULL && n < count; n++) {
        if (references[n] < UNIT_INPUT || references[n] >= UNIT_RATE || orders[n] != 1) {
            return refused(me, "only first derivatives of inputs can be set");
        }
        if (unit_set(&me->unit, references[n] + (UNIT_RATE - UNIT_INPUT), values[n]) != 0) {
            return refused(me, me->unit.told);
        }
    }
    return me != NULL ? fmi2OK : fmi2Error;
}

F(fmi2GetRealOutputDerivatives)(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[],
                                fmi2Real values[])
{
    (void)references, (void)count, (void)orders, (void)values;
    return out_of_turn(c, "there are no derivatives of outputs");
}

F(fmi2DoStep)(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean is_final)
{
    instance *me = c;
    (void)is_final;
    if (me != NULL && me->unit.now.is_solved) {
        return refused(me, "fmi2DoStep is of co-simulation");
    }
    return me != NULL ? status(me, unit_advance(&me->unit, time, step)) : fmi2Error;
}

F(fmi2CancelStep)(fmi2Component c)
{
    return out_of_turn(c, "no step is under way");
}

/* A step is done when fmi2DoStep returns. */
F(fmi2GetStatus)(fmi2Component c, fmi2StatusKind kind, fmi2Status *value)
{
    (void)kind, (void)value;
    return c != NULL ? fmi2Discard : fmi2Error;
}

F(fmi2GetRealStatus)(fmi2Component c, fmi2StatusKind kind, fmi2Real *value)
{
    instance *me = c;
    if (me == NULL || value == NULL || kind != fmi2LastSuccessfulTime) {
        return me != NULL ? fmi2Discard : fmi2Error;
    }
    *value = me->unit.now.time;
    return fmi2OK;
}

F(fmi2GetIntegerStatus)(fmi2Component c, fmi2StatusKind kind, fmi2Integer *value)
{
    (void)kind, (void)value;
    return c != NULL ? fmi2Discard : fmi2Error;
}

F(fmi2GetBooleanStatus)(fmi2Component c, fmi2StatusKind kind, fmi2Boolean *value)
{
    if (c == NULL || value == NULL || kind != fmi2Terminated) {
        return c != NULL ? fmi2Discard : fmi2Error;
    }
    *value = 0;
    return fmi2OK;
}

F(fmi2GetStringStatus)(fmi2Component c, fmi2StatusKind kind, fmi2String *value)
{
    (void)kind, (void)value;
    return c != NULL ? fmi2Discard : fmi2Error;
}

#include "fmi2_exchange.h"
