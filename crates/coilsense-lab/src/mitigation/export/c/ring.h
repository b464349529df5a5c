/* The last samples. */
#define {{ upper }}_RING {{ ring }}u

typedef struct {
    {{ name }}_real samples[{{ upper }}_RING];
    size_t newest;
} {{ name }}_ring;

static inline void {{ name }}_fill({{ name }}_ring *ring, {{ name }}_real x)
{
    size_t i;
    for (i = 0; i < {{ upper }}_RING; i++) {
        ring->samples[i] = x;
    }
    ring->newest = 0;
}

static inline void {{ name }}_push({{ name }}_ring *ring, {{ name }}_real x)
{
    ring->newest = ring->newest + 1 < {{ upper }}_RING ? ring->newest + 1 : 0;
    ring->samples[ring->newest] = x;
}

static inline {{ name }}_real {{ name }}_back(const {{ name }}_ring *ring, size_t ago)
{
    if (ago > {{ upper }}_RING - 1) {
        ago = {{ upper }}_RING - 1;
    }
    return ring->samples[ago <= ring->newest ? ring->newest - ago : ring->newest + {{ upper }}_RING - ago];
}

static inline {{ name }}_real {{ name }}_delayed(const {{ name }}_ring *ring, size_t whole, {{ name }}_real fraction)
{
    const {{ name }}_real near_one = {{ name }}_back(ring, whole);
    return near_one + fraction * ({{ name }}_back(ring, whole + 1) - near_one);
}
