/* Newest sample first. */
static const {{ name }}_real {{ name }}_taps[{{ upper }}_RING] = {
{%- for tap in s.taps %}
    {{ tap | real }},
{%- endfor %}
};

typedef struct {
    {{ name }}_ring ring;
} {{ name }}_state;

/* As if the input had been x for ever. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real x)
{
    {{ name }}_fill(&state->ring, x);
}

static inline {{ name }}_real {{ name }}_step({{ name }}_state *state, {{ name }}_real x)
{
    {{ name }}_real sum = {{ 0.0 | real }};
    size_t i;
    {{ name }}_push(&state->ring, x);
    for (i = 0; i < {{ upper }}_RING; i++) {
        sum = sum + {{ name }}_taps[i] * {{ name }}_back(&state->ring, i);
    }
    return sum;
}
