typedef struct {
    {{ name }}_ring rightward, leftward;
    {{ name }}_real ends[2];
    {{ name }}_real offset;
} {{ name }}_state;

static inline {{ name }}_real {{ name }}_static_force({{ name }}_real u1, {{ name }}_real u2)
{
    return {{ s.stiffness | real }} * (u2 - u1 - {{ s.rest_length | real }});
}

/* A spring at rest on which F_i, u1 and u2 are measured. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real force, {{ name }}_real u1, {{ name }}_real u2)
{
    {{ name }}_fill(&state->rightward, force);
    {{ name }}_fill(&state->leftward, force);
    state->ends[0] = u1;
    state->ends[1] = u2;
    state->offset = force - {{ name }}_static_force(u1, u2);
}

/* Takes F_i, u1 and u2, gives F_o. */
static inline {{ name }}_real {{ name }}_step({{ name }}_state *state, {{ name }}_real measured, {{ name }}_real u1, {{ name }}_real u2)
{
    const {{ name }}_real push1 = {{ s.impedance | real }} * ({{ s.rate | real }} * (u1 - state->ends[0]));
    const {{ name }}_real push2 = {{ s.impedance | real }} * ({{ s.rate | real }} * (u2 - state->ends[1]));
    const {{ name }}_real resting = {{ name }}_static_force(u1, u2) + state->offset;
    const size_t whole = {{ s.transit.whole }}u - 1u;
    const {{ name }}_real fraction = {{ s.transit.fraction | real }};
    const {{ name }}_real predicted = {{ name }}_delayed(&state->leftward, whole, fraction) - push1;
    const {{ name }}_real force = predicted + {{ s.gain | real }} * (measured - predicted);
    const {{ name }}_real output = {{ name }}_delayed(&state->rightward, whole, fraction) + push2;
    const {{ name }}_real right = force - push1, left = output + push2;
    state->ends[0] = u1;
    state->ends[1] = u2;
    {{ name }}_push(&state->rightward, right - {{ s.loss | real }} * (right - resting));
    {{ name }}_push(&state->leftward, left - {{ s.loss | real }} * (left - resting));
    return output;
}
