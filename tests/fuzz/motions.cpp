// Motions of every kind through a few controls, sampled with and without velocities, and put onto points. What is
// right is the definition of each in docs/motions.md, by the functions of Cox and de Boor over wide numbers.
#include <algorithm>

#include "judge.h"

namespace motorway::fuzz {
namespace {

template <class T>
using Out = typename api<T>::motors;

struct Shape {
    mw_motion_kind kind;
    unsigned degree;
    std::size_t controls;
};

const char *name_of(mw_motion_kind kind)
{
    const char *const names[] = {"additive", "multiplicative", "cumulative", "generator", "generator keys"};
    return names[kind - MW_MOTION_ADDITIVE];
}

// ------------------------------------------------------------------------------------------------------ what is right

// Clamped at both ends, 0 1 2 ... between, with one more at each end than the library wants.
template <class R>
R knot(const Shape &shape, std::size_t k)
{
    const std::size_t d = shape.degree, last = shape.controls - d;
    return R(static_cast<int>(k <= d ? 0 : std::min(k - d, last)));
}

// The span that t is in, of those that are not empty; at the end the last.
template <class R>
std::size_t span_of(const Shape &shape, R t)
{
    std::size_t j = shape.degree;
    while (j + 1 < shape.controls && knot<R>(shape, j + 1) <= t)
        ++j;
    return j;
}

// N_k(t), of all controls.
template <class R>
std::vector<R> basis(const Shape &shape, R t)
{
    const std::size_t d = shape.degree, j = span_of(shape, t);
    std::vector<R> n(shape.controls + d + 1, R(0));
    n[j] = 1;
    const auto part = [&](R above, R below) { return below == 0 ? R(0) : R(above / below); };
    for (std::size_t r = 1; r <= d; ++r)
        for (std::size_t k = j >= r ? j - r : 0; k <= j; ++k)
            n[k] = part(t - knot<R>(shape, k), knot<R>(shape, k + r) - knot<R>(shape, k)) * n[k] +
                   part(knot<R>(shape, k + r + 1) - t, knot<R>(shape, k + r + 1) - knot<R>(shape, k + 1)) * n[k + 1];
    n.resize(shape.controls);
    return n;
}

template <class R>
Motor<R> nearer(const Motor<R> &m, const Motor<R> &to)
{
    return dot(m.r, to.r) < 0 ? R(-1) * m : m;
}

template <class R>
Motor<R> multiplicative(const Shape &shape, const std::vector<Motor<R>> &controls, R t)
{
    const std::size_t d = shape.degree, j = span_of(shape, t);
    std::vector<Motor<R>> points(controls.begin() + static_cast<std::ptrdiff_t>(j - d),
                                 controls.begin() + static_cast<std::ptrdiff_t>(j + 1));
    for (std::size_t r = 1; r <= d; ++r)
        for (std::size_t i = d; i >= r; --i) {
            const R begin = knot<R>(shape, j - d + i), end = knot<R>(shape, j + 1 + i - r);
            points[i] = slerp(points[i - 1], nearer(points[i], points[i - 1]), R((t - begin) / (end - begin)));
        }
    return points[d];
}

template <class R>
Motor<R> right_pose(const Shape &shape, const std::vector<Motor<R>> &controls, R t)
{
    if (shape.kind == MW_MOTION_MULTIPLICATIVE)
        return multiplicative(shape, controls, t);
    const std::vector<R> n = basis(shape, t);
    Motor<R> sum{}, pose = controls[0];
    R rest = 0;
    switch (shape.kind) {
    case MW_MOTION_ADDITIVE:
        for (std::size_t k = 0; k < controls.size(); ++k)
            sum = sum + n[k] * controls[k];
        return sum;
    case MW_MOTION_GENERATOR:
        for (std::size_t k = 0; k < controls.size(); ++k)
            sum = sum + n[k] * log(controls[k], Way::principal);
        return exp(sum);
    default:  // the product exp(c_n b_n) ... exp(c_1 b_1) S_0, whose left factors act first
        for (std::size_t k = 0; k < controls.size(); ++k)
            rest += n[k];
        for (std::size_t k = 1; k < controls.size(); ++k) {
            rest -= n[k - 1];
            pose = compose(exp(rest * log(compose(controls[k], inverse(controls[k - 1])), Way::principal)), pose);
        }
        return pose;
    }
}

// Inputs are the controls and then the parameter. Controls with the sign of the shortest way; none if that is in
// doubt.
template <class T>
std::vector<Motor<Wide<T>>> controls_of(const Shape &shape, const void *const *inputs)
{
    using R = Wide<T>;
    std::vector<Motor<R>> controls;
    for (std::size_t k = 0; k < shape.controls; ++k) {
        Motor<R> control = motor_of<R>(numbers<T>(inputs[k]));
        if (shape.kind != MW_MOTION_ADDITIVE)
            control = normalized(control);
        const Motor<R> before = k > 0                               ? controls.back()
                                : shape.kind == MW_MOTION_GENERATOR ? Motor<R>{{{}, R(1)}, {}}
                                                                    : control;
        const R cosine = dot(control.r, before.r);
        if (abs(cosine) < R(0.01))
            return {};
        controls.push_back(cosine < 0 ? R(-1) * control : control);
    }
    return controls;
}

template <class T>
Verdict judge_pose(const Shape &shape, const void *const *inputs, const T *out)
{
    using R = Wide<T>;
    Verdict verdict;
    const std::vector<Motor<R>> controls = controls_of<T>(shape, inputs);
    if (controls.empty())
        return verdict;
    const Motor<R> right = right_pose(shape, controls, R(*numbers<T>(inputs[shape.controls])));
    R reach = 0;
    for (const Motor<R> &control : controls)
        reach = larger(reach, length(control.d));
    if (shape.kind == MW_MOTION_ADDITIVE) {
        near_motor(verdict, out, right, R(1), 2 + 2 * double(shape.degree), reach, 2 + 2 * double(shape.degree),
                   R(16));
        return verdict;
    }
    // What rotates by S and -S is the same.
    R numbers[8];
    components_of(right, numbers);
    R cosine = 0;
    for (int k = 0; k < 4; ++k)
        cosine += numbers[k] * R(out[k]);
    const double bound = 8 * (1 + double(shape.controls));
    unit_motor(verdict, out, 4 + 4 * double(shape.controls));
    // Where relative motors are far screws, what is between them is up to a few times as far away.
    const R size = reach * R(shape.kind == MW_MOTION_MULTIPLICATIVE ? 4 : 32);
    near_motor(verdict, out, cosine < 0 ? R(-1) * right : right, R(1), bound, size, bound, R(64));
    return verdict;
}

// The twist Ω with S' = S Ω of the normalised motion, by a difference; not beside a knot.
template <class T>
void judge_twist(Verdict &verdict, const Shape &shape, const void *const *inputs, const T *twist)
{
    const std::vector<Motor<Quad>> controls = [&] {
        std::vector<Motor<Quad>> wide;
        for (const auto &control : controls_of<T>(shape, inputs)) {
            Wide<T> c[8];
            components_of(control, c);
            wide.push_back(motor_of<Quad>(c));
        }
        return wide;
    }();
    const Quad t = *numbers<T>(inputs[shape.controls]), off = abs(remainder(t, Quad(1))), step = scaled(Quad(1), -34);
    if (controls.empty() || off < scaled(Quad(1), -20))
        return;
    const Motor<Quad> before = normalized(right_pose(shape, controls, Quad(t - step)));
    const Motor<Quad> after = nearer(normalized(right_pose(shape, controls, Quad(t + step))), before);
    // Half way, S^-1 S' to the square of the step: the logarithm of before^-1 after over two steps.
    const Motor<Quad> omega = Quad(1 / (2 * step)) * log(compose(conjugate(before), after), Way::principal);
    Quad right[6], reach = 0;
    bivector_components_of(omega, right);
    Wide<T> wide[6];
    for (int k = 0; k < 6; ++k)
        wide[k] = static_cast<Wide<T>>(right[k]);
    for (const auto &control : controls)
        reach = larger(reach, length(control.d));
    const double bound = 64 * (1 + double(shape.controls));
    verdict.near("angular velocity", twist, wide, 3, Wide<T>(1), bound);
    verdict.near("velocity", twist + 3, wide + 3, 3, static_cast<Wide<T>>(32 * (1 + reach)), bound, Wide<T>(64));
}

// ------------------------------------------------------------------------------------------------------------- calls

// A motion compiled from the controls of a call.
template <class T>
class Compiled {
public:
    Compiled(const Shape &shape, const Call &call)
    {
        std::vector<typename api<T>::motor> controls;
        for (std::size_t k = 0; k < shape.controls; ++k)
            controls.push_back(*first_of<typename api<T>::motor>(call.in[k]));
        typename api<T>::motion motion{};
        motion.kind = shape.kind;
        motion.degree = shape.degree;
        motion.controls = controls.data();
        motion.control_count = controls.size();
        std::size_t size = 0, where = 0;
        status = api<T>::motion_size(&size, &motion, &where);
        memory_.resize((size + 7) / 8);
        if (status == MW_OK)
            status = api<T>::compile_motion(&motion_, memory_.data(), size, &motion, MW_DEFAULT, &where);
    }

