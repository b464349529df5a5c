/* {{ title }}
 * C99, no library, no allocation; SI units, force tension-positive, positions from end 1 to end 2.
 *
 *   static {{ name }}_plant plant;
 *   static {{ name }}_state state;
 *   if ({{ name }}_init(&plant, {{ upper }}_STIFFNESS, {{ upper }}_MASS, {{ upper }}_DAMPING_RATIO, 1e-3) != 0) { stop(); }
 *   {{ name }}_settle(&state, 0, 0);
 *   each millisecond: {{ name }}_output out = {{ name }}_step(&plant, &state, u1, u2);
 *
 * Inputs count from their means: u1 [m] and {{ second }}. They run straight from the last sample to this one: a step is exact at the sample
 * where the input is read now. Without contraction of products and sums (-std=c99, or -ffp-contract=off; not -ffast-math) numbers equal those of
 * coilsense-rt to the bit. */
#ifndef {{ upper }}_H
#define {{ upper }}_H

#include <float.h>
{%- if sensors %}
#include <stdint.h>
{%- endif %}

#if defined(__clang__) || !defined(__GNUC__)
#pragma STDC FP_CONTRACT OFF
#endif

typedef {{ real }} {{ name }}_real;

#define {{ upper }}_MODES {{ modes | length }}
/* k [N/m], m [kg], and the damping ratio of the first mode that is damped: what the spring has; {{ name }}_init takes others. */
#define {{ upper }}_STIFFNESS {{ stiffness }}
#define {{ upper }}_MASS {{ mass }}
#define {{ upper }}_DAMPING_RATIO {{ damping_ratio }}

/* A mode: its frequency [rad/s], its damping over the plant's, what input 1 and 2 drive of it, what it pulls at end 1 and 2 [N/m], how far it
 * moves end 2. */
static const double {{ name }}_modes[{{ upper }}_MODES][7] = {
{%- for mode in modes %}
    { {{ mode | join(', ') }} },
{%- endfor %}
};

{%- include "windings_tables" %}

/* What a step does to a mode: quarter turns, the rest of the turn, what the ends' way takes along, what it pulls. */
typedef struct {
    {{ name }}_real quarters[2], dragged, rest[3], line[2], weights[2]{% if dashpots %}, rates[2]{% endif %}{% if not is_position %}, end{% endif %}{% if is_single %}, mend[2][2]{% endif %};
} {{ name }}_turn;

typedef struct {
    {{ name }}_real stiffness, preload{% if not is_position %}, compliance{% endif %};
{%- if dashpots %}
    int has_dashpots;
{%- endif %}
    {{ name }}_turn modes[{{ upper }}_MODES];
} {{ name }}_plant;

typedef struct {
    {{ name }}_real modes[{{ upper }}_MODES][2], inputs[2], moved[2];
{%- if is_single %}
    int steps;
{%- endif %}
} {{ name }}_state;

/* F_i, F_o and F_x [N], and u2 [m] from its mean. */
typedef struct {
    {{ name }}_real input, output, deflection, end;
} {{ name }}_output;

static inline double {{ name }}_polynomial(const double *coefficients, int count, double x)
{
    double sum = 0.0;
    while (count > 0) {
        count--;
        sum = sum * x + coefficients[count];
    }
    return sum;
}

static inline double {{ name }}_square_root(double x)
{
    double rest = x, scale = 1.0, root;
    int n;
    while (rest >= 4.0) {
        rest *= 0.25;
        scale *= 2.0;
    }
    while (rest < 1.0) {
        rest *= 4.0;
        scale *= 0.5;
    }
    root = 0.72 + 0.33 * rest;
    for (n = 0; n < 4; n++) {
        root = 0.5 * (root + rest / root);
    }
    return scale * root;
}

