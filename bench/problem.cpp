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

// Scalars from an element to the next where the components are adjacent. In the strided layout vertices are longer
// than what is moved of them, and motors on their own lie in longer records; what comes with them is packed.
std::size_t stride_of(operand operand, layout kind)
{
    if (kind != layout::strided || operand == operand::weights)
        return components_of(operand);
    return operand == operand::motor ? PLAIN_MOTOR_STRIDE : PLAIN_VERTEX_STRIDE;
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
        component = operand == operand::weights ? uniform(engine, 0.1, 1) : uniform(engine, -1, 1);
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

template <class T> array<T> make_array(operand operand, layout kind, std::size_t count, std::size_t place)
{
    return {components_of(operand), stride_of(operand, kind), kind, count, place};
}

// Motors of elements are packed wherever they are not separate arrays.
layout layout_of_motors(layout kind) { return kind == layout::soa ? kind : layout::packed; }

// Runs of equal indices, in an order that is none.
std::vector<std::uint16_t> draw_indices(random_engine &engine, std::size_t count)
{
    std::vector<std::uint16_t> indices(count);
    std::uniform_int_distribution<int> any(0, shared_motors - 1);
    int index = 0;
    for (std::size_t i = 0; i < count; ++i) {
        index = i % index_run ? index : any(engine);
        indices[i] = static_cast<std::uint16_t>(index);
    }
    return indices;
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

template <class T, class M>
problem<T, M>::problem(std::string name, const arguments &arguments, layout where, std::size_t elements)
    : kernel(std::move(name)), kind(where), count(elements), images(arguments.images),
      out(make_array<T>(arguments.out, where, elements * arguments.images, 0))
{
    random_engine engine(1);
    std::size_t place = out.components(); // of soa, every array takes one
    if (arguments.motor_an_element) {
        motors = make_array<M>(operand::motor, layout_of_motors(kind), count, place);
        fill(*motors, count, engine, operand::motor, arguments.kind);
        place += motors->components();
    }
    for (operand operand : arguments.in) {
        in.push_back(make_array<T>(operand, kind, count, place));
        fill(in.back(), count, engine, operand, arguments.kind);
        place += in.back().components();
    }
    for (std::size_t i = 0; i < arguments.fixed; ++i)
        for (double component : draw(engine, operand::motor, arguments.kind))
            fixed.push_back(static_cast<M>(component));
    if (arguments.index_an_element)
        indices = draw_indices(engine, count);
}

template <class T, class M> std::size_t problem<T, M>::element_size() const
{
    std::size_t size = motors ? motors->components() * sizeof(M) : 0;
    for (const auto &array : in)
        size += array.components() * sizeof(T);
    return size;
}

template <class T, class M> std::size_t problem<T, M>::span_read() const
{
    std::size_t sum = index_size() + (motors ? motors->span() : 0);
    for (const auto &array : in)
        sum += array.span();
    return sum;
}

template <class T> std::string layout_name(const arguments &arguments, layout kind)
{
    switch (kind) {
    case layout::soa: return "soa";
    case layout::packed: return "aos";
    case layout::strided: return "aos" + std::to_string(stride_of(arguments.out, kind) * sizeof(T));
    case layout::columns: return "aos-columns";
    }
    return "";
}

template <class T, class M> std::size_t problem_size(const arguments &arguments, layout kind, std::size_t count)
{
    std::size_t size = arguments.images * stride_of(arguments.out, kind) * sizeof(T);
    for (operand operand : arguments.in)
        size += stride_of(operand, kind) * sizeof(T);
    if (arguments.motor_an_element)
        size += components_of(operand::motor) * sizeof(M);
    if (arguments.index_an_element)
        size += sizeof(std::uint16_t);
    return size * count;
}

template class array<float>;
template class array<double>;
template std::string layout_name<float>(const arguments &, layout);
template std::string layout_name<double>(const arguments &, layout);

#define MOTORWAY_INSTANTIATE(T, M)                                                                                   \
    template struct problem<T, M>;                                                                                   \
    template std::size_t problem_size<T, M>(const arguments &, layout, std::size_t);
MOTORWAY_INSTANTIATE(float, float)
MOTORWAY_INSTANTIATE(double, double)
MOTORWAY_INSTANTIATE(float, double)

} // namespace motorway::bench
