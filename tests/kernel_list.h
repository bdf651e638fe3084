// The kernels of generated/kernel_list.inc as tests: every row becomes its subjects, in both precisions. A row whose
// subjects nobody has written (subjects_of_<verb>_<operand>_<pairing>) does not compile.
#ifndef MOTORWAY_TESTS_KERNEL_LIST_H
#define MOTORWAY_TESTS_KERNEL_LIST_H

#include <ostream>
#include <string>
#include <vector>

#include "apply_tester.h"
#include "blend_tester.h"
#include "compose_tester.h"
#include "normalize_tester.h"
#include "reverse_tester.h"
#include "subject.h"

namespace motorway::testing {

struct KernelRow {
    std::string name;
    bool unit;  // the variant for MW_UNIT_MOTORS
    int inputs, outputs, operations, divisions;
    Subjects<float> (*subjects_f32)();
    Subjects<double> (*subjects_f64)();

    template <class T>
    Subjects<T> subjects() const
    {
        if constexpr (sizeof(T) == sizeof(float))
            return subjects_f32();
        else
            return subjects_f64();
    }
};

inline void PrintTo(const KernelRow &row, std::ostream *out) { *out << row.name; }

inline const std::vector<KernelRow> &kernel_rows()
{
#define MOTORWAY_TEST_ROW(name, unit, inputs, outputs, operations, divisions)                                        \
    {#name, unit, inputs, outputs, operations, divisions, subjects_of_##name<float>, subjects_of_##name<double>},
#define MOTORWAY_KERNEL(verb, operand, pairing, inputs, outputs, operations, divisions)                              \
    MOTORWAY_TEST_ROW(verb##_##operand##_##pairing, false, inputs, outputs, operations, divisions)
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, inputs, outputs, operations, divisions)                         \
    MOTORWAY_TEST_ROW(verb##_##operand##_##pairing##_unit, true, inputs, outputs, operations, divisions)
    static const std::vector<KernelRow> rows = {
#include "../generated/kernel_list.inc"
    };
#undef MOTORWAY_TEST_ROW
    return rows;
}

}  // namespace motorway::testing

#endif
