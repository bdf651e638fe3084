#include "motions.h"

#include <memory>

#include "apply_api.h"
#include "draw.h"
#include "room.h"

namespace motorway::memcheck {
namespace {

using testing::api;

constexpr mw_motion_kind kinds[] = {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                    MW_MOTION_GENERATOR, MW_MOTION_GENERATOR_KEYS};
constexpr std::size_t control_count = 6, motion_count = 3;

template <class T>
class Motions {
public:
    using A = api<T>;
    using Motor = typename A::motor;
    using Motion = typename A::motion;

    explicit Motions(testing::Random &random) : random_(random)
    {
        for (std::size_t k = 0; k < motion_count * control_count; ++k)
            controls_.push_back(motor());
        for (std::size_t k = 0; k < control_count; ++k)
            weights_.push_back(static_cast<T>(random.uniform(1, 2)));
    }

    void check()
    {
        for (const mw_motion_kind kind : kinds)
            for (const bool closed : {false, true})
                for (const bool more : {false, true}) {
                    Motion motion{};
                    motion.kind = kind;
                    motion.degree = 3;
                    motion.controls = controls_.data();
                    motion.control_count = control_count;
                    motion.closed = closed;
                    motion.motion_count = motion_count;
                    if (more && kind == MW_MOTION_ADDITIVE)
                        motion.weights = weights_.data();
                    if (more && kind >= MW_MOTION_GENERATOR)
                        motion.base = controls_.data();
                    check(motion);
                }
        check_made();
    }

private:
    Motor motor()
    {
        fuzz::Draw<T> draw(random_);
        T numbers[8];
        fuzz::Wide<T> exact[8];
        const auto r = fuzz::turn_about(draw.axis(), fuzz::Wide<T>(draw.uniform(0, 1)));
        fuzz::components_of(fuzz::pose(r, fuzz::Wide<T>(draw.uniform(0, 5)) * draw.axis()), exact);
        fuzz::Draw<T>::round_to(numbers, exact, 8);
        return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], numbers[6], numbers[7]};
    }

    typename A::motors motors_at(Room<Motor> &room) { return A::motors_aos(room.get(), sizeof(Motor)); }

    void check(const Motion &motion)
    {
        std::size_t size = 0, where = 0;
        must(A::motion_size(&size, &motion, &where), "motion_size");
        Room<double> memory((size + 7) / 8);
        const typename A::compiled_motion *compiled;
        must(A::compile_motion(&compiled, memory.get(), size, &motion, MW_DEFAULT, &where), "compile_motion");
        touch(memory.get(), size);
        T domain[2];
        must(A::motion_domain(domain, compiled), "motion_domain");
        for (const std::size_t count : {1, 4, 19})
            sample(compiled, domain, count);
        measure(compiled, domain);
        apply(compiled, domain);
    }

    std::vector<T> parameters(const T *domain, std::size_t count)
    {
        std::vector<T> parameters;
        for (std::size_t i = 0; i < count; ++i)
            parameters.push_back(domain[0] + (domain[1] - domain[0]) * static_cast<T>(i) / static_cast<T>(count));
        return parameters;
    }

    void sample(const typename A::compiled_motion *compiled, const T *domain, std::size_t count)
    {
        const std::vector<T> at = parameters(domain, count);
        Room<Motor> poses(count);
        Room<T> twists(6 * count);
        const typename A::bivectors bivectors = {twists.get(),
                                                 twists.get() + count,
                                                 twists.get() + 2 * count,
                                                 twists.get() + 3 * count,
                                                 twists.get() + 4 * count,
                                                 twists.get() + 5 * count,
                                                 sizeof(T)};
        must(A::sample_motion_one(motors_at(poses), compiled, 1, at.data(), count, MW_CLAMP_PARAMETERS),
             "sample_motion_one");
        poses.touch();
        must(A::sample_motion_twist_one(motors_at(poses), bivectors, compiled, 0, at.data(), count, MW_BODY_FRAME),
             "sample_motion_twist_one");
        poses.touch();
        twists.touch();
        const std::size_t some = count < motion_count ? count : motion_count;
        for (const std::size_t stride : {std::size_t(0), sizeof(T)}) {
            must(A::sample_motion_each(motors_at(poses), compiled, 0, at.data(), stride, some, MW_WRAP_PARAMETERS),
                 "sample_motion_each");
            must(A::sample_motion_twist_each(motors_at(poses), bivectors, compiled, 0, at.data(), stride, some,
                                             MW_DEFAULT),
                 "sample_motion_twist_each");
        }
        poses.touch();
        twists.touch();
    }

