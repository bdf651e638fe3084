#include "problem.h"

#include "plain.h"
#include "rigid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <numeric>
#include <random>
#include <utility>

namespace motorway::bench {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr std::size_t cache_line = 64, page = 4096, place_offset = 5 * cache_line;

// Scalars from an element to the next where the components are adjacent. In the strided layout vertices are longer
// than what is moved of them, and motors and all that is as large lie in longer records; what comes with them is
// packed.
std::size_t stride_of(operand operand, layout kind)
{
    constexpr std::size_t vertex = PLAIN_VERTEX_STRIDE, rest = PLAIN_MOTOR_STRIDE - components_of(operand::motor);
    const std::size_t components = components_of(operand);
    const bool beside = operand == operand::weights || operand == operand::parameter ||
                        operand == operand::sorted_parameter;
    if (kind != layout::strided || beside)
        return components;
    return components < vertex ? vertex : components + rest;
}

// Distinct elements, repeated to fill an array: what the values are has no influence on time, so long as they are
// ordinary numbers. A prime number, so that the period is that of no layout.
constexpr std::size_t pool_size = 1009;

using random_engine = std::mt19937_64;

double uniform(random_engine &engine, double from, double to)
{
    return std::uniform_real_distribution<double>(from, to)(engine);
}

template <std::size_t N> std::array<double, N> random_direction(random_engine &engine)
{
    std::normal_distribution<double> normal;
    std::array<double, N> direction;
    double square = 0;
    for (double &component : direction) {
        component = normal(engine);
        square += component * component;
    }
    for (double &component : direction)
        component /= std::sqrt(square);
    return direction;
}

// A rotation, and then a random translation t: r + ε ½ t r.
std::array<double, 8> unit_motor(random_engine &engine, const std::array<double, 4> &r)
{
    double t[3];
    for (double &component : t)
        component = uniform(engine, -1, 1);
    return motor_of<double>({r[0], r[1], r[2], r[3], -0.5 * (t[0] * r[1] + t[1] * r[2] + t[2] * r[3]),
                             0.5 * (t[0] * r[0] + t[1] * r[3] - t[2] * r[2]),
                             0.5 * (t[1] * r[0] + t[2] * r[1] - t[0] * r[3]),
                             0.5 * (t[2] * r[0] + t[0] * r[2] - t[1] * r[1])});
}

std::array<double, 8> unit_motor(random_engine &engine) { return unit_motor(engine, random_direction<4>(engine)); }

std::array<double, 8> control(random_engine &engine)
{
    const double half = uniform(engine, 0, pi / 6);
    const auto axis = random_direction<3>(engine);
    const double sine = std::sin(half);
    return unit_motor(engine, {std::cos(half), sine * axis[0], sine * axis[1], sine * axis[2]});
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

std::vector<double> numbers(random_engine &engine, std::size_t count, double from, double to)
{
    std::vector<double> drawn(count);
    for (double &number : drawn)
        number = uniform(engine, from, to);
    return drawn;
}

// The first three numbers are a direction, times `scale`.
std::vector<double> with_direction(random_engine &engine, operand operand, double scale)
{
    auto drawn = numbers(engine, components_of(operand), -1, 1);
    const auto direction = random_direction<3>(engine);
    for (std::size_t k = 0; k < 3; ++k)
        drawn[k] = scale * direction[k];
    return drawn;
}

// With rotations by at most a half turn.
std::vector<double> rotation_about_axis(random_engine &engine, operand operand, std::size_t angle)
{
    auto drawn = with_direction(engine, operand, 1);
    drawn[angle] = uniform(engine, -pi, pi);
    return drawn;
}

template <class Numbers> std::vector<double> as_vector(const Numbers &numbers)
{
    return {std::begin(numbers), std::end(numbers)};
}

// x y z w of each four numbers w x y z.
std::vector<double> with_w_last(std::vector<double> numbers)
{
    for (auto four = numbers.begin(); four != numbers.end(); four += 4)
        std::rotate(four, four + 1, four + 4);
    return numbers;
}

// The matrix of a motion, by rows or by columns of so many numbers.
std::vector<double> matrix(const rigid &r, std::size_t lines, std::size_t length, bool by_rows)
{
    std::vector<double> m;
    for (std::size_t line = 0; line < lines; ++line)
        for (std::size_t k = 0; k < length; ++k) {
            const std::size_t row = by_rows ? line : k, column = by_rows ? k : line;
            m.push_back(row == 3 ? column == 3 : column == 3 ? r.translation[row] : r.rotation[row][column]);
        }
    return m;
}

std::vector<double> draw(random_engine &engine, operand operand)
{
    switch (operand) {
    case operand::motor: return as_vector(unit_motor(engine));
    case operand::any_motor: return as_vector(multiple(engine, unit_motor(engine)));
    case operand::bivector: return with_direction(engine, operand, uniform(engine, 0, pi / 2));
    case operand::weights: return numbers(engine, blend_terms, 0.1, 1);
    case operand::control: return as_vector(control(engine));
    case operand::parameter:
    case operand::sorted_parameter: return numbers(engine, 1, 0, 1);
    case operand::quaternion:
    case operand::quaternion_wxyz: return as_vector(random_direction<4>(engine));
    case operand::dual_quaternion:
    case operand::dual_quaternion_wxyz: return with_w_last(as_vector(dual_quaternion_of(unit_motor(engine))));
    case operand::axis_angle: return rotation_about_axis(engine, operand, 3);
    case operand::screw: return rotation_about_axis(engine, operand, 6);
    case operand::rows_3x4: return matrix(rigid_of(unit_motor(engine)), 3, 4, true);
    case operand::rows_4x4: return matrix(rigid_of(unit_motor(engine)), 4, 4, true);
    case operand::columns_3x4: return matrix(rigid_of(unit_motor(engine)), 4, 3, false);
    case operand::columns_4x4: return matrix(rigid_of(unit_motor(engine)), 4, 4, false);
    default: return numbers(engine, components_of(operand), -1, 1);
    }
}

template <class T> void fill(const array<T> &to, std::size_t count, random_engine &engine, operand operand)
{
    std::vector<std::vector<double>> pool;
    for (std::size_t i = 0; i < std::min(count, pool_size); ++i)
        pool.push_back(draw(engine, operand));
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < to.components(); ++k)
            to.at(k, i) = static_cast<T>(pool[i % pool_size][k]);
    if (operand == operand::sorted_parameter)
        std::sort(to.component()[0], to.component()[0] + count);
}

template <class M> std::vector<M> draw_controls(std::size_t count)
{
    const array<M> drawn(components_of(operand::control), components_of(operand::control), layout::packed, count, 0);
    random_engine engine(2);
    fill(drawn, count, engine, operand::control);
    return {drawn.component()[0], drawn.component()[0] + count * drawn.components()};
}

template <class T> array<T> make_array(operand operand, layout kind, std::size_t count, std::size_t place)
{
    array<T> made(components_of(operand), stride_of(operand, kind), kind, count, place);
    if (operand == operand::quaternion_wxyz || operand == operand::dual_quaternion_wxyz)
        made.rotate_fours();
    return made;
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

template <class T> std::size_t element_size(const std::vector<array<T>> &arrays)
{
    std::size_t size = 0;
    for (const auto &array : arrays)
        size += array.components() * sizeof(T);
    return size;
}

template <class T> std::size_t span_of(const std::vector<array<T>> &arrays)
{
    std::size_t span = 0;
    for (const auto &array : arrays)
        span += array.span();
    return span;
}

// As many controls as a sample depends on.
template <class M> std::size_t control_size_of_element(const arguments &arguments)
{
    constexpr std::size_t one = components_of(operand::control) * sizeof(M);
    return arguments.motion_an_element ? (motion_degree + 1) * one : 0;
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

template <class T> void array<T>::rotate_fours()
{
    for (auto four = component_.begin(); four != component_.end(); four += 4)
        std::rotate(four, four + 1, four + 4);
}

bool allows(const arguments &arguments, layout kind)
{
    if (kind == layout::columns)
        return arguments.images != 1;
    const auto any = [](const std::vector<operand> &operands) {
        return std::any_of(operands.begin(), operands.end(), is_adjacent);
    };
    const auto &in = arguments.in;
    if (kind != layout::packed && std::find(in.begin(), in.end(), operand::control) != in.end())
        return false;
    return kind != layout::soa || !(any(arguments.in) || any(arguments.out));
}

template <class T, class M>
problem<T, M>::problem(std::string name, const arguments &arguments, layout where, std::size_t how_many)
    : kernel(std::move(name)), kind(where), count(how_many), elements(how_many * arguments.joints),
      images(arguments.images), controls(draw_controls<M>(arguments.controls *
                                                          (arguments.motion_an_element ? elements : 1))),
      control_size_(elements * control_size_of_element<M>(arguments))
{
    random_engine engine(1);
    std::size_t place = 0; // of soa, every array takes one
    for (operand operand : arguments.out) {
        out.push_back(make_array<T>(operand, kind, results(), place));
        place += out.back().components();
    }
    if (arguments.motor_an_element) {
        motors = make_array<M>(operand::motor, layout_of_motors(kind), elements, place);
        fill(*motors, elements, engine, operand::motor);
        place += motors->components();
    }
    for (operand operand : arguments.in) {
        in.push_back(make_array<T>(operand, kind, elements, place));
        fill(in.back(), elements, engine, operand);
        place += in.back().components();
    }
    for (std::size_t i = 0; i < arguments.fixed; ++i)
        for (double component : draw(engine, operand::motor))
            fixed.push_back(static_cast<M>(component));
    if (arguments.index_an_element)
        indices = draw_indices(engine, elements);
    parents.resize(arguments.joints);
    std::iota(parents.begin(), parents.end(), -1);
}

template <class T, class M> std::size_t problem<T, M>::bytes_read() const
{
    const std::size_t motor_size = motors ? motors->components() * sizeof(M) : 0;
    return index_size() + control_size_ + elements * (element_size(in) + motor_size);
}

template <class T, class M> std::size_t problem<T, M>::bytes_written() const { return results() * element_size(out); }

template <class T, class M> std::size_t problem<T, M>::span_read() const
{
    return index_size() + control_size_ + span_of(in) + (motors ? motors->span() : 0);
}

template <class T, class M> std::size_t problem<T, M>::span_written() const { return span_of(out); }

template <class T> std::string layout_name(const arguments &arguments, layout kind)
{
    switch (kind) {
    case layout::soa: return "soa";
    case layout::packed: return "aos";
    case layout::strided: return "aos" + std::to_string(stride_of(arguments.out[0], kind) * sizeof(T));
    case layout::columns: return "aos-columns";
    }
    return "";
}

template <class T, class M> std::size_t problem_size(const arguments &arguments, layout kind, std::size_t count)
{
    std::size_t size = 0;
    for (operand operand : arguments.out)
        size += arguments.images * stride_of(operand, kind) * sizeof(T);
    for (operand operand : arguments.in)
        size += stride_of(operand, kind) * sizeof(T);
    if (arguments.motor_an_element)
        size += components_of(operand::motor) * sizeof(M);
    if (arguments.index_an_element)
        size += sizeof(std::uint16_t);
    size += control_size_of_element<M>(arguments);
    return size * arguments.joints * count;
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
