{% include "member" %}

typedef struct {
    {{ name }}_member_state members[{{ upper }}_MEMBERS];
    {{ name }}_real scores[{{ upper }}_MEMBERS];
} {{ name }}_state;

/* A spring at rest on which F_i, u1 and u2 are measured. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real force, {{ name }}_real u1, {{ name }}_real u2)
{
    int i;
    for (i = 0; i < {{ upper }}_MEMBERS; i++) {
        {{ name }}_member_settle(&{{ name }}_members[i], &state->members[i], force, u1, u2);
        state->scores[i] = {{ 0.0 | real }};
    }
}

/* Near exp(-x). */
static inline {{ name }}_real {{ name }}_fading({{ name }}_real x)
{
    {{ name }}_real power = {{ 1.0 | real }} - x * {{ 0.00390625 | real }};
    int i;
    if (!(power > {{ 0.0 | real }})) {
        return {{ 0.0 | real }};
    }
    for (i = 0; i < 8; i++) {
        power = power * power;
    }
    return power;
}

static inline {{ name }}_estimate {{ name }}_step({{ name }}_state *state, {{ name }}_real force, {{ name }}_real u1, {{ name }}_real u2)
{
    {{ name }}_estimate estimates[{{ upper }}_MEMBERS], sum;
    {{ name }}_real least = {{ 0.0 | real }}, total = {{ 0.0 | real }};
    int i;
    for (i = 0; i < {{ upper }}_MEMBERS; i++) {
        {{ name }}_real surprise;
        estimates[i] = {{ name }}_member_step(&{{ name }}_members[i], &state->members[i], force, u1, u2);
        surprise = estimates[i].surprise;
        state->scores[i] = state->scores[i] + {{ s.forgetting | real }} * (surprise * surprise - state->scores[i]);
        least = i > 0 && least < state->scores[i] ? least : state->scores[i];
    }
    sum.input = sum.output = sum.surprise = {{ 0.0 | real }};
    for (i = 0; i < {{ upper }}_MEMBERS; i++) {
        const {{ name }}_real weight = {{ name }}_fading({{ s.sharpness | real }} * (state->scores[i] - least));
        total = total + weight;
        sum.input = sum.input + weight * estimates[i].input;
        sum.output = sum.output + weight * estimates[i].output;
        sum.surprise = sum.surprise + weight * estimates[i].surprise;
    }
    sum.input = sum.input / total;
    sum.output = sum.output / total;
    sum.surprise = sum.surprise / total;
    return sum;
}
