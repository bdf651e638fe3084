/* Prints the instruction set in use; or, if MOTORWAY_ISA asks for one that cannot run, what a call then returns, and
 * exits with 1. */
#include <stdio.h>

#include "motorway.h"

int main(void)
{
    mw_motor_f32 motor = {1, 0, 0, 0, 0, 0, 0, 0}, result = {9, 9, 9, 9, 9, 9, 9, 9};
    const mw_status status = mw_reverse_motor_each_f32(mw_motors_f32_aos(&result, sizeof result),
                                                       mw_const_motors_f32_aos(&motor, sizeof motor), 1);
    if (mw_isa()) {
        printf("%s\n", mw_isa());
        return status == MW_OK && result.s == 1 ? 0 : 2;
    }
    printf("%s\n", mw_status_text(status));
    return status == MW_ERROR_ISA && result.s == 9 ? 1 : 2;
}
