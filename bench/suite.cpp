#include "suite.h"

#include "limits.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <thread>
#include <unistd.h>

namespace motorway::bench {
namespace {

// Counts that are measured on two threads, too: in the caches of every core.
constexpr std::size_t threaded_count = 1024;

template <class T> void set_counters(benchmark::State &state, const shape<T> &shape, const problem<T> &problem)
{
    const std::size_t read = problem.bytes_read(), written = problem.bytes_written();
    const auto iterations = static_cast<std::int64_t>(state.iterations());
    state.SetItemsProcessed(iterations * static_cast<std::int64_t>(shape.count));
    state.SetBytesProcessed(iterations * static_cast<std::int64_t>(read + written));
    const double values[] = {static_cast<double>(read), static_cast<double>(written),
                             static_cast<double>(problem.span_read()), static_cast<double>(problem.out.span()),
                             static_cast<double>(shape.row.operations * shape.row.terms * shape.count)};
    for (std::size_t i = 0; i < std::size(values); ++i)
        state.counters[report_counters[i]] = values[i];
}

class suite {
public:
    suite(const suite_settings &settings, benchmark::BenchmarkReporter *reporter)
        : settings_(settings), reporter_(reporter)
    {
    }

    void run_all()
    {
        run_limits(fma_limits(settings_.isas), is_anything_wanted());
        for (std::size_t count : settings_.counts)
            for_each_shape(count, [&](const auto &shape) { run_shape(shape); });
        for_each_shape(threaded_count, [&](const auto &shape) { run_threads(shape); });
    }

    std::size_t number() const { return names_.size(); }
    const std::vector<std::string> &names() const { return names_; }

private:
    // Registers a benchmark of the next run.
    template <class F> benchmark::internal::Benchmark *add(const std::string &name, F run)
    {
        names_.push_back(name);
        registered_ = true;
        return benchmark::RegisterBenchmark(name.c_str(), std::move(run));
    }

    // Runs what has been registered, unless it is only to be listed.
    void run_registered()
    {
        if (reporter_ && registered_)
            benchmark::RunSpecifiedBenchmarks(reporter_, ".");
        benchmark::ClearRegisteredBenchmarks();
        registered_ = false;
    }

    bool is_anything_wanted() const
    {
        bool wanted = false;
        for (std::size_t count : settings_.counts)
            for_each_shape(count, [&](const auto &shape) { wanted = wanted || is_wanted(shape, settings_); });
        return wanted;
    }

    // Limits are measured once, whatever the filter says where something is measured against them.
    void add_limits(const std::vector<limit> &limits, bool all)
    {
        for (const limit &limit : limits)
            if ((all || settings_.filter.matches(limit.name)) && measured_limits_.insert(limit.name).second)
                add(limit.name, limit.run);
    }
    void run_limits(const std::vector<limit> &limits, bool all)
    {
        add_limits(limits, all);
        run_registered();
    }

    // Half of the memory is for the data of a problem, of its baselines and of its limits: some three times its own.
    template <class T> bool fits(const shape<T> &shape) const
    {
        const auto memory = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                            static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        if (6 * shape.size() <= memory)
            return true;
        if (reporter_)
            std::fprintf(stderr, "skipped for want of memory: %s\n", shape.kernel_name("*").c_str());
        return false;
    }

    template <class T> void run_shape(const shape<T> &shape)
    {
        const bool wanted = is_wanted(shape, settings_);
        if (wanted && fits(shape)) {
            // Names depend on no data.
            auto made = shape;
            made.count = reporter_ ? shape.count : 1;
            const auto problem = std::make_shared<bench::problem<T>>(made.make_problem());
            for (const contestant &contestant : contestants(shape, *problem, settings_))
                add(contestant.name, [=](benchmark::State &state) {
                    contestant.get_ready();
                    contestant.todo.loop(state);
                    set_counters(state, shape, *problem);
                });
        }
        add_limits(memory_limits(shape.size()), wanted);
        run_registered();
    }

    // Two threads, each on data of its own, on the best instruction set.
    template <class T> void run_threads(const shape<T> &shape)
    {
        constexpr int threads = 2;
        const std::string &isa = settings_.isas.front(), name = shape.kernel_name(isa);
        if (std::thread::hardware_concurrency() < threads || !settings_.filter.matches(name))
            return;
        std::vector<std::shared_ptr<problem<T>>> problems;
        std::vector<work> todo;
        for (int i = 0; i < threads; ++i) {
            problems.push_back(std::make_shared<problem<T>>(shape.make_problem()));
            todo.push_back(shape.row.bind(*problems.back()));
        }
        add(name, [=](benchmark::State &state) {
            contestant{name, isa, {}}.get_ready();
            todo[static_cast<std::size_t>(state.thread_index())].loop(state);
            set_counters(state, shape, *problems[0]);
        })->Threads(threads)->UseRealTime();
        names_.back() += "/real_time/threads:2";
        run_registered();
    }

    const suite_settings &settings_;
    benchmark::BenchmarkReporter *reporter_; // null: list only
    std::vector<std::string> names_;
    std::set<std::string> measured_limits_;
    bool registered_ = false; // anything for the next run
};

} // namespace

std::vector<std::string> list_suite(const suite_settings &settings)
{
    suite suite(settings, nullptr);
    suite.run_all();
    return suite.names();
}

std::size_t run_suite(const suite_settings &settings, benchmark::BenchmarkReporter &reporter)
{
    suite suite(settings, &reporter);
    suite.run_all();
    return suite.number();
}

} // namespace motorway::bench
