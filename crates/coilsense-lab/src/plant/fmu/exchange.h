/* The spring as equations that others solve, whichever standard asks. Two states a mode, so that no input's acceleration is asked for:
 * z = q + c.u, its motion relative to the mean, and w = z'/omega - 2 zeta c.u.
 *   z' = omega (w + 2 zeta c.u), w' = omega (c.u - z) - 2 zeta z'
 * Next door: the spring and its steps (unit.h). */

enum {
    EXCHANGE_STATES = 2 * {{ upper }}_MODES,
    EXCHANGE_STATE = UNIT_VALUES,
    EXCHANGE_DERIVATIVE = EXCHANGE_STATE + EXCHANGE_STATES,
    EXCHANGE_VALUES = EXCHANGE_DERIVATIVE + EXCHANGE_STATES
};

static const double exchange_nominals[EXCHANGE_STATES] = {
{%- for nominal in nominals %}
    {{ nominal }},
{%- endfor %}
};

typedef struct {
    struct {
        double frequency, ratio, shares[2];
    } modes[{{ upper }}_MODES];
    /* A plant for which no time passes: its step reads what there is. */
    {{ name }}_plant still;
    /* k, m and zeta for which all this is made. */
    double made[3];
} exchange;

static int exchange_make(exchange *e, unit *u)
{
    const double *parameters = u->now.parameters;
    double faster;
    int j;
    if (memcmp(parameters, e->made, sizeof e->made) == 0) {
        return 0;
    }
    memset(e->made, 0, sizeof e->made);
    if (unit_start(u, &e->still, 1.0) != 0) {
        return 1;
    }
    faster = {{ name }}_square_root((parameters[0] / {{ upper }}_STIFFNESS) / (parameters[1] / {{ upper }}_MASS));
    for (j = 0; j < {{ upper }}_MODES; j++) {
        {{ name }}_turn *turn = &e->still.modes[j];
        e->modes[j].frequency = {{ name }}_modes[j][0] * faster;
        e->modes[j].ratio = {{ name }}_modes[j][1] * parameters[2];
        /* What the ends' way in a step of 1 s is of a mode's pace is c/omega. */
        e->modes[j].shares[0] = turn->line[0] * e->modes[j].frequency;
        e->modes[j].shares[1] = turn->line[1] * e->modes[j].frequency;
        turn->quarters[0] = 1.0;
        turn->quarters[1] = turn->dragged = turn->rest[0] = turn->rest[1] = turn->rest[2] = 0.0;
    }
    memcpy(e->made, parameters, sizeof e->made);
    return 0;
}

/* c.u of a mode. */
static double exchange_dragged(const exchange *e, int j, const double inputs[2])
{
    return e->modes[j].shares[0] * inputs[0] + e->modes[j].shares[1] * inputs[1];
}

/* z and w of a mode; the spring's place and pace count from the inputs that it knows, and with inputs of zero are z and w. */
static void exchange_state(const exchange *e, const unit *u, int j, double state[2])
{
    const double *place = u->now.spring.modes[j], dragged = exchange_dragged(e, j, u->now.spring.inputs);
    state[0] = place[0] + dragged;
    state[1] = place[1] - 2.0 * e->modes[j].ratio * dragged;
}

static void exchange_derivative(const exchange *e, const unit *u, int j, double derivative[2])
{
    const double frequency = e->modes[j].frequency, ratio = e->modes[j].ratio;
    const double dragged = exchange_dragged(e, j, u->now.is_solved ? u->now.inputs : u->now.spring.inputs);
    double state[2];
    exchange_state(e, u, j, state);
    derivative[0] = frequency * (state[1] + 2.0 * ratio * dragged);
    derivative[1] = frequency * (dragged - state[0]) - 2.0 * ratio * derivative[0];
}

/* From the end of initialization on, the spring holds z and w. */
static int exchange_begin(exchange *e, unit *u)
{
    int j;
    if (exchange_make(e, u) != 0 || unit_initialized(u, UNIT_EVENTS) != 0) {
        return 1;
    }
    for (j = 0; j < {{ upper }}_MODES; j++) {
        double state[2];
        exchange_state(e, u, j, state);
        memcpy(u->now.spring.modes[j], state, sizeof state);
    }
    u->now.spring.inputs[0] = u->now.spring.inputs[1] = 0.0;
    return 0;
}

/* What the spring gives under the inputs and their rates at this moment. */
static int exchange_outputs(exchange *e, unit *u)
{
    {{ name }}_state once;
    {{ name }}_output out;
    int j;
    if (exchange_make(e, u) != 0) {
        return 1;
    }
    memset(&once, 0, sizeof once);
    once.inputs[0] = u->now.inputs[0] - u->now.rates[0];
    once.inputs[1] = u->now.inputs[1] - u->now.rates[1];
    for (j = 0; j < {{ upper }}_MODES; j++) {
        const double dragged = exchange_dragged(e, j, u->now.inputs);
        double state[2];
        exchange_state(e, u, j, state);
        once.modes[j][0] = state[0] - dragged;
        once.modes[j][1] = state[1] + 2.0 * e->modes[j].ratio * dragged;
    }
    out = {{ name }}_step(&e->still, &once, u->now.inputs[0], u->now.inputs[1]);
    return unit_keep(u, &e->still, &once, &out) != 0 ? unit_refuses(u, "inputs and states lead beyond what numbers hold", u->now.inputs[0]) : 0;
}

static int exchange_set(unit *u, unsigned int number, double value)
{
    if (number >= EXCHANGE_STATE && number < EXCHANGE_VALUES) {
        return unit_refuses(u, "only inputs and parameters can be set: a value of this reference is neither", number);
    }
    return unit_set(u, number, value);
}

static int exchange_get(exchange *e, unit *u, unsigned int number, double *value)
{
    const int is_begun = u->now.stage > UNIT_INITIALIZING;
    double pair[2];
    unsigned int place;
    if (number >= EXCHANGE_VALUES || number < UNIT_OUTPUT) {
        return unit_get(u, number, value);
    }
    if (number < UNIT_VALUES) {
        return u->now.is_solved && is_begun && exchange_outputs(e, u) != 0 ? 1 : unit_get(u, number, value);
    }
    if ((!is_begun && unit_settle(u) != 0) || exchange_make(e, u) != 0) {
        return 1;
    }
    place = (number - EXCHANGE_STATE) % EXCHANGE_STATES;
    if (number < EXCHANGE_DERIVATIVE) {
        exchange_state(e, u, (int)(place / 2), pair);
    } else {
        exchange_derivative(e, u, (int)(place / 2), pair);
    }
    *value = pair[place % 2];
    return 0;
}

/* All states at once. */
static int exchange_put(unit *u, const double states[], size_t count)
{
    size_t n;
    if (count != EXCHANGE_STATES) {
        return unit_refuses(u, "the states are two for each mode", (double)count);
    }
    for (n = 0; n < count; n++) {
        if (!unit_is_finite(states[n])) {
            return unit_refuses(u, "a state must be finite", states[n]);
        }
    }
    for (n = 0; n < count; n++) {
        u->now.spring.modes[n / 2][n % 2] = states[n];
    }
    return 0;
}

/* All states, or all their derivatives. */
static int exchange_read(exchange *e, unit *u, unsigned int first, double values[], size_t count)
{
    size_t n;
    if (count != EXCHANGE_STATES) {
        return unit_refuses(u, "the states are two for each mode", (double)count);
    }
    for (n = 0; n < count; n++) {
        if (exchange_get(e, u, first + (unsigned int)n, &values[n]) != 0) {
            return 1;
        }
    }
    return 0;
}
