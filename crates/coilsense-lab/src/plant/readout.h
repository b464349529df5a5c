{%- if sensors %}

/* What instruments make of these: low-pass, delay, mean, samples of their own, noise, resolution; in steps of {{ upper }}_READ_STEP [s]. A state begins as if
 * what is there had been so for ever, with its first sample at time zero; the same seed gives the same noise.
 *
 *   static {{ name }}_sensors sensors;
 *   {{ name }}_sensors_settle(&sensors, &plant, &state, out, 1);    once, with the output of the first step or of a step at rest
 *   each step: {{ name }}_readings read = {{ name }}_read(&sensors, &plant, &state, out); */
#define {{ upper }}_SENSORS {{ sensors.each | length }}
#define {{ upper }}_POLES {{ sensors.poles }}
#define {{ upper }}_SLOTS {{ sensors.slots }}

/* Poles of the low-pass: what a step leaves of how far each is behind, what the input's growth adds, its share; the delay in whole steps and the rest;
 * the mean's whole steps and weights (where means is set); samples a step, 0 for every step; rms of noise and step, 0 for none. */
typedef struct {
    int poles;
    {{ name }}_real decay[{{ upper }}_POLES][2], drag[{{ upper }}_POLES][2], share[{{ upper }}_POLES][2];
    int late;
    {{ name }}_real late_part;
    int means, whole;
    {{ name }}_real weights[3];
    double samples;
    {{ name }}_real noise, resolution;
} {{ name }}_instrument;

static const {{ name }}_instrument {{ name }}_instruments[{{ upper }}_SENSORS] = {
{%- for sensor in sensors.each %}
    /* {{ sensor.title }} */
    { {{ sensor.initializer }} },
{%- endfor %}
};

typedef struct {
    {{ name }}_real behind[{{ upper }}_POLES][2], before, late[{{ upper }}_SLOTS], meant[{{ upper }}_SLOTS], sum, fresh, last, held;
    int newest, age;
    uint64_t seed, steps, taken;
} {{ name }}_instrument_state;

typedef struct {
    {{ name }}_instrument_state each[{{ upper }}_SENSORS];
} {{ name }}_sensors;

/* The force that each sensor tells [N]. */
typedef struct {
    {{ name }}_real {% for sensor in sensors.each %}{{ sensor.name }}{% if not loop.last %}, {% endif %}{% endfor %};
} {{ name }}_readings;

static inline double {{ name }}_natural_logarithm(double x)
{
    static const double series[11] = {
        1.0 / 3.0, 1.0 / 5.0, 1.0 / 7.0, 1.0 / 9.0, 1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0, 1.0 / 17.0, 1.0 / 19.0, 1.0 / 21.0, 1.0 / 23.0
    };
    double rest = x, count = 0.0, z, square, of_rest;
    while (rest >= 1.4142135623730951) {
        rest *= 0.5;
        count += 1.0;
    }
    while (rest < 0.7071067811865476) {
        rest *= 2.0;
        count -= 1.0;
    }
    z = (rest - 1.0) / (rest + 1.0);
    square = z * z;
    of_rest = 2.0 * (z + z * (square * {{ name }}_polynomial(series, 11, square)));
    return count * 6.931471803691238e-1 + (count * 1.9082149292705877e-10 + of_rest);
}

