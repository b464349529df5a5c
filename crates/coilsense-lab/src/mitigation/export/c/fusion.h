typedef struct {
    {{ name }}_real bias;
    {{ name }}_ring fast;
} {{ name }}_state;

/* As if both forces had been so for ever. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real fast, {{ name }}_real slow)
{
    state->bias = slow - fast;
    {{ name }}_fill(&state->fast, fast);
}

/* slow is NULL where there is no new one. */
static inline {{ name }}_real {{ name }}_step({{ name }}_state *state, {{ name }}_real fast, const {{ name }}_real *slow)
{
    {{ name }}_push(&state->fast, fast);
    if (slow != NULL) {
        const {{ name }}_real then = {{ name }}_delayed(&state->fast, {{ s.lateness.whole }}u, {{ s.lateness.fraction | real }});
        state->bias = state->bias + {{ s.gain | real }} * (*slow - then - state->bias);
    }
    return fast + state->bias;
}
