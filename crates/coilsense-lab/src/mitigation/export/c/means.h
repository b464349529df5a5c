{% include "mean" %}

typedef struct {
    {{ name }}_mean_state means[{{ upper }}_MEANS];
} {{ name }}_state;

/* As if the input had been x for ever. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real x)
{
    int i;
    for (i = 0; i < {{ upper }}_MEANS; i++) {
        {{ name }}_mean_settle(&{{ name }}_means[i], &state->means[i], x);
    }
}

static inline {{ name }}_real {{ name }}_step({{ name }}_state *state, {{ name }}_real x)
{
    int i;
    for (i = 0; i < {{ upper }}_MEANS; i++) {
        x = {{ name }}_means[i].scale * {{ name }}_weighted_sum(&{{ name }}_means[i], &state->means[i], x);
    }
    return x;
}
