#include "options.h"

#include <benchmark/benchmark.h>

#include <cstdio>

namespace motorway::bench {
namespace {

// The value of --name=value.
bool take(const std::string &argument, const std::string &name, std::string &value)
{
    const std::string start = "--" + name + "=";
    if (argument.compare(0, start.size(), start) != 0)
        return false;
    value = argument.substr(start.size());
    return true;
}

bool is_true(const std::string &value) { return value != "false" && value != "0" && value != "no" && value != "off"; }

} // namespace

options parse_options(int argc, char **argv)
{
    options parsed;
    parsed.out_format = "json";
    std::vector<std::string> given;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        std::string list;
        if (argument == "--quick")
            parsed.quick = true;
        else if (argument == "--benchmark_list_tests")
            parsed.list = true;
        else if (take(argument, "benchmark_list_tests", list))
            parsed.list = is_true(list);
        else if (!take(argument, "benchmark_out", parsed.out) &&
                 !take(argument, "benchmark_out_format", parsed.out_format))
            given.push_back(argument);
    }
    // Many short repetitions: what else goes on in a machine then meets all competitors alike.
    parsed.rest = {argv[0], parsed.quick ? "--benchmark_min_time=0.01" : "--benchmark_min_time=0.02",
                   parsed.quick ? "--benchmark_repetitions=5" : "--benchmark_repetitions=7",
                   "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true"};
    parsed.rest.insert(parsed.rest.end(), given.begin(), given.end());
    return parsed;
}

void print_help()
{
    std::puts("motorway_bench [--quick] and the flags of Google Benchmark:\n"
              "          [--quick]  a few counts a kernel from 64 to 8388608, and 5 repetitions of 0.01 s\n"
              "          else up to nine counts, and 7 repetitions of 0.02 s\n"
              "MOTORWAY_ISA in the environment restricts the kernels to one instruction set.\n");
    benchmark::PrintDefaultHelp();
}

filter::filter(const std::string &text)
    : negative_(!text.empty() && text[0] == '-'),
      expression_(text.empty() || text == "all" ? "" : text.substr(negative_ ? 1 : 0))
{
}

} // namespace motorway::bench