static inline uint64_t {{ name }}_mixed(uint64_t place)
{
    const uint64_t once = (place ^ (place >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    const uint64_t twice = (once ^ (once >> 27)) * UINT64_C(0x94D049BB133111EB);
    return twice ^ (twice >> 31);
}

/* A normal number by seed and count: Box and Muller, SplitMix64. */
static inline double {{ name }}_normal(uint64_t seed, uint64_t count)
{
    const uint64_t stride = UINT64_C(0x9E3779B97F4A7C15);
    const uint64_t place = {{ name }}_mixed(seed + stride) + count * 2 * stride;
    const double u = ((double)({{ name }}_mixed(place) >> 11) + 1.0) * 1.1102230246251565e-16;
    const double angle = (double)({{ name }}_mixed(place + stride) >> 11) * (1.1102230246251565e-16 * 6.283185307179586);
    const unsigned long whole = (unsigned long)(angle * 0.6366197723675814 + 0.5);
    const double turns = (double)whole;
    double sine, dip, cosine, square;
    {{ name }}_sine_and_cosine_less_one(
        ((angle - turns * 1.5707963267341256) - turns * 6.077100506303966e-11) - turns * 2.0222662487111665e-21, &sine, &dip);
    switch (whole % 4) {
    case 0:
        cosine = 1.0 + dip;
        break;
    case 1:
        cosine = -sine;
        break;
    case 2:
        cosine = -(1.0 + dip);
        break;
    default:
        cosine = sine;
        break;
    }
    square = -2.0 * {{ name }}_natural_logarithm(u);
    return square > 0.0 ? {{ name }}_square_root(square) * cosine : 0.0;
}

static inline void {{ name }}_instrument_settle(int which, {{ name }}_instrument_state *state, {{ name }}_real x, uint64_t seed)
{
    int i;
    for (i = 0; i < {{ upper }}_POLES; i++) {
        state->behind[i][0] = {{ zero }};
        state->behind[i][1] = {{ zero }};
    }
    for (i = 0; i < {{ upper }}_SLOTS; i++) {
        state->late[i] = x;
        state->meant[i] = x;
    }
    state->sum = {{ zero }};
    for (i = 0; i < {{ name }}_instruments[which].whole; i++) {
        state->sum = state->sum + x;
    }
    state->before = x;
    state->fresh = {{ zero }};
    state->last = x;
    state->held = x;
    state->newest = 0;
    state->age = 0;
    state->seed = seed;
    state->steps = 0;
    state->taken = 0;
}

/* Noise and resolution. */
static inline {{ name }}_real {{ name }}_instrument_reads(const {{ name }}_instrument *of, uint64_t seed, {{ name }}_real value, uint64_t sample)
{
    {{ name }}_real reading = value;
    if (of->noise > {{ zero }}) {
        reading = reading + of->noise * ({{ name }}_real){{ name }}_normal(seed, sample);
    }
    if (of->resolution > {{ zero }}) {
        const {{ name }}_real steps = reading / of->resolution, size = steps < {{ zero }} ? -steps : steps;
        if (size < ({{ name }}_real){{ half_whole }}) {
            reading = of->resolution * ((steps + ({{ name }}_real){{ rounds }}) - ({{ name }}_real){{ rounds }});
        }
    }
    return reading;
}

static inline int {{ name }}_back(int newest, int ago)
{
    return ago <= newest ? newest - ago : newest + {{ upper }}_SLOTS - ago;
}

/* Takes the quantity at this step and gives the reading. */
static inline {{ name }}_real {{ name }}_instrument_step(int which, {{ name }}_instrument_state *state, {{ name }}_real x)
{
    const {{ name }}_instrument *of = &{{ name }}_instruments[which];
    const {{ name }}_real gain = x - state->before;
    const uint64_t steps = state->steps;
    {{ name }}_real passed = x, near, meant;
    int i;
    state->before = x;
    for (i = 0; i < of->poles; i++) {
        const {{ name }}_real re = state->behind[i][0], im = state->behind[i][1];
        state->behind[i][0] = (of->decay[i][0] * re - of->decay[i][1] * im) - gain * of->drag[i][0];
        state->behind[i][1] = (of->decay[i][0] * im + of->decay[i][1] * re) - gain * of->drag[i][1];
        passed = passed + (of->share[i][0] * state->behind[i][0] - of->share[i][1] * state->behind[i][1]);
    }
    state->newest = state->newest + 1 < {{ upper }}_SLOTS ? state->newest + 1 : 0;
    state->late[state->newest] = passed;
    near = state->late[{{ name }}_back(state->newest, of->late)];
    meant = near + of->late_part * (state->late[{{ name }}_back(state->newest, of->late + 1)] - near);
    state->meant[state->newest] = meant;
    if (of->means) {
        const {{ name }}_real now = meant, far = state->meant[{{ name }}_back(state->newest, of->whole)];
        meant = of->weights[0] * far + of->weights[1] * state->meant[{{ name }}_back(state->newest, of->whole + 1)];
        if (of->whole > 0) {
            state->sum = state->sum + (now - far);
            state->fresh = state->fresh + now;
            state->age++;
            if (state->age >= of->whole) {
                state->sum = state->fresh;
                state->fresh = {{ zero }};
                state->age = 0;
            }
            meant = meant + of->weights[2] * (state->sum + ({{ name }}_real)0.5 * (far - now));
        }
    }
    state->steps++;
    if (of->samples > 0.0) {
        const double now = (double)steps * of->samples;
        const uint64_t sample = (uint64_t)(now + 1e-6);
        if (steps == 0 || sample != state->taken) {
            const double since = (now - (double)sample) / of->samples;
            const {{ name }}_real ago = ({{ name }}_real)(since > 0.0 ? since : 0.0);
            state->taken = sample;
            state->held = {{ name }}_instrument_reads(of, state->seed, meant + ago * (state->last - meant), sample);
        }
    } else {
        state->held = {{ name }}_instrument_reads(of, state->seed, meant, steps);
    }
    state->last = meant;
    return state->held;
}

/* What a sensor looks at: a force [N], the distance between the ends [m], or L [H]. */
static inline {{ name }}_real {{ name }}_seen(int which, const {{ name }}_plant *plant, const {{ name }}_state *state, {{ name }}_output out)
{
    switch (which) {
{%- for sensor in sensors.each %}
    case {{ loop.index0 }}:
        return {{ sensor.seen }};
{%- endfor %}
    default:
        (void)plant;
        (void)state;
        (void)out;
        return {{ zero }};
    }
}

static inline void {{ name }}_sensors_settle(
    {{ name }}_sensors *sensors, const {{ name }}_plant *plant, const {{ name }}_state *state, {{ name }}_output out, uint64_t seed)
{
    int i;
    for (i = 0; i < {{ upper }}_SENSORS; i++) {
        {{ name }}_instrument_settle(i, &sensors->each[i], {{ name }}_seen(i, plant, state, out), seed + (uint64_t)i);
    }
}

static inline {{ name }}_readings {{ name }}_read(
    {{ name }}_sensors *sensors, const {{ name }}_plant *plant, const {{ name }}_state *state, {{ name }}_output out)
{
    {{ name }}_real read[{{ upper }}_SENSORS];
    {{ name }}_readings forces;
    int i;
    for (i = 0; i < {{ upper }}_SENSORS; i++) {
        read[i] = {{ name }}_instrument_step(i, &sensors->each[i], {{ name }}_seen(i, plant, state, out));
    }
{%- for sensor in sensors.each %}
    forces.{{ sensor.name }} = {{ sensor.force }};
{%- endfor %}
    return forces;
}
{%- endif %}
