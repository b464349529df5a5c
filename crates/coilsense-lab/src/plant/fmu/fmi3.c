/* {{ title }}
 * FMI 3.0 for co-simulation, C99, no library beside C's own. To build: this file alone, as a shared library; -ffp-contract=off keeps the bits.
 * Types and functions are those of the standard (fmi-standard.org, 3.0.2); it wants all of them to be here, those of other interfaces too. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "unit.h"

#if defined(_WIN32)
#define FMI3_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define FMI3_EXPORT __attribute__((visibility("default")))
#else
#define FMI3_EXPORT
#endif

/* Linked into a program, functions begin with a prefix of the importer's. */
#if defined(FMI3_FUNCTION_PREFIX) && !defined(FMI3_OVERRIDE_FUNCTION_PREFIX)
#define FMI3_JOINED(a, b) a##b
#define FMI3_JOIN(a, b) FMI3_JOINED(a, b)
#define G(type, name) FMI3_EXPORT type FMI3_JOIN(FMI3_FUNCTION_PREFIX, name)
#else
#define G(type, name) FMI3_EXPORT type name
#endif
#define F(name) G(fmi3Status, name)

typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef const char *fmi3String;
typedef uint8_t fmi3Byte;
typedef const fmi3Byte *fmi3Binary;
typedef bool fmi3Clock;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef enum { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent } fmi3DependencyKind;
typedef enum { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged } fmi3IntervalQualifier;
typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String, fmi3String);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment, fmi3Float64, fmi3Boolean, fmi3Boolean, fmi3Boolean, fmi3Boolean,
                                               fmi3Boolean *, fmi3Float64 *);
typedef void (*fmi3LockPreemptionCallback)(void);
typedef void (*fmi3UnlockPreemptionCallback)(void);

typedef struct {
    unit unit;
    fmi3LogMessageCallback log;
    fmi3InstanceEnvironment host;
} instance;

/* Says what is wrong. */
static fmi3Status refused(const instance *me, const char *what)
{
    if (me != NULL && me->log != NULL) {
        me->log(me->host, fmi3Error, "logStatusError", what);
    }
    return fmi3Error;
}

/* What a unit said, as the standard has it. */
static fmi3Status status(const instance *me, int wrong)
{
    return wrong != 0 ? refused(me, me->unit.told) : fmi3OK;
}

G(const char *, fmi3GetVersion)(void)
{
    return "3.0";
}

F(fmi3SetDebugLogging)(fmi3Instance c, fmi3Boolean on, size_t count, const fmi3String categories[])
{
    (void)on, (void)count, (void)categories;
    return c != NULL ? fmi3OK : fmi3Error;
}

G(fmi3Instance, fmi3InstantiateCoSimulation)(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
                                             fmi3Boolean events, fmi3Boolean early, const fmi3ValueReference intermediate[], size_t count,
                                             fmi3InstanceEnvironment host, fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update)
{
    instance *me, unborn;
    (void)name, (void)resources, (void)visible, (void)logging, (void)early, (void)intermediate, (void)update;
    unborn.log = log;
    unborn.host = host;
    if (token == NULL || strcmp(token, UNIT_ID) != 0) {
        (void)refused(&unborn, "the instantiation token is not that of modelDescription.xml, " UNIT_ID);
        return NULL;
    }
    if (events || count > 0) {
        (void)refused(&unborn, events ? "there is no event mode" : "there is no intermediate update");
        return NULL;
    }
    me = calloc(1, sizeof *me);
    if (me == NULL) {
        (void)refused(&unborn, "no memory for an instance");
        return NULL;
    }
    me->log = log;
    me->host = host;
    unit_reset(&me->unit, 0);
    return me;
}

/* Interfaces that are not in here. */
static fmi3Instance no_instance(fmi3InstanceEnvironment host, fmi3LogMessageCallback log)
{
    if (log != NULL) {
        log(host, fmi3Error, "logStatusError", "only co-simulation is in here");
    }
    return NULL;
}

