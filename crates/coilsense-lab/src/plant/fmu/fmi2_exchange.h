/* The functions of FMI 2.0 for model exchange alone. No event ever happens: a spring is linear.
 * Next door: all the others (fmi2.c, of which this is a part), the equations (exchange.h). */

typedef struct {
    fmi2Boolean newDiscreteStatesNeeded, terminateSimulation, nominalsOfContinuousStatesChanged, valuesOfContinuousStatesChanged,
        nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;

/* Goes from one stage of model exchange to another, or stays there. */
static fmi2Status moves(instance *me, int from, int to, const char *otherwise)
{
    if (me == NULL || !me->unit.now.is_solved || me->unit.now.stage != from) {
        return out_of_turn(me, otherwise);
    }
    me->unit.now.stage = to;
    return fmi2OK;
}

static int is_under_way(const instance *me)
{
    return me != NULL && me->unit.now.is_solved && (me->unit.now.stage == UNIT_EVENTS || me->unit.now.stage == UNIT_CONTINUOUS);
}

F(fmi2EnterEventMode)(fmi2Component c)
{
    return moves(c, UNIT_CONTINUOUS, UNIT_EVENTS, "fmi2EnterEventMode is of model exchange and comes in continuous-time mode");
}

F(fmi2EnterContinuousTimeMode)(fmi2Component c)
{
    return moves(c, UNIT_EVENTS, UNIT_CONTINUOUS, "fmi2EnterContinuousTimeMode is of model exchange and comes in event mode");
}

F(fmi2NewDiscreteStates)(fmi2Component c, fmi2EventInfo *info)
{
    if (info != NULL) {
        memset(info, 0, sizeof *info);
    }
    return moves(c, UNIT_EVENTS, UNIT_EVENTS, "fmi2NewDiscreteStates is of model exchange and comes in event mode");
}

F(fmi2CompletedIntegratorStep)(fmi2Component c, fmi2Boolean is_final, fmi2Boolean *event, fmi2Boolean *terminates)
{
    (void)is_final;
    if (event != NULL) {
        *event = 0;
    }
    if (terminates != NULL) {
        *terminates = 0;
    }
    return moves(c, UNIT_CONTINUOUS, UNIT_CONTINUOUS, "fmi2CompletedIntegratorStep is of model exchange and comes in continuous-time mode");
}

F(fmi2SetTime)(fmi2Component c, fmi2Real time)
{
    instance *me = c;
    if (!is_under_way(me) || !unit_is_finite(time)) {
        return out_of_turn(me, "fmi2SetTime is of model exchange, comes after initialization and takes a finite time");
    }
    me->unit.now.time = time;
    return fmi2OK;
}

F(fmi2SetContinuousStates)(fmi2Component c, const fmi2Real states[], size_t count)
{
    instance *me = c;
    if (!is_under_way(me)) {
        return out_of_turn(me, "fmi2SetContinuousStates is of model exchange and comes after initialization");
    }
    return status(me, exchange_put(&me->unit, states, count));
}

F(fmi2GetContinuousStates)(fmi2Component c, fmi2Real states[], size_t count)
{
    instance *me = c;
    return me != NULL ? status(me, exchange_read(&me->exchange, &me->unit, EXCHANGE_STATE, states, count)) : fmi2Error;
}

F(fmi2GetDerivatives)(fmi2Component c, fmi2Real derivatives[], size_t count)
{
    instance *me = c;
    return me != NULL ? status(me, exchange_read(&me->exchange, &me->unit, EXCHANGE_DERIVATIVE, derivatives, count)) : fmi2Error;
}

F(fmi2GetNominalsOfContinuousStates)(fmi2Component c, fmi2Real nominals[], size_t count)
{
    if (c == NULL || count != EXCHANGE_STATES) {
        return out_of_turn(c, "the states are two for each mode");
    }
    memcpy(nominals, exchange_nominals, sizeof exchange_nominals);
    return fmi2OK;
}

F(fmi2GetEventIndicators)(fmi2Component c, fmi2Real indicators[], size_t count)
{
    (void)indicators;
    return c != NULL && count == 0 ? fmi2OK : out_of_turn(c, "there are no event indicators");
}
