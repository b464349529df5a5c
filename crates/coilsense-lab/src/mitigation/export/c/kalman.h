{% include "member" %}

typedef {{ name }}_member_state {{ name }}_state;

/* A spring at rest on which F_i, u1 and u2 are measured. */
static inline void {{ name }}_settle({{ name }}_state *state, {{ name }}_real force, {{ name }}_real u1, {{ name }}_real u2)
{
    {{ name }}_member_settle(&{{ name }}_members[0], state, force, u1, u2);
}

static inline {{ name }}_estimate {{ name }}_step({{ name }}_state *state, {{ name }}_real force, {{ name }}_real u1, {{ name }}_real u2)
{
    return {{ name }}_member_step(&{{ name }}_members[0], state, force, u1, u2);
}
