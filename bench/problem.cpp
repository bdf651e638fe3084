#include "problem.h"

#include "plain.h"
#include "rigid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <random>
#include <utility>

namespace motorway::bench {
namespace {

constexpr std::size_t cache_line = 64, page = 4096, place_offset = 5 * cache_line;

std::size_t components_of(operand operand)
{
    switch (operand) {
    case operand::xyz: return 3;
    case operand::motor: return 8;
    case operand::weights: return blend_terms;
    }
    return 0;
}

// Scalars from an element to the next where the components are adjacent. In the strided layout the vertices of
// points are longer than the points, and motors on their own lie in longer records; what comes with them is packed.
std::size_t stride_of(const arguments &arguments, operand operand, layout kind)
{
    if (kind == layout::strided && operand == operand::xyz)
        return PLAIN_POINT_STRIDE;
    if (kind == layout::strided && operand == operand::motor && arguments.out == operand::motor)
        return PLAIN_MOTOR_STRIDE;
    return components_of(operand);
}

// Distinct elements, repeated to fill an array: what the values are has no influence on time, so long as they are
// ordinary numbers. A prime number, so that the period is that of no layout.
constexpr std::size_t pool_size = 1009;

using random_engine = std::mt19937_64;

double uniform(random_engine &engine, double from, double to)
{
    return std::uniform_real_distribution<double>(from, to)(engine);
}

// A rotation about a random axis, and then a translation t: r + ε ½ t r.
std::array<double, 8> unit_motor(random_engine &engine)
{
    std::normal_distribution<double> normal;
    double r[4], t[3], length = 0;
    for (double &component : r) {
        component = normal(engine);
        length += component * component;
    }
    for (double &component : r)
        component /= std::sqrt(length);
    for (double &component : t)
        component = uniform(engine, -1, 1);
    return motor_of<double>({r[0], r[1], r[2], r[3], -0.5 * (t[0] * r[1] + t[1] * r[2] + t[2] * r[3]),
                             0.5 * (t[0] * r[0] + t[1] * r[3] - t[2] * r[2]),
                             0.5 * (t[1] * r[0] + t[2] * r[1] - t[0] * r[3]),
                             0.5 * (t[2] * r[0] + t[0] * r[2] - t[1] * r[1])});
}

// Times a study number a + b e123∞, which changes the dual part alone beside the scale.
std::array<double, 8> multiple(random_engine &engine, const std::array<double, 8> &motor)
{
    auto q = dual_quaternion_of(motor);
    const double a = uniform(engine, 0.5, 2), b = uniform(engine, -1, 1);
    for (int k = 0; k < 4; ++k) {
        q[4 + k] = a * q[4 + k] + b * q[k];
        q[k] *= a;
    }
    return motor_of(q);
}

std::vector<double> draw(random_engine &engine, operand operand, motors kind)
{
    if (operand == operand::motor) {
        const auto unit = unit_motor(engine);
        const auto motor = kind == motors::unit ? unit : multiple(engine, unit);
        return {motor.begin(), motor.end()};
    }
    std::vector<double> components(components_of(operand));
    for (double &component : components)
        component = operand == operand::xyz ? uniform(engine, -1, 1) : uniform(engine, 0.1, 1);
    return components;
}

template <class T>
void fill(const array<T> &to, std::size_t count, random_engine &engine, operand operand, motors kind)
{
    std::vector<std::vector<double>> pool;
    for (std::size_t i = 0; i < std::min(count, pool_size); ++i)
        pool.push_back(draw(engine, operand, kind));
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < to.components(); ++k)
            to.at(k, i) = static_cast<T>(pool[i % pool_size][k]);
}

template <class T>
array<T> make_array(const arguments &arguments, operand operand, layout kind, std::size_t count, std::size_t place)
{
    return {components_of(operand), stride_of(arguments, operand, kind), kind, count, place};
}

std::size_t round_up(std::size_t size, std::size_t to) { return (size + to - 1) / to * to; }

} // namespace

template <class T>
array<T>::array(std::size_t components, std::size_t stride, layout kind, std::size_t count, std::size_t place)
{
    const bool soa = kind == layout::soa;
    const std::size_t block = (soa ? 1 : stride) * count * sizeof(T), blocks = soa ? components : 1;
    const std::size_t offset = place * place_offset % page;
    const std::size_t distance = round_up(block, cache_line) + place_offset;
    const std::size_t size = round_up(offset + distance * blocks, page);
    stride_ = (soa ? 1 : stride) * sizeof(T);
    span_ = block * blocks;
    memory_.reset(static_cast<T *>(std::aligned_alloc(page, size)));
    if (!memory_)
        throw std::bad_alloc();
    std::fill_n(memory_.get(), size / sizeof(T), T(0));
    for (std::size_t k = 0; k < components; ++k)
        component_.push_back(memory_.get() + (offset + (soa ? k * distance : 0)) / sizeof(T) + (soa ? 0 : k));
}

template <class T>
problem<T>::problem(std::string name, const arguments &arguments, layout where, std::size_t elements)
    : kernel(std::move(name)), kind(where), count(elements),
      out(make_array<T>(arguments, arguments.out, where, elements, 0))
{
    random_engine engine(1);
    std::size_t place = out.components(); // of soa, every array takes one
    for (operand operand : arguments.in) {
        in.push_back(make_array<T>(arguments, operand, kind, count, place));
        fill(in.back(), count, engine, operand, arguments.kind);
        place += in.back().components();
    }
    for (std::size_t i = 0; i < arguments.fixed; ++i)
        for (double component : draw(engine, operand::motor, arguments.kind))
            fixed.push_back(static_cast<T>(component));
}

template <class T> std::size_t problem<T>::components_in() const
{
    std::size_t sum = 0;
    for (const auto &array : in)
        sum += array.components();
    return sum;
}

template <class T> std::size_t problem<T>::span_read() const
{
    std::size_t sum = 0;
    for (const auto &array : in)
        sum += array.span();
    return sum;
}

template <class T> std::string layout_name(const arguments &arguments, layout kind)
{
    switch (kind) {
    case layout::soa: return "soa";
    case layout::packed: return "aos";
    case layout::strided: return "aos" + std::to_string(stride_of(arguments, arguments.out, kind) * sizeof(T));
    }
    return "";
}

template <class T> std::size_t problem_size(const arguments &arguments, layout kind, std::size_t count)
{
    std::size_t stride = stride_of(arguments, arguments.out, kind);
    for (operand operand : arguments.in)
        stride += stride_of(arguments, operand, kind);
    return stride * count * sizeof(T);
}

template class array<float>;
template class array<double>;
template struct problem<float>;
template struct problem<double>;
template std::string layout_name<float>(const arguments &, layout);
template std::string layout_name<double>(const arguments &, layout);
template std::size_t problem_size<float>(const arguments &, layout, std::size_t);
template std::size_t problem_size<double>(const arguments &, layout, std::size_t);

} // namespace motorway::bench