/* e^x - 1 for x not above zero. */
static inline double {{ name }}_exponential_less_one(double x)
{
    static const double series[14] = {
        1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0, 1.0 / 5040.0, 1.0 / 40320.0, 1.0 / 362880.0, 1.0 / 3628800.0,
        1.0 / 39916800.0, 1.0 / 479001600.0, 1.0 / 6227020800.0, 1.0 / 87178291200.0
    };
    unsigned long halvings, n;
    double count, rest, scale = 1.0;
    if (x < -40.0) {
        return -1.0;
    }
    halvings = (unsigned long)(0.5 - x * 1.4426950408889634);
    count = (double)halvings;
    rest = (x + count * 6.931471803691238e-1) + count * 1.9082149292705877e-10;
    for (n = 0; n < halvings; n++) {
        scale *= 0.5;
    }
    return scale * (rest * {{ name }}_polynomial(series, 14, rest)) + (scale - 1.0);
}

/* sin x and cos x - 1 for x within a quarter of pi. */
static inline void {{ name }}_sine_and_cosine_less_one(double x, double *sine, double *dip)
{
    static const double sines[8] = {
        -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362880.0, -1.0 / 39916800.0, 1.0 / 6227020800.0, -1.0 / 1307674368000.0,
        1.0 / 355687428096000.0
    };
    static const double cosines[9] = {
        -1.0 / 2.0, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40320.0, -1.0 / 3628800.0, 1.0 / 479001600.0, -1.0 / 87178291200.0,
        1.0 / 20922789888000.0, -1.0 / 6402373705728000.0
    };
    const double square = x * x;
    *sine = x + x * (square * {{ name }}_polynomial(sines, 8, square));
    *dip = square * {{ name }}_polynomial(cosines, 9, square);
}

/* A mode's step by its angle and damping ratio: quarter turns, and a, b, d of what is left. */
static inline void {{ name }}_mode_step(double angle, double ratio, double quarters[2], double rest[3])
{
    const double square = (1.0 - ratio) * (1.0 + ratio);
    double less, sine, taken = 0.0;
    quarters[0] = 1.0;
    quarters[1] = 0.0;
    if (square > 0.0) {
        const double root = {{ name }}_square_root(square), turned = root * angle;
        const unsigned long whole = (unsigned long)(turned * 0.6366197723675814 + 0.5);
        const double count = (double)whole, decay = {{ name }}_exponential_less_one(-(ratio * angle)), left = 1.0 + decay;
        const int rings_on = ratio * angle <= 1.0 / 64.0;
        double s, dip, c;
        {{ name }}_sine_and_cosine_less_one(
            ((turned - count * 1.5707963267341256) - count * 6.077100506303966e-11) - count * 2.0222662487111665e-21, &s, &dip);
        c = 1.0 + dip;
        switch (whole % 4) {
        case 0:
            less = decay * c + dip;
            sine = left * s / root;
            break;
        case 1:
            less = -(left * s) - 1.0;
            sine = left * c / root;
            if (rings_on) {
                less = less + 1.0;
                quarters[0] = 0.0;
                quarters[1] = 1.0;
                taken = 1.0;
            }
            break;
        case 2:
            less = -(left * c) - 1.0;
            sine = -(left * s) / root;
            if (rings_on) {
                less = -(decay * c + dip);
                quarters[0] = -1.0;
            }
            break;
        default:
            less = left * s - 1.0;
            sine = -(left * c) / root;
            if (rings_on) {
                less = less + 1.0;
                quarters[0] = 0.0;
                quarters[1] = -1.0;
                taken = -1.0;
            }
            break;
        }
    } else {
        const double root = -square > 0.0 ? {{ name }}_square_root(-square) : 0.0;
        const double fast = (ratio + root) * angle, slow = angle / (ratio + root);
        const double of_slow = {{ name }}_exponential_less_one(-slow), of_fast = {{ name }}_exponential_less_one(-fast);
        const double gap = 2.0 * (root * angle);
        const double unit = gap > 0.0 ? -{{ name }}_exponential_less_one(-gap) / gap : 1.0;
        sine = (of_slow + 1.0) * (unit * angle);
        less = 0.5 * (of_slow + of_fast);
    }
    rest[0] = less + ratio * sine;
    rest[1] = sine - taken;
    rest[2] = less - ratio * sine;
}

