// Something to be timed.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <limits>

namespace motorway::bench {

struct work {
    std::function<void(benchmark::State &)> loop; // empty: there is nothing to do here
    std::function<void()> once;
    std::function<void()> publish; // writes the results into the problem's own output, if they are elsewhere
    std::size_t components = all;  // those that it makes of a result: the first so many

    static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

    explicit operator bool() const { return static_cast<bool>(loop); }
};

// The call is compiled into the loop, so that nothing is timed but the call.
template <class F> work make_work(F call, std::function<void()> publish = {})
{
    return {[call](benchmark::State &state) {
                for (auto _ : state) {
                    call();
                    benchmark::ClobberMemory();
                }
            },
            call, std::move(publish)};
}

} // namespace motorway::bench
