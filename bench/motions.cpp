#include "motions.h"

#include <memory>
#include <utility>

namespace motorway::bench {
namespace {

// What a motion is made of, and its description, which points to it.
template <class T> struct described_motion {
    std::vector<T> knots;
    typename api<T>::motion description{};

    described_motion(mw_motion_kind kind, const T *controls, std::size_t control_count, std::size_t motion_count)
    {
        knots = motion_knots<T>(control_count);
        if (kind == MW_MOTION_GENERATOR_KEYS) { // times, which increase
            knots.resize(control_count);
            for (std::size_t i = 0; i < control_count; ++i)
                knots[i] = static_cast<T>(i) / static_cast<T>(control_count - 1);
        }
        description.kind = kind;
        description.degree = motion_degree;
        description.controls = reinterpret_cast<const typename api<T>::motor *>(controls);
        description.control_count = control_count;
        description.knots = knots.data();
        description.knot_count = knots.size();
        description.motion_count = motion_count;
    }
    described_motion(const described_motion &) = delete;
};

// --------------------------------------------------------------------------------------------------------- samples

enum class sampling { one, one_random, each, each_shared };

arguments sample_arguments(std::size_t controls, sampling how, bool twist)
{
    arguments result{{operand::motor}, {}};
    if (twist)
        result.out.push_back(operand::bivector);
    if (how != sampling::each_shared)
        result.in.push_back(how == sampling::one ? operand::sorted_parameter : operand::parameter);
    result.controls = controls;
    result.motion_an_element = how == sampling::each || how == sampling::each_shared;
    return result;
}

template <class T> struct parameters_of_each {
    const T *first;
    std::size_t stride;

    explicit parameters_of_each(const problem<T> &p)
    {
        static const T shared = static_cast<T>(shared_parameter);
        const bool own = !p.in.empty();
        first = own ? p.in[0].component()[0] : &shared;
        stride = own ? p.in[0].stride() : 0;
    }
};

template <class T> work bind_sample(mw_motion_kind kind, const arguments &arguments, const problem<T> &p)
{
    const auto motion = compile_motions(kind, p, arguments.motion_an_element ? p.count : 1);
    const auto out = view_of<typename api<T>::motors>(p.out[0]);
    const parameters_of_each<T> t(p);
    if (arguments.motion_an_element)
        return make_work([=, count = p.count] {
            require(api<T>::sample_motion_each(out, motion->get(), 0, t.first, t.stride, count, MW_DEFAULT));
        });
    return make_work([=, count = p.count] {
        require(api<T>::sample_motion_one(out, motion->get(), 0, t.first, count, MW_DEFAULT));
    });
}

template <class T> work bind_sample_twist(mw_motion_kind kind, const arguments &arguments, const problem<T> &p)
{
    const auto motion = compile_motions(kind, p, arguments.motion_an_element ? p.count : 1);
    const auto out = view_of<typename api<T>::motors>(p.out[0]);
    const auto twists = view_of<typename api<T>::bivectors>(p.out[1]);
    const parameters_of_each<T> t(p);
    if (arguments.motion_an_element)
        return make_work([=, count = p.count] {
            require(api<T>::sample_motion_twist_each(out, twists, motion->get(), 0, t.first, t.stride, count,
                                                     MW_DEFAULT));
        });
    return make_work([=, count = p.count] {
        require(api<T>::sample_motion_twist_one(out, twists, motion->get(), 0, t.first, count, MW_DEFAULT));
    });
}

kernel make_sample(mw_motion_kind kind, std::size_t controls, sampling how, bool twist)
{
    const bench::arguments arguments = sample_arguments(controls, how, twist);
    const auto bind = [=](const auto &problem, unsigned) {
        return twist ? bind_sample_twist(kind, arguments, problem) : bind_sample(kind, arguments, problem);
    };
    return {arguments, bind, bind, {}};
}

// --------------------------------------------------------------------------------------------------------- a mesh

template <class T> work bind_mesh(const problem<T> &p)
{
    using functions = apply_functions<operand::point, T, T>;
    const bool columns = p.kind == layout::columns;
    const std::size_t step = p.out[0].stride();
    const auto in = view_of<typename functions::const_view>(p.in[0]);
    const auto out = view_of<typename functions::view>(p.out[0], columns ? mesh_frames * step : step);
    const auto motion = compile_motions(MW_MOTION_ADDITIVE, p, 1);
    return make_work([=, frames = frame_parameters<T>(), count = p.count] {
        require(functions::motion(out, columns ? step : count * step, motion->get(), 0, frames.data(), frames.size(),
                                  in, count, MW_DEFAULT));
    });
}

kernel make_mesh()
{
    bench::arguments arguments{{operand::point}, {operand::point}};
    arguments.images = mesh_frames;
    arguments.controls = spline_controls;
    arguments.natural_count = mesh_vertices;
    const auto bind = [](const auto &problem, unsigned) { return bind_mesh(problem); };
    return {arguments, bind, bind, {}};
}

// ------------------------------------------------------------------------------------------------------- compiling

// Its results are a sample for each control.
template <class T> work bind_compile(mw_motion_kind kind, const problem<T> &p)
{
    const auto described = std::make_shared<described_motion<T>>(kind, p.in[0].component()[0], p.count, 1);
    const auto memory = std::make_shared<motion_memory<T>>(described->description);
    return make_work([=] { memory->compile(described->description); }, [=, &p] {
        std::vector<T> parameters;
        for (std::size_t i = 0; i < p.count; ++i)
            parameters.push_back(static_cast<T>(i) / static_cast<T>(p.count - 1));
        require(api<T>::sample_motion_one(view_of<typename api<T>::motors>(p.out[0]), memory->get(), 0,
                                          parameters.data(), p.count, MW_DEFAULT));
    });
}

kernel make_compile(mw_motion_kind kind)
{
    bench::arguments arguments{{operand::motor}, {operand::control}};
    arguments.natural_count = compiled_controls;
    const auto bind = [=](const auto &problem, unsigned) { return bind_compile(kind, problem); };
    return {arguments, bind, bind, {}};
}

// -------------------------------------------------------------------------------------------------------- the rows

struct kind {
    mw_motion_kind value;
    std::string name;
    std::size_t controls;
    std::size_t weights, rest; // operations of the weights of a sample, and of what is done with them
};

kernel_row make_row(const kernel &kernel, const std::string &verb, const std::string &name, std::size_t operations)
{
    return {kernel, verb, name, operations, 1, MW_DEFAULT};
}

kernel_row sample_row(const kind &kind, sampling how, const std::string &pairing, bool twist)
{
    const std::size_t operations = how == sampling::each_shared ? kind.rest : kind.weights + kind.rest;
    return make_row(make_sample(kind.value, kind.controls, how, twist), "sample",
                    "sample_" + kind.name + (twist ? "_twist_" : "_") + pairing, twist ? 0 : operations);
}

} // namespace

template <class T>
std::shared_ptr<motion_memory<T>> compile_motions(mw_motion_kind kind, const problem<T> &p, std::size_t motion_count)
{
    constexpr std::size_t components = components_of(operand::control);
    const described_motion<T> described(kind, p.controls.data(), p.controls.size() / components / motion_count,
                                        motion_count);
    return std::make_shared<motion_memory<T>>(described.description);
}

template std::shared_ptr<motion_memory<float>> compile_motions(mw_motion_kind, const problem<float> &, std::size_t);
template std::shared_ptr<motion_memory<double>> compile_motions(mw_motion_kind, const problem<double> &, std::size_t);

std::vector<kernel_row> motion_rows(const motion_operations &of)
{
    constexpr std::size_t terms = motion_degree + 1, pairs = motion_degree * terms / 2;
    constexpr std::size_t components = components_of(operand::motor), generators = components_of(operand::bivector);
    // The parameter within a span, which is the ratio of the first pair of the tableau; those of the others; and two
    // weights that change with each pair.
    constexpr std::size_t ratios = 2 + (pairs - 1), weights = ratios + 1 + 2 * (pairs - 1);
    const kind kinds[] = {
        {MW_MOTION_ADDITIVE, "additive", spline_controls, weights, terms * components},
        {MW_MOTION_MULTIPLICATIVE, "multiplicative", bezier_controls, ratios, pairs * of.slerp},
        {MW_MOTION_CUMULATIVE, "cumulative", spline_controls, weights + motion_degree,
         motion_degree * (generators + of.exp + of.product)},
        {MW_MOTION_GENERATOR, "generator", spline_controls, weights, terms * generators + of.exp + of.product}};
    std::vector<kernel_row> rows;
    for (const kind &kind : kinds)
        for (bool twist : {false, true}) {
            rows.push_back(sample_row(kind, sampling::one, "one", twist));
            if (kind.value == MW_MOTION_ADDITIVE)
                rows.push_back(sample_row(kind, sampling::one_random, "one_random", twist));
            rows.push_back(sample_row(kind, sampling::each, "each", twist));
            rows.push_back(sample_row(kind, sampling::each_shared, "each_shared", twist));
        }
    rows.push_back(make_row(make_mesh(), "apply", "apply_point_motion", of.point));
    for (const kind &kind : kinds)
        rows.push_back(make_row(make_compile(kind.value), "compile", "compile_" + kind.name, 0));
    rows.push_back(make_row(make_compile(MW_MOTION_GENERATOR_KEYS), "compile", "compile_generator_keys", 0));
    return rows;
}

} // namespace motorway::bench