G(fmi3Instance, fmi3InstantiateModelExchange)(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
                                              fmi3InstanceEnvironment host, fmi3LogMessageCallback log)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging;
    return no_instance(host, log);
}

G(fmi3Instance, fmi3InstantiateScheduledExecution)(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                                   fmi3Boolean logging, fmi3InstanceEnvironment host, fmi3LogMessageCallback log,
                                                   fmi3ClockUpdateCallback update, fmi3LockPreemptionCallback lock,
                                                   fmi3UnlockPreemptionCallback unlock)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)update, (void)lock, (void)unlock;
    return no_instance(host, log);
}

G(void, fmi3FreeInstance)(fmi3Instance c)
{
    free(c);
}

F(fmi3EnterInitializationMode)(fmi3Instance c, fmi3Boolean tolerant, fmi3Float64 tolerance, fmi3Float64 start, fmi3Boolean stops, fmi3Float64 stop)
{
    instance *me = c;
    (void)tolerant, (void)tolerance, (void)stops, (void)stop;
    if (me == NULL) {
        return fmi3Error;
    }
    return status(me, unit_begin(&me->unit, start) != 0 || unit_initialize(&me->unit) != 0);
}

F(fmi3ExitInitializationMode)(fmi3Instance c)
{
    instance *me = c;
    return me != NULL ? status(me, unit_initialized(&me->unit, UNIT_STEPPING)) : fmi3Error;
}

F(fmi3Terminate)(fmi3Instance c)
{
    instance *me = c;
    return me != NULL ? status(me, unit_terminate(&me->unit)) : fmi3Error;
}

F(fmi3Reset)(fmi3Instance c)
{
    instance *me = c;
    if (me == NULL) {
        return fmi3Error;
    }
    unit_reset(&me->unit, 0);
    return fmi3OK;
}

F(fmi3GetFloat64)(fmi3Instance c, const fmi3ValueReference references[], size_t count, fmi3Float64 values[], size_t size)
{
    instance *me = c;
    size_t n;
    if (me == NULL || size != count) {
        return refused(me, "each reference has one value");
    }
    for (n = 0; n < count; n++) {
        if (unit_get(&me->unit, references[n], &values[n]) != 0) {
            return refused(me, me->unit.told);
        }
    }
    return fmi3OK;
}

F(fmi3SetFloat64)(fmi3Instance c, const fmi3ValueReference references[], size_t count, const fmi3Float64 values[], size_t size)
{
    instance *me = c;
    size_t n;
    if (me == NULL || size != count) {
        return refused(me, "each reference has one value");
    }
    for (n = 0; n < count; n++) {
        if (unit_set(&me->unit, references[n], values[n]) != 0) {
            return refused(me, me->unit.told);
        }
    }
    return fmi3OK;
}

