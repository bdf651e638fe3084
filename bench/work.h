// Something to be timed.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>

namespace motorway::bench {

struct work {
    std::function<void(benchmark::State &)> loop; // empty: there is nothing to do here
    std::function<void()> once;
    std::function<void()> publish; // writes the results into the problem's own output, if they are elsewhere

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
