/* What FMI 3.0 has and a spring in co-simulation has not: dependencies of elements, derivatives, structure, events, clocks, the equations of
 * model exchange. Each is there, as the standard wants it, and says that it is not.
 * Next door: all the rest (fmi3.c, of which this is a part). */

/* The arguments after the instance. */
#define OTHER(name, what, ...)                                                                                                                  \
    F(name)(fmi3Instance c, __VA_ARGS__)                                                                                                        \
    {                                                                                                                                           \
        return refused(c, "there " what);                                                                                                       \
    }
#define OTHER_OF_NONE(name, what)                                                                                                               \
    F(name)(fmi3Instance c)                                                                                                                     \
    {                                                                                                                                           \
        return refused(c, "there " what);                                                                                                       \
    }

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

OTHER(fmi3GetNumberOfVariableDependencies, "are no dependencies of elements", fmi3ValueReference reference, size_t *count)
OTHER(fmi3GetVariableDependencies, "are no dependencies of elements", fmi3ValueReference dependent, size_t elements[],
      fmi3ValueReference independents[], size_t of_independents[], fmi3DependencyKind kinds[], size_t count)
OTHER(fmi3GetDirectionalDerivative, "are no directional derivatives", const fmi3ValueReference unknowns[], size_t unknown,
      const fmi3ValueReference knowns[], size_t known, const fmi3Float64 seed[], size_t seeds, fmi3Float64 moves[], size_t moved)
OTHER(fmi3GetAdjointDerivative, "are no adjoint derivatives", const fmi3ValueReference unknowns[], size_t unknown,
      const fmi3ValueReference knowns[], size_t known, const fmi3Float64 seed[], size_t seeds, fmi3Float64 moves[], size_t moved)
OTHER(fmi3GetOutputDerivatives, "are no derivatives of outputs", const fmi3ValueReference references[], size_t count, const fmi3Int32 orders[],
      fmi3Float64 values[], size_t size)

OTHER_OF_NONE(fmi3EnterConfigurationMode, "is no structure to be configured")
OTHER_OF_NONE(fmi3ExitConfigurationMode, "is no structure to be configured")

OTHER_OF_NONE(fmi3EnterEventMode, "is no event mode")
OTHER_OF_NONE(fmi3EnterStepMode, "is no event mode")
OTHER_OF_NONE(fmi3EvaluateDiscreteStates, "is no event mode")
OTHER(fmi3UpdateDiscreteStates, "is no event mode", fmi3Boolean *again, fmi3Boolean *terminates, fmi3Boolean *nominals, fmi3Boolean *values,
      fmi3Boolean *has_next, fmi3Float64 *next)

OTHER(fmi3GetIntervalDecimal, "are no clocks", const fmi3ValueReference references[], size_t count, fmi3Float64 intervals[],
      fmi3IntervalQualifier qualifiers[])
OTHER(fmi3GetIntervalFraction, "are no clocks", const fmi3ValueReference references[], size_t count, fmi3UInt64 counters[],
      fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
OTHER(fmi3GetShiftDecimal, "are no clocks", const fmi3ValueReference references[], size_t count, fmi3Float64 shifts[])
OTHER(fmi3GetShiftFraction, "are no clocks", const fmi3ValueReference references[], size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[])
OTHER(fmi3SetIntervalDecimal, "are no clocks", const fmi3ValueReference references[], size_t count, const fmi3Float64 intervals[])
OTHER(fmi3SetIntervalFraction, "are no clocks", const fmi3ValueReference references[], size_t count, const fmi3UInt64 counters[],
      const fmi3UInt64 resolutions[])
OTHER(fmi3SetShiftDecimal, "are no clocks", const fmi3ValueReference references[], size_t count, const fmi3Float64 shifts[])
OTHER(fmi3SetShiftFraction, "are no clocks", const fmi3ValueReference references[], size_t count, const fmi3UInt64 counters[],
      const fmi3UInt64 resolutions[])
OTHER(fmi3ActivateModelPartition, "are no clocks", fmi3ValueReference clock, fmi3Float64 time)

OTHER_OF_NONE(fmi3EnterContinuousTimeMode, "is no model exchange")
OTHER(fmi3CompletedIntegratorStep, "is no model exchange", fmi3Boolean is_final, fmi3Boolean *event, fmi3Boolean *terminates)
OTHER(fmi3SetTime, "is no model exchange", fmi3Float64 time)
OTHER(fmi3SetContinuousStates, "is no model exchange", const fmi3Float64 states[], size_t count)
OTHER(fmi3GetContinuousStates, "is no model exchange", fmi3Float64 states[], size_t count)
OTHER(fmi3GetContinuousStateDerivatives, "is no model exchange", fmi3Float64 derivatives[], size_t count)
OTHER(fmi3GetNominalsOfContinuousStates, "is no model exchange", fmi3Float64 nominals[], size_t count)
OTHER(fmi3GetNumberOfContinuousStates, "is no model exchange", size_t *count)
OTHER(fmi3GetEventIndicators, "is no model exchange", fmi3Float64 indicators[], size_t count)
OTHER(fmi3GetNumberOfEventIndicators, "is no model exchange", size_t *count)

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