/* Begins with a stiffness [N/m], a mass [kg], a damping ratio and a step [s]. Gives 0, or what cannot be: 1 the stiffness, 2 the mass{% if has_mass %}, which
 * must be the spring's, as the modes belong to the mass at end 2{% endif %}, 3 the damping ratio (no mode's may be above 1000), 4 the step{% if sensors %}, which must be
 * {{ upper }}_READ_STEP, for which the instruments are made{% endif %}. */
static inline int {{ name }}_init({{ name }}_plant *plant, double stiffness, double mass, double damping_ratio, double step)
{
    double harder, faster{% if dashpots %}, dashpot{% endif %}{% if not is_position %}, softer{% endif %};
    int j;
    if (!(stiffness > 0.0 && stiffness <= DBL_MAX)) {
        return 1;
    }
    if (!(mass > 0.0 && mass <= DBL_MAX){% if has_mass %} || mass != {{ upper }}_MASS{% endif %}) {
        return 2;
    }
    if (!(damping_ratio >= 0.0)) {
        return 3;
    }
    if (!(step > 0.0 && step <= DBL_MAX){% if sensors %} || step != {{ upper }}_READ_STEP{% endif %}) {
        return 4;
    }
    harder = stiffness / {{ upper }}_STIFFNESS;
    faster = {{ name }}_square_root(harder / (mass / {{ upper }}_MASS));
{%- if dashpots %}
    dashpot = 2.0 * damping_ratio / ({{ damped_frequency }} * faster);
    plant->has_dashpots = dashpot > 0.0;
{%- endif %}
{%- if not is_position %}
    softer = 1.0 / harder;
    plant->compliance = ({{ name }}_real)(1.0 / stiffness);
{%- endif %}
    plant->stiffness = ({{ name }}_real)stiffness;
    plant->preload = ({{ name }}_real)(stiffness * {{ stretch }});
    for (j = 0; j < {{ upper }}_MODES; j++) {
        const double *mode = {{ name }}_modes[j];
        {{ name }}_turn *turn = &plant->modes[j];
        const double frequency = mode[0] * faster, ratio = mode[1] * damping_ratio, angle = frequency * step;
        const double input = mode[4] * harder, output = mode[5] * harder;
        double quarters[2], rest[3];
        if (!(ratio <= 1e3)) {
            return 3;
        }
        if (!(angle > 0.0 && angle <= 1e9)) {
            return 4;
        }
        {{ name }}_mode_step(angle, ratio, quarters, rest);
        turn->quarters[0] = ({{ name }}_real)quarters[0];
        turn->quarters[1] = ({{ name }}_real)quarters[1];
        turn->dragged = ({{ name }}_real)(1.0 - quarters[0]);
        turn->rest[0] = ({{ name }}_real)rest[0];
        turn->rest[1] = ({{ name }}_real)rest[1];
        turn->rest[2] = ({{ name }}_real)rest[2];
        turn->line[0] = ({{ name }}_real)(mode[2] / angle);
        turn->line[1] = ({{ name }}_real)(mode[3]{% if not is_position %} * softer{% endif %} / angle);
        turn->weights[0] = ({{ name }}_real)input;
        turn->weights[1] = ({{ name }}_real)output;
{%- if dashpots %}
        turn->rates[0] = ({{ name }}_real)(input * (dashpot * frequency));
        turn->rates[1] = ({{ name }}_real)(output * (dashpot * frequency));
{%- endif %}
{%- if not is_position %}
        turn->end = ({{ name }}_real)mode[6];
{%- endif %}
{%- if is_single %}
        turn->mend[0][0] = turn->mend[0][1] = turn->mend[1][0] = turn->mend[1][1] = {{ zero }};
        if (!(ratio * angle > 1.0 / 64.0)) {
            const double m11 = quarters[0] + rest[0], m12 = quarters[1] + rest[1], m22 = quarters[0] + rest[2];
            const double a = rest[0] - (double)turn->rest[0], b = rest[1] - (double)turn->rest[1], d = rest[2] - (double)turn->rest[2];
            const double scale = {{ mends }}.0 / (m11 * m22 + m12 * m12);
            turn->mend[0][0] = ({{ name }}_real)(scale * (m22 * a + m12 * b));
            turn->mend[0][1] = ({{ name }}_real)(scale * (m22 * b - m12 * d));
            turn->mend[1][0] = ({{ name }}_real)(scale * (m12 * a - m11 * b));
            turn->mend[1][1] = ({{ name }}_real)(scale * (m12 * b + m11 * d));
        }
{%- endif %}
    }
    return 0;
}

