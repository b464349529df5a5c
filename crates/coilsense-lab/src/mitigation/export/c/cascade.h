#define {{ upper }}_SECTIONS {{ s.sections | length }}

/* b0, b1, b2, a1, a2 of each section. */
static const {{ name }}_real {{ name }}_sections[{{ upper }}_SECTIONS][5] = {
{%- for section in s.sections %}
    { {{ section.b0 | real }}, {{ section.b1 | real }}, {{ section.b2 | real }}, {{ section.a1 | real }}, {{ section.a2 | real }} },
{%- endfor %}
};

typedef struct {
    {{ name }}_real memory[{{ upper }}_SECTIONS][2];
} {{ name }}_state;

/* As if the input had been x for ever. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real x)
{
    int i;
    for (i = 0; i < {{ upper }}_SECTIONS; i++) {
        const {{ name }}_real *c = {{ name }}_sections[i];
        const {{ name }}_real y = (c[0] + c[1] + c[2]) / ({{ 1.0 | real }} + c[3] + c[4]) * x;
        const {{ name }}_real second = c[2] * x - c[4] * y;
        state->memory[i][0] = c[1] * x - c[3] * y + second;
        state->memory[i][1] = second;
        x = y;
    }
}

static inline {{ name }}_real {{ name }}_step({{ name }}_state *state, {{ name }}_real x)
{
    int i;
    for (i = 0; i < {{ upper }}_SECTIONS; i++) {
        const {{ name }}_real *c = {{ name }}_sections[i];
        {{ name }}_real *memory = state->memory[i];
        const {{ name }}_real y = c[0] * x + memory[0];
        memory[0] = c[1] * x - c[3] * y + memory[1];
        memory[1] = c[2] * x - c[4] * y;
        x = y;
    }
    return x;
}
