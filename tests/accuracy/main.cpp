// Measures all errors and writes them to a file, one JSON object a line; report.py makes tables and charts of them.
//
//     motorway_accuracy FILE [--quick]

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>

#include "cases.h"
#include "check_truth.h"
#include "drift.h"
#include "library.h"

namespace motorway::accuracy {
namespace {

struct Counts {
    std::size_t of_function, of_conversion, of_chain, of_point;  // inputs
    int points;                                                  // of a curve
};
constexpr Counts full = {50000, 20000, 5000, 5000, 64}, quick = {8000, 4000, 500, 500, 64};

constexpr double tolerated_truth = 1e-26;

class Progress {
public:
    void say(const std::string &what)
    {
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin_;
        std::fprintf(stderr, "%4.0f s  %s\n", time.count(), what.c_str());
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Numbers are written so that infinity is one, as Python reads it.
class Line {
public:
    Line(std::ostream &out, const char *kind) : out_(out)
    {
        out_ << std::setprecision(9) << "{\"kind\": \"" << kind << '"';
    }
    ~Line() { out_ << "}\n" << std::flush; }
    Line(const Line &) = delete;
    Line &operator=(const Line &) = delete;

    Line &add(const char *key, const std::string &value)
    {
        out_ << ", \"" << key << "\": \"" << value << '"';
        return *this;
    }
    Line &add(const char *key, double value)
    {
        out_ << ", \"" << key << "\": ";
        if (std::isinf(value))
            out_ << "Infinity";
        else
            out_ << value;
        return *this;
    }

private:
    std::ostream &out_;
};

void write_part(std::ostream &out, const Title &title, const char *precision, const Errors &errors, bool rotation,
                std::size_t count, double disagreement)
{
    const Figures &figures = rotation ? errors.rotation : errors.translation;
    Line(out, "case")
        .add("section", title.section)
        .add("function", title.function)
        .add("inputs", title.inputs)
        .add("part", rotation ? "rotation" : "translation")
        .add("relative_to", rotation ? title.rotation : title.translation)
        .add("asked", title.asked)
        .add("precision", precision)
        .add("class", errors.isa_class)
        .add("count", static_cast<double>(count))
        .add("worst", figures.worst)
        .add("median", figures.median)
        .add("worst_angle", figures.worst_angle)
        .add("disagreement", disagreement);
}

template <class T>
void measure_cases(std::ostream &out, Progress &progress, const Counts &counts)
{
    std::vector<Case<T>> cases;
    for (const auto &some : {exponential_cases<T>(), product_cases<T>(), identity_cases<T>(), conversion_cases<T>()})
        cases.insert(cases.end(), some.begin(), some.end());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Title &title = cases[i].title;
        const std::size_t count = title.section == "conversions" ? counts.of_conversion
                                  : title.section == "chains"    ? counts.of_chain
                                                                 : counts.of_function;
        const Measured measured = measure(cases[i], count, i + 1);
        std::string worst;
        for (const Errors &errors : measured.errors) {
            for (bool rotation : {true, false})
                write_part(out, title, api<T>::name, errors, rotation, count, measured.disagreement);
            char text[64];
            std::snprintf(text, sizeof text, "  %s %.2f, %.2f", errors.isa_class.c_str(), errors.rotation.worst,
                          errors.translation.worst);
            worst += text;
        }
        progress.say(std::string(api<T>::name) + "  " + title.function + ", " + title.inputs + ":" + worst);
    }
}

// On a logarithmic axis up to 1 rad, and on a linear one to two turns.
template <class T>
void measure_curves(std::ostream &out, Progress &progress, const Counts &counts)
{
    std::vector<Curve<T>> curves = exponential_curves<T>();
    for (const Curve<T> &curve : product_curves<T>())
        curves.push_back(curve);
    for (const Curve<T> &curve : curves)
        for (const bool logarithmic : {true, false}) {
            progress.say(std::string(api<T>::name) + "  " + curve.name + " against the angle");
            for (int point = 0; point < counts.points; ++point) {
                const double from = static_cast<double>(point) / counts.points, to = from + 1.0 / counts.points;
                const double low = logarithmic ? std::pow(1e-30, 1 - from) : 2 * turn * from;
                const double high = logarithmic ? std::pow(1e-30, 1 - to) : 2 * turn * to;
                const Angles angles = logarithmic ? logarithmically("", low, high) : evenly("", low, high);
                const Measured measured =
                    measure(curve.at(angles), counts.of_point, static_cast<std::uint64_t>(point + 1));
                for (const Errors &errors : measured.errors)
                    Line(out, "curve")
                        .add("function", curve.name)
                        .add("axis", logarithmic ? "logarithmic" : "linear")
                        .add("precision", api<T>::name)
                        .add("class", errors.isa_class)
                        .add("low", low)
                        .add("high", high)
                        .add("rotation", errors.rotation.worst)
                        .add("translation", errors.translation.worst);
            }
        }
}

template <class T>
void measure_products(std::ostream &out, Progress &progress)
{
    progress.say(std::string(api<T>::name) + "  a million products");
    for (const Drift &drift : measure_drift<T>())
        Line(out, "drift")
            .add("precision", api<T>::name)
            .add("class", drift.isa_class)
            .add("products", static_cast<double>(drift_products))
            .add("every", static_cast<double>(drift_renormalised_every))
            .add("before", drift.before)
            .add("after", drift.after)
            .add("pseudoscalar", drift.pseudoscalar);
}

template <class T>
void measure_all(std::ostream &out, Progress &progress, const Counts &counts)
{
    measure_cases<T>(out, progress, counts);
    measure_curves<T>(out, progress, counts);
    measure_products<T>(out, progress);
}

void run(const std::string &path, bool is_quick)
{
    if (!mw_isa())
        throw std::runtime_error(mw_status_text(MW_ERROR_ISA));
    Progress progress;
    std::ofstream out(path);
    const Counts counts = is_quick ? quick : full;
    progress.say("the true values against the power series of the algebra");
    const double difference = check_truth();
    if (!(difference < tolerated_truth))
        throw std::runtime_error("the true values differ from the power series");
    Line(out, "truth").add("difference", difference).add("run", is_quick ? "quick" : "full");
    for (const IsaClass &of : isa_classes()) {
        std::string isas;
        for (const std::string &isa : of.isas)
            isas += (isas.empty() ? "" : ", ") + isa;
        Line(out, "class").add("class", of.name).add("isas", isas);
    }
    measure_all<float>(out, progress, counts);
    measure_all<double>(out, progress, counts);
    if (!out)
        throw std::runtime_error("could not write " + path);
    progress.say("done");
}

}  // namespace
}  // namespace motorway::accuracy

int main(int argc, char **argv)
{
    const bool is_quick = argc == 3 && std::strcmp(argv[2], "--quick") == 0;
    if (argc != 2 && !is_quick) {
        std::cerr << "usage: motorway_accuracy FILE [--quick]\n";
        return 2;
    }
    try {
        motorway::accuracy::run(argv[1], is_quick);
    } catch (const std::exception &error) {
        std::cerr << "motorway_accuracy: " << error.what() << '\n';
        return 1;
    }
}