/* A spring at rest under inputs that have been there for ever; zeros are the mean length. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real first, {{ name }}_real second)
{
    int j;
    for (j = 0; j < {{ upper }}_MODES; j++) {
        state->modes[j][0] = {{ zero }};
        state->modes[j][1] = {{ zero }};
    }
    state->inputs[0] = first;
    state->inputs[1] = second;
    state->moved[0] = {{ zero }};
    state->moved[1] = {{ zero }};
{%- if is_single %}
    state->steps = 0;
{%- endif %}
}

/* Takes u1 [m] and {{ second }} at this sample and gives the forces at it. */
static inline {{ name }}_output {{ name }}_step(const {{ name }}_plant *plant, {{ name }}_state *state, {{ name }}_real first, {{ name }}_real second)
{
    const {{ name }}_real moved1 = first - state->inputs[0], moved2 = second - state->inputs[1];
    {{ name }}_real input = {{ zero }}, output = {{ zero }}, still{% if not is_position %}, swing = {{ zero }}{% endif %};
    {{ name }}_output out;
    int j;
    state->inputs[0] = first;
    state->inputs[1] = second;
    state->moved[0] = moved1;
    state->moved[1] = moved2;
    for (j = 0; j < {{ upper }}_MODES; j++) {
        const {{ name }}_turn *turn = &plant->modes[j];
        {{ name }}_real *place = state->modes[j];
        const {{ name }}_real position = place[0], pace = place[1];
        const {{ name }}_real line = turn->line[0] * moved1 + turn->line[1] * moved2;
        const {{ name }}_real rate = pace - line;
        const {{ name }}_real gained = turn->rest[0] * position + turn->rest[1] * rate;
        const {{ name }}_real faded = turn->rest[2] * rate - turn->rest[1] * position;
        place[0] = (turn->quarters[0] * position + turn->quarters[1] * rate) + gained;
        place[1] = (turn->quarters[0] * pace - turn->quarters[1] * position) + (faded + turn->dragged * line);
        input = input + turn->weights[0] * place[0];
        output = output + turn->weights[1] * place[0];
    }
{%- if dashpots %}
    if (plant->has_dashpots) {
        for (j = 0; j < {{ upper }}_MODES; j++) {
            const {{ name }}_turn *turn = &plant->modes[j];
            const {{ name }}_real rate = state->modes[j][1] - (turn->line[0] * moved1 + turn->line[1] * moved2);
            input = input + turn->rates[0] * rate;
            output = output + turn->rates[1] * rate;
        }
    }
{%- endif %}
{%- if is_single %}
    state->steps++;
    if (state->steps >= {{ mends }}) {
        /* What the rounding of coefficients has added up to is made up for. */
        state->steps = 0;
        for (j = 0; j < {{ upper }}_MODES; j++) {
            const {{ name }}_turn *turn = &plant->modes[j];
            {{ name }}_real *place = state->modes[j];
            const {{ name }}_real position = place[0], rate = place[1] - (turn->line[0] * moved1 + turn->line[1] * moved2);
            place[0] = place[0] + (turn->mend[0][0] * position + turn->mend[0][1] * rate);
            place[1] = place[1] + (turn->mend[1][0] * position + turn->mend[1][1] * rate);
        }
    }
{%- endif %}
{%- if is_position %}
    still = plant->preload + plant->stiffness * (second - first);
    out.deflection = still;
    out.end = second;
{%- else %}
    for (j = 0; j < {{ upper }}_MODES; j++) {
        swing = swing + plant->modes[j].end * state->modes[j][0];
    }
    still = plant->preload + second;
    out.deflection = still + plant->stiffness * swing;
    out.end = first + plant->compliance * second + swing;
{%- endif %}
    out.input = still + input;
    out.output = still + output;
    return out;
}
{%- include "windings" %}
{%- include "readout" %}

#endif
