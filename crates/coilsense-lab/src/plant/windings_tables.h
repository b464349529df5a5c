{%- if windings or coil or sensors %}

/* The ends' distance where inputs are zero [m]. */
#define {{ upper }}_MEAN_LENGTH {{ mean_length }}
{%- endif %}
{%- if windings %}

/* Which share of the ends' distance is between neighbouring windings of a spring that moves slowly; at which
 * distance, centre to centre, windings touch [m]; how much each distance grows per mode. */
#define {{ upper }}_PITCH_SHARE {{ windings.share }}
#define {{ upper }}_CONTACT_PITCH {{ windings.contact_pitch }}
#define {{ upper }}_PITCHES {{ windings.gaps | length }}
static const {{ name }}_real {{ name }}_pitches[{{ upper }}_PITCHES][{{ upper }}_MODES] = {
{%- for row in windings.gaps %}
    { {{ row | join(', ') }} },
{%- endfor %}
};
{%- endif %}
{%- if coil %}

/* The coil: L to second order about windings evenly spaced, for ends from {{ coil.shortest }} to {{ coil.longest }} m apart; polynomials in the mean
 * pitch, by how many turns two are apart. 1/l = ALPHA L + BETA is the meter's calibration, by Maxwell's sum of wire that is not magnetic. */
#define {{ upper }}_WINDINGS {{ coil.windings }}
#define {{ upper }}_ALPHA {{ coil.alpha }}
#define {{ upper }}_BETA {{ coil.beta }}
#define {{ upper }}_GAPS {{ coil.gaps | length }}
#define {{ upper }}_TERMS {{ coil.inductance | length }}
static const {{ name }}_real {{ name }}_even_inductance[{{ upper }}_TERMS] = {
    {{ coil.inductance | join(', ') }}
};
{%- for part, table in [("slopes", coil.slopes), ("curvatures", coil.curvatures), ("remainders", coil.remainders)] %}
static const {{ name }}_real {{ name }}_{{ part }}[{{ upper }}_GAPS][{{ upper }}_TERMS] = {
{%- for row in table %}
    { {{ row | join(', ') }} },
{%- endfor %}
};
{%- endfor %}
static const {{ name }}_real {{ name }}_gaps[{{ upper }}_GAPS][{{ upper }}_MODES] = {
{%- for row in coil.gaps %}
    { {{ row | join(', ') }} },
{%- endfor %}
};
{%- endif %}
{%- if sensors %}

/* In which steps instruments are read [s]. */
#define {{ upper }}_READ_STEP {{ sensors.step }}
{%- endif %}
