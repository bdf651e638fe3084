// The command line: Google Benchmark's, and what this program adds to it.
#pragma once

#include <regex>
#include <string>
#include <vector>

namespace motorway::bench {

struct options {
    bool quick = false;
    bool list = false;       // --benchmark_list_tests
    std::string out;         // --benchmark_out
    std::string out_format;  // --benchmark_out_format
    std::vector<std::string> rest; // for Google Benchmark, its defaults for this program first
};

// The output and the listing are taken from Google Benchmark, because this program runs it many times: once for
// each shape of data, so that what is compared is measured in turns.
options parse_options(int argc, char **argv);

// What --help adds.
void print_help();

// Google Benchmark's --benchmark_filter: a regular expression, or what shall not match behind a minus.
class filter {
public:
    explicit filter(const std::string &text);
    bool matches(const std::string &name) const { return std::regex_search(name, expression_) != negative_; }

private:
    bool negative_;
    std::regex expression_;
};

} // namespace motorway::bench
