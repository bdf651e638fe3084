/* A library that was built with -Ofast must not set the process that loads it to take denormal numbers for zeros. */
#include <float.h>
#include <stdio.h>

#include "motorway.h"

int main(void)
{
    volatile float smallest = FLT_MIN;
    if (!mw_isa() || !(smallest / 2 > 0)) {
        fprintf(stderr, "denormal numbers are lost\n");
        return 1;
    }
    return 0;
}
