/* {{ title }}
 * C99, no library; SI units, force tension-positive. {{ name }}_settle() once, then {{ name }}_step() once per sample.
 * Without contraction of products and sums (-std=c99 or -ffp-contract=off) its numbers equal those of Rust to the bit. */
#ifndef {{ upper }}_H
#define {{ upper }}_H

#include <stddef.h>

typedef {{ real }} {{ name }}_real;
{%- if ring %}

{% include "ring" %}
{%- endif %}

{% include "body" %}

#endif
