#include "reporter.h"

#include "suite.h"

#include <algorithm>
#include <stdexcept>

namespace motorway::bench {
namespace {

std::unique_ptr<benchmark::BenchmarkReporter> make_reporter(const std::string &format)
{
    if (format == "json")
        return std::make_unique<benchmark::JSONReporter>();
    if (format == "console")
        return std::make_unique<benchmark::ConsoleReporter>(benchmark::ConsoleReporter::OO_None);
    throw std::runtime_error("--benchmark_out_format=" + format + ": the format is json or console");
}

// For the console: no counters that only the report needs, and of several repetitions the median.
std::vector<benchmark::BenchmarkReporter::Run> essence(const std::vector<benchmark::BenchmarkReporter::Run> &runs)
{
    using run = benchmark::BenchmarkReporter::Run;
    std::vector<run> result;
    for (run r : runs) {
        if (r.run_type == run::RT_Aggregate && r.aggregate_name != "median")
            continue;
        r.run_type = run::RT_Iteration;
        for (const char *counter : report_counters)
            r.counters.erase(counter);
        result.push_back(r);
    }
    return result;
}

} // namespace

reporter::reporter(const std::string &file, const std::string &format)
    : display_(benchmark::CreateDefaultDisplayReporter())
{
    if (file.empty())
        return;
    file_ = make_reporter(format);
    stream_.open(file);
    if (!stream_)
        throw std::runtime_error(file + " cannot be written");
    file_->SetOutputStream(&stream_);
}

bool reporter::ReportContext(const Context &context)
{
    if (has_context_)
        return true;
    has_context_ = true;
    Context wide = context;
    wide.name_field_width = std::max<std::size_t>(context.name_field_width, 72);
    return display_->ReportContext(wide) && (!file_ || file_->ReportContext(wide));
}

void reporter::ReportRuns(const std::vector<Run> &runs)
{
    const bool console = dynamic_cast<benchmark::ConsoleReporter *>(display_);
    display_->ReportRuns(console ? essence(runs) : runs);
    if (file_)
        file_->ReportRuns(runs);
}

void reporter::finish()
{
    if (!has_context_)
        return;
    display_->Finalize();
    if (file_)
        file_->Finalize();
}

} // namespace motorway::bench
