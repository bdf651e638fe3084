// Prints a line for each family of functions and precision, with a hash of its results on random inputs, special ones
// among them, by the instruction set that MOTORWAY_ISA says. With what flags the library was compiled must not show:
// compare_bits.cmake links this with another library and compares.

#include <cfloat>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "apply_api.h"
#include "convert_api.h"
#include "kernel_list.h"
#include "kernel_tester.h"
#include "motion_tester.h"

namespace motorway::testing {
namespace {

// FNV-1a. All NaN are one, for their bits depend on the order of operands, which compilers choose.
class Hash {
public:
    template <class T>
    void add(const T *numbers, std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k) {
            const T number = numbers[k] == numbers[k] ? numbers[k] : std::numeric_limits<T>::quiet_NaN();
            unsigned char bytes[sizeof(T)];
            std::memcpy(bytes, &number, sizeof(T));
            for (unsigned char byte : bytes)
                value_ = (value_ ^ byte) * 0x100000001b3u;
        }
    }
    template <class T>
    void add(const std::vector<T> &numbers) { add(numbers.data(), numbers.size()); }

    void print(const std::string &of) const
    {
        std::printf("%s %016llx\n", of.c_str(), static_cast<unsigned long long>(value_));
    }

private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

void expect_ok(mw_status status, const std::string &of)
{
    if (status == MW_OK)
        return;
    std::fprintf(stderr, "%s: %s\n", of.c_str(), mw_status_text(status));
    std::exit(1);
}

// ----------------------------------------------------------------------------------------------------- kernels

// All at once, so that both whole registers and a tail are computed.
template <class T>
void print_kernel(const KernelRow &row)
{
    Hash hash;
    for (const auto &subject : row.subjects<T>()) {
        Pool<T> pool = make_pool(*subject, 203, 11, Specials::some);
        std::vector<View<T>> inputs;
        for (std::size_t k = 0; k < pool.inputs.size(); ++k)
            inputs.push_back(packed_view(pool.element(k, 0), pool.operands[k].components, pool.operands[k].scalar));
        std::vector<T> out(pool.count * pool.output_components);
        expect_ok(subject->run(packed_view(out.data(), pool.output_components), inputs, pool.count), subject->name());
        hash.add(out);
    }
    hash.print(row.name + (sizeof(T) == sizeof(float) ? " f32" : " f64"));
}

// Every motor on every element, in both orders of the results: the second has a loop of its own.
template <class T>
void print_grid(const ApplyFunctions<T> &functions)
{
    constexpr std::size_t motor_count = 37, count = 23;
    const std::size_t components = functions.components();
    Random random(13);
    std::vector<double> numbers(8 * motor_count);
    for (double &number : numbers)
        number = random.uniform(-1, 1);
    std::vector<T> rounded(numbers.begin(), numbers.end()), in(components * count), out(in.size() * motor_count);
    for (T &number : in)
        number = static_cast<T>(random.uniform(-10, 10));
    Hash hash;
    for (bool by_motor : {true, false}) {
        ApplyCall<T> call;
        auto *motors = functions.is_mixed() ? reinterpret_cast<T *>(numbers.data()) : rounded.data();
        call.motors = packed_view(motors, 8, functions.motor_scalar);
        call.in = packed_view(in.data(), components);
        call.out = packed_view(out.data(), components);
        call.count = count;
        call.motor_count = motor_count;
        call.row_stride = (by_motor ? count : 1) * components * sizeof(T);
        call.out.stride = (by_motor ? 1 : motor_count) * components * sizeof(T);
        expect_ok(functions.run(Pairing::grid, call), functions.name(Pairing::grid));
        hash.add(out);
    }
    hash.print(functions.name(Pairing::grid) + " in both orders");
}

// ----------------------------------------------------------------------------------------------------- motions

template <class T>
void print_motions(mw_motion_kind kind)
{
    Hash compiled, poses, twists, lengths;
    Random random(17);
    for (std::size_t degree : {1, 2, 3, 5})
        for (bool closed : {false, true}) {
            auto data = random_motion<T>(random, kind, degree, degree + 7, closed);
            draw_knots(random, data, Ends::clamped, degree);
            const CompiledMotion<T> motion(data);
            compiled.add(reinterpret_cast<const unsigned char *>(motion.get()), motion.size());
            std::vector<T> parameters;
            for (int k = 0; k <= 150; ++k)
                parameters.push_back(motion.first() + T(k) / 150 * (motion.last() - motion.first()));
            const Twists<T> samples = twisted(motion, parameters, MW_CLAMP_PARAMETERS);
            poses.add(samples.poses);
            twists.add(samples.twists);
            poses.add(sampled(motion, parameters, MW_CLAMP_PARAMETERS));

            const T point[3] = {1, -2, T(0.5)};
            std::vector<T> way(2), even(9);
            const T domain[] = {motion.first(), motion.last()};
            expect_ok(api<T>::motion_lengths(way.data(), motion.get(), 0, point, domain, 2), "lengths");
            expect_ok(api<T>::motion_even_parameters(even.data(), motion.get(), 0, point, 9), "even");
            lengths.add(way);
            lengths.add(even);
        }
    const std::string of = std::string(name_of(kind)) + " " + api<T>::name;
    compiled.print(of + " compiled");
    poses.print(of + " poses");
    twists.print(of + " twists");
    lengths.print(of + " lengths");
}

// -------------------------------------------------------------------------------------------- one at a time

template <class T>
void print_rotations()
{
    using C = api<T>;
    Hash rotations, twists, nearest;
    Random random(19);
    for (int k = 0; k < 1000; ++k) {
        T axis[3], point[3], bivector[6], matrix[12];
        for (T &number : axis)
            number = static_cast<T>(random.magnitude(1e-3, 1e3));
        for (T &number : point)
            number = static_cast<T>(random.uniform(-10, 10));
        for (T &number : bivector)
            number = static_cast<T>(random.magnitude(1e-6, 1e6));
        for (T &number : matrix)
            number = static_cast<T>(random.uniform(-2, 2));
        typename api<T>::motor motor;
        const auto angle = static_cast<T>(random.magnitude(1e-6, 1e30));
        expect_ok(api<T>::rotation(&motor, axis, angle, point), "rotation");
        rotations.add(&motor.s, 8);

        typename C::twist twist;
        expect_ok(C::split_bivector(&twist, bivector), "split_bivector");
        expect_ok(C::twist_pose(&motor, &twist, T(0.375)), "twist_pose");
        expect_ok(C::twist_position(point, &twist, T(0.375)), "twist_position");
        twists.add(twist.axis, 3);
        twists.add(&motor.s, 8);
        twists.add(point, 3);

        const typename C::const_matrices in{matrix, sizeof matrix, MW_MATRIX_ROWS_3X4};
        expect_ok(C::convert_matrix_to_motor_each(packed_motors(&motor.s), in, 1, MW_NEAREST_ROTATION, nullptr),
                  "nearest rotation");
        nearest.add(&motor.s, 8);
    }
    rotations.print(std::string("rotation ") + api<T>::name);
    twists.print(std::string("twists ") + api<T>::name);
    nearest.print(std::string("nearest rotation ") + api<T>::name);
}

// Controls of a motion through keys; by Newton's method if it is cumulative.
template <class T>
void print_interpolation(mw_motion_kind kind)
{
    constexpr unsigned degree = 3, count = 12;
    Random random(23);
    MotionData<T> keys;
    keys.kind = kind;
    draw_controls(random, keys, count);
    std::vector<T> times{0}, knots(count + degree - 1);
    while (times.size() < count)
        times.push_back(times.back() + static_cast<T>(random.uniform(1, 1.5)));
    std::size_t size = 0;
    expect_ok(api<T>::interpolate_keys(nullptr, {}, kind, degree, nullptr, nullptr, count, nullptr, &size, nullptr),
              "interpolate_keys");
    std::vector<double> memory(size / sizeof(double) + 1);
    typename api<T>::motion motion;
    expect_ok(api<T>::interpolate_keys(&motion, {keys.controls.data(), count, knots.data(), knots.size()}, kind, degree,
                                       keys.controls.data(), times.data(), count, memory.data(), &size, nullptr),
              "interpolate_keys");
    Hash hash;
    hash.add(&keys.controls[0].s, 8 * count);
    hash.add(knots);
    hash.print(std::string("keys ") + name_of(kind) + " " + api<T>::name);
}

template <class T>
void print_all()
{
    for (const KernelRow &row : kernel_rows())
        if (!row.subjects<T>().empty())
            print_kernel<T>(row);
    for (const auto &functions : apply_functions<T>())
        print_grid(functions);
    for (mw_motion_kind kind : all_motion_kinds)
        print_motions<T>(kind);
    print_rotations<T>();
    for (mw_motion_kind kind : {MW_MOTION_ADDITIVE, MW_MOTION_CUMULATIVE})
        print_interpolation<T>(kind);
}

}  // namespace
}  // namespace motorway::testing

int main()
{
    using namespace motorway::testing;
    if (!mw_isa()) {
        std::fprintf(stderr, "%s\n", mw_status_text(MW_ERROR_ISA));
        return 1;
    }
    // Whether the process still has denormal numbers, which a library that is linked with -ffast-math takes from it.
    volatile float smallest = FLT_MIN;
    std::printf("denormal numbers: %s\n", smallest / 2 > 0 ? "kept" : "lost");
    std::printf("%s\n", mw_isa());
    print_all<float>();
    print_all<double>();
}
