{%- if windings or coil or sensors %}

/* How much further apart the ends are than where inputs are zero. */
static inline {{ name }}_real {{ name }}_longer(const {{ name }}_plant *plant, const {{ name }}_state *state)
{
{%- if is_position %}
    (void)plant;
    return state->inputs[1] - state->inputs[0];
{%- else %}
    {{ name }}_real swing = {{ zero }};
    int j;
    for (j = 0; j < {{ upper }}_MODES; j++) {
        swing = swing + plant->modes[j].end * state->modes[j][0];
    }
    return (state->inputs[0] + plant->compliance * state->inputs[1] + swing) - state->inputs[0];
{%- endif %}
}

static inline {{ name }}_real {{ name }}_sum(const {{ name }}_state *state, const {{ name }}_real *weights)
{
    {{ name }}_real sum = {{ zero }};
    int j;
    for (j = 0; j < {{ upper }}_MODES; j++) {
        sum = sum + weights[j] * state->modes[j][0];
    }
    return sum;
}
{%- endif %}
{%- if windings %}

/* The smallest distance between neighbouring windings [m]; below {{ upper }}_CONTACT_PITCH they would have met, and this is no longer the spring. */
static inline {{ name }}_real {{ name }}_closest_pitch(const {{ name }}_plant *plant, const {{ name }}_state *state)
{
    const {{ name }}_real even = ({{ name }}_real){{ upper }}_PITCH_SHARE * (({{ name }}_real){{ upper }}_MEAN_LENGTH + {{ name }}_longer(plant, state));
    {{ name }}_real least = {{ largest }};
    int i;
    for (i = 0; i < {{ upper }}_PITCHES; i++) {
        const {{ name }}_real grown = {{ name }}_sum(state, {{ name }}_pitches[i]);
        if (grown < least) {
            least = grown;
        }
    }
    return even + least;
}
{%- endif %}
{%- if coil %}

static inline {{ name }}_real {{ name }}_by_pitch(const {{ name }}_real *coefficients, {{ name }}_real z)
{
    {{ name }}_real value = {{ zero }};
    int i;
    for (i = {{ upper }}_TERMS - 1; i >= 0; i--) {
        value = value * z + coefficients[i];
    }
    return value;
}

/* L [H] and how far it may be from Maxwell's sum over these windings; F_L [N] and how far it may be off by that. Where nothing is known, beyond the
 * lengths above or where windings would meet, bounds are {{ largest }}. What the calibration is off is F_L's own. */
typedef struct {
    {{ name }}_real inductance, inductance_bound, force, force_bound;
} {{ name }}_reading;

static inline {{ name }}_reading {{ name }}_coil(const {{ name }}_plant *plant, const {{ name }}_state *state)
{
    const {{ name }}_real one = ({{ name }}_real)1.0;
    const {{ name }}_real pitch = (({{ name }}_real){{ upper }}_MEAN_LENGTH + {{ name }}_longer(plant, state)) * ({{ name }}_real)(1.0 / {{ upper }}_WINDINGS);
    const {{ name }}_real z = (pitch - ({{ name }}_real){{ coil.middle }}) * ({{ name }}_real)(1.0 / {{ coil.half }});
    const {{ name }}_real alpha = ({{ name }}_real){{ upper }}_ALPHA, beta = ({{ name }}_real){{ upper }}_BETA;
    {{ name }}_real nearer[{{ upper }}_GAPS], distances[{{ upper }}_GAPS];
    {{ name }}_real largest = {{ zero }}, uneven = {{ zero }}, remainder = {{ zero }}, strain, room, length, steep, share;
    {{ name }}_reading out;
    int i, lag;
    for (i = 0; i < {{ upper }}_GAPS; i++) {
        const {{ name }}_real change = {{ name }}_sum(state, {{ name }}_gaps[i]);
        const {{ name }}_real size = change < {{ zero }} ? -change : change;
        nearer[i] = change;
        distances[i] = {{ zero }};
        largest = size <= largest ? largest : size;
    }
    for (lag = 0; lag < {{ upper }}_GAPS; lag++) {
        {{ name }}_real sum = {{ zero }}, squares = {{ zero }};
        for (i = 0; i + lag < {{ upper }}_GAPS; i++) {
            distances[i] = distances[i] + nearer[i + lag];
            sum = sum + distances[i];
            squares = squares + distances[i] * distances[i];
        }
        uneven = uneven + ({{ name }}_by_pitch({{ name }}_slopes[lag], z) * sum + {{ name }}_by_pitch({{ name }}_curvatures[lag], z) * squares);
        remainder = remainder + {{ name }}_by_pitch({{ name }}_remainders[lag], z) * squares;
    }
    out.inductance = {{ name }}_by_pitch({{ name }}_even_inductance, z) + uneven;
    strain = largest / pitch;
    room = one - strain;
    if (pitch > {{ zero }} && room > {{ zero }} && z <= one && -one <= z) {
        const {{ name }}_real cube = room * room * room;
        out.inductance_bound = strain * remainder / (cube * cube) + ({{ name }}_real)({{ coil.left }} + 64.0 * {{ rounding }}) * out.inductance;
    } else {
        out.inductance_bound = {{ largest }};
    }
    length = one / (alpha * out.inductance + beta);
    out.force = plant->preload + plant->stiffness * (length - ({{ name }}_real){{ upper }}_MEAN_LENGTH);
    steep = alpha < {{ zero }} ? -alpha : alpha;
    share = steep * length * out.inductance_bound;
    room = one - share;
    out.force_bound = room > {{ zero }} ? plant->stiffness * (length * share) / room : {{ largest }};
    return out;
}
{%- endif %}
