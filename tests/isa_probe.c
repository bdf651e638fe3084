/* Prints the instruction set in use; or, if MOTORWAY_ISA asks for one that cannot run, what calls then return, and
 * exits with 1. One call of each kind of function. */
#include <stdio.h>

#include "motorway.h"

int main(void)
{
    mw_motor_f32 motor = {1, 0, 0, 0, 0, 0, 0, 0}, result = {9, 9, 9, 9, 9, 9, 9, 9};
    const size_t size = sizeof motor;
    float bivector[6] = {0, 0, 0, 0, 0, 0}, half = 0.5f;
    float quaternion[4], translation[3], matrix[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    const int32_t parent = -1;
    const mw_status expected = mw_isa() ? MW_OK : MW_ERROR_ISA;
    const mw_status statuses[] = {
        mw_reverse_motor_each_f32(&result, size, &motor, size, 1),
        mw_log_motor_each_f32(bivector, sizeof bivector, &motor, size, 1, MW_DEFAULT),
        mw_exp_motor_each_f32(&result, size, bivector, sizeof bivector, 1),
        mw_slerp_motor_one_f32(&result, size, &motor, &motor, &half, 0, 1, MW_DEFAULT),
        mw_nlerp_motor_each_f32(&result, size, &motor, size, &motor, size, &half, 0, 1, MW_DEFAULT),
        mw_ratio_motor_each_f32(&result, size, &motor, size, &motor, size, 1, MW_DEFAULT),
        mw_convert_motor_to_pose_each_f32(quaternion, sizeof quaternion, translation, sizeof translation, &motor, size,
                                          1),
        mw_convert_motor_to_matrix_each_f32(matrix, sizeof matrix, MW_MATRIX_ROWS_3X4, &motor, size, 1),
        mw_convert_matrix_to_motor_each_f32(&result, size, matrix, sizeof matrix, MW_MATRIX_ROWS_3X4, 1,
                                            MW_NEAREST_ROTATION, NULL),
        mw_convert_rotor_to_motor_each_f32(&result, size, &motor, size, 1, 2),
        mw_compose_motor_hierarchy_f32(&result, size, &motor, size, size, &parent, 1, 1, NULL),
    };
    size_t k;
    for (k = 0; k < sizeof statuses / sizeof statuses[0]; ++k)
        if (statuses[k] != expected)
            return 2;
    if (mw_isa()) {
        printf("%s\n", mw_isa());
        return result.s == 1 ? 0 : 2;
    }
    printf("%s\n", mw_status_text(statuses[0]));
    return result.s == 9 ? 1 : 2;
}
