// One kernel on one sort of data, and what competes there.
#pragma once

#include "baseline.h"
#include "kernels.h"
#include "options.h"

#include <string>
#include <vector>

namespace motorway::bench {

struct suite_settings {
    bool quick;
    bench::filter filter;
    std::vector<std::string> isas; // best first
};

template <class T, class M = T> struct shape {
    const kernel_row &row;
    layout kind;
    std::size_t count;

    std::string kernel_name(const std::string &isa) const { return row.name + path() + "/" + isa + tail(); }
    std::string baseline_name(const std::string &library) const
    {
        return "baseline_" + library + "/" + row.name + path() + tail();
    }
    work bind(const problem<T, M> &problem) const { return row.bind(problem); }
    bench::problem<T, M> make_problem() const { return {row.name, row.arguments, kind, count}; }
    std::size_t size() const { return problem_size<T, M>(row.arguments, kind, count); } // bytes of a problem

private:
    std::string path() const { return "/" + layout_name<T>(row.arguments, kind) + "/" + precision_name<T, M>; }
    std::string tail() const { return "/" + std::to_string(count); }
};

// Calls visit(shape) for every kernel, layout and precision.
template <class F> void for_each_shape(std::size_t count, F visit)
{
    for (const kernel_row &row : kernel_rows())
        for (layout kind : layouts) {
            if (!allows(row.arguments, kind))
                continue;
            if (row.f32)
                visit(shape<float>{row, kind, count});
            if (row.f64)
                visit(shape<double>{row, kind, count});
            if (row.mixed)
                visit(shape<float, double>{row, kind, count});
        }
}

// A kernel on one instruction set; or a baseline, for which that is the best, if it calls the library.
struct contestant {
    std::string name, isa;
    work todo;

    // Selects the instruction set.
    void get_ready() const;
};

// Those that the filter lets pass.
template <class T, class M>
std::vector<contestant> contestants(const shape<T, M> &shape, const problem<T, M> &problem,
                                    const suite_settings &settings);

// Whether there can be any: to be asked before data is made.
template <class T, class M> bool is_wanted(const shape<T, M> &shape, const suite_settings &settings);

} // namespace motorway::bench
