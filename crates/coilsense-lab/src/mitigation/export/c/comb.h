{% include "mean" %}

typedef struct {
    {{ name }}_mean_state inputs;
    {{ name }}_real last_sum;
    {{ name }}_ring outputs;
} {{ name }}_state;

/* As if the input had been x for ever. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real x)
{
    {{ name }}_mean_settle(&{{ name }}_means[0], &state->inputs, x);
    state->last_sum = {{ name }}_weighted_sum(&{{ name }}_means[0], &state->inputs, x);
    {{ name }}_fill(&state->outputs, x);
}

static inline {{ name }}_real {{ name }}_step({{ name }}_state *state, {{ name }}_real x)
{
    const {{ name }}_mean *period = &{{ name }}_means[0];
    const {{ name }}_real sum = {{ name }}_weighted_sum(period, &state->inputs, x);
    const {{ name }}_real y = period->scale * (sum - {{ s.radius | real }} * state->last_sum)
        + {{ s.feedback | real }} * {{ name }}_delayed(&state->outputs, period->whole - 1, period->fraction);
    state->last_sum = sum;
    {{ name }}_push(&state->outputs, y);
    return y;
}
