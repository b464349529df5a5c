/* One spring that others step, whichever standard asks: numbered values, stages, checks, and words where something cannot be.
 * Next door: the spring ({{ name }}.h), what a standard calls all this (its .c). */
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "{{ name }}.h"

#define UNIT_ID "{{ id }}"
/* The step for which forces at rest are made ready; any other will do. */
#define UNIT_STEP {{ step }}

enum { UNIT_INSTANTIATED, UNIT_INITIALIZING, UNIT_STEPPING, UNIT_EVENTS, UNIT_CONTINUOUS, UNIT_TERMINATED };

/* Values by their numbers in modelDescription.xml. */
enum { UNIT_TIME, UNIT_INPUT, UNIT_RATE = 3, UNIT_PARAMETER = 5, UNIT_OUTPUT = 8, UNIT_OUTPUTS = {{ outputs | length }}, UNIT_VALUES = UNIT_OUTPUT + UNIT_OUTPUTS };

/* All that changes. is_solved: whether another solves the spring's equations, and the inputs are those of this very moment. */
typedef struct {
    int stage, is_solved;
    double time, inputs[2], rates[2], parameters[3], outputs[UNIT_OUTPUTS];
    {{ name }}_state spring;
} unit_state;

/* A state in bytes: whose it is, then the state as this machine keeps it. */
#define UNIT_BYTES (sizeof UNIT_ID + sizeof(unit_state))

typedef struct {
    unit_state now;
    {{ name }}_plant plant;
    /* k, m, zeta and the step for which the plant is made. */
    double made[4];
    /* What went wrong last. */
    char told[200];
} unit;

static int unit_is_finite(double value)
{
    return value >= -DBL_MAX && value <= DBL_MAX;
}

/* Keeps words for the log; they hold no per cent sign. */
static int unit_says(unit *u, const char *what)
{
    (void)snprintf(u->told, sizeof u->told, "%s", what);
    return 1;
}

static int unit_refuses(unit *u, const char *what, double value)
{
    (void)snprintf(u->told, sizeof u->told, "%s, got %.17g", what, value);
    return 1;
}

static void unit_reset(unit *u, int is_solved)
{
    memset(&u->now, 0, sizeof u->now);
    u->now.is_solved = is_solved;
    u->now.parameters[0] = {{ upper }}_STIFFNESS;
    u->now.parameters[1] = {{ upper }}_MASS;
    u->now.parameters[2] = {{ upper }}_DAMPING_RATIO;
    {{ name }}_settle(&u->now.spring, 0.0, 0.0);
}

/* Starts a plant with k, m and zeta as they are. */
static int unit_start(unit *u, {{ name }}_plant *plant, double step)
{
    static const char *const words[5] = {
        "", "k must be above zero and finite", "m must be above zero and finite",
        "zeta must be from zero on, and that of no mode above 1000", "the step is too long or too short for the modes"
    };
    const double wanted[4] = { u->now.parameters[0], u->now.parameters[1], u->now.parameters[2], step };
    const int wrong = {{ name }}_init(plant, wanted[0], wanted[1], wanted[2], wanted[3]);
    return wrong != 0 ? unit_refuses(u, words[wrong], wanted[wrong - 1]) : 0;
}

/* Makes the plant for a step, where it is not the one of last time. Places and paces of the modes do not depend on it. */
static int unit_make(unit *u, double step)
{
    const double wanted[4] = { u->now.parameters[0], u->now.parameters[1], u->now.parameters[2], step };
    if (memcmp(wanted, u->made, sizeof wanted) == 0) {
        return 0;
    }
    memset(u->made, 0, sizeof u->made);
    if (unit_start(u, &u->plant, step) != 0) {
        return 1;
    }
    memcpy(u->made, wanted, sizeof wanted);
    return 0;
}

/* Takes what the spring gives; nothing where a number of it is none. */
static int unit_keep(unit *u, const {{ name }}_plant *plant, const {{ name }}_state *state, const {{ name }}_output *out)
{
{%- if has_coil %}
    const {{ name }}_reading coil = {{ name }}_coil(plant, state);
{%- endif %}
    const double outputs[UNIT_OUTPUTS] = { {% for output in outputs %}{{ ", " if not loop.first }}{{ output }}{% endfor %} };
    int n;
    (void)plant;
    (void)state;
    for (n = 0; n < UNIT_OUTPUTS; n++) {
        if (!unit_is_finite(outputs[n])) {
            return 1;
        }
    }
    memcpy(u->now.outputs, outputs, sizeof outputs);
    return 0;
}

/* A spring at rest under the inputs as they are. */
static int unit_settle(unit *u)
{
    {{ name }}_state once;
    {{ name }}_output out;
    if (unit_make(u, UNIT_STEP) != 0) {
        return 1;
    }
    {{ name }}_settle(&u->now.spring, u->now.inputs[0], u->now.inputs[1]);
    once = u->now.spring;
    out = {{ name }}_step(&u->plant, &once, u->now.inputs[0], u->now.inputs[1]);
    return unit_keep(u, &u->plant, &once, &out) != 0 ? unit_refuses(u, "inputs lead beyond what numbers hold at rest", u->now.inputs[0]) : 0;
}