    void measure(const typename A::compiled_motion *compiled, const T *domain)
    {
        const std::vector<T> at = parameters(domain, 5);
        const T point[] = {1, 2, 3};
        Room<T> lengths(5);
        must(A::motion_lengths(lengths.get(), compiled, 2, point, at.data(), 5), "motion_lengths");
        lengths.touch();
        must(A::motion_even_parameters(lengths.get(), compiled, 2, point, 5), "motion_even_parameters");
        lengths.touch();
        typename A::motion_distance distance;
        must(A::compare_motions(&distance, compiled, 0, compiled, 1, A::const_xyz_aos(point, sizeof point), 1, 7),
             "compare_motions");
        touch(distance.distance);
    }

    template <class Apply, class Out, class In>
    void apply_to(const char *name, Apply function, Out *, In *, std::size_t components,
                  const typename A::compiled_motion *compiled, const T *domain)
    {
        constexpr std::size_t count = 5, rows = 3;
        const std::vector<T> at = parameters(domain, rows);
        std::vector<T> elements(components * count, T(0.5));
        Room<T> images(components * count * rows);
        testing::View<T> in, out;
        for (std::size_t k = 0; k < components; ++k) {
            in.component.push_back(elements.data() + k);
            out.component.push_back(images.get() + k);
        }
        in.stride = out.stride = components * sizeof(T);
        must(function(testing::api_view<Out>(out), count * out.stride, compiled, 0, at.data(), rows,
                      testing::api_view<In>(in), count, MW_DEFAULT),
             name);
        images.touch();
    }

    void apply(const typename A::compiled_motion *compiled, const T *domain);
    void check_made();

    testing::Random &random_;
    std::vector<Motor> controls_;
    std::vector<T> weights_;
};

#define MOTORWAY_APPLY_TO(operand, views, P)                                                                         \
    apply_to("apply_" #operand "_motion", api<testing::scalar_##P>::apply_##operand##_motion,                        \
             static_cast<mw_##views##_##P *>(nullptr),                                                               \
             static_cast<mw_const_##views##_##P *>(nullptr), components_of(testing::Operand::views), compiled,       \
             domain);

template <>
void Motions<float>::apply(const mw_compiled_motion_f32 *compiled, const float *domain)
{
    MW_OPERANDS(MOTORWAY_APPLY_TO, f32)
}
template <>
void Motions<double>::apply(const mw_compiled_motion_f64 *compiled, const double *domain)
{
    MW_OPERANDS(MOTORWAY_APPLY_TO, f64)
}

// Motions made of keys and of other motions. Arrays are of the size that is asked for.
template <class T>
void Motions<T>::check_made()
{
    struct Arrays {
        Room<Motor> controls;
        Room<T> knots;
        typename A::motion_arrays arrays;
        Arrays(std::size_t c, std::size_t k) : controls(c), knots(k), arrays{controls.get(), c, knots.get(), k} {}
        void touch(const Motion &motion) const
        {
            controls.touch(motion.control_count);
            knots.touch(motion.knot_count);
        }
    };
    const std::vector<T> times = {0, 1, 2, 4, 5, 6};
    std::size_t where = 0;
    for (const mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_CUMULATIVE}) {
        std::size_t size = 0;
        Arrays arrays(control_count, control_count + 2);
        Motion motion;
        must(A::interpolate_keys(&motion, arrays.arrays, kind, 3, controls_.data(), times.data(), control_count,
                                 nullptr, &size, &where),
             "the size of interpolate_keys");
        Room<double> memory((size + 7) / 8);
        must(A::interpolate_keys(&motion, arrays.arrays, kind, 3, controls_.data(), times.data(), control_count,
                                 memory.get(), &size, &where),
             "interpolate_keys");
        arrays.touch(motion);
        if (kind != MW_MOTION_ADDITIVE)
            continue;
        Motion changed, rest;
        const typename A::motion_arrays none{};
        A::insert_knot(&changed, none, &motion, T(3), 2);
        Arrays inserted(changed.control_count, changed.knot_count);
        must(A::insert_knot(&changed, inserted.arrays, &motion, T(3), 2), "insert_knot");
        inserted.touch(changed);
        A::elevate_degree(&changed, none, &motion);
        Arrays elevated(changed.control_count, changed.knot_count);
        must(A::elevate_degree(&changed, elevated.arrays, &motion), "elevate_degree");
        elevated.touch(changed);
        A::split_motion(&changed, none, &rest, none, &motion, T(3));
        Arrays before(changed.control_count, changed.knot_count), after(rest.control_count, rest.knot_count);
        must(A::split_motion(&changed, before.arrays, &rest, after.arrays, &motion, T(3)), "split_motion");
        before.touch(changed);
        after.touch(rest);
    }
}

}  // namespace

void check_motions()
{
    testing::Random random(5);
    Motions<float>(random).check();
    Motions<double>(random).check();
}

}  // namespace motorway::memcheck