    const typename api<T>::compiled_motion *get() const { return motion_; }
    mw_status status;

private:
    std::vector<double> memory_;
    const typename api<T>::compiled_motion *motion_ = nullptr;
};

// The parameters adjacent, as all but the first functions want them.
template <class T>
std::vector<T> parameters_of(const Call &call, const Place &place)
{
    std::vector<T> parameters(call.count);
    for (std::size_t i = 0; i < call.count; ++i)
        std::memcpy(&parameters[i], place.component[0] + i * place.stride, sizeof(T));
    return parameters;
}

template <class T>
void draw_controls(Random &random, const Shape &shape, void *const *inputs)
{
    using R = Wide<T>;
    Draw<T> draw(random);
    const R far = R(draw.chance(3) ? draw.power_of_two(-20, 30) : T(1));
    for (std::size_t k = 0; k < shape.controls; ++k) {
        T *const control = static_cast<T *>(inputs[k]);
        if (k > 0 && draw.chance(8)) {
            std::copy_n(static_cast<const T *>(inputs[k - 1]), 8, control);
            continue;
        }
        R exact[8];
        const Quaternion<R> r = turn_about(draw.axis(), R(draw.uniform(-1, 1)));
        components_of(pose(r, far * R(draw.uniform(0, 4)) * draw.axis()), exact);
        Draw<T>::round_to(control, exact, 8);
        if (draw.chance(4))
            for (int c = 0; c < 8; ++c)
                control[c] = -control[c];
    }
}

template <class T>
T draw_parameter(Random &random, const Shape &shape)
{
    const auto last = static_cast<double>(shape.kind == MW_MOTION_GENERATOR_KEYS ? shape.controls - 1
                                                                                 : shape.controls - shape.degree);
    if (random.chance(6))
        return static_cast<T>(random.below(static_cast<std::size_t>(last) + 1));
    if (random.chance(6))
        return std::min(static_cast<T>(last), static_cast<T>(std::fabs(random.magnitude(1e-30, 1))));
    return static_cast<T>(random.uniform(0, last));
}

template <class T>
Function of_motion(const char *name, const Shape &shape)
{
    Function f{"motion", named<T>(name) + ", " + name_of(shape.kind) + " of degree " + std::to_string(shape.degree),
               {},       {8, sizeof(T)},
               {},       {},
               {}};
    for (std::size_t k = 0; k < shape.controls; ++k)
        f.inputs.push_back(motors_of<T>(Stream::shared));
    f.draw = [shape](Random &random, void *const *inputs) {
        draw_controls<T>(random, shape, inputs);
        *static_cast<T *>(inputs[shape.controls]) = draw_parameter<T>(random, shape);
    };
    return f;
}

template <class T>
Function sampled(const Shape &shape)
{
    Function f = of_motion<T>("sample_motion", shape);
    f.inputs.push_back({1, sizeof(T)});
    f.ways = {[shape](const Call &call) {
        const Compiled<T> motion(shape, call);
        const std::vector<T> t = parameters_of<T>(call, call.in[shape.controls]);
        return motion.status != MW_OK ? motion.status
                                      : api<T>::sample_motion_one(view_of<Out<T>>(call.out), motion.get(), 0, t.data(),
                                                                  call.count, MW_DEFAULT);
    }};
    f.judge = [shape](const void *const *inputs, const void *out, bool) {
        return shape.kind == MW_MOTION_GENERATOR_KEYS ? Verdict() : judge_pose<T>(shape, inputs, numbers<T>(out));
    };
    return f;
}

template <class T>
Function with_twists(const Shape &shape)
{
    Function f = of_motion<T>("sample_motion_twist", shape);
    f.inputs.push_back({1, sizeof(T)});
    f.output.components = 14;
    f.ways = {[shape](const Call &call) {
        const Compiled<T> motion(shape, call);
        const std::vector<T> t = parameters_of<T>(call, call.in[shape.controls]);
        return motion.status != MW_OK
                   ? motion.status
                   : api<T>::sample_motion_twist_one(view_of<Out<T>>(call.out),
                                                     view_of<typename api<T>::bivectors>(call.out, 8), motion.get(), 0,
                                                     t.data(), call.count, MW_DEFAULT);
    }};
    f.judge = [shape](const void *const *inputs, const void *out, bool) {
        if (shape.kind == MW_MOTION_GENERATOR_KEYS)
            return Verdict();
        Verdict verdict = judge_pose<T>(shape, inputs, numbers<T>(out));
        judge_twist<T>(verdict, shape, inputs, numbers<T>(out) + 8);
        return verdict;
    };
    return f;
}

// Points under the motion at one parameter: as by a sample of it.
template <class T>
Function onto_points(const Shape &shape)
{
    Function f = of_motion<T>("apply_point_motion", shape);
    f.apart = true;
    f.inputs.push_back({1, sizeof(T), Stream::shared});
    f.inputs.push_back({3, sizeof(T)});
    f.output.components = 3;
    f.draw = [shape, draw = f.draw](Random &random, void *const *inputs) {
        draw(random, inputs);
        Draw<T>(random).vector(static_cast<T *>(inputs[shape.controls + 1]), 3);
    };
    using Xyz = typename api<T>::xyz;
    using ConstXyz = typename api<T>::const_xyz;
    f.ways = {[shape](const Call &call) {
                  const Compiled<T> motion(shape, call);
                  const Xyz out = view_of<Xyz>(call.out);
                  return motion.status != MW_OK
                             ? motion.status
                             : api<T>::apply_point_motion(
                                   out, call.count * out.stride, motion.get(), 0, first_of<T>(call.in[shape.controls]),
                                   1, view_of<ConstXyz>(call.in[shape.controls + 1]), call.count, MW_DEFAULT);
              },
              [shape](const Call &call) {
                  const Compiled<T> motion(shape, call);
                  typename api<T>::motor sample{};
                  if (motion.status != MW_OK)
                      return motion.status;
                  const mw_status status =
                      api<T>::sample_motion_one(api<T>::motors_aos(&sample, sizeof sample), motion.get(), 0,
                                                first_of<T>(call.in[shape.controls]), 1, MW_DEFAULT);
                  return status != MW_OK ? status
                                         : api<T>::apply_point_one(view_of<Xyz>(call.out), &sample,
                                                                   view_of<ConstXyz>(call.in[shape.controls + 1]),
                                                                   call.count, MW_DEFAULT);
              }};
    f.judge = [](const void *const *, const void *, bool) { return Verdict(); };
    return f;
}

template <class T>
void add(Functions &functions)
{
    for (const mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                      MW_MOTION_GENERATOR, MW_MOTION_GENERATOR_KEYS})
        for (const unsigned degree : {1u, 2u, 3u}) {
            const Shape shape{kind, degree, 2 * degree};
            functions.push_back(sampled<T>(degree == 1 ? Shape{kind, 1, 3} : shape));
            functions.push_back(with_twists<T>(degree == 1 ? Shape{kind, 1, 3} : shape));
            if (degree == 2)
                functions.push_back(onto_points<T>(shape));
        }
}

}  // namespace

void add_motions(Functions &functions)
{
    add<float>(functions);
    add<double>(functions);
}

}  // namespace motorway::fuzz
