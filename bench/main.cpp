// motorway_bench: verifies, and then measures.
#include "baseline.h"
#include "motorway_views.h"
#include "options.h"
#include "reporter.h"
#include "suite.h"
#include "verify.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <sstream>

namespace {

using namespace motorway::bench;

std::string cpu_name()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.compare(0, 10, "model name") == 0 && line.find(':') + 2 < line.size())
            return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string join(const std::vector<std::string> &words)
{
    std::string text;
    for (const std::string &word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

// The instruction sets that run here, or the one that MOTORWAY_ISA asks for.
std::vector<std::string> isas_to_run()
{
    if (!mw_isa())
        throw std::runtime_error(mw_status_text(MW_ERROR_ISA));
    const char *requested = std::getenv("MOTORWAY_ISA");
    if (requested && *requested)
        return {mw_isa()};
    std::vector<std::string> isas;
    std::istringstream names(mw_isas());
    for (std::string name; std::getline(names >> std::ws, name, ',');)
        isas.push_back(name);
    return isas;
}

void describe_run(const options &options, const suite_settings &settings)
{
    const std::string missing = MOTORWAY_BENCH_MISSING;
    std::vector<std::string> skipped = skipped_baselines();
    if (!missing.empty())
        skipped.push_back(missing);
    for (const std::string &name : skipped)
        std::fprintf(stderr, "skipped: %s\n", name.c_str());
    benchmark::AddCustomContext("cpu", cpu_name());
    benchmark::AddCustomContext("isas", join(settings.isas));
    benchmark::AddCustomContext("compiler", MOTORWAY_BENCH_COMPILER);
    benchmark::AddCustomContext("baseline_compilers", MOTORWAY_BENCH_BASELINE_COMPILERS);
    benchmark::AddCustomContext("baseline_libraries", MOTORWAY_BENCH_LIBRARIES);
    benchmark::AddCustomContext("skipped", join(skipped));
    benchmark::AddCustomContext("quick", options.quick ? "yes" : "no");
}

int run(const options &options)
{
    const suite_settings settings{options.quick, filter(benchmark::GetBenchmarkFilter()), isas_to_run()};
    if (options.list) {
        for (const std::string &name : list_suite(settings))
            std::puts(name.c_str());
        return 0;
    }
    reporter report(options.out, options.out_format);
    verify(settings);
    describe_run(options, settings);
    const std::size_t number = run_suite(settings, report);
    report.finish();
    if (number == 0)
        std::fprintf(stderr, "no benchmark matches %s\n", benchmark::GetBenchmarkFilter().c_str());
    return number == 0;
}

} // namespace

int main(int argc, char **argv)
{
    options options = parse_options(argc, argv);
    std::vector<char *> arguments;
    for (std::string &argument : options.rest)
        arguments.push_back(argument.data());
    int count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    benchmark::Initialize(&count, arguments.data(), print_help);
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
        return 2;
    try {
        return run(options);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "motorway_bench: %s\n", error.what());
        return 1;
    }
}
