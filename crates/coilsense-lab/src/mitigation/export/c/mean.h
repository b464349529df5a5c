#define {{ upper }}_MEANS {{ s.means | length }}

typedef struct {
    size_t whole;
    {{ name }}_real fraction, scale;
} {{ name }}_mean;

static const {{ name }}_mean {{ name }}_means[{{ upper }}_MEANS] = {
{%- for mean in s.means %}
    { {{ mean.whole }}u, {{ mean.fraction | real }}, {{ mean.scale | real }} },
{%- endfor %}
};

typedef struct {
    {{ name }}_ring ring;
    {{ name }}_real sum, fresh;
    size_t age;
} {{ name }}_mean_state;

static inline void {{ name }}_mean_settle(const {{ name }}_mean *mean, {{ name }}_mean_state *state, {{ name }}_real x)
{
    size_t i;
    {{ name }}_fill(&state->ring, x);
    state->sum = {{ 0.0 | real }};
    for (i = 0; i < mean->whole; i++) {
        state->sum = state->sum + x;
    }
    state->fresh = {{ 0.0 | real }};
    state->age = 0;
}

/* The sum over the span, its last sample in part; it begins anew once per span, so that rounding does not pile up. */
static inline {{ name }}_real {{ name }}_weighted_sum(const {{ name }}_mean *mean, {{ name }}_mean_state *state, {{ name }}_real x)
{
    {{ name }}_real leaving;
    {{ name }}_push(&state->ring, x);
    leaving = {{ name }}_back(&state->ring, mean->whole);
    state->sum = state->sum + (x - leaving);
    state->fresh = state->fresh + x;
    state->age++;
    if (state->age >= mean->whole) {
        state->sum = state->fresh;
        state->fresh = {{ 0.0 | real }};
        state->age = 0;
    }
    return state->sum + mean->fraction * leaving;
}
