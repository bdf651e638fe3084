#include "sample_command.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <vector>

#include "error.h"
#include "files.h"
#include "motion.h"
#include "motion_file.h"
#include "samples.h"
#include "status.h"
#include "summary.h"
#include "text.h"

namespace motorway::tool {
namespace {

constexpr long long MOST_SAMPLES = 1000000;

std::array<double, 3> parse_point(const std::string &text)
{
    std::array<double, 3> point = {};
    std::size_t begin = 0, coordinates = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + 1, ++coordinates) {
        end = text.find(',', begin);
        const std::string word = text.substr(begin, end == std::string::npos ? end : end - begin);
        const std::optional<double> number = parse_double(word);
        if (coordinates == 3 || !number || !std::isfinite(*number))
            throw Error("--even", in_quotes(text) + " is no point; give X,Y,Z, three numbers without spaces");
        point[coordinates] = *number;
    }
    if (coordinates < 3)
        throw Error("--even", in_quotes(text) + " is no point; give X,Y,Z, three numbers without spaces");
    return point;
}

/* Everything that can be refused before a file is read. */
void check_options(const SampleOptions &options)
{
    if (options.count < 1 || options.count > MOST_SAMPLES)
        throw Error("--count", std::to_string(options.count) + " will not do; give 1 to " +
                                   grouped(std::uint64_t{MOST_SAMPLES}));
    if (!options.even.empty())
        parse_point(options.even);
    if (!mw_isa())
        throw Error("MOTORWAY_ISA", mw_status_text(MW_ERROR_ISA));
    if (!options.out.empty())
        OutputFiles::check(options.out);
}

std::vector<double> choose_parameters(const Motion &motion, const SampleOptions &options)
{
    const auto count = static_cast<std::size_t>(options.count);
    if (options.even.empty())
        return even_parameters(motion, count);
    std::vector<double> parameters(count);
    check(mw_motion_even_parameters_f64(parameters.data(), motion.compiled(), 0, parse_point(options.even).data(),
                                        count),
          options.motion);
    return parameters;
}

void write_to_standard_output(const std::string &text)
{
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw Error("the standard output",
                    std::string("cannot be written (") + std::strerror(errno) + "); check where it goes");
}

} // namespace

void run_sample(const SampleOptions &options)
{
    check_options(options);
    const Motion motion = read_motion(options.motion);
    std::optional<Frame> velocities;
    if (options.velocity)
        velocities = options.frame == "body" ? Frame::BODY : Frame::SPACE;
    const Samples samples = take_samples(motion, choose_parameters(motion, options), velocities);
    const bool as_json = options.format.empty() ? extension(options.out) == ".json" : options.format == "json";
    const std::string text = as_json ? write_json(samples, motion) : write_csv(samples);
    if (options.out.empty()) {
        write_to_standard_output(text);
        return;
    }
    OutputFiles out;
    out.write(options.out, text);
    out.commit();
    print_motion("motion", options.motion, motion);
    print_line("samples", grouped(static_cast<std::uint64_t>(options.count)));
    print_files(out.files());
}

} // namespace motorway::tool