/* All values are Float64. */
static fmi3Status no_values(const instance *me, size_t count)
{
    return me != NULL && count == 0 ? fmi3OK : refused(me, "all values are Float64");
}
#define NO_VALUES(type)                                                                                                                         \
    F(fmi3Get##type)(fmi3Instance c, const fmi3ValueReference references[], size_t count, fmi3##type values[], size_t size)                     \
    {                                                                                                                                           \
        (void)references, (void)values, (void)size;                                                                                             \
        return no_values(c, count);                                                                                                             \
    }                                                                                                                                           \
    F(fmi3Set##type)(fmi3Instance c, const fmi3ValueReference references[], size_t count, const fmi3##type values[], size_t size)               \
    {                                                                                                                                           \
        (void)references, (void)values, (void)size;                                                                                             \
        return no_values(c, count);                                                                                                             \
    }
NO_VALUES(Float32)
NO_VALUES(Int8)
NO_VALUES(UInt8)
NO_VALUES(Int16)
NO_VALUES(UInt16)
NO_VALUES(Int32)
NO_VALUES(UInt32)
NO_VALUES(Int64)
NO_VALUES(UInt64)
NO_VALUES(Boolean)
NO_VALUES(String)

F(fmi3GetBinary)(fmi3Instance c, const fmi3ValueReference references[], size_t count, size_t sizes[], fmi3Binary values[], size_t size)
{
    (void)references, (void)sizes, (void)values, (void)size;
    return no_values(c, count);
}

F(fmi3SetBinary)(fmi3Instance c, const fmi3ValueReference references[], size_t count, const size_t sizes[], const fmi3Binary values[], size_t size)
{
    (void)references, (void)sizes, (void)values, (void)size;
    return no_values(c, count);
}

F(fmi3GetClock)(fmi3Instance c, const fmi3ValueReference references[], size_t count, fmi3Clock values[])
{
    (void)references, (void)values;
    return no_values(c, count);
}

F(fmi3SetClock)(fmi3Instance c, const fmi3ValueReference references[], size_t count, const fmi3Clock values[])
{
    (void)references, (void)values;
    return no_values(c, count);
}

F(fmi3GetFMUState)(fmi3Instance c, fmi3FMUState *kept)
{
    instance *me = c;
    if (me == NULL || kept == NULL) {
        return refused(me, "fmi3GetFMUState needs a place for the state");
    }
    if (*kept != NULL) {
        memcpy(*kept, &me->unit.now, sizeof(unit_state));
        return fmi3OK;
    }
    *kept = unit_copy(&me->unit.now);
    return *kept != NULL ? fmi3OK : refused(me, "no memory for a state");
}

F(fmi3SetFMUState)(fmi3Instance c, fmi3FMUState kept)
{
    instance *me = c;
    if (me == NULL || kept == NULL) {
        return refused(me, "fmi3SetFMUState needs a state");
    }
    memcpy(&me->unit.now, kept, sizeof(unit_state));
    return fmi3OK;
}

F(fmi3FreeFMUState)(fmi3Instance c, fmi3FMUState *kept)
{
    if (c == NULL) {
        return fmi3Error;
    }
    if (kept != NULL) {
        free(*kept);
        *kept = NULL;
    }
    return fmi3OK;
}

F(fmi3SerializedFMUStateSize)(fmi3Instance c, fmi3FMUState kept, size_t *size)
{
    if (c == NULL || kept == NULL || size == NULL) {
        return refused(c, "fmi3SerializedFMUStateSize needs a state");
    }
    *size = UNIT_BYTES;
    return fmi3OK;
}

F(fmi3SerializeFMUState)(fmi3Instance c, fmi3FMUState kept, fmi3Byte bytes[], size_t size)
{
    if (c == NULL || kept == NULL || bytes == NULL || size < UNIT_BYTES) {
        return refused(c, "fmi3SerializeFMUState needs a state and room for it");
    }
    unit_pack(kept, bytes);
    return fmi3OK;
}

F(fmi3DeserializeFMUState)(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *kept)
{
    instance *me = c;
    if (me == NULL || kept == NULL || !unit_packed(bytes, size)) {
        return refused(me, "the bytes are no state of this FMU");
    }
    *kept = unit_unpack(bytes);
    return *kept != NULL ? fmi3OK : refused(me, "no memory for a state");
}

/* A step is done when this returns, and nothing happens in it. */
F(fmi3DoStep)(fmi3Instance c, fmi3Float64 time, fmi3Float64 step, fmi3Boolean is_final, fmi3Boolean *event, fmi3Boolean *terminates,
              fmi3Boolean *early, fmi3Float64 *reached)
{
    fmi3Boolean *const none[3] = { event, terminates, early };
    instance *me = c;
    fmi3Status went;
    int n;
    (void)is_final;
    if (me == NULL) {
        return fmi3Error;
    }
    for (n = 0; n < 3; n++) {
        if (none[n] != NULL) {
            *none[n] = false;
        }
    }
    went = status(me, unit_advance(&me->unit, time, step));
    if (reached != NULL) {
        *reached = me->unit.now.time;
    }
    return went;
}

#include "fmi3_others.h"
