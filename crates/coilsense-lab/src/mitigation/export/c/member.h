#define {{ upper }}_MODES {{ s.members[0].modes | length }}
#define {{ upper }}_MEMBERS {{ s.members | length }}

/* One mode over one sample, in newtons at end 1. */
typedef struct {
    {{ name }}_real turn[2][2], kick[2], input, output, gain[2];
} {{ name }}_mode;

typedef struct {
    {{ name }}_real stiffness, rest_length, rate, bias_gain;
    {{ name }}_mode modes[{{ upper }}_MODES];
} {{ name }}_member;

static const {{ name }}_member {{ name }}_members[{{ upper }}_MEMBERS] = {
{%- for member in s.members %}
    { {{ member.stiffness | real }}, {{ member.rest_length | real }}, {{ member.rate | real }}, {{ member.bias_gain | real }}, {
{%- for mode in member.modes %}
        { { { {{ mode.turn[0][0] | real }}, {{ mode.turn[0][1] | real }} }, { {{ mode.turn[1][0] | real }}, {{ mode.turn[1][1] | real }} } },
          { {{ mode.kick[0] | real }}, {{ mode.kick[1] | real }} }, {{ mode.input | real }}, {{ mode.output | real }},
          { {{ mode.gain[0] | real }}, {{ mode.gain[1] | real }} } },
{%- endfor %}
    } },
{%- endfor %}
};

typedef struct {
    {{ name }}_real modes[{{ upper }}_MODES][2];
    {{ name }}_real bias, ends[2], velocities[2];
} {{ name }}_member_state;

/* F_i cleaned of noise, F_o, and what was measured less what was predicted, all in N. */
typedef struct {
    {{ name }}_real input, output, surprise;
} {{ name }}_estimate;

static inline void {{ name }}_member_settle(const {{ name }}_member *member, {{ name }}_member_state *state,
    {{ name }}_real force, {{ name }}_real u1, {{ name }}_real u2)
{
    int j;
    for (j = 0; j < {{ upper }}_MODES; j++) {
        state->modes[j][0] = {{ 0.0 | real }};
        state->modes[j][1] = {{ 0.0 | real }};
    }
    state->bias = force - member->stiffness * (u2 - u1 - member->rest_length);
    state->ends[0] = u1;
    state->ends[1] = u2;
    state->velocities[0] = {{ 0.0 | real }};
    state->velocities[1] = {{ 0.0 | real }};
}

static inline {{ name }}_estimate {{ name }}_member_step(const {{ name }}_member *member, {{ name }}_member_state *state,
    {{ name }}_real force, {{ name }}_real u1, {{ name }}_real u2)
{
    const {{ name }}_real v1 = member->rate * (u1 - state->ends[0]), v2 = member->rate * (u2 - state->ends[1]);
    const {{ name }}_real jump1 = v1 - state->velocities[0], jump2 = v2 - state->velocities[1];
    {{ name }}_real still = member->stiffness * (u2 - u1 - member->rest_length) + state->bias;
    {{ name }}_real predicted = still;
    {{ name }}_estimate estimate;
    int j;
    state->ends[0] = u1;
    state->ends[1] = u2;
    state->velocities[0] = v1;
    state->velocities[1] = v2;
    for (j = 0; j < {{ upper }}_MODES; j++) {
        const {{ name }}_mode *mode = &member->modes[j];
        {{ name }}_real *q = state->modes[j];
        const {{ name }}_real position = q[0], swing = q[1] + mode->kick[0] * jump1 + mode->kick[1] * jump2;
        q[0] = mode->turn[0][0] * position + mode->turn[0][1] * swing;
        q[1] = mode->turn[1][0] * position + mode->turn[1][1] * swing;
        predicted = predicted + mode->input * q[0];
    }
    estimate.surprise = force - predicted;
    state->bias = state->bias + member->bias_gain * estimate.surprise;
    still = still + member->bias_gain * estimate.surprise;
    estimate.input = still;
    estimate.output = still;
    for (j = 0; j < {{ upper }}_MODES; j++) {
        const {{ name }}_mode *mode = &member->modes[j];
        {{ name }}_real *q = state->modes[j];
        q[0] = q[0] + mode->gain[0] * estimate.surprise;
        q[1] = q[1] + mode->gain[1] * estimate.surprise;
        estimate.input = estimate.input + mode->input * q[0];
        estimate.output = estimate.output + mode->output * q[0];
    }
    return estimate;
}