/* From one stage to the next. */
static int unit_begin(unit *u, double start)
{
    if (u->now.stage != UNIT_INSTANTIATED) {
        return unit_says(u, "initialization comes once, before any step, and the start time before it");
    }
    if (!unit_is_finite(start)) {
        return unit_refuses(u, "the start time must be finite", start);
    }
    u->now.time = start;
    return 0;
}

static int unit_initialize(unit *u)
{
    if (u->now.stage != UNIT_INSTANTIATED) {
        return unit_says(u, "initialization comes once, before any step");
    }
    u->now.stage = UNIT_INITIALIZING;
    return 0;
}

static int unit_initialized(unit *u, int next)
{
    if (u->now.stage != UNIT_INITIALIZING) {
        return unit_says(u, "initialization ends after it began");
    }
    if (unit_settle(u) != 0) {
        return 1;
    }
    u->now.stage = next;
    return 0;
}

static int unit_terminate(unit *u)
{
    if (u->now.stage <= UNIT_INITIALIZING || u->now.stage == UNIT_TERMINATED) {
        return unit_says(u, "the end comes once, after initialization");
    }
    u->now.stage = UNIT_TERMINATED;
    return 0;
}

static int unit_set(unit *u, unsigned int number, double value)
{
    if (number >= UNIT_VALUES) {
        return unit_refuses(u, "there is no value of this reference", number);
    }
    if (!unit_is_finite(value)) {
        return unit_refuses(u, "a value must be finite", value);
    }
    if (number >= UNIT_INPUT && number < UNIT_RATE) {
        u->now.inputs[number - UNIT_INPUT] = value;
        return 0;
    }
    if (number >= UNIT_RATE && number < UNIT_PARAMETER) {
        u->now.rates[number - UNIT_RATE] = value;
        return 0;
    }
    if (number < UNIT_PARAMETER || number >= UNIT_OUTPUT{% if has_mass %} || number == UNIT_PARAMETER + 1{% endif %}) {
        return unit_refuses(u, "only inputs and parameters can be set: a value of this reference is neither", number);
    }
    if (u->now.stage > UNIT_INITIALIZING) {
        return unit_refuses(u, "parameters can be set up to the end of initialization only", value);
    }
    u->now.parameters[number - UNIT_PARAMETER] = value;
    return 0;
}

static int unit_get(unit *u, unsigned int number, double *value)
{
    if (number >= UNIT_VALUES) {
        return unit_refuses(u, "there is no value of this reference", number);
    }
    if (number == UNIT_TIME) {
        *value = u->now.time;
    } else if (number < UNIT_RATE) {
        *value = u->now.inputs[number - UNIT_INPUT];
    } else if (number < UNIT_PARAMETER) {
        *value = u->now.rates[number - UNIT_RATE];
    } else if (number < UNIT_OUTPUT) {
        *value = u->now.parameters[number - UNIT_PARAMETER];
    } else {
        if (u->now.stage <= UNIT_INITIALIZING && unit_settle(u) != 0) {
            return 1;
        }
        *value = u->now.outputs[number - UNIT_OUTPUT];
    }
    return 0;
}

/* Goes from where the inputs were straight to where their rates lead by the step's end; without rates, to where they are. */
static int unit_advance(unit *u, double time, double step)
{
    const double reached[2] = { u->now.inputs[0] + u->now.rates[0] * step, u->now.inputs[1] + u->now.rates[1] * step };
    const {{ name }}_state before = u->now.spring;
    const double slack = 1e-2 * step + 1e-9 * (time < 0.0 ? -time : time);
    {{ name }}_output out;
    if (u->now.stage != UNIT_STEPPING) {
        return unit_says(u, "a step comes after initialization and before the end");
    }
    if (!(step > 0.0 && step <= DBL_MAX)) {
        return unit_refuses(u, "a communication step must be above zero and finite", step);
    }
    if (!(time >= u->now.time - slack && time <= u->now.time + slack)) {
        return unit_refuses(u, "a step must begin where the last one ended", time);
    }
    if (unit_make(u, step) != 0) {
        return 1;
    }
    out = {{ name }}_step(&u->plant, &u->now.spring, reached[0], reached[1]);
    if (unit_keep(u, &u->plant, &u->now.spring, &out) != 0) {
        u->now.spring = before;
        return unit_refuses(u, "inputs lead beyond what numbers hold at the end of the step", reached[0]);
    }
    u->now.time = time + step;
    return 0;
}

/* A state of its own, or NULL where there is no memory. */
static unit_state *unit_copy(const unit_state *state)
{
    unit_state *copy = malloc(sizeof *copy);
    if (copy != NULL) {
        memcpy(copy, state, sizeof *copy);
    }
    return copy;
}

static void unit_pack(const unit_state *state, void *bytes)
{
    memcpy(bytes, UNIT_ID, sizeof UNIT_ID);
    memcpy((char *)bytes + sizeof UNIT_ID, state, sizeof *state);
}

/* Whether bytes are a state of this FMU. */
static int unit_packed(const void *bytes, size_t size)
{
    return bytes != NULL && size == UNIT_BYTES && memcmp(bytes, UNIT_ID, sizeof UNIT_ID) == 0;
}

static unit_state *unit_unpack(const void *bytes)
{
    unit_state *state = malloc(sizeof *state);
    if (state != NULL) {
        memcpy(state, (const char *)bytes + sizeof UNIT_ID, sizeof *state);
    }
    return state;
}
