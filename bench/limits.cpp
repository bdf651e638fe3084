#include "limits.h"

#include "limit_memory.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace motorway::bench {

// limit_fma.cpp, once for each instruction set.
#define MOTORWAY_ISA(name)                                                                                           \
    double run_fma_f32_##name(std::size_t rounds);                                                                   \
    double run_fma_f64_##name(std::size_t rounds);
#include "../src/isa_list.inc"

namespace {

constexpr std::size_t page = 4096, smallest_size = 1024;

// Made when it is first asked for: limits are listed more often than they are run.
class buffer {
public:
    explicit buffer(std::size_t size) : size_((size + page - 1) / page * page) {}
    char *get()
    {
        if (!memory_) {
            memory_.reset(static_cast<char *>(std::aligned_alloc(page, size_)));
            if (!memory_)
                throw std::bad_alloc();
            std::memset(memory_.get(), 1, size_);
        }
        return memory_.get();
    }

private:
    struct release {
        void operator()(char *memory) const { std::free(memory); }
    };
    std::size_t size_;
    std::unique_ptr<char, release> memory_;
};

template <class F> std::function<void(benchmark::State &)> loop(std::size_t size, F pass)
{
    // The output of a copy begins elsewhere in a page than its input.
    constexpr std::size_t room = page;
    const auto memory = std::make_shared<buffer>(size + room);
    return [=](benchmark::State &state) {
        char *const first = memory->get();
        for (auto _ : state) {
            pass(first);
            benchmark::ClobberMemory();
        }
        state.SetBytesProcessed(static_cast<std::int64_t>(size) * static_cast<std::int64_t>(state.iterations()));
    };
}

// Stores that bypass the caches have a chance nowhere but beyond the first levels.
bool is_worth_trying(const std::string &method, std::size_t size)
{
    constexpr std::size_t first_levels = std::size_t(1) << 20;
    return method != "nontemporal" || size >= first_levels;
}

void add_memory_limits(std::size_t size, std::vector<limit> &to)
{
    const auto add = [&](const std::string &kind, const std::string &method, auto pass) {
        if (is_worth_trying(method, size))
            to.push_back({"limit_" + kind + "/" + method + "/" + std::to_string(size), loop(size, pass)});
    };
    constexpr std::size_t offset = 5 * 64;
    for (const copy_method &method : copy_methods())
        add("copy", method.name,
            [=](char *first) { method.run(first + size / 2 + offset, first, size / 2); });
    for (const fill_method &method : fill_methods())
        add("fill", method.name, [=](char *first) { method.run(first, size); });
    for (const read_method &method : read_methods())
        add("read", method.name, [=](char *first) { method.run(first, size); });
}

limit fma_limit(const std::string &precision, const std::string &isa, double (*run)(std::size_t))
{
    return {"limit_fma/" + precision + "/" + isa, [=](benchmark::State &state) {
                constexpr std::size_t rounds = 1000;
                double operations = 0;
                for (auto _ : state)
                    operations += run(rounds);
                state.SetItemsProcessed(static_cast<std::int64_t>(operations));
            }};
}

} // namespace

std::vector<limit> memory_limits(std::size_t footprint)
{
    std::size_t power = smallest_size;
    while (2 * power <= footprint)
        power *= 2;
    const std::size_t sizes[] = {power, power / 2 * 3, power * 2};
    const auto above = std::lower_bound(std::begin(sizes), std::end(sizes), footprint);
    std::vector<limit> limits;
    if (above != std::begin(sizes) && *above != footprint)
        add_memory_limits(above[-1], limits);
    add_memory_limits(*above, limits);
    return limits;
}

std::vector<limit> fma_limits(const std::vector<std::string> &isas)
{
    std::vector<limit> limits;
    const auto add = [&](const std::string &isa, double (*f32)(std::size_t), double (*f64)(std::size_t)) {
        if (std::find(isas.begin(), isas.end(), isa) == isas.end())
            return;
        limits.push_back(fma_limit("f32", isa, f32));
        limits.push_back(fma_limit("f64", isa, f64));
    };
#define MOTORWAY_ISA(name) add(#name, run_fma_f32_##name, run_fma_f64_##name);
#include "../src/isa_list.inc"
    return limits;
}

} // namespace motorway::bench
