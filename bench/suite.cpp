#include "suite.h"

#include "limits.h"
#include "schedule.h"

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

template <class T, class M>
void set_counters(benchmark::State &state, const shape<T, M> &shape, const problem<T, M> &problem)
{
    const std::size_t results = problem.results(), read = problem.bytes_read(), written = problem.bytes_written();
    const auto iterations = static_cast<std::int64_t>(state.iterations());
    state.SetItemsProcessed(iterations * static_cast<std::int64_t>(results));
    state.SetBytesProcessed(iterations * static_cast<std::int64_t>(read + written));
    const std::size_t values[] = {results, read, written, problem.span_read(), problem.span_written(),
                                  shape.row.operations * shape.row.terms * results};
    for (std::size_t i = 0; i < std::size(values); ++i)
        state.counters[report_counters[i]] = static_cast<double>(values[i]);
}

class suite {
public:
    suite(const suite_settings &settings, benchmark::BenchmarkReporter *reporter)
        : settings_(settings), reporter_(reporter)
    {
    }

    void run_all()
    {
        std::size_t wanted = 0;
        for_each_scheduled([&](const auto &shape) { wanted += is_wanted(shape, settings_); });
        run_limits(fma_limits(settings_.isas), wanted != 0);
        for_each_scheduled([&](const auto &shape) {
            if (is_wanted(shape, settings_)) {
                show_progress(shape.kernel_name("*"), wanted);
                run_shape(shape);
            } else
                run_limits(memory_limits(shape.size()), false);
        });
        for_each_shape(threaded_count, [&](const auto &shape) {
            if (is_threaded(shape, settings_.quick))
                run_threads(shape);
        });
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

    template <class F> void for_each_scheduled(F visit) const
    {
        for (std::size_t count : counts(settings_.quick))
            for_each_shape(count, [&](const auto &shape) {
                if (is_scheduled(shape, settings_.quick))
                    visit(shape);
            });
    }

    void show_progress(const std::string &name, std::size_t wanted)
    {
        if (reporter_)
            std::fprintf(stderr, "%zu of %zu: %s\n", ++begun_, wanted, name.c_str());
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
    template <class T, class M> bool fits(const shape<T, M> &shape) const
    {
        const auto memory = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                            static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        if (6 * shape.size() <= memory)
            return true;
        if (reporter_)
            std::fprintf(stderr, "skipped for want of memory: %s\n", shape.kernel_name("*").c_str());
        return false;
    }

    template <class T, class M> void run_shape(const shape<T, M> &shape)
    {
        if (fits(shape)) {
            // Names depend on no data, but a motion has no fewer controls than it needs.
            auto made = shape;
            made.count = reporter_ || shape.row.arguments.natural_count ? shape.count : 1;
            const auto problem = std::make_shared<bench::problem<T, M>>(made.make_problem());
            for (const contestant &contestant : contestants(shape, *problem, settings_))
                add(contestant.name, [=](benchmark::State &state) {
                    contestant.get_ready();
                    contestant.todo.loop(state);
                    set_counters(state, shape, *problem);
                });
        }
        run_limits(memory_limits(shape.size()), true);
    }

    // Two threads, each on data of its own, on the best instruction set.
    template <class T, class M> void run_threads(const shape<T, M> &shape)
    {
        constexpr int threads = 2;
        const std::string &isa = settings_.isas.front(), name = shape.kernel_name(isa);
        if (std::thread::hardware_concurrency() < threads || !settings_.filter.matches(name))
            return;
        std::vector<std::shared_ptr<problem<T, M>>> problems;
        std::vector<work> todo;
        for (int i = 0; i < threads; ++i) {
            problems.push_back(std::make_shared<problem<T, M>>(shape.make_problem()));
            todo.push_back(shape.bind(*problems.back()));
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
    std::size_t begun_ = 0;   // shapes
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
