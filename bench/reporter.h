// One report of many runs of Google Benchmark.
#pragma once

#include <benchmark/benchmark.h>

#include <fstream>
#include <memory>
#include <string>

namespace motorway::bench {

// Passes the context on once, results to the display and to a file. The display shows medians alone.
class reporter : public benchmark::BenchmarkReporter {
public:
    // `file` may be empty. Throws std::runtime_error if it cannot be written, or if there is no such format.
    reporter(const std::string &file, const std::string &format);

    bool ReportContext(const Context &context) override;
    void ReportRuns(const std::vector<Run> &runs) override;
    void finish(); // after the last run

private:
    benchmark::BenchmarkReporter *display_; // Google Benchmark's
    std::ofstream stream_;
    std::unique_ptr<benchmark::BenchmarkReporter> file_;
    bool has_context_ = false;
};

} // namespace motorway::bench
