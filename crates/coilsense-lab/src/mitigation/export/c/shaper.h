#define {{ upper }}_IMPULSES {{ s.impulses | length }}

typedef struct {
    {{ name }}_real amplitude;
    size_t whole;
    {{ name }}_real fraction;
} {{ name }}_impulse;

static const {{ name }}_impulse {{ name }}_impulses[{{ upper }}_IMPULSES] = {
{%- for impulse in s.impulses %}
    { {{ impulse.amplitude | real }}, {{ impulse.delay.whole }}u, {{ impulse.delay.fraction | real }} },
{%- endfor %}
};

typedef struct {
    {{ name }}_ring ring;
} {{ name }}_state;

/* As if the command had been x for ever. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real x)
{
    {{ name }}_fill(&state->ring, x);
}

static inline {{ name }}_real {{ name }}_step({{ name }}_state *state, {{ name }}_real x)
{
    {{ name }}_real sum = {{ 0.0 | real }};
    int i;
    {{ name }}_push(&state->ring, x);
    for (i = 0; i < {{ upper }}_IMPULSES; i++) {
        const {{ name }}_impulse *impulse = &{{ name }}_impulses[i];
        sum = sum + impulse->amplitude * {{ name }}_delayed(&state->ring, impulse->whole, impulse->fraction);
    }
    return sum;
}
